# SPDX-License-Identifier: GPL-3.0-or-later
"""Is a clipper right? A Python function, or one of ours, before the exact judge."""

from __future__ import annotations

import html
import pathlib
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, NamedTuple, Optional, Union

import numpy as np

from clipscope import clippers
from clipscope._arrays import whole_number
from clipscope._volume import DEPTHS

from . import _guest
from ._cases import Case, numbers_of_hex, read_cases
from ._program import NOTHING_JUDGED, run_json

_BRIDGE = pathlib.Path(__file__).parent / "bridge.so"
MEASURES = ("px", "ulp", "attribute", "containment", "crack", "crash")


class Promise(NamedTuple):
    """What was found about one promise: see `verify`."""

    name: str
    held: Optional[bool]  # None where nothing was judged
    judged: int  # triangles
    broken: int
    reason: str  # of the first counterexample
    counterexample: Optional[np.ndarray]  # (3, d + k): position, attributes
    replay: str  # a command of the program that asks again


@dataclass(frozen=True)
class Verdict:
    """What a clipper keeps and breaks, judged by the exact reference; in a notebook, a table.

    kept      whether all that was asked for holds on every triangle judged
    judged    triangles, of `triangles` tried
    promises  a Promise each
    shrunk    the first counterexample made as small as it goes: (3, d + k), or None
    case      the same as a hard case, with its exact outcome
    ulps      the largest backward error measured, in u M
    error     the first traceback of a Python function, or None
    """

    name: str
    scalar: str
    kept: bool
    judged: int
    triangles: int
    promises: list[Promise]
    shrunk: Optional[np.ndarray]
    case: Optional[Case]
    ulps: Optional[float]
    worst: dict = field(default_factory=dict)
    error: Optional[str] = None

    def __getitem__(self, promise: str) -> Promise:
        for p in self.promises:
            if p.name == promise:
                return p
        raise KeyError(f"{promise!r}; there are {', '.join(p.name for p in self.promises)}")

    @property
    def holds(self) -> list[str]:
        """The promises that held on all that was tried: what its author may promise of it."""
        return [p.name for p in self.promises if p.held]

    @property
    def headline(self) -> str:
        if self.judged == 0:
            return f"{self.name} {self.scalar}: nothing was judged"
        broken = max((p.broken for p in self.promises), default=0)
        state = "kept" if self.kept else f"BROKEN on up to {broken} triangles"
        return f"{self.name} {self.scalar}: {state}; judged: {self.judged} of {self.triangles}"

    def _rows(self) -> list[tuple[str, str, str]]:
        said = {None: "not judged", True: "yes"}
        return [(p.name, said.get(p.held, f"no, on {p.broken}"), p.reason) for p in self.promises]

    def __repr__(self) -> str:
        lines = [self.headline]
        lines += [f"  {name:<18} {held:<12} {reason}".rstrip() for name, held, reason in self._rows()]
        if self.shrunk is not None:
            lines += ["  smallest counterexample, a vertex a line:"]
            lines += ["    " + "  ".join(f"{x:g}" for x in vertex) for vertex in self.shrunk]
        if self.error:
            lines += ["  the function raised:", *("    " + line for line in self.error.splitlines())]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        def row(cells: Iterable[str], tag: str = "td") -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells) + "</tr>"

        table = row(("promise", "held?", "first counterexample"), "th") + "".join(map(row, self._rows()))
        text = f"<p>{html.escape(self.headline)}</p><table>{table}</table>"
        if self.shrunk is not None:
            vertices = "".join(row(f"{x:g}" for x in vertex) for vertex in self.shrunk)
            text += f"<p>Smallest counterexample:</p><table>{vertices}</table>"
        if self.error:
            text += f"<p>The function raised:</p><pre>{html.escape(self.error)}</pre>"
        return text


class Trophy(NamedTuple):
    """The worst that a hunt has found by one measure: a lower bound. See `hunt`."""

    measure: str
    value: float
    case: Case
    shrunk_value: Optional[float]
    shrunk: Optional[Case]
    replay: str
    evaluations: int


