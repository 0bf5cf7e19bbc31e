#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the C++ code under the address and undefined-behaviour sanitizers, and count its coverage.

usage: sanitize.py build      the preset asan: own code checked, verilated models those of build/
       sanitize.py unit       its unit tests
       sanitize.py program    whole runs of its program, good and bad input

CTest does the three in this order. A finding ends a program with an exit code that no case
expects. Nothing is suppressed.

Exit codes: 0 no finding, 1 a finding or a wrong exit code, 2 usage, or there is no such build.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "asan"
PROGRAM = BUILD / "testbench" / "trammel"
OUT = BUILD / "runs"
# The stacks of SystemC's threads are its own; a fake stack for locals would confuse the two.
ENVIRONMENT = os.environ | {
    "ASAN_OPTIONS": "detect_stack_use_after_return=0:exitcode=99",
    "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99",
    "LSAN_OPTIONS": "exitcode=99"}
# A few points, so that start-up, service routine and every output of a run are there.
LINE = ["-s", "path.kind=line", "-s", "path.line_end_x_m=0.1005", "-s", "path.line_end_y_m=0.1003",
        "-s", "path.line_ticks=10"]
SHORT = ["run", "circle", *LINE]
# Exit code, then the command line; `OUT` stands for the folder of all.
CASES = [
    (0, *SHORT, "--platform", "direct", "-o", "OUT/direct", "--wave", "fst",
     "--wave-window", "20ms:20.1ms"),
    (0, *SHORT, "--platform", "systemc", "-o", "OUT/systemc", "--json"),
    (0, *SHORT, "--platform", "direct", "-o", "OUT/triggered", "--wave", "vcd",
     "--wave-trigger", "drives", "--wave-window", "0:10us", "-s", "controller=fc"),
    (5, *SHORT, "-o", "OUT/tripped", "-s", "inject.trip_s=0.01"),
    (5, *SHORT, "-o", "OUT/watchdog", "-s", "inject.processor_s=0.01",
     "-s", "chip.watchdog_ticks=5"),
    (0, "report", "OUT/direct", "OUT/systemc", "-o", "OUT/two.html"),
    (0, "list"), (0, "list", "keys"), (0, "list", "signals", "--json"), (0, "--version"),
    (2,), (2, "rum"), (2, "run"), (2, "run", "no such"), (2, "run", "--all", "circle"),
    (2, "run", "circle", "-s", "gains.kp=33"), (2, "run", "circle", "-s", "gains.kpp=1"),
    (2, "run", "circle", "-s", "gains.kp"), (2, "run", "circle", "-c", "OUT/none.toml"),
    (2, "run", "circle", "-c", "OUT/bad.toml"), (2, "run", "circle", "-s", "path.kind=points"),
    (2, "run", "circle", "-s", "path.kind=points", "-s", "path.points_file=OUT/bad.csv"),
    (2, "run", "circle", "--wave", "fst", "--wave-window", "5ms"),
    (2, "run", "circle", "--wave", "fst", "--wave-trigger", "x.nothing > 3"),
    (2, "report", "OUT/none"), (2, "list", "nothing"),
]


def configure_and_build():
    if not (ROOT / "build" / "build.ninja").exists():
        print("sanitize: there is no build: trammel test makes it", file=sys.stderr)
        return 2
    for stale in BUILD.rglob("*.gcda"):
        stale.unlink()
    log = ROOT / "build" / "asan.log"
    commands = [] if (BUILD / "build.ninja").exists() else [["cmake", "--preset", "asan"]]
    with log.open("w", encoding="utf-8") as out:
        for command in [*commands, ["ninja", "-C", BUILD, "trammel_checked"]]:
            done = subprocess.run(command, cwd=ROOT, stdout=out, stderr=out, check=False)
            if done.returncode != 0:
                print(f"sanitize: {' '.join(map(str, command))} failed; end of {log}:\n"
                      + log.read_text(encoding="utf-8")[-4000:], file=sys.stderr)
                return 1
    return 0


def unit():
    return subprocess.run(["ctest", "--test-dir", BUILD, "-R", r"^unit\.", "-j", "2",
                           "--output-on-failure", "--no-tests=error"], env=ENVIRONMENT,
                          check=False).returncode and 1


def program():
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    (OUT / "bad.toml").write_text("[gains\nkp = 1\n", encoding="utf-8")
    (OUT / "bad.csv").write_text("1,2\n3;4\n", encoding="utf-8")
    wrong = 0
    for expected, *words in CASES:
        command = [PROGRAM, *(w.replace("OUT", str(OUT)) for w in words)]
        done = subprocess.run(command, env=ENVIRONMENT, cwd=OUT, capture_output=True, text=True,
                              errors="replace", check=False)
        line = f"trammel {' '.join(words)}: exit code {done.returncode}"
        if done.returncode == expected and "runtime error" not in done.stderr:
            print(line)
            continue
        wrong += 1
        print(f"sanitize: {line}, expected {expected}\n{done.stderr[-6000:]}", file=sys.stderr)
    return 1 if wrong else 0


def main():
    verbs = {"build": configure_and_build, "unit": unit, "program": program}
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    if len(sys.argv) != 2 or sys.argv[1] not in verbs:
        print(f"sanitize: one of {', '.join(verbs)}; see --help", file=sys.stderr)
        return 2
    return verbs[sys.argv[1]]()


if __name__ == "__main__":
    sys.exit(main())
