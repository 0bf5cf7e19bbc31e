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

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools
from trammel_tools.paths import ROOT

BLOCK = """module toy (
    input  logic       clk_i,
    input  logic       rst_i,
    input  logic       up_i,
    output logic [3:0] count_o
);
  localparam logic [3:0] Last = 4'd9;
  logic [3:0] count_q, twin_q;
  always_ff @(posedge clk_i) begin
    if (rst_i) count_q <= '0;
    else if (up_i) count_q <= count_q == 4'd9 ? 4'd0 : count_q + 4'd1;
    twin_q <= rst_i ? '0 : up_i ? (count_q == Last ? 4'd0 : twin_q + 4'd1) : twin_q;
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
  // breaks below_ten: count_q <= rst_i && !up_i ? count_q : next
  // breaks same: twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next
endmodule
bind toy toy_props u_toy_props (.*);
"""
COVER = "reaches_nine : cover (count_o == 4'd9);"
CONTROL = "  // breaks same: twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next\n"
PROVEN = ["below_ten " + 35 * " " + "proven", "same " + 40 * " " + "proven, 1 control(s)"]
GONE = "does not apply any more"
# What is changed in the properties or the block; exit code; what the prover must say.
CASES = [
    ("nothing", "", "", 0, [*PROVEN, "2 of 2 refute their promises"]),
    # Only after ten clocks, far beyond the induction; the true ones stay proven.
    ("a false promise", "same :", "no_nine : assert (count_o != 4'd9); same :", 1,
     ["no_nine: refuted at clock 10", *PROVEN, "not asked",
      "at clock 10: count_o 9", "gtkwave build/formal/math_toy/no_nine.gtkw"]),
    ("one that needs another", "count_o < 4'd10", "twin_q < 4'd10", 0, []),
    ("a false helper", "same :", "inv_nine : assert (count_o != 4'd9); same :", 1,
     ["inv_nine: refuted"]),
    ("a broken block", "count_q == 4'd9 ? 4'd0", "count_q == 4'd11 ? 4'd0", 1,
     ["below_ten: refuted at clock", "gtkwave build/formal/math_toy/below_ten.gtkw"]),
    # An honest edit: other words of the block, the same names.
    ("a block in other words", "count_q == 4'd9 ? 4'd0 : count_q + 4'd1",
     "count_q != 4'd9 ? count_q + 4'd1 : 4'd0", 0, [*PROVEN, "2 of 2 refute"]),
    ("a control of a net", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next",
     "count_o = count_o ^ 4'd1", 0, ["2 of 2 refute"]),
    ("a control of a constant", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next",
     "Last = Last - 4'd1", 0, ["2 of 2 refute"]),
    ("a control of a text", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next",
     "count_q == Last ? 4'd0 : twin_q => count_q == 4'd8 ? 4'd0 : twin_q", 0, ["2 of 2 refute"]),
    ("a control that changes nothing", "count_q == 4'd8 ?", "count_q == 4'd9 ?", 1,
     ["same: line 17", "does not refute it in 100 clocks", "1 of 2 refute"]),
    ("a control of a net that is gone", "breaks same: twin_q", "breaks same: twins_q", 1,
     [*PROVEN, "line 17: the control", GONE, "rtl/math/toy.sv has no twins_q", "1 of 2 refute"]),
    ("a control of an input", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next", "up_i = 1'b1", 1,
     [*PROVEN, GONE, "up_i is no net with a driver"]),
    ("a control of a net as a register", "breaks same: twin_q <=", "breaks same: count_o <=", 1,
     [*PROVEN, GONE, "count_o is no register"]),
    ("a control of no text", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next",
     "count_q == 4'd7 => 1'b0", 1, [*PROVEN, GONE, "occurs 0 times"]),
    ("a control of a text that is there twice", "twin_q <= up_i && count_q == 4'd8 ? 4'd0 : next",
     "4'd0 => 4'd1", 1, [*PROVEN, GONE, "times in rtl/math/toy.sv, not once"]),
    ("a control that is no Verilog", "up_i && count_q == 4'd8", "up_i && (count_q", 1,
     [*PROVEN, "line 17", GONE, "toy.sv:", "1 of 2 refute"]),
    ("no control", CONTROL, "", 1, ["same: no negative control"]),
    ("a control of no promise", "breaks same", "breaks some", 1,
     ["same " + 40 * " " + "proven", "no promise some"]),
    ("a state that is not reached", COVER, COVER.replace("4'd9", "4'd10"), 1,
     ["reaches_nine: not reached within 100 clocks: no input from reset on leads there"]),
    ("an assumption", COVER, "assume (count_o < 4'd9);", 1, ["no assume"]),
    ("an assertion without a label", COVER, "assert (count_o < 4'd9);", 1, ["needs a label"]),
    ("a label twice", COVER, "same : assert (count_o < 4'd9);", 1, ["label same twice"]),
    ("a signal that is not there", "twin_q\n", "twins_q\n", 1, ["toy_props.sv:", "twin_q"]),
]


