#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wave files of an LM628: the host port as the data sheet has it, the record's samples and
interrupts, the view for GTKWave.

usage: waves_check.py PROGRAM [FOLDER]      the built trammel program
"""

import csv
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
from wave_case import WaveCase, WaveFile, level, main, pulses

STEP = ["run", "an693-tuning", "-s", "trajectory.steps=1", "-s", "trajectory.wait_s=0.005",
        "-s", "run.reached_counts=50"]  # it is still on its way
CLOCK = 20  # [ns]


class PortTest(WaveCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = cls.run_to("fst", STEP, "--wave", "fst", "--wave-window", "0:10ms")
        cls.file = WaveFile(cls.out / "waves.fst")

    def changes(self, name, file=None, top="lm628"):
        return [(time, int(value)) for time, value in (file or self.file).changes(f"{top}.{name}")]

    def test_strobes_are_as_long_as_the_data_sheet_asks(self):
        select, data = self.changes("cs_n_i"), self.changes("ps_i")
        for strobe, clocks in (("wr_n_i", 5), ("rd_n_i", 9)):
            found = pulses(self.changes(strobe))
            self.assertGreater(len(found), 10)
            for begin, end in found:
                self.assertEqual(end - begin, clocks * CLOCK, strobe)
                self.assertEqual(level(select, begin - CLOCK), 0)
                self.assertEqual(level(data, begin - 2 * CLOCK), level(data, end + CLOCK))

    def test_commands_are_written_in_the_order_of_the_program(self):
        data, byte = self.changes("ps_i"), self.changes("d_i")
        commands = [level(byte, end) for _, end in pulses(self.changes("wr_n_i"))
                    if level(data, end) == 0]
        # PORT12, RSTI; LFIL, UDF; MSKI; LTRJ, STT of a step, RSTI at its end; the positions read.
        for code in (0x06, 0x1D, 0x1E, 0x04, 0x1F, 0x01, 0x08, 0x0A):
            self.assertIn(code, commands)
        self.assertLess(commands.index(0x1E), commands.index(0x04))
        self.assertLess(commands.index(0x1F), commands.index(0x01))

    def rows(self):
        with (self.out / "trace.csv").open() as file:
            return list(csv.DictReader(file))

    def test_samples_and_interrupts_stand_where_the_record_has_them(self):
        rows = self.rows()
        edges = [round(float(row["t_s"]) * 1e9) for row in rows]
        published = [end for _, end in pulses(self.changes("sample_o"), 1)]
        self.assertGreater(len(rows), 20)
        self.assertEqual(published, [edge for edge in edges if edge < 10_000_000])
        irq = self.changes("hi_o")
        for row, edge in zip(rows, edges):
            if edge < 10_000_000:
                self.assertEqual(level(irq, edge), int(row["host_irq"]), row["t_s"])
        self.assertIn("1", [row["host_irq"] for row in rows])

    def test_vcd_and_fst_hold_the_same(self):
        short = ["--wave-window", "2ms:2.3ms"]
        vcd = self.run_to("vcd", STEP, "--wave", "vcd", *short) / "waves.vcd"
        fst = self.run_to("short", STEP, "--wave", "fst", *short) / "waves.fst"
        self.assertRegex(self.wave("compare", vcd, fst), r"^equal: \d{3} signals$")

    def test_the_view_names_signals_that_are_there_in_all_its_groups(self):
        view = self.check_view(self.out / "waves.fst")
        point = int(re.search(r"count\] (\d+)\n[^@]*\{desired position\}", view)[1])
        shown = self.changes("u_engine.m_q.[0]")
        for row in self.rows()[:30]:
            self.assertAlmostEqual(level(shown, round(float(row["t_s"]) * 1e9)) / 2 ** point,
                                   float(row["desired_count"]), delta=1e-3)

    def test_a_script_is_shown_from_its_first_line(self):
        script = self.folder / "short.lm628"
        script.write_text("PORT12\nRSTI 0000h\nRDSTAT\n")
        out = self.run_to("script", ["lm628", script], "--wave", "fst")
        file = WaveFile(out / "waves.fst")
        byte = self.changes("d_i", file)
        written = [level(byte, end) for _, end in pulses(self.changes("wr_n_i", file))]
        self.assertEqual(written, [0x06, 0x1D, 0, 0])

    def test_what_cannot_be_dumped_is_one_line_and_its_exit_code(self):
        self.check_refused((
            (2, "needs a folder", ["lm628", "hold", "--wave", "fst"]),
            (1, "never fired", [*STEP, "-o", self.folder / "a", "--wave", "fst", "--wave-trigger",
                                "hi after 1s"])))


if __name__ == "__main__":
    main()
