# SPDX-License-Identifier: Apache-2.0
"""Run the placed and routed netlist of a board in closed loop beside its RTL.

usage: scripts/tool netlist FOLDER [--seconds S] [--path NAME] [--no-flips | --record]

FOLDER is of `trammel synth --board` with kung_soc. The netlist is what nextpnr placed and routed,
its memory what the bitstream's configuration holds; the firmware runs in both, a console types the
path and `start` on the serial port, and the netlist drives the table. All outputs are compared at
all clocks. Then one bit after the other of lookup tables behind registers of pins is flipped: each
table must be found.

--record adds the run to the placement on record (rtl/boards/<board>/kung_soc.placed.json), which
`trammel synth --board --check` asks for: minutes that CI need not spend on the same netlist.

--seconds is simulated time, 0.05 unless given; --path line or circle. Pads, clock tree, PLL and the
tool's bit database are not in it: this is a placed netlist, not hardware in the loop.

Exit codes: 0 no output differs and flips are found, 1 not so or it does not build, 2 usage, 3 a
tool is missing (under CTest 77).
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import ROOT
from trammel_tools.rtl import lint
from trammel_tools.synth import board, placed, placed_record, synth_flow

SOURCE = ROOT / "machines" / "kung" / "tests" / "netlist"
BUILD = ROOT / "build"
OUT = BUILD / "netlist"
SLOWEST = 80_000  # clocks of both a CPU second
FLIPS = 2  # tables that are tried


def write_netlist(folder, top):
    """netlist.v and the RTL's image from a folder of trammel synth; the flips that it offers."""
    before, after = (placed.read_contents(folder / f"{top}{end}.config")
                     for end in ("", ".firmware"))
    design = placed.Placed(folder / f"{top}.placed.json", top,
                           {words: after[n] for n, words in before.items()})
    OUT.mkdir(parents=True, exist_ok=True)
    text = design.verilog()
    target = OUT / "netlist.v"
    if not target.exists() or target.read_text(encoding="ascii") != text:
        target.write_text(text, encoding="ascii")
    shutil.copyfile(folder / "firmware.hex", OUT / "image.hex")
    return design.flips


def build(name):
    commands = (["cmake", "-S", SOURCE, "-B", OUT, "-G", "Ninja", f"-DBASE={BUILD}",
                 f"-DBOARD={name}", f"-DCORE={lint.cores()[0]}",
                 "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"], ["ninja", "-C", OUT])
    for command in commands:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print((done.stdout + done.stderr)[-4000:], file=sys.stderr)
            return False
    return True


def run(*words):
    """What netlist_run prints, or None."""
    done = subprocess.run([OUT / "netlist_run", *map(str, words)], cwd=OUT, capture_output=True,
                          text=True, check=False)
    if done.returncode not in (0, 1) or not done.stdout:
        print(f"netlist: exit code {done.returncode}: {done.stderr.strip()}", file=sys.stderr)
        return None
    return json.loads(done.stdout)


def wrong(result):
    """Lines of what is wrong in the run without a flip."""
    if result is None:
        yield "did not run"
        return
    print(f"netlist: {result['clocks']} clocks, {result['gate_changes']} changes of gates, "
          f"{result['different']} differences of outputs; {result['clocks_per_s']:.0f} clocks a "
          f"CPU second of both; the console says '{' '.join(result['said'].split())}'; at "
          f"({result['x_mm']:.3f}, {result['y_mm']:.3f}) mm", flush=True)
    if result["different"]:
        yield f"{result['different']} outputs differ: {result['first'][0]}"
    if not result["gate_changes"]:
        yield "the gates never switched"
    if result["clocks_per_s"] < SLOWEST:
        print(f"netlist: slower than {SLOWEST} clocks a CPU second", file=sys.stderr)


def flip(wanted, number, port):
    """A line if no flipped bit of this lookup table is found."""
    result = run(wanted.seconds, wanted.path, number)
    if result is None or not result["different"]:
        yield f"no flipped bit of the lookup table behind {port} is found"
        return
    print(f"netlist: bit {result['flipped_bit']} of the lookup table behind {port} flipped: "
          f"{result['first'][0]}", flush=True)


def main():
    parser = argparse.ArgumentParser(prog="scripts/tool netlist", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seconds", type=float, default=0.05)
    parser.add_argument("--path", choices=("line", "circle"), default="line")
    parser.add_argument("--no-flips", action="store_true")
    parser.add_argument("--record", action="store_true")
    wanted = parser.parse_args()
    if wanted.record and wanted.no_flips:
        parser.error("--record needs the flips")
    boards = [name for name in board.names() if "kung_soc" in board.find(name).table["chips"]
              and (wanted.folder / f"kung_soc_{name}.firmware.config").exists()]
    if len(boards) != 1:
        parser.error(f"{wanted.folder}: {len(boards)} placed boards with a firmware, not one")
    if not lint.cores():
        print(f"netlist: {synth_flow.CORE} is missing (trammel doctor)", file=sys.stderr)
        return python_tools.SKIPPED if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    on = board.find(boards[0], "kung_soc")
    if wanted.record and (line := placed_record.other(on, wanted.folder)):
        parser.error(line)
    flips = write_netlist(wanted.folder.resolve(), on.top)
    if not build(boards[0]):
        return 1
    result = run(wanted.seconds, wanted.path)
    bad = list(wrong(result))
    if not wanted.no_flips and not bad:
        for number, port in sorted(flips.values(), key=lambda one: one[1])[-FLIPS:]:
            bad += flip(wanted, number, port)
    if wanted.record and not bad:
        placed_record.put_loop(on, {key: result[key] for key in ("clocks", "gate_changes",
                                                                 "different")})
    for line in bad:
        print(f"netlist: {line}", file=sys.stderr)
    return 1 if bad else 0