def _guest_of(
    function: Callable, space: str, answers: str, attributes: int, depth: Any, options: dict[int, bool], batch: bool
) -> _guest.Guest:
    if space not in ("clip", "view"):
        raise ValueError(f"space: {space!r}; expected 'clip' or 'view'")
    if answers not in ("ndc", "clip") or answers == "clip" and space == "view":
        raise ValueError(f"answers: {answers!r}; expected 'ndc', or of space='clip' also 'clip'")
    depths = (depth,) if isinstance(depth, str) else tuple(depth)
    if not depths or any(d not in DEPTHS for d in depths):
        raise ValueError(f"depth: {depth!r}; expected some of {', '.join(map(repr, DEPTHS))}")
    bits = _guest.FLOAT | _guest.DOUBLE | _guest.TRIANGLES
    bits |= _guest.VIEW_SPACE | _guest.OTHER_FRUSTA if space == "view" else _guest.CLIP_SPACE
    bits |= _guest.ANSWERS_IN_CLIP_SPACE if answers == "clip" else 0
    for d in depths:
        bits |= _guest.DEPTH_BITS[d]
    for bit, takes in options.items():
        bits |= bit if takes else 0
    most = whole_number("attributes", attributes, 0, 32)
    return _guest.Guest(function, bits, most, batch, _guest.name_of(function))


def _ask(clipper: Any, guest: Optional[_guest.Guest], command: list[str], seconds: float) -> dict:
    good = (0, 1, NOTHING_JUDGED)
    if guest is None:
        return run_json([*command, "--clipper", clipper], good=good)
    with guest:
        there = {"CLIPSCOPE_PYTHON_SOCKET": guest.path}
        limits = ["--plugin", str(_BRIDGE), "--time-limit", str(seconds)]
        if command[0] == "hunt":
            limits += ["--clipper", guest.name, "--threads", "1"]
        return run_json([*command, *limits], good=good, environment=there)


def _contestant(clipper: Any, takes: tuple) -> Optional[_guest.Guest]:
    if callable(clipper):
        return _guest_of(clipper, *takes)
    if clipper not in [c.name for c in clippers()]:
        raise ValueError(f"clipper: {clipper!r}; expected a function, or a name of clippers()")
    return None


def _number(value: Any) -> Optional[float]:
    """JSON has no infinity: the program writes it as text."""
    return None if value is None else float(value)


def _verdict(found: dict, error: Optional[str]) -> Verdict:
    promises = []
    for p in found["promises"]:
        first = p["counterexample"] or {}
        hexes = first.get("hex")
        promises.append(
            Promise(
                p["name"], p["held"], p["judged"], p["broken"], first.get("reason", ""),
                numbers_of_hex(hexes) if hexes else None, first.get("replay", ""),
            )  # fmt: skip
        )
    shrunk, case = found.get("shrunk"), found.get("shrunk_case")
    return Verdict(
        found["clipper"],
        found["scalar"],
        found["kept"],
        found["judged"],
        found["triangles"],
        promises,
        numbers_of_hex(shrunk) if shrunk else None,
        read_cases(case)[0] if case else None,
        _number(found.get("largest_backward_error_ulp")),
        found.get("worst") or {},
        error,
    )


