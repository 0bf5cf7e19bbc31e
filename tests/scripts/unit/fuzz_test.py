# SPDX-License-Identifier: Apache-2.0
"""Unit tests of scripts/tool fuzz: what counts as a finding, and that a seed repeats its case."""

import random
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from trammel_tools.fuzz import fuzz_disks, fuzz_seeds, fuzz_starts


class Starts(unittest.TestCase):
    def test_documented_ends_are_no_findings(self):
        for code, said in ((0, b""), (5, b"trammel: a: timeout\n"), (2, b"trammel: a: no\n"),
                           (2, b"trammel: waves of 1 ms take 1 MB\ntrammel: a: no\n")):
            self.assertEqual(fuzz_starts.wrong(code, said, b"results\n\tmore\n", 0.1), "")

    def test_all_else_is_one(self):
        for code, said, printed, took, why in (
                (0, b"", b"", 11, "took"), (70, b"trammel: internal\n", b"", 0, "exit code 70"),
                (-11, b"", b"", 0, "exit code -11"), (2, b"", b"", 0, "no line"),
                (2, b"trammel: a\ntrammel: b\n", b"", 0, "more than one line"),
                (2, b"a\n", b"", 0, "does not begin"), (0, b"", b"\x1b[31m", 0, "raw character"),
                (0, b"", b"\xc2\x9b", 0, "raw character"), (0, b"", b"\xff", 0, "not UTF-8"),
                (2, b"trammel: \x07\n", b"", 0, "raw character")):
            self.assertIn(why, fuzz_starts.wrong(code, said, printed, took))

    def test_a_seed_repeats_its_damage(self):
        text = b"[run]\nmax_s = 1\n" * 20
        first, again, other = (fuzz_starts.damaged(random.Random(seed), text) for seed in (4, 4, 5))
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)


class Disks(unittest.TestCase):
    def test_an_error_is_one_line_beside_notices(self):
        good = "trammel: waves of 1 ms take 1 MB\ntrammel: out: cannot be written: why\n"
        self.assertEqual(fuzz_disks.documented(2, good), "")
        self.assertIn("not one line", fuzz_disks.documented(2, good + "trammel: more\n"))
        self.assertIn("exit code -7", fuzz_disks.documented(-7, ""))


class Seeds(unittest.TestCase):
    def test_every_input_of_a_machine_has_seeds(self):
        for name, table in fuzz_seeds.targets().items():
            self.assertTrue(table["files"], name)

    def test_seeds_are_numbered_files(self):
        with tempfile.TemporaryDirectory() as scratch:
            fuzz_seeds.put(Path(scratch) / "keys", 7, b"\0a=1")
            self.assertEqual((Path(scratch) / "keys" / "0007").read_bytes(), b"\0a=1")

    def test_a_dictionary_has_each_word_once_as_libfuzzer_reads_it(self):
        keys = [{"key": "gains.kp", "default": "0.5", "range": "0..9"},
                {"key": "mode", "default": '"fc"', "range": "one of fc, afc"}]
        with tempfile.TemporaryDirectory() as scratch, \
                mock.patch.object(fuzz_seeds.machines, "described", return_value=[{"name": "a"}]), \
                mock.patch.object(fuzz_seeds, "keys_of", return_value=keys), \
                mock.patch.object(fuzz_seeds, "targets", return_value={}):
            self.assertEqual(fuzz_seeds.assignments("p", "a"), ["gains.kp=0.5", "mode=fc"])
            file = Path(scratch) / "a.dict"
            fuzz_seeds.write_dictionary("p", file)
            lines = file.read_text(encoding="ascii").splitlines()
            words = (Path(scratch) / "a.words").read_bytes().split(b"\0")
        self.assertEqual(len(lines), len(set(lines)))
        self.assertLessEqual({f'"{word}"' for word in (
            "gains.kp", "gains", "kp", "0.5", "mode", "fc", "afc", "true", "[[", "\\x22\\x22\\x22",
            "\\x1b[2J", "\\xef\\xbb\\xbf", "\\x5cu001b", "\\x0d\\x0a")}, set(lines))
        self.assertFalse({'"one of fc"', '"0..9"'} & set(lines))
        self.assertEqual(len(words), len(lines))
        self.assertLessEqual({b'"""', b"\xff", b"afc"}, set(words))
