#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine kung in headless Chromium: what holds for every machine, and
what a reader relies on: zoom and cursor are shared, also with the path, buttons save pictures, the
dark theme follows the system, runs are compared with the paper and with each other.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import csv
import json
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import drawn_page
import sample_page

import browser
import report_pages


class Page(drawn_page.DrawnPage, sample_page.SamplePage, report_pages.ReportPages):
    runs = {
        "step": ["run", "step", "-s", "path.square_periods=2",
                 "-s", "path.square_half_samples=150", "-s", "run.reached_m=0.05"],
        "circle": ["run", "circle"],
        "small-fc": ["run", "circle", "-s", "controller=fc", "-s", "path.circle_ticks=60",
                     "-s", "path.circle_radius_m=0.01", "-s", "run.reached_m=0.02",
                     "-s", "plant.x.coulomb_N=2.9"],
        "response": ["run", "response", "-s", "path.sweep_tones=3", "-s", "run.engine=twin"],
        "precision": ["run", "circle", "-s", "controller=precision", "-s", "path.repeats=2",
                      "-s", "path.circle_radius_m=0.03", "-s", "plant.cogging_N=3",
                      "-s", "plant.y.payload_kg=2", "-s", "path.y.accel_m_s2=6",
                      "--engine", "twin"],
        "trip": ["run", "circle", "-s", "path.circle_ticks=60", "-s", "path.circle_radius_m=0.01",
                 "-s", "inject.fault=trip_pin", "-s", "inject.begin_s=0.05"],
    }
    tripped = {"trip"}
    compared = ("circle", "small-fc")
    values = {"circle": {"t_s": 1e-8, "x_position_m": 1e-8, "y_model_m": 1e-8, "x_i_q_ref": 0,
                         "y_force_N": 1e-3}}
    least_plots = 14
    least_saved = 30
    # A count of 5 um in 16 parts a tick of 0.5 ms; 9.6 A are 2048, of i_q* 4096; 311 V; a unit 256.
    drawn = {"circle": {
        "error": {"T(k)": (lambda row, _: 1e3 * math.hypot(*(row[f"{a}_model_m"] -
                                                            row[f"{a}_position_m"] for a in "xy")),
                           2e-5),
                  **{a: (lambda row, _, a=a: 1e3 * (row[f"{a}_model_m"] - row[f"{a}_position_m"]),
                         2e-5) for a in "xy"}},
        "contour": {"contour": (lambda row, _: 1e3 * abs(math.hypot(
            *(row[f"{a}_position_m"] - 0.25 for a in "xy")) - 0.1), 5e-3),  # chords, not arcs
            "distance from the command": (
            lambda row, _: 1e3 * math.hypot(*(row[f"{a}_command_m"] - row[f"{a}_position_m"]
                                              for a in "xy")), 2e-5)},
        "position-{a}": {"command": ("{a}_command_m", 1e3), "reference": ("{a}_model_m", 1e3),
                         "table": ("{a}_position_m", 1e3)},
        "speed-{a}": {"v*": ("{a}_v_star", 6.25e-4), "v (encoder)": ("{a}_v", 6.25e-4),
                      "v (plant)": "{a}_v_m_s"},
        "current-{a}": {"i_q*": ("{a}_i_q_ref", 9.6 / 4096), "i_q": ("{a}_i_q", 9.6 / 2048),
                        "i_d": ("{a}_i_d", 9.6 / 2048), "i_q (plant)": "{a}_i_q_A",
                        "i_d (plant)": "{a}_i_d_A"},
        "voltage-{a}": {"v_q": ("{a}_v_q", 311 / 3 ** 0.5 / 2048),
                        "v_d": ("{a}_v_d", 311 / 3 ** 0.5 / 2048)},
        "fuzzy-{a}": {"u": ("{a}_u", 1 / 256)}, "force-{a}": {"force": "{a}_force_N"}}}
    better_small = ("tracking.model.mean_mm tracking.model.std_mm tracking.model.variance_mm2 "
                    "tracking.model.rms_mm tracking.model.max_mm tracking.command.mean_mm "
                    "contour.mean_mm contour.max_mm")
    colors_drawn = {"circle": {
        "to reference": ("table, error (mm)", (lambda row, _: 1e3 * math.hypot(
            *(row[f"{a}_model_m"] - row[f"{a}_position_m"] for a in "xy")), 2e-5)),
        "to path": ("table, contour (mm)", (lambda row, _: 1e3 * abs(math.hypot(
            *(row[f"{a}_position_m"] - 0.25 for a in "xy")) - 0.1), 5e-3))}}  # chords, not arcs
    paths_drawn = {"circle": tuple((f"{{a}}_{name}_m", 1e3) for name in
                                   ("command", "model", "position", "model"))}

    def idle(self, key, options):
        kind = re.match(r"path\.(circle|window|star|square|line|points|sweep|gcode)_", key)
        return kind is not None and kind[1] != options["path.kind"]

    def asides(self, metrics):
        found = {"tracking.model.max_mm": "to the reference model"}
        for key, digits in (("peak_current_A", 2), ("max_speed_m_s", 3)):
            found[key] = ", ".join(f"{a.upper()} {metrics[a][key]:.{digits}f}" for a in "xy")
        if "contour" in metrics:
            found["contour.mean_mm"] = f"largest {metrics['contour']['max_mm']:.3f}"
        if "contour_um" in metrics:
            found["contour_um.mean"] = f"largest {metrics['contour_um']['max']:.2f}"
        for axis in "xy":
            periods = metrics[axis].get("periods", [])
            found[f"{axis}.periods.{len(periods) - 1}.overshoot_percent"] = \
                f"last period; first {periods[0]['overshoot_percent']:.1f}" if periods else ""
        return found

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
        self.see("response")
        plots = self.driver.find_elements("css selector", "[data-plot^=bode-] svg")
        self.assertEqual(len(plots), 4)
        tones = len(self.js("return Trammel.page.runs[0].detail.response.speed.x"))
        self.assertGreater(tones, 1)
        circles = self.driver.find_elements("css selector", "[data-plot=bode-speed-x] svg circle")
        self.assertEqual(len(circles), 4 * tones)  # gain and phase, closed and open
        crossover = self.metrics("response")["x"]["response"]["speed"]["crossover_Hz"]
        self.assertIn(f"{crossover:.2f}", self.driver.find_element("id", "response").text)

    def plot(self, name, then):
        """Of the plot with that id."""
        return self.js(f"return ((p) => {then})(Trammel.plots.find((p) => p.id === arguments[0]))",
                       name)

    def precise(self):
        """Rows of precision.csv that the page shows."""
        first = len(self.table("trace")) - len(self.rows("precision"))
        return self.table("precision")[first:]

    def table(self, name):
        with open(self.folder / "precision" / f"{name}.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_a_precision_page_has_its_errors_in_micrometres(self):
        self.see("precision")
        rows = self.precise()
        counted = [row for row in rows if row["counted"] == "1"]
        self.assertGreater(len(rows), len(counted))
        for axis in "xy":
            lines = self.lines(f"precision-{axis}")
            for shown, row in zip(lines["error"], rows, strict=True):
                self.assertAlmostEqual(shown, float(row[f"{axis}_error_um"]), delta=0.00051)
            self.assertEqual(set(lines["one count"]), {5})
            # As many samples in the bins as figures count, and where they are.
            bins = self.plot("histogram", f"p.bins.{axis}")
            self.assertAlmostEqual(sum(bins), 100, places=6)
            self.assertGreater(sum(bins[15:46]), 90)
        distance = self.lines("precision-both")["distance"]
        mean = sum(d for d, row in zip(distance, rows, strict=True) if row["counted"] == "1")
        error = self.metrics("precision")["error_um"]
        self.assertAlmostEqual(mean / len(counted), error["mean"], delta=1e-3)
        self.assertEqual(self.plot("laps", "p.title"), "Mean error of each lap")

    def test_the_contour_error_is_drawn_at_least_2000_times_larger(self):
        self.see("precision")
        card = self.driver.find_element("css selector", "[data-plot=contour-large]")
        factors = card.find_elements("css selector", ".segments button")
        self.assertEqual(factors[0].text, "\u00d72\u2009000")
        chosen = [f.text for f in factors if f.get_attribute("aria-pressed") == "true"]
        self.assertEqual(len(chosen), 1)
        self.assertIn(f"10 \u00b5m, {chosen[0]}", card.text)
        # The largest distance is that of the figures but for what the nearest place makes of it.
        top = self.plot("contour-large", "p.top()")
        most = self.metrics("precision")["contour_um"]["max"]
        self.assertAlmostEqual(top, most, delta=0.02 * most + 0.01)

    def test_the_bar_of_10_um_has_the_length_of_such_an_error_as_it_is_drawn(self):
        self.open("precision")
        card = self.driver.find_element("css selector", "[data-plot=contour-large]")
        factors = card.find_elements("css selector", ".segments button")
        self.assertGreater(len(factors), 2)
        for button in factors:
            self.js("arguments[0].click()", button)
            bars, pixels = self.js("""const plot = Trammel.plots.find((p) => p.id === arguments[0]);
                const c = plot.canvas, f = plot.frame(c.clientWidth, c.clientHeight);
                const ink = Trammel.theme().ink;  // of the bar alone
                return [[...c.querySelectorAll(`svg path[stroke="${ink}"]`)].map((path) =>
                  path.getAttribute('d').slice(1).split(' ').map(Number)), f.x(0.01) - f.x(0)]""",
                                   "contour-large")
            factor = int(button.text.removeprefix("\u00d7").replace("\u2009", ""))
            with self.subTest(factor=factor):
                self.assertEqual(len(bars), 1)
                (left, top, right, bottom), = bars
                self.assertEqual(top, bottom)
                self.assertAlmostEqual(right - left, factor * pixels, delta=0.02)

    def test_the_spectrum_has_marks_where_speed_puts_them(self):
        self.see("precision")
        rows = [row for row in self.precise() if row["counted"] == "1"]
        for axis in "xy":
            speeds = [abs(float(row[f"{axis}_command_m_s"])) for row in rows]
            marks = self.plot(f"spectrum-{axis}", "p.marks")
            self.assertEqual([mark[0] for mark in marks], ["electrical", "cogging"])
            for (_, low, high), times in zip(marks, (0.5, 1), strict=True):
                self.assertAlmostEqual(low, sum(speeds) / len(speeds) * times / 30.5e-3, places=2)
                self.assertAlmostEqual(high, max(speeds) * times / 30.5e-3, places=2)
            self.assertEqual(self.js("return Trammel.page.runs[0].detail.spectrum."
                                     f"{axis}.length"), 1025)

    def test_parts_of_the_current_make_its_sum(self):
        self.see("precision")
        rows = [row["counted"] == "1" for row in self.precise()]
        for axis in "xy":
            lines = self.lines(f"parts-{axis}")
            self.assertEqual(set(lines), {"i_q*", "acceleration", "speed", "friction", "IFF",
                                          "feedback"})
            whole = lines.pop("i_q*")
            self.assertGreater(max(whole), 0.1)
            for k, parts in enumerate(zip(*lines.values(), strict=True)):
                if rows[k]:
                    self.assertAlmostEqual(sum(parts), whole[k], delta=2e-3)
            limit = {"x": 8, "y": 6}[axis]
            self.assertLessEqual(max(self.lines(f"command-accel-{axis}")["command"]),
                                 1.0125 * limit)
            self.assertEqual(set(self.lines(f"command-accel-{axis}")["limit"]), {-limit})
        self.assertEqual(set(self.lines("command-speed")["limit"]), {0.5})

    def test_estimates_stand_beside_the_plant(self):
        self.see("precision")
        for axis, mass, friction in (("x", 2.5, 3), ("y", 10, 4.8)):
            lines = self.lines(f"estimate-mass-{axis}")
            self.assertEqual(set(lines["plant"]), {mass})
            self.assertAlmostEqual(lines["estimate"][-1], mass, delta=0.12 + 0.01 * mass)
            self.assertEqual(set(self.lines(f"estimate-coulomb-{axis}")["plant"]), {friction})
            lines = self.lines(f"estimate-force-{axis}")
            self.assertGreater(max(lines["plant"]), 2.9)  # the cogging of 3 N
            half = len(lines["plant"]) // 2
            apart = [abs(a - b) for a, b in zip(lines["plant"][half:], lines["estimate"][half:],
                                                strict=True)]
            self.assertLess(sum(apart) / len(apart), 1)

    def test_the_other_controllers_stand_beside_it(self):
        self.see("precision")
        metrics = self.metrics("precision")
        rows = [row.text for row in self.driver.find_elements("css selector", "#beside tbody tr")]
        self.assertEqual([row.split(",")[0] for row in rows], ["precision", "AFC", "FC"])
        self.assertIn(f"{metrics['error_um']['mean']:.2f}", rows[0])
        for name, row in zip(("AFC", "FC"), rows[1:], strict=True):
            mean = metrics["compared"][name]["error_um"]["mean"]
            self.assertGreater(mean, 1000)
            self.assertIn(f"{mean:,.0f}".replace(",", "\u2009"), row)

    def test_a_precision_page_is_made_again_from_its_files(self):
        page = (self.folder / "precision" / "report.html").read_bytes()
        self.report("precision", page="again.html")
        self.assertEqual((self.folder / "again.html").read_bytes(), page)

    def test_the_page_of_a_circle_is_below_a_megabyte(self):
        for name in ("circle", "precision"):
            self.assertLess((self.folder / name / "report.html").stat().st_size, 1_000_000)

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
        self.see(".", "compare.html")
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

    def test_runs_differ_from_half_of_the_last_digit_on_that_is_shown(self):
        page = (self.folder / "compare.html").read_text(encoding="utf-8")
        head, begin, rest = page.partition('id="run-data">')
        text, end, tail = rest.partition("</script>")
        for part, told, tone in ((0.45, "=", ""), (-0.45, "=", ""), (0.55, "+0.001", "bad-text"),
                                 (-0.55, "\u22120.001", "good-text")):
            data = json.loads(text)
            means = [next(f for f in run["metrics"]["figures"]
                          if f["id"] == "tracking.model.mean_mm") for run in data["runs"]]
            self.assertEqual(means[0]["digits"], 3)
            means[1]["value"] = means[0]["value"] + part * 1e-3
            (self.folder / "near.html").write_text(
                head + begin + json.dumps(data).replace("<", "\\u003c") + end + tail,
                encoding="utf-8")
            self.open(".", "near.html")
            small = self.driver.find_element("css selector", "#figures tbody tr small")
            with self.subTest(part=part):
                self.assertEqual(small.text.split(",")[0], told)
                self.assertEqual(small.get_attribute("class") or "", tone)
        self.assertEqual(browser.complaints(self.driver), [])


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
