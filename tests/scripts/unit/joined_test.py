# SPDX-License-Identifier: Apache-2.0
"""Several broken designs in one model: what each of them becomes."""

from scratch import Scratch
from trammel_tools import paths
from trammel_tools.proof import aiger, joined, leap_model, miter, seeded_bugs
from trammel_tools.proof.properties import PropertiesError

MODULE = """module toy (input logic clk_i, output logic y_o);
  logic y;
endmodule
"""
# Inputs a (2), b (4) and what readers of the cut net see (6). The sources make a && b of it, the
# changes make !a and seen && b; the output is seen && a.
MODEL = aiger.Model(3, [], [], [], [(2, 4), (4, 6), (2, 6)])
INPUTS = {"a_i[0]": 1, "b_i[0]": 2, "u_x.trammel_seen0[0]": 3}
WORDS = {"y_o": [12], "u_x.trammel_old0": [8], "u_x.trammel_new0_4": [3],
         "u_x.trammel_new0_7": [10]}
TOP = {"ports": {"a_i": {"bits": [2]}, "y_o": {"bits": [9]}, "u_x.trammel_seen0": {"bits": [5]},
                 "u_x.trammel_old0": {"bits": [6]}, "u_x.trammel_new0_4": {"bits": ["0"]},
                 "u_x.trammel_new0_7": {"bits": [5]}},
       "netnames": {"u_x.y": {"bits": [5]}},
       "cells": {"g": {"type": "$and", "connections": {"A": [5], "B": [2], "Y": [9]}}}}


class JoinedTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(paths, RTL=self.folder, ROOT=self.folder)
        self.patch(seeded_bugs, RTL=self.folder, ROOT=self.folder)
        self.path = self.write("math/toy.sv", MODULE)
        self.patch(leap_model, make=self.make, made_parts=lambda *_: (MODEL, INPUTS, WORDS, {}))
        self.patch(joined.domains, netlist=lambda _: TOP)
        self.model = joined.Joined(self.folder, "chips/toy", "joined", {
            4: seeded_bugs.parse(" stay (toy): y = !y"),
            7: seeded_bugs.parse(" stay (toy): y = y && b"),
            9: seeded_bugs.parse(" stay (toy): y <= next")}, False)

    def make(self, _, sources):
        self.source, = sources
        return ""

    def output(self, number):
        """Values of the output for a, b = 00, 10, 01, 11."""
        chip = self.model.chip(number)
        graph = miter.Graph()
        given = {1: graph.free(), 2: graph.free()}
        (literal,) = graph.copy(chip.gates, given, chip.outputs["y_o"])
        return [graph.simulate(bits)(literal) for bits in ((0, 0), (1, 0), (0, 1), (1, 1))]

    def test_changes_of_one_net_share_a_cut(self):
        text = self.source.changed[self.path]
        self.assertEqual(text.count("wire type(y) trammel_before0;"), 1)
        for line in ("trammel_value0_4 = !trammel_before0;",
                     "trammel_value0_7 = trammel_before0 && b;",
                     "trammel_value1_9 = trammel_before1;"):
            self.assertIn(line, text)
        self.assertEqual(self.source.behind, ["rewire y value 0 y load 1"])

    def test_a_design_has_its_own_change_alone(self):
        self.assertEqual(self.output(None), [0, 0, 0, 1])
        self.assertEqual(self.output(4), [0, 0, 0, 0])
        self.assertEqual(self.output(9), [0, 0, 0, 1])

    def test_a_loop_is_told(self):
        with self.assertRaisesRegex(PropertiesError, "loop"):
            self.model.chip(7)
        with self.assertRaisesRegex(PropertiesError, "its own driver"):
            self.model.netlist(7)

    def test_ports_of_cuts_are_none_of_the_chip(self):
        chip = self.model.chip(4)
        self.assertEqual((list(chip.inputs), list(chip.outputs)), (["a_i[0]", "b_i[0]"], ["y_o"]))

    def test_the_netlist_is_joined_too(self):
        for number, bit in ((None, 6), (4, "0"), (9, 6)):
            top = self.model.netlist(number)
            self.assertEqual(top["cells"]["g"]["connections"], {"A": [bit], "B": [2], "Y": [9]})
            self.assertEqual(top["netnames"]["u_x.y"]["bits"], [bit])
            self.assertEqual(list(top["ports"]), ["a_i", "y_o"])

    def test_a_register_has_the_name_of_its_net(self):
        self.assertEqual(self.model.original(9, "u_x.trammel_before0"), "u_x.y")
        self.assertEqual(self.model.original(4, "u_x.trammel_before0"), "u_x.trammel_before0")
        self.assertEqual(self.model.original(4, "u_x.y"), "u_x.y")
