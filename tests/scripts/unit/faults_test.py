# SPDX-License-Identifier: Apache-2.0
"""Which faults verify --faults injects, which of them it calls dangerous, and what it refuses."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

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
                self.assertEqual(faults.problems("toy", PLAN | {"counted": ["che"]}, made), [])
                self.assertEqual(faults.problems("toy", PLAN | {"counted": ["heck"]}, made), told)
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

    def test_a_path_goes_through_points_at_times(self):
        plan = {"waypoints": [[0, 0, 0], [1, 0.01, 0], [2, 0.01, 0.02]], "interval_s": 0.5}
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(faults.waypoints(plan, folder),
                             [f"path.points_file={folder}/waypoints.csv"])
            self.assertEqual(Path(folder, "waypoints.csv").read_text().splitlines(), [
                "0.0000,0.0000", "5.0000,0.0000", "10.0000,0.0000", "10.0000,10.0000",
                "10.0000,20.0000"])
            self.assertEqual(faults.waypoints({}, folder), [])

    def judged(self, seen, blind):
        """Outcome of a fault with these members of `injected` in its two runs."""
        plan = PLAN | {"settings": ["s=1"], "monitors": ["m=1"], "blind": ["m=0"]}
        quiet = {"begin_s": 1.0, "detected_by": "", "detected_after_s": None, "off_after_s": None,
                 "stopping": 0, "peak_A": 1.0, "at_stop": False}
        asked = []

        def run(_, settings, out):
            asked.append(settings)
            made = {"m=1": seen, "m=0": blind}[settings[-1]]
            return made if isinstance(made, str) else ({"injected": quiet | made}, [])

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(faults, "run", run):
            made = faults.judge(plan, [], ["w=1"], folder,
                                (("gate dead", ["f=1"]), ("at rest", 0.25)))
        for settings, last in zip(asked, ("m=1", "m=0"), strict=True):
            self.assertEqual(settings, ["s=1", "w=1", "inject.begin_s=0.25", "f=1", last])
        return made

    def test_a_fault_is_noticed_with_the_monitors_and_does_harm_without_them(self):
        noticed = {"detected_by": "check", "detected_after_s": 0.005, "off_after_s": 0.005003,
                   "stopping": 1.5}
        made = self.judged(noticed, {"peak_A": 5.0})
        self.assertEqual((made.fault, made.time, made.by, made.after_s, made.stopping, made.error),
                         ("gate dead", "at rest", "check", 0.005, 1.5, ""))
        self.assertAlmostEqual(made.off_s, 3e-6)
        self.assertEqual(made.consequences, ["5 A"])
        self.assertEqual(self.judged(noticed | {"at_stop": True}, {}).consequences, ["at a stop"])
        self.assertIsNone(self.judged(noticed | {"off_after_s": None}, {}).off_s)
        self.assertEqual(self.judged({}, {"peak_A": 5.0}).by, "")
        for runs in (("exit 70", {}), ({}, "exit 70")):
            self.assertEqual(self.judged(*runs).error, "exit 70")

    def test_a_cell_tells_who_noticed_when_and_what_else_there_was(self):
        def text(**more):
            return faults.text(PLAN, faults.Outcome("gate dead", "at rest", **more))

        by = {"by": "check", "after_s": 0.0051234, "off_s": 3e-6, "stopping": 1.54}
        harm = {"consequences": ["5 mm off", "6 A"]}
        self.assertEqual(text(**by), "check, 5.12 ms, off 3 us later, stops in 1.5 mm")
        self.assertEqual(text(**by, **harm), "check, 5.12 ms, off 3 us later, stops in 1.5 mm "
                         "(else 5 mm off; 6 A)")
        self.assertEqual(text(**by | {"off_s": None}), "check, 5.12 ms, stops in 1.5 mm")
        self.assertEqual(text(**harm), "**not noticed: 5 mm off; 6 A**")
        self.assertEqual(text(), "not noticed, harmless")
        self.assertEqual(text(error="exit 70", **harm), "exit 70")

    def test_a_section_counts_cases_and_has_a_column_a_time(self):
        plan = PLAN | {"times": {"at rest": 0.1, "moving": 0.2}, "about": "A toy.",
                       "met_by": {"che": "its drive"}}
        made = [faults.Outcome(fault, time, by=by, consequences=harm) for fault, time, by, harm in (
            ("a", "moving", "check", ["x"]), ("a", "at rest", "", []), ("b", "at rest", "", ["y"]),
            ("b", "moving", "check 2", ["z"]))]
        summary = "2 faults at 2 times: 3 of 4 cases dangerous, 2 of these noticed (66.7%)"
        self.assertEqual(faults.summary(plan, made), summary)
        self.assertEqual(faults.summary(plan, made[1:2]),
                         "1 faults at 2 times: 0 of 1 cases dangerous, 0 of these noticed (100.0%)")
        harmless = faults.Outcome("a", "at rest", by="check")
        self.assertIn("3 of 5 cases dangerous, 2 of these", faults.summary(plan, [*made, harmless]))
        lines = faults.section("toy", plan, made).splitlines()
        self.assertEqual(lines[:7], ["## toy", "", "A toy.", "", summary + ".", "",
                                     "| fault | at rest | moving |"])
        self.assertEqual([line.split(" | ")[:2] for line in lines[8:10]],
                         [["| a", "not noticed, harmless"], ["| b", "**not noticed: y**"]])
        self.assertEqual(lines[-2:], ["| check | its drive |", "| check 2 | its drive |"])
        with self.assertRaisesRegex(faults.machines.MachineError, 'lacks "watch"'):
            faults.section("toy", plan, [faults.Outcome("a", time, by="watch")
                                         for time in plan["times"]])
