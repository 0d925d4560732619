# SPDX-License-Identifier: MIT
"""Triangles, segments, points and polygons by any of the clippers, one after the other."""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np

from . import _clipscope
from ._arrays import integers, numbers, scalar_dtype, shape_error, whole_number
from ._volume import DepthClamp, OpenSides, VolumeOptions, against, volume_options

PRIMITIVES = {"point": 1, "segment": 2, "triangle": 3}


class Output:
    """Memory for results, to be given to many calls as `out=`.

    A call with `out=` puts its result into memory that no array looks at any more: once earlier
    results are dropped, nothing is allocated. A result that is still held is never overwritten.
    """

    def __init__(self) -> None:
        self._rows = _clipscope.Output()
        self._batch = _clipscope.BatchOutput()


class Clipper(NamedTuple):
    """What is known of a clipper: see `clippers`."""

    name: str
    summary: str
    source: str  # authors, title, year
    primitive: str  # "triangle", "segment" or "point"
    spaces: tuple[str, ...]  # that it takes: "view", "clip"
    scalars: tuple[str, ...]  # "float", "double"
    depth_clamp: bool  # whether it takes these options
    clip_distances: bool
    open_sides: bool


def clippers(primitive: str = "triangle") -> list[Clipper]:
    """All clippers of "triangle", "segment" or "point", with what each does and whose it is.

    >>> [c.name for c in clippers()][:2]
    ['textbook', 'view/sutherland_hodgman']
    """
    if primitive not in PRIMITIVES:
        raise ValueError(f"primitive: {primitive!r}; expected one of {', '.join(map(repr, PRIMITIVES))}")
    return [
        Clipper(
            d.name,
            d.summary,
            d.source,
            primitive,
            ("view", "clip") if d.clip_space else ("view",),
            ("float", "double") if d.in_double else ("float",),
            d.depth_clamp,
            d.clip_distances,
            d.open_sides,
        )
        for d in _clipscope.descriptions()
        if d.vertices == PRIMITIVES[primitive]
    ]


@dataclass(frozen=True, eq=False)
class Clipped:
    """What is left of many primitives: convex polygons, one after the other.

    Primitives of which nothing is left have no polygon. The arrays look at one block of memory; no
    call writes to it as long as one of them is alive.

    vertices    (v, 4): x, y, z in normalised device coordinates, and 1/w
    attributes  (v, k): their true, perspective-correct values (not divided by w)
    offsets     (p + 1,) int64: polygon i has the vertices offsets[i] to offsets[i + 1]
    source      (p,) int64: the primitive that polygon i is left of, in the order of the input
    weights     (v, n) or None: barycentric weights of each vertex, see `clip`
    """

    vertices: np.ndarray
    attributes: np.ndarray
    offsets: np.ndarray
    source: np.ndarray
    weights: Optional[np.ndarray]

    def __len__(self) -> int:
        """The number of polygons."""
        return len(self.source)

    def __getitem__(self, i: int) -> np.ndarray:
        """The vertices of polygon i: (n, 4)."""
        if not -len(self) <= i < len(self):
            raise IndexError(f"polygon {i} of {len(self)}")
        i = i % len(self)
        return self.vertices[self.offsets[i] : self.offsets[i + 1]]

    def fans(self) -> np.ndarray:
        """The polygons as triangles: (t, 3) int64 numbers of vertices, of each its first one's fan."""
        counts = np.diff(self.offsets)
        triangles = np.maximum(counts - 2, 0)
        first = np.repeat(self.offsets[:-1], triangles)
        begin = np.repeat(np.cumsum(triangles) - triangles, triangles)
        second = first + 1 + np.arange(len(first)) - begin
        return np.stack([first, second, second + 1], axis=1)

    def source_of_vertices(self) -> np.ndarray:
        """(v,) int64: the primitive that each vertex is of."""
        return np.repeat(self.source, np.diff(self.offsets))

    def __repr__(self) -> str:
        return (
            f"<Clipped: {len(self)} polygons, {len(self.vertices)} vertices, "
            f"{self.attributes.shape[1]} attributes, {self.vertices.dtype}>"
        )


