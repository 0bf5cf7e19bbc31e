# SPDX-License-Identifier: Apache-2.0
"""What report pages write, held against metrics.json: the outcome, the parameters and which of
them differ, figures of several runs with their differences, gauges, the foot."""

import math
import re

CELLS = """return [...document.querySelectorAll(arguments[0])].map((row) => [...row.cells].map(
  (cell) => [cell.textContent, cell.className, cell.colSpan]))"""
PARAMETERS = "#parameters tr[data-find]"


def number(text):
    return float(re.sub(r"[\u2009+ %]", "", text).replace("\u2212", "-"))


def same(text, value):
    """Whether a text of the page is that of a parameter."""
    if isinstance(value, bool | str):
        return text == (str(value).lower() if isinstance(value, bool) else value or "\u2013")
    return math.isclose(float(text), value, rel_tol=1e-9)


class Tables:
    better_small = ""   # figures of the page of several runs of which less is better

    def asides(self, metrics):
        """What the machine has below its tiles: {figure: text}."""
        return {}

    def idle(self, key, options):
        """Whether a parameter does nothing with these options, so that the page leaves it out."""
        return False

    def rows_of(self, selector):
        return self.js(CELLS, selector)

    def test_a_page_tells_outcome_parameters_gauges_and_foot_of_its_run(self):
        others = sorted(path.stem for path in (self.machines / self.metrics(next(iter(
            self.runs)))["machine"] / "scenarios").glob("*.toml"))
        self.make("cut", ["run", others[0], "-s", "run.max_s=0.002"], 5)
        for name in ("cut", *self.runs):
            self.see(name)  # once: each takes more than half a second
            metrics = self.metrics(name)
            self.check_outcome(name, metrics)
            if name != "cut":
                self.check_foot(name, metrics["run"])
                self.check_parameters(name, metrics["options"])
                self.check_gauges([f for f in metrics["figures"] if "expected" in f])
                for key, value, *_ in self.rows_of("#assumptions tbody tr"):
                    self.assertTrue(same(value[0], metrics["options"][key[0]]), f"{name} {key[0]}")

    def check_outcome(self, name, metrics):
        chip = self.driver.find_element("css selector", ".head .chip.good, .head .chip.bad")
        verdict = metrics["verdict"]
        self.assertEqual(chip.text, verdict[0].upper() + verdict[1:], name)
        self.assertEqual("good" in chip.get_attribute("class"), metrics["end"] == "done",
                         f"{name} ended as {metrics['end']}")

    def check_foot(self, name, run):
        """How long each clock domain was awake."""
        foot = self.driver.find_element("id", "foot").text
        self.assertIn(run["event_hash"], foot)
        for domain, count in run.get("activity", {}).items():
            self.assertIn(f"{domain} {100 * count / run['clocks']:.3f} %", foot, name)

    def check_parameters(self, name, options):
        """Each stands in the column of its axis, marked where it is not the default."""
        keys = self.js("return Trammel.page.keys")
        columns = [text for text, *_ in self.rows_of("#parameters thead tr")[0]][1:-2]
        found = self.js("return [...document.querySelectorAll(arguments[0])].map((row) => "
                        "[row.dataset.find.split(' ')[0], row.className])", PARAMETERS)
        self.assertNotEqual(found, [])
        told = set()
        for (key, look), cells in zip(found, self.rows_of(PARAMETERS), strict=True):
            section, _, own = key.rpartition(".")
            named = {re.sub(r"(^|\.)[xy]$", "", k.lower().rpartition(".")[0]) or "run": k
                     for k in options if k.lower().rpartition(".")[2] == own}
            self.assertIn(section, named)
            of = {axis: next((k for k in options if k.lower() == f"{section}.{axis}.{own}"),
                             None) for axis in "xy"}
            if any(of.values()):
                for axis, cell in zip(columns, cells[1:], strict=False):
                    self.assertTrue(same(cell[0], options[of[axis.lower()]]),
                                    f"{name} {key}, {axis}: {cell[0]}")
                mine = [k for k in of.values() if k]
            else:
                mine = [named[section]]
                self.assertTrue(same(cells[1][0], options[mine[0]]),
                                f"{name} {key}: {cells[1][0]}")
            differs = any("default" in keys.get(k, {}) and keys[k]["default"] != options[k]
                          for k in mine)
            self.assertEqual(look, "changed" if differs else "", f"{name} {key}")
            known = keys.get(mine[-1], {})
            default, meaning = (cell[0] for cell in cells[-2:])
            self.assertEqual(meaning, known.get("help", ""), key)
            self.assertTrue(same(default, known["default"]) if "default" in known
                            else default == "", f"{name} {key}: {default}")
            told.update(mine)
        self.assertEqual(told, {key for key in options if key not in ("name", "description")
                                and not self.idle(key, options)}, name)

    def check_gauges(self, judged):
        """Each points at the value, between the ends of its band; a bar is at what is printed."""
        gauges = self.js("return [...document.querySelectorAll('#figures .gauge svg')].map((svg) =>"
                         " [...svg.children].map((one) => Object.fromEntries([...one.attributes]"
                         ".map((a) => [a.name, Number.isNaN(Number(a.value)) ? a.value : "
                         "Number(a.value)]))))")
        for (_, band, *bar, dot), f in zip(gauges, judged, strict=True):
            off = f["value"] - f["expected"]
            reach = max(1.7 * f["tolerance"], 1.15 * abs(off)) or 1

            def at(off, reach=reach):
                return 75 + 69 * max(-1, min(1, off / reach))

            color = f"var(--{'good' if f['within'] else 'bad'})"
            self.assertEqual((band["fill"], dot["fill"]), (color, color), f["id"])
            printed = f.get("printed", math.inf) - f["expected"]
            wanted = [at(off), at(-f["tolerance"]), at(f["tolerance"])] + (
                [at(printed)] if abs(printed) <= reach else [])
            shown = [dot["cx"], band["x"], band["x"] + band["width"]] + [
                one["x"] + one["width"] / 2 for one in bar]
            self.assertEqual(len(shown), len(wanted), f["id"])
            for pixel, place in zip(shown, wanted, strict=True):
                self.assertAlmostEqual(pixel, place, delta=0.02, msg=f["id"])

    def test_tiles_have_what_belongs_to_their_figures_below_them(self):
        for name in self.runs:
            self.see(name)
            metrics = self.metrics(name)
            own = self.asides(metrics)
            tiles = [f for f in metrics["figures"] if "tile" in f]
            shown = self.js("return [...document.querySelectorAll('.tile .aside')].map((one) => "
                            "one.textContent)")
            for text, f in zip(shown, tiles, strict=True):
                beside = [(run, other) for run, one in metrics.get("compared", {}).items()
                          for other in one["figures"] if other["id"] == f["id"]]
                if f["id"] in own:
                    self.assertEqual(text, own[f["id"]], f"{name} {f['id']}")
                elif "printed" in f or "expected" in f:
                    word = "printed" if "printed" in f else "expected"
                    self.assertEqual(text.split(" ")[0], word)
                    self.assertAlmostEqual(number(text.split(" ")[1]), f[word], delta=0.0051)
                elif beside:
                    for part, (run, other) in zip(text.split(", "), beside, strict=True):
                        self.assertEqual(part.split(": ")[0], run)
                        self.assertAlmostEqual(number(part.split(": ")[1]), other["value"],
                                               delta=0.51 * 10 ** -other.get("digits", 0))
                else:
                    self.assertEqual(text, "\u00a0", f"{name} {f['id']}")

    def test_less_is_better_of_errors_and_times(self):
        self.see(".", "compare.html")
        told = self.js("const m = Trammel.machineOf(Trammel.page.machine).compare; return "
                       "Trammel.commonFigures(Trammel.page.runs, m.figures).filter(([f]) => "
                       "m.smallerIsBetter(f)).map(([f]) => f.id)")
        self.assertEqual(sorted(told), sorted(self.better_small.split()))

    def test_parameters_are_sifted(self):
        self.open(next(iter(self.runs)))
        shown = ("return [...document.querySelectorAll(arguments[0])].filter((row) => "
                 "!row.hidden).map((row) => [row.dataset.find, row.className])")
        whole = self.js(shown, PARAMETERS)
        changed = [row for row in whole if row[1] == "changed"]
        self.assertTrue(0 < len(changed) < len(whole))
        only = self.driver.find_element("css selector", "#parameters input[type=checkbox]")
        self.js("arguments[0].click()", only)
        self.assertEqual(self.js(shown, PARAMETERS), changed)
        self.check_groups()
        self.js("arguments[0].click()", only)
        self.driver.find_element("css selector", "#parameters input[type=search]").send_keys("Run.")
        self.assertEqual(self.js(shown, PARAMETERS), [row for row in whole if "run." in row[0]])
        self.check_groups()

    def check_groups(self):
        """The name of a section stands above its rows as long as one of them is shown."""
        rows = self.js("return [...document.querySelectorAll('#parameters tbody tr')].map((row) =>"
                       " [row.className === 'group' ? row.textContent : '', row.hidden, "
                       "row.dataset.find || ''])")
        groups, full = [], set()
        for name, hidden, words in rows:
            if name:
                groups.append((name.lower(), hidden))
            else:
                self.assertEqual(words.split(" ")[0].rpartition(".")[0], groups[-1][0])
                full |= set() if hidden else {groups[-1][0]}
        self.assertEqual({name for name, hidden in groups if not hidden}, full)

    def test_differences_are_to_the_first_run_of_its_kind(self):
        self.see(".", "compare.html")
        runs = [self.metrics(name) for name in self.compared]
        kinds = self.js("return Trammel.page.runs.map(Trammel.machineOf(Trammel.page.machine)"
                        ".compare.kindOf)")
        smaller = self.js("const m = Trammel.machineOf(Trammel.page.machine).compare; return "
                          "Object.fromEntries(Trammel.page.runs.flatMap((run) => "
                          "run.metrics.figures.map((f) => [f.id, !!m.smallerIsBetter(f)])))")
        figures = self.js("const m = Trammel.machineOf(Trammel.page.machine).compare; return "
                          "Trammel.commonFigures(Trammel.page.runs, m.figures).map(([f]) => f.id)")
        looks = self.js("return [...document.querySelectorAll('#figures tbody tr')].map((row) => "
                        "[...row.cells].slice(1).map((cell) => { const s = "
                        "cell.querySelector('div small'); return s ? [s.textContent, s.className] "
                        ": null; }))")
        told = 0
        for figure, cells in zip(figures, looks, strict=True):
            values = [next((f for f in run["figures"] if f["id"] == figure), None) for run in runs]
            for k, cell in enumerate(cells):
                base = kinds.index(kinds[k])
                if base == k or values[k] is None or values[base] is None:
                    self.assertIsNone(cell, figure)
                    continue
                by = values[k]["value"] - values[base]["value"]
                digits = values[k].get("digits", 0)
                if abs(by) < 0.499 * 10 ** -digits:
                    self.assertEqual(cell[0], "=", figure)
                elif abs(by) > 0.501 * 10 ** -digits:
                    self.assertAlmostEqual(number(cell[0].split(",")[0]), by,
                                           delta=0.51 * 10 ** -digits, msg=figure)
                    look = ("good-text" if by < 0 else "bad-text") if smaller[figure] else ""
                    self.assertEqual(cell[1], look, figure)
                    told += 1
        self.assertGreater(told, 0)

    def test_parameters_that_are_those_of_the_first_run_are_dim(self):
        self.see(".", "compare.html")
        rows = self.rows_of("#parameters tbody tr")
        self.assertNotEqual(rows, [])
        options = [self.metrics(name)["options"] for name in self.compared]
        for (key, *_), *cells in rows:
            for own, (text, look, _) in zip(options, cells, strict=True):
                self.assertTrue(same(text, own.get(key, "")), f"{key}: {text}")
                self.assertEqual(look, "dim" if own.get(key) == options[0].get(key) else "", key)

    def test_tables_of_figures_have_each_unit_once(self):
        self.see(next(iter(self.runs)))
        for units, heads, names, cells in (
                ("m m m m", ["a (m)", "b (m)"], ["One", "Two"], ["1", "2", "3", "4"]),
                ("m s m s", ["a (m)", "b (s)"], ["One", "Two"], ["1", "2", "3", "4"]),
                ("m m s s", ["a", "b"], ["One (m)", "Two (s)"], ["1", "2", "3", "4"]),
                ("m s s m", ["a", "b"], ["One", "Two"], ["1 m", "2 s", "3 s", "4 m"])):
            figures = [{"id": f"{row}.{c}", "name": f"{row}, {c}", "column": c, "value": value,
                        "unit": unit} for (row, c), value, unit in zip(
                            (("one", "a"), ("one", "b"), ("two", "a"), ("two", "b")), (1, 2, 3, 4),
                            units.split(), strict=True)]
            third = [{**f, "id": f["id"][:-1] + "c", "name": f["name"][:-1] + "c", "column": "c",
                      "value": 9} for f in figures[1::2]]
            rows = self.js("const [table] = Trammel.figureTables(arguments[0]); return "
                           "[...table.querySelectorAll('tr')].map((row) => [...row.cells].map("
                           "(cell) => cell.textContent))",
                           [*figures[:2], third[0], *figures[2:], third[1]])
            self.assertEqual(rows[0][1:3], heads, units)
            self.assertEqual([row[0] for row in rows[1:]], names, units)
            self.assertEqual([cell for row in rows[1:] for cell in row[1:3]], cells, units)
