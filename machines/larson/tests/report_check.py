#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine larson in headless Chromium: what holds for every machine, and
what these show beyond it: calls with their answers, events, and Larson's figures beside ours.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import drawing
import page_tables
import report_pages

SHORT = ["--engine", "twin", "-s", "axis.start_x_step=30", "-s", "axis.start_y_step=20"]


class Page(report_pages.ReportPages):
    runs = {
        "calibrate": ["run", "larson-calibrate", *SHORT],
        "lost": ["run", "larson-overload", *SHORT],
        "published": ["run", "larson-published", *SHORT],
        "step": ["run", "larson-step", *SHORT, "-s", "record.every_ms=1"],
        "rough": ["run", "larson-step", *SHORT, "-s", "record.every_ms=2",
                  "-s", "motor.friction_N_m=0.05"],
    }
    tripped = {"lost"}
    compared = ("step", "lost", "rough")
    values = {"calibrate": {"t_s": 1e-8, "call": 0, "x_step": 0, "y_at_step": 1e-3,
                            "x_speed_step_s": 1e-1, "x_angle_step": 1e-3, "x_waiting": 0,
                            "x_count": 0}}
    least_plots = 6
    least_saved = 12
    drawn = {"step": {
        "angle-{a}": {"rotor": "{a}_angle_step"},
        "position-{a}": {"interface": "{a}_asked_step", "translator": "{a}_step",
                         "rotor": "{a}_at_step"},
        "rate-{a}": {"rotor": "{a}_speed_step_s", "translator": "{a}_rate_step_s"},
        "waiting-{a}": {"waiting": "{a}_waiting"},
        "left-{a}": {"left": (lambda row, axis: 65535 - row[f"{axis}_count"], 0)},
        "bits-{a}": {"busy": drawing.bit("{a}_status", 12),
                     "forward": drawing.bit("{a}_status", 13),
                     "switch": drawing.bit("{a}_status", 14)}}}
    better_small = ("script.time_s script.off_step x.lost_step x.max_angle_step y.lost_step "
                    "y.max_angle_step")
    colors_drawn = {"step": {
        "speed": ("rotors, speed (step/s)", drawing.hypot("x_speed_step_s", "y_speed_step_s")),
        "load angle": ("rotors, load angle (step)",
                       drawing.hypot("x_angle_step", "y_angle_step"))}}
    compared_drawn = {"position-{a}": "{a}_at_step", "angle-{a}": "{a}_angle_step"}
    paths_drawn = {"calibrate": tuple((f"{{a}}_{name}", 25.4e-3) for name in
                                      ("asked_step", "step", "at_step", "step"))}

    def asides(self, metrics):
        return {"script.time_s": f"{metrics['script']['calls']} calls",
                "x.max_angle_step": "beyond 5 the rotor falls back by 10",
                "script.off_step": "rotors from where WHRTBL has them",
                "interrupts": f"{metrics['event_count']} events in all"}

    def test_events_stand_in_the_order_of_their_columns(self):
        self.see("calibrate")
        events = self.metrics("calibrate")["events"]
        self.assertTrue(events)
        for number, (cells, one) in enumerate(zip(self.rows_of("#interface .long tbody tr"), events,
                                                  strict=True), 1):
            text = [cell[0] for cell in cells]
            self.assertEqual([text[0], *text[2:4], *text[5:]], [
                str(number), one["axis"].upper(), one["what"], f"{one['count']:06o}",
                f"{one['status']:06o}"])
            self.assertAlmostEqual(page_tables.number(text[1]), one["time_s"], delta=0.51e-5)
            self.assertAlmostEqual(page_tables.number(text[4]), one["at_step"], delta=0.0051)
        for cells, call in zip(self.rows_of("#calls tbody tr"), self.metrics("calibrate")["calls"],
                               strict=True):
            self.assertEqual([cell[0] for cell in cells[1:4]],
                             [str(call["line"]), call["call"], call.get("answer", "")])
            self.assertAlmostEqual(float(cells[0][0]), call["time_s"], delta=0.51e-4)

    def test_calls_events_and_published_figures_are_shown(self):
        self.see("calibrate")
        metrics = self.metrics("calibrate")
        self.assertIn("1000 2000", self.driver.find_element("id", "calls").text)
        for row, call in zip(self.rows_of("#calls tbody tr"), metrics["calls"], strict=True):
            for cell, axis in zip(row[4:], "xy", strict=True):
                self.assertAlmostEqual(page_tables.number(cell[0]), call[f"{axis}_step"],
                                       delta=0.0051)
        marks = self.js("return Trammel.time.marks")
        rare = [one["time_s"] for one in metrics["events"] if one["what"] != "interrupt"]
        every = [one["time_s"] for one in metrics["events"]]
        self.assertEqual(marks, every if len(every) <= 24 else rare[:24])
        self.assertIn("low switch closed", self.driver.find_element("id", "interface").text)
        self.see("published")
        figures = self.driver.find_element("id", "figures").text
        self.assertIn("127 steps at 4000 PPS", figures)
        self.assertIn("Larson 1974, section III", figures)
        self.assertIn("rate 7704", figures.lower())
        self.see("lost")
        self.assertIn("steps lost", self.driver.find_element("id", "interface").text)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
