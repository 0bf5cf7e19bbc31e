# SPDX-License-Identifier: Apache-2.0
"""The data set of a sweep: a folder of Parquet files that only ever grows.

  plan.json          whose runs these are
  runs/*.parquet     rows, each one run; a file comes whole or not at all
"""

from __future__ import annotations

import fcntl
import json
import os
import uuid
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.dataset
import pyarrow.parquet

from trammel.sweep.plan import PlanError

FIXED = ("run", "part", "scenario", "end", "message", "wall_s", "event_hash")
LOCK = ".lock"
ENDS_REFUSED = ("refused", "lost")  # runs that have no result


def replace(file: Path, write) -> None:
    """write(path) makes the file; it is there whole, or as it was before."""
    scratch = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        write(scratch)
        with scratch.open("rb") as stream:
            os.fsync(stream.fileno())
        os.replace(scratch, file)
    finally:
        scratch.unlink(missing_ok=True)


def check_record(record: Path, identity: dict, holds: str, kind: str, made: str) -> None:
    """Refuses a folder of another identity, or with anything else in it."""
    folder = record.parent
    if record.is_file():
        try:
            kept = json.loads(record.read_text(encoding="utf-8"))
        except ValueError:
            raise PlanError(f"{record}: is corrupt") from None
        other = next((k for k in identity if kept.get(k) != identity[k]), None)
        if other:
            raise PlanError(f"{folder}: holds the {holds} of another "
                            f"{'version' if other == 'version' else kind}; give another folder "
                            "with -o, or remove it")
    elif folder.exists() and not all(entry.name.startswith(LOCK) for entry in folder.iterdir()):
        raise PlanError(f"{folder}: is not empty and holds no {made}; give another folder with -o")


def lock(folder: Path, name: str, made: str):
    """A file that is open as long as somebody writes into the folder, which it makes."""
    folder.mkdir(parents=True, exist_ok=True)
    held = (folder / f"{LOCK}{name}").open("w")
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        held.close()
        raise PlanError(f"{folder}: another {made} writes here now") from None
    return held


def keep_record(record: Path, identity: dict) -> None:
    if not record.is_file():
        replace(record, lambda path: path.write_text(
            json.dumps(identity, indent=2) + "\n", encoding="utf-8"))


class Store:
    """Runs that are there already are not made again; those of another plan are refused."""

    def __init__(self, folder: Path, identity: dict, name: str = ""):
        self.folder = Path(folder)
        self.name = name
        self.runs = self.folder / "runs"
        record = self.folder / "plan.json"
        check_record(record, identity, "runs", "plan", "sweep")
        self._lock = lock(self.folder, name, "sweep")
        keep_record(record, identity)
        self.runs.mkdir(exist_ok=True)

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *_) -> None:
        self._lock.close()

    def done(self) -> np.ndarray:
        """Numbers of the runs that are there."""
        files = sorted(self.runs.glob("*.parquet"))
        found = [pa.parquet.read_table(file, columns=["run"])["run"].to_numpy() for file in files]
        return np.unique(np.concatenate(found)) if found else np.empty(0, dtype=np.int64)

    def add(self, rows: list[dict]) -> None:
        """One more file of these rows."""
        names = [n for n in FIXED if any(n in row for row in rows)]
        names += [n for n in dict.fromkeys(n for row in rows for n in row) if n not in FIXED]
        table = pa.table({name: column(name, [row.get(name) for row in rows]) for name in names})
        file = self.runs / f"{rows[0]['run']:010d}-{uuid.uuid4().hex[:8]}.parquet"
        replace(file, lambda path: pa.parquet.write_table(table, path, compression="zstd"))

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


def read(folder, columns: list[str] | None = None) -> pa.Table:
    """All rows of a sweep's folder, by number; figures that a machine lacks are null."""
    files = sorted(Path(folder, "runs").glob("*.parquet"))
    if not files:
        raise PlanError(f"{folder}: holds no runs")
    kinds = {}
    for field in (field for file in files for field in pa.parquet.read_schema(file)):
        known = kinds.setdefault(field.name, field.type)
        if known != field.type:  # a key that is a number or a flag in one and a text in another
            kinds[field.name] = pa.string()
    data = pa.dataset.dataset([str(file) for file in files], schema=pa.schema(kinds.items()))
    return data.to_table(columns=columns).sort_by("run")
