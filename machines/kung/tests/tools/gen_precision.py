# SPDX-License-Identifier: Apache-2.0
"""Measure what the precision controller reaches and put it into docs/precision.md.

usage: scripts/tool gen-precision [--check | --grid] [--program FILE] [--jobs N]

Runs circle, window, star and part with the twin engine, on the first lap, in the conditions of the
tables between marks as "<!-- begin worth -->" in docs/precision.md, and writes these and
docs/pictures/precision.svg, the error on the circle beside that of fc and afc.
--check writes nothing: it says whether the page is what the program measures now, and whether all
of it is within the bars of the specification. --grid runs all combinations of path, payload,
friction, cogging, noise and seed (432 runs, some minutes) and holds them to the bars.

Exit codes: 0 ok, 1 stale or outside the bars, 2 usage, 3 the program is not built.
"""

import argparse
import csv
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import ROOT
from trammel_tools.picture import slim

PAGE = ROOT / "docs" / "precision.md"
PICTURE = ROOT / "docs" / "pictures" / "precision.svg"
GNUPLOT = """
set terminal svg size 800,420 dynamic enhanced font 'Helvetica,13' background '#ffffff'
set output 'precision.svg'
set logscale y
set yrange [0.02:200000]
set format y '%g'
set xlabel 't (ms)'
set ylabel 'distance from the command (um)'
set key outside top center horizontal
set grid y lc rgb '#dddddd'
set label 'a count of the encoder' at 20,7.5 tc rgb '#777777'
plot 5 with lines title '' lc rgb '#999999' dt 2, \\
     'fc.txt' every 8 with lines title 'fc' lc rgb '#bbbbbb' lw 5, \\
     'afc.txt' every 8 with lines title 'afc' lc rgb '#1f77b4' lw 1.5, \\
     'precision.txt' with lines title 'precision' lc rgb '#d62728' lw 1
"""
PATHS = ("circle", "window", "star", "part")
MEAN, MOST, PEAK = 2.0, 15.0, 4.5           # [um], [um], [A]: bars of every run
NEAR_MEAN, NEAR_MAX = 0.35, 5.0             # [um] of the specification's figures
FRICTION = {"x": 3.0, "y": 4.8}             # Coulomb [N] of the default table
VISCOUS = 20.0                              # [N s/m]
SENSORS = {True: 0.02, False: 0.0}          # [A] rms

# Payload [kg], share of the friction, cogging [N], noise of the sensors; the specification's mean
# and max of each path [um].
ROWS = [
    ((0, 1, 0, False), (0.62, 5.9), (1.71, 9.0), (0.80, 7.3), (1.34, 9.4)),
    ((0, 1.5, 3, True), (0.78, 7.5), (1.74, 8.8), (0.87, 8.0), (1.32, 8.7)),
    ((0, 0.5, 3, True), (1.22, 12.3), (1.74, 11.1), (1.62, 12.2), (1.85, 11.0)),
    ((11, 1, 0, False), (0.26, 3.1), (1.18, 4.5), (0.60, 3.6), (1.02, 3.1)),
    ((22.5, 1, 0, False), (0.19, 3.0), (1.08, 4.2), (0.36, 3.8), (0.82, 3.6)),
    ((22.5, 1.5, 3, True), (0.22, 3.6), (1.04, 3.5), (0.40, 4.2), (0.84, 3.9)),
]
# Path, payload, friction, cogging beyond the mean of 2.0 um, with either noise: one axis of the
# window stands, and a light one wanders within its count. None is a row of the specification.
OUTLIERS = {("window", 0, 0.5, 0)}
OUTLIER_MEAN = 2.3  # [um], of them; measured 2.13 to 2.19
PARTS = {
    "as specified": {},
    "no edge time": {"precision.subcount": "false"},
    "nothing estimated on the path": {"precision.adapt": "false"},
    "half the poles": {"precision.w1_rad_s": 150, "precision.w2_rad_s": 2000,
                       "precision.w3_rad_s": 200},
    "no identification move": {"precision.identify": "false"},
    "no identification move, nothing estimated": {"precision.identify": "false",
                                                  "precision.adapt": "false"},
}


def keys_of(payload, friction, cogging, noise, seed=1):
    keys = {"plant.payload_kg": payload, "plant.cogging_N": cogging,
            "plant.current_noise_A": SENSORS[noise], "plant.seed": seed}
    keys.update({f"plant.{axis}.coulomb_N": friction * newton for axis, newton in FRICTION.items()})
    keys["plant.viscous_N_s_m"] = friction * VISCOUS
    return keys


