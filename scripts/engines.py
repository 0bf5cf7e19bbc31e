# SPDX-License-Identifier: Apache-2.0
"""Whole scenarios with both engines, for trammel verify --engines: event for event the same run."""

import json
import subprocess
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "testbench" / "trammel"
SCENARIOS = ROOT / "testbench" / "scenarios"
CONTROLLERS = ("fc", "afc")
# Of metrics.json: what says how a run was made and how fast, and not how it went.
MADE = ("command", "versions", "options")
FAST = ("clocks_evaluated", "wakes", "wall_s", "clocks_per_s", "real_time_factor")


class EngineError(Exception):
    """The program is missing or a run did not end as it should."""


def scenarios():
    return sorted(p.stem for p in SCENARIOS.glob("*.toml"))


def variants(scenario):
    """Controllers that a scenario is run with; "" for a machine that has one."""
    text = (SCENARIOS / f"{scenario}.toml").read_text(encoding="utf-8")
    return CONTROLLERS if tomllib.loads(text).get("machine", "kung") == "kung" else ("",)


def flat(name, value):
    """(name, value) of each leaf of nested tables and lists."""
    if isinstance(value, dict):
        items = [(f"{name}.{key}", one) for key, one in value.items()]
    elif isinstance(value, list):
        items = [(f"{name}[{n}]", one) for n, one in enumerate(value)]
    else:
        return [(name, value)]
    return [leaf for item in items for leaf in flat(*item)]


def run(scenario, controller, engine, folder):
    """(seconds, figures, whole files) of a run; figures and files must not depend on the engine."""
    out = folder / f"{scenario}-{controller}-{engine}"
    done = subprocess.run([PROGRAM, "run", scenario, "--engine", engine, "--json", "--no-report",
                           *(("-s", f"controller={controller}") if controller else ()),
                           "-s", "run.platform=direct", "-o", out],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise EngineError(f"{scenario} {controller} {engine}: exit {done.returncode}: "
                          f"{done.stderr.strip()}")
    metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
    seconds = metrics["run"]["wall_s"]
    metrics["run"] = {key: one for key, one in metrics["run"].items() if key not in FAST}
    figures = dict(leaf for key, one in metrics.items() if key not in MADE
                   for leaf in flat(key, one))
    return seconds, figures, {path.name: path.read_bytes() for path in out.iterdir()
                              if path.name not in ("metrics.json", "run.toml")}


def differences(rtl, twin):
    """What differs between two runs, in words."""
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
    print(f"{'scenario':<17} {'':<4} {'clocks':>11}  {'event hash':<16} {'RTL s':>7} {'twin s':>7} "
          f"{'ratio':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for name, controller in ((n, c) for n in names for c in variants(n)):
            rtl, twin = (run(name, controller, engine, Path(folder)) for engine in ("rtl", "twin"))
            found = differences(rtl, twin)
            wrong += [f"{name} {controller}: RTL and twin differ: {what}" for what in found]
            print(f"{name:<17} {controller:<4} {rtl[1]['run.clocks']:>11}  "
                  f"{'differs' if found else rtl[1]['run.event_hash']:<16} "
                  f"{rtl[0]:>7.2f} {twin[0]:>7.2f} {rtl[0] / twin[0]:>6.1f}", flush=True)
    return wrong
