#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open real report pages in headless Chromium and check what a reader relies on: every plot holds
the data of the run's files, zoom and cursor are shared, pictures can be saved, nothing is loaded
from elsewhere, dark and narrow pages fit.

usage: report_page_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import base64
import json
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
import browser  # noqa: E402
import report_pages  # noqa: E402

RUNS = {  # folder: arguments
    "circle": ["circle"],
    "small-fc": ["circle", "-s", "controller=fc", "-s", "path.circle_ticks=60",
                 "-s", "path.circle_radius_m=0.01"],
    "step": ["step", "-s", "path.square_periods=2", "-s", "path.square_half_samples=150"],
    "trip": ["circle", "-s", "path.circle_ticks=60", "-s", "path.circle_radius_m=0.01",
             "-s", "inject.trip_s=0.05"],
    "an693": ["an693-tuning", "-s", "trajectory.steps=2"],
    "script": ["lm628", "tuning"],
    **report_pages.MCAFEE,
}


class Page(report_pages.ReportPages):
    runs = RUNS

    def test_every_plot_holds_the_data_of_the_files(self):
        for name in RUNS:
            self.open(name)
            rows = self.rows(name)
            series = self.js("return Trammel.time.plots.filter((p) => !p.times).map((p) => "
                             "p.uplot.data.map((s) => "
                             "[s.length, [...s].filter(Number.isFinite).length]))")
            self.assertGreaterEqual(len(series), 13 if "x_model_m" in rows[0] else 6)
            for plot in series:
                for length, finite in plot:
                    self.assertEqual((length, finite), (len(rows), len(rows)), name)
            self.assertEqual(browser.complaints(self.driver), [], name)
            for plot in self.js("return Trammel.plots.map((p) => [p.id, p.count()])"):
                self.assertGreater(plot[1], 0, plot[0])

    def test_values_are_those_of_the_trace(self):
        for run, lsb in (
                ("circle", {"t_s": 1e-8, "x_position_m": 1e-8, "y_model_m": 1e-8, "x_i_q_ref": 0,
                            "y_force_N": 1e-3}),
                ("an693", {"t_s": 1e-8, "desired_count": 1e-3, "theta_count": 1e-3, "p": 0,
                           "status": 0, "host_irq": 0, "omega_rad_s": 1e-4, "u_V": 1e-4}),
                ("mcafee", {"t_s": 1e-8, "row": 0, "v": 0, "contour_mm": 1e-5, "x_mm": 1e-5,
                            "y_mm_s": 1e-3, "x_desired_count": 1e-3, "y_desired_speed": 1e-5,
                            "x_p": 0, "y_i": 0, "x_d": 0, "y_status": 0, "x_u_V": 1e-4})):
            self.open(run)
            rows = self.rows(run)
            for name, step in lsb.items():
                column = [float(row[name]) for row in rows]
                values = self.js("return [...Trammel.page.runs[0].series[arguments[0]]]", name)
                worst = max(abs(a - b) for a, b in zip(column, values, strict=True))
                self.assertLessEqual(worst, 0.5001 * step, f"{run} {name}")

    def test_the_page_of_an_lm628_tells_its_interrupts_and_script(self):
        self.open("an693")
        metrics = json.loads((self.folder / "an693" / "metrics.json").read_text())
        self.assertEqual(self.js("return Trammel.time.marks"),
                         [one["time_s"] for one in metrics["interrupts"]])
        table = self.driver.find_element("id", "status").text
        self.assertEqual(table.count("trajectory complete"), len(metrics["interrupts"]))
        self.assertIn("First step settled", self.driver.find_element("id", "figures").text)
        self.open("script")
        script = self.driver.find_element("id", "script").text
        for line in ("LTRJ 0003h -50", "RDRP", "00000030h 48 counts"):
            self.assertIn(line, script)
        self.assertNotIn("filter", self.driver.find_element("id", "parameters").text)

    def test_runs_of_an_lm628_are_compared(self):
        page = self.folder / "compare_an693.html"
        subprocess.run([self.program, "report", self.folder / "an693", self.folder / "script",
                        "-o", page], check=True, capture_output=True)
        self.open(".", page.name)
        filled = self.js("return Trammel.time.plots.map((p) => p.uplot.data.map((s) => "
                         "[...s].filter((v) => v !== null).length))")
        lengths = [len(self.rows(name)) for name in ("an693", "script")]
        self.assertEqual(filled, [[max(lengths), *lengths]] * 4)
        self.assertEqual(browser.complaints(self.driver), [])

    def test_every_plot_is_painted(self):
        for name in ("circle", "trip", "an693", "mcafee", "move"):
            self.open(name)
            for canvas in self.driver.find_elements("css selector", ".plot canvas:not(.over)"):
                self.assertGreater(self.js(report_pages.PAINTED, canvas), 3)

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
        self.assertGreater(self.js(report_pages.PAINTED, self.driver.find_element(
            "css selector", "[data-plot=path] .over")), 3)
        # The other way: a point of the path is the cursor of all plots.
        path = self.driver.find_element("css selector", "[data-plot=path] canvas")
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

    def test_every_plot_can_be_saved(self):
        seen = set()
        for name in ("circle", "step", "small-fc", "an693", "mcafee"):
            self.open(name)
            plots = set(self.js("return Trammel.plots.map((p) => p.id)")) - seen
            seen |= plots
            for plot in sorted(plots):
                text = self.js("return Trammel.svgText(Trammel.plots.find((p) => "
                               "p.id === arguments[0]))", plot)
                root = ElementTree.fromstring(text)
                marks = [e for e in root.iter() if e.tag.endswith(("path", "rect", "text"))]
                self.assertGreater(len(marks), 12, plot)
                self.assertNotIn("NaN", text, plot)
                url, colors = self.driver.execute_async_script("""
                    const [id, done] = arguments;
                    (async () => {
                      const blob = await Trammel.pngBlob(Trammel.plots.find((p) => p.id === id));
                      const image = await createImageBitmap(blob);
                      const canvas = new OffscreenCanvas(image.width, image.height);
                      canvas.getContext('2d').drawImage(image, 0, 0);
                      const seen = (function () {""" + report_pages.PAINTED + """})(canvas);
                      const reader = new FileReader();
                      reader.onload = () => done([reader.result, seen]);
                      reader.readAsDataURL(blob);
                    })();""", plot)
                data = base64.b64decode(url.split(",")[1])
                self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n", plot)
                self.assertGreater(struct.unpack(">I", data[16:20])[0], 1200, plot)
                self.assertGreater(colors, 4, plot)
            self.assertEqual(browser.complaints(self.driver), [])
        self.assertGreater(len(seen), 25)

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

    def test_nothing_is_loaded_from_elsewhere(self):
        for name in RUNS:
            browser.requests(self.driver)
            self.open(name)
            page = (self.folder / name / "report.html").resolve().as_uri()
            foreign = [url for url in browser.requests(self.driver)
                       if url != page and not url.startswith(("data:", "blob:"))]
            self.assertEqual(foreign, [])

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

    def test_no_width_overflows(self):
        comparison = self.folder / "compare.html"
        subprocess.run([self.program, "report", self.folder / "circle", self.folder / "small-fc",
                        "-o", comparison], check=True, capture_output=True)
        for name, page in [*((name, "report.html") for name in RUNS), (".", "compare.html")]:
            for width in (390, 768, 1360):
                browser.resize(self.driver, width)
                self.open(name, page)
                self.js("for (const d of document.querySelectorAll('details')) d.open = true")
                self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), width,
                                     f"{name}/{page} at {width}")

    def test_runs_are_compared(self):
        page = self.folder / "compare.html"
        subprocess.run([self.program, "report", self.folder / "circle", self.folder / "small-fc",
                        "-o", page], check=True, capture_output=True)
        self.open(".", "compare.html")
        longest = len(self.rows("circle"))
        filled = self.js("return Trammel.time.plots[0].uplot.data.map((s) => "
                         "[...s].filter((v) => v !== null).length)")
        self.assertEqual(filled, [longest, longest, len(self.rows("small-fc"))])
        text = self.driver.find_element("id", "parameters").text
        for changed in ("controller", "path.circle_ticks", "path.circle_radius_m"):
            self.assertIn(changed, text)
        self.assertNotIn("gains.x.kp", text)
        links = [a.get_attribute("href") for a in self.driver.find_elements(
            "css selector", "#figures a")]
        self.assertEqual([link.split("/")[-2] for link in links], ["circle", "small-fc"])
        self.assertEqual(browser.complaints(self.driver), [])

    def test_print_has_a_picture_of_every_plot(self):
        browser.prefer(self.driver, "dark")
        self.open("step")
        plots = self.js("return Trammel.plots.length")
        self.js("window.seen = 0; window.addEventListener('beforeprint', () => {"
                "  seen = document.querySelectorAll('.card > .print-only svg').length; });")
        pdf = base64.b64decode(self.driver.execute_cdp_cmd("Page.printToPDF", {})["data"])
        self.assertEqual(pdf[:5], b"%PDF-")
        self.assertEqual(self.js("return seen"), plots)
        self.assertEqual(self.js("return document.querySelectorAll('.print-only').length"), 0)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
