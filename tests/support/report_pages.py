# SPDX-License-Identifier: Apache-2.0
"""Report pages of runs made anew, opened in headless Chromium: what their tests share."""

import csv
import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import browser

MCAFEE = {  # folder: arguments
    "mcafee": ["mcafee-stage3", "--engine", "twin", "-s", "path.side_mm=6",
               "-s", "path.radius_mm=1", "-s", "path.kappa_max_1_mm=1", "-s", "filter.ki=5",
               "-s", "filter.il=500"],
    "move": ["mcafee-stage2", "--engine", "twin", "-s", "trajectory.position_counts=2000"],
    "switch": ["mcafee-stage3", "--engine", "twin", "-s", "compare=false",
               "-s", "stage.switch_high_m=0.004"],
}
TRIPPED = {"trip", "switch"}
PAINTED = """
  const canvas = arguments[0];
  const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const seen = new Set();
  for (let k = 0; k < data.length; k += 4) {
    if (data[k + 3] > 0) seen.add(data[k] << 16 | data[k + 1] << 8 | data[k + 2]);
  }
  return seen.size;
"""


class ReportPages(unittest.TestCase):
    runs = {}  # folder: arguments
    program, folder, driver = None, None, None

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)
        for name, arguments in cls.runs.items():
            verb = [] if arguments[0] == "lm628" else ["run"]
            done = subprocess.run([cls.program, *verb, *arguments, "-o", cls.folder / name],
                                  capture_output=True, text=True, check=False)
            assert done.returncode == (5 if name in TRIPPED else 0), done.stderr
        cls.driver = browser.start()

    @classmethod
    def tearDownClass(cls):
        cls.driver.quit()

    def setUp(self):
        browser.resize(self.driver, 1360)
        browser.prefer(self.driver, "light")

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, name, page="report.html"):
        browser.open_page(self.driver, self.folder / name / page)

    def drag(self, plot, begin, end):
        """Drags over parts of the plot's width."""
        from selenium.webdriver import ActionChains
        over = self.driver.find_element("css selector", f"[data-plot={plot}] .u-over")
        self.js("arguments[0].scrollIntoView({block: 'center'})", over)
        width = over.size["width"]
        ActionChains(self.driver, duration=20).move_to_element_with_offset(
            over, round((begin - 0.5) * width), 0).click_and_hold().move_by_offset(
            round((end - begin) * width), 0).release().perform()

    def until(self, holds):
        """The page answers the pointer and the system in its own time."""
        from selenium.webdriver.support.ui import WebDriverWait
        WebDriverWait(self.driver, 10, 0.05).until(lambda driver: holds())

    def ranges(self):
        return self.js("return Trammel.time.plots.map((p) => "
                       "[p.uplot.scales.x.min, p.uplot.scales.x.max])")

    def rows(self, name):
        run = json.loads((self.folder / name / "metrics.json").read_text())["run"]
        first = run.get("first_tick", 0)
        with open(self.folder / name / "trace.csv", newline="", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if int(row.get("tick", 0)) >= first]
        return rows[run.get("first_sample", 0):]


def main(cases, usage):
    if len(sys.argv) != 3 or sys.argv[1] in ("-h", "--help"):
        print(usage)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    browser.need(Path(sys.argv[0]).stem)
    cases.program, cases.folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(cases)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1