def verify(
    function: Union[Callable, str],
    *,
    triangles: int = 500,
    catalogue: bool = False,
    scalar: str = "float",
    promises: Union[str, Iterable[str]] = (),
    space: str = "clip",
    answers: str = "ndc",
    batch: bool = False,
    attributes: int = 0,
    depth: Union[str, Iterable[str]] = "gl",
    depth_clamp: bool = False,
    clip_distances: bool = False,
    open_sides: bool = False,
    shrink: bool = True,
    seconds: float = 60,
) -> Verdict:
    """Judges a function that clips, as every clipper of clipscope is judged: by exact arithmetic.

    function: takes a triangle, (3, 4 + k) of float32 or float64, x, y, z, w in clip space and k
        attributes; returns the convex polygon left of it, (m, 4 + k): x, y, z in NDC, 1/w, and the
        attributes' true values; None or nothing where nothing is left. One with a second parameter
        is told what it clips against, an `Against`. Or the name of one of ours.
    triangles: so many random ones are tried; catalogue: also the hard cases and their families.
    scalar: "float" or "double", that it is given and judged in.
    promises: what must hold: some of total, confined, contained, covers, winding, watertight,
        rotation, scale, constants, faithful, correctly_rounded, steady, or "all" [of a function
        total, contained, covers and winding]. All are examined.
    space: "clip", or "view": positions x, y, z, seen in `Against.projection`.
    answers: "clip" if it returns x, y, z, w instead: the division is then done for it.
    batch: it takes (n, 3, 4 + k) and returns n polygons, or a clipscope.Clipped.
    attributes: that it takes per vertex at most, clip distances included.
    depth, depth_clamp, clip_distances, open_sides: what it can be asked; it is asked nothing else.
    shrink: whether the first counterexample is made as small as it goes.
    seconds: what a call for up to 4096 triangles may take.

    Returns a `Verdict`. An exception in the function is an outcome, no answer, and the first one is
    Verdict.error. Raises ValueError for wrong arguments, ProgramError where the program can't ask.
    """
    options = {
        _guest.DEPTH_CLAMP: depth_clamp,
        _guest.CLIP_DISTANCES: clip_distances,
        _guest.OPEN_SIDES: open_sides,
    }
    guest = _contestant(function, (space, answers, attributes, depth, options, batch))
    command = ["verify", "--scalar", scalar, "--space", space]
    command += ["--triangles", str(whole_number("triangles", triangles, 0, 10**9))] if triangles else []
    command += ["--catalogue"] if catalogue else []
    named = [promises] if isinstance(promises, str) else list(promises)
    command += ["--promise", ",".join(named)] if named else []
    command += [] if shrink else ["--no-shrink"]
    if not triangles and not catalogue:
        raise ValueError("triangles: 0, and no catalogue; expected something to try")
    found = _ask(function, guest, command, seconds)
    return _verdict(found, guest.error if guest else None)


def hunt(
    function: Union[Callable, str],
    measure: str = "px",
    *,
    evaluations: int = 2000,
    scalar: str = "float",
    seed: int = 1,
    space: str = "clip",
    answers: str = "ndc",
    batch: bool = False,
    attributes: int = 0,
    depth: Union[str, Iterable[str]] = "gl",
    in_domain: bool = False,
    seconds: float = 60,
) -> Trophy:
    """Searches for the triangle on which a clipper is worst, and shrinks it.

    measure: "px" or "ulp" (position), "attribute", "containment", "crack" or "crash".
    evaluations: triangles to try; seed: the same find the same.
    in_domain: triangles alone of which the bounds of `verify` speak.
    Other arguments: as in `verify`. Returns a `Trophy`: a lower bound of the worst. Raises
    ValueError and ProgramError, as `verify` does.
    """
    if measure not in MEASURES:
        raise ValueError(f"measure: {measure!r}; expected one of {', '.join(MEASURES)}")
    guest = _contestant(function, (space, answers, attributes, depth, {}, batch))
    command = ["hunt", "--scalar", scalar, "--space", space, "--measure", measure]
    command += ["--evaluations", str(whole_number("evaluations", evaluations, 1, 10**12)), "--seed", str(seed)]
    command += (["--in-domain"] if in_domain else []) + ["--plain"]
    found = _ask(function, guest, command, seconds)["hunts"][0]
    worst, shrunk = found["worst"], found.get("shrunk")
    return Trophy(
        measure,
        float(worst["value"]),
        read_cases(worst["case"])[0],
        _number(shrunk["value"]) if shrunk else None,
        read_cases(shrunk["case"])[0] if shrunk else None,
        (shrunk or worst)["replay"],
        found["evaluations"],
    )
