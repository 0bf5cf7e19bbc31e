# SPDX-License-Identifier: Apache-2.0
"""Measure the paper's eight experiments and put them into docs/deviations.md and docs/table2.md.

usage: scripts/tool gen-results [--check | --tables] [--program FILE]

Runs `trammel run --all` (about a minute) and a circle of four laps, writes the figures to
docs/results.json and the tables between marks as "<!-- begin results -->" in both pages.
--check runs nothing: it only says whether the tables are those of results.json, and the targets of
examples/table2.toml those that are printed; that the figures
are those of the chip is checked by the system tests, which simulate all of it anyway.

Exit codes: 0 ok, 1 stale, 2 usage, 3 the program is not built.
"""

import json
import math
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.generate import gen_manual
from trammel_tools.paths import ROOT

FIGURES = ROOT / "docs" / "results.json"
PAGE = ROOT / "docs" / "deviations.md"
READINGS = ROOT / "docs" / "table2.md"
STUDY = ROOT / "examples" / "table2.toml"
FITTED = "paper-"  # of the scenarios by the reading of that page
RATES = {"": (0.1, 0.2, 0.3), FITTED: (0.066, 0.132, 0.198)}  # once, twice, three times
WITHIN = {"mean": 0.05, "variance": 0.15}  # of what is printed: a distance of 1
POINTS = 0.8  # of an overshoot
PATHS = ("circle", "window", "star")
SPREADS = {"mean": "tracking.model.mean_mm", "variance": "tracking.model.variance_mm2",
           "standard deviation": "tracking.model.std_mm"}
PEAK = "peak_current_A"
CONTOUR = "contour.mean_mm"
BASELINES = {"P-PI": "baseline.cascade", "PID": "baseline.pid"}
LAPS = 4
OF_LAP = ("model.mean_mm", "model.variance_mm2", "contour.mean_mm")


def figures_of(program, scenario, *assignments):
    """Figures of a run with the twin."""
    words = [word for text in assignments for word in ("-s", text)]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "run"
        subprocess.run([program, "run", scenario, "--engine", "twin", "--no-report", "-o", out,
                        *words], stdout=subprocess.DEVNULL, check=True)
        metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
    return {figure["id"]: round(figure["value"], 5) for figure in metrics["figures"]}


def measure_laps(program, controller):
    """The figures of each lap of the circle."""
    values = figures_of(program, "circle", f"controller={controller}", f"path.repeats={LAPS}")
    return [[values[f"laps.{lap}.{name}"] for name in OF_LAP] for lap in range(LAPS)]


def measure_rate(program, prefix, rate, results):
    """With that learning rate: how far AFC is from Table 2, and its overshoots of three periods."""
    asked = ("controller=afc", f"gains.learning_rate={rate}")
    squares = []
    for path in PATHS:
        values = figures_of(program, prefix + path, *asked)
        for what, within in WITHIN.items():
            name = SPREADS[what]
            printed = results[f"{path}-afc"]["figures"][name]["paper"]
            squares.append(((values[name] / printed - 1) / within) ** 2)
    step = figures_of(program, prefix + "step", *asked, "path.square_periods=3",
                      "run.reached_m=0.05")  # more than a quarter of the step
    return {"distance": round(math.sqrt(sum(squares) / len(squares)), 3),
            "overshoot_percent": [[round(step[f"{axis}.periods.{n}.overshoot_percent"], 2)
                                   for n in range(3)] for axis in "xy"]}


def written(value, indent=""):
    """JSON with a line for each figure."""
    if not isinstance(value, dict) or not any(isinstance(one, dict) for one in value.values()):
        return json.dumps(value)
    lines = [f'{indent} "{key}": {written(one, indent + " ")}' for key, one in value.items()]
    return "{\n" + ",\n".join(lines) + f"\n{indent}}}"


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
        if baseline:  # of the defaults, the same whichever rules it stands beside
            figures.setdefault("baseline", {})[run["options"]["path.kind"]] = baseline
    figures["laps"] = {name: measure_laps(program, name) for name in ("fc", "afc")}
    figures["rates"] = {prefix + "afc": {str(rate): measure_rate(program, prefix, rate, figures)
                                         for rate in rates} for prefix, rates in RATES.items()}
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


