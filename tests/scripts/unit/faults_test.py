# SPDX-License-Identifier: Apache-2.0
"""Which faults verify --faults injects, which of them it calls dangerous, and what it refuses."""

import unittest

from trammel_tools.check import faults

PLAN = {"unit": "mm", "limit": 0.5, "peak_A": 4.0, "off_s": 1e-5}


def harm(rows, healthy, off_after_s=None, peak_A=1.0, at_stop=False):
    """What is dangerous of a run with a fault from 1 s on."""
    injected = {"begin_s": 1.0, "off_after_s": off_after_s, "peak_A": peak_A, "at_stop": at_stop}
    return faults.consequences(PLAN, {"injected": injected}, rows, healthy)


def outcome(by, off_s=1e-6, harmful=(), error=""):
    return faults.Outcome("gate dead", "at rest", by=by, off_s=off_s, consequences=list(harmful),
                          error=error)


class Faults(unittest.TestCase):
    def test_each_combination_of_a_groups_lists_is_a_fault(self):
        group = {"fault": "phase_open", "axis": [0, 1], "line": [0, 2], "settings": ["a=1"],
                 "axis_names": {"0": "X", "1": "Y"}}
        found = list(faults.expand(group))
        self.assertEqual([name for name, _ in found],
                         ["phase_open, X, line 0", "phase_open, X, line 2",
                          "phase_open, Y, line 0", "phase_open, Y, line 2"])
        self.assertEqual(found[1][1], ["inject.fault=phase_open", "a=1", "inject.axis=0",
                                       "inject.line=2"])

    def test_the_distance_is_that_of_the_axis_that_is_farthest_off_at_one_time(self):
        healthy = [(0.0, 1.0, 5.0), (0.1, 2.0, 6.0), (0.2, 3.0, 7.0)]
        for axis in (1, 2):
            for row in range(3):
                for off in (-0.75, 0.75):
                    rows = [list(one) for one in healthy]
                    rows[row][axis] += off
                    with self.subTest(axis=axis, row=row, off=off):
                        self.assertEqual(faults.farthest(rows, healthy), 0.75)
        self.assertEqual(faults.farthest(healthy, healthy), 0)
        self.assertEqual(faults.farthest([], healthy), 0)
        self.assertEqual(faults.farthest(healthy[:1], healthy), 0)  # it ended early

    def test_dangerous_is_what_passes_a_limit_and_not_what_reaches_it(self):
        healthy = [(1.0, 0.0, 0.0), (1.5, 0.0, 0.0), (2.0, 0.0, 0.0)]
        for axis in (1, 2):
            for off, told in ((0.5, []), (0.625, ["0.625 mm off"]), (-0.625, ["0.625 mm off"])):
                rows = [list(one) for one in healthy]
                rows[1][axis] = off
                with self.subTest(axis=axis, off=off):
                    self.assertEqual(harm(rows, healthy), told)
                    self.assertEqual(harm(rows, healthy, off_after_s=0.75), told)
                    self.assertEqual(harm(rows, healthy, off_after_s=0.5), [])  # it was stopped
        self.assertEqual(harm(healthy, healthy, peak_A=4.0), [])
        self.assertEqual(harm(healthy, healthy, peak_A=4.5), ["4.5 A"])
        self.assertEqual(harm(healthy, healthy, at_stop=True), ["at a stop"])

    def test_what_is_noticed_must_turn_the_drives_off_in_time_unless_it_is_only_counted(self):
        begin = "toy: gate dead, at rest: noticed (check), but the drives are not off within 10 us"
        for off_s, told in ((1e-5, []), (1.1e-5, [begin]), (None, [begin])):
            with self.subTest(off_s=off_s):
                made = [outcome("check", off_s)]
                self.assertEqual(faults.problems("toy", PLAN, made), told)
                self.assertEqual(faults.problems("toy", PLAN | {"counted": ["check"]}, made), [])
        self.assertEqual(faults.problems("toy", PLAN, [outcome("", error="exit 70")]),
                         ["toy: gate dead, at rest: exit 70"])

    def test_one_dangerous_fault_may_pass_unnoticed_or_a_share_of_many(self):
        noticed, missed = outcome("check", harmful=["x"]), outcome("", None, ["5 mm off"])
        for found, wrong in (([missed], False), ([missed] * 2, True),
                             ([noticed] * 38 + [missed] * 2, False),  # 5 %
                             ([noticed] * 36 + [missed] * 2, True)):
            with self.subTest(count=len(found)):
                told = faults.problems("toy", PLAN, found)
                self.assertEqual(bool(told), wrong, told)
                if wrong:
                    one = "toy: gate dead, at rest: **not noticed: 5 mm off**"
                    self.assertEqual(told[:2], [one] * 2)
                    self.assertEqual(told[2], f"toy: 2 of {len(found)} dangerous faults are not "
                                              "noticed: at most 5%")


if __name__ == "__main__":
    unittest.main()
