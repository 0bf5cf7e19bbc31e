# SPDX-License-Identifier: Apache-2.0
"""Report pages of fresh runs, opened in headless Chromium: what holds for every machine. The test
of a machine derives from it and names the runs; it tests itself what only its page shows."""

import base64
import csv
import json
import math
import re
import shutil
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

import browser
import checks
import drawing
import page_looks
import page_tables

MACHINES = Path(__file__).resolve().parents[2] / "machines"
PAINTED = """
  const canvas = arguments[0];
  const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const seen = new Set();
  for (let k = 0; k < data.length; k += 4) {
    if (data[k + 3] > 0) seen.add(data[k] << 16 | data[k + 1] << 8 | data[k + 2]);
    if (seen.size > 8) break;
  }
  return seen.size;
"""


def figure_text(figure):
    """As the page writes a figure: a whole number in groups of three digits, or with its digits."""
    if "digits" in figure:
        step = Decimal(1).scaleb(-figure["digits"])
        value = Decimal(figure["value"]).quantize(step, ROUND_HALF_UP)
        text = str(abs(value) if value == 0 else value)
    else:
        text = f"{figure['value']:,}".replace(",", "\u2009")
    return text.replace("-", "\u2212")


def unit_text(unit):
    """m/s2 with its exponent raised, um with a Greek letter."""
    raised = re.sub(r"(?<=[A-Za-z])[23]\b", lambda m: "\u00b2\u00b3"[int(m[0]) - 2], unit)
    return re.sub(r"\bum\b", "\u00b5m", raised)


def title_of(figure):
    name = figure["name"] + (f" ({unit_text(figure['unit'])})" if figure["unit"] else "")
    return name[0].upper() + name[1:]


def numbers(cell):
    return [float(n) for n in re.findall(r"-?[0-9.]+", cell.replace("\u2212", "-"))]


def given(figure, name):
    return [float(figure[name])] if name in figure else []


