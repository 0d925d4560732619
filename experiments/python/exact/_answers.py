# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a run of the program, read from its results.sqlite."""

from __future__ import annotations

import pathlib
import sqlite3
import struct
from collections.abc import Mapping
from typing import Any, Iterator, Union


def _value(value: Any) -> Any:
    # SQL has no NaN: the store keeps one as the eight bytes of it.
    return struct.unpack(">d", value)[0] if isinstance(value, bytes) and len(value) == 8 else value


class Results(Mapping):
    """The tables of a run by name: see `results`."""

    def __init__(self, file: pathlib.Path) -> None:
        self._file = file
        with self._open() as store:
            named = store.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")
            self._names = [name for (name,) in named if not name.startswith("sqlite_")]

    def _open(self) -> sqlite3.Connection:
        return sqlite3.connect(f"{self._file.absolute().as_uri()}?mode=ro", uri=True)

    def columns(self, table: str) -> dict[str, list]:
        """The columns of a table by name, each a list."""
        if table not in self._names:
            raise KeyError(f"{table!r}; there are {', '.join(self._names)}")
        store = self._open()
        try:
            cursor = store.execute(f'SELECT * FROM "{table}"')
            names = [column for column, *_ in cursor.description]
            rows = [[_value(v) for v in row] for row in cursor]
        finally:
            store.close()
        return {name: [row[i] for row in rows] for i, name in enumerate(names)}

    def __getitem__(self, table: str) -> Any:
        """A pandas.DataFrame where pandas is there, else what `columns` gives."""
        columns = self.columns(table)
        try:
            import pandas
        except ImportError:
            return columns
        return pandas.DataFrame(columns)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return f"<Results of {self._file}: {', '.join(self._names)}>"


def results(folder: Union[str, pathlib.Path]) -> Results:
    """The tables of a run: its folder (--out of `clipscope run`), or its results.sqlite.

    results(folder)["accuracy"] is a pandas.DataFrame where pandas is there, else a dict of columns.
    Raises FileNotFoundError where there is no run.
    """
    path = pathlib.Path(folder)
    file = path / "results.sqlite" if path.is_dir() else path
    if not file.is_file():
        raise FileNotFoundError(f"{file} is not there; expected the folder of a run of `clipscope run`")
    return Results(file)
