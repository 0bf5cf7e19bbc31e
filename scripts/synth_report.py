# SPDX-License-Identifier: Apache-2.0
"""What trammel synth says: tables, the critical path in words, the paper's Table 1, the budget."""

import re

import synth_flow

COLUMNS = ("cells", "lut4", "carry", "ff", "block_ram", "multipliers")
HEADS = ("cells", "LUT4", "carry", "FF", "block RAM", "MULT18X18D")
FLOOR_MHZ = 50  # the IC's clock: below it nothing works
ICE40_FLOOR_MHZ = 20  # of the LM628 with Inc = 10
# Kung et al. 2012, Table 1: Altera Stratix II EP2S60.
PAPER = {"processor": (8275, 46848), "afc": (16110, 0), "current": (6818, 595968),
         "total": (31203, 642816)}
# One axis of the paper's second row: current vector control, SVPWM, QEP and ADC.
CURRENT_AXIS = {"drive/current_loop": 1, "drive/pwm": 1, "drive/gate_leg": 3, "sense/qep": 1,
                "sense/adc_if": 1}
BLOCK_RAM_BITS = 18432  # of a DP16KD, used or not


def current_axis(blocks, column):
    """Cells of one axis' current control; column: isolated (of one) or in_chip (of all)."""
    cells = 0
    for block, instances in CURRENT_AXIS.items():
        row = blocks[block]
        share = 1 if column == "isolated" else 1 / row["instances"]
        cells += row[column]["cells"] * instances * share
    return round(cells)


def place_of(path):
    """u_chip.gen_axis[1].u_axis.u_afc -> axis 1."""
    axis = re.search(r"gen_axis\[(\d)\]", path)
    return f" of axis {'XY'[int(axis[1])]}" if axis else ""


def endpoint(netlist, cell):
    base = cell if cell in netlist.cells else cell.rsplit("$", 1)[0]
    if base not in netlist.cells:
        return {"block": "pins", "path": "", "register": base}
    path, signal = netlist.signal(base)
    return {"block": netlist.block_of[path], "path": path,
            "register": signal or netlist.cells[base]["type"]}


def describe(end):
    return f"{end['register']} of {end['block']}{place_of(end['path'])}"


def critical_path(report, netlist):
    """The slowest register-to-register path of nextpnr's report, counted and in words."""
    clock, speed = max(report["fmax"].items())
    path = next(p["path"] for p in report["critical_paths"] if p["from"] == p["to"])
    parts = {"logic_ns": 0.0, "routing_ns": 0.0, "register_ns": 0.0}
    counts = {"luts": 0, "carry_bits": 0, "multipliers": 0, "block_rams": 0}
    for step in path:
        kind = step["type"] if step["type"] in ("logic", "routing") else "register"
        parts[f"{kind}_ns"] += step["delay"]
        if kind == "logic":
            cell = step["from"]["cell"]
            base = cell if cell in netlist.cells else cell.rsplit("$", 1)[0]
            owner = netlist.cells.get(base, {"type": "LUT4"})["type"]
            name = {"CCU2C": "carry_bits", "MULT18X18D": "multipliers",
                    "DP16KD": "block_rams"}.get(owner, "luts")
            counts[name] += 1
    begin, end = endpoint(netlist, path[0]["from"]["cell"]), endpoint(netlist,
                                                                     path[-1]["to"]["cell"])
    through = [f"{count} {word}" for count, word in (
        (counts["luts"], "LUTs"), (counts["carry_bits"], "bits of carry chain"),
        (counts["multipliers"], "multiplier(s)"), (counts["block_rams"], "block RAM(s)")) if count]
    total = sum(parts.values())
    text = (f"{total:.1f} ns from {describe(begin)} to {describe(end)}, through "
            f"{', '.join(through) or 'no logic'}: {parts['logic_ns']:.1f} ns logic, "
            f"{parts['routing_ns']:.1f} ns routing, {parts['register_ns']:.1f} ns registers")
    return {"fmax_mhz": round(speed["achieved"], 2), "clock": clock.removeprefix("$glbnet$"),
            "path": {"from": begin, "to": end, **counts,
                     **{name: round(value, 2) for name, value in parts.items()}, "text": text}}


def used(report):
    """Cells after place and route."""
    found = report["utilization"]
    return {"cells": found["TRELLIS_COMB"]["used"], "ff": found["TRELLIS_FF"]["used"],
            "block_ram": found["DP16KD"]["used"], "multipliers": found["MULT18X18D"]["used"],
            "available": {"cells": found["TRELLIS_COMB"]["available"],
                          "multipliers": found["MULT18X18D"]["available"]}}


def used_of_ice40(report):
    """Cells and clock rate after place and route."""
    found = report["utilization"]
    cells, rams = found["ICESTORM_LC"], found["ICESTORM_RAM"]
    return {"cells": cells["used"], "block_ram": rams["used"], "pins": found["SB_IO"]["used"],
            "available": {"cells": cells["available"], "block_ram": rams["available"],
                          "pins": found["SB_IO"]["available"]},
            "fmax_mhz": round(max(report["fmax"].items())[1]["achieved"], 2)}


