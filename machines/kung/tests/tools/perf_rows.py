# SPDX-License-Identifier: Apache-2.0
"""Runs one row of trammel perf in its own process: rows that are programs of this build."""

import json
import subprocess
from dataclasses import dataclass

from trammel_tools.paths import ROOT

BUILD = ROOT / "build"
FOLDER = BUILD / "tests" / "kung" / "perf"
TESTS = ROOT / "machines" / "kung" / "tests" / "perf"
OUT = BUILD / "perf"
TARGETS = {"perf_sc_clock": ("a",), "perf_rows": ("b", "c", "w", "d", "e")}
PREFIX_S = 0.001  # what the replaying rows see
REPLAYED = ("f", "g")

# Row: name, program, its arguments.
NAMES = {"a": "--sc model, sc_clock, pins are signals",
         "b": "--cc model, activated once a clock",
         "c": "look-ahead, every clock evaluated",
         "w": "look-ahead, leaping, all clock domains",
         "d": "look-ahead, leaping, domains that are awake",
         "e": "twin engine, no RTL",
         "f": "Icarus Verilog, inputs replayed",
         "g": "cocotb on Verilator, inputs replayed"}
COMMANDS = {"a": ["perf_sc_clock", "sc"],
            "b": ["perf_rows", "clocked"],
            "c": ["perf_rows", "look_ahead", "run.leap=false"],
            "w": ["perf_rows", "look_ahead", "run.domains=false"],
            "d": ["perf_rows", "look_ahead"],
            "e": ["perf_rows", "look_ahead", "run.engine=twin"]}


class NotHere(Exception):
    """Why a row has no figures: what it needs is not built or not installed."""


class Failed(Exception):
    """A row that should run did not."""


@dataclass
class Measured:
    clocks: int
    evaluated: int
    event_hash: str
    cpu_s: float
    wall_s: float
    peak_kib: int
    record_kib: int = 0


def targets(rows):
    """What is to be built; the replaying rows need pins that row a recorded."""
    wanted = set(rows) | ({"a"} if set(rows) & set(REPLAYED) else set())
    return [target for target, serves in TARGETS.items() if wanted & set(serves)]


def build(rows):
    command = ["cmake", "--build", str(BUILD), "--target", *targets(rows)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"the build of {', '.join(targets(rows))} failed:\n"
                     f"{(done.stdout + done.stderr)[-4000:]}")


def run_program(name, *arguments):
    command = [str(FOLDER / name), *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode == 2 and "run.engine" in done.stderr:
        raise NotHere("not built")
    if done.returncode != 0:
        raise Failed(f"{name}: exit code {done.returncode}: {done.stderr.strip()[-500:]}")
    return Measured(**json.loads(done.stdout))


def run_row(row, seconds, *more):
    program, *arguments = COMMANDS[row]
    return run_program(program, *arguments, f"run.max_s={seconds}", *more)
