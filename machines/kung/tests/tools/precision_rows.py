# SPDX-License-Identifier: Apache-2.0
"""Hold the precision controller to the rows of its specification that are no plain first lap.

usage: scripts/tool precision-rows [NAME ...] [--program FILE] [--jobs N]

Runs each row of the table "Other" of the specification's section 11 with the twin engine and prints
what is measured beside the bar: loads, resonances, corners that are passed, laps, pushes, a step, a
table at rest. NAME picks rows by a part of their names.

Exit codes: 0 ok, 1 beyond a bar, 2 usage, 3 the program is not built.
"""

import csv
import itertools
import math
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import gen_precision
import precision_step
from trammel_tools import python_tools

SHAPES = gen_precision.PATHS[:3]
WORST = gen_precision.keys_of(0, 1.5, 3, True)  # light, with friction, cogging and noise
# With 1 mA of noise: how an axis stands within its count is one draw without it.
HARMONIC = {"plant.cogging_harmonic": 6, "plant.cogging_harmonic_N": 2,
            "plant.current_noise_A": 0.001}
LEARN = {"precision.learn": "true"}
SETTLE = 0.4  # [s] at rest before a push


@dataclass
class Check:
    """One row: what is measured, and the largest that is permitted."""
    name: str
    measured: float
    bar: float
    unit: str = "um"
    why: str = ""  # where the bar is not the specification's

    @property
    def holds(self):
        return self.measured <= self.bar

    def __str__(self):
        return (f"{'ok' if self.holds else 'BEYOND':<7}{self.name}: {self.measured:.3g} {self.unit}"
                f" of {self.bar:.3g}{'; ' + self.why if self.why else ''}")


class Failed(Exception):
    """A run that did not reach its end."""


def record(program, path, keys, table="trace.csv"):
    """(figures by name, rows of a table as numbers) of a run that ends as it should."""
    with tempfile.TemporaryDirectory() as folder:
        bench = gen_precision.Bench(program, 1)
        figures = bench.run(path, keys, Path(folder))
        with (Path(folder) / "run" / table).open(encoding="utf-8") as lines:
            rows = [{k: float(v) if v else math.nan for k, v in row.items()}
                    for row in csv.DictReader(lines)]
    return figures, rows


def followed(name, mean, most, path, keys, why=("", "")):
    """A row that is a path with bars of mean and largest error."""
    def measure(program):
        figures, _ = record(program, path, {**keys, "run.reached_m": 1})  # the bars are below
        if figures["end"] != 0:
            raise Failed(f"{name}, {path}: exit {figures['end']}")
        return [Check(f"{name}, {path}, mean", figures["error_um.mean"], mean, why=why[0]),
                Check(f"{name}, {path}, max", figures["error_um.max"], most, why=why[1])]
    return name, measure


def laps(name, path, keys, bar):
    """Five laps, of which bar() is told the errors; it returns (value, its bar)."""
    def measure(program):
        figures, _ = record(program, path, {**keys, "path.repeats": 5})
        return [Check(f"{name}, {path}", *bar([figures[f"lap_error_um.{n}"] for n in range(5)]))]
    return name, measure


def still(payload, more, settle):
    """Keys of a short move and then of rest."""
    return {"plant.payload_kg": payload, "path.kind": "line", "path.line_start_x_m": 0.25,
            "path.line_start_y_m": 0.25, "path.line_end_x_m": 0.26, "path.line_end_y_m": 0.26,
            "run.settle_s": settle, **more}


def at_rest(rows, begin):
    """(time from begin [s], X beside its last command [um]) of the samples from a time on."""
    end = rows[-1]["x_command_m"]
    return [(row["t_s"] - begin, 1e6 * (row["x_position_m"] - end)) for row in rows
            if row["t_s"] >= begin]


def settled(samples, band):
    """The time from which on all samples are within a band [s]."""
    return max((t for t, x in samples if abs(x) > band), default=0.0)


