# SPDX-License-Identifier: Apache-2.0
"""Which values verify --keys tries, and which keys it calls tried in vain."""

import contextlib
import io
import json
import subprocess
import unittest
from unittest import mock

from trammel_tools.check import keys


class Keys(unittest.TestCase):
    def test_both_ends_and_values_between_are_tried(self):
        tried = [float(word) for word in keys.values("plant.mass_kg", 0.1, 500, 2.5, False, 1)]
        self.assertEqual(tried[:2], [0.1, 500])
        self.assertEqual(len(tried), 2 + keys.BETWEEN)
        self.assertTrue(all(0.1 <= value <= 500 for value in tried))
        self.assertTrue(all(2.5 / 4 <= value <= 2.5 * 4 for value in tried[3:]))

    def test_numeric_keys_are_those_with_a_range_and_axes_are_one(self):
        told = [{"key": "a.kind", "range": "one, two", "default": "one"},
                {"key": "axis.x.mass_kg", "range": "0.1..50", "default": "2.5"},
                {"key": "axis.y.mass_kg", "range": "0.1..50", "default": "8.0"},
                {"key": "axis.y.ticks", "range": "-4..1000", "default": "20"},
                {"key": "small", "range": "0..1e-3", "default": "1e-05"}]
        done = subprocess.CompletedProcess([], 0, stdout=json.dumps(told))
        with mock.patch.object(subprocess, "run", return_value=done):
            self.assertEqual(keys.numeric("toy"), {
                "axis.mass_kg": (0.1, 50, 2.5, False), "axis.ticks": (-4, 1000, 20, True),
                "small": (0, 1e-3, 1e-5, False)})

    def test_a_machine_without_a_plan_has_nothing_to_try_and_what_is_listed_is_not_tried(self):
        numeric = {f"k{n}": (0, 1, 0.5, False) for n in range(20)}
        for plan in (None, {"listed": {"k3": "why"}, "words": {"kind": ["one", "two"]}}):
            runs = {} if plan is None else {"keys": plan}
            with mock.patch.object(keys.machines, "runs", return_value=runs), \
                    mock.patch.object(keys, "numeric", return_value=numeric):
                if plan is None:
                    self.assertEqual(keys.table("toy", False, 1), (None, [], {}))
                    continue
                for short, tried, listed in ((False, 19, {"k3": "why"}), (True, keys.SHORT, {})):
                    got, pairs, told = keys.table("toy", short, 1)
                    self.assertEqual((got, told), (plan, listed))
                    self.assertEqual(len({key for key, _ in pairs}), tried + 1)
                    self.assertNotIn("k3", dict(pairs))
                    self.assertEqual(pairs[-2:], [("kind", "one"), ("kind", "two")])

    def test_a_key_of_which_no_value_changes_the_run_is_told(self):
        made = {"a": [1, 1, 1], "b": [1, 2, 1], "c": [3], "d": [4, 4]}
        with contextlib.redirect_stdout(io.StringIO()) as said:
            wrong = keys.in_vain("toy", {"inert": {"d": "a warning alone"}}, made)
        self.assertEqual(wrong, ["toy: a: no value of it changes the run"])
        self.assertIn("inert    d: a warning alone", said.getvalue())


if __name__ == "__main__":
    unittest.main()