_NOTHING = "view space (x, y, z) with projection=, or clip space (x, y, z, w) with space=\"clip\""


def _dimension(projection: Any, space: str) -> int:
    if space not in ("view", "clip"):
        raise ValueError(f"space: {space!r}; expected 'view' or 'clip'")
    if space == "view" and projection is None:
        raise ValueError(f"projection: missing; expected {_NOTHING}")
    if space == "clip" and projection is not None:
        raise ValueError("projection: given with space='clip', where positions are projected already")
    return 3 if space == "view" else 4


def _columns(name: str, array: np.ndarray, attributes: Any, dimension: int) -> tuple[np.ndarray, np.ndarray]:
    """Positions and attributes of an array (..., dimension + k), or of the two."""
    if attributes is None:
        return array[..., :dimension], array[..., dimension:]
    beside = numbers("attributes", attributes, array.dtype)
    if array.shape[-1] != dimension:
        expected = f"{dimension} numbers per vertex where attributes= are given"
        raise shape_error(name, array, expected)
    if beside.ndim != array.ndim or beside.shape[:-1] != array.shape[:-1]:
        lead = ", ".join(map(str, array.shape[:-1]))
        raise shape_error("attributes", beside, f"({lead}, k), as {name} has")
    return array, beside


def _check_attributes(count: int, distances: int) -> None:
    most = _clipscope.MOST_ATTRIBUTES
    if count > most:
        raise ValueError(f"attributes: {count} per vertex, weights included; expected {most} at most")
    if distances > count:
        raise ValueError(
            f"clip_distances: {distances}, but there are {count} attributes; they are the first of them"
        )


def _primitives(
    name: str, values: Any, vertices: int, attributes: Any, projection: Any, space: str, scalar: Any
) -> tuple[np.ndarray, np.ndarray]:
    dimension = _dimension(projection, space)
    array = numbers(name, values, None if scalar is None else scalar_dtype(scalar))
    if array.size == 0 and array.ndim < 3:
        array = np.zeros((0, vertices, dimension), array.dtype)
    if array.ndim != 3 or array.shape[1] != vertices or array.shape[2] < dimension:
        letters = "x, y, z" if dimension == 3 else "x, y, z, w"
        expected = (
            f"(n, {vertices}, {dimension} + k): of each of {vertices} vertices {letters} "
            f"({space} space) and k attributes"
        )
        raise shape_error(name, array, expected)
    return _columns(name, array, attributes, dimension)


def _find(name: str, primitive: str) -> Clipper:
    known = {c.name: c for c in clippers(primitive)}
    if name in known:
        return known[name]
    near = difflib.get_close_matches(str(name), known, n=3, cutoff=0.4)
    meant = f"; did you mean {' or '.join(near)}?" if near else ""
    raise ValueError(f"clipper: no clipper of {primitive}s is called {name!r}{meant} clippers() lists all")


def _check_clipper(clipper: Clipper, in_clip_space: bool, dtype: np.dtype, volume: VolumeOptions) -> None:
    _, clamp, distances, sides = volume
    if in_clip_space and "clip" not in clipper.spaces:
        raise ValueError(f"clipper: {clipper.name} starts in view space; expected projection= a Frustum")
    if dtype == np.float64 and "double" not in clipper.scalars:
        raise ValueError(f"scalar: {clipper.name} computes in float alone; expected float32 or scalar='float'")
    for asked, takes, argument in (
        (any(clamp), clipper.depth_clamp, "depth_clamp"),
        (distances > 0, clipper.clip_distances, "clip_distances"),
        (any(sides), clipper.open_sides, "open_sides"),
    ):
        if asked and not takes:
            raise ValueError(f"{argument}: {clipper.name} does not take it; see clippers()")


def _clipped(arrays: tuple, attributes: int) -> Clipped:
    rows, offsets, source = arrays
    weights = rows[:, 4 + attributes :]
    return Clipped(
        rows[:, :4], rows[:, 4 : 4 + attributes], offsets, source, weights if weights.shape[1] else None
    )