def push(payload, force, peak, back):
    """A force for 0.1 s on X at rest, after which it comes back within 10 um."""
    name = f"{force} N for 0.1 s, {payload + 2.5:g} kg"

    def measure(program):
        begin = 0.5 + SETTLE  # behind the move before the path, and the line
        keys = still(payload, {"plant.x.load_N": force, "plant.x.load_begin_s": begin,
                               "plant.x.load_end_s": begin + 0.1, "run.reached_m": 1,
                               "run.diverged_m": 1}, 1.5)
        _, rows = record(program, "circle", keys)
        far = max(abs(x) for _, x in at_rest(rows, begin))
        after = settled(at_rest(rows, begin + 0.1), 10)
        checks = [Check(f"{name}, back within 10 um", 1e3 * after, 1e3 * back, "ms")]
        return checks if peak is None else [Check(f"{name}, peak", far, peak), *checks]
    return name, measure


def step(payload, limit):
    """A command of 10 mm at once, within the points of a file; beside it the law alone."""
    name = f"step of 10 mm without profile, {payload + 2.5:g} kg"

    def measure(program):
        with tempfile.TemporaryDirectory() as folder:
            points = Path(folder) / "step.csv"
            points.write_text("x_mm,y_mm\n" + "250,250\n" * 50 + "260,250\n" * 350,
                              encoding="utf-8")
            keys = {"plant.payload_kg": payload, "path.kind": "points",
                    "path.points_file": points, "run.reached_m": 1, "run.diverged_m": 1}
            _, rows = record(program, "circle", keys)
        begin = next(row["t_s"] for row, after in itertools.pairwise(rows)
                     if after["x_command_m"] > 0.2550)
        samples = at_rest(rows, begin)
        swings = precision_step.changes_of_side((x for _, x in samples), 10)
        law = precision_step.step(payload + 2.5)
        why = (f"specified 1; by {max(x for _, x in samples) / 1e3:.2f} mm; the law in double "
               f"precision {law.swings}, by {1e3 * law.beyond_m:.2f} mm")
        return [Check(f"{name}, settled to 10 um", 1e3 * settled(samples, 10), 1e3 * limit, "ms"),
                Check(f"{name}, times past the end", swings, law.swings, "", why)]
    return name, measure


def standing(name):
    def measure(program):
        _, rows = record(program, "circle", still(0, {}, 1.2))
        tail = rows[-2000:]
        checks = []
        for axis in "xy":
            at = [1e6 * row[f"{axis}_position_m"] for row in tail]
            rms = math.sqrt(sum(row[f"{axis}_i_q_A"] ** 2 for row in tail) / len(tail))
            checks += [Check(f"{name}, {axis}, peak to peak", max(at) - min(at), 10),
                       Check(f"{name}, {axis}, i_q rms", rms, 0.25, "A")]
        return checks
    return name, measure


def scenario_step(name):
    def measure(program):
        figures, _ = record(program, "step", {"path.square_periods": 2})
        return [Check(f"{name}, {axis}, overshoot", figures[f"{axis}.periods.0.overshoot_percent"],
                      0.2, "%") for axis in "xy"]
    return name, measure


def beyond(path, payload, late_mm, times):
    """A payload beyond the motor: late, but to and fro at most as often as its path asks."""
    name = f"beyond the motor, {payload} kg, {path}"

    def measure(program):
        keys = {"plant.payload_kg": payload, "run.reached_m": 1, "run.diverged_m": 1}
        _, rows = record(program, path, keys, "precision.csv")
        checks = []
        for axis in "xy":
            off = [1e-3 * row[f"{axis}_error_um"] for row in rows if row["counted"]]
            checks += [Check(f"{name}, {axis}, max", max(map(abs, off)), late_mm, "mm"),
                       Check(f"{name}, {axis}, changes of side",
                             precision_step.changes_of_side(off, 0.1), times, "")]
        return checks
    return name, measure


