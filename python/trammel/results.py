# SPDX-License-Identifier: Apache-2.0
"""What a run gives: figures with units, and columns as NumPy arrays."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

from trammel import _core


class Figure(float):
    """A number with its unit; what the run is judged by.

    unit, name            as the report shows them
    expected, tolerance   what it must be, where something is expected; else None and 0
    printed, source       what the machine's source prints, and where
    """

    def __new__(cls, value: float, unit: str = "", name: str = "", expected: float | None = None,
                tolerance: float = 0.0, printed: float | None = None, source: str = ""):
        figure = super().__new__(cls, value)
        figure.unit, figure.name = unit, name
        figure.expected, figure.tolerance = expected, tolerance
        figure.printed, figure.source = printed, source
        return figure

    def __getnewargs__(self):
        return (float(self), self.unit, self.name, self.expected, self.tolerance, self.printed,
                self.source)

    @property
    def good(self) -> bool:
        """Within tolerance, or nothing is expected."""
        return self.expected is None or abs(self - self.expected) <= self.tolerance

    def __repr__(self) -> str:
        return f"{float(self):.6g} {self.unit}".rstrip()


class Column(NamedTuple):
    """What a column of the record holds; its unit also ends its name where it is physical."""

    name: str
    unit: str
    help: str
    digits: int | None  # of trace.csv: behind the point; -n: n in all; None: a whole number

    def text(self, value: float) -> str:
        """As trace.csv prints it."""
        if self.digits is None:
            return f"{int(value)}"
        return f"{value:.{self.digits}f}" if self.digits >= 0 else f"{value:.{-self.digits}g}"


class Result(Mapping):
    """A finished run. A mapping from the names of columns to their NumPy arrays, one value a
    sample: whole numbers where trace.csv has them, else doubles."""

    def __init__(self, record: _core.Record):
        self._record = record

    def __getitem__(self, name: str) -> np.ndarray:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        return f"<{self.scenario}: {self.verdict}>"

    @cached_property
    def _arrays(self) -> dict[str, np.ndarray]:
        arrays = {}
        for column, values in zip(self.columns.values(), self._record.values()):
            whole = column.digits is None
            arrays[column.name] = np.rint(values).astype(np.int64) if whole else values
        return arrays

    @cached_property
    def columns(self) -> dict[str, Column]:
        """Unit and meaning of every column."""
        return {name: Column(name, *more) for name, *more in self._record.columns}

    @cached_property
    def units(self) -> dict[str, str]:
        return {name: column.unit for name, column in self.columns.items()}

    @cached_property
    def figures(self) -> dict[str, Figure]:
        """By their places in metrics.json, such as "tracking.model.mean_mm"."""
        return {place: Figure(*more) for place, *more in self._record.figures}

    @cached_property
    def metrics(self) -> dict:
        """All that metrics.json holds."""
        return json.loads(self._record.metrics)

    @property
    def end(self) -> str:
        """How it ended: "done", "tripped", "diverged", "missed", "timeout", "assertion failed"."""
        return self._record.end

    @property
    def ok(self) -> bool:
        return self._record.code == 0

    @property
    def verdict(self) -> str:
        """How it ended, in one line."""
        return self._record.verdict

    @property
    def settings(self) -> dict:
        """Every key and its value."""
        return self._record.settings.values

    @property
    def scenario(self) -> str:
        return self._record.settings.scenario

    @property
    def command(self) -> str:
        """The command that repeats the run."""
        return self._record.settings.command

    @property
    def simulated_s(self) -> float:
        """Simulated time [s]."""
        return self._record.simulated_s

    @property
    def wall_s(self) -> float:
        """What the simulation took [s]."""
        return self._record.wall_s

    @property
    def event_hash(self) -> str:
        """Of all events of the run: equal in every wiring and engine."""
        return f"{self._record.event_hash:016x}"

    @property
    def companions(self) -> dict[str, Result]:
        """The runs that it is compared with, by name."""
        return {one.name: Result(one) for one in self._record.companions}

    def to_pandas(self):
        """The columns as a pandas.DataFrame; the units in its attrs["units"]."""
        import pandas

        frame = pandas.DataFrame(dict(self))
        frame.attrs["units"] = self.units
        return frame

    def to_polars(self):
        """The columns as a polars.DataFrame."""
        import polars

        return polars.DataFrame(dict(self))

    def write_trace(self, file: str | os.PathLike) -> None:
        """trace.csv, as `trammel run` writes it."""
        self._record.write_trace(os.fspath(file))

    def save(self, folder: str | os.PathLike, *, page: bool = True) -> list[str]:
        """All files of the run into a folder, as `trammel run -o` writes them; returns its notes.

        A folder that is not empty and holds no run is refused with ConfigError."""
        return self._record.save(os.fspath(folder), page)

    def report(self, file: str | os.PathLike) -> None:
        """The page of the run: one self-contained file."""
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch) / self.scenario
            self.save(folder, page=False)
            _core.write_page([str(folder)], os.fspath(file))


def compare(results: list[Result], file: str | os.PathLike) -> None:
    """A page that compares 2 to 12 runs of one machine; the first is the reference."""
    with tempfile.TemporaryDirectory() as scratch:
        folders = []
        for number, result in enumerate(results):
            folder = Path(scratch) / str(number) / result.scenario
            folder.parent.mkdir()
            result.save(folder, page=False)
            folders.append(str(folder))
        _core.write_page(folders, os.fspath(file))
