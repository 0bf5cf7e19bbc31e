#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Moves of the machine an693 backwards and forwards.

usage: mirror_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import checks
import mirror


class Moves(mirror.Mirror):
    moves = {
        "an693-absolute": {"trajectory.position_counts": 20000},
        "an693-relative": {"trajectory.position_counts": 20000},
        "an693-tuning": {"trajectory.position_counts": 50, "trajectory.steps": 2},
    }
    signed = ("motion.desired_count", "motion.real_count")
    unlike = ("supply.energy_J",)


if __name__ == "__main__":
    sys.exit(checks.main(Moves, __doc__))
