#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine mcafee in headless Chromium and check what they show beyond the
others: contour errors of three runs, rows, switches, and a plot that is longer than the run.

usage: report_mcafee_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
import browser  # noqa: E402
import report_pages  # noqa: E402


class Page(report_pages.ReportPages):
    runs = {**report_pages.MCAFEE, "an693": ["an693-tuning", "-s", "trajectory.steps=1"]}

    def contour(self):
        """Names, figures that the page marks, and largest values of the runs of the plot."""
        return self.js("return Trammel.time.plots.find((p) => p.id === 'contour').series.map("
                       "(s) => [s.label, ...s.peak, Math.max(...s.data)])")

    def test_contour_errors_of_three_runs_are_in_one_plot(self):
        self.open("mcafee")
        metrics = json.loads((self.folder / "mcafee" / "metrics.json").read_text())
        runs = {"self-paced": metrics["motion"], **metrics["compared"]}
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

    def test_a_plot_longer_than_the_others_shares_zoom_and_cursor(self):
        from selenium.webdriver import ActionChains
        self.open("mcafee")
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
        status = self.driver.find_element("css selector", "[data-plot=status-x] canvas")
        self.js("arguments[0].scrollIntoView({block: 'center'})", status)
        ActionChains(self.driver, duration=20).move_to_element(status).perform()
        at = "return Trammel.time.plots.map((p) => p.uplot.data[0][p.uplot.cursor.idx] || 0)"
        self.until(lambda: self.js(at)[0] > 0)
        self.assertLess(max(self.js(at)) - min(self.js(at)), 0.02)

    def test_the_page_of_a_table_tells_rows_speed_and_switches(self):
        self.open("mcafee")
        with open(self.folder / "mcafee" / "table.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.js("document.querySelector('#feed details').open = true")
        shown = "return document.querySelectorAll('#feed details tbody tr').length"
        self.until(lambda: self.js(shown) == len(rows))
        cells = self.js("return [...document.querySelectorAll('#feed details tbody tr')].map("
                        "(r) => [...r.cells].map((c) => c.textContent.replace('\u2212', '-')))")
        for cell, row in zip(cells, rows, strict=True):
            self.assertEqual(cell[3:9], [row[key] for key in ("dx", "dy", "c", "cc", "vx", "vy")])
        trace = self.rows("mcafee")
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
        metrics = json.loads((self.folder / "switch" / "metrics.json").read_text())
        begin = float(self.rows("switch")[0]["t_s"])
        marks = self.js("return Trammel.time.marks")
        self.assertEqual(len(marks), 1)
        self.assertAlmostEqual(marks[0], metrics["events"][0]["time_s"] - begin, delta=1e-7)
        self.assertIn("limit switch", self.driver.find_element("class name", "bad").text)

    def test_runs_of_a_table_are_compared_and_machines_are_not_mixed(self):
        page = self.folder / "compare_mcafee.html"
        subprocess.run([self.program, "report", self.folder / "mcafee", self.folder / "switch",
                        self.folder / "move", "-o", page], check=True, capture_output=True)
        self.open(".", page.name)
        filled = self.js("return Trammel.time.plots.map((p) => p.uplot.data.map((s) => "
                         "[...s].filter((v) => v !== null).length))")
        lengths = [len(self.rows(name)) for name in ("mcafee", "switch", "move")]
        longest = max(lengths)
        self.assertEqual(filled, [[longest, *lengths[:2]]] * 2 + [[longest, *lengths]] * 2)
        self.assertEqual(len(self.driver.find_elements("css selector", "#paths .card")), 2)
        self.assertEqual(browser.complaints(self.driver), [])
        mixed = subprocess.run([self.program, "report", self.folder / "mcafee",
                                self.folder / "an693", "-o", self.folder / "mixed.html"],
                               check=False, capture_output=True, text=True)
        self.assertEqual(mixed.returncode, 2)
        self.assertIn("only runs of one machine can be compared", mixed.stderr)
        self.assertFalse((self.folder / "mixed.html").exists())


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
