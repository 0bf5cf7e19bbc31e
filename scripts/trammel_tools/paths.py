# SPDX-License-Identifier: Apache-2.0
"""Where the repository is."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"
TOOL = ROOT / "scripts" / "tool"
CATCH_MAIN = ROOT / "build" / "tests" / "libtrammel_catch_main.a"  # with Catch2's main


def twin_sources(top):
    """C++ sources that a unit test of this module needs: the twins of most are headers alone."""
    return sorted(ROOT.glob(f"models/exact/chips/{top}*.cpp"))
