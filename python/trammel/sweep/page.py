# SPDX-License-Identifier: Apache-2.0
"""page.html of a sweep: one self-contained file that shows its runs."""

from __future__ import annotations

import json
import math
import shlex
from pathlib import Path

import numpy as np
import pyarrow as pa

from trammel.sweep.files import replace
from trammel.sweep.store import FIXED

MOST = 20_000  # runs on a page: evenly taken where there are more
DIGITS = 6


def command(scenario: str, engine: str, keys: dict) -> str:
    """Repeats a run."""
    from trammel.run_settings import text_of

    words = ["./trammel", "run", scenario]
    for key, value in {"run.engine": engine, **keys}.items():
        words += ["-s", f"{key}={text_of(value)}"]
    return " ".join(shlex.quote(word) for word in words)


def _number(value):
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return None
    return float(f"{value:.{DIGITS}g}") if isinstance(value, float) else value


def data(plan, table: pa.Table) -> dict:
    """What the page is made of: numeric axes, words, and the command of each run."""
    if table.num_rows > MOST:
        table = table.take(np.linspace(0, table.num_rows - 1, MOST).astype(np.int64))
    axes, words = [], []
    names = [name for name in table.column_names if name not in FIXED]
    names += [name for name in ("wall_s",) if name in table.column_names]  # of runs that were made
    for name in names:
        values = table[name].to_pylist()
        if pa.types.is_floating(table[name].type) or pa.types.is_integer(table[name].type):
            axes.append({"name": name, "key": name in plan.varied,
                         "values": [_number(value) for value in values]})
        else:
            words.append({"name": name, "key": name in plan.varied, "values": values})
    runs = table["run"].to_pylist()
    commands = []
    for part, values in map(plan.run, runs):
        one = plan.parts[part]
        commands.append(command(one.scenario, one.engine, {**one.keys, **values}))
    return {"kind": "Sweep", "title": plan.file.stem, "what": "runs", "runs": runs,
            "axes": axes, "words": words, "end": table["end"].to_pylist(),
            "message": table["message"].to_pylist(), "commands": commands, "of": plan.count}


def trials_data(study, trials: list, best: set) -> dict:
    """The same of the trials of `trammel tune`, which ended."""
    ended = [t for t in trials if t.state.is_finished()]
    columns = [(key, True, [t.params.get(key) for t in ended]) for key in study.search]
    for n, goal in enumerate(study.objectives):
        columns.append((goal.name, False, [t.values[n] if t.values else None for t in ended]))
    for n, goal in enumerate(study.constraints):
        values = [t.user_attrs.get("constraints") for t in ended]
        columns.append((f"{goal.name} (limited)", False, [v[n] if v else None for v in values]))
    axes = []
    words = [{"name": "best", "values": ["best" if t.number in best else "" for t in ended]}]
    for name, key, values in columns:
        if all(isinstance(v, int | float | None) and not isinstance(v, bool) for v in values):
            axes.append({"name": name, "key": key, "values": [_number(v) for v in values]})
        else:
            words.append({"name": name, "key": key, "values": [str(v) for v in values]})
    scenario, case = study.cases[0]
    commands = [command(scenario, study.engine, {**study.keys, **case, **trial.params})
                for trial in ended]
    return {"kind": "Study", "title": study.file.stem, "what": "trials",
            "runs": [t.number for t in ended], "axes": axes, "words": words,
            "end": ["done" if t.values else "failed" for t in ended],
            "message": [t.user_attrs.get("message", "") for t in ended], "commands": commands,
            "of": len(trials)}


def write_trials(study, trials: list, best: set, file: Path) -> None:
    _write(trials_data(study, trials, best), file)


def write(plan, table: pa.Table, file: Path) -> None:
    _write(data(plan, table), file)


def _write(content: dict, file: Path) -> None:
    folder = Path(__file__).parent
    text = (folder / "page.html").read_text(encoding="utf-8")
    script = (folder / "page.js").read_text(encoding="utf-8")
    content = json.dumps(content, allow_nan=False).replace("<", "\\u003c")
    text = text.replace("@SCRIPT@", script).replace("@DATA@", content)
    replace(file, text.encode())
