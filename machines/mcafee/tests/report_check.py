#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine mcafee in headless Chromium: what holds for every machine, and
what these show beyond it: contour errors of three runs, rows, switches, and a plot that is longer
than the run.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import browser
import report_pages


class Page(report_pages.ReportPages):
    runs = {
        "track": ["run", "mcafee-stage3", "--engine", "twin", "-s", "path.side_mm=6",
                  "-s", "path.radius_mm=1", "-s", "path.kappa_max_1_mm=1", "-s", "filter.ki=5",
                  "-s", "filter.il=500", "-s", "trajectory.wait_s=0.3",
                  "-s", "run.reached_counts=1000"],
        "move": ["run", "mcafee-stage2", "--engine", "twin",
                 "-s", "trajectory.position_counts=2000"],
        "switch": ["run", "mcafee-stage3", "--engine", "twin", "-s", "compare=false",
                   "-s", "stage.switch_high_m=0.004"],
    }
    tripped = {"switch"}
    compared = ("track", "switch", "move")
    values = {"track": {"t_s": 1e-8, "row": 0, "v": 0, "contour_mm": 1e-5, "x_mm": 1e-5,
                        "y_mm_s": 1e-3, "x_desired_count": 1e-3, "y_desired_speed": 1e-5,
                        "x_p": 0, "y_i": 0, "x_d": 0, "y_status": 0, "x_u_V": 1e-4}}
    least_plots = 6
    least_saved = 19

    def contour(self):
        """Names, figures that the page marks, and largest values of the runs of the plot."""
        return self.js("return Trammel.time.plots.find((p) => p.id === 'contour').series.map("
                       "(s) => [s.label, ...s.peak, Math.max(...s.data)])")

    def test_contour_errors_of_three_runs_are_in_one_plot(self):
        self.open("track")
        metrics = self.metrics("track")
        runs = {"self-paced": metrics["motion"],
                **{name: run["motion"] for name, run in metrics["compared"].items()}}
        shown = self.contour()
        self.assertEqual([one[0] for one in shown], ["self-paced", "v = 254", "v = 40"])
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
        self.open("track")
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
        trace = self.rows("track")
        begins = next(row for row in trace if row["row"] == "8")
        self.assertEqual(cells[7][9], begins["v"])
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
        self.open("switch")
        self.assertFalse(self.driver.find_element("id", "zoom-reset").is_enabled())
        events = self.driver.find_element("id", "status").text
        self.assertIn("X high switch open", events)  # the record ends before the motors are off
        begin = float(self.rows("switch")[0]["t_s"])
        opened = self.metrics("switch")["events"][0]["time_s"]
        marks = self.js("return Trammel.time.marks")
        self.assertEqual(len(marks), 1)
        self.assertAlmostEqual(marks[0], opened - begin, delta=1e-7)
        self.assertIn("limit switch", self.driver.find_element("class name", "bad").text)

    def test_runs_of_a_table_are_compared(self):
        self.open(".", "compare.html")
        lengths = [len(self.rows(name)) for name in self.compared]
        longest = max(lengths)
        self.assertEqual(self.filled(),
                         [[longest, *lengths[:2]]] * 2 + [[longest, *lengths]] * 2)
        self.assertEqual(len(self.driver.find_elements("css selector", "#paths .card")), 2)
        self.assertEqual(browser.complaints(self.driver), [])


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