class ReportPages(drawing.Drawing, page_looks.Looks, page_tables.Tables, unittest.TestCase):
    runs = {}         # folder: arguments of the program
    tripped = set()   # those of them that end with exit 5
    compared = ()     # two or more of them, for compare.html
    values = {}       # folder: {column of its trace: step of its values on the page, 0 if exact}
    least_plots = 1   # over time, of any of the runs
    least_saved = 1   # plots of all kinds, of all runs together
    program, folder, driver = None, None, None
    machines = MACHINES
    seen = {}         # page that is open in a window of its own: window, complaints, requests

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)
        for name, arguments in cls.runs.items():
            cls.make(name, arguments, 5 if name in cls.tripped else 0)
        cls.report(*cls.compared)
        cls.driver = browser.start()
        cls.window, cls.seen = cls.driver.current_window_handle, {}

    @classmethod
    def tearDownClass(cls):
        cls.driver.quit()

    @classmethod
    def make(cls, name, arguments, code=0):
        done = subprocess.run([cls.program, *arguments, "-o", cls.folder / name],
                              capture_output=True, text=True, check=False)
        assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stderr}"

    @classmethod
    def report(cls, *names, page="compare.html", code=0):
        """Compares runs; what the program said on stderr."""
        done = subprocess.run([cls.program, "report", *(cls.folder / name for name in names), "-o",
                               cls.folder / page], capture_output=True, text=True, check=False)
        assert done.returncode == code, f"{names}: exit {done.returncode}\n{done.stderr}"
        return done.stderr

    def setUp(self):
        self.driver.switch_to.window(self.window)
        browser.resize(self.driver, 1360)
        browser.prefer(self.driver, "light")

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, name, page="report.html"):
        """Loads a page, for a test that changes it."""
        self.driver.switch_to.window(self.window)
        browser.open_page(self.driver, self.folder / name / page)

    def see(self, name, page="report.html"):
        """A page of which a test changes nothing: loaded once, in a window that the others share;
        what it complained of and what it asked for then."""
        file = (self.folder / name / page).resolve()
        if file not in self.seen:
            self.driver.switch_to.new_window("window")
            browser.resize(self.driver, 1360)
            browser.prefer(self.driver, "light")
            browser.complaints(self.driver)
            browser.requests(self.driver)
            browser.open_page(self.driver, file)
            foreign = [url for url in browser.requests(self.driver)
                       if url != file.as_uri() and not url.startswith(("data:", "blob:"))]
            self.seen[file] = (self.driver.current_window_handle,
                               browser.complaints(self.driver), foreign)
        window, *said = self.seen[file]
        self.driver.switch_to.window(window)
        return said

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

    def filled(self):
        """Of each plot over time: how many values its base and each of its lines have."""
        return self.js("return Trammel.time.plots.map((p) => p.uplot.data.map((s) => "
                       "[...s].filter((v) => v !== null).length))")

    def metrics(self, name):
        return json.loads((self.folder / name / "metrics.json").read_text())

    def rows(self, name):
        run = self.metrics(name)["run"]
        first = run.get("first_tick", 0)
        with open(self.folder / name / "trace.csv", newline="", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if int(row.get("tick", 0)) >= first]
        return rows[run.get("first_sample", 0):]

    def check_painted(self, name):
        for canvas in self.driver.find_elements("css selector", ".plot canvas"):
            self.assertGreater(self.js(PAINTED, canvas), 3, name)
        for shapes in self.js("return [...document.querySelectorAll('.plot > :not(.over) > svg')]"
                              ".map((svg) => svg.innerHTML)"):
            self.assertNotEqual(shapes, "", name)
            self.assertNotIn("NaN", shapes, name)

    def check_tiles(self, metrics):
        shown = self.js("return [...document.querySelectorAll('.tile')].map((tile) => "
                        "[tile.children[0].textContent, tile.children[1].firstChild.textContent, "
                        "tile.querySelector('small').textContent])")
        self.assertEqual(shown, [[f["tile"], figure_text(f), unit_text(f["unit"])]
                                 for f in metrics["figures"] if "tile" in f])

    def test_every_plot_holds_the_data_of_the_files(self):
        for name in self.runs:
            self.see(name)
            count = len(self.rows(name))
            series = self.js("return Trammel.time.plots.filter((p) => !p.times).map((p) => "
                             "p.uplot.data.map((s) => "
                             "[s.length, [...s].filter(Number.isFinite).length]))")
            self.assertGreaterEqual(len(series), self.least_plots)
            for plot in series:
                for length, finite in plot:
                    self.assertEqual((length, finite), (count, count), name)

    def test_values_are_those_of_the_trace(self):
        self.assertNotEqual(self.values, {})
        for run, steps in self.values.items():
            self.see(run)
            rows = self.rows(run)
            for name, step in steps.items():
                column = [float(row[name]) for row in rows]
                values = self.js("return [...Trammel.page.runs[0].series[arguments[0]]]", name)
                worst = max(abs(a - b) for a, b in zip(column, values, strict=True))
                self.assertLessEqual(worst, 0.5001 * step, f"{run} {name}")

    def test_tiles_and_tables_hold_the_figures(self):
        for name in self.runs:
            self.see(name)
            metrics = self.metrics(name)
            self.check_tiles(metrics)
            cells = set(self.js("return [...document.querySelectorAll('td')].map((cell) => "
                                "cell.textContent)"))
            for figure in metrics["figures"]:
                if figure.get("shown", True):
                    self.assertIn(figure_text(figure), cells, f"{name} {figure['id']}")
            judged = [f for f in metrics["figures"] if "printed" in f or "expected" in f]
            within = {True: "within", False: "outside", None: "\u2013"}
            section = self.driver.find_element("id", "figures")
            marks = self.js("return [...arguments[0].querySelectorAll('tr')].filter((row) => "
                            "row.cells.length === 7).slice(1).map((row) => "
                            "[...row.cells].slice(0, 6).map((cell) => cell.textContent))", section)
            self.assertEqual([[row[0], row[1], row[5]] for row in marks],
                             [[title_of(f), figure_text(f), within[f.get("within")]]
                              for f in judged])
            for figure, row in zip(judged, marks, strict=True):
                self.check_source(figure, *row[2:5])
            for source in {f["source"] for f in judged if "source" in f}:
                self.assertIn(source[1:], section.text)  # it begins with a capital there

    def check_source(self, figure, printed, difference, expected):
        """The source's value, by how much ours is off it, and what is expected."""
        self.assertEqual(numbers(printed), given(figure, "printed"), figure["id"])
        self.assertEqual(numbers(expected)[:1], given(figure, "expected"), figure["id"])
        for text, band in zip(re.findall(r"\u00b1 ([0-9.]+)", expected), given(
                figure, "tolerance"), strict=True):
            self.assertAlmostEqual(float(text), band, delta=0.501 * 10 ** -len(
                text.partition(".")[2]), msg=figure["id"])
        off = [(figure["value"] / figure["printed"] - 1) * 100] if figure.get("printed") else []
        self.assertEqual(len(numbers(difference)), len(off), figure["id"])
        for shown, wanted in zip(numbers(difference), off, strict=True):
            self.assertAlmostEqual(shown, wanted, delta=0.0501, msg=figure["id"])

    def test_every_plot_is_painted(self):
        for name in self.runs:
            self.see(name)
            self.check_painted(name)

    def test_every_plot_can_be_saved(self):
        seen = set()
        for name in self.runs:
            self.see(name)
            plots = set(self.js("return Trammel.plots.map((p) => p.id)")) - seen
            seen |= plots
            for plot in sorted(plots):
                self.check_pictures(plot)
            self.assertEqual(browser.complaints(self.driver), [])
        self.assertGreaterEqual(len(seen), self.least_saved)

    def check_pictures(self, plot):
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
              const seen = (function () {""" + PAINTED + """})(canvas);
              const reader = new FileReader();
              reader.onload = () => done([reader.result, seen]);
              reader.readAsDataURL(blob.slice(0, 24));
            })();""", plot)
        data = base64.b64decode(url.split(",")[1])
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n", plot)
        self.assertGreater(struct.unpack(">I", data[16:20])[0], 1200, plot)
        self.assertGreater(colors, 4, plot)

    def test_a_page_complains_of_nothing_and_loads_nothing_from_elsewhere(self):
        for name, page in [(name, "report.html") for name in self.runs] + [(".", "compare.html")]:
            self.assertEqual(self.see(name, page), [[], []], name)

    def test_runs_of_two_machines_are_not_compared(self):
        own = next(iter(self.runs))
        others = sorted(path for path in MACHINES.glob("*/scenarios/*.toml")
                        if path.parts[-3] != self.metrics(own)["machine"])
        if not others:
            self.skipTest("there is one machine")
        self.make("other", ["run", others[0].stem, "-s", "run.max_s=0.002"], 5)
        said = self.report(own, "other", page="mixed.html", code=2)
        self.assertIn("only runs of one machine can be compared", said)
        self.assertFalse((self.folder / "mixed.html").exists())

    def plain(self, name, page):
        """The page as it would be if the machine had no page of its own."""
        text = (self.folder / name / page).read_text(encoding="utf-8")
        machine = f'"machine":"{self.metrics(next(iter(self.runs)))["machine"]}"'
        self.assertIn(machine, text)
        (self.folder / name / f"plain_{page}").write_text(
            text.replace(machine, '"machine":"none"', 1), encoding="utf-8")
        browser.complaints(self.driver)
        self.check_widths(name, f"plain_{page}")
        self.assertEqual(browser.complaints(self.driver), [])

    def test_a_machine_needs_no_page_of_its_own(self):
        lines = ("return Trammel.time.plots.flatMap((p) => p.series.map((s, k) => [s.label, "
                 "p.uplot.root.querySelectorAll('.u-series')[k + 1].title, s.data.length]))")
        for name in self.runs:
            self.plain(name, "report.html")
            metrics, count = self.metrics(name), len(self.rows(name))
            channels = self.js("return Trammel.page.runs[0].channels")
            self.assertEqual(sorted(self.js(lines)), sorted(
                [one["name"], one["help"], count] for one in channels if one["unit"] != "s"))
            self.check_columns(channels)
            self.check_tiles(metrics)
            listed = self.js("return [...document.querySelectorAll('#figures td')].map((cell) => "
                             "cell.textContent)")
            for figure in metrics["figures"]:
                if figure.get("shown", True):
                    self.assertIn(figure_text(figure), listed, f"{name} {figure['id']}")
            self.assertGreater(len(self.js("return [...document.querySelectorAll("
                                           "'#parameters tr[data-find]')]")), 20)
            self.check_painted(name)

    def check_columns(self, channels):
        """Each line is its column, beside others of its unit alone; words stand in steps."""
        told = [[cell for cell, *_ in row] for row in self.rows_of("#columns tbody tr")]
        self.assertEqual(told, [[one["name"], unit_text(one["unit"]), one["help"]]
                                for one in channels])
        by_name = {one["name"]: one for one in channels}
        for units, labels in self.js("""const s = Trammel.page.runs[0].series;
                return Trammel.time.plots.map((p) => [p.yLabel, p.series.map((one) => [one.label,
                  one.unit, one.digits, !!one.steps, one.data === s[one.label], one.run])])"""):
            for label, unit, digits, steps, own, _ in labels:
                channel = by_name[label]
                self.assertEqual((unit, steps, own), (unit_text(channel["unit"]), channel["lsb"]
                                                      == 1, True), label)
                self.assertIn(units, (unit, ""), label)
                self.assertEqual(digits, min(6, max(0, round(-math.log10(channel["lsb"]) + 0.49))),
                                 label)
            self.assertEqual(len({one[1] for one in labels}), 1)
            self.assertEqual(len({one[5] for one in labels}), len(labels))  # colors

    def test_runs_of_a_machine_without_a_page_are_compared(self):
        self.plain(".", "compare.html")
        titles = self.js("return Trammel.time.plots.map((p) => p.title)")
        channels = self.js("return Trammel.page.runs[0].channels")
        self.assertEqual(titles, [one["name"] for one in channels if one["unit"] != "s"])
        self.assertNotEqual(titles, [])
        rows = [[float(row["t_s"]) for row in self.rows(name)] for name in self.compared]
        times = self.js("return [...Trammel.time.values]")
        self.assertEqual(times[0], 0)
        every = (rows[0][-1] - rows[0][0]) / (len(rows[0]) - 1)
        # Without the column of time it is the time of the run, which begins before its samples.
        self.assertAlmostEqual(times[1], every, delta=1e-3 * every)
        lengths = [len(self.rows(name)) for name in self.compared]
        for plot in self.filled():
            self.assertEqual(plot, [max(lengths), *lengths])
        ids = {f["id"] for name in self.compared for f in self.metrics(name)["figures"]
               if f.get("shown", True)}
        self.assertEqual(len(self.driver.find_elements("css selector", "#figures tbody tr")),
                         len(ids))

    def test_print_has_a_picture_of_every_plot(self):
        browser.prefer(self.driver, "dark")
        self.open(next(iter(self.runs)))
        plots = self.js("return Trammel.plots.length")
        self.js("window.seen = 0; window.addEventListener('beforeprint', () => {"
                "  seen = document.querySelectorAll('.card > .print-only svg').length; });")
        pdf = base64.b64decode(self.driver.execute_cdp_cmd("Page.printToPDF", {})["data"])
        self.assertEqual(pdf[:5], b"%PDF-")
        self.assertEqual(self.js("return seen"), plots)
        self.assertEqual(self.js("return document.querySelectorAll('.print-only').length"), 0)


def main(cases, usage):
    if len(sys.argv) == 3:
        browser.need(Path(sys.argv[0]).stem)
    return checks.main(cases, usage)
