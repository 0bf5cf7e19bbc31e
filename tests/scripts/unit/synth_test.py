# SPDX-License-Identifier: Apache-2.0
"""Which block owns a cell, what the cells cost, and what is over the budget."""

import contextlib
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from trammel_tools.synth import estimate, synth_flow, synth_netlist, synth_report
from trammel_tools.synth.synth_netlist import Count


def cell(kind, inputs=(), outputs=()):
    return {"type": kind, "connections": {"I": list(inputs), "O": list(outputs)},
            "port_directions": {"I": "input", "O": "output"}}


def module(source, ports, cells=None, names=None):
    found = {"attributes": {"src": f"rtl/{source}:1.1"}, "cells": cells or {}, "netnames": {},
             "ports": {}}
    for name, (direction, bit) in ports.items():
        found["ports"][name] = {"direction": direction, "bits": [bit]}
        found["netnames"][name] = {"bits": [bit]}
    for name, bit in (names or {}).items():
        found["netnames"][name] = {"bits": [bit]}
    return found


def instance(kind, **ports):
    return {"type": kind, "connections": {port: [bit] for port, bit in ports.items()}}


# Two registers in a row, each in a separate block; what lies between feeds the second.
MODULES = {"modules": {
    "chip": module("chips/chip.sv", {"in_i": ("input", 2), "out_o": ("output", 4)},
                   {"u_a": instance("a", d_i=2, q_o=3), "u_b": instance("b", d_i=3, q_o=4)},
                   {"middle": 3}),
    "a": module("math/a.sv", {"d_i": ("input", 2), "q_o": ("output", 3)}, names={"x_q": 3}),
    "b": module("drive/b.sv", {"d_i": ("input", 2), "q_o": ("output", 3)}, names={"y_q": 3})}}
MAPPED = {"modules": {"chip": {
    "cells": {"ff_a": cell("TRELLIS_FF", [2], [10]), "lut": cell("LUT4", [10], [20]),
              "ff_b": cell("TRELLIS_FF", [20], [30])},
    "netnames": {"u_a.x_q": {"bits": [10]}, "u_b.y_q": {"bits": [30]},
                 "hidden": {"bits": [20], "hide_name": 1}}}}}


class SynthNetlistTest(unittest.TestCase):
    def test_logic_belongs_to_the_block_it_feeds(self):
        netlist = synth_netlist.Netlist(MODULES, MAPPED, "chip")
        self.assertEqual({name: netlist.owner(name) for name in netlist.cells},
                         {"ff_a": "u_a", "lut": "u_b", "ff_b": "u_b"})
        self.assertEqual(netlist.signal("ff_a"), ("u_a", "x_q"))
        blocks = netlist.by_block()
        self.assertEqual(blocks["math/a"], (1, {"TRELLIS_FF": 1}))
        self.assertEqual(blocks["drive/b"], (1, {"TRELLIS_FF": 1, "LUT4": 1}))
        self.assertEqual(blocks["chips/chip"][1], netlist.total())

    def test_what_feeds_several_belongs_to_the_one_around_them(self):
        for scopes, around in ((["u_x.u_a", "u_x.u_b"], "u_x"), (["u_x.u_a", "u_y"], ""),
                               (["u_x.u_a"], "u_x.u_a"), (["u_x", "u_x.u_a"], "u_x"), ([], "")):
            self.assertEqual(synth_netlist.common(scopes), around)

    def test_cells_of_a_carry_chain_and_a_memory(self):
        count = Count(LUT4=5, CCU2C=3, chain=1, TRELLIS_DPR16X4=2, DP16KD=1, MULT18X18D=4,
                      TRELLIS_FF=7)
        self.assertEqual(count.table(), {"cells": 5 + 10 + 12, "lut4": 5, "carry": 10, "ff": 7,
                                         "block_ram": 1, "multipliers": 4})


