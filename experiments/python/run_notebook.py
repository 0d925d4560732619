#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_notebook.py NOTEBOOK...: executes the code cells of notebooks, in order, and prints what they show.

Jupyter is not needed. An exception ends it with exit code 1, naming notebook and cell.
"""

import ast
import json
import pathlib
import sys
import traceback


def run_cell(source: str, names: dict) -> None:
    """As a notebook does it: the value of a last expression is shown."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is not None:
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        if value is not None:
            print(value)


def run_notebook(path: pathlib.Path) -> None:
    cells = [c for c in json.loads(path.read_text())["cells"] if c["cell_type"] == "code"]
    names: dict = {"__name__": "__main__"}
    for number, cell in enumerate(cells, 1):
        print(f"{path.name} [{number}]")
        try:
            run_cell("".join(cell["source"]), names)
        except Exception:
            traceback.print_exc()
            sys.exit(f"{path}: code cell {number} failed (above)")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} NOTEBOOK...")
    for argument in sys.argv[1:]:
        run_notebook(pathlib.Path(argument))
