# SPDX-License-Identifier: Apache-2.0
"""What the proof of a board's gates is made of: the registers of a mapped netlist."""

import copy
import unittest

import gates_off

INPUTS = {"TRELLIS_FF": ("DI",), "LUT4": ("A", "B")}


def cell(kind, q, *inputs, **parameters):
    ports = {"Q": [q], **{port: [bit] for port, bit in zip(INPUTS[kind], inputs)}}
    return {"type": kind, "connections": ports, "parameters": parameters,
            "port_directions": {port: "output" if port == "Q" else "input" for port in ports}}


def netlist():
    """Gates are bits 10..15 and 20..25, enables of the drivers 30 and 31, CTRL.enable 2 and 3."""
    cells = {f"ff{bit}": cell("TRELLIS_FF", bit, bit + 100, REGSET="RESET")
             for bit in (2, 3, *range(10, 16), *range(20, 26))}
    cells["en0"], cells["en1"] = cell("LUT4", 30, 2, 50), cell("LUT4", 31, 3, 30)
    nets = {f"u_xy.u_regs.field_storage_{axis}_ctrl_enable_value": {"bits": [bit]}
            for axis, bit in (("x", 2), ("y", 3))}
    return {"cells": cells, "netnames": nets, "ports": {
        name: {"bits": list(bits)} for name, bits in (
            ("gate_hi_o", range(10, 16)), ("gate_lo_o", range(20, 26)), ("driver_en_o", (30, 31)))}}


class GatesOffTest(unittest.TestCase):
    def test_each_gate_and_driver_is_of_its_axis(self):
        enables, wires = gates_off.places(netlist())
        self.assertEqual(enables, [2, 3])
        self.assertEqual([(axis, what, bit) for axis, what, _, bit in wires], [
            *((n // 3, f"gate_hi_o[{n}]", 10 + n) for n in range(6)),
            *((n // 3, f"gate_lo_o[{n}]", 20 + n) for n in range(6)),
            (0, "driver_en_o[0]", 30), (1, "driver_en_o[1]", 31)])

    def test_a_register_that_may_be_1_is_told(self):
        for name, change, message in (
                ("ff14", {"REGSET": "SET"}, r"^gate_hi_o\[4\] is configured as 1$"),
                ("ff20", {"SRMODE": "ASYNC"}, r"^gate_lo_o\[0\] has an asynchronous reset$"),
                ("ff3", {"REGSET": "SET"}, "^CTRL.enable of y is configured as 1$")):
            found = copy.deepcopy(netlist())
            found["cells"][name]["parameters"] |= change
            with self.assertRaisesRegex(gates_off.NotProven, message):
                gates_off.places(found)
        found = netlist()
        found["ports"]["gate_hi_o"]["bits"][5] = 31
        with self.assertRaisesRegex(gates_off.NotProven, r"gate_hi_o\[5\] is driven by en1 \(LUT4"):
            gates_off.places(found)
        found["ports"]["gate_hi_o"]["bits"][5] = 99
        with self.assertRaisesRegex(gates_off.NotProven, "driven by nothing"):
            gates_off.places(found)
        found = netlist()
        del found["netnames"]["u_xy.u_regs.field_storage_y_ctrl_enable_value"]
        with self.assertRaisesRegex(gates_off.NotProven, "^0 registers .*_y_ctrl_enable"):
            gates_off.places(found)

    def test_logic_ends_at_registers_inputs_and_where_it_is_told_to(self):
        found = netlist()
        made = gates_off.drivers(found)
        cells, begin = gates_off.cone(found, made, [31], ())
        self.assertEqual((set(cells), begin), ({"en0", "en1"}, {2, 3, 50}))
        cells, begin = gates_off.cone(found, made, [31, "0"], {30})
        self.assertEqual((set(cells), begin), ({"en1"}, {3, 30}))
