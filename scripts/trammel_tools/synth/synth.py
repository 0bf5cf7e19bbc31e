# SPDX-License-Identifier: Apache-2.0
"""Synthesize for an ECP5-25F: cells per block, clock rate, slowest path, beside a paper's table.

Yosys maps every block alone and the whole IC; nextpnr places and routes the IC. The table shows
each block alone (leap inputs tied to 0, as on a board) and all its instances in the chip, where
logic between two blocks counts for the one it feeds. Chips with a budget stand there alone, as
mapped; one is also placed and routed on an iCE40 UP5K. Cells are nextpnr's: a lookup table of 4
inputs or a bit of a carry chain, on the iCE40 with its flip-flop. The result is held to the budgets
in synth.toml of each machine and part, which also name the boards.

With --board it takes one chip on a board (rtl/boards/<board>) with the board's pins, which are
checked before place and route, up to a bitstream; --firmware puts a program into the memory of a
chip with a processor, --repack does that in the design placed before, without placing it again.
--docs puts the placement on record beside the board's files; --check maps the sources again and
says whether their netlist is the one on record.

Writes synth.json, netlists, logs and the FPGAs' configurations into the output folder. It takes a
few minutes; the same sources, tools and seed give the same result.

Exit codes: 0 within the budget, 2 usage, 3 a tool is missing, 6 synthesis failed, the clock is
below what the chip runs at, something is over the budget or not as on record, 130 interrupted.
"""

import concurrent.futures
import json
import os
import sys
from pathlib import Path

from trammel_tools import machines, python_tools
from trammel_tools.paths import ROOT
from trammel_tools.rtl import lint
from trammel_tools.synth import (
    bitstream,
    board,
    estimate,
    placed_record,
    synth_board,
    synth_flow,
    synth_report,
)
from trammel_tools.synth.synth_netlist import Netlist

PAGE = ROOT / "docs" / "synthesis.md"
MAX_SEED = 2**31 - 1


def arguments():
    parser = python_tools.Parser(prog="trammel synth", description=__doc__)
    parser.add_argument("chip", nargs="?", metavar="CHIP", help="with --board: which of its chips")
    parser.add_argument("--board", metavar="NAME",
                        help=f"a chip on a board, up to a bitstream: {', '.join(board.names())}")
    parser.add_argument("--size", type=int, metavar="K", help="of the board's FPGA, as 12 or 85")
    parser.add_argument("--firmware", type=Path, metavar="FILE",
                        help="what the chip's memory holds, hexadecimal words; default: its "
                             "machine's firmware")
    parser.add_argument("--repack", action="store_true",
                        help="put the firmware into the design placed before in the folder")
    parser.add_argument("--block", metavar="LAYER/BLOCK", help="one block alone: area only")
    parser.add_argument("--area", action="store_true", help="do not place and route")
    parser.add_argument("--estimate", action="store_true",
                        help="the chip's area on other families, as estimates")
    parser.add_argument("--seed", type=int, default=1, metavar="N",
                        help=f"of the placer, 1 to {MAX_SEED}, default 1")
    parser.add_argument("--out", type=Path, default=Path("out/synth"), metavar="FOLDER",
                        help="default out/synth")
    parser.add_argument("--json", action="store_true", help="print synth.json, not the tables")
    parser.add_argument("--docs", action="store_true",
                        help="write the tables into docs/synthesis.md")
    parser.add_argument("--check", action="store_true",
                        help="fail also when docs/synthesis.md is more than 5 %% off; with "
                             "--board: map only, and fail unless the netlist is that of the "
                             "placement on record")
    wanted = parser.parse_args()
    if not 1 <= wanted.seed <= MAX_SEED:
        parser.error(f"--seed {wanted.seed}: 1 to {MAX_SEED}")
    if wanted.block is not None and wanted.block not in lint.blocks():
        parser.error(f"--block {wanted.block}: no such block; there are "
                     f"{', '.join(lint.blocks())}")
    if wanted.docs and (wanted.block or wanted.area):
        parser.error("--docs needs the whole chip, placed and routed")
    if wanted.estimate and any((wanted.block, wanted.area, wanted.docs, wanted.check)):
        parser.error("--estimate stands alone")
    if wanted.check and wanted.block:
        parser.error("--check needs all blocks")
    if wanted.board is None:
        for name in ("chip", "size", "firmware", "repack"):
            if getattr(wanted, name):
                parser.error(f"{name if name == 'chip' else '--' + name} needs --board")
    else:
        for name in ("block", "area", "estimate"):
            if getattr(wanted, name):
                parser.error(f"--{name} is not for --board")
        for name in ("docs", "firmware", "repack", "json"):
            if wanted.check and getattr(wanted, name):
                parser.error(f"--check places nothing: without --{name}")
        try:
            wanted.on = board.find(wanted.board, wanted.chip, wanted.size)
        except board.BoardError as error:
            parser.error(str(error))
        if wanted.firmware and not wanted.on.memory:
            parser.error(f"--firmware: {wanted.on.chip} has no memory for one")
    return wanted


