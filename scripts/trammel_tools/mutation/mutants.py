# SPDX-License-Identifier: Apache-2.0
"""Makes the mutants of a block: one netlist that holds all of them behind a selector.

Yosys changes one bit of one port of one cell a mutant (stuck, inverted, or inverted while another
bit of the port is 0 or 1). Only cells of the block's own module are changed, not those of blocks
inside it, and no clock. The selector is an undriven net of the netlist; whoever uses it drives it.
"""

import hashlib
import re
from dataclasses import dataclass

from trammel_tools.paths import ROOT, block_file
from trammel_tools.rtl import yosys

OUT = ROOT / "build" / "mutants"
SELECTOR = "trammel_mutant"
WIDTH = 8  # bits of the selector; 0 selects no mutant
COUNT = 200
SEED = 1
SPARE = 200  # listed beyond COUNT, since some pins are dropped
# Clocks, and pins that a memory has for other kinds of read ports than ours.
EXEMPT = {"CLK", "clk_i", "clk", "WR_CLK", "RD_CLK", "RD_EN", "RD_ARST", "RD_SRST"}

# Enables become part of the registers: else a stuck or inverted output would feed itself back while
# nothing happens. Resets stay in the data path, so that their values can be changed.
READ = """read_slang --keep-hierarchy --top {top} {files}
proc -norom
bwmuxmap
opt -nosdff
memory_collect
memory_map -rom-only
wreduce
opt_clean
write_rtlil plain.il
mutate -list {count} -seed {seed} -o list.txt {top}/*
"""
APPLY = """read_rtlil plain.il
cd {top}
add -wire {selector} {width}
setattr -set keep 1 w:{selector}
cd ..
{mutations}
flatten
opt_clean
hierarchy -top {top}
write_rtlil mutants.il
write_verilog -noattr mutants.v
splitnets -driver
opt_clean
write_verilog -noattr split.v
"""


class MutationError(Exception):
    """One line: why a block cannot be mutated."""


@dataclass
class Mutant:
    number: int
    command: str  # Yosys
    words: str
    where: str  # path:line


def folder_of(block):
    folder = OUT / block.replace("/", "_")
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def source_hash(block):
    """Of what decides which mutants there are: the text without comments and spacing."""
    text = block_file(block, ".sv").read_text(encoding="utf-8")
    code = " ".join(re.sub(r"//.*", "", text).split())
    return hashlib.sha256(code.encode()).hexdigest()[:16]


def field(command, name):
    found = re.search(rf" -{name} (\S+)", command)
    return found[1] if found else None


def excerpt(place, folder):
    """Text of path:line.column-line.column, on one line; Yosys' paths start at the folder."""
    found = re.fullmatch(r"(.+):(\d+)\.(\d+)(?:-(\d+)\.(\d+))?", place)
    if not found:
        return place, ""
    path, line, column = (folder / found[1]).resolve(), int(found[2]), int(found[3])
    lines = path.read_text(encoding="utf-8").split("\n")
    last, end = (int(found[4]), int(found[5])) if found[4] else (line, len(lines[line - 1]) + 1)
    text = lines[line - 1:last]
    text[-1] = text[-1][:end - 1]
    text[0] = text[0][column - 1:]
    if path.is_relative_to(ROOT):
        path = path.relative_to(ROOT)
    return f"{path}:{line}", shortened(" ".join(" ".join(text).split()))


def shortened(text):
    return text if len(text) <= 30 else text[:27] + "..."


def describe(number, command, cells, folder):
    mode, port, bit = (field(command, n) for n in ("mode", "port", "portbit"))
    other = field(command, "ctrlbit")
    effect = {"inv": "inverted", "const0": "stuck at 0", "const1": "stuck at 1",
              "cnot0": f"inverted while bit {other} is 0",
              "cnot1": f"inverted while bit {other} is 1"}[mode]
    cell = field(command, "cell")
    places = cells.get(cell, [])
    # The narrowest place is the expression itself, the others are statements around it.
    spots = sorted((excerpt(p, folder) for p in places), key=lambda spot: len(spot[1]))
    where, text = spots[0] if spots else ("", shortened(cell))
    kind = cells.get(f"{cell} type", "")
    words = f"{kind} `{text}`, {port}[{bit}] {effect}"
    wire = field(command, "wire")
    if wire and len(words) + len(wire) < 80:  # a table's line has 100 columns
        words += f" ({wire}[{field(command, 'wirebit')}])"
    return Mutant(number, command, words, where)


def read_cells(netlist, top):
    """Places in the sources of each cell of the module, and its type under `<cell> type`."""
    cells, inside, places = {}, False, []
    for line in netlist.read_text(encoding="utf-8").split("\n"):
        if line.startswith("module "):
            inside = line.split()[1] == f"\\{top}"
        elif inside and line.startswith("  attribute \\src "):
            places = line.split('"')[1].split("|")
        elif inside and line.startswith("  cell "):
            _, kind, name = line.split()
            cells[name.lstrip("\\")] = places
            cells[f"{name.lstrip(chr(92))} type"] = kind.lstrip("$\\").split("$")[0]
            places = []
        elif inside and line.startswith("  ") and not line.startswith(("   ", "  attribute")):
            places = []
    return cells


def make(block, count=COUNT, seed=SEED):
    """Writes the netlists of a block; returns its mutants, numbered from 1.

    mutants.il and mutants.v keep the names of the source; split.v has no net that several cells
    drive in parts, which Verilator would take for loops.
    """
    folder, top = folder_of(block), block.split("/")[1]
    files = " ".join(str(p) for p in yosys.design())
    yosys.make(READ.format(top=top, files=files, count=count + SPARE, seed=seed), folder, "read")
    commands = [line for line in (folder / "list.txt").read_text(encoding="utf-8").split("\n")
                if line.startswith("mutate ") and field(line, "port") not in EXEMPT][:count]
    cells = read_cells(folder / "plain.il", top)
    found = [describe(n, command, cells, folder) for n, command in enumerate(commands, 1)]
    mutations = "\n".join(
        m.command.split(" -src ")[0].replace(
            "mutate ", f"mutate -ctrl {SELECTOR} {WIDTH} {m.number} ", 1) for m in found)
    yosys.make(APPLY.format(top=top, selector=SELECTOR, width=WIDTH, mutations=mutations), folder,
               "apply")
    return found


def with_selector(block, netlist, declaration, name):
    """Writes the netlist as `name` with the selector declared so; returns its path."""
    folder = folder_of(block)
    text = (folder / netlist).read_text(encoding="utf-8")
    net = f"  wire [{WIDTH - 1}:0] {SELECTOR};\n"
    if text.count(net) != 1:
        raise MutationError(f"{folder}/{netlist}: selector is not there once")
    path = folder / name
    path.write_text(text.replace(net, declaration), encoding="utf-8")
    return path
