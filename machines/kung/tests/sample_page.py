# SPDX-License-Identifier: Apache-2.0
"""What the page of the X-Y table draws of single samples and of several runs: words of the
controller, carrier and one edge of the gates, laps, a spectrum; runs of several paths."""

import math
import re

from drawing import line_through


def whole(text):
    return int(text.replace("\u2009", "").replace("\u2212", "-")) if text else None


class SamplePage:
    def test_every_word_of_the_controller_stands_in_its_step(self):
        self.open("circle")
        steps = self.detail("circle")["moment"]
        table = self.js("return [...document.querySelectorAll('#sample details tbody tr')].map("
                        "(row) => [...row.cells].map((cell) => cell.textContent))")
        self.assertEqual([row[0] for row in table], [f"s{k}" for k in range(35)])
        for axis, at in (("x", 3), ("y", 5)):
            self.assertEqual([whole(row[at]) for row in table],
                             [word for _, word in steps[axis]["steps"]], axis)
        # The step under the pointer is told below the plot: 35 cells from 82 to 14 pixels.
        self.js("""const c = Trammel.plots.find((p) => p.id === 'afc').canvas;
            const box = c.getBoundingClientRect();
            c.dispatchEvent(new MouseEvent('mousemove', { clientX: box.left + c.clientLeft + 82 +
              4.5 * (c.clientWidth - 96) / 35, clientY: box.top + 50 }));""")
        told = self.js("return [...document.querySelectorAll('dl.step b')].map((b) => "
                       "b.textContent)")
        self.assertEqual(told[0], "s4")
        words = [steps[axis]["steps"][4] for axis in "xy"]
        self.assertEqual([whole(text) for text in told[1:]], [word for _, word in words])
        self.assertEqual(self.js("return [...document.querySelectorAll('#sample tr.picked')].map("
                                 "(row) => row.cells[0].textContent)"), ["s4"])

    def test_one_edge_is_enlarged_of_the_leg_that_is_chosen(self):
        self.open("circle")
        gates = self.detail("circle")["gates"]
        length = gates["end"] - gates["begin"]
        card = self.driver.find_element("css selector", "[data-plot=pwm]")
        buttons = {b.text: b for b in card.find_elements("css selector", ".segments button")}
        for axis in (1, 0):
            self.js("arguments[0].click()", buttons["XY"[axis]])
            for phase in range(3):
                self.js("arguments[0].click()", buttons["ABC"[phase]])
                spans, begin = [], None
                for edge, word in gates["edges"]:
                    on = word >> (6 * axis + phase) & 1 or word >> (6 * axis + 3 + phase) & 1
                    if not on and begin is None:
                        begin = edge - gates["begin"]
                    elif on and begin is not None:
                        spans += [(begin, edge - gates["begin"])] if begin > 0 else []
                        begin = None
                first, last = min(spans, key=lambda one: abs(one[0] - length / 2))
                shapes = self.shapes("dead-time")
                texts = [s["text"] for s in shapes if s["tag"] == "text"]
                self.assertIn(f"{last - first} clocks = {(last - first) * 0.02:.2f} \u00b5s", texts)
                self.assertTrue({f"{'ABC'[phase]} hi", f"{'ABC'[phase]} lo"} <= set(texts))
                ticks = [(float(s["text"]), float(s["x"])) for s in shapes if s["tag"] == "text"
                         and s["text-anchor"] == "middle" and re.fullmatch(r"[\d.]+", s["text"])]
                ink = self.color("ink")
                ends = sorted(s["points"][0][0] for s in shapes if s["tag"] == "path" and
                              s.get("stroke") == ink and s.get("stroke-dasharray") == "2 2")
                slope, offset, _ = line_through(ticks)
                for clock, x in zip((first, last), ends, strict=True):
                    self.assertAlmostEqual(x, offset + slope * clock * 0.02, delta=0.3)

    def test_compare_values_lie_on_the_carrier(self):
        self.open("circle")
        gates = self.detail("circle")["gates"]
        peak = (gates["end"] - gates["begin"]) // 2 // 2
        card = self.driver.find_element("css selector", "[data-plot=pwm]")
        for axis in (0, 1):
            self.js("arguments[0].click()", card.find_elements("css selector",
                                                               ".segments button")[axis])
            (carrier,) = [points for points in self.paths("pwm", "faint") if len(points) == 5]
            level = [(value, y) for value, (_, y) in zip((0, peak, 0, peak, 0), carrier,
                                                         strict=True)]
            for phase, role in enumerate(("x", "y", "other")):
                lines = [points for points in self.paths("pwm", role) if len(points) == 2]
                self.assertEqual(len(lines), len(gates["compare"]))
                for period, (points, axes) in enumerate(zip(lines, gates["compare"], strict=True)):
                    self.assertEqual(points[0][1], points[1][1])
                    self.assertEqual([x for x, _ in points],
                                     [carrier[2 * (period + k)][0] for k in (0, 1)])
                    level.append((axes[axis][phase], points[0][1]))
            slope, _, worst = line_through(level)
            self.assertLess(slope, 0)
            self.assertLess(worst, 0.03)

    def test_laps_and_spectrum_are_drawn_at_their_values(self):
        self.see("precision")
        laps = [f["value"] for f in self.metrics("precision")["figures"]
                if f["id"].startswith("lap_error_um.")]
        self.assertGreater(len(laps), 1)
        shapes, color = self.shapes("laps"), self.color("actual")
        bars = [s for s in shapes if s["tag"] == "rect" and s["fill"] == color]
        self.assertEqual([float(s["x"]) for s in bars], sorted(float(s["x"]) for s in bars))
        ticks = [(float(s["text"]), float(s["y"]) - 0.35 * 11.5) for s in shapes
                 if s["tag"] == "text" and s["text-anchor"] == "end"]
        _, _, worst = line_through(ticks + [(lap, float(bar["y"])) for lap, bar in
                                            zip(laps, bars, strict=True)])
        self.assertLess(worst, 0.05)
        for axis in "xy":
            amplitudes = self.js("return Trammel.page.runs[0].detail.spectrum[arguments[0]]", axis)
            step = 2000 / 2 / (len(amplitudes) - 1)  # Hz: half of the sample rate at the end
            shapes = [s for s in self.shapes(f"spectrum-{axis}") if s["tag"] == "text" and
                      re.fullmatch(r"[\d.]+", s["text"])]
            across = [(math.log10(float(s["text"])), float(s["x"])) for s in shapes
                      if s["text-anchor"] == "middle"]
            upward = [(math.log10(float(s["text"])), float(s["y"]) - 0.35 * 11.5) for s in shapes
                      if s["text-anchor"] == "end"]
            line = max(self.paths(f"spectrum-{axis}", axis), key=len)
            for k, (value, (x, y)) in enumerate(zip(amplitudes[1:], line, strict=True), 1):
                across.append((math.log10(k * step), x))
                upward.append((math.log10(max(value, 1e-12)), y))
            for points in (across, upward):
                self.assertLess(line_through(points)[2], 0.1, axis)

    # ---- several runs ----

    def test_runs_of_two_kinds_of_path_have_plots_of_their_own(self):
        names = ("circle", "step", "small-fc")
        self.report(*names, page="kinds.html")
        self.open(".", "kinds.html")
        plots = self.js("return Trammel.time.plots.map((p) => [p.id, p.series.map((s) => s.run)])")
        self.assertEqual(plots, [["tracking-circle", [0, 2]], ["tracking-square", [1]]])
        # They open with the longest of the circles; the square lasts longer.
        lasts = [(len(self.rows(name)) - 1) * 0.5e-3 for name in names]
        low, high = self.js("return Trammel.time.range")
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, min(max(lasts[0], lasts[2]), max(lasts)), delta=1e-9)
        told = self.js("return [...document.querySelector('#figures tbody tr').cells].map((cell) "
                       "=> !!cell.querySelector('div small'))")
        self.assertEqual(told, [False, False, False, True])
        self.assertEqual(len(self.driver.find_elements("css selector", "#paths .card")), 3)
        runs = self.rows_of("#runs tbody tr")
        for name, cells in zip(names, runs, strict=True):
            metrics = self.metrics(name)
            self.assertEqual([cell[0] for cell in cells[1:]],
                             [metrics["verdict"], metrics["command"]])

    def test_small_paths_are_those_of_their_runs(self):
        self.see(".", "compare.html")
        for k, name in enumerate(self.compared):
            plot = f"path-{k + 1}"
            color = self.js("return Trammel.light.runs[arguments[0]]", k)
            rows = self.numbers_of(name)
            table = max((s["points"] for s in self.shapes(plot) if s["tag"] == "path" and
                         s.get("stroke") == color), key=len)
            asked = max(self.paths(plot, "asked"), key=len)
            slopes = []
            for at, axis in enumerate("xy"):
                points = [(row[f"{axis}_{column}_m"], pixel[at]) for line, column in
                          ((table, "position"), (asked, "command"))
                          for row, pixel in zip(rows, line, strict=True)]
                slope, _, worst = line_through(points)
                self.assertLess(worst, 0.05, f"{name} {axis}")
                slopes.append(slope)
            self.assertAlmostEqual(slopes[0], -slopes[1], delta=1e-3 * slopes[0])
            self.assertEqual(self.js("return document.querySelector(`[data-plot=${arguments[0]}] "
                                     "h3`).firstChild.textContent", plot),
                             self.js("return Trammel.page.runs[arguments[0]].label", k))
