# SPDX-License-Identifier: Apache-2.0
"""The data set of a sweep: a folder of Parquet files that only ever grows.

  plan.json          whose runs these are
  runs/*.parquet     rows, each one run; a file comes whole or not at all
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import re
import uuid
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.compute
import pyarrow.dataset
import pyarrow.parquet

from trammel.sweep import files
from trammel.sweep.files import PlanError, replace

FIXED = ("run", "part", "scenario", "end", "message", "wall_s", "event_hash")
NEEDED = {"run": pa.int64(), "part": pa.int64(), "scenario": pa.string(), "end": pa.string(),
          "message": pa.string()}
KINDS = {pa.int64(), pa.float64(), pa.bool_(), pa.string()}
LOCK = ".lock"
ENDS_REFUSED = ("refused", "lost")  # runs that have no result


def check_record(record: Path, identity: dict, holds: str, kind: str, made: str) -> None:
    """Refuses a folder of another identity, or with anything else in it."""
    folder = record.parent
    kept = files.read_json(record)
    if kept is not None:
        other = next((k for k in identity if kept.get(k) != identity[k]), None)
        if other:
            raise PlanError(f"{folder}: holds the {holds} of another "
                            f"{'version' if other == 'version' else kind}; give another folder "
                            "with -o, or remove it")
    elif folder.exists() and not all(_is_begun(entry, record) for entry in folder.iterdir()):
        raise PlanError(f"{folder}: is not empty and holds no {made}; give another folder with -o")


def _is_begun(entry: Path, record: Path) -> bool:
    """What others that begin now, or were killed before there was a record, have in the folder."""
    scratch = rf"\.{re.escape(record.name)}\.[0-9a-f]{{16}}-\d+"
    return re.fullmatch(rf"{re.escape(LOCK)}(-\d+-of-\d+)?|{scratch}", entry.name) is not None


def lock(folder: Path, name: str, made: str):
    """A file that is open as long as somebody writes into the folder, which it makes."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{LOCK}{name}"
    held = os.fdopen(files.opened(file, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW), "r+b")
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        held.close()
        raise PlanError(f"{folder}: another {made} writes here now") from None
    return held


def keep_record(record: Path, identity: dict) -> None:
    if not record.is_file():
        replace(record, (json.dumps(identity, indent=2) + "\n").encode())


class Store:
    """Runs that are there already are not made again; those of another plan are refused."""

    def __init__(self, folder: Path, identity: dict, name: str = ""):
        self.folder = Path(folder)
        self.name = name
        self.runs = self.folder / "runs"
        record = self.folder / "plan.json"
        self.count = identity["runs"]
        check_record(record, identity, "runs", "plan", "sweep")
        files.check_folder(self.runs)
        self._lock = lock(self.folder, name, "sweep")
        keep_record(record, identity)
        self.runs.mkdir(exist_ok=True)

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *_) -> None:
        self._lock.close()

    def done(self) -> np.ndarray:
        """Numbers of the runs that are there."""
        found = [np.empty(0, dtype=np.int64)]
        for file in files.inside(self.runs, "*.parquet"):
            schema(file)
            with _reading(file):
                numbers = pa.parquet.read_table(file, columns=["run"])["run"]
            if numbers.null_count or not all(0 <= n < self.count for n in
                                             pa.compute.min_max(numbers).as_py().values() if n):
                raise PlanError(f"{file}: holds a run that is not of this plan")
            found.append(numbers.to_numpy())
        return np.unique(np.concatenate(found))

    def add(self, rows: list[dict]) -> None:
        """One more file of these rows."""
        names = [n for n in FIXED if any(n in row for row in rows)]
        names += [n for n in dict.fromkeys(n for row in rows for n in row) if n not in FIXED]
        table = pa.table({name: column(name, [row.get(name) for row in rows]) for name in names})
        file = self.runs / f"{rows[0]['run']:010d}-{uuid.uuid4().hex[:8]}.parquet"
        whole = pa.BufferOutputStream()
        pa.parquet.write_table(table, whole, compression="zstd")
        replace(file, whole.getvalue())

    def table(self, columns: list[str] | None = None) -> pa.Table:
        return read(self.folder, columns)


def column(name: str, values: list) -> pa.Array:
    if name in ("run", "part"):
        return pa.array(values, pa.int64())
    kinds = {type(value) for value in values if value is not None}
    if kinds <= {int, float}:  # a key may be whole in one run and not in another
        return pa.array(values, pa.float64())
    if kinds == {bool}:
        return pa.array(values, pa.bool_())
    return pa.array([None if v is None else str(v) for v in values], pa.string())


@contextlib.contextmanager
def _reading(place: Path):
    """What Arrow says of a file that is none of its own is no error of the disk."""
    try:
        yield
    except (pa.ArrowException, OSError) as error:
        if isinstance(error, OSError) and error.errno:
            raise
        raise PlanError(f"{place}: is corrupt") from None


def schema(file: Path) -> pa.Schema:
    """Names and types of a file of runs."""
    with _reading(file):
        found = pa.parquet.read_schema(file)
    if not set(found.types) <= KINDS or any(
            found.names.count(name) != 1 or found.field(name).type != kind
            for name, kind in NEEDED.items()):
        raise PlanError(f"{file}: holds no runs")
    return found


def read(folder, columns: list[str] | None = None) -> pa.Table:
    """All rows of a sweep's folder, by number; figures that a machine lacks are null."""
    runs = Path(folder, "runs")
    found = files.inside(runs, "*.parquet")
    if not found:
        raise PlanError(f"{folder}: holds no runs")
    kinds = {}
    for field in (field for file in found for field in schema(file)):
        known = kinds.setdefault(field.name, field.type)
        if known != field.type:  # a key that is a number or a flag in one and a text in another
            kinds[field.name] = pa.string()
    with _reading(runs):
        data = pa.dataset.dataset([str(file) for file in found], schema=pa.schema(kinds.items()))
        return data.to_table(columns=columns).sort_by("run")
