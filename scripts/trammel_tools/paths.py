# SPDX-License-Identifier: Apache-2.0
"""Where the repository is."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"
TOOL = ROOT / "scripts" / "tool"


def twin_sources(top):
    """C++ sources that a unit test of this module needs: the twins of most are headers alone."""
    return sorted(ROOT.glob(f"models/exact/chips/{top}*.cpp"))
