#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine an693 in headless Chromium: what holds for every machine, and
what these show beyond it: interrupts, the script that drove the part, runs of both kinds compared.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import browser
import report_pages


class Page(report_pages.ReportPages):
    runs = {
        "tuning": ["run", "an693-tuning", "-s", "trajectory.steps=2"],
        "script": ["lm628", "tuning"],
    }
    compared = ("tuning", "script")
    values = {"tuning": {"t_s": 1e-8, "desired_count": 1e-3, "theta_count": 1e-3, "p": 0,
                         "status": 0, "host_irq": 0, "omega_rad_s": 1e-4, "u_V": 1e-4}}
    least_plots = 6
    least_saved = 7

    def test_the_page_tells_its_interrupts_and_script(self):
        self.open("tuning")
        interrupts = self.metrics("tuning")["interrupts"]
        self.assertEqual(self.js("return Trammel.time.marks"),
                         [one["time_s"] for one in interrupts])
        table = self.driver.find_element("css selector", "#status table").text
        self.assertEqual(table.count("trajectory complete"), len(interrupts))
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
