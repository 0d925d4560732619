# SPDX-License-Identifier: GPL-3.0-or-later
"""The program clipscope, which has the exact reference and the judge: found, run, listened to."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import sys
from typing import Any, Iterable, Optional

import numpy as np

from clipscope import Frustum
from clipscope._arrays import numbers, shape_error

NOTHING_JUDGED = 6


class ProgramError(RuntimeError):
    """The program clipscope is missing, or it refused; the message is its own."""


def program() -> str:
    """The path of the program: $CLIPSCOPE_PROGRAM, beside this Python, or on the PATH."""
    beside = pathlib.Path(sys.prefix) / "bin" / "clipscope"
    named = os.environ.get("CLIPSCOPE_PROGRAM")
    for found in (named, beside if beside.exists() else None, shutil.which("clipscope")):
        if found:
            return str(found)
    raise ProgramError(
        "the program clipscope is not there: build it (experiments/run python does), put it on the PATH or set "
        "CLIPSCOPE_PROGRAM to its path"
    )


def run(arguments: Iterable[str], text: str = "", good: Iterable[int] = (0,), environment: Optional[dict] = None) -> str:
    """What the program prints. Raises ProgramError with what it says where it ends otherwise."""
    command = [program(), *arguments]
    started = subprocess.run(
        command, input=text, capture_output=True, text=True, env={**os.environ, **(environment or {})}
    )
    if started.returncode not in tuple(good):
        said = started.stderr.strip() or f"it ended with exit code {started.returncode}"
        raise ProgramError(f"clipscope {command[1]}: {said}")
    return started.stdout


def run_json(arguments: Iterable[str], text: str = "", good: Iterable[int] = (0,), environment: Optional[dict] = None) -> Any:
    return json.loads(run([*arguments, "--json"], text, good, environment))


def number_text(x: float) -> str:
    return float(x).hex() if np.isfinite(x) else str(float(x))


def lens(projection: Any) -> list[str]:
    """The options that name a projection: a Frustum or a matrix (4, 4)."""
    if isinstance(projection, Frustum):
        f = projection
        sides = ",".join(number_text(x) for x in (f.left, f.right, f.bottom, f.top, f.near, f.far))
        shear = ["--shear", f"{number_text(f.shear_x)},{number_text(f.shear_y)}"] if f.shear_x or f.shear_y else []
        return ["--ortho" if f.parallel else "--frustum", sides, *shear]
    matrix = numbers("projection", projection, np.dtype(np.float64))
    if matrix.shape != (4, 4):
        raise shape_error("projection", matrix, "a Frustum or a matrix (4, 4)")
    return ["--matrix", ",".join(map(number_text, matrix.ravel()))]


def lines(array: np.ndarray) -> str:
    """Each element of the first axis as a line of hex floats."""
    flat = array.reshape(len(array), -1).astype(np.float64)
    return "".join(" ".join(map(float.hex, row)) + "\n" for row in flat.tolist())
