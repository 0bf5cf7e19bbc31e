#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Peak memory of `trammel run` does not grow with the simulated time, files and report included.

usage: memory_test.py PROGRAM      the built trammel program
"""

import os
import subprocess
import sys
import tempfile

GROWTH_KIB = 2048  # allowed from the short run to the long one; a record kept would take 10,000
RUNS = {"circle": (["--engine", "twin", "-s", "run.max_s=60"], "path.repeats", (2, 22)),
        "an693-hold": (["--no-report"], "trajectory.wait_s", (2, 60))}


def peak_kib(program, scenario, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.Popen([program, "run", scenario, *arguments, "--out", f"{folder}/run"],
                               stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = status
    return usage.ru_maxrss if status == 0 else sys.exit(f"{scenario}: ended with {status}")


def main(program):
    errors = 0
    for scenario, (arguments, key, lengths) in RUNS.items():
        short, long = (peak_kib(program, scenario, *arguments, "-s", f"{key}={length}")
                       for length in lengths)
        print(f"{scenario}: {short} KiB with {key} = {lengths[0]}, {long} with {lengths[1]}")
        errors += long > short + GROWTH_KIB
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
