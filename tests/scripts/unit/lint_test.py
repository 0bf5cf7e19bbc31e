# SPDX-License-Identifier: Apache-2.0
"""Blocks and packages are found by their folders, and the exit code says what lint found."""

from unittest import mock

from scratch import Scratch, call
from trammel_tools import paths
from trammel_tools.rtl import lint


class LintTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(paths, RTL=self.folder / "rtl", ROOT=self.folder)
        self.patch(lint, RTL=self.folder / "rtl",
                   GENERATED=self.folder / "rtl" / "chips" / "generated")
        for path in ("math/timer.sv", "math/timer_props.sv", "math/a_pkg.sv", "pkg/z_pkg.sv",
                     "chips/top.sv", "chips/generated/b_pkg.sv", "chips/generated/regs.sv",
                     "boards/x.sv", "drive/pwm.sv"):
            self.write(f"rtl/{path}", "")

    def test_blocks_are_neither_packages_nor_properties_nor_boards(self):
        self.assertEqual(list(lint.blocks()), ["chips/top", "drive/pwm", "math/timer"])

    def test_packages_come_after_those_they_import(self):
        self.assertEqual([p.name for p in lint.packages()], ["z_pkg.sv", "a_pkg.sv", "b_pkg.sv"])

    def code(self, *words, verible="verible", finds=(), verilator="verilator"):
        """Exit code when these tools are there and find something in these blocks."""
        with mock.patch.object(lint, "find_verible", return_value=verible), \
                mock.patch("shutil.which", return_value=verilator), \
                mock.patch.object(lint, "lint_verilator", side_effect=lambda b: b not in finds), \
                mock.patch.object(lint, "lint_verible", return_value=True):
            return call(lint.main, *words)[0]

    def test_exit_codes(self):
        self.assertEqual(self.code(), 0)
        self.assertEqual(self.code("math/timer", finds=["drive/pwm"]), 0)
        self.assertEqual(self.code(finds=["drive/pwm"]), 1)
        self.assertEqual(self.code("math/none"), 2)
        self.assertEqual(self.code("math/" + "a" * 300), 2)
        self.assertEqual(self.code(verilator=None), 3)
        self.assertEqual(self.code(verible=None), lint.SKIPPED)
        self.assertEqual(self.code(verible=None, finds=["drive/pwm"]), 1)
