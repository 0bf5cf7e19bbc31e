# SPDX-License-Identifier: Apache-2.0
"""The page of a sweep in headless Chromium, for who looks at it: page_test.py PROGRAM (which is not
used)."""

import base64
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "support"))
import browser
from drawing import line_through
from trammel.sweep import Plan, page, store, work

PLAN = """scenario = "circle"
[keys]
"run.max_s" = 0.03
[grid]
controller = ["fc", "afc"]
"plant.payload_kg" = [0, 11, 22]
"gains.kp" = [0.1, 0.2]
"""
SVG = "{http://www.w3.org/2000/svg}"


def made(folder):
    """The page of the plan, whose runs are made in this process."""
    file = Path(folder, "plan.toml")
    file.write_text(PLAN)
    plan = Plan(file)
    parts = [(part.scenario, part.engine, part.keys) for part in plan.parts]
    rows, _ = work.chunk(parts, [(n, *plan.run(n)) for n in range(plan.count)])
    rows[3] = {k: rows[3][k] for k in ("run", "part", "scenario", *plan.varied)} | {
        "end": "refused", "message": "for a <!--<script> </script> & \\"}
    with store.Store(Path(folder, "out"), plan.identity()) as kept:
        kept.add(rows)
        page.write(plan, kept.table(), Path(folder, "page.html"))
    return rows, Path(folder, "page.html")


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.rows, cls.file = made(cls.scratch.name)
        cls.driver = browser.start()
        cls.addClassCleanup(cls.driver.quit)

    def setUp(self):
        browser.resize(self.driver, 1360)
        self.driver.get(self.file.as_uri())

    def tearDown(self):
        self.assertEqual(browser.complaints(self.driver), [])
        self.assertEqual({a for a in browser.requests(self.driver) if a.startswith("http")}, set())

    def js(self, text, *words):
        return self.driver.execute_script(text, *words)

    def choose(self, name, value):
        from selenium.webdriver.support.ui import Select
        Select(self.driver.find_element("id", name)).select_by_visible_text(value)

    def column(self, number):
        """Texts of a column of the table."""
        return self.js("return [...document.querySelectorAll('#table tbody tr')]"
                       f".map((row) => row.cells[{number}].textContent)")

    def svg(self, name):
        return ElementTree.fromstring(self.js("return svgOf(arguments[0])", name))

    def test_axes_are_chosen(self):
        known = [o.text for o in self.driver.find_elements("css selector", "#x option")]
        for name in ("controller", "plant.payload_kg", "gains.kp", "end"):
            self.assertIn(name, known)
        columns = {}
        for x in ("plant.payload_kg", "gains.kp", "controller"):
            self.choose("x", x)
            self.choose("y", "wall_s")
            at = self.js("return places.scatter")
            self.assertEqual(len(at), len(self.rows) - 1)  # one has no figures
            columns[x] = len({round(one["x"]) for one in at})
        self.assertEqual(columns, {"plant.payload_kg": 3, "gains.kp": 2, "controller": 2})
        self.assertIn("controller", "".join(self.svg("scatter").itertext()))
        before = self.js("return byId('scatter').toDataURL()")
        self.choose("color", "gains.kp")
        self.assertNotEqual(before, self.js("return byId('scatter').toDataURL()"))
        self.assertIn("gains.kp:", "".join(self.svg("scatter").itertext()))

    def test_a_column_sorts_the_table(self):
        head = [c.text for c in self.driver.find_elements("css selector", "#table th")]
        at = head.index("gains.kp")
        for falls in (False, True):
            self.driver.find_elements("css selector", "#table th")[at].click()
            values = [float(text) for text in self.column(at)]
            self.assertEqual(values, sorted(values, reverse=falls))
            self.assertEqual(len(values), len(self.rows))

    def test_what_has_no_value_comes_last(self):
        refused = [row["run"] for row in self.rows if row["end"] == "refused"]
        self.assertEqual(len(refused), 1)
        head = [c.text for c in self.driver.find_elements("css selector", "#table th")]
        for _ in range(2):  # rising, falling
            self.driver.find_elements("css selector", "#table th")[head.index("wall_s")].click()
            self.assertEqual(int(self.column(0)[-1]), refused[0])

    def test_the_page_tells_how_many_ended_badly(self):
        bad = sum(row["end"] != "done" for row in self.rows)
        self.assertNotEqual(bad, len(self.rows) - bad)
        about = self.driver.find_element("id", "about").text
        self.assertIn(f"{len(self.rows)} of {len(self.rows)} runs are shown; {bad} of these", about)

    def place(self, values, n):
        """Where on its axis a value is, 0 to 1."""
        there = [v for v in values if v is not None]
        return (values[n] - min(there)) / (max(there) - min(there))

    def values(self, name):
        return [row.get(name) for row in self.rows]

    def test_points_and_lines_lie_where_their_values_are(self):
        self.choose("x", "gains.kp")
        self.choose("y", "wall_s")
        points = {one["n"]: one for one in self.js("return places.scatter")}
        width, height = self.js("const c = byId('scatter'); return [c.clientWidth, "
                                "Number(c.dataset.height)]")
        for n, at in points.items():
            self.assertAlmostEqual(
                at["x"], 80 + (width - 110) * self.place(self.values("gains.kp"), n), delta=0.1)
            self.assertAlmostEqual(
                at["y"], height - 40 - (height - 76) * self.place(self.values("wall_s"), n),
                delta=0.1)
        for option in self.driver.find_elements("css selector", "#axes option"):
            if option.is_selected() != (option.text in ("gains.kp", "plant.payload_kg", "wall_s")):
                option.click()
        taken = self.js("return [...byId('axes').selectedOptions].map((o) => o.value)")
        self.assertEqual(sorted(taken), ["gains.kp", "plant.payload_kg", "wall_s"])
        tall = self.js("return Number(byId('parallel').dataset.height)") - 60
        marks = self.js("return places.parallel")
        self.assertEqual(len(marks), 3 * len(points))
        for k, mark in enumerate(marks):  # three of a run, one after the other
            place = self.place(self.values(taken[k % 3]), mark["n"])
            self.assertAlmostEqual(mark["y"], 44 + tall * (1 - place), delta=0.1, msg=taken[k % 3])

    def test_colors_go_from_blue_to_red(self):
        self.choose("x", "wall_s")
        self.choose("y", "wall_s")
        for name, wanted in (("gains.kp", {0.1: "hsl(240, 75%, 45%)", 0.2: "hsl(0, 75%, 45%)"}),
                             ("controller", {"afc": "#1f77b4", "fc": "#d9731a"})):
            self.choose("color", name)
            drawn = [c.get("fill") for c in self.svg("scatter").iter(f"{SVG}circle")]
            values = [row[name] for row in self.rows if "wall_s" in row]
            self.assertEqual(drawn, [wanted[v] for v in values], name)

    def texts(self, name):
        return [(one.text, float(one.get("x")), float(one.get("y")), one.get("text-anchor"))
                for one in self.svg(name).iter(f"{SVG}text")]

    def test_ticks_lie_where_their_values_are(self):
        self.choose("x", "plant.payload_kg")
        self.choose("y", "gains.kp")
        points = self.js("return places.scatter")
        texts = self.texts("scatter")
        bottom = max(y for _, _, y, _ in texts)
        across = [(float(t), x) for t, x, y, anchor in texts if anchor == "middle"
                  and y == bottom - 16]
        upward = [(float(t), y - 4) for t, x, y, anchor in texts if anchor == "end" and x == 75]
        self.assertGreater(min(len(across), len(upward)), 2)
        across += [(self.values("plant.payload_kg")[p["n"]], p["x"]) for p in points]
        upward += [(self.values("gains.kp")[p["n"]], p["y"]) for p in points]
        for pairs, rises in ((across, True), (upward, False)):
            slope, _, worst = line_through(pairs)
            self.assertEqual(slope > 0, rises)
            self.assertLess(worst, 0.11)
        names = [(t, anchor) for t, _, _, anchor in texts]
        self.assertIn(("plant.payload_kg", "middle"), names)
        self.assertIn(("gains.kp", "start"), names)
        self.choose("y", "end")
        places = {t: y - 4 for t, x, y, anchor in self.texts("scatter")
                  if anchor == "end" and x == 75}
        self.assertEqual(set(places), {row["end"] for row in self.rows})
        for point in self.js("return places.scatter"):
            self.assertAlmostEqual(point["y"], places[self.values("end")[point["n"]]], delta=0.11)

    def test_the_legend_tells_the_colors(self):
        self.choose("color", "gains.kp")
        texts = {t: x for t, x, y, _ in self.texts("scatter") if y == 14}
        self.assertLess(texts["gains.kp:"], texts["0.1"])
        self.assertLess(texts["0.1"], texts["0.2"])
        bar = [(float(r.get("x")), r.get("fill")) for r in self.svg("scatter").iter(f"{SVG}rect")
               if (r.get("fill") or "").startswith("hsl")]
        self.assertEqual((min(bar)[1], max(bar)[1]), ("hsl(240, 75%, 45%)", "hsl(0, 75%, 45%)"))
        self.choose("color", "controller")
        texts = {t: x for t, x, y, _ in self.texts("scatter") if y == 14}
        marks = {r.get("fill"): float(r.get("x")) for r in self.svg("scatter").iter(f"{SVG}rect")
                 if (r.get("fill") or "").startswith("#") and r.get("width") == "8"}
        # Each square stands before its word; "afc" before "fc".
        self.assertLess(texts["controller:"], marks["#1f77b4"])
        order = [marks["#1f77b4"], texts["afc"], marks["#d9731a"], texts["fc"]]
        self.assertEqual(order, sorted(order))
        self.choose("color", "none")
        self.assertEqual([t for t, _, y, _ in self.texts("scatter") if y == 14], [])

    def test_a_page_opens_with_its_keys_and_first_figures(self):
        self.assertEqual(self.driver.title, "Sweep plan")
        self.assertEqual(self.driver.find_element("id", "title").text, "Sweep plan")
        self.assertEqual(self.driver.find_element("id", "rows").text, "Runs")
        chosen = self.js("return ['x', 'y', 'color'].map((name) => byId(name).value)")
        self.assertEqual(chosen[::2], ["plant.payload_kg", "controller"])
        figures = self.js("return data.axes.filter((a) => !a.key).map((a) => a.name)")
        self.assertIn(chosen[1], figures)
        taken = self.js("return [...byId('axes').selectedOptions].map((o) => o.value)")
        self.assertEqual(set(taken) - set(figures),
                         {"controller", "plant.payload_kg", "gains.kp"})
        self.assertEqual(len(taken), 6)

    def test_a_study_opens_with_its_best_trial(self):
        content = self.js("return data")
        best = 5
        content["words"].append({"name": "best", "values": ["best" if n == best else "" for n in
                                                            range(len(self.rows))]})
        content |= {"kind": "Study", "what": "trials", "of": 20}
        file = Path(self.scratch.name, "study.html")
        page._write(content, file)
        self.driver.get(file.as_uri())
        self.assertEqual(self.driver.find_element("id", "command").text, content["commands"][best])
        self.assertEqual(self.driver.find_element("css selector", "tr.chosen td").text,
                         str(content["runs"][best]))
        self.assertIn(f"{len(self.rows)} of 20 trials are shown",
                      self.driver.find_element("id", "about").text)
        self.assertEqual(self.driver.find_element("id", "rows").text, "Trials")
        wide = [n for n, one in enumerate(self.svg("scatter").iter(f"{SVG}circle"))
                if one.get("r") == "6"]
        self.assertEqual(len(wide), 1)
        lines = [one.get("stroke-width") for one in self.svg("parallel").iter(f"{SVG}polyline")]
        self.assertEqual(lines.count("3"), 1)

    def test_words_sort_and_a_second_column_begins_rising(self):
        def click(name):
            heads = self.driver.find_elements("css selector", "#table th")
            heads[[h.text.split(" ")[0] for h in heads].index(name)].click()
            return [h.text for h in self.driver.find_elements("css selector", "#table th")]

        click("gains.kp")
        self.assertIn("gains.kp v", click("gains.kp"))
        head = click("controller")
        self.assertIn("controller ^", head)
        self.assertIn("gains.kp", head)
        words = self.column(head.index("controller ^"))
        self.assertEqual(words, sorted(words))
        runs = [int(text) for text in self.column(0)]
        self.assertEqual(runs, sorted(runs, key=lambda n: (self.values("controller")[n], n)))

    def test_bars_count_the_runs(self):
        self.choose("y", "plant.payload_kg")
        bars = [float(bar.get("height")) for bar in self.svg("histogram").iter(f"{SVG}rect")
                if bar.get("fill") == "#335577"]
        values = [v for v in self.values("plant.payload_kg") if v is not None]
        counts = [0] * 5  # of 0, 11 and 22
        for v in values:
            counts[min(4, int(v / 22 * 5))] += 1
        for bar, count in zip(bars, counts, strict=True):
            self.assertAlmostEqual(bar / max(bars), count / max(counts), delta=0.01)

    def test_a_click_shows_the_command(self):
        from selenium.webdriver import ActionChains
        commands = self.js("return data.commands")
        canvas = self.driver.find_element("id", "scatter")
        self.js("arguments[0].scrollIntoView({block: 'center'})", canvas)
        at = self.js("return places.scatter")[7]
        width, height = self.js("const c = byId('scatter');"
                                "return [c.clientWidth, c.clientHeight]")
        ActionChains(self.driver, duration=20).move_to_element_with_offset(
            canvas, round(at["x"] - width / 2), round(at["y"] - height / 2)).click().perform()
        shown = self.driver.find_element("id", "command").text
        self.assertIn(shown, commands)
        self.assertEqual(self.js("return places.scatter.filter((p) => p.n === chosen)[0].x"),
                         at["x"])
        row = self.driver.find_elements("css selector", "#table tbody tr")[2]
        self.js("arguments[0].scrollIntoView({block: 'center'})", row)
        number = int(row.find_element("css selector", "td").text)
        row.click()
        self.assertEqual(self.driver.find_element("id", "command").text, commands[number])
        self.assertEqual(self.driver.find_element("css selector", "tr.chosen td").text,
                         str(number))
        refused = self.driver.find_elements("css selector", "#table tr[title]:not([title=''])")
        titles = [r.get_attribute("title") for r in refused]
        self.assertIn("for a <!--<script> </script> & \\", titles)

    def test_narrow(self):
        browser.resize(self.driver, 375, 800)
        self.driver.get(self.file.as_uri())
        wide, room = self.js("return [document.documentElement.scrollWidth, innerWidth]")
        self.assertLessEqual(wide, room)
        self.assertLess(self.js("return byId('scatter').clientWidth"), 375)
        self.assertEqual(len(self.js("return places.scatter")), len(self.rows) - 1)

    def test_printed(self):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        browser.resize(self.driver, 700)
        shape = self.js("const c = byId('scatter');"
                        "return [c.clientWidth / c.clientHeight, c.width / c.height]")
        self.assertAlmostEqual(*shape, delta=0.02)
        self.assertFalse(self.driver.find_element("id", "x").is_displayed())
        self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), 700)
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
        paper = self.driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True})
        self.assertTrue(base64.b64decode(paper["data"]).startswith(b"%PDF"))

    def test_pictures_are_saved(self):
        figures = len(self.rows) - 1
        self.assertEqual(len(list(self.svg("scatter").iter(f"{SVG}circle"))), figures)
        self.assertGreaterEqual(len(list(self.svg("parallel").iter(f"{SVG}polyline"))), figures)
        bars = [float(bar.get("height")) for bar in self.svg("histogram").iter(f"{SVG}rect")
                if bar.get("fill") == "#335577"]
        self.assertGreater(max(bars), 0)
        buttons = self.driver.find_elements("css selector", "[data-save]")
        self.assertEqual(len(buttons), 3)
        target = Path(self.scratch.name, "saved")
        target.mkdir()
        self.driver.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(target)})
        buttons[0].click()
        from selenium.webdriver.support.ui import WebDriverWait
        WebDriverWait(self.driver, 10, 0.05).until(
            lambda _: (target / "plan-scatter.svg").is_file()
            and ElementTree.parse(target / "plan-scatter.svg"))


if __name__ == "__main__":
    browser.need("page")
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
