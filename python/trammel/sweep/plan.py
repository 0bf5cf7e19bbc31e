# SPDX-License-Identifier: Apache-2.0
"""What a sweep runs: a plan in TOML, and the keys and values of each of its runs."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
import os
import re
import tomllib
import zlib
from pathlib import Path
from typing import NamedTuple

import numpy as np

from trammel import _core
from trammel.run_settings import SettingError, _apply, _given
from trammel.sweep import files
from trammel.sweep.files import PlanError

SECTIONS = ("keys", "grid", "latin", "random", "table")
OWN = {"scenario", "engine", *SECTIONS}
MOST = 10**7  # runs without --yes
MOST_BYTES = 4 << 20


def read_toml(file: Path, error: type[PlanError] = PlanError) -> dict:
    """What a plan or a study holds."""
    try:
        text = files.read(file, MOST_BYTES, 0)
    except PlanError as why:
        raise error(str(why)) from None
    except OSError as why:
        raise error(f"{file}: cannot be read: {why.strerror}") from None
    if len(text) > MOST_BYTES:
        raise error(f"{file}: longer than {MOST_BYTES >> 20} MiB")
    try:
        return tomllib.loads(text.decode())
    except ValueError as why:  # of TOML, of UTF-8, or a number of too many digits
        raise error(f"{file}: {why}") from None
    except RecursionError:
        raise error(f"{file}: lists or tables too deep in each other") from None


class Axis(NamedTuple):
    """One key: its values, or how they are drawn."""

    key: str
    values: tuple = ()  # of a grid
    spread: str = "uniform"  # uniform, log or normal
    low: float = 0.0  # normal: mean
    high: float = 0.0  # normal: standard deviation
    whole: bool = False  # only whole numbers

    def at(self, share: np.ndarray) -> np.ndarray:
        """Values at these shares of the distribution, 0 to 1."""
        if self.spread == "normal":
            from statistics import NormalDist

            inverse = NormalDist(self.low, self.high).inv_cdf
            inside = np.clip(share, 1e-12, 1 - 1e-12)
            return np.array([inverse(s) for s in inside])
        if self.spread == "log":
            return self.low * (self.high / self.low) ** share
        if self.whole:  # each as likely, both ends among them
            return np.floor(self.low + share * (self.high - self.low + 1)).astype(np.int64)
        return self.low + share * (self.high - self.low)


def _is_number(value) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def grid_axis(where: str, key: str, given, whole: bool) -> Axis:
    """[values...], or {from, to, count} with scale = "log" if wanted; whole numbers of a key that
    takes no others."""
    if isinstance(given, list):
        if not given:
            raise PlanError(f"{where}: {key}: an empty list; it needs at least one value")
        if any(isinstance(value, list | dict) for value in given):
            raise PlanError(f"{where}: {key}: a value must be no list or table")
        return Axis(key, tuple(given))
    if not isinstance(given, dict) or not {"from", "to", "count"} <= set(given) <= {
            "from", "to", "count", "scale"}:
        raise PlanError(f"{where}: {key}: expects a list of values or {{from, to, count}}")
    low, high, count = given["from"], given["to"], given["count"]
    scale = given.get("scale", "linear")
    if not (_is_number(low) and _is_number(high) and low < high):
        raise PlanError(f"{where}: {key}: an empty range: from must be below to")
    if type(count) is not int or not 2 <= count <= MOST:
        raise PlanError(f"{where}: {key}: count must be 2..{MOST}")
    if scale not in ("linear", "log") or (scale == "log" and low <= 0):
        raise PlanError(f"{where}: {key}: scale must be linear, or log with from above 0")
    spaced = np.geomspace if scale == "log" else np.linspace
    values = spaced(low, high, count).tolist()
    if whole:
        broken = [v for v in values if not math.isclose(v, round(v), rel_tol=1e-12,
                                                      abs_tol=1e-9)]
        if broken:
            shown = ", ".join(f"{v:g}" for v in broken[:3]) + (", ..." if len(broken) > 3 else "")
            raise PlanError(f"{where}: {key}: takes whole numbers; {count} values from {low} to "
                            f"{high} have {shown} among them")
        values = [round(v) for v in values]
    return Axis(key, tuple(values))


def drawn_axis(where: str, key: str, given, whole: bool) -> Axis:
    """[low, high], {log = [low, high]} or {normal = [mean, deviation]}; whole numbers alone of a
    key that takes no others."""
    spread = "uniform"
    if isinstance(given, dict) and len(given) == 1:
        spread, given = next(iter(given.items()))
    if spread not in ("uniform", "log", "normal") or not isinstance(given, list) \
            or len(given) != 2 or not all(map(_is_number, given)):
        raise PlanError(f"{where}: {key}: expects [low, high], {{log = [low, high]}} or "
                        "{normal = [mean, deviation]}")
    low, high = given
    if spread == "normal" and high <= 0:
        raise PlanError(f"{where}: {key}: the deviation must be above 0")
    if spread != "normal" and low >= high:
        raise PlanError(f"{where}: {key}: an empty range: {low} is not below {high}")
    if spread == "log" and low <= 0:
        raise PlanError(f"{where}: {key}: log needs a range above 0")
    if whole and not (spread == "uniform" and isinstance(low, int) and isinstance(high, int)):
        raise PlanError(f"{where}: {key}: takes whole numbers: expects [low, high] of such")
    return Axis(key, (), spread, low, high, whole)


def table_points(where: str, given, folder: Path) -> dict[str, list]:
    """The columns of a CSV or Parquet file: keys, a line for each run."""
    if not isinstance(given, dict) or set(given) != {"file"}:
        raise PlanError(f"{where}: expects file = \"points.csv\" or .parquet")
    file = folder / str(given["file"])
    try:
        os.close(files.opened(file, os.O_RDONLY))
        if file.suffix == ".parquet":
            from pyarrow import parquet

            columns = parquet.read_table(file).to_pydict()
        else:
            from pyarrow import csv

            columns = csv.read_csv(file).to_pydict()
    except PlanError as error:
        raise PlanError(f"{where}: {error}") from None
    except Exception as error:  # of the file or of its format
        said = str(error).splitlines() or [type(error).__name__]
        raise PlanError(f"{where}: {file}: {said[0]}") from None
    if not columns or not len(next(iter(columns.values()))):
        raise PlanError(f"{where}: {file}: holds no run")
    for key, values in columns.items():
        empty = next((n for n, v in enumerate(values, 1) if v is None or v != v), None)
        if empty is not None:
            raise PlanError(f"{where}: {file}: {key}: run {empty} of {len(values)} has no value")
        if not all(isinstance(value, bool | int | float | str) for value in values):
            raise PlanError(f"{where}: {file}: {key}: holds other values than numbers, flags and "
                            "texts")
    return columns


class Part:
    """Runs of one scenario: each point of the grid with each of the drawn points."""

    def __init__(self, where: str, given: dict, folder: Path, seed: int, number: int):
        unknown = sorted(set(given) - OWN)
        if unknown:
            raise PlanError(f"{where}: {unknown[0]}: unknown; a part has {', '.join(sorted(OWN))}")
        self.scenario = given.get("scenario")
        if not isinstance(self.scenario, str):
            raise PlanError(f"{where}: scenario: expects a name or a file")
        if (folder / self.scenario).is_file():
            self.scenario = str(folder / self.scenario)
        self.engine = given.get("engine", "twin")
        for name in SECTIONS:
            if not isinstance(given.get(name, {}), dict):
                raise PlanError(f"{where}: {name}: expects a table")
        self.keys = given.get("keys", {})
        whole = self._whole_keys(where)
        self.grid = [grid_axis(f"{where} [grid]", key, value, key in whole)
                     for key, value in given.get("grid", {}).items()]
        self.drawn = self._drawn(where, given, seed, number, whole)
        self.table = (table_points(f"{where} [table]", given["table"], folder)
                      if "table" in given else {})
        if self.table and self.drawn:
            raise PlanError(f"{where}: a table and drawn points together; one part has one")
        self.points = self.table or self.drawn
        self.grid_count = math.prod(len(axis.values) for axis in self.grid)
        self.count = self.grid_count * (len(next(iter(self.points.values()))) if self.points else 1)
        self.check(where)

    def _drawn(self, where: str, given: dict, seed: int, number: int,
               whole: set[str]) -> dict[str, np.ndarray]:
        if "latin" in given and "random" in given:
            raise PlanError(f"{where}: latin and random together; one part has one")
        name = "latin" if "latin" in given else "random"
        section = dict(given.get(name, {}))
        if not section:
            return {}
        count = section.pop("count", None)
        if type(count) is not int or not 1 <= count <= 100 * MOST:
            raise PlanError(f"{where} [{name}]: count must be 1..{100 * MOST}")
        if not section:
            raise PlanError(f"{where} [{name}]: names no key")
        points = {}
        for key, value in section.items():
            axis = drawn_axis(f"{where} [{name}]", key, value, key in whole)
            # A stream of its own for each key: another key more changes no value of the others.
            draw = np.random.default_rng([seed, number, zlib.crc32(key.encode())])
            share = draw.random(count)
            if name == "latin":  # one in each of `count` equal parts, in random order
                share = (draw.permutation(count) + share) / count
            points[key] = axis.at(share)
        return points

    def _whole_keys(self, where: str) -> set[str]:
        """Keys that take whole numbers, and their names without an axis."""
        try:
            values = _core.Settings(self.scenario).values
        except _core.ConfigError as error:
            raise PlanError(f"{where}: {error}") from None
        names = [key for key, value in values.items() if type(value) is int]
        return {*names, *(re.sub(r"\.[xy]\.", ".", name) for name in names)}

    def check(self, where: str) -> None:
        """Each key exists, and texts and the ends of numbers are values that it takes."""
        tried = {axis.key: axis.values for axis in self.grid}
        tried |= {key: (min(values), max(values)) if not isinstance(values[0], str) else values
                  for key, values in self.points.items()}
        twice = [key for key in tried if key in self.keys]
        twice += [axis.key for axis in self.grid if axis.key in self.points]
        if twice:
            raise PlanError(f"{where}: {twice[0]}: given twice")
        try:
            _given(self.scenario, self.engine, (), self.keys).validate()
            base = _core.Settings(self.scenario)
            for key, values in tried.items():
                for value in dict.fromkeys(values):
                    _apply(base.copy(), key, value)
        except _core.ConfigError as error:
            raise PlanError(f"{where}: {error}") from None
        self.machine = base.machine

    @property
    def varied(self) -> list[str]:
        return [axis.key for axis in self.grid] + list(self.points)

    def point(self, number: int) -> dict:
        """Keys and values of a run of this part, besides those that all have."""
        drawn, cell = divmod(number, self.grid_count)
        values = {}
        for axis in reversed(self.grid):
            cell, at = divmod(cell, len(axis.values))
            values[axis.key] = axis.values[at]
        values = dict(reversed(values.items()))
        for key, column in self.points.items():
            value = column[drawn]
            values[key] = value.item() if hasattr(value, "item") else value
        return values

    def identity(self) -> dict:
        return {"scenario": self.scenario, "engine": self.engine, "keys": self.keys,
                "grid": {axis.key: list(axis.values) for axis in self.grid},
                "points": {key: hashlib.sha256(repr(list(column)).encode()).hexdigest()
                           for key, column in self.points.items()}}


class Plan:
    """The parts of a plan, and its runs, which are numbered from 0 through all of them."""

    def __init__(self, file: Path):
        self.file = Path(file)
        given = read_toml(self.file)
        self.seed = given.pop("seed", 1)
        if type(self.seed) is not int or self.seed < 0:
            raise PlanError(f"{self.file}: seed: expects a whole number from 0")
        parts = given.pop("part", None)
        if parts is None:
            parts = [given]
        elif given:
            raise PlanError(f"{self.file}: {next(iter(given))}: belongs in a [[part]]")
        if not isinstance(parts, list) or not parts or not all(isinstance(p, dict) for p in parts):
            raise PlanError(f"{self.file}: expects one scenario, or several as [[part]]")
        folder = self.file.parent
        self.parts = []
        for number, part in enumerate(parts):
            where = str(self.file) + (f" part {number + 1}" if len(parts) > 1 else "")
            try:
                self.parts.append(Part(where, part, folder, self.seed, number))
            except SettingError as error:
                raise PlanError(f"{where}: {error}") from None
        self.first = [0, *itertools.accumulate(part.count for part in self.parts)]

    @property
    def count(self) -> int:
        return self.first[-1]

    @property
    def varied(self) -> list[str]:
        return list(dict.fromkeys(key for part in self.parts for key in part.varied))

    def run(self, number: int) -> tuple[int, dict]:
        """Part and values of a run."""
        part = next(n for n in range(len(self.parts)) if number < self.first[n + 1])
        return part, self.parts[part].point(number - self.first[part])

    def identity(self) -> dict:
        """What makes the runs what they are; a data set belongs to one of them."""
        parts = [part.identity() for part in self.parts]
        text = json.dumps([self.seed, parts], sort_keys=True, default=str)
        return {"plan": hashlib.sha256(text.encode()).hexdigest(), "runs": self.count,
                "version": _core.version}
