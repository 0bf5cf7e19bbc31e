# SPDX-License-Identifier: Apache-2.0
"""The table of sines in the RTL is the quarter wave, and what the generator writes."""

import math
import re

from scratch import Scratch, call
from trammel_tools.generate import gen_sine
from trammel_tools.paths import RTL

TABLE = RTL / "math" / "sine_pkg.sv"


class GenSineTest(Scratch):
    def test_the_table_is_a_quarter_of_a_sine(self):
        values = [int(word) for word in re.findall(r"12'd(\d+)", TABLE.read_text("utf-8"))]
        self.assertEqual(values, [round(2048 * math.sin(2 * math.pi * k / 1024))
                                  for k in range(256)])

    def test_the_generator_writes_this_table(self):
        target = self.folder / "sine_pkg.sv"
        self.patch(gen_sine, TARGET=target)
        self.assertEqual(call(gen_sine.main)[0], 0)
        self.assertEqual(target.read_bytes(), TABLE.read_bytes())
