# SPDX-License-Identifier: Apache-2.0
"""Waves of a failed case of a block's unit test, with a view for GTKWave.

usage: scripts/tool unit-waves TEST [CASE [MAIN]]

TEST: <layer>/<block>_test.cpp; CASE: its text; MAIN: the library with Catch2's main, by default
that of build/.

A unit test that fails calls this. The test is compiled again, with a model that traces, and run
twice: once to find in which clock of which instance of the block the first assertion failed, once
to trace the clocks before it. The tests themselves are built without any of this. The waves, the
view and the model stay in build/waves/<layer>_<block>.

Exit codes: 0 waves were written, 1 the case does not fail or does not build, 2 there is no such
test, 3 Verilator or Catch2's main is missing.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import CATCH_MAIN, ROOT, RTL, twin_sources
from trammel_tools.rtl import lint
from trammel_tools.waves import vcd

BEFORE = 500  # clocks traced before the failure
SEEN = 40  # of these at the first look
BEHIND = 5
REGISTERS = 30  # in the view
JOBS = "2"


def block_of(test):
    """The block that <layer>/<block>[_<part>]_test.cpp is about; None when there is none."""
    layer, _, name = test.rpartition("/")
    name = name.removesuffix("_test.cpp")
    while name and not (RTL / layer / f"{name}.sv").exists():
        name = name.rpartition("_")[0]
    return f"{layer}/{name}" if name and (ROOT / "tests" / test).exists() else None


def build(block, test, folder, catch_main):
    """The program of this test with a model that traces; None when it does not build."""
    layer, top = block.split("/")
    chip = layer == "chips"
    properties = sorted(RTL.glob("*/*_props.sv" if chip else f"{layer}/{top}_props.sv"))
    source = ROOT / "tests" / test
    main = (ROOT / "tests" / layer / f"{top}_test.cpp").read_text(encoding="utf-8")
    parameters = " ".join(re.findall(r"^// verilate: (.*)$", main, re.M)).split()
    search = [f"-I{d}" for d in sorted(RTL.iterdir()) if d.is_dir() and d.name != "boards"]
    command = ["verilator", "--cc", "--exe", "--build", "-j", JOBS, "--trace", "--assert",
               "-Wno-fatal", "-Wno-lint", "-fno-split", "--top-module", top, "--prefix", f"V{top}",
               "--Mdir", str(folder / "obj"), "-CFLAGS", f"-std=c++17 -I{ROOT} -DTRAMMEL_WAVES",
               "-o", "unit", *parameters, *search, f"-I{RTL}/chips/generated",
               *map(str, lint.packages()), str(RTL / f"{block}.sv"), *map(str, properties),
               str(source), *map(str, twin_sources(top)),
               str(ROOT / "tests" / "support" / "first_failure.cpp"), str(catch_main)]
    cache = "ccache" if shutil.which("ccache") else ""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False,
                          env={**os.environ, "OBJCACHE": cache})
    (folder / "build.log").write_text(done.stdout + done.stderr, encoding="utf-8")
    return folder / "obj" / "unit" if done.returncode == 0 else None


def run(program, case, **variables):
    # A comma would part two patterns, brackets are tags.
    pattern = [re.sub(r"([,\\\[\]\"*~])", r"\\\1", case)] if case else []
    subprocess.run([program, *pattern], cwd=program.parent, check=False, timeout=600,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, **variables})


def declared(waves):
    """The signals of a VCD."""
    scopes, found = [], []
    with waves.open(encoding="utf-8") as lines:
        for line in lines:
            word = line.split()
            match word[:1]:
                case ["$scope"]:
                    scopes.append(word[2])
                case ["$upscope"]:
                    scopes.pop()
                case ["$var"]:
                    found.append(vcd.Signal(".".join([*scopes, word[4]]), int(word[2])))
                case ["$enddefinitions"]:
                    return found
    return found


def groups(signals, top):
    """What the view shows: the ports, and the block's own registers."""
    ports = [s for s in signals if re.fullmatch(r"\w+\.\w+_n?[io]", s.path)]
    clock = [s for s in ports if s.path.endswith((".clk_i", ".rst_i"))]
    own = [s for s in signals if re.fullmatch(rf"\w+\.{top}\.\w+_q", s.path)]
    return {"Clock": clock,
            "Inputs": [s for s in ports if s.path.endswith("_i") and s not in clock],
            "Outputs": [s for s in ports if s.path.endswith("_o")],
            "Registers": own[:REGISTERS]}


def trace(block, test, case, catch_main):
    """(the view, the clock of the failure), or one line that says why there is none."""
    folder = ROOT / "build" / "waves" / block.replace("/", "_")
    folder.mkdir(parents=True, exist_ok=True)
    program = build(block, test, folder, catch_main)
    if program is None:
        return f"the test does not build with waves: {folder.relative_to(ROOT)}/build.log"
    failed, waves = folder / "failed", folder / "waves.vcd"
    for old in (failed, waves):
        old.unlink(missing_ok=True)
    run(program, case, TRAMMEL_FAILED=str(failed))
    if not failed.exists():
        return f"'{case}' does not fail when it runs alone"
    instance, clock = map(int, failed.read_text(encoding="ascii").split())
    if clock == 0:
        return "it failed before the first clock"
    first = max(1, clock - BEFORE)
    run(program, case, TRAMMEL_WAVES=f"{instance} {first} {clock + BEHIND} {waves}")
    view = waves.with_suffix(".gtkw")
    end = (clock + BEHIND) * vcd.PERIOD
    vcd.write_view(view, waves, f"{case} ({block}): failed after edge {clock} of instance "
                   f"{instance}, of those evaluated", groups(declared(waves), block.split("/")[1]),
                   (max(first, clock - SEEN) * vcd.PERIOD - 1, end), clock * vcd.PERIOD)
    return view, clock


def main():
    if len(sys.argv) not in (2, 3, 4) or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 and sys.argv[1] in ("-h", "--help") else 2
    test, case, catch_main = [*sys.argv[1:], *["", CATCH_MAIN][len(sys.argv) - 2:]]
    block = block_of(test)
    if block is None:
        print(f"unit-waves: tests/{test}: no unit test of a block", file=sys.stderr)
        return 2
    if shutil.which("verilator") is None:
        print("unit-waves: verilator is missing (trammel doctor)", file=sys.stderr)
        return 3
    if not Path(catch_main).exists():
        print(f"unit-waves: {catch_main} is missing: ./trammel build makes it", file=sys.stderr)
        return 3
    python_tools.progress(f"waves of '{case}': building {block} with a model that traces")
    found = trace(block, test, case, Path(catch_main).resolve())
    python_tools.progress("")
    if isinstance(found, str):
        print(f"unit-waves: {test}: {found}", file=sys.stderr)
        return 1
    view, clock = found
    print(f"waves of '{case}', which failed after evaluated edge {clock}, at "
          f"{clock * vcd.PERIOD} ns of the waves:\n"
          f"  gtkwave {view.relative_to(ROOT)}", flush=True)
    return 0
