# SPDX-License-Identifier: GPL-3.0-or-later
"""What a matrix means, and whether a box or a sphere is in sight."""

from __future__ import annotations

from typing import Any, Iterable, Sequence

from clipscope._volume import depth_number

from ._program import lens, number_text, run_json

SOLIDS = {"box": 6, "sphere": 4, "obb": 12, "points": None, "polygon": None}


def camera(projection: Any, *, depth: str = "gl") -> dict[str, Any]:
    """What a matrix (4, 4) or a Frustum means, as `clipscope camera --json` says it.

    Near and far planes by each depth convention with what float has lost of them (`conventions`),
    digits of depth that are left by distance (`depth_digits`), and so on; lengths in the unit of the
    view space. Raises ValueError for what is no projection, ProgramError where it can't be read.
    """
    depth_number(depth)
    return run_json(["camera", *lens(projection), "--depth", depth])


def bounds(solids: Iterable[Sequence[Any]], projection: Any, *, depth: str = "gl") -> list[dict[str, Any]]:
    """Is each solid in sight? A row for each bound: what the tests answer, the exact answer beside it.

    solids: ("box", x0, y0, z0, x1, y1, z1), ("sphere", x, y, z, r), ("obb", centre, three half axes:
        12 numbers), ("points", x, y, z, ...) or ("polygon", x, y, z, ...), in view space.
    projection: a Frustum or a matrix (4, 4).

    A row has by_planes, by_axes, exact and content, each "rejected", "accepted" or "look closer".
    Raises ValueError for a solid that is none.

    >>> from clipscope import Frustum
    >>> [row["exact"] for row in bounds([("sphere", 13, 0, -14, 4.9)], Frustum(-1, 1, -1, 1, 1, 10))]
    ['rejected']
    """
    depth_number(depth)
    text = ""
    for i, (kind, *values) in enumerate(solids):
        if kind not in SOLIDS:
            raise ValueError(f"solids: number {i} is {kind!r}; expected one of {', '.join(SOLIDS)}")
        expected = SOLIDS[kind]
        if len(values) != expected if expected else len(values) % 3 or not values:
            needed = f"{expected} numbers" if expected else "three numbers for each point"
            raise ValueError(f"solids: number {i}, a {kind}, has {len(values)} numbers; expected {needed}")
        text += " ".join([kind, *map(number_text, values)]) + "\n"
    return run_json(["bounds", *lens(projection), "--depth", depth], text)["rows"] if text else []
