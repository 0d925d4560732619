# SPDX-License-Identifier: GPL-3.0-or-later
"""A Python function as a clipper that the program asks: the other end of bridge.cpp."""

from __future__ import annotations

import inspect
import pathlib
import re
import socket
import struct
import tempfile
import threading
import traceback
from dataclasses import dataclass
from typing import Any, Callable, Optional

import numpy as np

from clipscope import Clipped, Frustum
from clipscope._volume import DEPTHS, SIDES

# Capability bits of spaces/plugin/clipscope_plugin.h.
FLOAT, DOUBLE, VIEW_SPACE, CLIP_SPACE, TRIANGLES = 1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 6
DEPTH_BITS = {"gl": 1 << 8, "zero_to_one": 1 << 9, "reversed": 1 << 10}
OTHER_FRUSTA = 1 << 11 | 1 << 12 | 1 << 13 | 1 << 14
DEPTH_CLAMP, CLIP_DISTANCES, OPEN_SIDES, ANSWERS_IN_CLIP_SPACE = 1 << 15, 1 << 16, 1 << 17, 1 << 18

_QUESTION = struct.Struct("=12I3Q8d16d")  # struct Question of bridge.cpp
_REPLY = struct.Struct("=2Q")


@dataclass(frozen=True)
class Against:
    """What a function that takes a second argument is told: what it clips against.

    space "view" or "clip"; depth, depth_clamp, clip_distances and open_sides as in clipscope.clip;
    in view space the projection, a Frustum, and its matrix (4, 4) to clip space.
    """

    space: str
    depth: str
    depth_clamp: Any
    clip_distances: int
    open_sides: tuple[str, ...]
    projection: Optional[Frustum]
    matrix: Optional[np.ndarray]


def _against(space: int, depth: int, clamp: int, sides: int, distances: int, flags: tuple, numbers: tuple) -> Against:
    projection = matrix = None
    if space == VIEW_SPACE:
        left, right, bottom, top, near, far, shear_x, shear_y = numbers[:8]
        is_parallel, is_infinite = flags
        far = float("inf") if is_infinite else far
        projection = Frustum(left, right, bottom, top, near, far, bool(is_parallel), shear_x, shear_y)
        matrix = np.array(numbers[8:]).reshape(4, 4)
    return Against(
        "view" if space == VIEW_SPACE else "clip",
        next(name for name in DEPTHS if DEPTH_BITS[name] == depth),
        {0: False, 1: "near", 2: "far", 3: True}[clamp],
        distances,
        tuple(side for i, side in enumerate(SIDES) if sides >> i & 1),
        projection,
        matrix,
    )


def _polygons(found: Any, count: int, stride: int, dtype: np.dtype) -> list[np.ndarray]:
    """What a function returned for `count` triangles: for each its vertices (m, stride)."""
    if isinstance(found, Clipped):
        rows = np.concatenate([found.vertices, found.attributes], axis=1)
        parts = [rows[:0]] * count
        for i, triangle in enumerate(found.source):
            parts[triangle] = rows[found.offsets[i] : found.offsets[i + 1]]
        found = parts
    if len(found) != count:
        raise ValueError(f"the function returned {len(found)} polygons for {count} triangles")
    polygons = []
    for i, polygon in enumerate(found):
        array = np.zeros((0, stride), dtype) if polygon is None or len(polygon) == 0 else np.asarray(polygon, dtype)
        if array.ndim != 2 or array.shape[1] != stride:
            raise ValueError(f"the function returned shape {array.shape} for triangle {i}; expected (m, {stride})")
        polygons.append(array)
    return polygons


class Guest:
    """The function while the program asks it. With `with`: it listens until the end of the block."""

    def __init__(self, function: Callable, capabilities: int, attributes: int, is_batch: bool, name: str) -> None:
        self.function, self.capabilities, self.attributes, self.is_batch = function, capabilities, attributes, is_batch
        self.name = name
        self.error: Optional[str] = None  # the first traceback of the function
        self.calls = 0
        self._takes_against = _positional_parameters(function) >= 2
        self._one_at_a_time = threading.Lock()

    def __enter__(self) -> "Guest":
        self._folder = tempfile.TemporaryDirectory(prefix="clipscope-")
        self.path = str(pathlib.Path(self._folder.name) / "socket")
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._listener.bind(self.path)
        self._listener.listen()
        threading.Thread(target=self._listen, daemon=True).start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._folder.cleanup()

    def _listen(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            threading.Thread(target=self._answer_all, args=(connection,), daemon=True).start()

    def _answer_all(self, connection: socket.socket) -> None:
        with connection, connection.makefile("rb") as given:
            name, summary = self.name.encode()[:60], f"the Python function {self.name}".encode()[:190]
            connection.sendall(struct.pack("=2I64s192s", self.capabilities, self.attributes, name, summary))
            while question := given.read(_QUESTION.size):
                connection.sendall(self._answer(question, given))

    def _answer(self, question: bytes, given: Any) -> bytes:
        fields = _QUESTION.unpack(question)
        scalar, space, _, depth, clamp, sides, distances, attributes, stride = fields[:9]
        count, vertices, most = fields[12:15]
        dtype = np.dtype(np.float32 if scalar == FLOAT else np.float64)
        numbers = np.frombuffer(given.read(vertices * stride * dtype.itemsize), dtype).reshape(count, 3, stride)
        against = _against(space, depth, clamp, sides, distances, fields[9:11], fields[15:])
        try:
            with self._one_at_a_time, np.errstate(all="ignore"):
                polygons = _polygons(self._call(numbers, against), count, 4 + attributes, dtype)
            worst = max(map(len, polygons), default=0)
            if worst > most:
                raise ValueError(f"the function returned {worst} vertices for a triangle; expected {most} at most")
        except Exception:  # whatever the function does is an outcome, as a crash of any other guest
            self.error = self.error or traceback.format_exc()
            return _REPLY.pack(0, 0)
        ends = np.cumsum([len(p) for p in polygons], dtype=np.uint64)
        rows = np.concatenate(polygons) if polygons else np.zeros((0, 4 + attributes), dtype)
        return _REPLY.pack(1, len(rows)) + ends.tobytes() + rows.tobytes()

    def _call(self, numbers: np.ndarray, against: Against) -> Any:
        self.calls += 1
        beside = (against,) if self._takes_against else ()
        if self.is_batch:
            return self.function(numbers, *beside)
        return [self.function(triangle, *beside) for triangle in numbers]


def _positional_parameters(function: Callable) -> int:
    kinds = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    return sum(
        p.kind in kinds and p.default is inspect.Parameter.empty for p in inspect.signature(function).parameters.values()
    )


def name_of(function: Callable) -> str:
    """As tables show it: "python/my_clipper"."""
    plain = re.sub(r"[^a-z0-9_.-]+", "_", getattr(function, "__name__", "function").lower()).strip("_")
    return f"python/{plain or 'function'}"[:60]
