# SPDX-License-Identifier: Apache-2.0
"""Rules for the pins of a board, before place and route."""

import dataclasses
import re
import tempfile
import unittest
from pathlib import Path

from trammel_tools.paths import ROOT
from trammel_tools.synth import board, board_picture

PORTS = {"clk_i": {"direction": "input", "bits": [2]},
         "gate_o": {"direction": "output", "bits": [3, 4]},
         "enc_i": {"direction": "input", "bits": [5], "offset": 1},
         "led_o": {"direction": "output", "bits": [6]}}
LPF = """# pins
LOCATE COMP "clk_i" SITE "G2";
IOBUF PORT "clk_i" IO_TYPE=LVCMOS33 PULLMODE=NONE;
FREQUENCY PORT "clk_i" 25 MHZ;
LOCATE COMP "gate_o[0]" SITE "A1";  # J1
IOBUF PORT "gate_o[0]" IO_TYPE=LVCMOS33 PULLMODE=DOWN DRIVE=8;
LOCATE COMP "gate_o[1]" SITE "A2";
IOBUF PORT "gate_o[1]" IO_TYPE=LVCMOS33 PULLMODE=DOWN;
LOCATE COMP "enc_i[1]" SITE "A3";
IOBUF PORT "enc_i[1]" IO_TYPE=LVCMOS33 PULLMODE=UP;
LOCATE COMP "led_o" SITE "A4";
IOBUF PORT "led_o" IO_TYPE=LVCMOS33 PULLMODE=NONE;
"""
TABLE = {"family": "ecp5", "clocks": {"clk_i": 25}, "pulled_down": ["gate_o"],
         "shared_sites": ["U18"]}

# Group of the floor plan: instances of kung_soc_ecp5 that belong to it.
AXIS = "u_soc.u_ic.gen_axis[{}].u_axis"
FLOOR = {
    "processor, memory, console": ["u_soc.u_host", "u_soc.u_host.u_cpu.u_core",
                                   "u_soc.u_host.u_ram", "u_soc.u_host.u_uart"],
    "registers": ["u_soc.u_ic.u_regs"],
    "precision controller": ["u_soc.u_ic.u_precision", "u_soc.u_ic.u_precision.u_precision.u_knots",
                             "u_soc.u_ic.u_precision.gen_edge[1].u_edge_time"],
    "time base, faults, bus": ["u_soc.u_ic", "u_soc.u_ic.u_timebase.u_phase",
                               "u_soc.u_ic.u_supervisor", "u_soc.u_ic.u_watchdog",
                               "u_soc.u_master", ""],
    **{f"{what} {name}": [AXIS.format(n) + inside for inside in insides]
       for n, name in enumerate("XY") for what, insides in {
           "position controller": [".u_afc", ".u_afc.u_rules"],
           "current controller": [".u_current_loop", ".u_current_loop.u_pi_d"],
           "encoder, command, gates": ["", ".u_qep", ".u_command", ".u_adc", ".u_pwm",
                                       ".gen_leg[2].u_leg.u_dead_time"]}.items()},
}

# What a board.toml says of its board, but for clocks, sites and pulls, which the pins are held to.
ECP5 = {"family": "ecp5", "chips": ["kung_soc"], "memory": {"kung_soc": 16384},
        "pulled_down": ["gate_hi_o", "gate_lo_o", "driver_en_o"]}
FACTS = {
    "ulx3s": {**ECP5, "device": "LFE5U-{size}F CABGA381", "sizes": [12, 25, 45, 85],
              "placer": ["--package", "CABGA381", "--speed", "6"],
              "load": "openFPGALoader --board ulx3s",
              "shared_sites": ["F4", "E3", "G3", "F3", "H4", "G5",  # GP, GN 11 to 13: ESP32
                               "U18", "U17", "N17", "P16", "N16", "M17", "L16", "L17"]},  # 14 to 17
    "colorlight_i5": {**ECP5, "device": "LFE5U-25F CABGA381",
                      "placer": ["--25k", "--package", "CABGA381", "--speed", "6"],
                      "load": "openFPGALoader --board colorlight-i5"},
    "icebreaker": {"family": "ice40", "device": "iCE40UP5K SG48", "chips": ["lm628"],
                   "placer": ["--up5k", "--package", "sg48"], "target_mhz": 20,
                   "load": "openFPGALoader --board ice40_generic"},
}


