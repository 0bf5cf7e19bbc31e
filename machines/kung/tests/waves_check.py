#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wave files of real runs: both formats, their names, the view for GTKWave, the docs' pictures.

usage: waves_check.py PROGRAM      the built trammel program
"""

import json
import re
import shlex
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
from wave_case import WaveCase, WaveFile, main

ROOT = Path(__file__).resolve().parents[3]
LINE = ["-s", "path.kind=line", "-s", "path.line_end_x_m=0.11", "-s",
        "path.line_end_y_m=0.105", "-s", "path.line_ticks=10", "-s", "run.reached_m=1"]


class WavesTest(WaveCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        window = ["--wave-trigger", "rise x.gate_hi", "--wave-window", "-20us:60us"]
        cls.fst = cls.run_line("a", "--wave", "fst", *window) / "waves.fst"
        cls.vcd = cls.run_line("b", "--wave", "vcd", *window) / "waves.vcd"

    @classmethod
    def run_line(cls, name, *words, code=0):
        out = cls.folder / name
        cls.trammel("run", "circle", *LINE, "--no-report", "-o", out, *words, code=code)
        return out

    def test_vcd_and_fst_hold_the_same(self):
        self.assertRegex(self.wave("compare", self.fst, self.vcd), r"^equal: 1\d\d\d signals$")
        back = self.folder / "back.fst"
        self.wave("convert", self.vcd, back)
        self.assertRegex(self.wave("compare", self.fst, back), r"^equal: 1\d\d\d signals$")

    def test_another_dead_time_differs_at_the_gates_of_its_axis_from_its_turn_on(self):
        window = ["--wave", "fst", "--wave-trigger", "drives", "--wave-window", "-1us:40us"]
        other = self.run_line("c", *window, "-s", "chip.y.dead_time_ns=1980") / "waves.fst"
        base = self.run_line("d", *window) / "waves.fst"
        legs = [f"gen_axis[{axis}].u_axis.gen_leg[?].u_leg.hi_o" for axis in (0, 1)]
        self.wave("compare", base, other, "--signals", legs[0])
        found = json.loads(self.wave("compare", base, other, "--signals", legs[1], "--json",
                                     code=1))
        self.assertEqual(found["differing"], 3)
        first = found["first"][0]
        self.assertEqual((first["a"], first["b"]), (0, 1))  # 20 ns earlier
        self.wave("compare", base, other, "--signals", legs[1], "--window",
                  f"0:{first['t_s'] * 1e9:.0f}ns")

    def test_the_chip_is_the_top_scope_and_its_ports_stand_there_once(self):
        names = WaveFile(self.fst).names
        self.assertEqual({name.split(".")[0] for name in names}, {"kung_xy"})
        self.assertFalse([name for name in names if name.startswith("kung_xy.kung_xy")])
        self.assertEqual([name for name in names if name.endswith(".s_axil_awaddr_i")],
                         ["kung_xy.s_axil_awaddr_i", "kung_xy.u_regs.s_axil_awaddr_i"])

    def test_the_view_names_signals_that_are_there_in_all_its_groups(self):
        view = self.check_view(self.fst)
        marker = re.search(r"^\*\S+ (\d+) -1", view, re.M)[1]
        rise = WaveFile(self.fst).changes("kung_xy.gate_hi_o")[1][0]
        self.assertEqual(int(marker), rise)
        begin = rise - 20_000
        self.assertEqual(WaveFile(self.fst).clock()[1], list(range(begin, begin + 80_000, 20)))

    def test_a_window_of_every_period_and_nothing_between(self):
        wave = WaveFile(self.run_line("e", "--wave", "fst", "--wave-every", "5ms",
                                      "--wave-window", "1ms:1.01ms") / "waves.fst")
        rising = wave.clock()[1]
        self.assertGreaterEqual(len(rising), 2000)
        for place, time in enumerate(rising):
            self.assertEqual(time, (place // 500) * 5_000_000 + 1_000_000 + (place % 500) * 20)

    def test_windows_show_what_a_run_traced_throughout_shows(self):
        short = ["--wave", "fst", "-s", "run.max_s=0.0035"]
        whole = self.run_line("g", *short, "--wave-window", "2ms:3.2ms", code=5) / "waves.fst"
        parts = self.run_line("h", *short, "--wave-every", "501.34us", "--wave-window",
                              "2.1ms:2.107ms", code=5) / "waves.fst"
        begins = [2_100_000 + n * 501_340 for n in range(3)]
        rising = set(WaveFile(parts).clock()[1])
        for begin in begins:
            self.assertLessEqual({begin, begin + 6980}, rising)
            self.assertNotIn(begin + 7000, rising)
            told = self.wave("compare", whole, parts, "--window", f"{begin}ns:{begin + 6980}ns")
            self.assertRegex(told, r"^equal: 1\d\d\d signals$")

    def test_what_cannot_be_dumped_is_one_line_and_its_exit_code(self):
        def told(code, *words):
            done = self.trammel("run", "circle", *LINE, "--no-report", "-o", self.folder / "f",
                                "--json", "--wave", "fst", *words, code=code)
            lines = [line for line in done.stderr.split("\n") if "waves of" not in line]
            self.assertEqual(len(lines), 2, done.stderr)
            return lines[0]
        self.assertIn('the trigger "fault" never fired in', told(1, "--wave-trigger", "fault"))
        self.assertTrue((self.folder / "f" / "metrics.json").exists())
        self.assertIn("lies outside the run, 0..", told(1, "--wave-window", "1:1.001"))
        shutil.rmtree(self.folder / "f")
        self.assertIn("did you mean x.STATUS?", told(2, "--wave-trigger", "x.STATSU == 1"))
        self.assertIn("is outside the run, 0..60 s", told(2, "--wave-window", "61:62"))
        self.assertFalse((self.folder / "f").exists())

    def test_the_pictures_of_the_page_are_what_its_commands_make(self):
        page = (ROOT / "docs" / "waves.md").read_text(encoding="utf-8").replace("\\\n", " ")
        commands = re.findall(r"^\./trammel (run circle .*--wave-trigger.*|wave draw .*)$", page,
                              re.M)
        self.assertEqual([c.split()[0] for c in commands], ["run", "wave", "wave"])
        out = self.folder / "page"
        # Nothing after 21 ms is drawn.
        self.trammel(*shlex.split(commands[0]), "-s", "run.max_s=0.021", "--no-report", "-o",
                     out, code=5)
        for command in commands[1:]:
            words = shlex.split(command)[1:]
            picture = ROOT / words[words.index("-o") + 1]
            words[words.index("-o") + 1] = self.folder / picture.name
            words[1] = out / "waves.fst"
            self.wave(*words)
            for suffix in (".json", ".svg"):
                self.assertEqual((self.folder / picture.name).with_suffix(suffix).read_bytes(),
                                 picture.with_suffix(suffix).read_bytes(), picture.name)
            made = json.loads((self.folder / picture.name).with_suffix(".json").read_text())
            clocks = [edge.split()[1] for edge in made["edge"]]
            self.assertEqual(clocks, {"dead_time": ["1", "100"], "afc": ["60", "70"]}[picture.stem])


if __name__ == "__main__":
    main()
