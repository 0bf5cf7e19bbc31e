#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the unit tests of the tools, which need no other program (in .venv if it exists).

usage: run.py [NAME ...]     those of unit/NAME_test.py alone, for instance run.py properties

Tests of a machine's tools stand beside them: machines/<m>/tests/tools/NAME_test.py.

Exit codes: 0 all passed, 1 one failed, 2 there is no such test.
"""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools
from trammel_tools.paths import ROOT

FOLDERS = [ROOT / "tests" / "scripts" / "unit", *sorted(ROOT.glob("machines/*/tests/tools"))]


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    there = sorted(p.stem.removesuffix("_test") for folder in FOLDERS
                   for p in folder.glob("*_test.py"))
    for name in sys.argv[1:]:
        if name not in there:
            print(f"run.py: {name}: no such test; there are {', '.join(there)}", file=sys.stderr)
            return 2
    python_tools.restart()
    sys.path[:0] = map(str, FOLDERS)
    suite = unittest.defaultTestLoader.loadTestsFromNames(
        f"{name}_test" for name in sys.argv[1:] or there)
    return 0 if unittest.TextTestRunner().run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