class Bench:
    def __init__(self, program, jobs):
        self.program = program
        self.pool = ThreadPoolExecutor(jobs)

    def run(self, path, keys, folder=None):
        """The figures of a run by their names; its files remain in folder/run."""
        if folder is None:
            with tempfile.TemporaryDirectory() as passing:
                return self.run(path, keys, Path(passing))
        out = folder / "run"
        given = {"controller": "precision", "precision.compare": "false", **keys}
        done = subprocess.run(
            [self.program, "run", path, "--engine", "twin", "--no-report", "-o", out,
             *itertools.chain.from_iterable(("-s", f"{k}={v}") for k, v in given.items())],
            capture_output=True, text=True, check=False, env={**os.environ, "PATH": "/nowhere"})
        if not (out / "metrics.json").is_file():
            raise SystemExit(f"gen-precision: {path}: {done.stderr.strip()}")
        metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
        figures = {f["id"]: f["value"] for f in metrics["figures"]}
        figures["end"] = done.returncode
        return figures

    def all(self, runs):
        """{(path, keys): figures} of [(path, keys)], in their order."""
        return list(self.pool.map(lambda one: self.run(*one), runs))


def outside(figures, payload):
    """What of a run is beyond the bars of every run."""
    if figures["end"] != 0 or "error_um.mean" not in figures:
        return ["did not follow"]
    found = []
    for name, bar in (("error_um.mean", MEAN), ("error_um.max", MOST), ("peak_current_A", PEAK)):
        if figures[name] > bar:
            found.append(f"{name} {figures[name]:.2f} above {bar}")
    for axis, own in (("x", 2.5), ("y", 8.0)):
        mass = own + payload
        off = abs(figures[f"{axis}.estimate.mass_kg"] - mass)
        if off > 0.12 + 0.01 * mass:
            found.append(f"{axis} mass {off:.3f} kg off")
    return found


def cell(figures):
    return f"{figures['error_um.mean']:.2f} / {figures['error_um.max']:.1f}"


def row_name(payload, friction, cogging, noise):
    parts = [f"{payload:g} kg", f"friction x{friction:g}"]
    if cogging:
        parts.append(f"cogging {cogging:g} N")
    if noise:
        parts.append("sensors 20 mA rms")
    return ", ".join(parts)


def first_lap(bench, wrong):
    runs = bench.all([(path, keys_of(*row)) for row, *_ in ROWS for path in PATHS])
    text = f"| mean / max (um) | {' | '.join(PATHS)} |\n|---|{'---|' * len(PATHS)}\n"
    for n, (row, *printed) in enumerate(ROWS):
        of_row = runs[n * len(PATHS):(n + 1) * len(PATHS)]
        for path, figures, (mean, most) in zip(PATHS, of_row, printed):
            where = f"{path}, {row_name(*row)}"
            wrong += [f"{where}: {one}" for one in outside(figures, row[0])]
            if path == "part":  # the specification's part is another one
                continue
            if abs(figures["error_um.mean"] - mean) > NEAR_MEAN:
                wrong.append(f"{where}: mean {figures['error_um.mean']:.2f}, specified {mean}")
            if abs(figures["error_um.max"] - most) > NEAR_MAX:
                wrong.append(f"{where}: max {figures['error_um.max']:.1f}, specified {most}")
        text += f"| {row_name(*row)} | {' | '.join(cell(one) for one in of_row)} |\n"
    return text


def worth(bench):
    paths, payloads = PATHS[:3], (0, 22.5)
    runs = bench.all([(path, {**keys_of(payload, 1.5, 3, True), **keys})
                      for keys in PARTS.values() for payload in payloads for path in paths])
    heads = [f"{path}, {payload:g} kg" for payload in payloads for path in paths]
    text = f"| mean / max (um) | {' | '.join(heads)} |\n|---|{'---|' * len(heads)}\n"
    for n, name in enumerate(PARTS):
        of_row = runs[n * len(heads):(n + 1) * len(heads)]
        text += f"| {name} | {' | '.join(cell(one) for one in of_row)} |\n"
    return text


