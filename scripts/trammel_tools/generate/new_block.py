# SPDX-License-Identifier: Apache-2.0
"""Start a new RTL block: module, properties, page, bit-exact twin and test.

usage: scripts/tool new-block <layer>/<block>   for instance drive/soft_start

The files compile, the test passes and the promises can be proven: a flow block that passes its
input on after one clock. No list needs an entry: CMake and the scripts find a block by its folder.
"""

import re
import sys

from trammel_tools import output_file, python_tools
from trammel_tools.paths import ROOT

LAYERS = ("math", "sense", "drive", "control", "motion", "bus")

MODULE = """// SPDX-License-Identifier: Apache-2.0
//
// {title}: what it does, the equation and its source.
// Latency: 1 clock from tick_i to valid_o.
module {block}
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input word_t x_i,

    output logic  valid_o,
    output word_t y_o,
    output logic  quiescent_o
);

  logic  valid_q;
  word_t y_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      valid_q <= 1'b0;
      y_q     <= '0;
    end else begin
      valid_q <= tick_i;
      if (tick_i) y_q <= x_i;
    end
  end

  assign valid_o     = valid_q;
  assign y_o         = y_q;
  assign quiescent_o = !tick_i && !valid_q;

endmodule
"""

PAGE = """# {layer}/{block}

Purpose in one sentence.

| | |
|---|---|
| Shape | flow: `tick_i` to `valid_o` |
| Latency | 1 clock |
| Source | where the equation comes from |
| Twin | `models/exact/{layer}/{block}.hpp` |
| Properties | `{block}_props.sv` |

| port | format | meaning |
|---|---|---|
| `tick_i` | pulse | takes `x_i` |
| `x_i` | word | input |
| `valid_o` | pulse | the result is new |
| `y_o` | word | output, holds until the next `valid_o` |
| `quiescent_o` | level | idle, no tick |

    y = x
"""

PROPS = """// SPDX-License-Identifier: Apache-2.0
//
// Promises of {block} under any input.

module {block}_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic  valid_o,
    input word_t y_o
);

  logic live_q = 1'b0;
  logic asked_q, was_reset_q;
  word_t was_y_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    asked_q     <= tick_i && !rst_i;
    was_reset_q <= rst_i;
    was_y_q     <= y_o;
    if (live_q && !rst_i) begin
      one_result_per_tick : assert (valid_o == asked_q);
      holds_between_results : assert (was_reset_q || valid_o || y_o == was_y_q);
      reaches_result : cover (valid_o && y_o != '0);
    end
  end

  // breaks one_result_per_tick: valid_q <= 1'b1
  // breaks holds_between_results: y_q <= rst_i ? next : x_i

endmodule

bind {block} {block}_props u_{block}_props (.*);
"""

TWIN = """// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/{layer}/{block}.sv.
#pragma once

#include <cstdint>

namespace trammel::exact {{

struct {name} {{
  struct In {{
    std::int32_t x = 0;
  }};
  struct Out {{
    std::int32_t y = 0;
  }};

  void reset() {{}}
  Out step(const In& in) {{ return {{in.x}}; }}
}};

}}  // namespace trammel::exact
"""

TEST = """// SPDX-License-Identifier: Apache-2.0
#include <V{block}.h>

#include <catch2/catch.hpp>

#include "models/exact/{layer}/{block}.hpp"

namespace {{

void clock(V{block}& dut) {{
  dut.clk_i = 0;
  dut.eval();
  dut.clk_i = 1;
  dut.eval();
}}

}}  // namespace

TEST_CASE("{layer}/{block} agrees with its twin") {{
  V{block} dut;
  trammel::exact::{name} twin;
  dut.rst_i = 1;
  clock(dut);
  dut.rst_i = 0;
  dut.tick_i = 1;
  for (const std::int32_t x : {{0, 1, -1, 2047, -2048}}) {{
    dut.x_i = static_cast<std::uint32_t>(x) & 0xFFF;
    clock(dut);
    CHECK(dut.valid_o);
    CHECK(dut.y_o == (static_cast<std::uint32_t>(twin.step({{x}}).y) & 0xFFF));
  }}
}}
"""


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    layer, _, block = sys.argv[1].partition("/")
    if layer not in LAYERS or not re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", block):
        print(f"new-block: expects <layer>/<block_name>; layers: {', '.join(LAYERS)}",
              file=sys.stderr)
        return 2
    words = {"layer": layer, "block": block, "title": block.replace("_", " ").capitalize(),
             "name": "".join(part.capitalize() for part in block.split("_"))}
    files = {
        f"rtl/{layer}/{block}.sv": MODULE,
        f"rtl/{layer}/{block}_props.sv": PROPS,
        f"rtl/{layer}/{block}.md": PAGE,
        f"models/exact/{layer}/{block}.hpp": TWIN,
        f"tests/{layer}/{block}_test.cpp": TEST,
    }
    try:
        output_file.create(ROOT, {path: text.format(**words) for path, text in files.items()})
    except output_file.Refused as error:
        return python_tools.refuse("new-block", error)
    print("\n".join(files))
    print(f"next: write them, then ./trammel test {layer}/{block}", file=sys.stderr)
    return 0
