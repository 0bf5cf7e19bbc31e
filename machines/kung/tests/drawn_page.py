# SPDX-License-Identifier: Apache-2.0
"""What only the page of the X-Y table draws, held against the files of the run: rules, surface,
gates, steps, Bode plots, and the errors of the precision controller."""

import json
import math
from itertools import pairwise

from drawing import line_through

RULE = 1 << 20  # a rule of 1 unit
KNOTS = (-6, -4, -2, 0, 2, 4, 6)


class DrawnPage:
    def detail(self, name):
        return json.loads((self.folder / name / "detail.json").read_text())

    def cells(self, plot):
        """Of a heat map: (column from the left, row from below): center, and text or None."""
        shapes = self.shapes(plot, 460, 340)
        rects = [s for s in shapes if s["tag"] == "rect"]
        self.assertEqual(len(rects), 49)
        center = [(float(r["x"]) + float(r["width"]) / 2, float(r["y"]) + float(r["height"]) / 2)
                  for r in rects]
        xs, ys = sorted({x for x, _ in center}), sorted({y for _, y in center}, reverse=True)
        half = float(rects[0]["width"]) / 2
        texts = [(float(s["x"]), float(s["y"]), s["text"]) for s in shapes
                 if s["tag"] == "text" and "x" in s]
        return {(xs.index(x), ys.index(y)): ((x, y), next(
            (t for tx, ty, t in texts if abs(tx - x) < half and abs(ty - y) < half), None))
            for x, y in center}

    def test_a_rule_stands_where_its_e_and_de_are(self):
        self.see("circle")
        for axis in "xy":
            rules = self.detail("circle")["rules"][axis]
            change = [b - a for a, b in zip(rules["first"], rules["last"], strict=True)]
            self.assertNotEqual(change, [0] * 49)
            for plot, values, digits in (("before", rules["first"], 1), ("after", rules["last"], 1),
                                         ("change", change, 2)):
                for (e, de), (_, text) in self.cells(f"rules-{axis}-{plot}").items():
                    value = values[7 * de + e] / RULE
                    if text is None:
                        self.assertLess(abs(value), 0.005)
                    else:
                        self.assertAlmostEqual(float(text.replace("\u2212", "-")), value,
                                               delta=0.51 * 10 ** -digits,
                                               msg=f"{axis} {plot}, e {KNOTS[e]}, de {KNOTS[de]}")

    def test_the_line_over_the_rules_is_that_of_e_and_de(self):
        self.see("small-fc")
        options, rows = self.metrics("small-fc")["options"], self.numbers_of("small-fc")
        for axis in "xy":
            cells = self.cells(f"rules-{axis}-fixed")
            to_x = line_through([(KNOTS[e], at[0]) for (e, _), (at, _) in cells.items()])
            to_y = line_through([(KNOTS[de], at[1]) for (_, de), (at, _) in cells.items()])
            (line,) = self.paths(f"rules-{axis}-fixed", "ink", 460, 340)
            for row, (x, y) in zip(rows, line, strict=True):
                for word, (slope, offset, _), pixel in (("e", to_x, x), ("de", to_y, y)):
                    units = row[f"{axis}_{word}"] * 2 ** options[f"gains.{axis}.shift_{word}"] / 256
                    self.assertAlmostEqual(pixel, offset + slope * max(-6, min(6, units)),
                                           delta=0.02, msg=f"{axis} {word}")

    def test_the_surface_goes_through_the_rules(self):
        self.see("circle")
        for axis in "xy":
            rules = self.detail("circle")["rules"][axis]["last"]
            closed = [s["points"] for s in self.shapes(f"surface-{axis}", 460, 340)
                      if s["tag"] == "path" and s["d"].endswith("Z")]
            base, *facets = closed
            self.assertEqual(len(facets), 24 * 24)
            corners = {(round(x, 1), round(y, 1)) for facet in facets for x, y in facet}
            (x0, y0), (x1, y1), _, (x2, y2) = base  # e, de: -6, -6; 6, -6; -6, 6; u = -8
            rise = None
            for de in range(7):
                for e in range(7):
                    x = x0 + (x1 - x0) * e / 6 + (x2 - x0) * de / 6
                    y = y0 + (y1 - y0) * e / 6 + (y2 - y0) * de / 6
                    value = rules[7 * de + e] / RULE + 8
                    if rise is None:  # pixels of a unit, from the first rule
                        rise = min(abs(cy - y) / value for cx, cy in corners if abs(cx - x) < 0.15)
                        self.assertGreater(rise, 5)
                    near = min(math.dist((x, y - rise * value), corner) for corner in corners)
                    self.assertLess(near, 0.4, f"{axis}, e {KNOTS[e]}, de {KNOTS[de]}")

    def test_the_gates_are_drawn_as_they_switched(self):
        self.see("circle")
        detail = self.detail("circle")
        gates = detail["gates"]
        row = next(r for r in self.numbers_of("circle") if r["tick"] >= detail["moment"]["tick"])
        axis = int(abs(row["y_v_m_s"]) > abs(row["x_v_m_s"]))
        pressed = self.driver.find_element(
            "css selector", "[data-plot=pwm] .segments button[aria-pressed=true]").text
        self.assertEqual(pressed, "XY"[axis])  # the one that moves faster
        ends = [edge for edge, _ in gates["edges"][1:]] + [gates["end"]]
        spans = [(end - edge, word) for (edge, word), end in zip(gates["edges"], ends, strict=True)]
        whole = gates["end"] - gates["begin"]
        color = {"actual": 0, "model": 3}
        for role, first in color.items():
            lines = [points for points in self.paths("pwm", role) if len(points) > 3]
            self.assertEqual(len(lines), 3, role)
            for phase, line in enumerate(lines):
                bit = 6 * axis + first + phase
                wanted = sum(clocks for clocks, word in spans if word >> bit & 1) / whole
                top = min(y for _, y in line)
                drawn = sum(b[0] - a[0] for a, b in pairwise(line)
                            if a[1] == b[1] == top) / (line[-1][0] - line[0][0])
                self.assertAlmostEqual(drawn, wanted, delta=0.004, msg=f"phase {phase}, {role}")
        dead = [end - begin for begin, end in self.dead_times(gates, axis)]
        note = self.driver.find_element("css selector", "[data-plot=pwm] .note").text
        self.assertIn(f"{len(dead)} dead times", note)
        self.assertIn(f"the shortest {min(dead)} clocks = {min(dead) * 0.02:.2f} \u00b5s", note)

    def test_the_dead_times_are_counted_and_the_shortest_is_told(self):
        folder = self.folder / "circle"
        detail = self.detail("circle")
        gates = detail["gates"]
        # One of the legs of each axis is off for 7 clocks longer than it was, once.
        for axis in (0, 1):
            spans = self.dead_times(gates, axis)
            late = next(n for n, (edge, word) in enumerate(gates["edges"])
                        if edge == spans[len(spans) // 2][1])
            gates["edges"][late][0] += 7
            gates["edges"].sort(key=lambda one: one[0])
        # All gates off for good: what has no end in the window is no dead time.
        last = 7 * len(gates["edges"]) // 8
        gates["edges"][last:] = [[gates["edges"][last][0], 0]]
        changed = self.folder / "dead"
        changed.mkdir(exist_ok=True)
        for file in ("metrics.json", "trace.csv"):
            (changed / file).write_bytes((folder / file).read_bytes())
        (changed / "detail.json").write_text(json.dumps(detail), encoding="utf-8")
        self.report("dead", page="dead.html")
        self.open(".", "dead.html")
        clock_us = self.metrics("circle")["run"]["clock_ps"] * 1e-6
        card = self.driver.find_element("css selector", "[data-plot=pwm]")
        for axis in (0, 1):
            card.find_elements("css selector", ".segments button")[axis].click()
            lengths = sorted(end - begin for begin, end in self.dead_times(gates, axis))
            self.assertGreater(lengths[-1], lengths[0])
            self.assertIn(f"{len(lengths)} dead times in the window (grey), the shortest "
                          f"{lengths[0]} clocks = {lengths[0] * clock_us:.2f} \u00b5s.", card.text)

    def dead_times(self, gates, axis):
        """Of the legs of an axis, as [begin, end], those that lie inside the window."""
        spans = []
        for phase in range(3):
            begin = None
            for edge, word in gates["edges"]:
                on = word >> (6 * axis + phase) & 1 or word >> (6 * axis + 3 + phase) & 1
                if not on and begin is None:
                    begin = edge
                elif on and begin is not None:
                    if begin > gates["begin"]:
                        spans.append([begin, edge])
                    begin = None
        return sorted(spans)

    def test_a_bode_plot_has_gain_above_phase(self):
        self.see("response")
        for loop in ("speed", "current"):
            plot = f"bode-{loop}-x"
            if not self.js("return Trammel.plots.some((p) => p.id === arguments[0])", plot):
                continue
            rows = self.detail("response")["response"][loop]["x"]
            self.assertEqual(self.keys(plot), {"closed": self.color("actual"),
                                               "open": self.color("model")})
            middles = []
            for part in (0, 1):  # gain, phase
                points = []
                for role, column in (("actual", 1), ("model", 3)):
                    line = [one for one in self.paths(plot, role) if len(one) == len(rows)][part]
                    points += [(row[column + part], y) for row, (_, y) in zip(rows, line)]
                    _, _, off = line_through([(math.log10(row[0]), x)
                                              for row, (x, _) in zip(rows, line)])
                    self.assertLess(off, 0.05)
                slope, _, off = line_through(points)
                self.assertLess(slope, 0)
                self.assertLess(off, 0.05, f"{loop}, part {part}")
                middles.append(sum(y for _, y in points) / len(points))
            self.assertLess(*middles)

    def test_periods_of_a_square_lie_over_its_levels(self):
        self.see("step")
        options, rows = self.metrics("step")["options"], self.numbers_of("step")
        half = options["path.square_half_samples"]
        low, high = (options[f"path.square_{end}_m"] for end in ("low", "high"))
        for axis in "xy":
            commands = [row[f"{axis}_command_m"] for row in rows]
            self.assertEqual((commands[half // 2], commands[half + half // 2]), (high, low))
            (levels,) = [points for points in self.paths(f"periods-{axis}", "asked")
                         if len(points) == 4]
            self.assertLess(levels[0][1], levels[3][1])  # first the high one
            slope = (levels[3][1] - levels[0][1]) / (low - high)
            (model,) = [points for points in self.paths(f"periods-{axis}", "model")
                        if len(points) > 4]
            table = max(self.paths(f"periods-{axis}", "actual"), key=len)
            self.assertEqual(len(table), 2 * half)  # the second period, the last of them
            for k in range(0, 2 * half, 7):
                row = rows[2 * half + k]
                for line, name in ((model, "model"), (table, "position")):
                    wanted = levels[0][1] + slope * (row[f"{axis}_{name}_m"] - high)
                    self.assertAlmostEqual(line[k][1], wanted, delta=0.05, msg=f"{axis} {name} {k}")

    def test_words_of_the_controller_have_their_physical_values(self):
        self.see("circle")
        steps = self.detail("circle")["moment"]
        count, tick = 5e-6, 0.5e-3
        # Step, value of its word's least bit, digits, unit: rtl/control/afc.md.
        known = ((5, count / 16384 * 1e3, 4, "mm"), (6, count * 1e3, 3, "mm"),
                 (7, count / 16 / tick, 4, "m/s"), (9, count / tick, 4, "m/s"),
                 (11, 1 / 1024, 3, "units"), (12, 1 / 2048, 4, ""),
                 (25, count / 16 / tick / 4096, 4, "m/s"), (26, count / 16 / tick, 4, "m/s"),
                 (29, 9.6 / 4096, 4, "A"), (31, 1 / RULE, 4, "units"))
        table = self.js("return [...document.querySelectorAll('#sample details tbody tr')].map("
                        "(row) => [...row.cells].map((cell) => cell.textContent))")
        for step, least, digits, unit in known:
            for axis, at in (("x", 3), ("y", 5)):
                word = steps[axis]["steps"][step][1]
                text = table[step][at + 1].replace("\u2212", "-").split()
                self.assertAlmostEqual(float(text[0]), word * least, delta=0.51 * 10 ** -digits,
                                       msg=f"s{step} of {axis}")
                self.assertEqual(" ".join(text[1:]), unit, f"s{step}")

    # ---- the precision controller ----

    def precision_rows(self):
        return [{key: float(value) for key, value in row.items()} for row in self.precise()]

    def test_an_error_beside_the_path_is_drawn_on_its_side(self):
        self.see("precision")
        rows, trace = self.precision_rows(), self.numbers_of("precision")
        card = self.driver.find_element("css selector", "[data-plot=contour-large]")
        factor = next(float(b.text[1:].replace("\u2009", "")) for b in card.find_elements(
            "css selector", ".segments button") if b.get_attribute("aria-pressed") == "true")
        size = (640, 560)
        x0, x1, y0, y1 = self.path_frame(*size, plot="contour-large")
        parts = [s["points"] for s in self.shapes("contour-large", *size)
                 if s["tag"] == "path" and s["stroke-width"] == "2.4"]
        drawn = parts[0][:1] + [at for part in parts for at in part[1:]]
        checked = 0
        for (px, py), row, at in zip(drawn, rows, trace, strict=True):
            speed = math.hypot(row["x_command_m_s"], row["y_command_m_s"])
            if row["counted"] != 1 or speed < 1e-3:
                continue
            # The part of what is off (true less command) across the way, factor times, in mm.
            way = (row["x_command_m_s"] / speed, row["y_command_m_s"] / speed)
            left = (-way[1], way[0])
            off = -(left[0] * row["x_error_um"] + left[1] * row["y_error_um"]) * 1e-3 * factor
            self.assertAlmostEqual(px, x0 + (1e3 * at["x_command_m"] + left[0] * off) * (x1 - x0),
                                   delta=0.3)
            self.assertAlmostEqual(py, y0 + (1e3 * at["y_command_m"] + left[1] * off) * (y1 - y0),
                                   delta=0.3)
            checked += 1
        self.assertGreater(checked, 500)

    def test_bins_hold_the_errors_of_their_places(self):
        self.see("precision")
        rows = [row for row in self.precision_rows() if row["counted"] == 1]
        reach = max(abs(row[f"{axis}_error_um"]) for row in rows for axis in "xy")
        for axis in "xy":
            bins = self.js("return Trammel.plots.find((p) => p.id === 'histogram').bins"
                           f".{axis}")
            wanted = [0] * len(bins)
            for row in rows:
                part = (row[f"{axis}_error_um"] / reach + 1) / 2
                wanted[min(len(bins) - 1, int(part * len(bins)))] += 100 / len(rows)
            moved = sum(abs(a - b) for a, b in zip(bins, wanted, strict=True))
            self.assertLess(moved, 2, axis)  # values at the border of two bins are rounded
            # Drawn with negative errors to the left.
            line = max(self.paths("histogram", axis), key=len)
            tall = [y for _, y in line[::2]]
            self.assertGreater(line[-1][0], line[0][0])
            self.assertEqual(tall.index(min(tall)), bins.index(max(bins)))

    def test_the_table_beside_has_its_figures_in_their_columns(self):
        self.see("precision")
        metrics = self.metrics("precision")
        ids = [("error_um", key) for key in ("mean", "rms", "p99", "max")] + [
            ("contour_um", key) for key in ("mean", "max")]
        head = self.driver.find_element("css selector", "#beside thead").text
        places = [head.index(word) for word in ("mean (\u00b5m)", "rms", "99 %", "max",
                                                "from the path")]
        self.assertEqual(places, sorted(places))
        (cells, *_) = self.js("return [...document.querySelectorAll('#beside tbody tr')].map("
                              "(row) => [...row.cells].map((cell) => cell.textContent))")
        for cell, (group, key) in zip(cells[1:], ids, strict=False):
            self.assertAlmostEqual(float(cell.replace("\u2009", "")), metrics[group][key],
                                   delta=0.51 if metrics[group][key] >= 100 else 0.0051,
                                   msg=f"{group} {key}")
