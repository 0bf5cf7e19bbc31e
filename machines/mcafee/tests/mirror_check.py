#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Moves of the machine mcafee backwards and forwards.

usage: mirror_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import checks
import mirror


class Moves(mirror.Mirror):
    moves = {"mcafee-stage2": {"trajectory.position_counts": 4000}}
    signed = ("real_count.0",)


if __name__ == "__main__":
    sys.exit(checks.main(Moves, __doc__))
