# SPDX-License-Identifier: MIT
"""Many triangles in one call, in SIMD: the batch clippers, as a renderer uses them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np

from . import _clipscope
from ._arrays import integers, numbers, shape_error, whole_number
from ._clip import Output, _check_attributes
from ._volume import DepthClamp, OpenSides, VolumeOptions, volume_options


class Method(NamedTuple):
    """What is known of a batch method: see `methods`."""

    name: str
    summary: str
    source: str  # authors, title, year


def _numbered_methods() -> dict[str, tuple[int, Method]]:
    return {name: (number, Method(name, *texts)) for number, name, *texts in _clipscope.methods()}


def methods() -> list[Method]:
    """The methods of `stage` and `clip_mesh`, with what each does and whose it is."""
    return [method for _, method in _numbered_methods().values()]


@dataclass(frozen=True, eq=False)
class Staged:
    """What a stage leaves: triangles inside by number, the polygons of those that were cut.

    inside    (i,) uint32: triangles that lie inside; empty where every survivor is written
    vertices  (v, 4 + k) float32: x, y, z, w in clip space, not divided; then attributes
    ends      (p,) uint32: polygon i ends before vertex ends[i], and begins where i - 1 ends
    source    (p,) uint32: the triangle that polygon i is left of
    weights   (v, 3) float32 or None: barycentric weights of each vertex, see `clip_mesh`
    """

    inside: np.ndarray
    vertices: np.ndarray
    ends: np.ndarray
    source: np.ndarray
    weights: Optional[np.ndarray] = None

    def __len__(self) -> int:
        """The number of polygons."""
        return len(self.source)

    @property
    def offsets(self) -> np.ndarray:
        """(p + 1,) int64: polygon i has the vertices offsets[i] to offsets[i + 1]. A copy."""
        return np.concatenate([[0], self.ends]).astype(np.int64)

    def __repr__(self) -> str:
        return f"<Staged: {len(self.inside)} inside, {len(self)} polygons, {len(self.vertices)} vertices>"


def _options(method: str, volume: VolumeOptions, attributes: int, threads: int) -> Any:
    known = _numbered_methods()
    if method not in known:
        raise ValueError(f"method: {method!r}; expected one of {', '.join(known)}")
    _check_attributes(attributes, volume[2])
    return _clipscope.BatchOptions(known[method][0], *volume, whole_number("threads", threads, 0, 1024))


def _floats(name: str, values: Any) -> np.ndarray:
    """Contiguous float32, copied only where it is not that already."""
    return np.ascontiguousarray(numbers(name, values, np.dtype(np.float32)))


def stage(
    triangles: Any,
    *,
    method: str = "homogeneous/batch",
    layout: str = "vertices",
    attributes: Any = None,
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    threads: int = 1,
    out: Optional[Output] = None,
) -> Staged:
    """Clips clip-space triangles as a renderer's pipeline does, before the divide, in SIMD.

    triangles, with layout="vertices": (n, 3, 4 + k) float32: x, y, z, w and k attributes. Every
        survivor is written, so `inside` is empty.
    with layout="streams": (3, 4, n) float32, twelve arrays of coordinates, and
        attributes=(n, 3, k). Triangles that lie inside come out by number, only cut ones are written.
    method: a name of `methods()`.

    C-contiguous float32 is read in place, all else is copied to that first. The result is looked at
    where the library left it; with several threads the parts are put together by one copy. The GIL
    is released. Other arguments: as in `clip`. Returns a `Staged`. Raises ValueError.

    Source: Sproull and Sutherland, "A Clipping Divider", 1968, for outcodes; each method has its own.
    """
    volume = volume_options(depth, depth_clamp, clip_distances, open_sides)
    array = _floats("triangles", triangles)
    memory = (out or Output())._batch
    if layout == "vertices":
        if array.ndim != 3 or array.shape[1] != 3 or array.shape[2] < 4:
            raise shape_error("triangles", array, "(n, 3, 4 + k) with layout='vertices'")
        if attributes is not None:
            raise ValueError("attributes: given with layout='vertices', where they stand behind the positions")
        options = _options(method, volume, array.shape[2] - 4, threads)
        return Staged(*_clipscope.stage(array, options, memory))
    if layout != "streams":
        raise ValueError(f"layout: {layout!r}; expected 'vertices' or 'streams'")
    if array.ndim != 3 or array.shape[:2] != (3, 4):
        raise shape_error("triangles", array, "(3, 4, n) with layout='streams': x, y, z, w of each vertex")
    count = array.shape[2]
    beside = np.zeros((count, 3, 0), np.float32) if attributes is None else _floats("attributes", attributes)
    if beside.ndim != 3 or beside.shape[:2] != (count, 3):
        raise shape_error("attributes", beside, f"({count}, 3, k)")
    options = _options(method, volume, beside.shape[2], threads)
    return Staged(*_clipscope.stage_streams(array, beside, options, memory))


def _projected(array: np.ndarray, matrix: Any) -> np.ndarray:
    """Vertices (v, 3 + k) by a matrix, each coordinate summed from left to right in float."""
    rows = numbers("matrix", matrix, np.dtype(np.float32))
    if rows.shape != (4, 4):
        raise shape_error("matrix", rows, "(4, 4), whose rows yield x, y, z and w of (x, y, z, 1)")
    x, y, z = array[:, 0:1], array[:, 1:2], array[:, 2:3]
    clip = x * rows[:, 0] + y * rows[:, 1] + z * rows[:, 2] + rows[:, 3]
    return np.ascontiguousarray(np.concatenate([clip, array[:, 3:]], axis=1))


def _weights_of(staged: Staged, array: np.ndarray, indices: np.ndarray, options: Any, distances: int) -> np.ndarray:
    """The cut triangles once more, with the weights as attributes in place of others."""
    corners = array[indices.reshape(-1, 3)[staged.source]]
    unit = np.broadcast_to(np.eye(3, dtype=np.float32), (len(corners), 3, 3))
    again = np.concatenate([corners[..., : 4 + distances], unit], axis=2)
    rows = _clipscope.stage(np.ascontiguousarray(again), options, Output()._batch)[1]
    return rows[:, 4 + distances :]


def clip_mesh(
    vertices: Any,
    indices: Any,
    matrix: Any = None,
    *,
    method: str = "homogeneous/batch",
    depth: str = "gl",
    depth_clamp: DepthClamp = False,
    clip_distances: int = 0,
    open_sides: OpenSides = False,
    weights: bool = False,
    threads: int = 1,
    out: Optional[Output] = None,
) -> Staged:
    """Clips an indexed mesh as a renderer's pipeline does, before the divide, in SIMD.

    vertices: (v, 4 + k) float32 in clip space: x, y, z, w and k attributes; or (v, 3 + k) with
        matrix=(4, 4), whose rows yield x, y, z, w of (x, y, z, 1), computed in float.
    indices: (m, 3) or (3 m,) of uint32, three per triangle, each below v.
    method: a name of `methods()`.
    weights: whether `weights` of the new vertices are computed: vertex i is the point
        sum over j of weights[i, j] * vertices[indices[t, j]], t its triangle, of clip space.

    Each vertex is classified once. Triangles that lie inside come out by number (`inside`): draw
    them from the mesh itself. Only those that were cut are written: draw them as fans after the
    divide. C-contiguous float32 and uint32 are read in place, all else is copied to that first. The
    GIL is released. Other arguments: as in `clip`. Returns a `Staged`. Raises ValueError.

    >>> square = [[-2, -.5, 0, 1], [.5, -.5, 0, 1], [.5, .5, 0, 1], [-2, .5, 0, 1]]
    >>> clip_mesh(square, [[0, 1, 2], [0, 2, 3]])
    <Staged: 0 inside, 2 polygons, 7 vertices>
    """
    volume = volume_options(depth, depth_clamp, clip_distances, open_sides)
    array = _floats("vertices", vertices)
    dimension = 4 if matrix is None else 3
    if array.ndim != 2 or array.shape[1] < dimension:
        raise shape_error("vertices", array, f"(v, {dimension} + k)" + ("" if matrix is None else " with matrix="))
    if matrix is not None:
        array = _projected(array, matrix)
    numbered = integers("indices", indices, np.uint32)
    if numbered.ndim not in (1, 2) or numbered.ndim == 2 and numbered.shape[1] != 3 or numbered.size % 3:
        raise shape_error("indices", numbered, "(m, 3) or (3 m,)")
    options = _options(method, volume, array.shape[1] - 4, threads)
    arrays = _clipscope.clip_mesh(array, numbered, options, (out or Output())._batch)
    if arrays is None:
        raise ValueError(f"indices: the largest is {numbered.max()}; expected less than {len(array)}, the vertices")
    staged = Staged(*arrays)
    if not weights:
        return staged
    _check_attributes(clip_distances + 3, clip_distances)
    return Staged(*arrays, _weights_of(staged, array, numbered, options, clip_distances))
