#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine gantry in headless Chromium: what holds for every machine, and
what these show beyond it: the calibration and the thesis' figures beside ours.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import drawing
import report_pages

SHORT = ["--engine", "twin", "-s", "run.time_s=2", "-s", "step.zero_mm=0.5", "-s",
         "step.from_mm=2"]


class Page(report_pages.ReportPages):
    runs = {
        "p": ["run", "gantry-p", *SHORT],
        "cascade": ["run", "gantry-cascade", *SHORT],
        "aw": ["run", "gantry-pi-aw", *SHORT],
        "at_150_mm": ["run", "gantry-backlash", "--engine", "twin", "-s", "run.time_s=2"],
        "fitted": ["run", "gantry-calibrate", "--engine", "twin"],
        "identified": ["run", "gantry-identify", "--engine", "twin", "-s", "run.time_s=8"],
    }
    compared = ("p", "cascade", "aw")
    values = {"p": {"t_s": 1e-8, "x_mm": 1e-4, "v_mm_s": 1e-2, "position_mm": 1e-4,
                    "filtered_mm_s": 1e-2, "m1_u_count": 0, "m2_u_count": 0}}
    least_plots = 6
    least_saved = 9
    drawn = {"p": {
        "position": {"asked": "goal_mm", "cart": "x_mm", "observer": "position_mm"},
        "velocity": {"cart": "v_mm_s", "filtered": "filtered_mm_s", "observer": "velocity_mm_s"},
        **{plot: {f"motor {k}": f"m{k}_{column}" for k in (1, 2)} for plot, column in
           (("control", "u_count"), ("force", "force_count"), ("apart", "apart_mm"),
            ("flank", "flank"))}}}
    better_small = ("step.overshoot_mm step.overshoot_percent step.arrive_s step.settle_s "
                    "step.swing_mm")
    compared_drawn = {
        "response": (lambda row, _: 100 * (row["x_mm"] - 0.5 - 2) / (305 - 2), 1e-4),
        "position": "x_mm", "velocity": "v_mm_s", "filtered": "filtered_mm_s",
        "control": "m1_u_count"}

    def test_the_calibration_and_the_published_figure_are_shown(self):
        self.see("p")
        cubics = self.driver.find_element("id", "calibration").text
        for coefficient in ("162", "1652", "12289"):
            self.assertIn(coefficient, cubics)
        figures = self.driver.find_element("id", "figures").text
        self.assertIn("Brochier 2006, figure 36", figures)
        self.assertIn("figure 36: overshoot of 0.26 %",
                      self.driver.find_element("id", "motion").text)

    def test_models_are_drawn_beside_the_track(self):
        self.see("identified")
        for plot, lines in (("confidence", 3), ("validation", 5), ("step-responses", 5),
                            ("impulse-responses", 5), ("gains", 5)):
            drawn = self.js("return Trammel.svgText(Trammel.plots.find((p) => p.id === "
                            "arguments[0]))", plot)
            self.assertGreaterEqual(drawn.count("<path"), 2 * lines, plot)
            self.assertNotIn("NaN", drawn)

    def asides(self, metrics):
        names = ("reference_mm", "from_mm", "band_mm")
        to, begin, band = (metrics["options"][f"step.{name}"] for name in names)
        return {"step.overshoot_percent": f"of {to:g} mm", "step.arrive_s": f"within {band:g} mm",
                "step.settle_s": f"within {0.02 * abs(to - begin):g} mm, 2 %"}

    def test_asked_cart_and_observer_are_drawn_from_one_zero(self):
        self.see("at_150_mm")
        ends = {label: values[-1] for label, values in self.lines("position").items()}
        self.assertEqual(ends["asked"], 155)
        self.assertAlmostEqual(ends["cart"], 154, delta=1)
        self.assertAlmostEqual(ends["observer"], ends["cart"], delta=0.1)

    def test_chips_name_the_controller(self):
        self.see("p")
        options = {**self.metrics("p")["options"], "host.sends": ":21=1;:22=2", "position.gain": 3,
                   "position.time_shift": 12, "position.sum": "none", "position.min_force": 7}
        for changed, words in (
                ({}, "P, K = 3"), ({"position.sum": "plain"}, "PI, TI = 12"),
                ({"position.sum": "cancel"}, "PI, sum cancelled, TI = 12"),
                ({"position.sum": "anti_windup"}, "PI, anti-windup, TI = 12"),
                ({"position.sum": "anti_windup", "position.min_force": 0}, "PI, linear, TI = 12"),
                ({"position.sum": "plain", "position.min_force": 0}, "PI, TI = 12"),
                ({"position.bang_bang": True, "position.max_force": 90}, "bang-bang, \u00b190"),
                ({"control.cascade": True, "control.cascade_gain": 9, "control.compensate": False},
                 "cascade, K = 9"),
                ({"control.cascade": True, "control.cascade_gain": 9, "control.compensate": True},
                 "cascade, K = 9, backlash compensated"),
                ({"control.open": "random"}, "no controller, random"),
                ({"host.sends": ":22=2", "velocity.time_shift": 5}, "velocity PI, KIV = 5")):
            chips = self.js("return Trammel.machines.gantry.chips({ options: arguments[0], "
                            "published: { figure: arguments[1] } })", {**options, **changed}, "36")
            self.assertEqual(chips, [words, "figure 36"])

    def test_the_portrait_has_its_points_where_the_codes_are(self):
        self.see("fitted")
        rows = self.numbers_of("fitted")
        step = math.ceil(len(rows) / 6000)
        shapes = self.shapes("portrait", 440, 418)
        ring = self.paths("portrait", "asked", 440, 418)
        ring = max(ring, key=len)
        for role, names in (("model", ("a_code", "b_code")),
                            ("actual", ("sensor_a_code", "sensor_b_code"))):
            codes = [[row[name] for name in names] for row in rows[::step]]
            codes = [pair for pair in codes if pair != [0, 0]]
            color = self.color(role)
            dots = [(float(s["cx"]), float(s["cy"])) for s in shapes if s["tag"] == "circle" and
                    s["fill"] == color]
            self.assertEqual(len(dots), len(codes))
            for k, rises in ((0, True), (1, False)):
                # The ideal circle of 400 around 512 is in the same frame.
                pixels = [at[k] for at in ring]
                ends = [(112, min(pixels)), (912, max(pixels))]
                ends = ends if rises else [(912, ends[0][1]), (112, ends[1][1])]
                _, _, worst = drawing.line_through(
                    [(pair[k], dot[k]) for pair, dot in zip(codes, dots, strict=True)] + ends)
                self.assertLess(worst, 0.05, role)

    def chips(self, name):
        self.see(name)
        return self.driver.find_element("css selector", ".head-title").text

    def test_controller_and_figure_stand_beside_the_title(self):
        for name, words in (("p", "P, K = 3"), ("p", "figure 36"), ("cascade", "cascade, K = 9"),
                            ("cascade", "figure 55"), ("aw", "PI, anti-windup, TI = 12")):
            self.assertIn(words, self.chips(name))
            self.assertNotIn("none", self.chips(name))

    def test_the_cubics_are_those_of_the_memory(self):
        self.see("fitted")
        words = self.metrics("fitted")["calibration"]
        colors = self.js("return Trammel.light.runs")

        def phase(region, code):
            c = [w - 65536 if w > 32767 else w for w in words[14 + 4 * region:18 + 4 * region]]
            x = (64 * (code - 512) - words[10 + region]) / 16384
            return ((c[0] * x + c[1]) * x + c[2]) * x + c[3]

        curves, errors = [], []
        for region in range(4):
            steps = [32 * (k - 64) for k in range(129)]  # phase from the centre
            curve, error = (max((s["points"] for s in self.shapes(plot) if s["tag"] == "path"
                                 and s.get("stroke") == colors[region]), key=len)
                            for plot in ("cubics", "cubics-off"))
            for off, at, wrong in zip(steps, curve, error, strict=True):
                wave = math.cos if region % 2 else math.sin
                true = region * 4096 + off
                code = 512 + 400 * wave(2 * math.pi * true / 16384)
                curves.append((code, phase(region, code), at))
                errors.append((off, phase(region, code) - true, wrong))
        for points in (curves, errors):
            for k in (0, 1):  # x, y
                slope, _, worst = drawing.line_through([(one[k], one[2][k]) for one in points])
                self.assertEqual(slope > 0, k == 0)
                self.assertLess(worst, 0.02)

    def test_runs_lie_over_each_other_beside_what_the_thesis_has(self):
        self.see(".", "compare.html")
        table = self.driver.find_element("id", "published").text
        for words in ("figure 36", "overshoot of 0.26 %", "figure 39", "overshoot of 0.65 %",
                      "cascade, K = 9", "no overshoot, slower than P"):
            self.assertIn(words, table)
        top = self.js("const p = Trammel.time.plots.find((one) => one.id === 'response'); "
                      "return p.uplot.data.slice(1).map((s) => Math.max(...s))")
        self.assertEqual(len(top), 3)
        for value in top:
            self.assertTrue(99 < value < 102, top)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
