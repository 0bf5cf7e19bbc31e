#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine larson in headless Chromium: what holds for every machine, and
what these show beyond it: calls with their answers, events, and Larson's figures beside ours.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import report_pages

SHORT = ["--engine", "twin", "-s", "axis.start_x_step=30", "-s", "axis.start_y_step=20"]


class Page(report_pages.ReportPages):
    runs = {
        "calibrate": ["run", "larson-calibrate", *SHORT],
        "lost": ["run", "larson-overload", *SHORT],
        "step": ["run", "larson-step", *SHORT, "-s", "record.every_ms=1"],
    }
    tripped = {"lost"}
    compared = ("calibrate", "lost", "step")
    values = {"calibrate": {"t_s": 1e-8, "call": 0, "x_step": 0, "y_at_step": 1e-3,
                            "x_speed_step_s": 1e-1, "x_angle_step": 1e-3, "x_waiting": 0,
                            "x_count": 0}}
    least_plots = 6
    least_saved = 12

    def test_calls_events_and_published_figures_are_shown(self):
        self.open("calibrate")
        metrics = self.metrics("calibrate")
        calls = self.driver.find_element("id", "calls").text
        for call in metrics["calls"]:
            self.assertIn(call["call"], calls)
            self.assertIn(call["answer"], calls)
        self.assertIn("1000 2000", calls)
        events = self.driver.find_element("id", "interface").text
        for event in metrics["events"]:
            self.assertIn(event["what"], events)
        self.assertIn("low switch closed", events)
        figures = self.driver.find_element("id", "figures").text
        self.assertIn("127 steps at 4000 PPS", figures)
        self.assertIn("Larson 1974, section III", figures)
        self.assertIn("rate 7704", figures.lower())
        self.open("lost")
        self.assertIn("steps lost", self.driver.find_element("id", "interface").text)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
