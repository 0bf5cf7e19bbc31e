# SPDX-License-Identifier: Apache-2.0
"""Measure the paper's eight experiments and put them into docs/deviations.md.

usage: scripts/tool gen-results [--check | --tables] [--program FILE]

Runs `trammel run --all` (about a minute) and a circle of four laps, writes the figures to
docs/results.json and the tables between marks as "<!-- begin results -->" in docs/deviations.md.
--check runs nothing: it only says whether the tables are those of results.json; that the figures
are those of the chip is checked by the system tests, which simulate all of it anyway.

Exit codes: 0 ok, 1 stale, 2 usage, 3 the program is not built.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.generate import gen_manual
from trammel_tools.paths import ROOT

FIGURES = ROOT / "docs" / "results.json"
PAGE = ROOT / "docs" / "deviations.md"
PATHS = ("circle", "window", "star")
SPREADS = {"mean": "tracking.model.mean_mm", "variance": "tracking.model.variance_mm2",
           "standard deviation": "tracking.model.std_mm"}
PEAK = "peak_current_A"
CONTOUR = "contour.mean_mm"
BASELINES = {"P-PI": "baseline.cascade", "PID": "baseline.pid"}
LAPS = 4
OF_LAP = ("model.mean_mm", "model.variance_mm2", "contour.mean_mm")


def measure_laps(program, controller):
    """The figures of each lap of the circle."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "circle"
        subprocess.run([program, "run", "circle", "--engine", "twin", "--no-report", "-o", out,
                        "-s", f"controller={controller}", "-s", f"path.repeats={LAPS}"],
                       stdout=subprocess.DEVNULL, check=True)
        metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
    values = {figure["id"]: round(figure["value"], 5) for figure in metrics["figures"]}
    return [[values[f"laps.{lap}.{name}"] for name in OF_LAP] for lap in range(LAPS)]


def measure(program):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "run", "--all", "--json", "--out", folder],
                              capture_output=True, text=True, check=True, cwd=folder)
    figures = {}
    for run in json.loads(done.stdout):
        if run["options"]["controller"] == "precision":  # docs/precision.md has its figures
            continue
        entry = {"figures": {}}
        for figure in run["figures"]:
            peak_of_steps = figure["id"] == PEAK and "periods" in run["x"]
            if ("expected" in figure or "printed" in figure or peak_of_steps
                    or figure["id"] == CONTOUR):
                line = {"ours": round(figure["value"], 5)}
                if "printed" in figure:
                    line["paper"] = figure["printed"]
                entry["figures"][figure["id"]] = line
        for axis in "xy":
            if "periods" in run[axis]:
                entry[f"overshoot_percent_{axis}"] = [round(p["overshoot_percent"], 2)
                                                      for p in run[axis]["periods"]]
        figures[run["scenario"]] = entry
        baseline = {figure["id"]: round(figure["value"], 5) for figure in run["figures"]
                    if figure["id"].startswith("baseline.")}
        if baseline:  # the same whichever rules it stands beside
            figures.setdefault("baseline", {})[run["options"]["path.kind"]] = baseline
    figures["laps"] = {name: measure_laps(program, name) for name in ("fc", "afc")}
    return figures


def baseline_table(results):
    text = "| |" + "".join(f" {path} mean | variance | contour |" for path in PATHS)
    text += f"\n|---|{'---|' * 9}\n"

    def row(name, cells):
        return f"| {name} | " + " | ".join("-" if cell is None else f"{cell:.2f}"
                                           for cell in cells) + " |\n"

    for name in ("fc", "afc"):
        rows = [results[f"{path}-{name}"]["figures"] for path in PATHS]
        text += row(f"{name.upper()}, paper", [
            cell for one in rows for cell in (one[SPREADS["mean"]]["paper"],
                                              one[SPREADS["variance"]]["paper"], None)])
        text += row(name.upper(), [
            one[key]["ours"] for one in rows for key in (SPREADS["mean"], SPREADS["variance"],
                                                         CONTOUR)])
    for name, key in BASELINES.items():
        text += row(name, [results["baseline"][path][f"{key}.{what}"] for path in PATHS
                           for what in OF_LAP])
    return text


