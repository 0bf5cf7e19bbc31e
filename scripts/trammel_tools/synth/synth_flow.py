# SPDX-License-Identifier: Apache-2.0
"""Yosys and nextpnr for trammel synth: from sources to a mapped netlist and to a placed one."""

import contextlib
import dataclasses
import importlib.metadata
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from trammel_tools import output_file
from trammel_tools.paths import RTL, block_file
from trammel_tools.rtl import lint

# What the leap contract adds; a board ties the input to 0 and leaves the outputs open.
LEAP_INPUTS, LEAP_OUTPUTS = ("leap_i",), ("next_o", "quiescent_o", "awake_o", "timed_o")
CORE = "pythondata-cpu-picorv32"
# Area comes first where the clock allows: without a limit every path is made as fast as it can be,
# which took 11 % more cells. [ps] of logic alone; routing takes more than half of a period.
ABC_LIMIT = "8000"
# A carry chain costs four cells more than its bits; shorter ones are smaller as lookup tables.
SHORT_CARRY = 7


class FlowError(Exception):
    """A tool refused the design; the text names its log."""


@dataclasses.dataclass(frozen=True)
class Device:
    family: str
    name: str
    options: tuple  # of nextpnr
    target_mhz: int

    @property
    def placer(self):
        return f"yowasp-nextpnr-{self.family}"

    def program(self):
        """Beside this Python or on the path, or None."""
        local = Path(sys.executable).parent / self.placer
        return str(local) if local.exists() else shutil.which(self.placer)


ECP5 = Device("ecp5", "LFE5U-25F CABGA381", ("--25k", "--package", "CABGA381"), 65)
ICE40 = Device("ice40", "iCE40UP5K SG48", ("--up5k", "--package", "sg48"), 25)
DEVICES = (ECP5, ICE40)


def sources():
    """All sources, packages first; a path is what Yosys' messages and cell attributes show."""
    found = [*lint.packages(), *sorted(RTL.glob("chips/generated/*_regs.sv"))]
    found += [block_file(block, ".sv") for block in lint.blocks()]
    return found + sorted(RTL.glob("boards/*/*.sv")) + lint.cores()


def versions():
    placers = {f"nextpnr-{device.family}": importlib.metadata.version(device.placer)
               for device in DEVICES}
    return {"yosys": importlib.metadata.version("pyosys"), **placers}


@contextlib.contextmanager
def output_to(log):
    """Yosys writes to the file descriptors, not to Python's streams."""
    sys.stdout.flush()
    sys.stderr.flush()
    saved = [os.dup(1), os.dup(2)]
    with log.open("wb") as file:
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            for target, copy in enumerate(saved, 1):
                os.dup2(copy, target)
                os.close(copy)


@contextlib.contextmanager
def read_design(top, log):
    """The design without leap contract and clock enables, and what runs a Yosys command on it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # in a worker: end without a traceback
    from pyosys import libyosys as ys  # takes 0.2 s: not for --help
    with output_to(log):
        design = ys.Design()

        def run(command):
            ys.run_pass(command, design)

        run(f"read_slang --keep-hierarchy --top {top} " + " ".join(str(s) for s in sources()))
        run(f"hierarchy -top {top}")
        run(f"delete -input {top}/w:clock_en_i")  # no clock is gated
        run(f"setundef -undriven -one {top}")
        for name in LEAP_INPUTS:
            run(f"delete -input {top}/w:{name}")
        for name in LEAP_OUTPUTS:
            run(f"delete -output {top}/w:{name}")
        run(f"setundef -undriven -zero {top}")
        yield design, run


def map_to_ecp5(top, folder, check=None):
    """Writes <top>.modules.json (before flattening) and <top>.json (mapped) into the folder.

    check: is called with the top's ports before the long part.
    """
    folder = Path(folder)
    with read_design(top, folder / f"{top}.yosys.log") as (design, run):
        run(f"write_json {folder / top}.modules.json")
        checked(top, folder, check)
        design.scratchpad_set_string("abc9.D", ABC_LIMIT)
        run(f"synth_ecp5 -top {top} -run begin:map_gates")
        run(f"techmap t:$alu r:Y_WIDTH<={SHORT_CARRY} %i")
        run(f"synth_ecp5 -top {top} -run map_gates:check")
        run("check -noinit -assert")
        run("blackbox =A:whitebox")
        run(f"write_json {folder / top}.json")


def checked(top, folder, check):
    if check:
        modules = json.loads((folder / f"{top}.modules.json").read_text(encoding="utf-8"))
        check(modules["modules"][top]["ports"])


def map_to_ice40(top, folder, check=None):
    """Writes <top>.json (mapped) into the folder; cells by type. check: as in map_to_ecp5."""
    folder = Path(folder)
    netlist = folder / f"{top}.json"
    netlist.unlink(missing_ok=True)
    log = folder / f"{top}.yosys.log"
    with read_design(top, log) as (_, run):
        run(f"write_json {folder / top}.modules.json")
        checked(top, folder, check)
        run(f"synth_ice40 -device u -abc9 -top {top} -json {netlist}")
    if not netlist.exists():
        raise FlowError(f"Yosys gave no netlist of {top} for iCE40: see {log}")
    cells = json.loads(netlist.read_text(encoding="utf-8"))["modules"][top]["cells"].values()
    kinds = [cell["type"] for cell in cells]
    return {"lut4": kinds.count("SB_LUT4"), "carry": kinds.count("SB_CARRY"),
            "ff": sum(kind.startswith("SB_DFF") for kind in kinds),
            "block_ram": sum(kind.startswith("SB_RAM40") for kind in kinds)}


def read_mapped(top, folder, end=""):
    folder = Path(folder)
    try:
        return json.loads((folder / f"{top}{end}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise FlowError(f"Yosys gave no netlist of {top}: see {folder / top}.yosys.log"
                        ) from error


def read_netlist(top, folder):
    """Before flattening, and mapped."""
    return read_mapped(top, folder, ".modules"), read_mapped(top, folder)


def write_whole(path, text):
    """The file is the old one or the new one, never a part."""
    try:
        output_file.replace(path, text)
    except output_file.Refused as error:
        raise FlowError(error) from None


def place_and_route(top, folder, seed, device, more=None):
    """nextpnr's report; files are named relative to the folder, which its sandbox sees.

    more: options in place of free pins.
    """
    free = "--lpf-allow-unconstrained" if device.family == "ecp5" else "--pcf-allow-unconstrained"
    more = [free] if more is None else more
    log = Path(folder) / f"{top}.nextpnr.log"
    report = Path(folder) / f"{top}.report.json"
    report.unlink(missing_ok=True)
    configuration = "--textcfg" if device.family == "ecp5" else "--asc"
    target = ["--freq", str(device.target_mhz)] if device.target_mhz else []
    command = [device.program(), *device.options, *more, "--json", f"{top}.json", *target,
               "--timing-allow-fail", "--seed", str(seed), "--report", report.name, configuration,
               f"{top}.config"]
    with log.open("wb") as file:
        done = subprocess.run(command, cwd=folder, stdout=file, stderr=file, check=False)
    if done.returncode != 0 or not report.exists():
        errors = [line for line in log.read_text(errors="replace").splitlines()
                  if line.startswith("ERROR")]
        raise FlowError(f"nextpnr: {errors[0] if errors else 'failed'}: see {log}")
    return json.loads(report.read_text(encoding="utf-8"))
