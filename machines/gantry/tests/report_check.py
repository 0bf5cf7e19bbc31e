#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine gantry in headless Chromium: what holds for every machine, and
what these show beyond it: the calibration and the thesis' figures beside ours.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import report_pages

SHORT = ["--engine", "twin", "-s", "run.time_s=2"]


class Page(report_pages.ReportPages):
    runs = {
        "p": ["run", "gantry-p", *SHORT],
        "cascade": ["run", "gantry-cascade", *SHORT],
        "aw": ["run", "gantry-pi-aw", *SHORT],
    }
    compared = ("p", "cascade", "aw")
    values = {"p": {"t_s": 1e-8, "x_mm": 1e-4, "v_mm_s": 1e-2, "position_mm": 1e-4,
                    "filtered_mm_s": 1e-2, "m1_u_count": 0, "m2_u_count": 0}}
    least_plots = 6
    least_saved = 6

    def test_the_calibration_and_the_published_figure_are_shown(self):
        self.open("p")
        cubics = self.driver.find_element("id", "calibration").text
        for coefficient in ("162", "1652", "12289"):
            self.assertIn(coefficient, cubics)
        figures = self.driver.find_element("id", "figures").text
        self.assertIn("Brochier 2006, figure 36", figures)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
