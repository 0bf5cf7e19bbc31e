# SPDX-License-Identifier: Apache-2.0
"""The tops of the boards: each port of the IC, or of a top's core, is at the pin of its name.

Where two pins carry the same signal, as the chip selects of both axes of kung_xy, no simulation
tells them apart; what the source says does.
"""

import re
import unittest

from trammel_tools.paths import ROOT

# What stands at a port that has no pin of its name.
OTHERS = {
    "kung_xy_ecp5_25f": {
        "rst_i": "reset_q[1]", "clock_en_i": "'1", "leap_i": "'0", "tick_o": "unused_tick",
        "sample_o": "unused_sample", "next_o": "unused_next", "quiescent_o": "unused_quiescent",
        "awake_o": "unused_awake", "timed_o": "unused_timed",
        "driver_en_o": "unused_driver_en", "tripped_o": "unused_tripped"},
    "kung_soc_ecp5": {
        "clk_i": "clk", "rst_i": "reset_q[3]", "driver_fault_i": "~fault_n_i"},
    "kung_soc_ulx3s": {
        "reset_i": "btn_reset_i", "uart_rx_i": "ftdi_txd_i", "uart_tx_o": "ftdi_rxd_o",
        "fault_n_i": "driver_fault_n_i", "status_o": "led_o"},
    "kung_soc_colorlight_i5": {
        "reset_i": "!btn_reset_n_i", "fault_n_i": "driver_fault_n_i", "status_o": "status"},
    "lm628_dip28": {
        "rst_i": "1'b0", "clock_en_i": "'1", "leap_i": "'0", "wrap_i": "1'b0",
        "d_oe_o": "d_oe", "dac_o": "dac",
        "dac_hi_lo_o": "hi_lo", "dac_wr_n_o": "strobe_n", "pwm_mag_o": "magnitude",
        "pwm_sign_o": "sign", "sample_o": "sample", "next_o": "unused_next",
        "quiescent_o": "unused_chip_quiescent",
        "awake_o": "unused_awake", "timed_o": "unused_timed"},
    "lm628_icebreaker": {
        "clk_i": "clk", "rst_i": "1'b0", "clock_en_i": "'1", "leap_i": "'0", "wrap_i": "1'b0",
        "reset_n_i": "reset_n", "d_i": "d_io", "d_o": "d", "d_oe_o": "d_oe", "dac_o": "",
        "dac_hi_lo_o": "", "dac_wr_n_o": "", "pwm_mag_o": "magnitude", "pwm_sign_o": "sign",
        "sample_o": "", "next_o": "", "quiescent_o": "", "awake_o": "", "timed_o": ""},
    "lm628_ice40_up5k": {
        "rst_i": "1'b0", "clock_en_i": "'1", "leap_i": "'0", "wrap_i": "1'b0",
        "d_i": "d_io", "d_o": "d",
        "d_oe_o": "d_oe", "sample_o": "unused_sample", "next_o": "unused_next",
        "quiescent_o": "unused_quiescent",
        "awake_o": "unused_awake", "timed_o": "unused_timed"},
}


def module(text):
    """The ports of a module by their directions."""
    head = text[:text.index("\n);")]
    return {name: direction for direction, name in
            re.findall(r"^ +(input|output|inout) .*?(\w+),?(?: *//.*)?$", head, re.M)}


def connections(text):
    """The name of the IC, and pairs of a port and what is at it, as often as they are given."""
    chip, body = re.search(r"^  (\w+)(?: #\([^;]*?\n  \))? u_(?:chip|soc) \((.*?)\n  \);", text,
                           re.M | re.S).groups()
    return chip, re.findall(r"\.(\w+) *\((.*?)\)(?:,|$)", body, re.M)


def faults(top, chip_ports, given, pins):
    """One line for each port that is not where it should be."""
    others = OTHERS.get(top, {})
    found = []
    for port, direction in chip_ports.items():
        at = [what for name, what in given if name == port]
        wanted = others.get(port, port)
        if at != [wanted]:
            found.append(f"{top}: port {port} of the IC is at {' and '.join(at) or 'nothing'}, "
                         f"wanted {wanted}")
        elif port not in others and pins.get(port) != direction:
            found.append(f"{top}: pin {port} is {pins.get(port, 'not there')}, wanted {direction}")
    return found


class BoardTopsTest(unittest.TestCase):
    def test_each_port_of_the_ic_is_at_the_pin_of_its_name(self):
        tops = sorted(path for path in ROOT.glob("rtl/boards/*/*.sv")
                      if path.parent.name != "cells")  # the vendors'
        self.assertEqual({path.stem for path in tops}, set(OTHERS), "the tops of OTHERS")
        for path in tops:
            text = path.read_text()
            chip, given = connections(text)
            source, = [*ROOT.glob(f"rtl/chips/{chip}.sv"), *ROOT.glob(f"rtl/boards/*/{chip}.sv")]
            ports = module(source.read_text())
            self.assertGreater(len(ports), 14, chip)
            self.assertEqual(faults(path.stem, ports, given, module(text)), [])

    def test_pins_exchanged_or_left_open_are_told(self):
        ports = {"a_i": "input", "b_o": "output", "c_o": "output"}
        given = [("a_i", "a_i"), ("b_o", "{b_o[0], b_o[1]}")]
        self.assertEqual(faults("top", ports, given, {"a_i": "output", "b_o": "output"}), [
            "top: pin a_i is output, wanted input",
            "top: port b_o of the IC is at {b_o[0], b_o[1]}, wanted b_o",
            "top: port c_o of the IC is at nothing, wanted c_o"])


if __name__ == "__main__":
    unittest.main()
