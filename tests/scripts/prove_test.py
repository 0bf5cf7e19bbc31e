#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check the prover itself: what is false, unreachable, unlabelled or without control must fail.

usage: prove_test.py FOLDER      writes a block and its properties there, many times

Exit codes: 0 the prover does what it says, 1 it does not, 3 pyosys is missing (77 under CTest).
"""

import shutil
import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
import python_tools  # noqa: E402

BLOCK = """module toy (
    input  logic       clk_i,
    input  logic       rst_i,
    input  logic       up_i,
    output logic [3:0] count_o
);
  logic [3:0] count_q, twin_q;
  always_ff @(posedge clk_i) begin
    if (rst_i) count_q <= '0;
    else if (up_i) count_q <= count_q == 4'd9 ? 4'd0 : count_q + 4'd1;
    twin_q <= rst_i ? '0 : up_i ? (count_q == 4'd9 ? 4'd0 : twin_q + 4'd1) : twin_q;
  end
  assign count_o = count_q;
endmodule
"""
PROPERTIES = """module toy_props (
    input logic       clk_i,
    input logic       rst_i,
    input logic [3:0] count_o,
    input logic [3:0] twin_q
);
  logic live_q = 1'b0;
  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    if (live_q) begin
      below_ten : assert (count_o < 4'd10);
      same : assert (count_o == twin_q);
      reaches_nine : cover (count_o == 4'd9);
    end
  end
  // breaks below_ten: if (rst_i) count_q => if (rst_i && up_i) count_q
  // breaks same: up_i ? (count_q == 4'd9 => up_i ? (count_q == 4'd8
endmodule
bind toy toy_props u_toy_props (.*);
"""
COVER = "reaches_nine : cover (count_o == 4'd9);"
CONTROL = "  // breaks same: up_i ? (count_q == 4'd9 => up_i ? (count_q == 4'd8\n"
# What is changed in the properties; exit code; what the prover must say.
CASES = [
    ("nothing", "", "", 0, ["same " + 40 * " " + "proven, 1 control(s)"]),
    # Only after ten clocks, far beyond the induction; the true ones stay proven.
    ("a false promise", "same :", "no_nine : assert (count_o != 4'd9); same :", 1,
     ["no_nine: refuted", "no_nine: no negative control", "same " + 40 * " " + "proven"]),
    ("one that needs another", "count_o < 4'd10", "twin_q < 4'd10", 0, []),
    ("a false helper", "same :", "inv_nine : assert (count_o != 4'd9); same :", 1,
     ["inv_nine: refuted"]),
    ("a control that changes nothing", "4'd9 => up_i ? (count_q == 4'd8",
     "4'd9 => up_i ? (4'd9 == count_q", 1, ["same: line", "does not refute it in 100 clocks"]),
    ("a control of no text", "count_q == 4'd9 =>", "count_q == 4'd7 =>", 1, ["occurs 0 times"]),
    ("a control of a text that is there twice", "up_i ? (count_q == 4'd9 =>", "4'd9 ? 4'd0 =>", 1,
     ["occurs 2 times"]),
    ("no control", CONTROL, "", 1, ["same: no negative control"]),
    ("a control of no promise", "breaks same", "breaks some", 1, ["no promise some"]),
    ("a state that is not reached", COVER, COVER.replace("4'd9", "4'd10"), 1,
     ["reaches_nine: not reached within 100 clocks"]),
    ("an assumption", COVER, "assume (count_o < 4'd9);", 1, ["no assume"]),
    ("an assertion without a label", COVER, "assert (count_o < 4'd9);", 1, ["needs a label"]),
    ("a label twice", COVER, "same : assert (count_o < 4'd9);", 1, ["label same twice"]),
    ("a signal that is not there", "twin_q\n", "twins_q\n", 1, ["toy_props.sv:", "twin_q"]),
]


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    python_tools.need("pyosys", "prove_test")
    root = Path(sys.argv[1]).resolve()
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(SCRIPTS, root / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    layer = root / "rtl" / "math"
    layer.mkdir(parents=True)
    (layer / "toy.sv").write_text(BLOCK, encoding="ascii")
    wrong = 0
    for name, old, new, code, says in CASES:
        if old not in PROPERTIES:
            print(f"{name}: '{old}' is not in the properties")
            return 1
        text = PROPERTIES.replace(old, new, 1) if old else PROPERTIES
        (layer / "toy_props.sv").write_text(text, encoding="ascii")
        done = subprocess.run([sys.executable, root / "scripts" / "prove.py", "math/toy"],
                              capture_output=True, text=True, check=False, timeout=120)
        said = done.stdout + done.stderr
        missing = [part for part in says if part not in said]
        if done.returncode != code or missing:
            print(f"{name}: exit code {done.returncode}, not {code}, or not said: {missing}\n"
                  f"{said}")
            wrong += 1
    print(f"prover: {len(CASES)} cases, {wrong} wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
