# SPDX-License-Identifier: Apache-2.0
"""A chip on a board, from its sources to a bitstream, and what that took."""

import concurrent.futures
import json
import os
import shutil
import subprocess

from trammel_tools import machines, python_tools
from trammel_tools.paths import TOOL
from trammel_tools.synth import bitstream, board, synth_flow, synth_report
from trammel_tools.synth.synth_netlist import Netlist


def mapped(wanted, folder):
    """Maps in this process, whose folder Yosys reads the random image from."""
    os.chdir(folder)
    run = synth_flow.map_to_ecp5 if wanted.family == "ecp5" else synth_flow.map_to_ice40
    run(wanted.top, folder, lambda ports: board.check(wanted, ports))


def place(wanted, folder, seed):
    """nextpnr's report; <top>.config and <top>.placed.json are in the folder."""
    shutil.copyfile(wanted.constraints, folder / wanted.constraints.name)
    kind = "--lpf" if wanted.family == "ecp5" else "--pcf"
    return synth_flow.place_and_route(
        wanted.top, folder, seed, wanted.device,
        [kind, wanted.constraints.name, "--write", f"{wanted.top}.placed.json"])


def built_firmware(wanted, folder):
    """Words of the board's own firmware, or None where it has none."""
    if not wanted.app:
        return None
    file = folder / f"{wanted.app}.hex"
    done = subprocess.run([TOOL, "firmware", "--words", wanted.app, file, "--ram",
                           str(4 * wanted.memory)], capture_output=True, text=True, check=False)
    if done.returncode == 3:
        raise python_tools.Missing(done.stderr.strip())
    if done.returncode != 0:
        raise synth_flow.FlowError(f"firmware: {(done.stdout + done.stderr).strip()}")
    return bitstream.words_of(file)


def packed(wanted, folder, firmware):
    """The bitstream, with a firmware (words) where the chip has a memory for one."""
    words, configuration = wanted.memory, None
    if words and firmware is not None:
        bitstream.put_firmware(folder, wanted.top, firmware, words)
        configuration = f"{wanted.top}.firmware.config"
    path = bitstream.pack(wanted.family, folder, wanted.top, configuration)
    return {"file": path.name, "bytes": path.stat().st_size,
            "firmware_bytes": 4 * len(firmware) if words and firmware is not None else None,
            "same_when_packed_again": bitstream.same_again(wanted.family, folder, wanted.top)}


def packed_again(wanted, folder, firmware):
    """As `packed`, of a design that was placed before in this folder."""
    if not (folder / f"{wanted.top}.config").exists():
        raise synth_flow.FlowError(f"--repack: {folder} holds no placed {wanted.top}")
    return packed(wanted, folder, firmware)


def map_board(wanted, folder):
    """Writes the mapped netlist into the folder, in a process of its own."""
    if wanted.memory:
        bitstream.write_random_image(folder, wanted.memory)
    python_tools.progress(f"mapping {wanted.top}")
    with concurrent.futures.ProcessPoolExecutor(1) as pool:
        pool.submit(mapped, wanted, folder).result()


def run(wanted, folder, seed, firmware):
    """The result as one document."""
    map_board(wanted, folder)
    netlist = Netlist(*synth_flow.read_netlist(wanted.top, folder), wanted.top)
    python_tools.progress(f"placing and routing {wanted.top}")
    report = place(wanted, folder, seed)
    python_tools.progress("packing")
    made = packed(wanted, folder, firmware)
    python_tools.progress("")
    blocks = {block: {"instances": instances, "in_chip": count.table()}
              for block, (instances, count) in netlist.by_block().items() if any(count.values())}
    used = synth_report.used if wanted.family == "ecp5" else synth_report.used_of_ice40
    return {"board": wanted.name, "design": f"chips/{wanted.chip}", "top": wanted.top,
            "device": wanted.device.name, "seed": seed, "tools": synth_flow.versions(),
            "blocks": blocks, "chip": used(report),
            "timing": synth_report.critical_path(report, netlist), "bitstream": made}


