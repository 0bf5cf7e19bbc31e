# SPDX-License-Identifier: Apache-2.0
"""Lint RTL blocks with verilator -Wall and verible-verilog-lint (default rules).

usage: trammel lint [layer/block ...]      without arguments: every block

Exit codes: 0 clean, 1 findings, 2 no such block, 3 verilator is missing,
77 verible or the core of a chip is missing and else nothing was found (CTest counts it as skipped).
"""

import os
import re
import shutil
import subprocess
import sys

from trammel_tools import python_tools
from trammel_tools.paths import ROOT, RTL, block_file, block_of, rtl_files, rtl_search
from trammel_tools.rtl import hierarchy

GENERATED = RTL / "chips" / "generated"
WAIVERS = ROOT / "scripts" / "lint.vlt"
SKIPPED = 77


def blocks():
    """Own blocks; packages are linted with the blocks that use them, boards are exempt."""
    for source in rtl_files("*.sv"):
        if not source.stem.endswith(("_pkg", "_props")):
            yield block_of(source)


def packages():
    """In an order in which each finds the ones it imports."""
    folders = ("pkg", "math", "chips/generated", "chips")
    return [path for folder in folders for path in sorted(RTL.glob(f"{folder}/*_pkg.sv"))]


def find_verible():
    local = ROOT / ".venv" / "bin" / "verible-verilog-lint"
    return str(local) if local.exists() else shutil.which("verible-verilog-lint")


def cores():
    """RTL of processor cores that packages of .venv bring."""
    return sorted((ROOT / ".venv" / "lib").glob(
        "python3*/site-packages/pythondata_cpu_picorv32/verilog/picorv32.v"))


def needs_core(block):
    """Whether the block contains a core."""
    texts = hierarchy.modules(block.split("/")[1], rtl_files("*.sv"))
    return any(re.search(r"^\s*picorv32\s+#", text, re.M) for text in texts.values())


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)
    if done.returncode != 0:
        print((done.stdout + done.stderr).replace(f"{ROOT}/", ""), end="")
    return done.returncode == 0


def lint_verilator(block):
    source, props = block_file(block, ".sv"), block_file(block, "_props.sv")
    # Behind the waivers, which do not reach back; with a time scale, because they have one.
    more = [*map(str, cores()), "--timescale", "1ns/1ps"] if needs_core(block) else []
    return run(["verilator", "--lint-only", "-Wall", "--assert", *rtl_search(), f"-I{GENERATED}",
                "--top-module", source.stem, str(WAIVERS), *more, *map(str, packages()),
                str(source),
                *([str(props)] if props.exists() else [])])


def lint_verible(verible, block):
    own = [block_file(block, ending) for ending in (".sv", "_props.sv")]
    own += [p for p in packages() if p.parent != GENERATED]
    return run([verible, *(str(p) for p in own if p.exists())])


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    wanted = sys.argv[1:] or list(blocks())
    for block in wanted:
        if not os.path.exists(block_file(block, ".sv")):  # Path's raises at one too long
            return python_tools.refuse("lint", f"rtl/{block}.sv: no such block")
    if shutil.which("verilator") is None:
        print("lint: verilator is missing (trammel doctor)", file=sys.stderr)
        return 3
    verible = find_verible()
    clean, skipped = True, [] if cores() else [block for block in wanted if needs_core(block)]
    for block in wanted:
        if block in skipped:
            continue
        clean = lint_verilator(block) and clean
        if verible:
            clean = lint_verible(verible, block) and clean
    if not clean:
        return 1
    if not verible:
        print("skipped: verible missing")
        return SKIPPED
    if skipped:
        print(f"skipped: pythondata-cpu-picorv32 missing, for {', '.join(skipped)}")
        return SKIPPED
    print(f"lint: {len(wanted)} block(s) clean")
    return 0
