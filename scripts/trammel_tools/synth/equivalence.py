# SPDX-License-Identifier: Apache-2.0
"""Prove that blocks are what Yosys maps them to: RTL and ECP5 netlist, for every input.

usage: scripts/tool equivalence [layer/block ...]

Registers of both are matched by name; then every one of them and every output is proven equal in
all states in which the others are (equiv_simple, equiv_induct). Without arguments: the blocks
below, which have neither multiplier nor memory; the others are compared by the placed netlist in
closed loop (scripts/tool netlist).

Each block is also tried with one bit of one lookup table flipped, which must be refuted.

Exit codes: 0 proven, 1 not, or a flipped bit not found, 2 usage, 3 Yosys is missing (under
CTest 77).
"""

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import RTL
from trammel_tools.rtl import lint
from trammel_tools.synth import synth_flow

BLOCKS = ["drive/gate_leg", "drive/supervisor", "motion/watchdog", "sense/qep", "sense/adc_if",
          "drive/pwm", "motion/timebase", "control/command", "drive/vector_limit", "math/timer",
          "bus/lm628_bridge", "motion/lm628_time"]
DEPTH = 4  # clocks of the induction
TRIES = 6  # flipped bits, of which one must be found
BOXES = "whitebox lib_whitebox blackbox abc9_box keep_hierarchy"


def models():
    """Files with what the cells do: Yosys' own, and ours for what it has as black boxes."""
    import pyosys
    own = Path(pyosys.__file__).parent / "share" / "ecp5"
    return [own / "common_sim.vh", own / "ccu2c_sim.vh"]


def prepared(run, top, name):
    """The design in hand becomes `name`, of simple registers and gates."""
    for command in (f"hierarchy -top {top}", "proc", "flatten", "opt_clean", "memory_map",
                    "async2sync", "opt_clean", f"rename {top} {name}", f"design -stash {name}"):
        run(command)


def read_cells(run, netlist, top, files):
    """The mapped netlist with what its cells do."""
    run(f"read_json {netlist}")
    run("delete t:$scopeinfo")
    run("delete =A:blackbox")
    run("read_verilog -sv " + " ".join(map(str, files)))
    run(f"hierarchy -top {top}")
    for word in BOXES.split():
        run(f"setattr -mod -unset {word} =*")


def proven(top, folder, netlist):
    """Whether RTL and netlist are equal; the log is <top>.equivalence.log."""
    status = folder / f"{top}.equivalence.txt"
    status.unlink(missing_ok=True)
    try:
        with synth_flow.read_design(top, folder / f"{top}.equivalence.log") as (_, run):
            prepared(run, top, "gold")
            read_cells(run, netlist, top, models())
            prepared(run, top, "gate")
            run("design -copy-from gold -as gold gold")
            run("design -copy-from gate -as gate gate")
            for command in ("equiv_make gold gate equiv", "hierarchy -top equiv", "opt_clean",
                            "equiv_simple", f"equiv_induct -seq {DEPTH}",
                            f"tee -o {status} equiv_status"):
                run(command)
    except RuntimeError as error:
        raise synth_flow.FlowError(f"{top}: Yosys: {error}") from error
    text = status.read_text(encoding="utf-8") if status.exists() else ""
    return "Equivalence successfully proven!" in text


def flipped(netlist, top, target, number):
    """Writes the netlist with bit 0, that of all inputs 0, of one lookup table flipped."""
    design = json.loads(netlist.read_text(encoding="utf-8"))
    tables = [c for c in design["modules"][top]["cells"].values() if c["type"] == "LUT4"]
    # Those with the most inputs first: of the others some bits mean nothing.
    tables.sort(key=lambda c: sum(isinstance(c["connections"][pin][0], str) for pin in "ABCD"))
    parameters = tables[number % len(tables)]["parameters"]
    bits = parameters["INIT"]
    parameters["INIT"] = bits[:-1] + ("0" if bits[-1] == "1" else "1")
    target.write_text(json.dumps(design), encoding="utf-8")


def check(block, folder):
    """Lines of what is wrong with a block."""
    top = block.split("/")[1]
    netlist = folder / f"{top}.json"
    synth_flow.map_to_ecp5(top, folder)
    begin = time.monotonic()
    if not proven(top, folder, netlist):
        yield "not proven equal to its netlist"
        return
    took = time.monotonic() - begin
    other = folder / f"{top}.flipped.json"
    for number in range(TRIES):  # not every combination of inputs can occur
        flipped(netlist, top, other, number)
        if not proven(top, folder, other):
            break
    else:
        yield f"of {TRIES} flipped bits of lookup tables none is found"
        return
    print(f"{block:<24}proven equal to its netlist in {took:.1f} s; a flipped bit is refuted",
          flush=True)


def main():
    parser = argparse.ArgumentParser(prog="scripts/tool equivalence", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("blocks", nargs="*", metavar="layer/block")
    wanted = parser.parse_args()
    for block in wanted.blocks:
        if block not in lint.blocks() or not (RTL / f"{block}.sv").exists():
            parser.error(f"{block}: no such block")
    python_tools.need("pyosys", "equivalence")
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        for block in wanted.blocks or BLOCKS:
            for line in check(block, Path(folder)):
                print(f"{block}: {line}", file=sys.stderr)
                bad += 1
    return 1 if bad else 0
