# SPDX-License-Identifier: Apache-2.0
"""Whole scenarios with both engines, for trammel verify --engines: event for event the same run."""

import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "testbench" / "trammel"
CONTROLLERS = ("fc", "afc")
# Of metrics.json: what says how a run went and not how fast.
RUN = ("event_hash", "clocks", "samples", "points", "first_tick", "end_tick")


class EngineError(Exception):
    """The program is missing or a run did not end as it should."""


def scenarios():
    return sorted(p.stem for p in (ROOT / "testbench" / "scenarios").glob("*.toml"))


def run(scenario, controller, engine, folder):
    """(metrics, whole files of the run that must not depend on the engine)"""
    out = folder / f"{scenario}-{controller}-{engine}"
    done = subprocess.run([PROGRAM, "run", scenario, "--engine", engine, "--json", "--no-report",
                           "-s", f"controller={controller}", "-s", "run.platform=direct",
                           "-o", out], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise EngineError(f"{scenario} {controller} {engine}: exit {done.returncode}: "
                          f"{done.stderr.strip()}")
    return (json.loads((out / "metrics.json").read_text(encoding="utf-8")),
            {name: (out / name).read_bytes() for name in ("trace.csv", "detail.json")})


def differences(rtl, twin):
    """What differs between two runs, in words."""
    found = [f"{key} {rtl[0]['run'][key]} and {twin[0]['run'][key]}" for key in RUN
             if rtl[0]["run"][key] != twin[0]["run"][key]]
    if rtl[0]["end"] != twin[0]["end"]:
        found.append(f"end {rtl[0]['end']} and {twin[0]['end']}")
    for name, content in rtl[1].items():
        if twin[1][name] == content:
            continue
        lines = [part.split(b"\n") for part in (content, twin[1][name])]
        at = next((n for n, pair in enumerate(zip(*lines), 1) if pair[0] != pair[1]), "end")
        found.append(f"{name} from line {at} on")
    return found


def compare(names):
    """Prints a line a run; returns lines of what went wrong."""
    if not PROGRAM.exists():
        raise EngineError(f"{PROGRAM.relative_to(ROOT)} is missing: trammel list builds it")
    wrong = []
    print(f"{'scenario':<10} {'':<4} {'clocks':>11}  {'event hash':<16} {'RTL s':>7} {'twin s':>7} "
          f"{'ratio':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            for controller in CONTROLLERS:
                rtl, twin = (run(name, controller, engine, Path(folder))
                             for engine in ("rtl", "twin"))
                found = differences(rtl, twin)
                wrong += [f"{name} {controller}: RTL and twin differ: {what}" for what in found]
                seconds = [one[0]["run"]["wall_s"] for one in (rtl, twin)]
                print(f"{name:<10} {controller:<4} {rtl[0]['run']['clocks']:>11}  "
                      f"{'differs' if found else rtl[0]['run']['event_hash']:<16} "
                      f"{seconds[0]:>7.2f} {seconds[1]:>7.2f} {seconds[0] / seconds[1]:>6.1f}",
                      flush=True)
    return wrong
