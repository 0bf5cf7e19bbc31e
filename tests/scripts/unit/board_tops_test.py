# SPDX-License-Identifier: Apache-2.0
"""The tops of the boards: each port of the IC is at the pin of its name.

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
        "awake_o": "unused_awake", "timed_o": "unused_timed"},
    "lm628_dip28": {
        "rst_i": "1'b0", "clock_en_i": "'1", "leap_i": "'0", "wrap_i": "1'b0",
        "d_oe_o": "d_oe", "dac_o": "dac",
        "dac_hi_lo_o": "hi_lo", "dac_wr_n_o": "strobe_n", "pwm_mag_o": "magnitude",
        "pwm_sign_o": "sign", "sample_o": "sample", "next_o": "unused_next",
        "quiescent_o": "unused_chip_quiescent",
        "awake_o": "unused_awake", "timed_o": "unused_timed"},
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
    chip, body = re.search(r"^  (\w+)(?: #\(.*?\n  \))? u_chip \((.*?)\n  \);", text,
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
        tops = sorted(ROOT.glob("rtl/boards/*/*.sv"))
        self.assertEqual({path.stem for path in tops}, set(OTHERS), "the tops of OTHERS")
        for path in tops:
            text = path.read_text()
            chip, given = connections(text)
            ports = module((ROOT / "rtl" / "chips" / f"{chip}.sv").read_text())
            self.assertGreater(len(ports), 20, chip)
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
