# SPDX-License-Identifier: Apache-2.0
"""What stands around the lines of report pages: the head, links to sections, titles and units of
plots, their legends, ticks, cursor and colors; and the functions of theme, time and pictures."""

import xml.etree.ElementTree as ElementTree

import browser
from drawing import line_through

# Of each plot over time; a line without unit and hidden lines are told by null and true.
PLOTS = """return Trammel.time.plots.map((p) => ({id: p.id, title: p.title, yLabel: p.yLabel,
  own: !!p.times, times: [...(p.times || Trammel.time.values)].filter((v, k, all) => k === 0 ||
    k === all.length - 1), series: p.series.map((s, k) => ({label: s.label, unit: s.unit || '',
    digits: s.digits, color: s.role ? Trammel.light[s.role] : Trammel.light.runs[s.run % 8],
    hidden: !!s.hidden, shown: p.uplot.series[k + 1].show, peak: s.peak || null,
    ends: [s.data[0], s.data[s.data.length - 1]], range: Trammel.range([...s.data].filter(
      (v) => v !== null))}))}))"""
CURSOR = """Trammel.time.point(arguments[0], null); return Trammel.time.plots.filter((p) =>
  !p.times).map((p) => [p.uplot.cursor.idx, p.series.map((s, k) => [s.data[arguments[0]],
  s.digits, s.unit || '', p.uplot.root.querySelectorAll('.u-value')[k + 1].textContent])])"""
MARKERS = """return Trammel.time.plots.map((p) => [p.id, [...p.uplot.root.querySelectorAll(
  '.u-series')].slice(1).map((row, k) => [row.querySelector('.u-label').textContent,
  getComputedStyle(row.querySelector('.u-marker')).backgroundColor,
  getComputedStyle(row.querySelector('.u-marker')).backgroundImage,
  p.uplot.series[k + 1].stroke(), p.series[k].label])])"""

# What follows a new size has been drawn one frame later.
DRAWN = "const [done] = arguments; requestAnimationFrame(() => requestAnimationFrame(() => done()))"
WIDTHS = """return [...document.querySelectorAll('[data-plot] .plot')].filter((p) => p.clientWidth)
  .map((p) => [p.closest('[data-plot]').dataset.plot, p.clientWidth, p.querySelector(
    ':scope > .uplot .u-wrap, :scope > svg, :scope > :not(.over) > svg').getBoundingClientRect()
    .width])"""


def rgb(color):
    return f"rgb({', '.join(str(int(color[k:k + 2], 16)) for k in (1, 3, 5))})"


def written(text):
    """A number of a plot, or None."""
    try:
        return float(text.replace("\u2212", "-"))
    except ValueError:
        return None


