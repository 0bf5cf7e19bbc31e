# SPDX-License-Identifier: Apache-2.0
"""The tops of the boards: each port of the IC, or of a top's core, is at the pin of its name, and
each parameter of a block has the value that the board needs.

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


# Of the tops with a PLL: MHz that it gets and makes, and what holds the IC until it has locked.
PLLS = {"kung_soc_ecp5": (25, 50, "reset_q <= {reset_q[2:0], !locked || reset_i};"),
        "lm628_icebreaker": (12, 19.875, "reset_n = btn_n_i && reset_n_i && locked;")}

# Outputs of the tops that are no port of the IC.
DRIVEN = {
    "kung_soc_ulx3s": {"wifi_gpio0_o": "1'b1"},  # low would reset the board
    "kung_soc_colorlight_i5": {"led_n_o": "status[1:0] == '0"},
    "lm628_icebreaker": {"pwm_mag_o": "magnitude && ready_q", "pwm_sign_o": "sign && ready_q",
                         "driver_en_o": "ready_q", "led_red_n_o": "ready_q",
                         "led_green_n_o": "!pwm_mag_o"},
}

# Parameters that a top gives to blocks of ours; its own ones go on by their names.
PARAMETERS = {
    "kung_soc_ecp5": {"kung_soc": {"Image": '"image.hex"'}},
    "larson_ice40_up5k": {"step_table": {"Inc": "1", "Mod": "50"}},  # 12 MHz to 240 kHz
    "lm628_dip28": {"lm628": {"Inc": "Inc"}, "lm628_pins": {"Variant": "Variant"}},
    "lm628_ice40_up5k": {"lm628": {"Inc": "10"}},
    "lm628_icebreaker": {"lm628": {"Inc": "10"}},
}


def made(text, mhz):
    """MHz that the PLL of a source makes."""
    value = {name: int(digits) for name, digits in
             re.findall(r"\.(\w+) *\((?:\d+'d)?(\d+)\)", text)}
    if "EHXPLLL" in text:  # CLKOP feeds back
        return mhz / value["CLKI_DIV"] * value["CLKFB_DIV"] * value["CLKOP_DIV"] / \
            value["CLKOS_DIV"]
    return mhz * (value["DIVF"] + 1) / (value["DIVR"] + 1) / 2 ** value["DIVQ"]


def tops():
    return sorted(path for path in ROOT.glob("rtl/boards/*/*.sv")
                  if path.parent.name != "cells")  # the vendors'


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


def beside(text, chip):
    """Blocks of ours in a top beside its IC: {module: pairs of a port and what is at it}."""
    found = {}
    for name, body in re.findall(r"^  (\w+)(?: #\([^;]*?\n  \))? u_\w+ \((.*?)\n  \);", text,
                                 re.M | re.S):
        if name != chip and any(ROOT.glob(f"rtl/*/{name}.sv")):
            found[name] = re.findall(r"\.(\w+) *\((.*?)\)(?:,|$)", body, re.M)
    return found


def parameters(text):
    """Parameters of the blocks of ours in a source: {module: {name: what is given}}."""
    return {module: dict(re.findall(r"\.(\w+) *\((.*?)\)(?:,|$)", body, re.M))
            for module, body in re.findall(r"^  (\w+) #\(([^;]*?)\n  \) u_\w+ \(", text, re.M)
            if any(ROOT.glob(f"rtl/*/{module}.sv"))}


def faults(top, chip_ports, given, pins, block=None):
    """One line for each port that is not where it should be, of the IC or of a block beside it."""
    others = OTHERS.get(top, {})
    others = others.get(block, {}) if block else others
    found = []
    for port, direction in chip_ports.items():
        at = [what for name, what in given if name == port]
        wanted = others.get(port, port)
        if at != [wanted]:
            found.append(f"{top}: port {port} of {block or 'the IC'} is at "
                         f"{' and '.join(at) or 'nothing'}, wanted {wanted}")
        elif port not in others and pins.get(port) != direction:
            found.append(f"{top}: pin {port} is {pins.get(port, 'not there')}, wanted {direction}")
    return found


class BoardTopsTest(unittest.TestCase):
    def test_each_port_of_the_ic_is_at_the_pin_of_its_name(self):
        self.assertEqual({path.stem for path in tops()}, set(OTHERS), "tables in tests/boards")
        for path in tops():
            text = path.read_text()
            chip, given = connections(text)
            source, = [*ROOT.glob(f"rtl/*/{chip}.sv"), *ROOT.glob(f"rtl/boards/*/{chip}.sv")]
            ports = module(source.read_text())
            self.assertGreater(len(ports), 14, chip)
            self.assertEqual(faults(path.stem, ports, given, module(text)), [])

    def test_each_port_of_a_block_beside_the_ic_is_where_its_table_says(self):
        tables = {(top, name) for top, others in OTHERS.items()
                  for name, what in others.items() if isinstance(what, dict)}
        found = set()
        for path in tops():
            text = path.read_text()
            for name, given in beside(text, connections(text)[0]).items():
                source, = ROOT.glob(f"rtl/*/{name}.sv")
                found.add((path.stem, name))
                self.assertEqual(faults(path.stem, module(source.read_text()), given,
                                        module(text), name), [])
        self.assertEqual(found, tables)

    def test_each_parameter_of_a_block_is_given_as_its_board_needs_it(self):
        for path in tops():
            text = path.read_text()
            found = parameters(text)
            self.assertEqual(found, PARAMETERS.get(path.stem, {}), path.stem)
            own = set(re.findall(r"^    parameter .*?(\w+) =", text, re.M))
            given = {what for table in found.values() for what in table.values()}
            self.assertEqual(own - given, set(), f"parameters of {path.stem} that no block has")
        self.assertLessEqual(set(PARAMETERS), {path.stem for path in tops()})

    def test_a_pll_makes_the_clock_of_its_ic_and_holds_it_until_it_has_locked(self):
        found = {}
        for path in tops():
            text = path.read_text()
            if re.search(r"^  \w*PLL\w* #", text, re.M):
                gets, _, holds = PLLS[path.stem]
                found[path.stem] = (gets, made(text, gets), holds if holds in text else None)
        self.assertEqual(found, PLLS)

    def test_an_output_beside_the_ic_is_what_it_must_be(self):
        found = {}
        for path in tops():
            text = path.read_text()
            _, given = connections(text)
            used = {what for _, what in given}
            used |= {what for what in OTHERS[path.stem].values() if isinstance(what, str)}
            alone = {pin for pin, direction in module(text).items()
                     if direction == "output" and pin not in used}
            assigned = {pin: " ".join(what.split()) for pin, what in
                        re.findall(r"^  assign (\w+) *= (.*?);", text, re.M | re.S)}
            if alone & set(assigned):
                found[path.stem] = {pin: assigned[pin] for pin in alone & set(assigned)}
        self.assertEqual(found, DRIVEN)

    def test_pins_exchanged_or_left_open_are_told(self):
        ports = {"a_i": "input", "b_o": "output", "c_o": "output"}
        given = [("a_i", "a_i"), ("b_o", "{b_o[0], b_o[1]}")]
        self.assertEqual(faults("top", ports, given, {"a_i": "output", "b_o": "output"}), [
            "top: pin a_i is output, wanted input",
            "top: port b_o of the IC is at {b_o[0], b_o[1]}, wanted b_o",
            "top: port c_o of the IC is at nothing, wanted c_o"])
