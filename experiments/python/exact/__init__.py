# SPDX-License-Identifier: GPL-3.0-or-later
"""clipscope.exact: the exact answer, and the judge.

    import clipscope.exact

    exact(triangles, ...)     the exact polygons, as fractions.Fraction or nearest doubles
    verify(function)          is my clipper right? By the exact judge; a table in a notebook
    hunt(function, measure)   on which triangle is it worst?
    catalogue()               all hard cases, as arrays
    camera(matrix)            what does a matrix mean?   bounds(solids, frustum): is it in sight?
    results(folder)           the tables of a run, as pandas frames where pandas is there

Licence: this submodule is under the GPL, version 3 or later, as the program clipscope is, which it
runs as a process of its own: $CLIPSCOPE_PROGRAM, beside this Python, or on the PATH. `import
clipscope` alone loads none of it and stays under the MIT licence.
"""

from ._answers import Results, results
from ._camera import bounds, camera
from ._cases import Case, catalogue, read_cases
from ._exact import ExactPolygons, exact
from ._guest import Against
from ._program import ProgramError, program
from ._verify import Promise, Trophy, Verdict, hunt, verify

__all__ = [
    "exact", "ExactPolygons", "verify", "Verdict", "Promise", "Against", "hunt", "Trophy", "catalogue", "Case",
    "read_cases", "camera", "bounds", "results", "Results", "program", "ProgramError",
]  # fmt: skip
