#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine an693 in headless Chromium: what holds for every machine, and
what these show beyond it: interrupts, the script that drove the part, runs of both kinds compared.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import browser
import report_pages


class Page(report_pages.ReportPages):
    runs = {
        "tuning": ["run", "an693-tuning", "-s", "trajectory.steps=2"],
        "script": ["lm628", "tuning"],
        "turn": ["run", "an693-relative", "--engine", "twin",
                 "-s", "trajectory.position_counts=3000"],
        "soft": ["run", "an693-tuning", "-s", "trajectory.steps=2", "-s", "filter.kp=80"],
    }
    compared = ("tuning", "script", "soft")
    values = {"tuning": {"t_s": 1e-8, "desired_count": 1e-3, "theta_count": 1e-3, "p": 0,
                         "status": 0, "host_irq": 0, "omega_rad_s": 1e-4, "u_V": 1e-4}}
    least_plots = 6
    least_saved = 7
    # A turn has 4000 counts, a sample 256 us.
    drawn = {"turn": {
        "position": {"desired": "desired_count", "shaft": "theta_count",
                     "real, as counted": "real_count"},
        "speed": {"desired": ("desired_speed", 1 / 4000 / 256e-6),
                  "shaft": ("omega_rad_s", 1 / (2 * math.pi))},
        "error": {"e": "e"}, "terms": {name: name for name in ("output", "d", "p", "i")},
        "voltage": {"u": "u_V"}, "current": {"i": "i_A"}}}
    compared_drawn = {"position": "theta_count", "error": "e", "output": "output",
                      "speed": ("omega_rad_s", 1 / (2 * math.pi))}

    def test_the_page_tells_its_interrupts_and_script(self):
        self.open("tuning")
        interrupts = self.metrics("tuning")["interrupts"]
        self.assertEqual(self.js("return Trammel.time.marks"),
                         [one["time_s"] for one in interrupts])
        table = self.driver.find_element("css selector", "#status table").text
        self.assertEqual(table.count("trajectory complete"), len(interrupts))
        self.assertNotIn("busy", table)
        rows = self.rows_of("#status tbody tr")
        for row, one in zip(rows, interrupts, strict=True):
            self.assertEqual([cell[0] for cell in row[3:5]],
                             [str(one["desired_count"]), str(one["real_count"])])
        speed = self.metrics("tuning")["motion"]["max_speed_rev_s"]
        self.assertIn(f"{60 * speed:.0f} rev/min", self.driver.find_element("id", "top").text)
        self.assertIn("First step settled", self.driver.find_element("id", "figures").text)
        self.open("script")
        script = self.driver.find_element("id", "script").text
        for line in ("LTRJ 0003h -50", "RDRP", "00000030h 48 counts"):
            self.assertIn(line, script)
        self.assertNotIn("filter", self.driver.find_element("id", "parameters").text)

    def test_a_run_and_a_script_are_compared(self):
        self.open(".", "compare.html")
        lengths = [len(self.rows(name)) for name in self.compared]
        self.assertEqual(self.filled(), [[max(lengths), *lengths]] * 4)
        self.assertEqual(browser.complaints(self.driver), [])


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
