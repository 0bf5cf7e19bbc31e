# SPDX-License-Identifier: Apache-2.0
"""A placement on record holds for the netlist, tools and device that it was made of."""

import copy
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from trammel_tools.synth import board, placed_record, synth_board, synth_flow, synth_report

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


if __name__ == "__main__":
    unittest.main()