def laps_table(laps):
    text = "| lap | FC mean | variance, mm2 | contour | AFC mean | variance, mm2 | contour |\n"
    text += f"|---|{'---|' * 6}\n"
    for lap in range(LAPS):
        cells = [cell for name in ("fc", "afc") for cell in (
            f"{laps[name][lap][0]:.3f}", f"{laps[name][lap][1]:.4f}", f"{laps[name][lap][2]:.3f}")]
        text += f"| {lap + 1} | {' | '.join(cells)} |\n"
    return text


def tables(results):
    def figure(run, name):
        return results[run]["figures"][name]

    text = "Tracking error in mm, ours / paper:\n\n"
    text += "| | circle | window | star |\n|---|---|---|---|\n"
    for controller in ("fc", "afc"):
        for what, unit in (("mean", ""), ("variance", ", mm2"), ("standard deviation", "")):
            text += f"| {controller.upper()} {what}{unit} |"
            for path in PATHS:
                one = figure(f"{path}-{controller}", SPREADS[what])
                paper = f" / {one['paper']:.2f}" if "paper" in one else ""
                text += f" {one['ours']:.2f}{paper} |"
            text += "\n"
    for what in ("mean", "variance"):
        text += f"| reduction of {what} |"
        for path in PATHS:
            fc, afc = (figure(f"{path}-{name}", SPREADS[what]) for name in ("fc", "afc"))
            ours, paper = (100 * (1 - afc[key] / fc[key]) for key in ("ours", "paper"))
            text += f" {ours:.1f} / {paper:.1f} % |"
        text += "\n"
    text += "\nThe paper gives one spread: its formula is a square root, its label says variance.\n"
    text += "\nStep of 10 mm with 11 kg, overshoot in % of periods 1 to 8:\n\n"
    text += f"| | {' | '.join(map(str, range(1, 9)))} | paper, period 1 |\n"
    text += f"|---|{'---|' * 9}\n"
    for controller in ("fc", "afc"):
        for axis in "XY":
            run = f"step-{controller}"
            periods = results[run][f"overshoot_percent_{axis.lower()}"]
            first = figure(run, f"{axis.lower()}.periods.0.overshoot_percent")
            paper = first.get("paper", "-")
            text += (f"| {controller.upper()} {axis} | {' | '.join(f'{p:.1f}' for p in periods)} "
                     f"| {paper} |\n")
    fc, afc = (figure(f"step-{name}", PEAK)["ours"] for name in ("fc", "afc"))
    return f"{text}\nPeak current in it, the larger of both axes: FC {fc:.2f} A, AFC {afc:.2f} A.\n"


def main():
    parser = python_tools.Parser(prog="scripts/tool gen-results", description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--tables", action="store_true", help="from results.json, without a run")
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel")
    arguments = parser.parse_args()
    if not (arguments.check or arguments.tables):
        if not arguments.program.exists():
            print(f"gen-results: {arguments.program}: not built", file=sys.stderr)
            return 3
        figures = measure(arguments.program.resolve())
        FIGURES.write_text(json.dumps(figures, indent=1) + "\n", encoding="ascii")
        print(FIGURES.relative_to(ROOT))
    page = PAGE.read_text(encoding="utf-8")
    results = json.loads(FIGURES.read_text())
    text = gen_manual.replaced(page, "results", tables(results))
    text = gen_manual.replaced(text, "laps", laps_table(results["laps"]))
    text = gen_manual.replaced(text, "baseline", baseline_table(results))
    if text == page:
        return 0
    if arguments.check:
        print("docs/deviations.md is stale: scripts/tool gen-results", file=sys.stderr)
        return 1
    PAGE.write_text(text, encoding="ascii")
    print(PAGE.relative_to(ROOT))
    return 0
