# SPDX-License-Identifier: Apache-2.0
"""Yosys (pyosys) in a separate process, and the modules that it reads."""

import subprocess
import sys

from trammel_tools.paths import ROOT, block_file
from trammel_tools.rtl import lint

PACKAGES = ROOT / "scripts"


class YosysError(Exception):
    """One line: the log of the script that fails."""


def design():
    """Every module, packages first; slang takes what the top needs."""
    generated = sorted(p for p in lint.GENERATED.glob("*.sv") if not p.stem.endswith("_pkg"))
    return [*lint.packages(), *(block_file(block, ".sv") for block in lint.blocks()), *generated]


def run(folder, names):
    """The finished process that ran each name.ys there; each has its log in name.log."""
    code = (f"import sys; sys.path.insert(0, {str(PACKAGES)!r})\n"
            "from pyosys import libyosys as ys\n"
            "from trammel_tools.rtl import rewire\n"
            "command = rewire.register()\n"
            f"for name in {names}:\n"
            "    ys.run_pass(f'tee -q -o {name}.log script {name}.ys', ys.Design())")
    return subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True,
                          text=True, check=False)


def make(script, folder, name):
    """Writes name.ys into the folder and runs it."""
    (folder / f"{name}.ys").write_text(script, encoding="utf-8")
    if run(folder, [name]).returncode != 0:
        raise YosysError(f"Yosys fails: {folder}/{name}.log")
