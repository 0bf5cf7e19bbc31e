# SPDX-License-Identifier: Apache-2.0
"""Which values verify --keys tries, and which keys it calls tried in vain."""

import contextlib
import io
import json
import subprocess
import unittest
from pathlib import Path
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

    def test_values_of_a_whole_key_are_whole_and_each_is_tried_once(self):
        for least, most, default in ((0, 2, 1), (-4, 1000, 20), (0, 1, 0), (0, 2**31, 0)):
            tried = keys.values("k", least, most, default, True, 1)
            self.assertEqual(len(tried), len(set(tried)))
            self.assertTrue(all(least <= int(word) <= most for word in tried), tried)
            self.assertEqual(tried[:2], [str(least), str(most)])
        wide = [float(word) for seed in range(40)
                for word in keys.values("k", 0, 1e6, 0.0, False, seed)[2:]]
        self.assertTrue(all(10 <= value <= 1e6 for value in wide))
        self.assertGreater(sum(value < 1e4 for value in wide), 40)  # as many in each decade
        self.assertNotEqual(*(keys.values("a", 0, 1, 0.5, False, seed) for seed in (1, 2)))

    def judged(self, code, text, twin=(0, "", "aa", {}), rtl=(0, "", "aa", {}), trace=""):
        plan = {"columns": [["x_mm", "y_mm"], ["want_x", "want_y"]], "reached": 0.5}

        def cut(plan, key, value, folder, engine, cut):
            self.assertTrue(cut)
            code, text, made, files = {"twin": twin, "rtl": rtl}[engine]
            return code, text, {"run": {"event_hash": made}}, files

        with mock.patch.object(keys, "run", cut):
            return keys.judge_run(plan, Path("."), ("plant.mass_kg", "7"),
                                  (code, text, {"trace.csv": trace.encode()}))

    def test_a_value_is_refused_by_a_line_that_names_its_key(self):
        for text in ("plant.mass_kg: value 7 is out of range", "-s mass_kg: no",
                     "plant.length_m: too short for it"):
            self.assertEqual(self.judged(2, text), ("refused", text))
        self.assertEqual(self.judged(2, "gains.kp: no"),
                         ("WRONG", "the key is not named: gains.kp: no"))

    def test_a_run_ends_as_one_may_and_is_the_same_with_both_engines(self):
        for code in (None, 3, 70, 130, -11):
            self.assertEqual(self.judged(code, "why"), ("WRONG", f"exit {code}: why"))
        for code in (1, 4, 5):
            self.assertEqual(self.judged(code, "it tripped"), ("ended", "it tripped"))
        self.assertEqual(self.judged(0, "good"), ("done", "good"))
        same = (0, "", "aa", {"trace.csv": b"1"})
        for other in ((5, "", "aa", {"trace.csv": b"1"}), (0, "", "ab", {"trace.csv": b"1"}),
                      (0, "", "aa", {"trace.csv": b"2"})):
            for code in (0, 5):
                self.assertEqual(self.judged(code, "good", same, same)[0],
                                 "ended" if code else "done")
                outcome, text = self.judged(code, "good", same, other)
                self.assertEqual((outcome, text[:20]), ("WRONG", "RTL and twin differ:"), other)

    def test_a_run_ends_where_it_was_asked_to(self):
        head = "t_s,x_mm,want_x,y_mm,want_y\n"
        for last, far in (("1,3,3,4,4.5", None), ("1,3,3,4,4.75", "0.75"), ("1,3,3.75,4,4", "0.75"),
                          ("1,3,3.5,4,3.5", "0.7071")):
            trace = f"{head}0,9,0,9,0\n{last}\n"
            self.assertEqual(self.judged(0, "good", trace=trace),
                             ("WRONG", f"ends {far} from what was asked: good") if far
                             else ("done", "good"))
            self.assertEqual(self.judged(5, "bad", trace=trace), ("ended", "bad"))
        self.assertIsNone(keys.off_target({"trace.csv": head.encode()}, [["x_mm"], ["want_x"]]))

    def test_all_is_tried_again_with_other_settings(self):
        plan = {"settings": ["a=1"], "also": [
            {"name": "slow", "settings": ["b=2"], "without": ["gains.", "run."]},
            {"name": "all", "settings": []}]}
        tried = [("gains.kp", "1"), ("plant.mass_kg", "2"), ("run.x", "3"), ("plant.mass_kg", "4")]
        (name, one, own), (_, _, every) = keys.again(plan, tried, False, 1)
        self.assertEqual((name, one["settings"], own),
                         ("slow", ["a=1", "b=2"], [tried[1], tried[3]]))
        self.assertEqual((every, plan["settings"]), (tried, ["a=1"]))
        many = [(f"k{n}", value) for n in range(30) for value in "12"]
        (_, _, few), *_ = keys.again(plan, many, True, 1)
        self.assertEqual((len(few), len(dict(few))), (2 * keys.SHORT, keys.SHORT))
