# SPDX-License-Identifier: Apache-2.0
"""What report pages draw, held against the files of the run: every line over time is that of the
column it names, paths lie where trace.csv has them, and the functions that all plots share."""

import math
import re
from html import unescape

# Of a line: a column; (column, factor); (function of a row and an axis, tolerance); None: it is
# looked at elsewhere.


def bit(column, number):
    return lambda row, axis: int(row[column.format(a=axis)]) >> number & 1, 0


def hypot(*columns, factor=1, tolerance=1e-3):
    return lambda row, axis: factor * math.hypot(*(row[c] for c in columns)), tolerance


def shape_of(tag, text):
    shape = {"tag": tag, **dict(re.findall(r'([\w-]+)="([^"]*)"', text))}
    if "d" in shape:
        numbers = [float(n) for n in re.findall(r"-?[\d.]+", shape["d"])]
        shape["points"] = list(zip(numbers[::2], numbers[1::2], strict=True))
    return shape


def line_through(points):
    """Slope and offset of [(value, pixel), ...], and how far the worst one is off that line."""
    (v0, p0), (v1, p1) = min(points), max(points)
    slope = (p1 - p0) / (v1 - v0)
    return slope, p0 - slope * v0, max(abs(p0 + slope * (v - v0) - p) for v, p in points)