def readings_table(results):
    """Both readings beside what is printed, and how far each is from it, in tolerances."""
    text = "| | printed | defaults | off | `paper-*` | off |\n|---|---|---|---|---|---|\n"
    squares = {"": [], FITTED: []}

    def row(label, run, name, share=None):
        printed = results[run]["figures"][name]["paper"]
        cells = []
        for prefix, all_of in squares.items():
            ours = results[prefix + run]["figures"][name]["ours"]
            off = 100 * (ours / printed - 1) if share else ours - printed
            all_of.append((off / (share or POINTS)) ** 2)
            cells.append(f"{ours:.2f} | {off:+.1f} {'%' if share else 'points'}")
        return f"| {label} | {printed:.2f} | {' | '.join(cells)} |\n"

    for what, unit in (("mean", "mm"), ("variance", "mm2")):
        for path in PATHS:
            for name in ("fc", "afc"):
                text += row(f"{path}, {name.upper()} {what}, {unit}", f"{path}-{name}",
                            SPREADS[what], 100 * WITHIN[what])
    for axis in "xy":
        text += row(f"step, FC {axis.upper()} overshoot, %", "step-fc",
                    f"{axis}.periods.0.overshoot_percent")
    cost = [math.sqrt(sum(of) / len(of)) for of in squares.values()]
    text += f"| distance, rms | 0 | {cost[0]:.2f} | | {cost[1]:.2f} | |\n"
    for what in ("mean", "variance"):
        for path in PATHS:
            cells = []
            for prefix, key in (("", "paper"), ("", "ours"), (FITTED, "ours")):
                fc, afc = (results[f"{prefix}{path}-{name}"]["figures"][SPREADS[what]][key]
                           for name in ("fc", "afc"))
                cells.append(f"{100 * (1 - afc / fc):.1f} %")
            text += f"| {path}, reduction of {what} | {' | '.join(cells[:2])} | | {cells[2]} | |\n"
    return text


def learning_table(results):
    text = f"| | {' | '.join(map(str, range(1, 9)))} |\n|---|{'---|' * 8}\n"
    for prefix, label in (("", "defaults"), (FITTED, "`paper-*`")):
        for name in ("fc", "afc"):
            for axis in "XY":
                periods = results[f"{prefix}step-{name}"][f"overshoot_percent_{axis.lower()}"]
                text += (f"| {label}, {name.upper()} {axis} | "
                         f"{' | '.join(f'{p:.1f}' for p in periods)} |\n")
    return text


def rates_table(rates):
    text = ("| | learning rate | AFC from Table 2 | X, periods 1 to 3 | Y, periods 1 to 3 |\n"
            "|---|---|---|---|---|\n")
    for prefix, label in (("", "defaults"), (FITTED, "`paper-*`")):
        for rate, one in rates[prefix + "afc"].items():
            cells = [", ".join(f"{p:.1f}" for p in axis) for axis in one["overshoot_percent"]]
            text += f"| {label} | {rate} | {one['distance']:.2f} | {' | '.join(cells)} |\n"
    return text


def pages(results):
    """(file, its text now, its text with the tables)."""
    for file, blocks in ((PAGE, {"results": tables(results), "laps": laps_table(results["laps"]),
                                 "baseline": baseline_table(results)}),
                         (READINGS, {"readings": readings_table(results),
                                     "learning": learning_table(results),
                                     "rates": rates_table(results["rates"])})):
        before = text = file.read_text(encoding="utf-8")
        for name, block in blocks.items():
            text = gen_manual.replaced(text, name, block)
        yield file, before, text


def wrong_targets(results):
    """Targets of the study that are not what the paper prints, or not as near as the table asks."""
    study = tomllib.loads(STUDY.read_text(encoding="utf-8"))
    for one in study["objective"][0]["targets"]:
        run = f"{one['scenario'].removeprefix(FITTED)}-{one['controller']}"
        what = next((what for what, name in SPREADS.items() if name == one["figure"]), None)
        printed = results[run]["figures"][one["figure"]]["paper"]
        within = printed * WITHIN[what] if what else POINTS
        if one["value"] != printed or not math.isclose(one["within"], within):
            yield f"{one['figure']} of {run}: expects {printed} within {within:.6g}"


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
        FIGURES.write_text(written(figures) + "\n", encoding="ascii")
        print(FIGURES.relative_to(ROOT))
    results = json.loads(FIGURES.read_text())
    stale = 0
    for text in wrong_targets(results):
        print(f"{STUDY.relative_to(ROOT)}: {text}", file=sys.stderr)
        stale = 1
    for file, before, text in pages(results):
        if text == before:
            continue
        name = file.relative_to(ROOT)
        if arguments.check:
            print(f"{name} is stale: scripts/tool gen-results", file=sys.stderr)
            stale = 1
            continue
        file.write_text(text, encoding="ascii")
        print(name)
    return stale