class Looks:
    def check_widths(self, name, page="report.html"):
        """Loads a page, and leaves it with all that can be opened open."""
        browser.resize(self.driver, 390)
        self.open(name, page)
        self.js("for (const d of document.querySelectorAll('details')) d.open = true")
        for width in (390, 1360, 768):
            browser.resize(self.driver, width)
            self.driver.execute_async_script(DRAWN)
            self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), width,
                                 f"{name}/{page} at {width}")
            for plot, place, drawn in self.js(WIDTHS):
                self.assertAlmostEqual(drawn, place, delta=1, msg=f"{name} {plot} at {width}")
        browser.resize(self.driver, 1360)
        self.driver.execute_async_script(DRAWN)

    def test_no_width_overflows(self):
        for name in self.runs:
            self.check_widths(name)
        self.check_widths(".", "compare.html")

    def test_head_and_links_are_those_of_the_run(self):
        for name in self.runs:
            self.see(name)
            metrics = self.metrics(name)
            self.assertEqual(self.js("return document.querySelector('h1').textContent"),
                             metrics["scenario"])
            self.assertEqual(self.js("return document.querySelector('.head .lead').textContent"),
                             metrics["options"].get("description", ""), name)
            self.assertEqual(self.js("return document.querySelector('.repeat code').textContent"),
                             metrics["command"], name)
            links = self.js("return [...document.querySelectorAll('#sections a')].map((a) => "
                            "[a.getAttribute('href'), a.textContent])")
            self.assertEqual(links, self.js(
                "return [...document.querySelectorAll('section')].map((s) => ['#' + s.id, "
                "s.querySelector('h2').textContent])"), name)
            self.assertEqual(len(links), len({href for href, _ in links}))
            foot = self.js("return [...document.querySelectorAll('#foot dl > div')].map((one) => "
                           "[...one.children].map((c) => c.textContent))")
            for key, value in metrics["versions"].items():
                self.assertIn([key, str(value)], foot, name)

    def test_a_plot_tells_what_its_lines_are(self):
        for name, page in [(name, "report.html") for name in self.runs] + [(".", "compare.html")]:
            self.see(name, page)
            for plot in self.js(PLOTS):
                where = f"{name} {plot['id']}"
                if plot["id"][-2:] in ("-x", "-y"):
                    self.assertEqual(plot["title"][0], plot["id"][-1].upper(), where)
                for one in plot["series"]:
                    if one["unit"] and plot["yLabel"] != one["unit"]:
                        self.assertIn(f"({one['unit']})", plot["yLabel"], where)
                    self.assertEqual(one["shown"], not one["hidden"], where)
                self.check_picture(plot, where)
            for plot, rows in self.js(MARKERS):
                for label, ground, image, stroke, wanted in rows:
                    self.assertEqual(label, wanted, plot)
                    self.assertIn(rgb(stroke), ground if image == "none" else image,
                                  f"{name} {plot} {label}")

    def check_picture(self, plot, where):
        """Legend, labels and ticks of a saved plot, and where its lines lie between them."""
        shapes = self.shapes(plot["id"])
        shown = [one for one in plot["series"] if not one["hidden"]]
        self.assertEqual(self.keys(plot["id"]), {one["label"]: one["color"] for one in shown},
                         where)
        texts = [s for s in shapes if s["tag"] == "text"]
        self.assertIn(plot["yLabel"], [s["text"] for s in texts if "transform" in s], where)
        self.assertIn(self.js("return Trammel.time.label"), [s["text"] for s in texts], where)
        ticks = {anchor: [(written(s["text"]), s) for s in texts if s["text-anchor"] == anchor and
                          "transform" not in s and written(s["text"]) is not None]
                 for anchor in ("middle", "end")}
        across = [(value, float(s["x"])) for value, s in ticks["middle"]]
        upward = [(value, float(s["y"]) - 0.35 * float(s["font-size"])) for value, s in
                  ticks["end"]]
        self.assertGreater(min(len(across), len(upward)), 1, where)
        for one in shown:
            lines = [s["points"] for s in shapes if s["tag"] == "path" and s.get("stroke") ==
                     one["color"] and len(s["points"]) > 2]
            if len(lines) != 1 or None in one["ends"]:
                continue  # of two lines with one color, or with gaps
            (line,) = lines
            across += [(plot["times"][0], line[0][0]), (plot["times"][-1], line[-1][0])]
            upward += [(one["ends"][0], line[0][1]), (one["ends"][1], line[-1][1]),
                       (one["range"][0], max(y for _, y in line)),
                       (one["range"][1], min(y for _, y in line))]
        for points, rises in ((across, True), (upward, False)):
            slope, _, worst = line_through(points)
            self.assertEqual(slope > 0, rises, where)
            self.assertLess(worst, 0.03, where)
        for one in shown:
            if one["peak"]:
                dots = [(float(s["cx"]), float(s["cy"])) for s in shapes if s["tag"] == "circle"
                        and s["fill"] == one["color"]]
                self.assertEqual(len(dots), 1, where)
                for value, pixel, points in zip(one["peak"], dots[0], (across, upward),
                                                strict=True):
                    slope, offset, _ = line_through(points)
                    self.assertAlmostEqual(pixel, offset + slope * value, delta=0.05, msg=where)
                self.assertTrue([s for s in texts if s["fill"] == one["color"] and s[
                    "text"].endswith(one["unit"]) and abs(written(s["text"].split(" ")[0]) -
                                                          one["peak"][1]) < 1e-3], where)

    def test_events_are_dashed_lines_at_their_times(self):
        for name in self.runs:
            self.see(name)
            marks, plots = self.js("return [Trammel.time.marks, Trammel.time.plots.filter((p) => "
                                   "!p.times).map((p) => p.id)]")
            times = self.js("return Trammel.time.full")
            for plot in plots[:2] if marks else []:
                shapes = self.shapes(plot)
                drawn = sorted(s["points"][0][0] for s in shapes if s["tag"] == "path" and
                               s.get("stroke-dasharray") == "4 4")
                ticks = [(written(s["text"]), float(s["x"])) for s in shapes if s["tag"] == "text"
                         and s["text-anchor"] == "middle" and "x" in s and written(s["text"])
                         is not None]
                slope, offset, _ = line_through(ticks)
                inside = sorted(t for t in marks if times[0] <= t <= times[1])
                self.assertEqual(len(drawn), len(inside), f"{name} {plot}")
                for x, t in zip(drawn, inside, strict=True):
                    self.assertAlmostEqual(x, offset + slope * t, delta=0.05, msg=name)

    def test_the_cursor_tells_the_values_of_its_sample(self):
        self.open(next(iter(self.runs)))
        count = self.js("return Trammel.time.values.length")
        for k in (count // 3, count // 2):
            for at, lines in self.js(CURSOR, k):
                self.assertEqual(at, k)
                for value, digits, unit, text in lines:
                    number, _, rest = text.partition(" ")
                    self.assertEqual(rest, unit)
                    self.assertEqual(len(number.partition(".")[2]), digits, text)
                    self.assertAlmostEqual(written(number), value, delta=0.501 * 10 ** -digits)
            now = self.js("return document.getElementById('time-now').textContent")
            seconds = self.js("return Trammel.time.values[arguments[0]]", k)
            self.assertRegex(now, r"^t = \u2212?[0-9]+\.[0-9]{4} s$")
            self.assertAlmostEqual(written(now[4:-2]), seconds, delta=0.501e-4)
        self.js("Trammel.time.point(null, null)")
        self.assertEqual(self.js("return document.getElementById('time-now').textContent"), "")

    def test_dark_plots_have_dark_colors_and_are_saved_and_printed_in_light_ones(self):
        self.open(next(iter(self.runs)))
        plots = self.js("return Trammel.plots.filter((p) => p.canvas).map((p) => p.id)")
        self.assertTrue(plots)
        light, dark = ("return Trammel.plots.map((p) => p.canvas ? p.canvas.innerHTML : '')",
                       "return Trammel.theme().muted")
        before, muted = self.js(light), self.js(dark)
        browser.prefer(self.driver, "dark")
        self.until(lambda: not any(muted in text for text in self.js(light)))
        other = self.js(dark)
        for first, then in zip(before, self.js(light), strict=True):
            self.assertEqual((muted in first, other in first), (first != "", False))
            self.assertEqual((muted in then, other in then), (False, first != ""))
        saved = self.js("return Trammel.plots.map((p) => [p.title, Trammel.svgText(p)])")
        for title, text in saved:
            root = ElementTree.fromstring(text)
            self.assertEqual(root[0].get("fill"), "#ffffff", title)
            self.assertEqual(root[1].text, title)
            self.assertNotIn(other, text, title)
        self.js("window.seen = []; window.addEventListener('beforeprint', () => { seen = "
                "[[...document.querySelectorAll('.print-only')].map((n) => n.innerHTML), "
                "document.querySelectorAll('details:not([open])').length, "
                "document.documentElement.style.getPropertyValue('--surface')]; });")
        closed = self.js("return document.querySelectorAll('details:not([open])').length")
        self.driver.execute_cdp_cmd("Page.printToPDF", {})
        pictures, shut, ground = self.js("return seen")
        self.assertEqual((shut, ground), (0, "#ffffff"))
        for (title, _), text in zip(saved, pictures, strict=False):
            self.assertTrue(muted in text and other not in text, title)
        self.assertEqual(self.js("return document.querySelectorAll('details:not([open])').length"),
                         closed)
        self.assertEqual(self.js("return document.documentElement.style.getPropertyValue("
                                 "'--muted')"), other)

    def test_the_chosen_theme_is_kept(self):
        run = next(iter(self.runs))
        self.open(run)
        self.js("localStorage.clear()")
        self.open(run)
        scheme = "return [Trammel.theme().name, document.documentElement.style.colorScheme]"
        self.assertEqual(self.js(scheme), ["light"] * 2)
        for wanted in ("dark", "light", "dark"):
            self.js("document.getElementById('theme').click()")
            self.assertEqual(self.js(scheme), [wanted] * 2)
        self.open(run)
        self.assertEqual(self.js(scheme), ["dark"] * 2)
        self.js("localStorage.clear()")

    def test_colors_times_and_shapes(self):
        self.open(next(iter(self.runs)))
        both = "(({ full, values }) => { Object.assign(T.time, { full: [0, 3], values: [0, 1, 3] }"\
            "); const found = [-0.1, 0, 0.4, 0.6, 1.9, 2.1, 3, 3.1].map(T.time.at); "\
            "Object.assign(T.time, { full, values }); return found; })({ ...T.time })"
        entries = "[['ab', 60], ['abc', 61], ['abcd', 62]].map(([label]) => ({ label }))"
        for script, wanted in (
                ("T.mix('#000000', '#ff8001', 0.5)", "#804001"),
                ("[T.mix('#102030', '#405060', 0), T.mix('#102030', '#405060', 1)]",
                 ["#102030", "#405060"]),
                ("[-1, 0, 0, 1, -3, 3].map((v, k) => T.diverge(T.light, v) === [T.light.cold, "
                 "T.light.middle, T.light.middle, T.light.warm, T.light.cold, T.light.warm][k])",
                 [True] * 6),
                ("[-1, 0, 1 / 3, 2 / 3, 1, 2].map((v) => T.light.ramp.indexOf(T.ramp(T.light, v)))",
                 [0, 0, 1, 2, 3, 3]),
                ("['#ffffff', '#f4f5f7', '#000000', '#0b5fa5'].map(T.inkOn)",
                 ["#161a21", "#161a21", "#ffffff", "#ffffff"]),
                ("[0, 7, 8].map((k) => [T.runColour(T.light, k) === T.light.runs[k % 8], "
                 "T.runDash(k) || null])", [[True, None], [True, None], [True, [6, 4]]]),
                ("new Set(T.light.runs).size", 8),
                (both, [None, 0, 0, 1, 1, 2, 2, None]),
                # 22 + 7.4 a letter + 18 pixels: 54.8, 62.2, 69.6.
                (f"[60, 118, 186, 187].map((w) => T.keyLines({entries}, w).map((l) => l.length))",
                 [[1, 1, 1], [2, 1], [2, 1], [3]]),
                ("T.shapes((p) => { p.text(1, 2, '<a> & \"b\"', { fill: 'red' }); p.rect(1.004, "
                 "2.006, 3, 4, { fill: 'red', alpha: 0.5 }); p.path([1, 2, 3, 4], { stroke: 'red',"
                 " dash: [1, 2], close: true }); }, 9, 9, T.light)",
                 '<text x="1" y="2" font-size="12" font-weight="400" text-anchor="start" '
                 'fill="red">&lt;a&gt; &amp; &quot;b&quot;</text><rect x="1" y="2.01" width="3" '
                 'height="4" fill="red" opacity="0.5"/><path d="M1 2 3 4Z" fill="none" '
                 'stroke="red" stroke-width="1" stroke-dasharray="1 2"/>')):
            self.assertEqual(self.js(f"const T = Trammel; return {script}"), wanted, script)
