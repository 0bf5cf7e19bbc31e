# SPDX-License-Identifier: Apache-2.0
"""What trammel synth says: tables, the critical path in words, a comparison, the budget."""

import re

from trammel_tools.synth import synth_flow

COLUMNS = ("cells", "lut4", "carry", "ff", "block_ram", "multipliers")
HEADS = ("cells", "LUT4", "carry", "FF", "block RAM", "MULT18X18D")
BLOCK_RAM_BITS = 18432  # of a DP16KD, used or not


def group_cells(group, blocks, column):
    """Cells of blocks that are counted together; column: isolated (of one) or in_chip (of all)."""
    cells = 0
    for block, instances in group["blocks"].items():
        row = blocks[block]
        share = 1 if column == "isolated" else 1 / row["instances"]
        cells += row[column]["cells"] * instances * share
    return round(cells)


def place_of(path):
    """u_chip.gen_axis[1].u_axis.u_afc -> axis 1."""
    axis = re.search(r"gen_axis\[(\d)\]", path)
    return f" of axis {'XY'[int(axis[1])]}" if axis else ""


def of_netlist(netlist, cell):
    """The mapped cell that a placed one was packed from; packing adds to its name."""
    for base in (cell, cell.rsplit("$", 1)[0], *(cell.removesuffix(end)
                                                 for end in ("_LC", "_DFFLC", "_RAM"))):
        if base in netlist.cells:
            return base
    return cell


def endpoint(netlist, cell):
    base = of_netlist(netlist, cell)
    if base not in netlist.cells:
        return {"block": "pins", "path": "", "register": base}
    register = next((sink for bit in netlist.outputs(base) for sink in netlist.sinks[bit]
                     if netlist.cells[sink]["type"].startswith("SB_DFF")), base)
    path, signal = netlist.signal(register)  # an iCE40's cell has its lookup table's name
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
            owner = netlist.cells.get(of_netlist(netlist, cell), {"type": "LUT4"})["type"]
            name = {"CCU2C": "carry_bits", "SB_CARRY": "carry_bits", "MULT18X18D": "multipliers",
                    "DP16KD": "block_rams", "SB_RAM40_4K": "block_rams"}.get(owner, "luts")
            if step["to"]["port"] == "COUT":
                name = "carry_bits"
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


def placed_findings(name, placed, speed, budget):
    """What a placed chip needs more than its limits, and whether it reaches its clock [MHz]."""
    clock, limits = budget["clock_mhz"], budget["limits"]
    if speed < clock:
        yield f"{name}: {speed} MHz, less than the {clock} MHz it runs at"
    elif speed < limits["fmax_mhz"]:
        yield f"{name}: {speed} MHz, less than the budget's {limits['fmax_mhz']}"
    for what in sorted(limits.keys() - {"fmax_mhz"}):
        if placed[what] > limits[what]:
            yield f"{name}: {placed[what]} {what}, more than {limits[what]}"


def mapped_findings(result, budget):
    """What a chip that is not placed needs more than its limits; placing adds a few cells."""
    row = result["blocks"].get(budget.get("ecp5", {}).get("design"), {}).get("in_chip", {})
    for what in ("cells", "multipliers"):
        limit = budget["ecp5"]["limits"].get(what)
        if row and limit is not None and row[what] > limit:
            yield f"chip: {row[what]} {what} as mapped, more than {limit}"


def findings(result, budget):
    """What is over the budget: lines."""
    if "timing" in result:
        yield from placed_findings("chip", result["chip"], result["timing"]["fmax_mhz"],
                                   budget["ecp5"])
    else:
        yield from mapped_findings(result, budget)
    ice40 = result.get("ice40", {})
    if "fmax_mhz" in ice40:
        yield from placed_findings(ice40["design"], ice40, ice40["fmax_mhz"],
                                   budget["ice40"])
    blocks = result["blocks"]
    for block, limit in budget.get("cells", {}).items():
        cells = blocks.get(block, {}).get("isolated", {}).get("cells", 0)
        if cells > limit:
            yield f"{block}: {cells} cells, more than {limit}"
    for block, limit in budget.get("multipliers", {}).items():
        used = blocks.get(block, {}).get("isolated", {}).get("multipliers", 0)
        if used > limit:
            yield f"{block}: {used} multipliers, more than {limit}"
    for group in groups(result, budget):
        cells = group_cells(group, blocks, "isolated")
        if cells > group["cells"]:
            yield f"{group['name']}: {cells} cells, more than {group['cells']}"


def groups(result, budget):
    """Groups of the budget whose blocks were all mapped."""
    return [g for g in budget.get("group", []) if g["blocks"].keys() <= result["blocks"].keys()]


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