class Drawing:
    drawn = {}           # run: {plot over time: {label: line}}, all of them; {a} stands for x and y
    compared_drawn = {}  # plot of the page of several runs: line
    colors_drawn = {}    # run: {button: (label, line)} of the colors of its path
    paths_drawn = {}     # run: lines of command, model, table, and from where errors begin, in mm

    def lines(self, plot):
        """Of a plot over time: {label: values}."""
        return self.js("return Object.fromEntries(Trammel.time.plots.find((p) => p.id === "
                       "arguments[0]).series.map((s) => [s.label, [...s.data]]))", plot)

    def shapes(self, plot, width=640, height=420):
        """What a plot draws on light ground: tag, attributes, points of a path, text."""
        svg = self.js("const p = Trammel.plots.find((p) => p.id === arguments[0]); return "
                      "Trammel.shapes(p.scene, arguments[1], arguments[2], Trammel.light)",
                      plot, width, height)
        found = [shape_of(tag, more) for tag, more in
                 re.findall(r"<(path|rect|circle) ([^>]*)/>", svg)]
        return found + [{**shape_of("text", more), "text": unescape(text)} for more, text in
                        re.findall(r"<text ([^>]*)>([^<]*)</text>", svg)]

    def color(self, role):
        return self.js("return Trammel.light[arguments[0]]", role)

    def paths(self, plot, role, *size):
        """Points of the lines that have the color of a role."""
        color = self.color(role)
        return [s["points"] for s in self.shapes(plot, *size)
                if s["tag"] == "path" and s.get("stroke") == color]

    def test_the_path_has_the_colors_of_what_is_chosen(self):
        for run, colors in self.colors_drawn.items():
            self.open(run)
            rows, steps = self.numbers_of(run), self.steps()
            buttons = {b.text: b for b in self.driver.find_elements(
                "css selector", "[data-plot=path] .segments button") if b.text[0] != "\u00d7"}
            self.assertEqual(list(buttons) or list(colors)[:1], list(colors))
            ramp = self.js("return Array.from({ length: 32 }, (v, k) => Trammel.ramp("
                           "Trammel.light, k / 31))")
            middle, end = (rows[k]["t_s"] for k in (len(rows) // 2, -1))
            since = rows[0]["t_s"] - self.js("return Trammel.time.values[0]")
            for button, (label, line) in colors.items():
                self.js("arguments[0].click()", buttons[button])
                values, off = zip(*(self.value(line, row, " ", steps) for row in rows), strict=True)
                texts = [s["text"] for s in self.shapes("path") if s["tag"] == "text"]
                self.assertIn(label, texts)
                at = texts.index(label)
                top, text, more = max(values), texts[at + 1], max(off)
                self.assertEqual(texts[at - 1], "0")
                self.assertAlmostEqual(float(text), top, delta=more + 0.51 * 10 ** -len(
                    text.partition(".")[2]))
                for zoomed in (False, True):
                    self.js("Trammel.time.zoom(...(arguments[0] ? [arguments[1], arguments[2]] : "
                            "Trammel.time.full))", zoomed, middle - since, end - since)
                    k = 0
                    for one in self.shapes("path"):
                        if one["tag"] != "path" or one["stroke-width"] != "2.4":
                            continue
                        place = ramp.index(one["stroke"])
                        for value in values[k:k + len(one["points"]) - 1]:
                            self.assertLess(abs(32 * value / top - place - 0.5), 0.5 +
                                            64 * more / top, f"{run}, {button}, sample {k}")
                        pale = zoomed and rows[k]["t_s"] < middle - 1e-7
                        self.assertEqual(float(one["opacity"]), 0.15 if pale else 1)
                        k += len(one["points"]) - 1
                    self.assertEqual(k, len(rows) - 1)

    def numbers_of(self, run):
        return [{name: float(value) for name, value in row.items()} for row in self.rows(run)]

    def value(self, line, row, axis, steps):
        """What a line has at a row, and how far the page may be off it."""
        first, more = line if isinstance(line, tuple) else (line, 1)
        if callable(first):
            return first(row, axis), more
        name = first.format(a=axis)
        return row[name] * more, abs(more) * (0.51 * steps[name] + 1e-9)

    def check_line(self, where, line, shown, rows, axis, steps):
        self.assertEqual(len(shown), len(rows), where)
        for k, (value, row) in enumerate(zip(shown, rows, strict=True)):
            wanted, tolerance = self.value(line, row, axis, steps)
            self.assertAlmostEqual(value, wanted, delta=tolerance + 1e-9 * abs(wanted),
                                   msg=f"{where}, row {k}")

    def steps(self, run=0):
        return dict(self.js("return Trammel.page.runs[arguments[0]].channels.map((c) => "
                            "[c.name, c.lsb])", run))

    def test_every_line_over_time_is_that_of_its_column(self):
        for run, plots in self.drawn.items():
            self.see(run)
            wanted = {plot.format(a=axis): (lines, axis) for plot, lines in plots.items()
                      for axis in ("xy" if "{a}" in plot else " ")}
            self.assertEqual(set(self.js("return Trammel.time.plots.map((p) => p.id)")),
                             set(wanted), run)
            rows, steps = self.numbers_of(run), self.steps()
            for plot, (lines, axis) in wanted.items():
                shown = self.lines(plot)
                self.assertEqual(set(shown), set(lines), f"{run} {plot}")
                for label, line in lines.items():
                    if line is not None:
                        self.check_line(f"{run}, plot {plot}, line {label}", line, shown[label],
                                        rows, axis, steps)

    def test_lines_of_compared_runs_are_those_of_their_columns(self):
        if not self.compared_drawn:
            self.skipTest("the machine compares nothing of its own")
        self.see(".", "compare.html")
        self.assertEqual(set(self.js("return Trammel.time.plots.map((p) => p.id)")),
                         {plot.format(a=axis) for plot in self.compared_drawn for axis in "xy"})
        times = self.js("return [...Trammel.time.values]")
        for plot, line in self.compared_drawn.items():
            for axis in "xy" if "{a}" in plot else " ":
                shown = self.js("return Trammel.time.plots.find((p) => p.id === arguments[0])"
                                ".series.map((s) => [s.run, s.data])", plot.format(a=axis))
                self.assertNotEqual(shown, [], plot)
                for k, data in shown:
                    rows = self.numbers_of(self.compared[k])
                    every = (rows[-1]["t_s"] - rows[0]["t_s"]) / (len(rows) - 1)
                    at = [round(t / every) for t in times]
                    gaps = sum((v is None) != (n >= len(rows)) for v, n in zip(data, at,
                                                                               strict=True))
                    self.assertEqual(gaps, 0, f"{plot} of {self.compared[k]}")
                    self.check_line(f"{plot} of {self.compared[k]}", line,
                                    [v for v in data if v is not None],
                                    [rows[n] for n in at if n < len(rows)], axis, self.steps(k))

    def keys(self, plot, *size):
        """The legend of a plot: label: color."""
        shapes = self.shapes(plot, *size)
        marks = {(float(x) + 22, float(y)): s["stroke"] for s in shapes if s["tag"] == "path"
                 and len(s["points"]) == 2 for x, y in [s["points"][0]]
                 if s["points"][1] == (x + 16, y)}
        return {s["text"]: marks[at] for s in shapes if s["tag"] == "text" and "x" in s
                for at in [(float(s["x"]), round(float(s["y"]) - 4.2, 2))] if at in marks}

    def test_a_path_is_drawn_where_the_trace_has_it(self):
        for run, lines in self.paths_drawn.items():
            self.open(run)
            self.check_path(run, *lines)

    def path_frame(self, width, height, plot="path"):
        """Pixels of 0 and of 1 mm, of x and of y."""
        return self.js("const f = Trammel.plots.find((p) => p.id === arguments[0]).frame("
                       "arguments[1], arguments[2]); return [f.x(0), f.x(1), f.y(0), f.y(1)]",
                       plot, width, height)

    def check_path(self, run, asked, model, table, begin):
        rows, steps = self.numbers_of(run), self.steps()
        width, height = 640, self.js("return Trammel.plots.find((p) => p.id === 'path')"
                                     ".height(640)")
        x0, x1, y0, y1 = self.path_frame(width, height)
        self.assertAlmostEqual(x1 - x0, y0 - y1)  # equal scales, y upward
        self.assertGreater(x1, x0)

        def place(line, row, origin=None, larger=1):
            """Pixels of a row; of its error from an origin where that is drawn larger."""
            def at(axis):
                value = self.value(line, row, axis, steps)[0]
                first = self.value(origin, row, axis, steps)[0] if origin else value
                return first + larger * (value - first)
            return x0 + at("x") * (x1 - x0), y0 + at("y") * (y1 - y0)

        def check(points, wanted, what):
            self.assertEqual(len(points), len(wanted), f"{run}, {what}")
            far = max(math.dist(a, b) for a, b in zip(points, wanted, strict=True))
            self.assertLess(far, 0.05, f"{run}, {what}: pixels")

        def colored():
            """The table's line: its parts end where the next ones begin."""
            parts = [s["points"] for s in self.shapes("path", width, height)
                     if s["tag"] == "path" and s["stroke-width"] == "2.4"]
            return parts[0][:1] + [at for part in parts for at in part[1:]]

        for line, role in ((asked, "asked"), (model, "model")):
            if line is not None:
                check(max(self.paths("path", role, width, height), key=len),
                      [place(line, row) for row in rows], role)
        check(colored(), [place(table, row) for row in rows], "table")
        for x, y in colored():  # within the frame: left of labels, above them
            self.assertTrue(60 <= x <= width - 14 and 14 <= y <= height - 60, (run, x, y))
        # The cursor: command, model and table of one sample.
        k = len(rows) // 3
        dots = self.js("Trammel.time.point(arguments[0], null); const p = Trammel.plots.find("
                       "(p) => p.id === 'path'); return Trammel.shapes(p.overlay, "
                       "arguments[1], arguments[2], Trammel.light)", k, width, height)
        dots = [shape_of("circle", one) for one in re.findall(r"<circle ([^>]*)/>", dots)]
        self.assertEqual([dot["fill"] for dot in dots],
                         [self.color(role) for role in ("asked", "model", "actual")])
        for dot, line in zip(dots, (asked, model, table), strict=True):
            if line is not None:
                check([(float(dot["cx"]), float(dot["cy"]))], [place(line, rows[k])],
                      f"cursor, {dot['fill']}")
        if begin is None:
            return
        self.driver.find_element("css selector",
                                 "[data-plot=path] .segments button:nth-child(2)").click()
        x0, x1, y0, y1 = self.path_frame(width, height)
        check(colored(), [place(table, row, begin, 5) for row in rows], "error x 5")

    def test_a_saved_plot_has_the_time_that_is_shown(self):
        run = next(iter(self.drawn or self.runs))
        self.open(run)
        times = self.js("return [...Trammel.time.values]")
        first, last = len(times) // 4, len(times) // 2
        plot, roles = self.js("const p = Trammel.time.plots.find((p) => !p.times && !p.series[0]"
                              ".steps && !p.series[0].hidden); return [p.id, "
                              "p.series.map((s) => s.role)]")
        color = roles[0]
        before = max(self.paths(plot, color), key=len)
        self.assertEqual(len(before), len(times))
        self.js("Trammel.time.zoom(arguments[0], arguments[1])", times[first], times[last])
        after = max(self.paths(plot, color), key=len)
        self.assertAlmostEqual(len(after), last - first + 2, delta=2)
        # The ends of the time that is shown are at the borders of the frame.
        self.assertAlmostEqual(min(x for x, _ in after), min(x for x, _ in before), delta=8)
        self.assertAlmostEqual(max(x for x, _ in after), max(x for x, _ in before), delta=8)

    def test_a_value_holds_until_the_next_one_where_it_is_drawn_in_steps(self):
        run = next(iter(self.drawn or self.runs))
        self.see(run)
        found = self.js("return Trammel.time.plots.flatMap((p) => p.series.map((s) => [p.id, "
                        "s.steps, s.role, s.hidden, [...new Set(s.data)].length]))"
                        ".filter((s) => s[1] && !s[3] && s[4] > 1)")
        for plot, _, role, *_ in found[:4]:
            line = max(self.paths(plot, role), key=len)
            for (x0, y0), (x1, y1), (x2, _) in zip(line[::2], line[1::2], line[2::2]):
                self.assertEqual((y1, x2), (y0, x1), plot)  # first to the next time, then up
                self.assertLessEqual(x0, x1)

    def test_frames_ticks_and_numbers(self):
        self.see(next(iter(self.runs)))
        for script, wanted in (
                ("((f) => [f.x(0), f.x(2), f.y(-1), f.y(1)])("
                 "T.frame({ x: 10, y: 20, w: 100, h: 50 }, [0, 2], [-1, 1]))", [10, 110, 70, 20]),
                ("T.ticks(0, 10, 5)", [0, 2, 4, 6, 8, 10]),
                ("T.ticks(-1, 1, 4)", [-1, -0.5, 0, 0.5, 1]), ("T.ticks(3, 3, 4)", [3]),
                ("T.ticks(0.11, 0.29, 2)", [0.2]),
                ("[T.tickText(0.5, [0, 0.5]), T.tickText(20, [0, 20])]", ["0.5", "20"]),
                ("T.range([3, -1, 2])", [-1, 3]), ("T.range([3], 1, 2)", [1, 3]),
                ("T.padded([0, 10], 0.1)", [-1, 11]), ("T.padded([2, 2], 0.5)", [1, 3]),
                ("T.decades([0, 1.1]).map((one) => one[1])", [1, 2, 5, 10]),
                ("[T.num(-1.25, 2), T.num(-0.04, 1), T.num(NaN, 1)]",
                 ["\u22121.25", "0.0", "\u2013"]),
                ("[T.whole(1234567), T.whole(-1234), T.whole(999)]",
                 ["1\u2009234\u2009567", "\u22121\u2009234", "999"]),
                ("[T.unit('m/s2'), T.unit('um'), T.unit('2x')]", ["m/s\u00b2", "\u00b5m", "2x"]),
                ("[T.valueText(0.1 + 0.2), T.valueText(''), T.valueText(false)]",
                 ["0.3", "\u2013", "false"])):
            self.assertEqual(self.js(f"const T = Trammel; return {script}"), wanted, script)
