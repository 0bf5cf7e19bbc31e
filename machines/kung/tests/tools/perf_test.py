# SPDX-License-Identifier: Apache-2.0
"""Rows of the measurement: what they need, their ratios, and events that differ."""

import unittest
from types import SimpleNamespace
from unittest.mock import patch

import perf_rows
import perf_table


def run(cpu_s, event_hash="a", clocks=1000):
    return perf_rows.Measured(clocks, clocks, event_hash, cpu_s, 2 * cpu_s, 1024)


class PerfTest(unittest.TestCase):
    def test_replayed_rows_need_the_pins_of_the_first(self):
        self.assertEqual(perf_rows.targets(["d"]), ["perf_rows"])
        self.assertEqual(perf_rows.targets(["f"]), ["perf_sc_clock"])
        self.assertEqual(perf_rows.targets(["a", "e"]), ["perf_sc_clock", "perf_rows"])

    def test_a_ratio_is_the_median_of_the_rounds(self):
        found = {"a": [run(4), run(4), run(4)], "d": [run(1), run(2), run(0.1)]}
        self.assertEqual(perf_table.ratio(found, "d", "a"), 4)
        self.assertIsNone(perf_table.ratio(found, "e", "a"))

    def test_a_row_with_other_events_is_an_error(self):
        found = {"a": [run(1)], "d": [run(1, "b")]}
        self.assertEqual(perf_table.row_of("a", found["a"], "a", found)["state"], "ok")
        self.assertEqual(perf_table.row_of("d", found["d"], "a", found)["state"],
                         "error: its events differ")

    def test_a_row_that_cannot_run_says_why(self):
        self.assertEqual(perf_table.row_of("g", perf_rows.NotHere("not installed"), "a", {}),
                         {"row": "g", "name": perf_rows.NAMES["g"], "state": "not installed"})
        self.assertEqual(perf_table.row_of("g", perf_rows.Failed("broke"), "a", {})["state"],
                         "error: broke")

    def test_a_row_that_failed_leaves_the_others_without_a_ratio_to_it(self):
        found = {"a": perf_rows.Failed("broke"), "d": [run(1)]}
        wanted = SimpleNamespace(seconds=1, repeat=1)
        with patch.object(perf_table, "machine", dict):
            result = perf_table.document(found, {"a": "a", "d": "a"}, wanted)
        self.assertEqual([row["state"] for row in result["rows"]], ["error: broke", "ok"])
        self.assertIsNone(result["rows"][1]["ratio"])
        self.assertEqual(result["errors"], ["row a: broke"])
