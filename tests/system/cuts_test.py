#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs that `run.max_s` cuts anywhere end at that edge: RTL by SystemC, RTL direct and twin alike.

usage: cuts_test.py [--cuts N] [--seed N] [--longest SECONDS]
"""

import argparse
import random
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools.check import engines

TIMEOUT = 5  # exit code of a run that does not finish within run.max_s


def differences(scenario, cut, folder):
    variant = f"run.max_s={cut!r}"
    direct, systemc, twin = (
        engines.run(scenario, variant, engine, folder, platform, TIMEOUT)
        for engine, platform in (("rtl", "direct"), ("rtl", "systemc"), ("twin", "direct")))
    return ([f"SystemC: {what}" for what in engines.differences(direct, systemc)] +
            [f"twin: {what}" for what in engines.differences(direct, twin)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--cuts", type=int, default=30, help="runs that are cut (default 30)")
    parser.add_argument("--seed", type=int, default=1, help="of the random cuts (default 1)")
    parser.add_argument("--longest", type=float, default=0.004,
                        help="simulated time of the longest run, in s (default 0.004)")
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    names = [name for name, _ in engines.with_twin(engines.scenarios())]
    wrong = 0
    for _ in range(arguments.cuts):
        scenario, cut = chance.choice(names), chance.uniform(0.001, arguments.longest)
        with tempfile.TemporaryDirectory() as folder:
            found = differences(scenario, cut, Path(folder))
        wrong += bool(found)
        for what in found:
            print(f"{scenario} cut at {cut!r} s: RTL direct and {what}")
    print(f"{arguments.cuts - wrong} of {arguments.cuts} equal")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
