# SPDX-License-Identifier: Apache-2.0
"""A placed netlist as Verilog: tables as expressions, memories by what a configuration holds. A
placement on record holds for the netlist, tools and device that it was made of.
"""

import copy
import itertools
import json
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from trammel_tools.synth import board, placed, placed_record, synth_board, synth_flow, synth_report


def cell(kind, parameters, **pins):
    outputs = {"F", "Q", "O", "OFX", "FCO"}
    return {"type": kind, "parameters": parameters,
            "port_directions": {p: "output" if p in outputs else "input" for p in pins},
            "connections": {p: [bit] for p, bit in pins.items()}}


def evaluated(text, values):
    """The value of an expression, innermost brackets first."""
    for pin, value in values.items():
        text = text.replace("{" + pin + "}", str(value))
    text = text.replace("1'b", "").replace("~0", "1").replace("~1", "0")

    def value_of(found):
        first, operator, *more = found[1].split()
        numbers = [int(first), *(int(word) for word in more if word.isdigit())]
        if operator == "?":
            return str(numbers[1] if numbers[0] else numbers[2])
        return str({"&": min, "|": max, "^": lambda a: a[0] ^ a[1]}[operator](numbers))

    while "(" in text:
        text = re.sub(r"\(([^()]*)\)", value_of, text)
    return int(text)