class BoardTest(unittest.TestCase):
    def findings(self, old="", new="", ports=PORTS, **table):
        on = board.Board("b", "c", None, {**TABLE, **table})
        self.assertIn(old, LPF)
        with tempfile.NamedTemporaryFile("w", dir=ROOT, suffix=".lpf") as file:
            file.write(LPF.replace(old, new, 1) if old else LPF)
            file.flush()
            return list(board.findings(on, ports, board.read_lpf(Path(file.name))))

    def test_pins_as_they_must_be(self):
        self.assertEqual(self.findings(), [])

    def test_each_rule_is_told(self):
        for old, new, told in (
                ('LOCATE COMP "led_o" SITE "A4";\n', "", "led_o: no site (LOCATE, set_io)"),
                ('IOBUF PORT "led_o" IO_TYPE=LVCMOS33 PULLMODE=NONE;', "",
                 "led_o: no voltage (IOBUF with IO_TYPE)"),
                ("IO_TYPE=LVCMOS33 PULLMODE=NONE;\nFREQUENCY", "IO_TYPE=LVCMOS33;\nFREQUENCY",
                 "clk_i: no pull (PULLMODE)"),
                ("PULLMODE=DOWN;", "PULLMODE=UP;",
                 "gate_o[1]: must be pulled down, is UP: a driver would see it float"),
                ("PULLMODE=UP", "PULLMODE=NONE", "enc_i[1]: must have PULLMODE UP, has NONE"),
                ('FREQUENCY PORT "clk_i" 25 MHZ;', "", "clk_i: a clock without FREQUENCY"),
                ("25 MHZ", "50 MHZ", "clk_i: 50 MHz, on the board are 25"),
                ('SITE "A2"', 'SITE "U18"',
                 "gate_o[1]: U18 is shared with another chip on the board"),
                ('SITE "A4"', 'SITE "A3"', "led_o: site A3 is that of enc_i[1]"),
                ('# pins', 'LOCATE COMP "old_i" SITE "B9";', "old_i: the top has no such port")):
            with self.subTest(told):
                self.assertIn(told, self.findings(old, new))

    def test_a_pin_is_where_the_connector_has_it(self):
        sites = {"J1": "A1"}
        self.assertEqual(self.findings(sites=sites), [])
        self.assertIn("gate_o[0]: J1 is at site A1, not A9",
                      self.findings('SITE "A1"', 'SITE "A9"', sites=sites))
        self.assertIn("gate_o[0]: no connector of board.toml has J2",
                      self.findings("# J1", "# J2", sites=sites))

    def test_inputs_with_a_circuit_have_their_own_pull(self):
        self.assertEqual(self.findings(pulls={"enc_i": "DOWN"}),
                         ["enc_i[1]: must have PULLMODE DOWN, has UP"])
        self.assertEqual(self.findings("PULLMODE=UP", "PULLMODE=DOWN", pulls={"enc_i": "DOWN"}),
                         [])

    def test_a_pin_that_is_driven_both_ways_has_the_pull_of_an_input(self):
        for direction, wrong in (("inout", ["enc_i[1]: must have PULLMODE UP, has NONE"]),
                                 ("output", [])):
            ports = {**PORTS, "enc_i": {**PORTS["enc_i"], "direction": direction}}
            with self.subTest(direction):
                self.assertEqual(self.findings(ports=ports), [])
                self.assertEqual(self.findings("PULLMODE=UP", "PULLMODE=NONE", ports), wrong)

    def test_a_line_that_is_not_understood_is_refused(self):
        for old, new in (("# pins", "BLOCK RESETPATHS;"), ('SITE "A1"', 'SITE "A1" x'),
                         ("25 MHZ", "x MHZ")):
            with self.assertRaisesRegex(board.BoardError, r"^tmp\w+\.lpf:\d+: "):
                self.findings(old, new)

    def test_a_site_twice_for_one_port_is_refused(self):
        with self.assertRaisesRegex(board.BoardError, "led_o has a site already"):
            self.findings("# pins", 'LOCATE COMP "led_o" SITE "B9";')

    def test_an_ice40_has_pins_in_a_pcf(self):
        with tempfile.NamedTemporaryFile("w", dir=ROOT, suffix=".pcf") as file:
            file.write("set_io -pullup yes enc_i[1] 4  # 1A\nset_io led_o 5\n"
                       "set_frequency clk_i 12\n")
            file.flush()
            pins = board.read_pcf(Path(file.name))
        self.assertEqual((pins["enc_i[1]"].site, pins["enc_i[1]"].pull), ("4", "UP"))
        self.assertEqual((pins["led_o"].pull, pins["clk_i"].mhz), ("NONE", 12))

    def test_every_board_has_its_files(self):
        for name in board.names():
            for chip in board.find(name).table["chips"]:
                on = board.find(name, chip)
                for path in (on.constraints, on.folder / f"{on.top}.sv", on.folder / "README.md"):
                    self.assertTrue(path.exists(), path)
        with self.assertRaisesRegex(board.BoardError, "there are "):
            board.find("none")

    def test_the_pins_of_every_board_are_as_they_must_be(self):
        for name in board.names():
            for chip in board.find(name).table["chips"]:
                on = board.find(name, chip)
                text = (on.folder / f"{on.top}.sv").read_text(encoding="utf-8")
                ports = {}
                for way, width, port in re.findall(
                        r"^\s*(input|output|inout)\s+(?:logic|wire)\s*(?:\[\s*(\d+):0\])?\s*(\w+)",
                        text, re.M):
                    ports[port] = {"direction": way, "bits": [*range(int(width or 0) + 1)]}
                read = board.read_lpf if on.family == "ecp5" else board.read_pcf
                self.assertEqual(list(board.findings(on, ports, read(on.constraints))), [], name)

    def test_a_board_is_described_as_it_is(self):
        self.assertEqual(set(board.names()), set(FACTS))
        for name, facts in FACTS.items():
            table = board.find(name).table
            beside = {"clocks", "sites", "pulls", "firmware"}
            self.assertEqual(set(table) - beside, set(facts), name)
            for key, value in facts.items():
                with self.subTest(board=name, key=key):
                    self.assertEqual(table[key], value)
            readme = (board.FOLDER / name / "README.md").read_text(encoding="utf-8")
            loads = re.findall(r"(openFPGALoader .*) out/", readme)
            self.assertEqual(loads, [facts["load"]] * len(loads), name)
            for chip, words in facts.get("memory", {}).items():
                self.assertEqual(table["firmware"], {chip: chip.removesuffix("_soc")}, name)
                source = (ROOT / "rtl" / "chips" / f"{chip}.sv").read_text(encoding="utf-8")
                self.assertEqual(re.findall(r"parameter .* Words = (\d+)", source), [str(words)])

    def test_all_pins_of_the_ecp5_boards_have_3_3_volts(self):
        for name in ("ulx3s", "colorlight_i5"):
            on = board.find(name)
            for port, pin in board.read_lpf(on.constraints).items():
                self.assertEqual(pin.io_type, "LVCMOS33", f"{name}: {port}")

    def test_a_stale_picture_says_what_changed(self):
        was = board_picture.connectors(board.find("icebreaker"))
        now = was.replace(">pwm_mag_o<", ">pwm_sign_o<", 1)
        self.assertEqual(board_picture.changed(was, now), "pwm_mag_o became pwm_sign_o")
        self.assertEqual(board_picture.changed("", now), "nothing became Pmod 1A")
        self.assertEqual(board_picture.changed(was, was + " "), "a shape or colour changed")

    def test_an_instance_has_the_group_of_the_floor_plan_that_is_named_after_it(self):
        groups = board_picture.groups_of_plans()
        used = set()
        for name, paths in FLOOR.items():
            for path in paths:
                with self.subTest(path):
                    found = groups[board_picture.group_of(path, groups)]
                    self.assertEqual(found["name"], name)
                    used.add(found["name"])
        self.assertEqual({group["name"] for group in groups}, used)
        colours = [group["colour"] for group in groups]
        self.assertEqual(len(set(colours)), len(colours), colours)

    def test_the_pins_of_a_board_are_read(self):
        on = board.find("icebreaker")
        changed = dataclasses.replace(on, table={**on.table, "clocks": {"clk_12mhz_i": 13}})
        ports = {"clk_12mhz_i": {"direction": "input", "bits": [2]}}
        self.assertIn("clk_12mhz_i: 12 MHz, on the board are 13",
                      list(board.findings(changed, ports, board.read_pcf(on.constraints))))
