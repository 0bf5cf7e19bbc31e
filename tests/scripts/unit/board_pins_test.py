# SPDX-License-Identifier: Apache-2.0
"""Wiring of the boards, port by port: what their READMEs tell the user to connect.

Written from these and from the schematics of the boards, not generated from the pin files: whoever
moves a port changes it here too. Bits of a port stand in their order.
"""

import re
import unittest

from trammel_tools.paths import ROOT

# Port: (site and connector's pin of bit 0, of bit 1, ...)
ULX3S = {
    "gate_hi_o": "B11 GP0, A10 GP1, A9 GP2, A7 GP4, C8 GP5, C6 GP6",
    "gate_lo_o": "C11 GN0, A11 GN1, B10 GN2, A8 GN4, B8 GN5, C7 GN6",
    "driver_en_o": "B9 GP3, A6 GP7",
    "driver_fault_n_i": "C10 GN3, B6 GN7",
    "adc_cs_n_o": "H18 GP18, B15 GP22",
    "adc_sdata_a_i": "F17 GP19, B17 GP23",
    "adc_sdata_b_i": "D18 GP20, C16 GP24",
    "adc_sclk_o": "C18 GP21, D14 GP25",
    "enc_a_i": "H17 GN18, C15 GN22",
    "enc_b_i": "G18 GN19, C17 GN23",
    "enc_z_i": "E17 GN20, D16 GN24",
    "spare_i": "D17 GN21, E14 GN25",
    "clk_25mhz_i": "G2", "btn_reset_i": "R1", "ftdi_txd_i": "M1", "ftdi_rxd_o": "L4",
    "wifi_gpio0_o": "L2", "led_o": "B2, C2, C1, D2, D1, E2, E1, H3",
}
COLORLIGHT = {
    "gate_hi_o": "C17 E1, B18 E2, B20 E3, D1 F1, C1 F2, C2 F3",
    "gate_lo_o": "A18 E7, A19 E8, B19 E9, E2 F7, D2 F8, B1 F9",
    "driver_en_o": "F20 E4, E3 F4",
    "driver_fault_n_i": "D20 E10, A3 F10",
    "adc_cs_n_o": "J20 D1, D18 I1",
    "adc_sdata_a_i": "L18 D2, G5 I2",
    "adc_sdata_b_i": "M18 D3, F5 I3",
    "adc_sclk_o": "N17 D4, E5 I4",
    "enc_a_i": "G20 D7, D17 I7",
    "enc_b_i": "K20 D8, D16 I8",
    "enc_z_i": "L20 D9, E6 I9",
    "spare_i": "N18 D10, F4 I10",
    "clk_25mhz_i": "P3", "btn_reset_n_i": "K18", "uart_rx_i": "H18", "uart_tx_o": "J17",
    "led_n_o": "U16",
}
ICEBREAKER = {
    "d_io": "4 1A1, 2 1A2, 47 1A3, 45 1A4, 3 1A7, 48 1A8, 46 1A9, 44 1A10",
    "cs_n_i": "43 1B1", "rd_n_i": "38 1B2", "wr_n_i": "34 1B3", "ps_i": "31 1B4",
    "reset_n_i": "42 1B7", "hi_o": "36 1B8",
    "enc_a_i": "27 21", "enc_b_i": "25 22", "enc_idx_n_i": "21 23",
    "pwm_mag_o": "26 27", "pwm_sign_o": "23 28", "driver_en_o": "20 29",
    "clk_12mhz_i": "35", "btn_n_i": "10", "led_red_n_o": "11", "led_green_n_o": "37",
}
FILES = {"ulx3s/kung_soc_ulx3s.lpf": ULX3S,
         "colorlight_i5/kung_soc_colorlight_i5.lpf": COLORLIGHT,
         "icebreaker/lm628_icebreaker.pcf": ICEBREAKER}
LPF = re.compile(r'LOCATE COMP "([^"]+)" SITE "(\w+)";(?:  # (.*))?')
PCF = re.compile(r"set_io (?:-pullup yes )?(\S+) (\w+)(?:  # (.*))?")


def wanted(wiring):
    """{bit of a port: its site and connector's pin}"""
    pins = {}
    for port, places in wiring.items():
        bits = places.split(", ")
        for n, place in enumerate(bits):
            pins[f"{port}[{n}]" if len(bits) > 1 else port] = place
    return pins


def written(text, pattern):
    pins = {}
    for line in text.splitlines():
        if found := pattern.fullmatch(line):
            bit, site, pin = found.groups()
            pin = re.sub(r"^J\d_\d+. |^Pmod | ?pin ", "", pin or "")
            pins[bit] = f"{site} {pin}".strip()
    return pins


class BoardPinsTest(unittest.TestCase):
    def test_every_port_is_at_the_pin_that_the_readme_names(self):
        for name, wiring in FILES.items():
            path = ROOT / "rtl" / "boards" / name
            pins = written(path.read_text(encoding="utf-8"), LPF if path.suffix == ".lpf" else PCF)
            expected = wanted(wiring)
            self.assertEqual(sorted(pins), sorted(expected), name)
            for bit, place in expected.items():
                with self.subTest(file=name, port=bit):
                    self.assertEqual(pins[bit], place, f"{name}: {bit}")

    def test_the_ulx3s_readme_names_these_pins_of_its_headers(self):
        text = (ROOT / "rtl/boards/ulx3s/README.md").read_text(encoding="utf-8")
        rows = {"gate hi a, lo a": "J1 GP0, GN0 | J1 GP4, GN4",
                "gate hi b, lo b": "J1 GP1, GN1 | J1 GP5, GN5",
                "gate hi c, lo c": "J1 GP2, GN2 | J1 GP6, GN6",
                "enable": "J1 GP3 | J1 GP7", "fault": "J1 GN3 | J1 GN7",
                "encoder A, B, Z, spare": "J2 GN18, 19, 20, 21 | J2 GN22, 23, 24, 25",
                "converter CS, D0, D1, SCLK (the order of a Pmod AD1)":
                    "J2 GP18, 19, 20, 21 | J2 GP22, 23, 24, 25"}
        for row, pins in rows.items():
            self.assertIn(f"| {row} | {pins} |", text)
