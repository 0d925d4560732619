# SPDX-License-Identifier: MIT
# The compiled part; use the package clipscope, which checks what it is given.
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

MOST_ATTRIBUTES: int
MOST_CLIP_DISTANCES: int

class Against:
    depth: int
    depth_clamp: tuple[bool, bool]
    clip_distances: int
    open_sides: list[bool]
    is_parallel: bool
    frustum: list[float]
    matrix: list[float]
    point_half_size: tuple[float, float]

class Options:
    def __init__(self, clipper: str, weights: bool, threads: int) -> None: ...

class Output: ...
class BatchOutput: ...

class BatchOptions:
    def __init__(
        self, method: int, depth: int, clamp: tuple[bool, bool], distances: int, open: list[bool], threads: int
    ) -> None: ...

class Description:
    name: str
    summary: str
    source: str
    vertices: int
    clip_space: bool
    in_double: bool
    depth_clamp: bool
    clip_distances: bool
    open_sides: bool

Rows = tuple[NDArray[Any], NDArray[np.int64], NDArray[np.int64]]
Stage = tuple[NDArray[np.uint32], NDArray[np.float32], NDArray[np.uint32], NDArray[np.uint32]]

def descriptions() -> list[Description]: ...
def clip(
    positions: NDArray[Any], attributes: NDArray[Any], against: Against, options: Options, output: Output
) -> Rows: ...
def clip_polygons(
    positions: NDArray[Any],
    attributes: NDArray[Any],
    ends: NDArray[np.int64],
    against: Against,
    threads: int,
    output: Output,
) -> Rows: ...
def methods() -> list[tuple[int, str, str, str]]: ...
def stage(triangles: NDArray[np.float32], options: BatchOptions, output: BatchOutput) -> Stage: ...
def stage_streams(
    positions: NDArray[np.float32], attributes: NDArray[np.float32], options: BatchOptions, output: BatchOutput
) -> Stage: ...
def clip_mesh(
    vertices: NDArray[np.float32], indices: NDArray[np.uint32], options: BatchOptions, output: BatchOutput
) -> Optional[Stage]: ...
def target_name() -> str: ...
