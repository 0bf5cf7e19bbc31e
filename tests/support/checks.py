# SPDX-License-Identifier: Apache-2.0
"""What the checks of a machine are called with: PROGRAM FOLDER."""

import sys
import unittest
from pathlib import Path


def main(cases, usage):
    """Runs test cases that have `program` and `folder`; the exit code."""
    if len(sys.argv) != 3 or sys.argv[1] in ("-h", "--help"):
        print(usage)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    cases.program, cases.folder = (Path(word).resolve() for word in sys.argv[1:])
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(cases)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1