def top_of(block):
    return block.split("/")[1]


def alone(block, folder):
    return {"isolated": Netlist(*synth_flow.read_netlist(top_of(block), folder),
                                top_of(block)).total().table()}


def on_ice40(top, folder, seed, area):
    """A part on its board: mapped and, but for its area alone, placed."""
    result = {"device": synth_flow.ICE40.name, "mapped": synth_flow.map_to_ice40(top, folder)}
    if not area:
        report = synth_flow.place_and_route(top, folder, seed, synth_flow.ICE40)
        result.update(synth_report.used_of_ice40(report))
    return result


def run(wanted, folder, budget):
    """The result as one document."""
    top, ice40_top = budget["ecp5"]["board"], budget["ice40"]["board"]
    blocks = [wanted.block] if wanted.block else [
        b for b in lint.blocks() if not b.startswith("chips/") or b in budget["cells"]]
    result = {"design": wanted.block or budget["ecp5"]["design"], "device": synth_flow.ECP5.name,
              "seed": wanted.seed, "tools": synth_flow.versions(), "blocks": {}}
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        chip = None if wanted.block else pool.submit(synth_flow.map_to_ecp5, top, folder)
        ice40 = None if wanted.block else pool.submit(
            on_ice40, ice40_top, folder, wanted.seed, wanted.area)
        jobs = {pool.submit(synth_flow.map_to_ecp5, top_of(b), folder): b for b in blocks}
        if chip:
            python_tools.progress("mapping the chip")
            concurrent.futures.wait([chip])
            netlist = Netlist(*synth_flow.read_netlist(top, folder), top)
            if not wanted.area:
                python_tools.progress("placing and routing the chip")
                report = synth_flow.place_and_route(top, folder, wanted.seed, synth_flow.ECP5)
        for done, job in enumerate(concurrent.futures.as_completed(jobs), 1):
            python_tools.progress(f"[{done}/{len(jobs)}] {jobs[job]}")
    for block in blocks:
        result["blocks"][block] = alone(block, folder)
    if chip:
        result["ice40"] = {"design": ice40_top, **ice40.result()}
        for block, (instances, count) in netlist.by_block().items():
            if not block.startswith("boards/"):
                result["blocks"].setdefault(block, {}).update(instances=instances,
                                                              in_chip=count.table())
        if not wanted.area:
            result["chip"] = synth_report.used(report)
            result["timing"] = synth_report.critical_path(report, netlist)
            result["comparison"] = {key: budget["comparison"][key] for key in ("source", "rows")}
    python_tools.progress("")
    return result


def run_estimate(wanted, folder, budget):
    """Exit code of `--estimate`."""
    top, result = budget["ecp5"]["board"], {}
    for family in estimate.FAMILIES:
        python_tools.progress(f"mapping for {family.name}")
        result[family.name] = estimate.one(top, folder, family)
    python_tools.progress("")
    document = {"design": budget["ecp5"]["design"], "estimates": result}
    print(json.dumps(document, indent=2) if wanted.json else "\n".join(estimate.lines(result)))
    return 0