def _clip(
    argument: str,
    values: Any,
    primitive: str,
    clipper: str,
    projection: Any,
    space: str,
    attributes: Any,
    scalar: Any,
    options: tuple,
    weights: bool,
    threads: int,
    out: Optional[Output],
    half_size: tuple[float, float] = (0.0, 0.0),
) -> Clipped:
    count = PRIMITIVES[primitive]
    positions, beside = _primitives(argument, values, count, attributes, projection, space, scalar)
    volume = volume_options(*options)
    _check_attributes(beside.shape[2] + (count if weights else 0), volume[2])
    _check_attributes(beside.shape[2], volume[2])
    a = against(projection, volume, positions.dtype)
    a.point_half_size = half_size
    # From a matrix on it is the clipper's way through clip space.
    _check_clipper(_find(clipper, primitive), not a.frustum, positions.dtype, volume)
    call = _clipscope.Options(clipper, bool(weights), whole_number("threads", threads, 0, 1024))
    arrays = _clipscope.clip(positions, beside, a, call, (out or Output())._rows)
    return _clipped(arrays, beside.shape[2])


def clip(
    triangles: Any,
    projection: Any = None,
    *,
    space: str = "view",
    clipper: str = "homogeneous/sutherland_hodgman",
    attributes: Any = None,
    scalar: Any = None,
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    weights: bool = True,
    threads: int = 1,
    out: Optional[Output] = None,
) -> Clipped:
    """Clips triangles to the canonical view volume and divides; bit for bit what the C++ clipper does.

    triangles: (n, 3, 3 + k) in view space with `projection`, or (n, 3, 4 + k) in clip space with
        space="clip": of each vertex its position, then k attributes; or positions alone, with
        attributes=(n, 3, k) beside them. float32 and float64 of any layout are read in place;
        other numbers become float64.
    projection: a `Frustum` (see `perspective`, `orthographic`), or a matrix (4, 4) whose rows yield
        x, y, z, w of (x, y, z, 1); the clipper then starts in clip space.
    clipper: a name of `clippers()`.
    scalar: "float" or "double" that is computed in [that of the array].
    depth: "gl" (-w <= z <= w), "zero_to_one" (0 <= z <= w) or "reversed" (the same, near at 1).
    depth_clamp: True, "near" or "far": these planes do not clip, and depths beyond remain.
    clip_distances: so many of the first attributes clip: what is negative is outside. At most 8.
    open_sides: sides that do not own their points; True: right and bottom (the top-left rule).
    weights: whether barycentric weights are computed.
    threads: 1, any number, or 0 for all processors. The result does not depend on it.
    out: an `Output` whose memory is used again.

    Returns a `Clipped`. A polygon has 3 to 9 vertices, one more for each clip distance, in the
    winding of its triangle.

    Weights: vertex i of a polygon is the point
        sum over j of weights[i, j] * (vertex j of the triangle)
    of view space, and so of clip space (x, y, z, w). They are the perspective-correct ones, not
    those of the projected triangle on screen. They are attributes 1 0 0, 0 1 0, 0 0 1, interpolated
    as the clipper interpolates (cvv/naive does so in NDC, which is its fault): each within rounding
    of [0, 1], and their sum of 1. An attribute's value is the weighted sum of the triangle's, so
    that gradients flow through them.

    Raises ValueError for an argument that can't be (it names the argument, its shape and what was
    expected). Primitives with a NaN or an infinite coordinate yield nothing; nothing is raised.

    >>> from clipscope import perspective
    >>> result = clip([[[0, -1, -2], [4, 0, -2], [0, 1, -2]]], perspective(90, 1, 1, 100))
    >>> len(result), result[0].shape
    (1, (4, 4))
    """
    options = (depth, depth_clamp, clip_distances, open_sides)
    return _clip(
        "triangles", triangles, "triangle", clipper, projection, space, attributes, scalar, options, weights,
        threads, out,
    )  # fmt: skip


