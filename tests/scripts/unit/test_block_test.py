# SPDX-License-Identifier: Apache-2.0
"""Blocks are found with their tests, each check gives one line, and the exit code is the worst."""

from unittest import mock

from scratch import Scratch, call
from trammel_tools import paths
from trammel_tools.check import test_block
from trammel_tools.rtl import lint


class TestBlockTest(Scratch):
    def setUp(self):
        super().setUp()
        rtl = self.folder / "rtl"
        self.patch(test_block, ROOT=self.folder, RTL=rtl, BUILD=self.folder / "build")
        self.patch(paths, RTL=rtl, ROOT=self.folder)
        self.patch(lint, RTL=rtl, GENERATED=rtl / "chips" / "generated")
        for path in ("rtl/drive/pwm.sv", "rtl/drive/pwm_props.sv", "tests/drive/pwm_test.cpp",
                     "rtl/chips/top.sv", "rtl/chips/top_props.sv", "rtl/chips/top_leap.toml",
                     "rtl/boards/b/board.sv", "rtl/boards/b/free.sv",
                     "tests/boards/board_test.cpp"):
            self.write(path, "")

    def test_a_block_may_have_no_test_and_a_board_without_one_is_none(self):
        found = {name: test and test.name for name, test in test_block.blocks().items()}
        self.assertEqual(found, {"boards/board": "board_test.cpp", "chips/top": None,
                                 "drive/pwm": "pwm_test.cpp"})

    def test_a_block_that_is_not_there_is_refused_in_one_line(self):
        for name, near in (("pwm", "did you mean drive/pwm?"), ("motion/pwm", "drive/pwm?"),
                           ("drive/pwn", "drive/pwm?"), ("nothing", "see docs/README.md")):
            code, out, err = call(test_block.main, name)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1))
            self.assertIn(f"{name}: no such block; ", err)
            self.assertIn(near, err)
        self.assertEqual(call(test_block.main, "--names", "drive/pwm"), (0, "", ""))

    def checked(self, *blocks, wrong=()):
        """Exit code and lines when the commands that contain these words end so."""
        def told(command):
            text = " ".join(map(str, command))
            return next((answer for word, answer in wrong if word in text), (0, ""))

        def run(command, **_):
            return mock.Mock(returncode=told(command)[0])
        with mock.patch.object(test_block, "call", side_effect=told), \
                mock.patch("subprocess.run", side_effect=run):
            code, out, _ = call(test_block.main, *blocks)
        return code, [" ".join(line.split()[:3]) for line in out.splitlines()]

    def test_lint_unit_test_and_proof_of_a_block(self):
        code, lines = self.checked("drive/pwm")
        self.assertEqual(code, 0)
        self.assertEqual(sorted(lines[:2]), ["lint drive/pwm passed", "unit drive/pwm passed"])
        self.assertEqual(lines[2:], ["proof drive/pwm passed"])

    def test_a_chip_is_asked_the_lemmas_too_and_a_board_is_not_proven(self):
        self.assertEqual(self.checked("chips/top"), (0, [
            "lint chips/top passed", "proof chips/top passed", "leap chips/top passed",
            "leap chips/top passed"]))
        self.assertEqual(self.checked("boards/board"), (0, ["unit boards/board passed"]))

    def test_what_failed_says_why_and_the_rest_goes_on(self):
        for word, kind in (("lint", "lint"), ("ninja", "unit"), ("pwm_test", "unit"),
                           ("prove", "proof")):
            code, lines = self.checked("drive/pwm", wrong=[(f"{word}", (1, "because\n"))])
            self.assertEqual(code, 1)
            self.assertEqual(len([line for line in lines if "drive/pwm" in line]), 3)
            at = lines.index(f"{kind} drive/pwm failed")
            self.assertIn(lines[at - 1], ("because", "see above"))

    def test_a_tool_that_is_missing_is_no_success_and_no_failure(self):
        skipped = [(" lint ", (77, "skipped: verible missing"))]
        self.assertEqual(self.checked("drive/pwm", wrong=skipped)[0], 3)
        self.assertEqual(self.checked("drive/pwm", wrong=[("prove", (3, ""))])[0], 3)
        self.assertEqual(self.checked("drive/pwm", wrong=[*skipped, ("pwm_test", (1, ""))])[0], 1)

    def test_the_progress_of_the_build_is_no_news(self):
        told = ("[1/2] Building CXX object a.o\n[2/2] Building CXX object b.o\nFAILED: b.o\n"
                "c++ -c b.cpp\nb.cpp:1: error: no\nninja: build stopped: subcommand failed.")
        with mock.patch.object(test_block, "call", return_value=(1, told)):
            code, said = test_block.build({"drive/pwm": self.folder / "pwm_test.cpp"})
        self.assertEqual((code, said), (1, "b.cpp:1: error: no"))
