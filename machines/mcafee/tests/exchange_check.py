#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""X and Y of the machine mcafee are alike: a path with exchanged coordinates moves the axes the
other way round. The processor serves X before Y, so rows begin at other times.

usage: exchange_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import checks
import exchange

COMMON = {"program": "track", "path.kind": "points", "compare": "false", "track.speed": 60,
          "run.reached_counts": 2000, "name": "both"}


def loop():
    """A flat loop, in mm: not like itself with exchanged axes."""
    for k in range(61):
        angle = 2 * math.pi * k / 60
        yield 12 * math.cos(angle) - 12, 5 * math.sin(angle) + 2 * math.sin(angle) ** 2


class Exchange(exchange.Pairs):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write_both(list(loop()))

    def both(self, first=(), second=()):
        """Exit codes, outcomes, traces and metrics of a run and of the exchanged one."""
        made = []
        for name, more in (("xy", first), ("yx", second or first)):
            code, said = exchange.run(self.program, "mcafee-stage3", {
                **COMMON, "path.points_file": self.folder / f"{name}.csv", **dict(more)},
                self.folder / name)
            made.append((code, said, *exchange.records(self.folder / name)))
        return zip(*made, strict=True)

    def test_records_are_exchanged(self):
        codes, words, traces, metrics = self.both()
        self.assertEqual(codes, (0, 0), words)
        self.assertEqual(words[0], exchange.exchanged(words[1]))
        for column in traces[0][0]:
            reach = [[float(row[name]) for row in trace] for trace, name in
                     zip(traces, (column, exchange.exchanged(column)), strict=True)]
            if column.endswith(("_mm", "_count", "_mm_s", "_desired_speed")):
                for end in (min, max):
                    one, other = (end(values) for values in reach)
                    self.assertAlmostEqual(one, other, delta=0.06 * max(map(abs, reach[0])) + 1e-9,
                                           msg=f"{end.__name__} of {column}")
        figures = [{f["id"]: f["value"] for f in one["figures"]} for one in metrics]
        for name in ("motion.time_s", "motion.max_speed_mm_s", "motion.max_desired_mm_s"):
            self.assertAlmostEqual(figures[0][name] / figures[1][name], 1, delta=0.1, msg=name)

    def test_switches_are_exchanged(self):
        # The loop begins at its right end: it reaches the low switch of its long axis, the first
        # one, and the high switch of the other one.
        for end, place in (("low", -0.008), ("high", 0.004)):
            _, words, _, metrics = self.both({f"stage.switch_{end}_m": place})
            self.assertEqual(words[0], exchange.exchanged(words[1]))
            events = [[(e["axis"], e["what"]) for e in one["events"]] for one in metrics]
            self.assertNotEqual(events[0], [])
            self.assertEqual(events[0], [(exchange.exchanged(axis), what)
                                         for axis, what in events[1]])

    def test_faults_are_exchanged(self):
        _, words, _, metrics = self.both(
            *({"inject.fault": "encoder_stuck", "inject.axis": axis, "inject.begin_s": 0.2,
               "chip.error_limit_counts": 300} for axis in (0, 1)))
        self.assertEqual(words[0], exchange.exchanged(words[1]))
        events = [[(e["axis"], e["what"]) for e in one["events"]] for one in metrics]
        self.assertNotEqual(events[0], [])
        self.assertEqual(events[0], [(exchange.exchanged(axis), what) for axis, what in events[1]])


if __name__ == "__main__":
    sys.exit(checks.main(Exchange, __doc__))
