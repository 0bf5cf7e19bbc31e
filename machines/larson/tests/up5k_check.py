#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Map both axes of the stepper interface, without AXI4-Lite and pulse buffers, for an iCE40 UP5K.

usage: up5k_check.py PROGRAM FOLDER     PROGRAM: is not used; FOLDER: for netlist and log, made anew

Exit codes: 0 at most 500 LUT4 and no block RAM, 1 more, 77 Yosys is missing.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts"))
from trammel_tools import python_tools

LIMIT = 500  # LUT4
TOP = "larson_ice40_up5k"


def main():
    python_tools.need("pyosys", "up5k")
    from trammel_tools.synth import synth_flow
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    used = synth_flow.map_to_ice40(TOP, folder)
    print(f"up5k: {TOP}: {used['lut4']} LUT4 of {LIMIT}, {used['carry']} carry bits, "
          f"{used['ff']} flip-flops, {used['block_ram']} block RAMs")
    return 0 if used["lut4"] <= LIMIT and used["block_ram"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
