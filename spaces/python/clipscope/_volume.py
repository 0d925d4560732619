# SPDX-License-Identifier: MIT
"""What is clipped against: projections and the options of the clip volume."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Iterable, Union

import numpy as np

from . import _clipscope
from ._arrays import numbers, shape_error, whole_number

DEPTHS = ("gl", "zero_to_one", "reversed")
SIDES = ("left", "right", "bottom", "top")


@dataclass(frozen=True)
class Frustum:
    """A view volume in view space: right-handed, the eye at the origin, looking down -z.

    Perspective: left, right, bottom and top are measured on the near plane, 0 < near < far; far may
    be math.inf. Parallel: they bound x + shear_x z and y + shear_y z. Points of the volume have
    -far <= z <= -near. All numbers in the unit of the view space.

    Raises ValueError where it encloses no volume. `perspective` and `orthographic` make the usual
    ones. Source: OpenGL 1.5 specification, section 2.11.2 (glFrustum, glOrtho).
    """

    left: float = -1.0
    right: float = 1.0
    bottom: float = -1.0
    top: float = 1.0
    near: float = 1.0
    far: float = 100.0
    parallel: bool = False
    shear_x: float = 0.0
    shear_y: float = 0.0

    def __post_init__(self) -> None:
        for name in ("left", "right", "bottom", "top", "near", "shear_x", "shear_y"):
            if not math.isfinite(getattr(self, name)):
                raise ValueError(f"Frustum: {name} is {getattr(self, name)}; expected a finite number")
        if not (self.left < self.right and self.bottom < self.top):
            raise ValueError(f"Frustum: {self}; expected left < right and bottom < top")
        if self.parallel:
            if not (self.near < self.far < math.inf):
                raise ValueError(f"Frustum: near {self.near}, far {self.far}; expected near < far < inf")
        elif not 0 < self.near < self.far:
            raise ValueError(f"Frustum: near {self.near}, far {self.far}; expected 0 < near < far")
        if not self.parallel and (self.shear_x, self.shear_y) != (0, 0):
            raise ValueError("Frustum: a shear is of parallel projections only")


def perspective(fov_y: float, aspect: float, near: float, far: float = math.inf) -> Frustum:
    """A symmetric perspective frustum.

    fov_y: the whole vertical angle in degrees; aspect: width / height.
    """
    if not 0 < fov_y < 180:
        raise ValueError(f"fov_y: {fov_y}; expected degrees between 0 and 180")
    if not 0 < aspect < math.inf:
        raise ValueError(f"aspect: {aspect}; expected a positive number")
    top = near * math.tan(math.radians(fov_y) / 2)
    return Frustum(-top * aspect, top * aspect, -top, top, near, far)


def orthographic(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Frustum:
    """A parallel projection along z: what has left <= x <= right, bottom <= y <= top, -far <= z <= -near."""
    return Frustum(left, right, bottom, top, near, far, parallel=True)


DepthClamp = Union[bool, str]
OpenSides = Union[bool, str, Iterable[str]]
# (depth, depth clamp, clip distances, open sides) as _clipscope takes them.
VolumeOptions = tuple[int, tuple[bool, bool], int, list[bool]]


def _clamp_of(depth_clamp: DepthClamp) -> tuple[bool, bool]:
    known = {False: (False, False), True: (True, True), "near": (True, False), "far": (False, True)}
    if isinstance(depth_clamp, (bool, np.bool_, str)) and depth_clamp in known:
        return known[depth_clamp]
    raise ValueError(f"depth_clamp: {depth_clamp!r}; expected False, True, 'near' or 'far'")


def _sides_of(open_sides: OpenSides) -> list[bool]:
    if isinstance(open_sides, (bool, np.bool_)):
        return [False, bool(open_sides), bool(open_sides), False]  # the top-left rule
    named = open_sides.split(",") if isinstance(open_sides, str) else list(open_sides)
    for side in named:
        if side not in SIDES:
            raise ValueError(f"open_sides: {side!r}; expected True, False or some of {', '.join(SIDES)}")
    return [side in named for side in SIDES]


def depth_number(depth: str) -> int:
    if depth not in DEPTHS:
        raise ValueError(f"depth: {depth!r}; expected one of {', '.join(map(repr, DEPTHS))}")
    return DEPTHS.index(depth)


def volume_options(
    depth: str, depth_clamp: DepthClamp, clip_distances: int, open_sides: OpenSides
) -> VolumeOptions:
    distances = whole_number("clip_distances", clip_distances, 0, _clipscope.MOST_CLIP_DISTANCES)
    return depth_number(depth), _clamp_of(depth_clamp), distances, _sides_of(open_sides)


def against(projection: Any, options: VolumeOptions, dtype: np.dtype) -> Any:
    """A Frustum, a matrix (4, 4) or None, with the options of the volume."""
    a = _clipscope.Against()
    a.depth, a.depth_clamp, a.clip_distances, a.open_sides = options
    if isinstance(projection, Frustum):
        f = projection
        a.frustum = [f.left, f.right, f.bottom, f.top, f.near, f.far, f.shear_x, f.shear_y]
        a.is_parallel = f.parallel
        # Each number is rounded to the scalar once; what was a volume may be none afterwards.
        left, right, bottom, top, near, far = (dtype.type(x) for x in a.frustum[:6])
        if not (left < right and bottom < top and near < far and (f.parallel or 0 < near)):
            raise ValueError(f"projection: {f} encloses no volume in {dtype.name}")
    elif projection is not None:
        matrix = numbers("projection", projection, np.dtype(np.float64))
        if matrix.shape != (4, 4):
            raise shape_error("projection", matrix, "a Frustum, or a matrix (4, 4) whose rows yield x, y, z and w")
        a.matrix = matrix.ravel().tolist()
    return a
