# SPDX-License-Identifier: Apache-2.0
"""The acceptance of whole machines against their specifications, for trammel verify --acceptance.

`[acceptance] tools` of machines/<m>/tests/runs.toml names what is run: each a tool of scripts/tool
with its arguments. They print what they measure; one that does not end with 0 is an error.
"""

import subprocess
import sys

from trammel_tools import machines
from trammel_tools.check import engines
from trammel_tools.paths import ROOT


def check():
    """Returns lines of what went wrong."""
    if not engines.PROGRAM.exists():
        raise engines.EngineError("the program is missing: trammel list builds it")
    wrong = []
    for machine in machines.folders():
        for tool in machines.runs(machine).get("acceptance", {}).get("tools", []):
            print(f"{machine}: {tool}", flush=True)
            done = subprocess.run([sys.executable, ROOT / "scripts" / "tool", *tool.split()],
                                  check=False)
            if done.returncode != 0:
                wrong.append(f"{machine}: {tool}: exit {done.returncode}")
    return wrong
