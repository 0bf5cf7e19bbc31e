# SPDX-License-Identifier: Apache-2.0
"""What `trammel sweep` and `trammel tune` print of names and keys that a terminal would obey:
terminal_test.py PROGRAM (which is not used)."""

import contextlib
import io
import os
import re
import subprocess
import sys
import unicodedata
import unittest
from pathlib import Path
from unittest import mock

import sweeps

from trammel import _core, command_line
from trammel.sweep import main as sweep
from trammel.tune import main as tune

sys.path.insert(1, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import output_file
from trammel_tools import text as scripts_text

PLAN = 'scenario = "circle"\n[grid]\n"gains.kp" = [0.1, 0.2]\n'
STUDY = '[search]\n"gains.kp" = [0.1, 0.3]\n[[objective]]\nfigure = "tracking.model.mean_mm"\n'
BAD = "\x1b]0;PWN\x07\u202e\U000e0001"
GOOD = r"\u001b]0;PWN\u0007\u202e\U000e0001"


class Terminal(sweeps.Case):
    def setUp(self):
        super().setUp()
        self.plan = self.written("plan.toml", PLAN)
        self.study = self.written("study.toml", STUDY)

    def printed(self, verb, *words):
        """The exit code and what is printed, none of which a terminal obeys."""
        out, errors = io.StringIO(), io.StringIO()
        with mock.patch.object(sys, "argv", [verb.__name__, *map(str, words)]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            try:
                code = verb.main()
            except SystemExit as ended:
                code = ended.code
        for text in (out.getvalue(), errors.getvalue()):
            self.assertIsNone(re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202e\udc80-\udcff]", text),
                              ascii(text))
        return code, out.getvalue(), errors.getvalue()

    def test_what_a_terminal_would_obey(self):
        done = sweep.Done(2, 0, 0, 1.0)
        named = self.folder / f"{BAD}.toml"
        named.write_text(PLAN)
        with mock.patch.object(sweep, "perform", return_value=done):
            code, said, _ = self.printed(sweep, named, "-o", f"a{BAD}\udcff")
        self.assertEqual((code, said.count(GOOD), said.count("\n")), (0, 3, 3), said)
        self.assertIn(r"a" + GOOD + r"\xff/page.html", said)
        with mock.patch.object(tune, "perform", return_value=([], [])):
            _, said, _ = self.printed(tune, self.study, "-o", f"a{BAD}")
        self.assertIn("results in a" + GOOD, said)
        key = self.folder / "key.toml"
        key.write_text(f'"{GOOD}" = 1\n')  # as TOML has it
        for verb in (sweep, tune):
            for words in ((f"none{BAD}",), (key,), (self.plan, f"--a\nb{BAD}"),
                          (self.plan, "--cluster", BAD), (self.plan, "--jobs", f"a\nb{BAD}"),
                          *([(self.plan, "--shard", BAD)] if verb is sweep else [])):
                code, said, errors = self.printed(verb, *words)
                self.assertEqual((code, said, errors.count("\n")), (2, "", 1), (words, errors))
                self.assertIn(GOOD.lower(), errors.replace(r"\x", r"\u00").lower())  # or as Python

    def test_a_long_message_is_cut(self):
        _, _, errors = self.printed(sweep, f"{self.folder}/{'x' * 5000}end")
        self.assertRegex(errors, "^sweep: .*/x{120}\u2026 cannot be read: File name too long\n$")

    def test_scripts_show_and_keep_what_the_program_does(self):
        """They run before it is built, so that they cannot ask it."""
        assigned = [c for c in map(chr, range(sys.maxunicode + 1))
                    if unicodedata.category(c) not in ("Cn", "Cs")]  # of the Unicode of both
        said = " ".join([*assigned, *map(chr, range(0xDC80, 0xDD00))])  # the latter: bytes
        self.assertEqual(scripts_text.shown(said), _core.printable_lines(said))
        said = "a\tb\r\n\u202e\udcff"
        self.assertEqual(scripts_text.one_line(said), _core.one_line(said))
        self.assertEqual(sorted(output_file.RECORD), _core.record_files())

    def test_progress_is_still_a_command_to_the_terminal(self):
        terminal = io.StringIO()
        terminal.isatty = lambda: True
        with contextlib.redirect_stderr(command_line.Shown(terminal)):
            progress = sweep.Progress(True)
            progress.begin(2)
            progress.last -= 1
            progress.add(1)
            progress.close()
        self.assertRegex(terminal.getvalue(), "^\r\033\\[K1 of 2 runs, .*s left\r\033\\[K$")

    def test_from_the_command_line(self):
        for words, message in (
                (("sweep", f"{BAD}.toml"), f"sweep: {GOOD}.toml: cannot be read: No such file or "
                 "directory\n"),
                (("tune", b"a\xff\n.toml"), "tune: a\\xff\\u000a.toml: cannot be read: No such "
                 "file or directory\n")):
            done = subprocess.run([sys.executable, "-m", "trammel", *words], capture_output=True,
                                  check=False, env={**os.environ, "PYTHONIOENCODING": "utf-8"})
            self.assertEqual((done.returncode, done.stdout, done.stderr.decode()),
                             (2, b"", message))


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