class SynthReportTest(unittest.TestCase):
    BUDGET = {"cells": {"math/a": 10}, "multipliers": {"math/a": 1},
              "ecp5": {"clock_mhz": 50, "limits": {"cells": 90, "fmax_mhz": 60}},
              "group": [{"name": "a loop", "cells": 30, "blocks": {"math/a": 2, "math/b": 1}}]}

    def findings(self, **used):
        return list(synth_report.findings({"blocks": {"math/a": {"isolated": used}}}, self.BUDGET))

    def test_what_is_over_the_budget_is_told(self):
        self.assertEqual(self.findings(cells=10, multipliers=1), [])
        self.assertEqual(self.findings(cells=11, multipliers=2),
                         ["math/a: 11 cells, more than 10", "math/a: 2 multipliers, more than 1"])

    def test_a_placed_chip_is_held_to_its_clock_and_its_limits(self):
        def findings(cells, speed):
            return list(synth_report.placed_findings("chip", {"cells": cells}, speed,
                                                     self.BUDGET["ecp5"]))

        self.assertEqual(findings(90, 60), [])
        self.assertEqual(findings(91, 59),
                         ["chip: 59 MHz, less than the budget's 60",
                          "chip: 91 cells, more than 90"])
        self.assertEqual(findings(90, 49), ["chip: 49 MHz, less than the 50 MHz it runs at"])

    def test_what_a_placed_chip_uses_and_has_left_is_that_of_its_kind_of_cell(self):
        def report(*kinds):
            return {"utilization": {kind: {"used": n, "available": 100 + n}
                                    for n, kind in enumerate(kinds, 1)},
                    "fmax": {"clk": {"achieved": 12.346}}}

        self.assertEqual(
            synth_report.used(report("TRELLIS_COMB", "TRELLIS_FF", "DP16KD", "MULT18X18D")),
            {"cells": 1, "ff": 2, "block_ram": 3, "multipliers": 4,
             "available": {"cells": 101, "multipliers": 104}})
        self.assertEqual(
            synth_report.used_of_ice40(report("ICESTORM_LC", "ICESTORM_RAM", "SB_IO")),
            {"cells": 1, "block_ram": 2, "pins": 3, "fmax_mhz": 12.35,
             "available": {"cells": 101, "block_ram": 102, "pins": 103}})

    def test_blocks_of_a_group_are_counted_together(self):
        blocks = {"math/a": {"isolated": {"cells": 10}, "in_chip": {"cells": 36}, "instances": 4},
                  "math/b": {"isolated": {"cells": 11}, "in_chip": {"cells": 20}, "instances": 2}}
        result = {"blocks": blocks}
        self.assertEqual(list(synth_report.findings(result, self.BUDGET)),
                         ["a loop: 31 cells, more than 30"])
        self.assertEqual(list(synth_report.group_lines(result, self.BUDGET)),
                         ["a loop: 31 cells alone, 28 in the chip"])
        del blocks["math/b"]
        self.assertEqual(list(synth_report.group_lines(result, self.BUDGET)), [])

    def test_another_design_stands_beside_ours(self):
        result = {"chip": {"cells": 1000, "block_ram": 3},
                  "blocks": {"math/a": {"in_chip": {"cells": 300, "block_ram": 1}}}}
        rows = [{"name": "first", "theirs": [16110, 0], "blocks": ["math/a"]},
                {"name": "other", "of": "rest"}, {"name": "all", "theirs": [2, 3], "of": "chip"},
                {"name": "theirs alone", "theirs": [5, 6]}]
        self.assertEqual(list(synth_report.comparison_lines(result, {"rows": rows})), [
            ["first", "16,110", "0", "300", "18,432"], ["other", "-", "-", "700", "36,864"],
            ["all", "2", "3", "1,000", "55,296"], ["theirs alone", "5", "6", "-", "-"]])

    def test_a_processor_stands_beside_the_ic(self):
        blocks = {"chips/ic": {"in_chip": {"cells": 700, "block_ram": 2}},
                  "chips/host": {"in_chip": {"cells": 250, "block_ram": 1}},
                  "math/a": {"in_chip": {"cells": 300, "block_ram": 1}}}
        rows = [{"name": "first", "theirs": [1, 2], "blocks": ["math/a"]},
                {"name": "other", "of": "rest"}, {"name": "ic", "of": "ic"},
                {"name": "processor", "beside": ["chips/host"]}, {"name": "all", "of": "chip"}]

        def ours(blocks):
            result = {"chip": {"cells": 1000, "block_ram": 3}, "blocks": blocks}
            lines = synth_report.comparison_lines(result, {"rows": rows, "ic": "chips/ic"})
            return {line[0]: line[3] for line in lines}

        self.assertEqual(ours(blocks), {"first": "300", "other": "400", "ic": "700",
                                        "processor": "250", "all": "1,000"})
        del blocks["chips/host"]
        self.assertEqual(ours(blocks), {"first": "300", "other": "700", "ic": "1,000",
                                        "processor": "-", "all": "1,000"})

    def test_a_chip_that_is_only_mapped_is_held_to_its_cells(self):
        budget = {"ecp5": {"design": "chips/ic", "limits": {"cells": 90, "multipliers": 2}}}
        for cells, told in ((90, []), (91, ["chip: 91 cells as mapped, more than 90"])):
            result = {"blocks": {"chips/ic": {"in_chip": {"cells": cells, "multipliers": 2}}}}
            self.assertEqual(list(synth_report.mapped_findings(result, budget)), told)

    def test_a_placed_cell_is_found_by_the_name_it_was_mapped_with(self):
        class Mapped:
            cells = {"lut": {}, "x$y": {}}
        for placed, name in (("lut_LC", "lut"), ("lut$COMB", "lut"), ("x$y", "x$y"), ("z", "z")):
            self.assertEqual(synth_report.of_netlist(Mapped, placed), name)

    def test_a_row_is_a_block_alone_and_all_of_it_in_the_chip(self):
        alone = dict(zip(synth_report.COLUMNS, range(1, 7)))
        inside = dict(zip(synth_report.COLUMNS, range(11, 17)))
        blocks = {"math/b": {"isolated": alone}, "math/a": {}}
        self.assertEqual(list(synth_report.rows({"blocks": blocks})),
                         [["math/a", *"------"], ["math/b", *"123456"]])
        blocks["math/a"] = {"isolated": alone, "in_chip": inside, "instances": 2}
        self.assertEqual(list(synth_report.rows({"blocks": blocks})),
                         [["math/a", *"123456", "2", "11", "14", "15", "16"],
                          ["math/b", *"123456", *"-----"]])
        for line in synth_report.rows({"blocks": blocks}):
            self.assertEqual(len(line), len(synth_report.heads({"blocks": blocks})))

    def test_a_page_is_stale_when_a_block_is_more_than_a_twentieth_off(self):
        page = "<!-- trammel synth --docs: blocks -->\n| math/a | %d | 7 |\n<!-- end -->"
        for shown, cells, stale in ((100, 105, False), (100, 106, True), (100, 95, False),
                                    (100, 94, True), (10, 15, False), (10, 16, True),
                                    (1000, 1052, False), (1000, 1053, True)):
            blocks = {"math/a": {"isolated": {"cells": cells}}, "math/b": {}}
            told = [f"math/a: {cells} cells, {shown} in docs/synthesis.md"] if stale else []
            self.assertEqual(list(synth_report.stale(page % shown, {"blocks": blocks})), told)
        self.assertEqual(list(synth_report.stale("", {"blocks": {"math/a": {"isolated": {
            "cells": 3}}}})), ["math/a: 3 cells, nothing in docs/synthesis.md"])

    def test_the_slowest_path_is_counted_by_what_it_goes_through(self):
        def step(kind, delay, cell="x", port="F"):
            return {"type": kind, "delay": delay, "from": {"cell": cell},
                    "to": {"port": port, "cell": "ff_b"}}

        netlist = synth_netlist.Netlist(MODULES, MAPPED, "chip")
        report = {"fmax": {"$glbnet$clk": {"achieved": 61.237}}, "critical_paths": [
            {"from": "<async>", "to": "clk", "path": [step("logic", 99)]},
            {"from": "clk", "to": "clk", "path": [
                step("clk-to-q", 0.5, "ff_a"), step("routing", 1.0), step("logic", 0.25, "lut"),
                step("logic", 0.25, "lut", "COUT"), step("routing", 2.0), step("setup", 0.25)]}]}
        found = synth_report.critical_path(report, netlist)
        self.assertEqual((found["fmax_mhz"], found["clock"]), (61.24, "clk"))
        self.assertEqual(found["path"]["text"],
                         "4.2 ns from x_q of math/a to y_q of drive/b, through 1 LUTs, 1 bits of "
                         "carry chain: 0.5 ns logic, 3.0 ns routing, 0.8 ns registers")
        self.assertEqual([synth_report.place_of(f"u.gen_axis[{n}].u_axis") for n in (0, 1)],
                         [" of axis X", " of axis Y"])

    def test_an_estimate_tells_what_there_is(self):
        self.assertEqual(list(estimate.lines({"A B": {"LUT": 3, "FF": 0, "RAM": 2}})),
                         ["estimate, not placed: A B: 3 LUT, 2 RAM"])

    def test_cells_of_each_family_are_counted_by_what_they_are(self):
        types = [{"LUT1": 1, "LUT6": 2, "FDRE": 3, "FDSE": 1, "FDCE": 1, "FDPE": 1, "DSP48E1": 4,
                  "RAMB18E1": 5, "RAMB36E1": 6, "CARRY4": 7, "MUXF7": 8, "INV": 9},
                 {"MISTRAL_ALUT2": 1, "MISTRAL_ALUT6": 2, "MISTRAL_ALUT_ARITH": 3, "MISTRAL_NOT": 4,
                  "MISTRAL_FF": 5, "MISTRAL_MUL18X18": 6, "MISTRAL_M10K": 7, "MISTRAL_MLAB": 8}]
        wanted = [{"LUT": 3, "FF": 6, "DSP48": 4, "RAMB18": 5, "RAMB36": 6, "carry of 4 bits": 7},
                  {"ALUT": 10, "FF": 5, "multiplier": 6, "M10K": 7, "MLAB": 8}]

        for family, kinds, counts in zip(estimate.FAMILIES, types, wanted):
            cells = {f"{kind}{n}": {"type": kind} for kind, count in kinds.items()
                     for n in range(count)}
            said = []

            def run(command, cells=cells, said=said):
                said.append(command)
                if command.startswith("write_json "):
                    Path(command.split()[1]).write_text(
                        json.dumps({"modules": {"top": {"cells": cells}}}), encoding="utf-8")

            with tempfile.TemporaryDirectory() as folder, mock.patch.object(
                    estimate.synth_flow, "read_design",
                    lambda *_, run=run: contextlib.nullcontext((None, run))):
                self.assertEqual(estimate.one("top", folder, family), counts, family.name)
            self.assertEqual(said[0], f"{family.command} -top top")

    def test_a_result_is_not_written_through_a_link(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            victim = folder / "victim"
            victim.write_text("mine", encoding="utf-8")
            (folder / "synth.json.new").symlink_to(victim)
            synth_flow.write_whole(folder / "synth.json", "new")
            (folder / "link").symlink_to(victim)
            with self.assertRaisesRegex(synth_flow.FlowError, "not a regular file"):
                synth_flow.write_whole(folder / "link", "new")
            self.assertEqual(victim.read_text(encoding="utf-8"), "mine")
            self.assertEqual((folder / "synth.json").read_text(encoding="utf-8"), "new")

    def test_a_column_is_as_wide_as_its_widest_cell(self):
        self.assertEqual(list(synth_report.text_table(["block", "n"], [["a", "100"]])),
                         ["block    n", "a      100"])
