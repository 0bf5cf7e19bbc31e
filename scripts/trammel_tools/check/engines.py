# SPDX-License-Identifier: Apache-2.0
"""Whole scenarios with both engines, for trammel verify --engines: event for event the same run."""

import json
import subprocess
import tempfile
from pathlib import Path

from trammel_tools import machines
from trammel_tools.paths import ROOT

PROGRAM = ROOT / "build" / "testbench" / "trammel"
# Of metrics.json: how a run was made and how fast it was, not what it gave.
MADE = ("command", "versions", "options")
FAST = ("clocks_evaluated", "activity", "wakes", "wall_s", "clocks_per_s", "real_time_factor")


class EngineError(Exception):
    """The program is missing or a run did not end as it should."""


def scenarios(short=False):
    """All of them, or, of each machine, those of its tests/runs.toml."""
    every = machines.scenarios()
    if not short:
        return sorted(every)
    return [name for machine in machines.folders()
            for name in machines.runs(machine).get("engines", {}).get("short", [])]


def variants(machine):
    """Assignments that each scenario of a machine is run with; "" is none."""
    return machines.runs(machine).get("engines", {}).get("variants", [""])


def with_twin(names):
    """(scenario, its machine) of those whose machine has a twin."""
    twins = {entry["name"] for entry in machines.described(PROGRAM) if entry["twin"]}
    every = machines.scenarios()
    return [(name, every[name]) for name in names if every[name] in twins]


def flat(name, value):
    """(name, value) of each leaf of nested tables and lists."""
    if isinstance(value, dict):
        items = [(f"{name}.{key}", one) for key, one in value.items()]
    elif isinstance(value, list):
        items = [(f"{name}[{n}]", one) for n, one in enumerate(value)]
    else:
        return [(name, value)]
    return [leaf for item in items for leaf in flat(*item)]


def run(scenario, variant, engine, folder, platform="direct", code=0):
    """(seconds, figures, whole files) of a run; figures and files must not depend on the engine."""
    out = folder / f"{scenario}-{variant}-{engine}-{platform}"
    done = subprocess.run([PROGRAM, "run", scenario, "--engine", engine, "--json", "--no-report",
                           *(("-s", variant) if variant else ()),
                           "--platform", platform, "-o", out],
                          capture_output=True, text=True, check=False)
    if done.returncode != code:
        raise EngineError(f"{scenario} {variant} {engine}: exit {done.returncode}: "
                          f"{done.stderr.strip()}")
    metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
    seconds = metrics["run"]["wall_s"]
    metrics["run"] = {key: one for key, one in metrics["run"].items() if key not in FAST}
    figures = dict(leaf for key, one in metrics.items() if key not in MADE
                   for leaf in flat(key, one))
    return seconds, figures, {path.name: path.read_bytes() for path in out.iterdir()
                              if path.name not in ("metrics.json", "run.toml", "run.json")}


def differences(rtl, twin):
    """What differs between two runs, in words; `rtl` and `twin` as run() gives them."""
    found = [f"{key} {rtl[1].get(key)} and {twin[1].get(key)}"
             for key in dict.fromkeys((*rtl[1], *twin[1])) if rtl[1].get(key) != twin[1].get(key)]
    for name in sorted({*rtl[2], *twin[2]}):
        contents = [run[2].get(name, b"") for run in (rtl, twin)]
        if contents[0] == contents[1]:
            continue
        lines = [content.split(b"\n") for content in contents]
        at = next((n for n, pair in enumerate(zip(*lines), 1) if pair[0] != pair[1]), "end")
        found.append(f"{name} from line {at} on")
    return found


def compare(names):
    """Prints a line a run; returns lines of what went wrong."""
    if not PROGRAM.exists():
        raise EngineError(f"{PROGRAM.relative_to(ROOT)} is missing: trammel list builds it")
    wrong = []
    print(f"{'scenario':<17} {'':<14} {'clocks':>11}  {'event hash':<16} {'RTL s':>7} "
          f"{'twin s':>7} {'ratio':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for name, variant in ((n, v) for n, m in with_twin(names) for v in variants(m)):
            rtl, twin = (run(name, variant, engine, Path(folder)) for engine in ("rtl", "twin"))
            found = differences(rtl, twin)
            wrong += [f"{name} {variant}: RTL and twin differ: {what}" for what in found]
            print(f"{name:<17} {variant:<14} {rtl[1]['run.clocks']:>11}  "
                  f"{'differs' if found else rtl[1]['run.event_hash']:<16} "
                  f"{rtl[0]:>7.2f} {twin[0]:>7.2f} {rtl[0] / twin[0]:>6.1f}", flush=True)
    return wrong