class PlacedTest(unittest.TestCase):
    def design(self, cells, ports):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "top.placed.json"
            path.write_text(json.dumps({"modules": {"top": {"cells": cells, "ports": ports}}}),
                            encoding="utf-8")
            return placed.Placed(path, "top")

    def test_an_expression_has_the_values_of_its_table(self):
        for bits in ("0110" * 4, "0001" * 4, "0" * 16, "1" * 16, "1000000000000000",
                     "0111111111111111", "0" * 8 + "1" * 8, "0010111011010001", "1101000100011110"):
            text = placed.shortest(bits)
            for n, values in enumerate(itertools.product((0, 1), repeat=4)):
                d, c, b, a = values
                found = evaluated(text, {"A": a, "B": b, "C": c, "D": d})
                self.assertEqual(found, int(bits[n]), (bits, text, values))

    def test_short_forms(self):
        for bits, text in (("01" * 8, "{A}"), ("0" * 16, "1'b0"), ("0001" * 4, "({B} & {A})"),
                           ("0110" * 4, "({B} ^ {A})")):
            self.assertIn(placed.shortest(bits), (text, text.replace("{B} & {A}", "{A} & {B}")
                                                  .replace("{B} ^ {A}", "{A} ^ {B}")))

    def test_a_register_behind_a_table_that_can_be_flipped(self):
        cells = {"in": cell("TRELLIS_IO", {}, B=2, O=3), "clk": cell("TRELLIS_IO", {}, B=8, O=9),
                 "out": cell("TRELLIS_IO", {}, B=4, I=5),
                 "lut": cell("TRELLIS_COMB", {"INITVAL": "01" * 8}, A=3, F=6),
                 "ff": cell("TRELLIS_FF", {"REGSET": "SET", "CEMUX": "1 "}, CLK=9, DI=6, Q=5)}
        ports = {"d_i": {"direction": "input", "bits": [2]},
                 "clk_i": {"direction": "input", "bits": [8]},
                 "q_o": {"direction": "output", "bits": [4]}}
        design = self.design(cells, ports)
        self.assertEqual(design.flips, {"lut": (1, "q_o")})
        text = design.verilog()
        for line in ("reg n5_q = 1'b1;", "always @(posedge n9) begin n5_q <= n6; end",
                     "assign q_o = n5;", "assign n3 = d_i;"):
            self.assertIn(line, text)
        self.assertRegex(text, r"assign n6 = .*flip_i\[7:4\] == \{3'd1, 1'b1\}")

    def test_what_is_not_known_is_refused(self):
        for one, told in ((cell("OSCG", {}, O=3), "OSCG is not known"),
                          (cell("TRELLIS_FF", {"CLKMUX": "INV"}, CLK=2, DI=3, Q=4), "inverted"),
                          (cell("TRELLIS_FF", {"SRMODE": "ASYNC"}, CLK=2, DI=3, Q=4), "asynch"),
                          (cell("TRELLIS_COMB", {"MODE": "X"}, A=2, F=3), "mode X")):
            with self.assertRaisesRegex(synth_flow.FlowError, told):
                self.design({"x": one}, {}).verilog()

    def test_contents_of_a_configuration(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "top.config"
            path.write_text(".tile R1\narc: a b\n\n.bram_init 3\n0aa 1ff\n001 000\n\n.tile x\n",
                            encoding="ascii")
            self.assertEqual(placed.read_contents(path), {3: (0xAA, 0x1FF, 1, 0)})


TOP = "kung_soc_ulx3s"
MODULE = {"ports": {"gate_o": {"direction": "output", "bits": [3]}},
          "cells": {"table": {"type": "LUT4", "parameters": {"INIT": "0110"},
                              "connections": {"A": [2], "Z": [3]},
                              "attributes": {"src": "/one/chip.sv:3"}}}}


def digest(module):
    with tempfile.TemporaryDirectory() as folder:
        for end in (".modules", ""):
            (Path(folder) / f"{TOP}{end}.json").write_text(
                json.dumps({"modules": {TOP: module}}), encoding="utf-8")
        return placed_record.digest(TOP, folder)


class Digest(unittest.TestCase):
    def test_names_of_source_files_are_not_in_it(self):
        other = copy.deepcopy(MODULE)
        other["cells"]["table"]["attributes"]["src"] = "/two/chip.sv:4"
        self.assertEqual(digest(MODULE), digest(other))

    def test_a_table_a_wire_and_a_port_are(self):
        for change in (lambda m: m["cells"]["table"]["parameters"].update(INIT="0111"),
                       lambda m: m["cells"]["table"]["connections"].update(A=[4]),
                       lambda m: m["ports"]["gate_o"].update(bits=[4])):
            other = copy.deepcopy(MODULE)
            change(other)
            self.assertNotEqual(digest(MODULE), digest(other))


class OnRecord(unittest.TestCase):
    """The ULX3S' record as it is, and what no longer holds of it."""

    def setUp(self):
        self.on = board.find("ulx3s", "kung_soc")
        self.record = placed_record.read(self.on)
        self.budget, self.comparison = synth_board.budget_of(self.on)
        self.page = synth_board.fill(
            "<!-- trammel synth --docs: board ulx3s -->\n<!-- end -->",
            self.record, self.on, self.budget, self.comparison)

    def said(self, record, page=None, budget=None):
        with mock.patch.object(placed_record, "read", lambda on: record), \
                mock.patch.object(placed_record, "digest", lambda *_: self.record["netlist"]), \
                mock.patch.object(synth_flow, "versions", lambda: self.record["tools"]), \
                mock.patch.object(synth_board, "budget_of",
                                  lambda on: (budget or self.budget, self.comparison)):
            return list(placed_record.findings(self.on, None, page or self.page))

    def only(self, said, words):
        self.assertEqual(len(said), 1, said)
        self.assertIn(words, said[0])

    def test_what_was_recorded_holds(self):
        self.assertEqual(self.said(self.record), [])
        section = synth_report.section("board ulx3s")
        whole = Path(placed_record.ROOT / "docs" / "synthesis.md").read_text(encoding="utf-8")
        self.assertEqual(section.search(whole)[0], self.page)

    def test_what_differs_is_told(self):
        self.only(self.said(None), "there is no rtl/boards/ulx3s/kung_soc.placed.json")
        self.only(self.said(self.record | {"netlist": "0"}), "the netlist is not the one of")
        self.only(self.said(self.record | {"tools": {"yosys": "0.1"}}), "yosys")
        self.assertIn("85F", self.said(self.record | {"device": "LFE5U-85F CABGA381"})[0])
        cells = self.record["chip"]["cells"]
        self.only(self.said(self.record, page=self.page.replace(str(cells), str(cells + 1))),
                  "docs/synthesis.md does not say")
        self.only(self.said({k: v for k, v in self.record.items() if k != "loop"}),
                  "has not run beside its RTL")
        self.only(self.said(self.record | {"loop": {"netlist": "0"}}), "has not run beside its RTL")
        budget = copy.deepcopy(self.budget)
        budget["limits"]["cells"] = 14000
        self.only(self.said(self.record, budget=budget), "cells")
