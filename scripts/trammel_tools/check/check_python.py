# SPDX-License-Identifier: Apache-2.0
"""Lint the Python files with ruff, by the rules of pyproject.toml.

usage: scripts/tool check-python [ruff check options]     --fix corrects what it can

Exit codes: 0 clean, 1 findings, 3 ruff is missing (under CTest 77).
"""

import subprocess
import sys

from trammel_tools import python_tools
from trammel_tools.paths import ROOT


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    python_tools.need("ruff", "check-python")
    return subprocess.run([sys.executable, "-m", "ruff", "check", "--no-cache", *sys.argv[1:], "."],
                          cwd=ROOT, check=False).returncode
