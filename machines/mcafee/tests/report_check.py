#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine mcafee in headless Chromium: what holds for every machine, and
what these show beyond it: contour errors of three runs, rows, switches, and a plot that is longer
than the run.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import csv
import itertools
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import drawing
import report_pages

MM = 1e3 * 0.0040132 / 800        # of a count
CLOCK = "-s", "chip.clock_MHz=8"  # not the default
MM_S = MM / (2048 / 8e6)          # of a count a sample


def place(column, factor):
    """From the origin of the square, the middle of its lower edge."""
    return (lambda row, axis: row[column.format(a=axis)] * factor - (3 if axis == "y" else 0),
            1e-5)


class Page(report_pages.ReportPages):
    runs = {
        "track": ["run", "mcafee-stage3", "--engine", "twin", *CLOCK, "-s", "path.side_mm=6",
                  "-s", "path.radius_mm=1", "-s", "path.kappa_max_1_mm=1", "-s", "filter.ki=5",
                  "-s", "filter.il=500", "-s", "trajectory.wait_s=0.3",
                  "-s", "run.reached_counts=1000"],
        "move": ["run", "mcafee-stage2", "--engine", "twin", *CLOCK,
                 "-s", "trajectory.position_counts=2000"],
        "switch": ["run", "mcafee-stage3", "--engine", "twin", *CLOCK, "-s", "compare=false",
                   "-s", "stage.switch_high_m=0.0039"],
    }
    tripped = {"switch"}
    compared = ("track", "switch", "move")
    values = {"track": {"t_s": 1e-8, "row": 0, "v": 0, "contour_mm": 1e-5, "x_mm": 1e-5,
                        "y_mm_s": 1e-3, "x_desired_count": 1e-3, "y_desired_speed": 1e-5,
                        "x_p": 0, "y_i": 0, "x_d": 0, "y_status": 0, "x_u_V": 1e-4}}
    least_plots = 6
    least_saved = 19
    drawn = {"track": {
        "contour": {"self-paced": None, "v = 254": None, "v = 40": None},
        "path-speed": {"desired": drawing.hypot("x_desired_speed", "y_desired_speed", factor=MM_S,
                                                tolerance=1e-3),
                       "table": drawing.hypot("x_mm_s", "y_mm_s")},
        "feed": {"v": "v"}, "curvature": {"C": None, "CC": None},
        "position-{a}": {"desired": place("{a}_desired_count", MM), "table": place("{a}_mm", 1),
                         "real, as counted": place("{a}_real_count", MM)},
        "speed-{a}": {"desired": ("{a}_desired_speed", MM_S), "table": "{a}_mm_s"},
        "error-{a}": {"e": "{a}_e"},
        "terms-{a}": {name: f"{{a}}_{name}" for name in ("output", "d", "p", "i")},
        "voltage-{a}": {"u": "{a}_u_V"}, "current-{a}": {"i": "{a}_i_A"}}}
    better_small = ("motion.time_s motion.contour_max_mm motion.contour_rms_mm "
                    "motion.contour_end_mm motion.max_error_counts")
    colors_drawn = {"track": {
        "speed": ("table, speed (mm/s)", drawing.hypot("x_mm_s", "y_mm_s")),
        "feed rate": ("table, v (0..255)", "v"),
        "contour error": ("table, contour (mm)", "contour_mm")}}
    paths_drawn = {"track": (None, place("{a}_desired_count", MM), place("{a}_mm", 1), None)}

    def asides(self, metrics):
        motion = metrics["motion"]
        return {"real_count.0": f"{metrics['real_count'][0] * MM:.3f} mm from the start",
                "motion.max_error_counts":
                    f"of an axis, {motion['max_error_counts'] * MM:.3f} mm",
                "motion.max_speed_mm_s": f"of an axis, desired {motion['max_desired_mm_s']:.1f}",
                "motion.max_current_A": f"limit {metrics['options']['motor.current_limit_A']:.1f} A"
                }

    def contour(self):
        """Names, figures that the page marks, and largest values of the runs of the plot."""
        return self.js("return Trammel.time.plots.find((p) => p.id === 'contour').series.map("
                       "(s) => [s.label, ...s.peak, Math.max(...s.data)])")

    def test_contour_errors_of_three_runs_are_in_one_plot(self):
        self.see("track")
        metrics = self.metrics("track")
        runs = {"self-paced": metrics["motion"],
                **{name: run["motion"] for name, run in metrics["compared"].items()}}
        shown = self.contour()
        self.assertEqual([one[0] for one in shown], ["self-paced", "v = 254", "v = 40"])
        own, fast, slow = (runs[one[0]] for one in shown)
        note = self.driver.find_element("id", "tracking").text
        self.assertIn(f"has {own['contour_max_mm'] / fast['contour_max_mm']:.2f} of the largest "
                      "contour error of v = 254", note)
        self.assertIn(f"takes {own['time_s'] / slow['time_s']:.2f} of the time of v = 40", note)
        most = (254 * 255 >> 8) * 0xF1 * 2 ** self.metrics("track")["options"][
            "track.velocity_shift"] / 65536 * MM_S
        self.assertIn(f"v = 254 along an axis is {most:.2f} mm/s",
                      self.driver.find_element("id", "feed").text)
        for name, when, peak, largest in shown:
            self.assertEqual((when, peak), (runs[name]["contour_max_s"],
                                            runs[name]["contour_max_mm"]))
            self.assertAlmostEqual(largest, peak, delta=1e-5)
            table = self.driver.find_element("id", "tracking").text
            self.assertIn(f"{name} {runs[name]['time_s']:.3f} {peak:.4f} {when:.3f}", table)
        self.assertEqual(len(set(self.js(
            "return Trammel.time.plots.find((p) => p.id === 'contour').series.map((s) => "
            "Trammel.theme().runs[s.run])"))), 3)

    def test_tiles_tell_the_figures_of_the_runs_beside(self):
        self.see("track")
        asides = [one.text for one in self.driver.find_elements("css selector", ".tile .aside")]
        beside = self.metrics("track")["compared"]
        self.assertEqual(asides[0], ", ".join(f"{name}: {run['motion']['time_s']:.3f}"
                                              for name, run in beside.items()))

    def test_a_plot_longer_than_the_others_shares_zoom_and_cursor(self):
        from selenium.webdriver import ActionChains
        self.open("track")
        reset = self.driver.find_element("id", "zoom-reset")
        ids = self.js("return Trammel.time.plots.map((p) => p.id)")
        whole = self.ranges()
        longer = ids.index("contour")
        self.assertFalse(reset.is_enabled())
        self.assertGreater(whole[longer][1], 1.5 * whole[0 if longer else 1][1])
        self.drag("contour", 0.05, 0.15)
        self.until(lambda: all(r == self.ranges()[0] != w
                               for r, w in zip(self.ranges(), whole, strict=True)))
        reset.click()
        self.until(lambda: self.ranges() == whole)
        self.drag("contour", 0.8, 0.9)  # where the other plots have ended
        self.until(lambda: self.ranges()[longer] != whole[longer])
        self.assertEqual([r for k, r in enumerate(self.ranges()) if k != longer],
                         [r for k, r in enumerate(whole) if k != longer])
        self.assertTrue(reset.is_enabled())
        reset.click()
        self.until(lambda: self.ranges() == whole)
        self.drag("error-x", 0.5, 0.6)
        self.until(lambda: len({tuple(r) for r in self.ranges()}) == 1)
        reset.click()
        # A point of the status bits is the cursor of all, also of the longer one.
        status = self.driver.find_element("css selector", "[data-plot=status-x] .plot")
        self.js("arguments[0].scrollIntoView({block: 'center'})", status)
        ActionChains(self.driver, duration=20).move_to_element(status).perform()
        at = "return Trammel.time.plots.map((p) => p.uplot.data[0][p.uplot.cursor.idx] || 0)"
        self.until(lambda: self.js(at)[0] > 0)
        self.assertLess(max(self.js(at)) - min(self.js(at)), 0.02)

    def test_the_page_of_a_table_tells_rows_speed_and_switches(self):
        self.open("track")
        with open(self.folder / "track" / "table.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.js("document.querySelector('#feed details').open = true")
        shown = "return document.querySelectorAll('#feed details tbody tr').length"
        self.until(lambda: self.js(shown) == len(rows))
        cells = self.js("return [...document.querySelectorAll('#feed details tbody tr')].map("
                        "(r) => [...r.cells].map((c) => c.textContent.replace('\u2212', '-')))")
        for cell, row in zip(cells, rows, strict=True):
            self.assertEqual(cell[3:9], [row[key] for key in ("dx", "dy", "c", "cc", "vx", "vy")])
        self.assertEqual(cells[0][1:3], ["0.000", "-3.000"])
        for before, cell in itertools.pairwise(cells):
            for axis in (1, 2):  # where a row begins is where the one before it ends
                self.assertAlmostEqual(float(cell[axis]), float(before[axis]) +
                                       MM * float(before[axis + 2]), delta=1.1e-3)
        trace = self.rows("track")
        for label, key in (("C", "c"), ("CC", "cc")):
            for k, (shown, row) in enumerate(zip(self.lines("curvature")[label], trace,
                                                 strict=True)):
                now = rows[min(len(rows), max(1, int(row["row"]))) - 1]
                self.assertEqual(shown, int(now[key]), f"{label}, sample {k}")
        begins = next(row for row in trace if row["row"] == "8")
        self.assertEqual(cells[7][9], begins["v"])
        after = next(row for row in trace if row["row"] == "9")
        self.assertAlmostEqual(float(cells[7][11]), 0.4951819 / (float(after["t_s"]) -
                                                                 float(begins["t_s"])), delta=0.01)
        self.assertAlmostEqual(float(cells[7][10]), float(begins["t_s"]) - float(trace[0]["t_s"]),
                               delta=6e-4)
        speeds = [math.hypot(float(row["x_mm_s"]), float(row["y_mm_s"])) for row in trace]
        self.assertAlmostEqual(self.js("return Trammel.plots.find((p) => p.id === 'path').top()"),
                               max(speeds), delta=1e-2)
        far = self.js("const d = Trammel.page.runs[0].data; return Math.max(...d.from.x.map((x, k) "
                      "=> Math.hypot(d.table.x[k] - x, d.table.y[k] - d.from.y[k])))")
        # A chord of a row of 0.5 mm lies 0.03 mm inside of an arc of 1 mm.
        self.assertAlmostEqual(far, max(float(row["contour_mm"]) for row in trace), delta=0.032)
        self.assertIn("Aerotech 1075", self.driver.find_element("id", "assumptions").text)
        self.assertIn("chip.clock_MHz 8 not stated",
                      self.driver.find_element("id", "assumptions").text)
        self.open("switch")
        self.assertFalse(self.driver.find_element("id", "zoom-reset").is_enabled())
        events = self.driver.find_element("id", "status").text
        self.assertIn("X high switch open", events)  # the record ends before the motors are off
        begin = float(self.rows("switch")[0]["t_s"])
        opened = self.metrics("switch")["events"][0]["time_s"]
        marks = self.js("return Trammel.time.marks")
        self.assertEqual(len(marks), 1)
        self.assertAlmostEqual(marks[0], opened - begin, delta=1e-7)
        bars = [s for s in self.shapes("status-x") if s["tag"] == "rect"]
        rows = self.numbers_of("switch")
        # The row at the bottom is that of the high switch: a bar from its first sample on.
        lowest = max(bars, key=lambda bar: float(bar["y"]))
        first = next(k for k, row in enumerate(rows) if int(row["limits"]) & 2)
        part = (rows[first]["t_s"] - begin) / (rows[-1]["t_s"] - begin)
        self.assertAlmostEqual(float(lowest["x"]), 146 + part * (640 - 160), delta=1)
        self.assertIn("limit switch", self.driver.find_element("class name", "bad").text)

    def test_runs_of_a_table_are_compared(self):
        self.see(".", "compare.html")
        lengths = [len(self.rows(name)) for name in self.compared]
        longest = max(lengths)
        self.assertEqual(self.filled(),
                         [[longest, *lengths[:2]]] * 2 + [[longest, *lengths]] * 2)
        self.assertEqual(len(self.driver.find_elements("css selector", "#paths .card")), 2)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
