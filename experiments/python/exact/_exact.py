# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact polygon: in rational arithmetic, nothing rounded."""

from __future__ import annotations

import csv
import io
from fractions import Fraction
from typing import Any, Iterator

import numpy as np

from clipscope import Clipped
from clipscope._clip import _check_attributes, _primitives
from clipscope._volume import SIDES, volume_options

from ._program import lens, lines, run


class ExactPolygons(list):
    """For each primitive the list of its polygon's vertices, each a tuple of Fraction:

    x, y, z in NDC, 1/w, then the attributes, and the barycentric weights if they were asked for.
    The list is empty where nothing is left.
    """


def _options_of(volume: tuple, depth: str) -> list[str]:
    _, clamp, distances, sides = volume
    options = ["--depth", depth]
    if any(clamp):
        options.append("--depth-clamp=" + {(True, True): "both", (True, False): "near", (False, True): "far"}[clamp])
    if distances:
        options += ["--clip-distances", str(distances)]
    if any(sides):
        options.append("--half-open=" + ",".join(name for name, is_open in zip(SIDES, sides) if is_open))
    return options


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    """(primitive, numbers of a vertex) of each row."""
    reader = csv.reader(io.StringIO(text))
    next(reader)
    for row in reader:
        yield int(row[0]), row[2:]


def _rounded(text: str, attributes: int, weights: bool) -> Clipped:
    rows, source, offsets = [], [], [0]
    for primitive, row in _rows(text):
        if not source or source[-1] != primitive:
            source.append(primitive)
            offsets.append(offsets[-1])
        offsets[-1] += 1
        rows.append([float.fromhex(x) for x in row])
    numbers = np.array(rows, np.float64).reshape(len(rows), 4 + attributes + (3 if weights else 0))
    return Clipped(
        numbers[:, :4],
        numbers[:, 4 : 4 + attributes],
        np.array(offsets, np.int64),
        np.array(source, np.int64),
        numbers[:, 4 + attributes :] if weights else None,
    )


def exact(
    triangles: Any,
    projection: Any = None,
    *,
    space: str = "view",
    attributes: Any = None,
    depth: str = "gl",
    depth_clamp: Any = False,
    clip_distances: int = 0,
    open_sides: Any = False,
    weights: bool = False,
    fractions: bool = True,
) -> Any:
    """The exact polygons of triangles: what any clipper should give, by rational arithmetic.

    Arguments: as in clipscope.clip. Each number given is taken exactly as the double that it is; a
    Frustum likewise, no matrix being rounded on the way.
    fractions: an `ExactPolygons` of fractions.Fraction; else a clipscope.Clipped whose float64
        numbers are the nearest ones to the exact values.

    A polygon has at least three vertices; where the triangle has no area some are the same point, and
    nothing is left of what only touches the volume.

    Raises ValueError for wrong arguments and where a coordinate is NaN or infinite; ProgramError
    where the program is not there. Source: exact arithmetic by GMP and CGAL, in the program.

    >>> exact([[[1, 0, 0, 3], [0, 1, 0, 3], [0, 0, 1, 3]]], space="clip")[0][0][0]
    Fraction(1, 3)
    """
    positions, beside = _primitives("triangles", triangles, 3, attributes, projection, space, None)
    volume = volume_options(depth, depth_clamp, clip_distances, open_sides)
    columns = [positions.astype(np.float64), beside.astype(np.float64)]
    if weights:
        columns.append(np.broadcast_to(np.eye(3), (len(positions), 3, 3)))
    given = np.concatenate(columns, axis=2)
    count = given.shape[2] - positions.shape[2]
    _check_attributes(count, volume[2])
    if not np.isfinite(given).all():
        where = np.argwhere(~np.isfinite(given))[0].tolist()
        raise ValueError(f"triangles: not finite at {where} (triangle, vertex, number); expected finite numbers")
    arguments = ["clip", "--scalar", "exact", "--space", space, "--attributes", str(count)]
    arguments += _options_of(volume, depth) + (lens(projection) if projection is not None else [])
    text = run([*arguments, "--fraction" if fractions else "--hex"], lines(given)) if len(given) else "triangle\n"
    if not fractions:
        return _rounded(text, beside.shape[2], weights)
    polygons = ExactPolygons([] for _ in range(len(given)))
    for primitive, row in _rows(text):
        polygons[primitive].append(tuple(map(Fraction, row)))
    return polygons
