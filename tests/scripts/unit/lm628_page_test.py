# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/lm628.md are those that the test of the RTL asserts."""

import re
import unittest

from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "lm628.md"
TEST = ROOT / "tests" / "chips" / "lm628_timing_test.cpp"


def measured(text):
    table = text.partition("kFigures[] = {")[2].partition("};")[0]
    return dict(re.findall(r'\{"([\w-]+)", (\d+)\}', table))


def told(text):
    return dict(re.findall(r"^\| ([\w-]+) \|.*\| (\d+) \|$", text, re.M))


class Lm628PageTest(unittest.TestCase):
    def test_each_figure_of_the_page_is_measured_and_each_measured_one_is_told(self):
        figures = measured(TEST.read_text(encoding="utf-8"))
        self.assertGreater(len(figures), 20)
        self.assertEqual(told(PAGE.read_text(encoding="utf-8")), figures)

    def test_a_figure_that_differs_is_seen(self):
        self.assertEqual(told("| T1 | a | min 0 | 40 |\n| T2 | b | max 3 | none |\n"), {"T1": "40"})
        self.assertEqual(measured('kFigures[] = {\n {"T1", 40}, {"a-b", 3}};'),
                         {"T1": "40", "a-b": "3"})
