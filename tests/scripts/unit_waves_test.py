#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that a failed unit test of a block leaves waves that show the failure, and their view.

usage: unit_waves_test.py FOLDER MAIN     a block and a test that fails are written there; MAIN: the
                                          library with Catch2's main

Exit codes: 0 it does, 1 it does not, 77 verilator is missing.
"""

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

BLOCK = """module toy (
    input  logic       clk_i,
    input  logic       rst_i,
    input  logic       up_i,
    output logic [3:0] count_o
);
  logic [3:0] count_q;
  always_ff @(posedge clk_i) count_q <= rst_i ? '0 : count_q + 4'(up_i);
  assign count_o = count_q;
endmodule
"""
TEST = """#include "Vtoy.h"

#include <catch2/catch.hpp>

#include "tests/support/rtl.hpp"

TEST_CASE("it counts") { CHECK(true); }

TEST_CASE("it counts, up to six [only], they say") {
  for (int run = 0; run < 3; ++run) {
    trammel::test::Rtl<Vtoy> toy;
    toy.reset();
    toy->up_i = 1;
    for (int i = 0; i < 5 + run; ++i) toy.tick();
    CHECK(toy->count_o < 7);  // not in the third run: 2 clocks of reset, then 7
  }
}
"""
# The same case in a program that is quick to build: all that matters is that and where it fails.
FAILS = """#include <catch2/catch.hpp>
#line 9 "../tests/math/toy_test.cpp"
TEST_CASE("it counts, up to six [only], they say") { CHECK(false); }
"""


def changes(waves):
    """{name: [value]} of a VCD, names with all scopes; what is not a vector is 0 or 1."""
    scopes, names, values = [], {}, {}
    for line in waves.read_text(encoding="ascii").splitlines():
        word = line.split()
        match word[:1]:
            case ["$scope"]:
                scopes.append(word[2])
            case ["$upscope"]:
                scopes.pop()
            case ["$var"]:
                names.setdefault(word[3], []).append(".".join([*scopes, word[4]]))
            case [first] if first[0] in "01":
                values.setdefault(first[1:], []).append(int(first[0]))
            case [first] if first[0] == "b":
                values.setdefault(word[1], []).append(int(first[1:], 2))
    return {name: values[code] for code, every in names.items() for name in every
            if code in values}


def faults(root, catch_main):
    tool = root / "scripts" / "tool"
    program = root / "build" / "tests" / "toy_test"
    program.parent.mkdir(parents=True)
    shutil.copy(catch_main, program.parent)
    subprocess.run(["c++", "-std=c++17", "-o", program, "-x", "c++", "-", "-x", "none",
                    catch_main], input=FAILS, text=True, check=True)
    done = subprocess.run(program, cwd=root, capture_output=True, text=True, check=False)
    view = "build/waves/math_toy/waves.gtkw"
    place = "failed after evaluated edge 9, at 180 ns"
    if done.returncode != 1 or place not in done.stdout or view not in done.stdout:
        log = root / "build" / "waves" / "math_toy" / "build.log"
        yield f"exit code {done.returncode}: {done.stdout}{done.stderr}"
        yield log.read_text(encoding="utf-8")[-2000:] if log.exists() else "nothing was built"
        return
    seen = changes(root / "build" / "waves" / "math_toy" / "waves.vcd")
    if seen.get("top.count_o", [])[-1:] != [7]:
        yield f"count_o is {seen.get('top.count_o')}, not 7 in the end"
    lines = (root / view).read_text(encoding="ascii").splitlines()
    shown = [line.split("[")[0] for line in lines if line.startswith("top.")]
    for name in ("top.clk_i", "top.up_i", "top.count_o", "top.toy.count_q"):
        if name not in shown or name not in seen:
            yield f"{name} is not in the view or not in the waves"
    for words, code in ((["math/toy_test.cpp", "it counts"], 1), (["math/none_test.cpp"], 2),
                        (["math/toy_test.cpp", "it counts", root / "none.a"], 3)):
        done = subprocess.run([sys.executable, tool, "unit-waves", *words], cwd=root,
                              capture_output=True, text=True, check=False)
        if done.returncode != code:
            yield f"{words}: exit code {done.returncode}, not {code}: {done.stderr}"


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    if shutil.which("verilator") is None:
        print("unit_waves_test: verilator is missing (trammel doctor)", file=sys.stderr)
        return 77
    root = Path(sys.argv[1]).resolve()
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(ROOT / "scripts", root / "scripts",
                    ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "tests" / "support", root / "tests" / "support")
    shutil.copytree(ROOT / "cosim" / "verilated", root / "cosim" / "verilated")
    for name, text in (("rtl/math/toy.sv", BLOCK), ("tests/math/toy_test.cpp", TEST)):
        (root / name).parent.mkdir(parents=True)
        (root / name).write_text(text, encoding="ascii")
    wrong = list(faults(root, Path(sys.argv[2]).resolve()))
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