def waves(root):
    """What is wrong with the waves of no_nine, whose promise fails as the count reaches 9."""
    stem = root / "build" / "formal" / "math_toy" / "no_nine"
    scopes, names, values = [], {}, {}
    for line in stem.with_suffix(".vcd").read_text(encoding="ascii").splitlines():
        word = line.split()
        match word[0]:
            case "$scope":
                scopes.append(word[2])
            case "$upscope":
                scopes.pop()
            case "$var":
                names[".".join([*scopes, word[4]]) + "".join(word[5:-1])] = word[3]
            case _ if line[0] in "01":
                values.setdefault(line[1:], []).append(int(line[0]))
            case _ if line[0] == "b":
                values.setdefault(word[1], []).append(int(word[0][1:], 2))
    view = stem.with_suffix(".gtkw").read_text(encoding="ascii").splitlines()
    shown = [line for line in view if line.startswith("toy.")]
    yield from (f"the view shows {name}, which the waves lack" for name in shown
                if name not in names)
    for name in ("toy.clk_i", "toy.count_o[3:0]", "toy.up_i", "toy.u_toy_props.no_nine"):
        if name not in shown:
            yield f"the view does not show {name}"
    if values[names["toy.count_o[3:0]"]] != list(range(10)):
        yield f"count_o is {values[names['toy.count_o[3:0]']]}"
    if values[names["toy.u_toy_props.no_nine"]] != [1, 0]:
        yield "the promise does not fail in the last clock"


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    python_tools.need("pyosys", "prove_test")
    root = Path(sys.argv[1]).resolve()
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(ROOT / "scripts", root / "scripts",
                    ignore=shutil.ignore_patterns("__pycache__"))
    layer = root / "rtl" / "math"
    layer.mkdir(parents=True)
    wrong = 0
    for name, old, new, code, says in CASES:
        if old not in PROPERTIES + BLOCK:
            print(f"{name}: '{old}' is in neither file")
            return 1
        for file, text in (("toy.sv", BLOCK), ("toy_props.sv", PROPERTIES)):
            changed = text.replace(old, new, 1) if old else text
            (layer / file).write_text(changed, encoding="ascii")
        done = subprocess.run([sys.executable, root / "scripts" / "tool", "prove", "math/toy"],
                              capture_output=True, text=True, check=False, timeout=120)
        said = done.stdout + done.stderr
        missing = [part for part in says if part not in said]
        if done.returncode != code or missing:
            print(f"{name}: exit code {done.returncode}, not {code}, or not said: {missing}\n"
                  f"{said}")
            wrong += 1
        if name == "a false promise":
            faults = list(waves(root))
            wrong += bool(faults)
            print(*faults, sep="\n", end="\n" if faults else "")
    print(f"prover: {len(CASES)} cases, {wrong} wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