def chords(length_mm):
    """A circle of 50 mm as chords, as lines of a points file."""
    name = f"circle of {length_mm} mm chords"

    def measure(program):
        count = round(2 * math.pi * 50 / length_mm)
        lines = [f"{250 + 50 * math.cos(2 * math.pi * n / count):.4f},"
                 f"{250 + 50 * math.sin(2 * math.pi * n / count):.4f}" for n in range(count + 1)]
        with tempfile.TemporaryDirectory() as folder:
            points = Path(folder) / "chords.csv"
            points.write_text("\n".join(["x_mm,y_mm", *lines, ""]), encoding="utf-8")
            return followed(name, 2.5, 15, "circle",
                            {"path.kind": "points", "path.points_mode": "path",
                             "path.points_file": points})[1](program)
    return name, measure


def rows_of_table():
    """(name, function of the program that gives the checks of a row)."""
    rows = []
    for counts in (0, 0.4):
        rows += [followed(f"hysteresis {counts} count", 3, 15, path,
                          {"plant.encoder_hysteresis_counts": counts}) for path in SHAPES]
    drops = {"chip.dead_time_ns": 3000, "plant.switch_drop_V": 1.5, "plant.diode_drop_V": 1.5}
    rows += [followed("dead time 3 us, drops 1.5 V", 3.5, 25, path, drops) for path in SHAPES]
    rows.append(followed("20 N outside, 11 kg", 1, 8, "circle",
                         {"plant.payload_kg": 11, "plant.external_force_N": 20}))
    for hertz, payload in itertools.product((60, 250, 500, 1000), (0, 11, 22.5)):
        rows.append(followed(f"mode {hertz} Hz, {payload} kg", 3, 25, "circle",
                             {**gen_precision.keys_of(payload, 1.5, 3, False),
                              "plant.mode_Hz": hertz}))
    rows += [followed("corners passed", 2.5, 15, path, {"path.corner": "pass"})
             for path in gen_precision.PATHS]
    rows += [chords(1), chords(5), chords(6)]
    rows += [laps("laps 2 to 5 without learning", path, WORST,
                  lambda of: (max(of[1:]), 1.1 * of[0] + 0.2)) for path in SHAPES]
    rows += [laps("lap 5 with learning", path, {**WORST, **LEARN},
                  lambda of: (of[4], of[0] + 0.1)) for path in SHAPES]
    rows += [laps("lap 5 with learning, harmonic of 2 N", path, {**HARMONIC, **LEARN},
                  lambda of: (of[4], of[0] / 2)) for path in SHAPES]
    rows += [push(0, 100, 300, 0.05), push(22.5, 100, 50, 0.05), push(0, 500, None, 0.6)]
    # The set point is there long before the current can bring the table.
    rows += [step(0, 0.1), step(22.5, 0.3), standing("standing still 1 s"),
             scenario_step("scenario step as a move")]
    rows += [beyond("circle", 80, 5, 1), beyond("window", 80, 8, 4), beyond("circle", 120, 20, 1)]
    return rows


def check(program, jobs, names=()):
    """Prints a line a check; returns lines of what is beyond its bar."""
    chosen = [measure for name, measure in rows_of_table()
              if not names or any(part in name for part in names)]

    def measured(measure):
        try:
            return measure(program)
        except Failed as error:
            return str(error)

    wrong = []
    with ThreadPoolExecutor(jobs) as pool:
        for found in pool.map(measured, chosen):
            if isinstance(found, str):
                wrong.append(found)
                continue
            for one in found:
                print(one, flush=True)
                if not one.holds:
                    wrong.append(str(one))
    print(f"precision: {len(chosen)} rows, {len(wrong)} beyond their bars")
    return wrong


def main():
    parser = python_tools.Parser(prog="scripts/tool precision-rows", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = gen_precision.arguments_of_runs(parser)
    if arguments is None:
        return 3
    wrong = check(arguments.program.resolve(), arguments.jobs, arguments.names)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
