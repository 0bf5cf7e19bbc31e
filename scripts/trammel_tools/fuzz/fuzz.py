# SPDX-License-Identifier: Apache-2.0
"""Feed the program random input, in process and as whole starts, and set disks against it.

usage: scripts/tool fuzz [--part PART] [--runs N | --minutes N] [--seed N]
       scripts/tool fuzz --short      what the test fuzz.short runs, with the sanitized build

Parts, all of them unless one is named; N is of each:
  inside    keys, scenarios, tables of points, G-code, LM628 scripts and folders of runs, by
            libFuzzer under the address and undefined-behaviour sanitizers (preset fuzz, needs
            Clang)
  starts    starts of the program with random command lines, files and folders
  disks     runs against small disks, kills, little memory, bad streams, and each other

  --runs N       cases of each part; default 100000 inside, 2000 starts, 100 disks
  --minutes N    for so long instead
  --seed N       of the first case, default 1: the same seed gives the same cases

A finding is a crash, an input of more than 10 s, an exit code that docs/manual.md does not have, a
file outside of its folder, a character that is no text on the terminal, more than one line of an
error, or a folder that is not of one run. Inputs that make one are in build/fuzz/findings.

Exit codes: 0 no finding, 1 a finding or the build failed, 2 usage, 3 Clang or the program missing.
"""

import argparse
import shutil
import sys

from trammel_tools.check import sanitize
from trammel_tools.fuzz import fuzz_disks, fuzz_inside, fuzz_seeds, fuzz_starts
from trammel_tools.machines import MachineError
from trammel_tools.paths import ROOT

PROGRAM = ROOT / "build" / "testbench" / "trammel"
RUNS = {"inside": 100000, "starts": 2000, "disks": 100}


def inside(seed, count, seconds):
    if shutil.which("clang++") is None:
        print("fuzz: clang++ is missing: apt-get install clang libclang-rt-14-dev", file=sys.stderr)
        return None
    failed = fuzz_inside.build()
    if failed is not None:
        print(f"fuzz: the build failed:\n{failed}", file=sys.stderr)
        return 1
    return fuzz_inside.run(PROGRAM, seed, count if seconds is None else None, seconds)


def parts(asked):
    seconds = None if asked.minutes is None else 60 * asked.minutes
    found = 0
    for part in [asked.part] if asked.part else RUNS:
        count = asked.runs or RUNS[part]
        if part == "inside":
            result = inside(asked.seed, count, seconds)
            if result is None:
                return 3
            found += result
        else:
            run = fuzz_starts.run if part == "starts" else fuzz_disks.run_all
            found += run(PROGRAM, asked.seed, count, seconds)
    return 1 if found else 0


def short(seed):
    if failed := sanitize.build("trammel_fuzz_replay"):
        print(f"fuzz: {failed}", file=sys.stderr)
        return 1
    found = (fuzz_inside.replay(PROGRAM, seed) + fuzz_starts.run(PROGRAM, seed, 400) +
             fuzz_disks.run_all(PROGRAM, seed, 16))
    return 1 if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, add_help=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-h", "--help", action="store_true")
    parser.add_argument("--part", choices=list(RUNS))
    parser.add_argument("--runs", type=int)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--short", action="store_true")
    asked = parser.parse_args()
    if asked.help:
        print(__doc__)
        return 0
    if not PROGRAM.exists():
        print("fuzz: there is no program: ./trammel list builds it", file=sys.stderr)
        return 3
    try:
        return short(asked.seed) if asked.short else parts(asked)
    except (MachineError, fuzz_seeds.SeedError) as error:
        print(f"fuzz: {error}", file=sys.stderr)
        return 1
