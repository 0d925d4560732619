# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles to test with: everywhere, near planes, through the eye, and what is no number."""

import numpy as np

FRUSTUM = (-1.0, 1.5, -1.0, 1.0, 1.0, 50.0)
DEPTHS = ("gl", "zero_to_one", "reversed")


def view_triangles(count, dtype, attributes=4, seed=1):
    rng = np.random.default_rng(seed)
    positions = rng.normal(size=(count, 3, 3)) * np.exp(rng.normal(size=(count, 1, 1)))
    positions[..., 2] -= rng.uniform(-3, 8, size=(count, 1))
    # Some coordinates are small integers, as in the catalogue: on planes, at the eye, of no area.
    small = rng.random((count, 1, 1)) < 0.3
    positions = np.where(small, np.round(positions), positions)
    values = rng.normal(size=(count, 3, attributes))
    return np.concatenate([positions, values], axis=2).astype(dtype)


def clip_triangles(count, dtype, attributes=4, seed=2):
    rng = np.random.default_rng(seed)
    positions = rng.normal(size=(count, 3, 4)) * np.exp(2 * rng.normal(size=(count, 1, 1)))
    positions[..., 3] += 0.5
    small = rng.random((count, 1, 1)) < 0.3
    positions = np.where(small, np.round(positions), positions)
    special = rng.random((count, 3, 4)) < 0.002
    positions = np.where(special, rng.choice([np.nan, np.inf, -np.inf, 0.0, -0.0], size=(count, 3, 4)), positions)
    values = rng.normal(size=(count, 3, attributes))
    return np.concatenate([positions, values], axis=2).astype(dtype)


def same_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
