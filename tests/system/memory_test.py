#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Peak memory of `trammel run` does not grow with the simulated time, files and report included.

usage: memory_test.py PROGRAM      the built trammel program

Each machine names its runs in its tests/runs.toml.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import machines

GROWTH_KIB = 2048  # allowed from the short run to the long one; a record kept would take 10,000


def peak_kib(program, scenario, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.Popen([program, "run", scenario, *arguments, "--out", f"{folder}/run"],
                               stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = status
    return usage.ru_maxrss if status == 0 else sys.exit(f"{scenario}: ended with {status}")


def main(program):
    errors = 0
    cases = [case for name in machines.folders() for case in machines.runs(name).get("memory", [])]
    for case in cases:
        scenario, key, lengths = case["scenario"], case["key"], case["values"]
        short, long = (peak_kib(program, scenario, *case["arguments"], "-s", f"{key}={length}")
                       for length in lengths)
        print(f"{scenario}: {short} KiB with {key} = {lengths[0]}, {long} with {lengths[1]}")
        errors += long > short + GROWTH_KIB
    return 1 if errors or not cases else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
