# SPDX-License-Identifier: Apache-2.0
"""The tops of the boards: each port of the IC, or of a top's core, is at the pin of its name.

Where two pins carry the same signal, as the chip selects of both axes of kung_xy, no simulation
tells them apart; what the source says does.
"""

import re
import tomllib
import unittest

from trammel_tools.paths import ROOT

# tests/boards/<top>.toml: what stands at a port that has no pin of its name.
OTHERS = {path.stem: tomllib.loads(path.read_text(encoding="utf-8"))
          for path in (ROOT / "tests" / "boards").glob("*.toml")}


def module(text):
    """The ports of a module by their directions."""
    head = text[:text.index("\n);")]
    return {name: direction for direction, name in
            re.findall(r"^ +(input|output|inout) .*?(\w+),?(?: *//.*)?$", head, re.M)}


def connections(text):
    """The name of the IC, and pairs of a port and what is at it, as often as they are given."""
    chip, body = re.search(r"^  (\w+)(?: #\([^;]*?\n  \))? u_(?:chip|soc|table) \((.*?)\n  \);",
                           text, re.M | re.S).groups()
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
        self.assertEqual({path.stem for path in tops}, set(OTHERS), "tables in tests/boards")
        for path in tops:
            text = path.read_text()
            chip, given = connections(text)
            source, = [*ROOT.glob(f"rtl/*/{chip}.sv"), *ROOT.glob(f"rtl/boards/*/{chip}.sv")]
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