def check_board(on, folder):
    """Exit code of `--board --check`."""
    synth_board.map_board(on, folder)
    python_tools.progress("")
    bad = list(placed_record.findings(on, folder, PAGE.read_text(encoding="utf-8")))
    for line in bad:
        print(f"synth: {line}", file=sys.stderr)
    if not bad:
        print(f"{on.top}: the netlist of {placed_record.path_of(on).relative_to(ROOT)}")
    return 6 if bad else 0


def run_board(wanted, folder):
    """Exit code of `--board`."""
    on = wanted.on
    if wanted.check:
        return check_board(on, folder)
    firmware = (bitstream.words_of(wanted.firmware) if wanted.firmware else
                synth_board.built_firmware(on, folder))
    if wanted.repack:
        made = synth_board.packed_again(on, folder, firmware)
        print(f"{made['file']}: {made['bytes']} bytes; load it: {on.load} {made['file']}")
        return 0
    budget, comparison = synth_board.budget_of(on)
    result = synth_board.run(on, folder, wanted.seed, firmware)
    result["over_budget"] = synth_board.findings(result, budget)
    document = synth_board.write(folder, result)
    shown = [*synth_board.lines(result, on, budget),
             *synth_board.comparison_lines(result, comparison)]
    print(document if wanted.json else "\n".join(shown), end="" if wanted.json else "\n")
    if wanted.docs:
        PAGE.write_text(synth_board.fill(PAGE.read_text(encoding="utf-8"), result, on, budget,
                                         comparison), encoding="utf-8")
        placed_record.put(on, folder, result)
        for path in (PAGE, placed_record.path_of(on)):
            print(f"wrote {path.relative_to(ROOT)}", file=sys.stderr)
    for line in result["over_budget"]:
        print(f"synth: over budget: {line}", file=sys.stderr)
    return 6 if result["over_budget"] else 0


def main():
    wanted = arguments()
    python_tools.need("pyosys", "synth")
    missing = [device.placer for device in synth_flow.DEVICES if device.program() is None]
    if wanted.board and wanted.on.memory and not lint.cores():
        missing.append(synth_flow.CORE)
    if missing and not (wanted.area or wanted.block or wanted.estimate):
        print(f"synth: {' and '.join(missing)} missing (trammel doctor)", file=sys.stderr)
        return python_tools.SKIPPED if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    folder = wanted.out.resolve()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if not (wanted.repack or wanted.estimate):
            (folder / "synth.json").unlink(missing_ok=True)
    except OSError as error:
        print(f"synth: --out {wanted.out}: not a folder for results: {error.strerror}",
              file=sys.stderr)
        return 2
    try:
        if wanted.board:
            return run_board(wanted, folder)
        budget = machines.tables("synth.toml")
        if wanted.estimate:
            return run_estimate(wanted, folder, budget)
        result = run(wanted, folder, budget)
        result["over_budget"] = list(synth_report.findings(result, budget))
        document = synth_board.write(folder, result)
    except python_tools.Missing as error:
        print(f"synth: {error}", file=sys.stderr)
        return python_tools.SKIPPED if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    except (synth_flow.FlowError, machines.MachineError, board.BoardError) as error:
        python_tools.progress("")
        print(f"synth: {error}", file=sys.stderr)
        return 6
    print(document if wanted.json else "\n".join(synth_report.text(result, budget)),
          end="" if wanted.json else "\n")
    bad = [f"over budget: {line}" for line in result["over_budget"]]
    if wanted.docs:
        PAGE.write_text(synth_report.filled(PAGE.read_text(encoding="utf-8"), result, budget),
                        encoding="utf-8")
        print(f"wrote {PAGE.relative_to(ROOT)}", file=sys.stderr)
    if wanted.check:
        bad += [f"stale, run trammel synth --docs: {line}"
                for line in synth_report.stale(PAGE.read_text(encoding="utf-8"), result)]
    for line in bad:
        print(f"synth: {line}", file=sys.stderr)
    return 6 if bad else 0