def placed_findings(name, placed, speed, clock, limits):
    """What a placed chip needs more than its limits, and whether it reaches its clock [MHz]."""
    if speed < clock:
        yield f"{name}: {speed} MHz, less than the {clock} MHz it runs at"
    elif speed < limits["fmax_mhz"]:
        yield f"{name}: {speed} MHz, less than the budget's {limits['fmax_mhz']}"
    for what in sorted(limits.keys() - {"fmax_mhz"}):
        if placed[what] > limits[what]:
            yield f"{name}: {placed[what]} {what}, more than {limits[what]}"


def findings(result, budget):
    """What is over the budget: lines."""
    if "timing" in result:
        yield from placed_findings("chip", result["chip"], result["timing"]["fmax_mhz"], FLOOR_MHZ,
                                   budget["chip"])
    ice40 = result.get("ice40", {})
    if "fmax_mhz" in ice40:
        yield from placed_findings(ice40["design"], ice40, ice40["fmax_mhz"], ICE40_FLOOR_MHZ,
                                   budget["ice40"])
    blocks = result["blocks"]
    for block, limit in budget["cells"].items():
        cells = blocks.get(block, {}).get("isolated", {}).get("cells", 0)
        if cells > limit:
            yield f"{block}: {cells} cells, more than {limit}"
    for block, limit in budget["multipliers"].items():
        used = blocks.get(block, {}).get("isolated", {}).get("multipliers", 0)
        if used > limit:
            yield f"{block}: {used} multipliers, more than {limit}"
    if CURRENT_AXIS.keys() <= blocks.keys():
        cells = current_axis(blocks, "isolated")
        if cells > budget["axis"]["current_cells"]:
            yield f"current control of an axis: {cells} cells, more than " \
                  f"{budget['axis']['current_cells']}"


def rows(result):
    """Rows of the table: block, instances, one alone, all of them in the chip."""
    def figures(count):
        return [str(count[c]) for c in COLUMNS] if count else ["-"] * len(COLUMNS)

    chip = any("in_chip" in row for row in result["blocks"].values())
    for block, row in sorted(result["blocks"].items()):
        if "in_chip" in row:
            inside = row["in_chip"]
            shown = [str(inside[c]) for c in ("cells", "ff", "block_ram", "multipliers")]
            yield [block, *figures(row.get("isolated")), str(row["instances"]), *shown]
        else:
            yield [block, *figures(row.get("isolated")), *(["-"] * 5 if chip else [])]


def heads(result):
    inside = any("in_chip" in row for row in result["blocks"].values())
    return ["block", *HEADS] + (["in chip", "cells", "FF", "block RAM", "MULT18X18D"]
                                if inside else [])


def text_table(head, lines):
    widths = [max(len(line[n]) for line in [head, *lines]) for n in range(len(head))]
    for line in [head, *lines]:
        yield "  ".join([line[0].ljust(widths[0])] +
                        [cell.rjust(width) for cell, width in zip(line[1:], widths[1:])])


def markdown_table(head, lines):
    yield "| " + " | ".join(head) + " |"
    yield "|---" + "|---:" * (len(head) - 1) + "|"
    for line in lines:
        yield "| " + " | ".join(line) + " |"


def paper_lines(result):
    """The paper's Table 1 beside ours: cells and memory bits."""
    blocks = result["blocks"]
    afc = blocks["control/afc"]["in_chip"]
    current = {c: round(sum(blocks[b]["in_chip"][c] for b in CURRENT_AXIS))
               for c in ("cells", "block_ram")}
    chip = result["chip"]
    rest = chip["cells"] - afc["cells"] - current["cells"]
    rest_ram = chip["block_ram"] - afc["block_ram"] - current["block_ram"]

    def line(name, paper, cells, rams):
        return [name, *(f"{figure:,}" if figure is not None else "-" for figure in paper),
                cells, rams]

    def memory(count):
        return f"{count * BLOCK_RAM_BITS:,}"

    none = (None, None)
    return [
        line("2 x adaptive fuzzy controller", PAPER["afc"], f"{afc['cells']:,}",
             memory(afc["block_ram"])),
        line("2 x current control (vector control, SVPWM, ADC, QEP)", PAPER["current"],
             f"{current['cells']:,}", memory(current["block_ram"])),
        line("registers, commands, time base, faults", none, f"{rest:,}", memory(rest_ram)),
        line("motion-control IC", (PAPER["afc"][0] + PAPER["current"][0], PAPER["current"][1]),
             f"{chip['cells']:,}", memory(chip["block_ram"])),
        line("processor (Nios II)", PAPER["processor"], "-", "-"),
        line("total", PAPER["total"], f"{chip['cells']:,}", memory(chip["block_ram"]))]


