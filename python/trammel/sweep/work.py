# SPDX-License-Identifier: Apache-2.0
"""What a worker does: some runs, one after the other, and what is kept of each."""

from __future__ import annotations

import errno
import os
import socket
import time

from trammel import _core
from trammel.results import Result
from trammel.run_settings import _apply, _given

# What is of the worker's computer and not of the run: it may be made again.
TROUBLE = {errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO, errno.EMFILE, errno.ENFILE}

_bases: dict = {}  # settings of parts, as this process has read them


def _base(scenario: str, engine: str, keys: dict) -> _core.Settings:
    name = (scenario, engine, tuple(keys.items()))
    if name not in _bases:
        _bases[name] = _given(scenario, engine, (), keys)
    return _bases[name]


class WorkerError(Exception):
    """A computer that can make no run now, in one line."""


def one(scenario: str, engine: str, keys: dict, values: dict) -> dict:
    """A run: what was asked, how it ended, its figures. What cannot run is a row with a message;
    a full disk of the worker is a WorkerError."""
    row = {"scenario": scenario, **values}
    try:
        asked = _base(scenario, engine, keys).copy()
        for key, value in values.items():
            _apply(asked, key, value)
        asked.validate()
        result = Result(_core.run(asked))
    except (_core.ConfigError, _core.ToolMissing, OSError) as error:
        if isinstance(error, OSError) and error.errno in TROUBLE:
            where = f"worker on {socket.gethostname()}"
            raise WorkerError(f"{where}: {os.strerror(error.errno)}") from None
        return row | {"end": "refused", "message": str(error).removeprefix("-s: ")}
    return row | {"end": result.end, "message": result.verdict, "wall_s": result.wall_s,
                  "event_hash": result.event_hash,
                  **{place: float(figure) for place, figure in result.figures.items()}}


def nothing(values: dict) -> dict:
    """An empty run, to measure what is around it."""
    return {"scenario": "", **values, "end": "done", "message": "", "wall_s": 0.0}


def chunk(parts: list, runs: list, empty: bool = False) -> tuple[list[dict], float]:
    """Rows of runs, each (number, part, values), and what they took [s]."""
    begun = time.perf_counter()
    rows = []
    for number, part, values in runs:
        row = nothing(values) if empty else one(*parts[part], values)
        rows.append({"run": number, "part": part, **row})
    return rows, time.perf_counter() - begun
