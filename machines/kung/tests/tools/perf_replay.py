# SPDX-License-Identifier: Apache-2.0
"""Rows of trammel perf that replay recorded pins: Icarus Verilog on a netlist written by Yosys."""

import os
import shutil
import subprocess
import time
from pathlib import Path

import perf_cocotb
from perf_rows import OUT, PREFIX_S, TESTS, Failed, Measured, NotHere, run_row
from trammel_tools import python_tools
from trammel_tools.rtl import yosys

NETLIST = """read_slang --top kung_xy {files}
proc
flatten
opt_clean
write_verilog -noattr kung_xy.v
"""
BENCH = TESTS / "replay.v"
DRIVE, IRQ, BUS_DONE, TICK, SAMPLE = 2, 4, 8, 16, 32  # cosim::Why
MASK = 2**64 - 1


def lines_of(hi, lo):
    """Gates as machines/kung/chip/pins.hpp packs them."""
    return sum(((hi >> 3 * axis) & 7) << 6 * axis | ((lo >> 3 * axis) & 7) << 6 * axis + 3
               for axis in (0, 1))


def event_hash(printed):
    """That of machines/kung/run/recorder.cpp, from the lines of a replay."""
    state = 0xcbf29ce484222325

    def mix(value):
        nonlocal state
        state = ((state ^ value & MASK) * 0x9e3779b97f4a7c15) & MASK
        state ^= state >> 29

    before, irq_before = 0, 0
    for line in printed:
        edge, hi, lo, flags, *words = line.split()
        irq, tick, sample, done = (int(f) for f in flags)
        drive = lines_of(int(hi, 16), int(lo, 16))
        data, *words = (int(word, 16) for word in words)
        why = ((DRIVE if drive != before else 0) | (IRQ if irq and not irq_before else 0) |
               BUS_DONE * done | TICK * tick | SAMPLE * sample)
        before, irq_before = drive, irq
        if not why:
            continue
        mix(int(edge))
        mix(why << 32 | drive)
        if done:
            mix(data)
        if sample:
            for x_m, i_q_ref in (words[:2], words[2:]):
                mix(x_m)
                mix((i_q_ref ^ 0x800) - 0x800 & 0xffffffff)  # 12 bits, two's complement
    return f"{state:016x}"


class Replay:
    """Pins of row a over the prefix, the netlist, and what was made of them; made on first use."""

    def __init__(self):
        self.clocks = round(PREFIX_S * 50e6)
        self.pins = OUT / "pins.txt"
        self.recorded = None
        self.program = None
        self.cocotb_is_built = False

    def reference(self):
        """The event hash of the run that the pins were recorded of."""
        if self.recorded is None:
            OUT.mkdir(parents=True, exist_ok=True)
            self.recorded = run_row("a", PREFIX_S, f"pins={self.pins}")
        return self.recorded.event_hash

    def run(self, row):
        self.reference()
        return self.icarus() if row == "f" else self.cocotb()

    def prepare_icarus(self):
        if shutil.which("iverilog") is None:
            raise NotHere("not installed: apt-get install iverilog")
        python_tools.need("pyosys", "perf")
        try:
            yosys.make(NETLIST.format(files=" ".join(map(str, yosys.design()))), OUT, "netlist")
        except yosys.YosysError as error:
            raise Failed(str(error)) from error
        self.program = OUT / "replay.vvp"
        done = subprocess.run(["iverilog", "-g2005", "-s", "replay", "-o", self.program, BENCH,
                               OUT / "kung_xy.v"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"iverilog: {done.stderr[-500:]}")

    def icarus(self):
        if self.program is None:
            self.prepare_icarus()
        events = OUT / "icarus.txt"
        return measured(["vvp", self.program, f"+pins={self.pins}", f"+end={self.clocks}"],
                        events, events, self.clocks)

    def cocotb(self):
        log, events = OUT / "cocotb.log", OUT / "cocotb.txt"
        command = perf_cocotb.command("run")
        environment = perf_cocotb.environment() | {
            "PERF_PINS": str(self.pins), "PERF_EVENTS": str(events), "PERF_END": str(self.clocks)}
        if not self.cocotb_is_built:
            with log.open("wb") as file:
                done = subprocess.run(perf_cocotb.command("build"), env=environment, stdout=file,
                                      stderr=subprocess.STDOUT, check=False)
            if done.returncode != 0:
                raise Failed(f"cocotb does not build: {log}")
            self.cocotb_is_built = True
        events.unlink(missing_ok=True)
        return measured(command, log, events, self.clocks, cwd=OUT, env=environment)


def measured(command, log, events, clocks, **where):
    """A process that writes events; its start-up counts too."""
    with log.open("wb") as file:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT, **where)
        peak = watch(process.pid)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.monotonic() - start
    if process.returncode != 0 or not events.exists():
        raise Failed(f"{command[0]}: exit code {process.returncode}: see {log}")
    lines = events.read_text(encoding="utf-8", errors="replace").split("\n")
    found = event_hash(line for line in lines if line[:1].isdigit())
    return Measured(clocks, clocks, found, used.ru_utime + used.ru_stime, wall, peak)


def watch(pid):
    """Peak memory [KiB] of a process or of its child, until it ends. That of wait4() begins with
    our own."""
    peak = 0
    while True:
        try:
            children = Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii").split()
            own = high_water(pid)
        except OSError:
            return peak
        if own is None:  # a zombie has no memory
            return peak
        peak = max([peak, own, *(high_water(child) or 0 for child in children)])
        time.sleep(0.02)


def high_water(pid):
    status = Path(f"/proc/{pid}/status")
    try:
        lines = status.read_text(encoding="ascii").split("\n")
    except OSError:
        return None
    return next((int(line.split()[1]) for line in lines if line.startswith("VmHWM:")), None)
