#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measure the paper's eight experiments and put them into docs/deviations.md.

usage: gen_results.py [--check | --tables] [--program FILE]

Runs `trammel run --all` (about a minute), writes the figures to docs/results.json and the tables
between "<!-- begin results -->" and "<!-- end results -->" in docs/deviations.md. --check runs
nothing: it only says whether the tables are those of results.json; that the figures are those of
the chip is checked by the system tests, which simulate all eight anyway.

Exit codes: 0 ok, 1 stale, 2 usage, 3 the program is not built.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import gen_manual

ROOT = Path(__file__).resolve().parent.parent
FIGURES = ROOT / "docs" / "results.json"
PAGE = ROOT / "docs" / "deviations.md"
PATHS = ("circle", "window", "star")


def measure(program):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "run", "--all", "--json", "--out", folder],
                              capture_output=True, text=True, check=True, cwd=folder)
    figures = {}
    for run in json.loads(done.stdout):
        entry = {"figures": {}}
        for line in run["comparison"]:
            entry["figures"][line["what"]] = {key: round(line[key], 5) for key in ("ours", "paper")
                                              if key in line}
        for axis in "xy":
            if "periods" in run[axis]:
                entry[f"overshoot_percent_{axis}"] = [round(p["overshoot_percent"], 2)
                                                      for p in run[axis]["periods"]]
        figures[run["scenario"]] = entry
    return figures


def tables(results):
    def figure(run, what):
        return results[run]["figures"][what]

    text = "Tracking error in mm, ours / paper:\n\n"
    text += "| | circle | window | star |\n|---|---|---|---|\n"
    for controller in ("fc", "afc"):
        for what, unit in (("mean", ""), ("variance", ", mm2"), ("standard deviation", "")):
            text += f"| {controller.upper()} {what}{unit} |"
            for path in PATHS:
                one = figure(f"{path}-{controller}", what)
                paper = f" / {one['paper']:.2f}" if "paper" in one else ""
                text += f" {one['ours']:.2f}{paper} |"
            text += "\n"
    for what in ("mean", "variance"):
        text += f"| AFC less {what} |"
        for path in PATHS:
            fc, afc = figure(f"{path}-fc", what), figure(f"{path}-afc", what)
            ours, paper = (100 * (1 - afc[key] / fc[key]) for key in ("ours", "paper"))
            text += f" {ours:.1f} / {paper:.1f} % |"
        text += "\n"
    text += "\nThe paper has one spread for both: its formula is a root, its label says variance.\n"
    text += "\nStep of 10 mm with 11 kg, overshoot in % of periods 1 to 8:\n\n"
    text += f"| | {' | '.join(map(str, range(1, 9)))} | paper, period 1 |\n"
    text += f"|---|{'---|' * 9}\n"
    for controller in ("fc", "afc"):
        for axis in "XY":
            run = f"step-{controller}"
            periods = results[run][f"overshoot_percent_{axis.lower()}"]
            paper = figure(run, f"overshoot {axis}, first period").get("paper", "-")
            text += (f"| {controller.upper()} {axis} | {' | '.join(f'{p:.1f}' for p in periods)} "
                     f"| {paper} |\n")
    fc, afc = (figure(f"step-{name}", "peak current")["ours"] for name in ("fc", "afc"))
    return f"{text}\nPeak current in it, the larger of both axes: FC {fc:.2f} A, AFC {afc:.2f} A.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--tables", action="store_true", help="from results.json, without a run")
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel")
    arguments = parser.parse_args()
    if not (arguments.check or arguments.tables):
        if not arguments.program.exists():
            print(f"gen_results: {arguments.program}: not built", file=sys.stderr)
            return 3
        figures = measure(arguments.program.resolve())
        FIGURES.write_text(json.dumps(figures, indent=1) + "\n", encoding="ascii")
        print(FIGURES.relative_to(ROOT))
    page = PAGE.read_text(encoding="utf-8")
    text = gen_manual.replaced(page, "results", tables(json.loads(FIGURES.read_text())))
    if text == page:
        return 0
    if arguments.check:
        print("docs/deviations.md is stale: scripts/gen_results.py", file=sys.stderr)
        return 1
    PAGE.write_text(text, encoding="ascii")
    print(PAGE.relative_to(ROOT))
    return 0


if __name__ == "__main__":
    sys.exit(main())