def segments(
    segments: Any,
    projection: Any = None,
    *,
    space: str = "view",
    clipper: str = "homogeneous/liang_barsky_division_free",
    attributes: Any = None,
    scalar: Any = None,
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    weights: bool = True,
    threads: int = 1,
    out: Optional[Output] = None,
) -> Clipped:
    """Clips segments: (n, 2, 3 + k) or (n, 2, 4 + k); all else as in `clip`.

    Of a segment two vertices are left, in its order, or nothing. weights: (v, 2). Clippers:
    clippers("segment").
    """
    options = (depth, depth_clamp, clip_distances, open_sides)
    return _clip(
        "segments", segments, "segment", clipper, projection, space, attributes, scalar, options, weights,
        threads, out,
    )  # fmt: skip


def points(
    points: Any,
    projection: Any = None,
    *,
    space: str = "view",
    clipper: str = "point/pop",
    attributes: Any = None,
    scalar: Any = None,
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    half_size: tuple[float, float] = (0.0, 0.0),
    threads: int = 1,
    out: Optional[Output] = None,
) -> Clipped:
    """Clips points: (n, 3 + k) in view space or (n, 4 + k) in clip space; all else as in `clip`.

    half_size: half the width and height of a point's square, in NDC: what "point/pop_free" keeps as
    long as the square touches the volume. Without weights. Clippers: clippers("point").
    """
    values = numbers("points", points, None if scalar is None else scalar_dtype(scalar))
    dimension = _dimension(projection, space)
    if values.ndim != 2 and values.size or values.ndim == 2 and values.shape[1] < dimension:
        raise shape_error("points", values, f"(n, {dimension} + k)")
    beside = None if attributes is None else numbers("attributes", attributes, values.dtype)
    if beside is not None and (beside.ndim != 2 or len(beside) != len(values)):
        raise shape_error("attributes", beside, f"({len(values)}, k), as points has")
    width, height = (float(x) for x in half_size)
    if not (width >= 0 and height >= 0):
        raise ValueError(f"half_size: {half_size}; expected two numbers >= 0")
    options = (depth, depth_clamp, clip_distances, open_sides)
    return _clip(
        "points", values[:, None], "point", clipper, projection, space,
        None if beside is None else beside[:, None], scalar, options, False, threads, out, (width, height),
    )  # fmt: skip


def polygons(
    vertices: Any,
    offsets: Any,
    projection: Any = None,
    *,
    space: str = "view",
    attributes: Any = None,
    scalar: Any = None,
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    threads: int = 1,
    out: Optional[Output] = None,
) -> Clipped:
    """Clips convex, flat polygons of any size; all else as in `clip`.

    vertices: (v, 3 + k) in view space or (v, 4 + k) in clip space; offsets: (p + 1,) integers:
    polygon i has the vertices offsets[i] to offsets[i + 1], so that a result is an input.
    Sutherland-Hodgman in clip space; the parts of a concave polygon are joined along the planes, so
    triangulate it first. Without weights, which are not unique.
    """
    dimension = _dimension(projection, space)
    array = numbers("vertices", vertices, None if scalar is None else scalar_dtype(scalar))
    if array.ndim != 2 or array.shape[1] < dimension:
        raise shape_error("vertices", array, f"(v, {dimension} + k)")
    positions, beside = _columns("vertices", array, attributes, dimension)
    ends = integers("offsets", offsets, np.int64)
    if ends.ndim != 1 or len(ends) == 0:
        raise shape_error("offsets", ends, "(p + 1,), from 0 to the number of vertices")
    if ends[0] != 0 or ends[-1] != len(array) or (np.diff(ends) < 0).any():
        raise ValueError(
            f"offsets: from {ends[0]} to {ends[-1]}; expected ascending numbers from 0 to {len(array)}, "
            "the number of vertices"
        )
    options = volume_options(depth, depth_clamp, clip_distances, open_sides)
    _check_attributes(beside.shape[1], options[2])
    arrays = _clipscope.clip_polygons(
        positions[:, None], beside[:, None], ends[1:], against(projection, options, positions.dtype),
        whole_number("threads", threads, 0, 1024), (out or Output())._rows,
    )  # fmt: skip
    return _clipped(arrays, beside.shape[1])