def budget_of(wanted):
    """The board's part of synth.toml, or an error that says where it belongs; and another design's
    table, or None."""
    tables = machines.tables("synth.toml")
    try:
        return tables["boards"][wanted.name][wanted.chip], tables.get("comparison")
    except KeyError as error:
        raise board.BoardError(f"no budget [boards.{wanted.name}.{wanted.chip}] in a synth.toml"
                               ) from error


def lines(result, wanted, budget):
    """What the user reads."""
    yield from synth_report.text_table(*block_table(result))
    chip, timing, made = result["chip"], result["timing"], result["bitstream"]
    free = chip["available"]
    shown = [f"{chip[what]} of {free[what]} {word}" if what in free else f"{chip[what]} {word}"
             for what, word in (("cells", "cells"), ("ff", "FF"), ("block_ram", "block RAMs"),
                                ("multipliers", "multipliers"), ("pins", "pins")) if what in chip]
    yield ""
    yield f"{wanted.chip} on {wanted.name} ({result['device']}), placed and routed: " \
          f"{', '.join(shown)}"
    yield (f"fmax {timing['fmax_mhz']} MHz (seed {result['seed']}); the board runs it at "
           f"{budget['clock_mhz']} MHz")
    yield f"slowest path: {timing['path']['text']}"
    again = "packs again to" if made["same_when_packed_again"] else "PACKS AGAIN TO OTHER THAN"
    inside = "" if made["firmware_bytes"] is None else \
        f", firmware of {made['firmware_bytes']} bytes in it"
    yield f"bitstream {made['file']}: {made['bytes']} bytes{inside}; unpacked it {again} the same"
    yield f"load it: {wanted.load} {made['file']}"


def comparison_lines(result, comparison):
    """Another design's table beside ours, where it has one for this chip."""
    if comparison and comparison["ic"] in result["blocks"]:
        yield ""
        yield from synth_report.text_table([comparison["title"], *comparison["heads"]],
                                           list(synth_report.comparison_lines(result, comparison)))


def section(result, wanted, budget, comparison):
    """The generated part of docs/synthesis.md."""
    summary = [line for line in lines(result, wanted, budget) if line][len(block_table(result)[1])
                                                                       + 1:]
    text = [f"* {line[0].upper()}{line[1:]}." for line in summary[:-1]]
    text += ["", *synth_report.markdown_table(*block_table(result))]
    if comparison and comparison["ic"] in result["blocks"]:
        text += ["", *synth_report.markdown_table(
            ["", *comparison["heads"]], list(synth_report.comparison_lines(result, comparison)))]
    return "\n".join(text)


def fill(page, result, wanted, budget, comparison):
    """The page with this board's section."""
    name = f"board {wanted.name}"
    body = section(result, wanted, budget, comparison)
    filled, found = synth_report.section(name).subn(lambda m: f"{m[1]}{body}\n{m[2]}", page)
    if found != 1:
        raise board.BoardError(f"--docs: docs/synthesis.md has no section '{name}'")
    return filled


def block_table(result):
    """Heads and lines: what each block takes in the chip."""
    columns = ("cells", "ff", "block_ram", "multipliers")
    return (["block", "instances", "cells", "FF", "block RAM", "multipliers"],
            [[block, str(row["instances"]), *(str(row["in_chip"][c]) for c in columns)]
             for block, row in sorted(result["blocks"].items())])


def findings(result, budget):
    """What is over the budget or wrong: lines."""
    found = list(synth_report.placed_findings(result["top"], result["chip"],
                                              result["timing"]["fmax_mhz"], budget))
    if not result["bitstream"]["same_when_packed_again"]:
        found.append(f"{result['top']}: the bitstream unpacks to another design")
    return found


def write(folder, result):
    text = json.dumps(result, indent=2) + "\n"
    synth_flow.write_whole(folder / "synth.json", text)
    return text
