#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine kung in headless Chromium: what holds for every machine, and
what a reader relies on: zoom and cursor are shared, also with the path, buttons save pictures, the
dark theme follows the system, runs are compared with the paper and with each other.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import browser
import report_pages


class Page(report_pages.ReportPages):
    runs = {
        "step": ["run", "step", "-s", "path.square_periods=2",
                 "-s", "path.square_half_samples=150", "-s", "run.reached_m=0.05"],
        "circle": ["run", "circle"],
        "small-fc": ["run", "circle", "-s", "controller=fc", "-s", "path.circle_ticks=60",
                     "-s", "path.circle_radius_m=0.01", "-s", "run.reached_m=0.02"],
        "response": ["run", "response", "-s", "path.sweep_tones=3", "-s", "run.engine=twin"],
        "trip": ["run", "circle", "-s", "path.circle_ticks=60", "-s", "path.circle_radius_m=0.01",
                 "-s", "inject.trip_s=0.05"],
    }
    tripped = {"trip"}
    compared = ("circle", "small-fc")
    values = {"circle": {"t_s": 1e-8, "x_position_m": 1e-8, "y_model_m": 1e-8, "x_i_q_ref": 0,
                         "y_force_N": 1e-3}}
    least_plots = 14
    least_saved = 30

    def test_zoom_is_shared_and_taken_back(self):
        from selenium.webdriver import ActionChains
        self.open("circle")
        whole = self.ranges()
        self.drag("current-x", 0.25, 0.5)
        self.until(lambda: self.ranges()[0] != whole[0])
        zoomed = self.ranges()
        self.assertTrue(all(r == zoomed[0] for r in zoomed))
        span = whole[0][1] - whole[0][0]
        self.assertAlmostEqual((zoomed[0][1] - zoomed[0][0]) / span, 0.25, delta=0.02)
        self.assertAlmostEqual((zoomed[0][0] - whole[0][0]) / span, 0.25, delta=0.02)
        over = self.driver.find_element("css selector", "[data-plot=error] .u-over")
        ActionChains(self.driver, duration=20).double_click(over).perform()
        self.until(lambda: self.ranges() == whole)
        self.drag("error", 0.6, 0.7)
        self.until(lambda: all(a != b for a, b in zip(self.ranges(), whole, strict=True)))
        self.driver.find_element("id", "zoom-reset").click()
        self.until(lambda: self.ranges() == whole)

    def test_the_cursor_is_shared(self):
        from selenium.webdriver import ActionChains
        cursors = "return Trammel.time.plots.map((p) => p.uplot.cursor.idx)"
        self.open("circle")
        over = self.driver.find_element("css selector", "[data-plot=error] .u-over")
        self.js("arguments[0].scrollIntoView({block: 'center'})", over)
        ActionChains(self.driver, duration=20).move_to_element_with_offset(over, 40, 5).perform()
        self.until(lambda: (self.js(cursors)[0] or 0) > 0)
        at = self.js(cursors)
        self.assertEqual(set(at), {at[0]})
        for legend in self.driver.find_elements("css selector", ".u-series:nth-child(2) .u-value"):
            self.assertRegex(legend.text, r"\d")
        self.assertEqual(len(self.driver.find_elements(
            "css selector", "[data-plot=path] .over circle")), 3)
        # The other way: a point of the path is the cursor of all plots.
        path = self.driver.find_element("css selector", "[data-plot=path] .plot")
        self.js("arguments[0].scrollIntoView({block: 'center'})", path)
        x, y = self.js("""const plot = Trammel.plots.find((p) => p.id === 'path');
            const c = plot.canvas, d = Trammel.page.runs[0].data;
            const f = plot.frame(c.clientWidth, c.clientHeight);
            return [f.x(d.table.x[700]) - c.clientWidth / 2,
                    f.y(d.table.y[700]) - c.clientHeight / 2]""")
        ActionChains(self.driver, duration=20).move_to_element_with_offset(
            path, round(x), round(y)).perform()
        self.until(lambda: abs((self.js(cursors)[0] or 0) - 700) <= 8)
        self.assertEqual(len(set(self.js(cursors))), 1)

    def test_the_buttons_download_files(self):
        from selenium.webdriver.support.ui import WebDriverWait
        target = (self.folder / "saved").resolve()
        target.mkdir(exist_ok=True)
        self.driver.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(target)})
        self.open("circle")
        for kind in ("svg", "png"):
            self.js("arguments[0].click()", self.driver.find_element(
                "css selector", f"[data-plot=error] [data-save={kind}]"))
            file = target / f"circle-error.{kind}"
            WebDriverWait(self.driver, 10, 0.05).until(
                lambda d, f=file: f.exists() and f.stat().st_size > 5000)

    def test_a_sweep_has_bode_plots_and_its_margins(self):
        self.open("response")
        plots = self.driver.find_elements("css selector", "[data-plot^=bode-] svg")
        self.assertEqual(len(plots), 4)
        tones = len(self.js("return Trammel.page.runs[0].detail.response.speed.x"))
        self.assertGreater(tones, 1)
        circles = self.driver.find_elements("css selector", "[data-plot=bode-speed-x] svg circle")
        self.assertEqual(len(circles), 4 * tones)  # gain and phase, closed and open
        crossover = self.metrics("response")["x"]["response"]["speed"]["crossover_Hz"]
        self.assertIn(f"{crossover:.2f}", self.driver.find_element("id", "response").text)
        self.assertEqual(browser.complaints(self.driver), [])

    def test_the_page_of_a_circle_is_below_a_megabyte(self):
        self.assertLess((self.folder / "circle" / "report.html").stat().st_size, 1_000_000)

    def test_dark_follows_the_system_and_the_button(self):
        ground = "return getComputedStyle(document.body).backgroundColor"
        self.open("circle")
        light = self.js(ground)
        browser.prefer(self.driver, "dark")
        self.until(lambda: self.js(ground) != light)
        self.driver.find_element("id", "theme").click()
        self.until(lambda: self.js(ground) == light)
        self.js("localStorage.clear()")
        self.assertEqual(browser.complaints(self.driver), [])

    def test_runs_are_compared(self):
        self.open(".", "compare.html")
        longest = len(self.rows("circle"))
        self.assertEqual(self.filled()[0], [longest, longest, len(self.rows("small-fc"))])
        text = self.driver.find_element("id", "parameters").text
        for changed in ("controller", "path.circle_ticks", "path.circle_radius_m"):
            self.assertIn(changed, text)
        self.assertNotIn("gains.x.kp", text)
        means = [self.metrics(name)["tracking"]["model"]["mean_mm"] for name in self.compared]
        more = means[1] - means[0]
        self.assertGreater(more, 0)  # a red difference: a larger error is worse
        row = self.driver.find_element("css selector", "#figures tbody tr")
        self.assertEqual(row.text.split(), ["T(k)", "to", "reference", "model,", "mean", "(mm)",
                                            f"{means[0]:.3f}", f"{means[1]:.3f}",
                                            f"+{more:.3f},", f"+{100 * more / means[0]:.1f}",
                                            "%"])
        self.assertEqual(len(row.find_elements("css selector", ".bad-text")), 1)
        judged = [f for f in self.metrics("circle")["figures"] if "expected" in f]
        self.assertGreater(len(judged), 2)
        table = self.driver.find_element("id", "judged").text
        self.assertEqual(table.count("within"), len(judged))
        self.assertIn("Not reproduced", table)
        links = [a.get_attribute("href") for a in self.driver.find_elements(
            "css selector", "#figures a")]
        self.assertEqual([link.split("/")[-2] for link in links], ["circle", "small-fc"])
        self.assertEqual(browser.complaints(self.driver), [])


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