PAPER_HEADS = ["", "paper: ALUTs", "paper: bits", "ours: cells", "ours: bits"]
DIFFERENCES = [
    "An ALUT of Stratix II makes any function of 6 inputs, or two of 4; a cell of ECP5 is one "
    "lookup table of 4 inputs or one bit of a carry chain.",
    "The paper's fuzzy controllers hold rules and words in logic (0 memory bits); ours keep the "
    "rules in block memory, and use one adder and one multiplier for all 35 steps.",
    "The paper's current loops hold full tables and logs in 595,968 bits; ours a quarter of a "
    "sine. Bits are counted as whole block RAMs of 18,432, mostly empty.",
    "The paper does not list its embedded multipliers (Stratix II has 144); ours are "
    "MULT18X18D, a 24 x 24 product takes four.",
    "The paper's IC holds its processor; ours answers one over AXI4-Lite. Registers, interpolated "
    "commands, watchdog, faults, dead time and locks have no row in the paper.",
]


def chip_lines(result):
    chip, timing = result["chip"], result["timing"]
    free = chip["available"]
    yield (f"chip on {result['device']}, placed and routed: {chip['cells']} cells of "
           f"{free['cells']}, {chip['ff']} FF, {chip['block_ram']} block RAMs, "
           f"{chip['multipliers']} of {free['multipliers']} multipliers")
    yield f"fmax {timing['fmax_mhz']} MHz (seed {result['seed']}); the IC runs at {FLOOR_MHZ} MHz"
    yield f"slowest path: {timing['path']['text']}"


def axis_line(result):
    blocks = result["blocks"]
    line = f"current control of one axis: {current_axis(blocks, 'isolated')} cells alone"
    if all("in_chip" in blocks[b] for b in CURRENT_AXIS):
        line += f", {current_axis(blocks, 'in_chip')} in the chip"
    return line


def ice40_lines(result):
    row = result["ice40"]
    mapped = row["mapped"]
    yield (f"the LM628 ({row['design']}) mapped for an {row['device']}: {mapped['lut4']} LUT4, "
           f"{mapped['carry']} bits of carry chain, {mapped['ff']} FF, {mapped['block_ram']} block "
           "RAMs")
    if "fmax_mhz" in row:
        free = row["available"]
        yield (f"placed and routed: {row['cells']} of {free['cells']} logic cells, "
               f"{row['block_ram']} of {free['block_ram']} block RAMs, {row['pins']} of "
               f"{free['pins']} pins")
        yield (f"fmax {row['fmax_mhz']} MHz (seed {result['seed']}); the part runs at "
               f"{ICE40_FLOOR_MHZ} MHz")


def text(result):
    yield from text_table(heads(result), list(rows(result)))
    if CURRENT_AXIS.keys() <= result["blocks"].keys():
        yield axis_line(result)
    if "ice40" in result:
        yield ""
        yield from ice40_lines(result)
    if "timing" in result:
        yield ""
        yield from chip_lines(result)
        yield ""
        yield from text_table(["the paper's Table 1", *PAPER_HEADS[1:]], paper_lines(result))
        yield from DIFFERENCES
    tools = result["tools"]
    yield ""
    yield ", ".join(f"{tool} {version}" for tool, version in tools.items())


def sections(result):
    """Name -> text of the generated parts of docs/synthesis.md."""
    tools = result["tools"]
    chip = [f"* {line[0].upper()}{line[1:]}." for line in [*chip_lines(result), axis_line(result)]]
    chip.append(f"* Yosys {tools['yosys']}, nextpnr-ecp5 {tools['nextpnr-ecp5']}; target of the "
                f"placer {synth_flow.ECP5.target_mhz} MHz.")
    ice40 = [f"* {line[0].upper()}{line[1:]}." for line in ice40_lines(result)]
    ice40.append(f"* Yosys {tools['yosys']}, nextpnr-ice40 {tools['nextpnr-ice40']}; target of the "
                 f"placer {synth_flow.ICE40.target_mhz} MHz.")
    return {"chip": "\n".join(chip), "ice40": "\n".join(ice40),
            "blocks": "\n".join(markdown_table(heads(result), list(rows(result)))),
            "paper": "\n".join([*markdown_table(PAPER_HEADS, paper_lines(result)), "",
                                *(f"* {line}" for line in DIFFERENCES)])}


def section(name):
    begin = f"<!-- trammel synth --docs: {name} -->"
    return re.compile(f"({re.escape(begin)}\n).*?(<!-- end -->)", re.S)


def filled(page, result):
    for name, body in sections(result).items():
        page, found = section(name).subn(lambda m, b=body: f"{m[1]}{b}\n{m[2]}", page)
        if found != 1:
            raise ValueError(f"no section '{name}'")
    return page


def stale(page, result):
    """Blocks whose cells in the page's table are more than 5 % off: an edit may cost a little."""
    table = section("blocks").search(page)
    shown = dict(re.findall(r"^\| (\w+/\w+) \| (\d+) \|", table[0] if table else "", re.M))
    for block, row in result["blocks"].items():
        if "isolated" not in row:
            continue
        cells = row["isolated"]["cells"]
        if block not in shown or abs(int(shown[block]) - cells) > max(5, 0.05 * cells):
            yield f"{block}: {cells} cells, {shown.get(block, 'nothing')} in docs/synthesis.md"