def comparison_lines(result, comparison):
    """Another design's table beside ours: cells and memory bits."""
    columns = ("cells", "block_ram")

    def inside(names):
        return {c: sum(result["blocks"][b]["in_chip"][c] for b in names) for c in columns}

    named = [inside(row["blocks"]) for row in comparison["rows"] if "blocks" in row]
    beside = {block for row in comparison["rows"] for block in row.get("beside", [])}
    alone = not beside or not beside <= result["blocks"].keys()  # no processor beside the IC
    ic = result["chip"] if alone else inside([comparison["ic"]])
    whole = {"chip": result["chip"], "ic": ic,
             "rest": {c: ic[c] - sum(one[c] for one in named) for c in columns}}
    for row in comparison["rows"]:
        ours = whole.get(row.get("of"))
        if "blocks" in row or ("beside" in row and not alone):
            ours = inside(row.get("blocks", row.get("beside")))
        shown = [*row.get("theirs", (None, None)),
                 *((ours["cells"], ours["block_ram"] * BLOCK_RAM_BITS) if ours else (None, None))]
        yield [row["name"], *("-" if figure is None else f"{figure:,}" for figure in shown)]


def chip_lines(result, budget):
    chip, timing = result["chip"], result["timing"]
    free = chip["available"]
    yield (f"chip on {result['device']}, placed and routed: {chip['cells']} cells of "
           f"{free['cells']}, {chip['ff']} FF, {chip['block_ram']} block RAMs, "
           f"{chip['multipliers']} of {free['multipliers']} multipliers")
    yield (f"fmax {timing['fmax_mhz']} MHz (seed {result['seed']}); the IC runs at "
           f"{budget['ecp5']['clock_mhz']} MHz")
    yield f"slowest path: {timing['path']['text']}"


def group_lines(result, budget):
    blocks = result["blocks"]
    for group in groups(result, budget):
        line = f"{group['name']}: {group_cells(group, blocks, 'isolated')} cells alone"
        if all("in_chip" in blocks[b] for b in group["blocks"]):
            line += f", {group_cells(group, blocks, 'in_chip')} in the chip"
        yield line


def ice40_lines(result, budget):
    row = result["ice40"]
    mapped = row["mapped"]
    name = budget["ice40"]["name"]
    yield (f"{name} ({row['design']}) mapped for an {row['device']}: {mapped['lut4']} LUT4, "
           f"{mapped['carry']} bits of carry chain, {mapped['ff']} FF, {mapped['block_ram']} block "
           "RAMs")
    if "fmax_mhz" in row:
        free = row["available"]
        yield (f"placed and routed: {row['cells']} of {free['cells']} logic cells, "
               f"{row['block_ram']} of {free['block_ram']} block RAMs, {row['pins']} of "
               f"{free['pins']} pins")
        yield (f"fmax {row['fmax_mhz']} MHz (seed {result['seed']}); the part runs at "
               f"{budget['ice40']['clock_mhz']} MHz")


def text(result, budget):
    yield from text_table(heads(result), list(rows(result)))
    yield from group_lines(result, budget)
    if "ice40" in result:
        yield ""
        yield from ice40_lines(result, budget)
    if "timing" in result:
        yield ""
        yield from chip_lines(result, budget)
        comparison = budget["comparison"]
        yield ""
        yield from text_table([comparison["title"], *comparison["heads"]],
                              list(comparison_lines(result, comparison)))
        yield from comparison["differences"]
    tools = result["tools"]
    yield ""
    yield ", ".join(f"{tool} {version}" for tool, version in tools.items())


def sections(result, budget):
    """Name -> text of the generated parts of docs/synthesis.md."""
    tools, comparison = result["tools"], budget["comparison"]
    chip = [f"* {line[0].upper()}{line[1:]}."
            for line in [*chip_lines(result, budget), *group_lines(result, budget)]]
    chip.append(f"* Yosys {tools['yosys']}, nextpnr-ecp5 {tools['nextpnr-ecp5']}; target of the "
                f"placer {synth_flow.ECP5.target_mhz} MHz.")
    ice40 = [f"* {line[0].upper()}{line[1:]}." for line in ice40_lines(result, budget)]
    ice40.append(f"* Yosys {tools['yosys']}, nextpnr-ice40 {tools['nextpnr-ice40']}; target of the "
                 f"placer {synth_flow.ICE40.target_mhz} MHz.")
    lines = list(comparison_lines(result, comparison))
    return {"chip": "\n".join(chip), "ice40": "\n".join(ice40),
            "blocks": "\n".join(markdown_table(heads(result), list(rows(result)))),
            "paper": "\n".join([*markdown_table(["", *comparison["heads"]], lines), "",
                                *(f"* {line}" for line in comparison["differences"])])}


def section(name):
    begin = f"<!-- trammel synth --docs: {name} -->"
    return re.compile(f"({re.escape(begin)}\n).*?(<!-- end -->)", re.S)


def filled(page, result, budget):
    for name, body in sections(result, budget).items():
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
