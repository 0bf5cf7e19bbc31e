#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Open report pages of the machine an693 in headless Chromium: what holds for every machine, and
what these show beyond it: interrupts, the script that drove the part, runs of both kinds compared.

usage: report_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import report_pages


class Page(report_pages.ReportPages):
    BITS = {7: "motor off", 6: "breakpoint", 5: "position error", 4: "wraparound",
            3: "index pulse", 2: "trajectory complete", 1: "command error"}  # SNVS781C
    runs = {
        "tuning": ["run", "an693-tuning", "-s", "trajectory.steps=2"],
        "script": ["lm628", "tuning"],
        "turn": ["run", "an693-relative", "--engine", "twin",
                 "-s", "trajectory.position_counts=3000"],
        "soft": ["run", "an693-tuning", "-s", "trajectory.steps=2", "-s", "filter.kp=80"],
    }
    compared = ("tuning", "script", "soft")
    values = {"tuning": {"t_s": 1e-8, "desired_count": 1e-3, "theta_count": 1e-3, "p": 0,
                         "status": 0, "host_irq": 0, "omega_rad_s": 1e-4, "u_V": 1e-4}}
    least_plots = 6
    least_saved = 7
    # A turn has 4000 counts, a sample 256 us.
    drawn = {"turn": {
        "position": {"desired": "desired_count", "shaft": "theta_count",
                     "real, as counted": "real_count"},
        "speed": {"desired": ("desired_speed", 1 / 4000 / 256e-6),
                  "shaft": ("omega_rad_s", 1 / (2 * math.pi))},
        "error": {"e": "e"}, "terms": {name: name for name in ("output", "d", "p", "i")},
        "voltage": {"u": "u_V"}, "current": {"i": "i_A"}}}
    better_small = "motion.overshoot_counts motion.settled_s motion.max_error_counts"
    compared_drawn = {"position": "theta_count", "error": "e", "output": "output",
                      "speed": ("omega_rad_s", 1 / (2 * math.pi))}

    def asides(self, metrics):
        motion = metrics["motion"]
        whole = [f"{motion[key]:,}".replace(",", "\u2009").replace("-", "\u2212")
                 for key in ("samples", "desired_count")]
        return {"motion.time_s": f"{whole[0]} samples",
                "motion.real_count": f"desired {whole[1]}; {motion['real_count'] / 4000:.2f} turns",
                "motion.overshoot_counts": "beyond the desired position",
                "motion.max_error_counts": "as the part saw it",
                "motion.max_speed_rev_s": f"{60 * motion['max_speed_rev_s']:.0f} rev/min",
                "motion.max_current_A": f"voltage {motion['max_voltage_V']:.2f} V"}

    def test_chips_name_the_part(self):
        for name, words in (("tuning", ["LM628"]), ("script", ["LM628", "script"])):
            self.see(name)
            self.assertEqual(self.js("return [...document.querySelectorAll('.head-title .chip')]"
                                     ".map((c) => c.textContent)")[:-1], words)
        self.assertEqual(self.js("return Trammel.machines.an693.chips({ options: { 'chip.variant': "
                                 "'lm629' } })"), ["LM629"])

    def test_bars_of_the_status_are_where_its_bits_are_set(self):
        self.see("turn")
        rows = self.numbers_of("turn")
        shapes = self.shapes("status", 640, 250)
        names = {s["text"]: float(s["y"]) - 4.2 for s in shapes if s["tag"] == "text" and
                 s["text-anchor"] == "end"}
        # SNVS781C: busy is bit 0, motor off bit 7.
        bits = [self.BITS[n] for n in range(1, 8)]
        self.assertEqual(list(names), ["HI", *reversed(bits)])
        begin, end = rows[0]["t_s"], rows[-1]["t_s"]
        drawn = 0
        for name, middle in names.items():
            bars = sorted((float(s["x"]), float(s["x"]) + float(s["width"])) for s in shapes if
                          s["tag"] == "rect" and abs(float(s["y"]) + float(s["height"]) / 2 -
                                                     middle) < 0.1)
            values = [int(row["host_irq"]) & 1 if name == "HI" else
                      int(row["status"]) >> 1 + bits.index(name) & 1 for row in rows]
            wanted = []
            for k, (before, now) in enumerate(zip([0, *values], [*values, 0], strict=True)):
                x = 146 + (rows[min(k, len(rows) - 1)]["t_s"] - begin) / (end - begin) * 480
                if now and not before:
                    wanted.append((x, x + 2))
                elif before and not now:
                    wanted[-1] = (wanted[-1][0], max(wanted[-1][0] + 2, x))
            self.assertEqual(len(bars), len(wanted), name)
            for bar, place in zip(bars, wanted, strict=True):
                for a, b in zip(bar, place, strict=True):
                    self.assertAlmostEqual(a, b, delta=0.03, msg=name)
            drawn += len(bars)
        self.assertGreater(drawn, 1)

    def test_pointing_at_the_status_is_pointing_at_its_time_in_all_plots(self):
        self.open("turn")
        rows = self.numbers_of("turn")
        begin, end = rows[0]["t_s"], rows[-1]["t_s"]
        plot = self.driver.find_element("css selector", "[data-plot=status] .plot")
        self.js("arguments[0].scrollIntoView({block: 'center'})", plot)
        for part in (0.01, 0.3, 0.75, 0.99, -0.05, 1.02):
            found, width = self.js("""
              const canvas = arguments[1], box = canvas.getBoundingClientRect();
              const width = canvas.clientWidth;
              canvas.dispatchEvent(new MouseEvent('mousemove', { bubbles: true,
                clientX: box.left + 146 + arguments[0] * (width - 160), clientY: box.top + 20 }));
              return [Trammel.time.plots.filter((p) => p.uplot.cursor.idx != null &&
                p.uplot.cursor.left >= 0).map((p) => p.uplot.data[0][p.uplot.cursor.idx]), width];
              """, part, plot)
            with self.subTest(part=part):
                if not 0 <= part <= 1:
                    self.assertEqual(found, [])
                    continue
                self.assertGreater(len(found), 1)
                pixel = (end - begin) / (width - 160)
                for time in found:
                    self.assertAlmostEqual(time, begin + part * (end - begin), delta=2 * pixel)

    def test_lines_of_a_script_have_their_times_and_answers(self):
        self.see("script")
        script = self.metrics("script")["script"]
        self.assertGreater(len(script), 5)
        for cells, one in zip(self.rows_of("#script tbody tr"), script, strict=True):
            self.assertAlmostEqual(float(cells[0][0]), one["time_s"], delta=0.51e-6)
            self.assertEqual(cells[1][0], one["line"])
            words = [one.get("hex"), one.get("bits")]
            if "value" in one and "bits" not in one:
                words.append(f" {one['value']:g} {one.get('unit', '')}")
            for word in filter(None, words):
                self.assertIn(word, f" {cells[2][0]}")
            self.assertEqual("after" in cells[2][0], "waited_s" in one)

    def test_the_page_tells_its_interrupts_and_script(self):
        self.see("tuning")
        interrupts = self.metrics("tuning")["interrupts"]
        self.assertEqual(self.js("return Trammel.time.marks"),
                         [one["time_s"] for one in interrupts])
        table = self.driver.find_element("css selector", "#status table").text
        self.assertEqual(table.count("trajectory complete"), len(interrupts))
        self.assertNotIn("busy", table)
        rows = self.rows_of("#status tbody tr")
        for row, one in zip(rows, interrupts, strict=True):
            self.assertEqual([cell[0] for cell in row[3:5]],
                             [str(one["desired_count"]), str(one["real_count"])])
            self.assertAlmostEqual(float(row[2][0]), one["time_s"], delta=0.51e-5)
            self.assertEqual(row[1][0].replace("\u2009", ""), str(one["sample"])
                             if one["sample"] else "before the motion")
            names = [name for bit, name in self.BITS.items() if one["status"] >> bit & 1]
            self.assertEqual(row[5][0], ", ".join(names))
        speed = self.metrics("tuning")["motion"]["max_speed_rev_s"]
        self.assertIn(f"{60 * speed:.0f} rev/min", self.driver.find_element("id", "top").text)
        self.assertIn("First step settled", self.driver.find_element("id", "figures").text)
        self.see("script")
        script = self.driver.find_element("id", "script").text
        for line in ("LTRJ 0003h -50", "RDRP", "00000030h 48 counts"):
            self.assertIn(line, script)
        self.assertNotIn("filter", self.driver.find_element("id", "parameters").text)

    def test_a_run_and_a_script_are_compared(self):
        self.see(".", "compare.html")
        lengths = [len(self.rows(name)) for name in self.compared]
        self.assertEqual(self.filled(), [[max(lengths), *lengths]] * 4)


if __name__ == "__main__":
    sys.exit(report_pages.main(Page, __doc__))