def grid(bench):
    """Prints all of the grid; returns lines of what is beyond the bars.

    The rows of the specification are held to them with every seed; of the other combinations, what
    the page tells (OUTLIERS) may be beyond the mean.
    """
    rows = list(itertools.product((0, 11, 22.5), (0.5, 1, 1.5), (0, 3), (False, True), (1, 2, 3)))
    runs = [(path, row) for row in rows for path in PATHS]
    figures = bench.all([(path, keys_of(*row)) for path, row in runs])
    wrong, known = [], 0
    for (path, row), one in zip(runs, figures):
        for what in outside(one, row[0]):
            text = f"{path}, {row_name(*row[:4])}, seed {row[4]}: {what}"
            outlier = (path, *row[:3]) in OUTLIERS and one.get("error_um.mean", 99) <= OUTLIER_MEAN
            if outlier and what.startswith("error_um.mean"):
                known += 1
                print(f"known: {text}")
            else:
                wrong.append(text)
    for path in PATHS:
        own = [one for (of, _), one in zip(runs, figures) if of == path]
        print(f"{path}: worst mean {max(f['error_um.mean'] for f in own):.2f} um, "
              f"max {max(f['error_um.max'] for f in own):.1f} um of {len(own)} runs")
    print(f"precision: {len(runs)} runs, {len(wrong)} findings, {known} known outliers")
    return wrong


def picture(bench):
    """The distance from the command over time, of three controllers on the same feed profile."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("fc", "afc", "precision"):
            subprocess.run([bench.program, "run", "circle", "--engine", "twin", "--no-report",
                            "-s", f"controller={name}", "-s", "path.profile=feed",
                            "-s", "precision.compare=false", "-o", f"{folder}/{name}"],
                           stdout=subprocess.DEVNULL, check=True)
            metrics = json.loads(Path(folder, name, "metrics.json").read_text(encoding="utf-8"))
            first, last = metrics["run"]["first_tick"] + 8, metrics["run"]["end_tick"] - 12
            of = "model" if name == "precision" else "command"  # what the chip has as set point
            with (Path(folder) / "trace.csv").open("w", encoding="utf-8") as out, \
                    open(f"{folder}/{name}/trace.csv", encoding="utf-8") as lines:
                for line in csv.DictReader(lines):
                    if first <= int(line["tick"]) < last:
                        error = [float(line[f"{a}_{of}_m"]) - float(line[f"{a}_position_m"])
                                 for a in "xy"]
                        print((int(line["tick"]) - first) / 2, 1e6 * math.hypot(*error), file=out)
            (Path(folder) / "trace.csv").rename(Path(folder) / f"{name}.txt")
        subprocess.run(["gnuplot"], input=GNUPLOT, text=True, check=True, cwd=folder)
        drawn = (Path(folder) / "precision.svg").read_text(encoding="utf-8")
        PICTURE.write_text(slim(drawn), encoding="utf-8")


def with_tables(page, tables):
    for name, text in tables.items():
        begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
        head, rest = page.split(begin)
        page = head + begin + text + end + rest.split(end, 1)[1]
    return page


def arguments_of_runs(parser):
    """What is given, with the program and how many runs at once; None where it is not built."""
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.program.is_file():
        return arguments
    print(f"{parser.prog.split()[-1]}: {arguments.program} is not built", file=sys.stderr)
    return None


def main():
    parser = python_tools.Parser(prog="scripts/tool gen-precision", description=__doc__)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true")
    what.add_argument("--grid", action="store_true")
    arguments = arguments_of_runs(parser)
    if arguments is None:
        return 3
    bench = Bench(arguments.program.resolve(), arguments.jobs)
    if arguments.grid:
        wrong = grid(bench)
        for one in wrong:
            print(f"gen-precision: {one}", file=sys.stderr)
        return 1 if wrong else 0
    wrong = []
    page = PAGE.read_text(encoding="utf-8")
    made = with_tables(page, {"first lap": first_lap(bench, wrong), "worth": worth(bench)})
    for one in wrong:
        print(f"gen-precision: {one}", file=sys.stderr)
    if arguments.check and made != page:
        print("gen-precision: docs/precision.md is stale: scripts/tool gen-precision",
              file=sys.stderr)
    if not arguments.check:
        PAGE.write_text(made, encoding="utf-8")
        picture(bench)
    return 1 if wrong or (arguments.check and made != page) else 0


if __name__ == "__main__":
    sys.exit(main())
