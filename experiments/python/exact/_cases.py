# SPDX-License-Identifier: GPL-3.0-or-later
"""The catalogue of hard cases, as arrays."""

from __future__ import annotations

import pathlib
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np

from clipscope import Frustum

_CORPUS = pathlib.Path(__file__).parent / "corpus"


@dataclass
class Case:
    """A primitive that clippers get wrong.

    vertices    (n, 3) in view space or (n, 4) in clip space, float64 that floats hold exactly
    attributes  (n, k), as far as the file gives them
    projection  a Frustum in view space, None in clip space
    expected    "rejected", "accepted" or "clipped", in exact arithmetic; count: the vertices then
    """

    name: str
    source: str = ""
    why: str = ""
    primitive: str = "triangle"
    space: str = "clip"
    depth: str = "gl"
    projection: Optional[Frustum] = None
    depth_clamp: Any = False
    clip_distances: int = 0
    open_sides: Any = False
    expected: str = ""
    count: Optional[int] = None
    vertices: np.ndarray = field(default_factory=lambda: np.zeros((0, 4)))
    attributes: np.ndarray = field(default_factory=lambda: np.zeros((0, 0)))

    def arguments(self) -> dict[str, Any]:
        """What clipscope.clip and exact take beside the vertices: clip([case.vertices], **case.arguments())."""
        return {
            "projection": self.projection,
            "space": self.space,
            "depth": self.depth,
            "depth_clamp": self.depth_clamp,
            "clip_distances": self.clip_distances,
            "open_sides": self.open_sides,
            "attributes": self.attributes[None] if self.attributes.size else None,
        }


def number(text: str) -> float:
    return float.fromhex(text) if "0x" in text.lower() else float(text)


def _set_space(case: Case, words: list[str]) -> None:
    case.space, case.depth = words[0], words[-1]
    if case.space == "clip":
        return
    sides = [number(w) for w in words[2:8]]
    shear = [number(w) for w in words[8:-1]]
    case.projection = Frustum(*sides, words[1] == "parallel", *shear)


def _set(case: Case, key: str, rest: str, rows: list[tuple[list[float], list[float]]]) -> None:
    words = rest.split()
    if key in ("source", "why", "primitive"):
        setattr(case, key, rest)
    elif key == "space":
        _set_space(case, words)
    elif key == "depth_clamp":
        case.depth_clamp = rest or True
    elif key == "clip_distances":
        case.clip_distances = int(rest)
    elif key == "half_open":
        case.open_sides = words or True
    elif key == "vertex":
        position, _, attributes = rest.partition("|")
        rows.append(([number(w) for w in position.split()], [number(w) for w in attributes.split()]))
    elif key == "expect":
        case.expected, case.count = words[0], int(words[1]) if len(words) > 1 else None


def read_cases(text: str, theme: str = "") -> list[Case]:
    """The cases of a text in the format of tests/corpus/README.md."""
    cases: list[Case] = []
    rows: list[tuple[list[float], list[float]]] = []
    for line in text.splitlines():
        key, _, rest = line.strip().partition(" ")
        if not key or key.startswith("#"):
            continue
        if key == "case":
            rows = []
            cases.append(Case(f"{theme}/{rest}" if theme else rest))
        if not cases:
            raise ValueError(f"cases: {line!r}; expected a line `case NAME` before it")
        _set(cases[-1], key, rest.strip(), rows)
        if key == "vertex":
            cases[-1].vertices = np.array([p for p, _ in rows])
            widths = {len(a) for _, a in rows}
            cases[-1].attributes = np.array([a for _, a in rows]) if len(widths) == 1 else np.zeros((len(rows), 0))
    return cases


def catalogue(theme: Optional[str] = None, *, primitive: Optional[str] = None, space: Optional[str] = None) -> list[Case]:
    """All hard cases, each with where it was met, why it is hard and what comes out exactly.

    theme: of that file alone, "w_sign" for instance; primitive, space: those alone. Raises
    ValueError for a theme that there is not.

    >>> case = next(c for c in catalogue("w_sign") if c.name == "w_sign/eye_point_view")
    >>> case.vertices.tolist(), case.expected, case.count
    ([[1.0, 1.0, 0.0], [0.0, 0.0, -2.0], [1.0, 0.0, -2.0]], 'clipped', 4)
    """
    files = {path.stem: path for path in sorted(_CORPUS.glob("*.cases"))}
    if theme is not None and theme not in files:
        raise ValueError(f"theme: {theme!r}; expected one of {', '.join(files)}")
    chosen = files if theme is None else {theme: files[theme]}
    cases = [case for stem, path in chosen.items() for case in read_cases(path.read_text(), stem)]
    return [c for c in cases if primitive in (None, c.primitive) and space in (None, c.space)]


def numbers_of_hex(text: str) -> np.ndarray:
    """A triangle (3, d + k) as the program prints it."""
    values = [number(w) for w in text.split()]
    return np.array(values).reshape(3, -1) if len(values) % 3 == 0 else np.array(values)


