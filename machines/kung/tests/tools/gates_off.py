# SPDX-License-Identifier: Apache-2.0
"""Prove that on a board gates and driver enables are off from configuration until enabled.

usage: scripts/tool gates-off FOLDER     of trammel synth --board, with the mapped netlist

In the netlist that is placed, for all inputs and all states of everything else:
  - the registers of an axis' gates and its CTRL.enable are configured as 0, at any clock or reset;
  - while CTRL.enable is 0, a clock leaves the gates' registers 0, and the driver's enable is 0.
So by induction gates and enables of an axis are 0 from configuration until its CTRL.enable is
written. The clock tree, pads and what the pins do before configuration are not in the netlist.

Controls: a gate's register configured as 1, and one without its reset and logic, must be refuted.

Exit codes: 0 proven, 1 not, 2 usage, 3 Yosys is missing (under CTest 77).
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import RTL
from trammel_tools.synth import equivalence, synth_flow

AXES = ("x", "y")


class NotProven(Exception):
    """One line: what is not as it must be."""


def drivers(module):
    """{bit: (name, cell)} of the cell that drives it."""
    found = {}
    for name, cell in module["cells"].items():
        for port, bits in cell["connections"].items():
            if cell["port_directions"].get(port) == "output":
                found.update((bit, (name, cell)) for bit in bits)
    return found


def enable_bits(module):
    """The net of CTRL.enable of each axis."""
    found = []
    for axis in AXES:
        ends = f".field_storage_{axis}_ctrl_enable_value"
        names = [n for n in module["netnames"] if n.endswith(ends)]
        if len(names) != 1 or len(module["netnames"][names[0]]["bits"]) != 1:
            raise NotProven(f"{len(names)} registers *{ends} in the netlist, not one")
        found.append(module["netnames"][names[0]]["bits"][0])
    return found


def register_of(bit, made, what):
    """The flip-flop behind a bit, which must be configured as 0 and never set at once."""
    name, cell = made.get(bit, ("nothing", {"type": "nothing"}))
    if cell["type"] != "TRELLIS_FF":
        raise NotProven(f"{what} is driven by {name} ({cell['type']}), not by a register")
    if cell["parameters"]["REGSET"].strip() != "RESET":
        raise NotProven(f"{what} is configured as 1")
    if cell["parameters"].get("SRMODE", "LSR_OVER_CE").strip() != "LSR_OVER_CE":
        raise NotProven(f"{what} has an asynchronous reset")
    return cell


def places(module):
    """The bits of CTRL.enable, and (axis, what, register or None, bit) of what must stay 0."""
    made = drivers(module)
    enables = enable_bits(module)
    for axis, bit in zip(AXES, enables):
        register_of(bit, made, f"CTRL.enable of {axis}")
    wires = []
    for port in ("gate_hi_o", "gate_lo_o"):
        bits = module["ports"][port]["bits"]
        for n, bit in enumerate(bits):
            what = f"{port}[{n}]"
            cell = register_of(bit, made, what)
            wires.append((n // 3, what, cell, bit))
    for n, bit in enumerate(module["ports"]["driver_en_o"]["bits"]):
        wires.append((n, f"driver_en_o[{n}]", None, bit))
    return enables, wires


def cone(module, made, wanted, stop):
    """Lookup tables and carries that the wanted bits depend on, and the bits they begin at."""
    cells, begin, pending, seen = {}, set(), list(wanted), set()
    while pending:
        bit = pending.pop()
        if bit in seen or isinstance(bit, str):
            continue
        seen.add(bit)
        name, cell = made.get(bit, (None, None))
        if bit in stop or cell is None or cell["type"] not in ("LUT4", "CCU2C", "PFUMX",
                                                               "L6MUX21"):
            begin.add(bit)
            continue
        cells[name] = cell
        pending += [b for port, bits in cell["connections"].items() for b in bits
                    if cell["port_directions"][port] == "input"]
    return cells, begin


def value(text):
    return f'"{text}"' if set(text) - set("01x") else f"{len(text)}'b{text}"


def verilog(module, axis, cells, begin, enable, next_bits):
    """A combinational module: inputs are the bits it begins at, output bad is any next bit."""
    inputs = sorted(b for b in begin if b != enable)
    lines = [f"module question_{AXES[axis]} ({', '.join(f'n{b}' for b in inputs)}"
             f"{', ' if inputs else ''}bad);"]
    lines += [f"input n{b};" for b in inputs] + ["output bad;"]
    lines.append(f"wire n{enable} = 1'b0;")
    outputs = {b for cell in cells.values() for port, bits in cell["connections"].items()
               for b in bits if cell["port_directions"][port] == "output"}
    lines += [f"wire n{b};" for b in sorted(outputs)]
    for number, cell in enumerate(cells.values()):
        parameters = ", ".join(f".{k}({value(v)})" for k, v in cell["parameters"].items())
        pins = ", ".join(f".{port}({bit_name(bits[0])})"
                         for port, bits in cell["connections"].items() if bits)
        lines.append(f"{cell['type']} {f'#({parameters}) ' if parameters else ''}c{number} "
                     f"({pins});")
    lines.append(f"assign bad = {' | '.join(next_bits) or chr(49) + chr(39) + 'b0'};")
    return "\n".join([*lines, "endmodule", ""])


def bit_name(bit):
    return f"n{bit}" if isinstance(bit, int) else f"1'b{bit if bit in '01' else '0'}"


def next_of(cell):
    """The next value of a flip-flop that is 0, and the bits it depends on."""
    parameters, pins = cell["parameters"], cell["connections"]

    def pin(name, mux):
        bits = pins.get(name, [])
        told = parameters.get(mux, "").strip()
        if told in ("0", "1"):
            return f"1'b{told}", []
        if not bits:
            return "1'b0", []
        text = bit_name(bits[0])
        return (f"~{text}" if told == "INV" else text), bits[:1]

    data = bit_name(pins["DI"][0])
    enable, some = pin("CE", "CEMUX")
    reset, more = pin("LSR", "LSRMUX")
    return f"({data} & {enable} & ~{reset})", [pins["DI"][0], *some, *more]


def refuted(folder, module):
    """Names of what can become 1 although CTRL.enable of its axis is 0."""
    made = drivers(module)
    enables, wires = places(module)
    state = {bit for _, _, cell, bit in wires if cell}  # gates: 0 before the clock
    text, tops = "", []
    for at, (axis, what, cell, bit) in enumerate(wires):
        new, wanted = next_of(cell) if cell else (bit_name(bit), [bit])
        cells, begin = cone(module, made, wanted, {*enables, *(state if cell else ())})
        own = verilog(module, axis, cells, begin, enables[axis], [new])
        own = own.replace(f"module question_{AXES[axis]}", f"module question_{at}")
        text += own
        tops.append((f"question_{at}", what))
    (folder / "questions.v").write_text(text, encoding="utf-8")
    return list(asked(folder, tops))


def asked(folder, tops):
    from pyosys import libyosys as ys
    for name, what in tops:
        log = folder / f"{name}.log"
        with synth_flow.output_to(log):
            design = ys.Design()
            for command in ("read_verilog -sv " + " ".join(map(str, equivalence.models())),
                            f"read_verilog -sv {folder / 'questions.v'}", f"hierarchy -top {name}",
                            *(f"setattr -mod -unset {word} =*"
                              for word in equivalence.BOXES.split()),
                            "proc", "flatten", "opt", f"sat -prove bad 0 {name}"):
                ys.run_pass(command, design)
        if "SAT proof finished - no model found: SUCCESS!" not in log.read_text("utf-8"):
            yield what


def controls(folder, module):
    """Changes that must be refuted; lines of those that are not."""
    bit = module["ports"]["gate_hi_o"]["bits"][0]
    name, cell = drivers(module)[bit]
    for what, change in (
            ("configured as 1", {"REGSET": "SET"}),
            ("always set", None)):
        changed = dict(cell)
        if change:
            changed["parameters"] = {**cell["parameters"], **change}
        else:
            changed["connections"] = {**cell["connections"], "DI": ["1"], "LSR": ["0"],
                                      "CE": ["1"]}
        other = {**module, "cells": {**module["cells"], name: changed}}
        try:
            found = refuted(folder, other)
        except NotProven:
            continue
        if not found:
            yield f"a gate's register that is {what} is not found"


def main():
    parser = argparse.ArgumentParser(prog="scripts/tool gates-off", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    wanted = parser.parse_args()
    python_tools.need("pyosys", "gates-off")
    tops = [p for p in wanted.folder.glob("kung_soc_*.json")
            if (RTL / "boards" / p.stem.removeprefix("kung_soc_")).is_dir()]
    if len(tops) != 1:
        parser.error(f"{wanted.folder}: {len(tops)} mapped netlists of a board, not one")
    top = tops[0].stem
    module = json.loads(tops[0].read_text(encoding="utf-8"))["modules"][top]
    with tempfile.TemporaryDirectory() as folder:
        try:
            bad = [f"{what} can become 1 while its axis is not enabled"
                   for what in refuted(Path(folder), module)]
            bad += controls(Path(folder), module)
        except NotProven as error:
            bad = [str(error)]
    for line in bad:
        print(f"gates-off: {top}: {line}", file=sys.stderr)
    if not bad:
        print(f"{top}: 12 gates and 2 driver enables are 0 from configuration until their axis is "
              "enabled: proven; 2 of 2 controls refuted")
    return 1 if bad else 0
