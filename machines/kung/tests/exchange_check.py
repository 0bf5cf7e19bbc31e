#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""X and Y of the X-Y table are alike: runs with exchanged axes leave exchanged records, and what is
refused or told of an axis is told of the other one in the same words.

usage: exchange_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import checks
import exchange

# Keys that must have one value for both axes: CURRENT_LIMIT is that of both, and the path of these
# tests is drawn in counts of both.
SHARED = re.compile(r"plant\.[xy]\.(current_full_scale_A|encoder_count_m)")


def points():
    """A path in mm that is another one with exchanged axes."""
    for k in range(150):
        way = (k / 149) ** 2 * (3 - 2 * k / 149)
        yield (250 + 40 * math.sin(2 * math.pi * way),
               260 + 25 * math.sin(2 * math.pi * way) ** 3 + 20 * way)


class Exchange(exchange.Pairs):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_both(list(points()))
        cls.keys = {key: value for key, value in exchange.keys_of(cls.program, "kung").items()
                    if not SHARED.fullmatch(key)}
        cls.defaults = {key: default for key, (default, _, _) in cls.keys.items()}

    def pair(self, settings, *more, of_axis=()):
        """Exit code and words of a run and of the exchanged one, in folders xy and yx. of_axis:
        keys that have another value each."""
        settings = {**self.defaults, **settings}
        axes = dict(of_axis).items()
        return [exchange.run(self.program, "circle", {
            "path.kind": "points", "path.points_file": self.folder / f"{name}.csv",
            "name": "both", **dict(more), **values}, self.folder / name)
            for name, values in (
                ("xy", {**settings, **{key: both[0] for key, both in axes}}),
                ("yx", {**{exchange.exchanged(key): value for key, value in settings.items()},
                        **{key: both[1] for key, both in axes}}))]

    def alike(self, settings, *more, of_axis=(), part=0):
        """part: of a column's largest value, by which two may differ."""
        (code, said), (other_code, _) = self.pair(settings, *more, of_axis=of_axis)
        self.assertEqual(code, other_code)
        self.assertIn(code, (0, 5), said)
        (trace, metrics), (other_trace, other) = (exchange.records(self.folder / name)
                                                  for name in ("xy", "yx"))
        self.assertEqual(len(trace), len(other_trace))
        reach = {key: part * max(abs(float(row[key])) for row in trace) for key in trace[0]}
        for row, exchanged_row in zip(trace, other_trace, strict=True):
            wanted = {exchange.exchanged(key): value for key, value in exchanged_row.items()}
            off = [key for key in row
                   if abs(float(row[key]) - float(wanted[key])) > reach[key]]
            self.assertEqual(off, [], f"tick {row['tick']}: " + ", ".join(
                f"{key} {row[key]}, exchanged {wanted[key]}" for key in off[:3]))
        for one in (metrics, other):  # what is left and right of a path is exchanged with it
            for name in ("options", "run", "versions", "command"):
                one.pop(name)
        sides = {"left": "right", "right": "left"}
        other["contour"].update({f"{a}_mm": other["contour"][f"{b}_mm"] for a, b in sides.items()
                                 }.items())
        values = {f["id"]: f["value"] for f in other["figures"]}
        for f in other["figures"]:
            for a, b in sides.items():
                if f["id"] == f"contour.{a}_mm":
                    f["value"] = values[f"contour.{b}_mm"]
        self.assertEqual(list(exchange.differences(metrics, other, part)), [])

    def test_records_are_exchanged(self):
        for seed, controller in ((1, "fc"), (2, "afc"), (3, "afc")):
            with self.subTest(seed=seed):
                values = exchange.varied(self.keys, seed)
                self.alike({key: value for key, value in values.items() if "stroke" not in key},
                           ("controller", controller), ("run.settle_s", 0.2))

    def test_what_differs_in_kind_is_exchanged(self):
        more = {"plant.x.brake": "false", "plant.y.cogging_N": 4, "plant.x.cogging_harmonic_N": 2,
                "plant.x.mode_Hz": 80, "plant.y.supply_ohm": 1, "plant.x.cable_N_m": 30,
                "plant.y.load_N": 6, "plant.y.load_begin_s": 0.1, "gains.x.feedforward": "true",
                "gains.y.interpolate": "true", "gains.x.shift_e": 1, "gains.y.shift_de": 1,
                "chip.x.dead_time_ns": 1000, "chip.y.qep_filter_clk": 5,
                "plant.x.stribeck_N": 1}
        # The steps of a plant that is solved in steps end where the other axis has an event.
        self.alike(more, ("run.settle_s", 0.2), part=1e-3)

    def test_faults_are_exchanged(self):
        for fault, value, line in (("converter_offset", 200, 1), ("phase_open", 0, 2),
                                   ("encoder_missing", 0, 0), ("gate_dead", 0, 3),
                                   ("encoder_stuck", 0, 1)):
            with self.subTest(fault=fault):
                self.alike({}, ("inject.fault", fault), ("inject.value", value),
                           ("inject.line", line), ("inject.begin_s", 0.1),
                           of_axis={"inject.axis": (0, 1)})

    def test_x_turned_round_leaves_y_and_turns_x(self):
        """The path in a mirror at x = 300 mm, the middle of the stroke."""
        self.write_points("turned", [(600 - x, y) for x, y in points()])
        traces, figures = [], []
        for name in ("xy", "turned"):
            code, said = exchange.run(self.program, "circle", {
                "path.kind": "points", "path.points_file": self.folder / f"{name}.csv",
                "run.settle_s": 0.2}, self.folder / name)
            self.assertIn(code, (0, 5), said)
            trace, metrics = exchange.records(self.folder / name)
            traces.append(trace)
            figures.append({f["id"]: f["value"] for f in metrics["figures"]})
        for row, turned in zip(*traces, strict=True):
            for key in row:
                if key.startswith("y_"):  # to the last digit
                    self.assertEqual(row[key], turned[key], f"{key} at tick {row['tick']}")
            for key in ("x_position_m", "x_model_m", "x_command_m"):
                if float(row["x_command_m"]) > 0:  # behind the first point
                    self.assertAlmostEqual(float(row[key]) + float(turned[key]), 0.6, delta=2e-4,
                                           msg=f"{key} at tick {row['tick']}")
        one, other = figures
        other["contour.left_mm"], other["contour.right_mm"] = (
            other["contour.right_mm"], other["contour.left_mm"])
        other["x.error_to_model.mean_mm"] *= -1
        for name, value in one.items():
            self.assertAlmostEqual(other[name], value, delta=0.03 * abs(value) + 1e-9, msg=name)

    def test_what_is_refused_or_told_is_told_of_either_axis(self):
        for key, (_, least, most) in self.keys.items():
            for value in (least, most, most + 1):
                (code, said), (other_code, other) = self.pair({key: f"{value:.17g}"},
                                                              ("run.max_s", 0.004))
                where = f"{key} = {value}"
                self.assertEqual(code, other_code, f"{where}\n{said}\n{other}")
                lines = [sorted(text.replace("yx.csv", "xy.csv").split("\n"))
                         for text in (said, exchange.exchanged(other))]
                self.assertEqual(*lines, where)


if __name__ == "__main__":
    sys.exit(checks.main(Exchange, __doc__))
