# SPDX-License-Identifier: GPL-3.0-or-later
"""The weights of a vertex make it of the triangle's vertices."""

import unittest

import clipscope
import numpy as np
from inputs import FRUSTUM, clip_triangles, view_triangles


class Weights(unittest.TestCase):
    def each(self):
        for clipper in clipscope.clippers():
            for scalar in clipper.scalars:
                yield clipper.name, np.float32 if scalar == "float" else np.float64

    def test_they_make_the_vertex_in_clip_space(self):
        """Of clip coordinates p = sum w_j p_j the point on screen is p / p_w, in every clipper but the naive."""
        worst = 0
        for name, dtype in self.each():
            if name == "cvv/naive" or "clip" not in self.spaces(name):
                continue
            triangles = np.abs(clip_triangles(1000, dtype, 0))  # w > 0: in every promise's domain
            triangles[..., :3] -= triangles[..., 3:]
            found = clipscope.clip(triangles, space="clip", clipper=name)
            self.assertGreater(len(found), 50, name)
            corners = triangles[found.source_of_vertices()].astype(np.float64)
            points = np.einsum("vj,vjc->vc", found.weights.astype(np.float64), corners)
            size = np.abs(corners).max(axis=(1, 2)) / found.vertices[:, 3] ** -1.0
            error = np.abs(points[:, :3] * found.vertices[:, 3:] - found.vertices[:, :3]).max(axis=1)
            relative = (error / (np.finfo(dtype).eps * np.maximum(size, 1))).max()
            worst = max(worst, relative)
            self.assertLess(relative, 200, (name, dtype))
        self.assertGreater(worst, 0)

    def spaces(self, name):
        return next(c.spaces for c in clipscope.clippers() if c.name == name)

    def test_they_sum_to_one_and_are_of_the_triangle(self):
        for name, dtype in self.each():
            triangles = view_triangles(1000, dtype, 2)
            triangles[..., 2] = -0.1 - np.abs(triangles[..., 2])  # w > 0: in every promise's domain
            found = clipscope.clip(triangles, clipscope.Frustum(*FRUSTUM), clipper=name)
            self.assertEqual(found.weights.shape, (len(found.vertices), 3))
            if name == "cvv/naive":
                continue
            small = 100 * np.finfo(dtype).eps
            np.testing.assert_allclose(found.weights.sum(axis=1), 1, atol=small, err_msg=name)
            self.assertGreaterEqual(found.weights.min(), -small, name)
            values = triangles[found.source_of_vertices()][..., 3:]
            made = np.einsum("vj,vjk->vk", found.weights, values)
            np.testing.assert_allclose(made, found.attributes, atol=20 * small, err_msg=name)

    def test_they_are_perspective_correct(self):
        """Halfway on screen between w = 1 and w = 3 lies a quarter of the way on the edge."""
        triangle = [[[0, 0, 0, 1], [6, 0, 0, 3], [0, 1, 0, 1]]]
        found = clipscope.clip(triangle, space="clip")
        at = np.flatnonzero((found.vertices[:, 0] == 1) & (found.vertices[:, 1] == 0))
        # x / w = 6 t / (1 + 2 t) = 1 at t = 1/4.
        np.testing.assert_array_equal(found.weights[at], [[0.75, 0.25, 0]])

    def test_without_them_nothing_else_changes(self):
        triangles = view_triangles(1000, np.float32, 3)
        one = clipscope.clip(triangles, clipscope.Frustum(*FRUSTUM))
        other = clipscope.clip(triangles, clipscope.Frustum(*FRUSTUM), weights=False)
        self.assertIsNone(other.weights)
        self.assertTrue(np.array_equal(one.vertices, other.vertices))
        self.assertTrue(np.array_equal(one.attributes, other.attributes))

    def test_a_gradient_flows_through_them(self):
        """d(screen position)/d(corner) by the weights against finite differences, a plane crossed."""
        triangle = np.array([[[0, 0, 0, 1], [0.5, 0, 0, 1], [0, 0.5, 0, 1.0]]])
        found = clipscope.clip(triangle, space="clip")
        step = 1e-6
        for j in range(3):
            moved = triangle.copy()
            moved[0, j, 0] += step
            after = clipscope.clip(moved, space="clip")
            measured = (after.vertices[:, 0] - found.vertices[:, 0]) / step
            np.testing.assert_allclose(measured, found.weights[:, j] * found.vertices[:, 3], atol=1e-6)


if __name__ == "__main__":
    unittest.main()
