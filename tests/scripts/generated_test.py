#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that `--check` of gen-register-map and gen-sine refuses stale files, in a copy of the
sources.

Exit codes: 0 each is refused, 1 one is not, 3 PeakRDL is missing (77 under CTest).
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools
from trammel_tools.paths import ROOT

COPIED = ["scripts", "rtl/chips", "rtl/pkg", "rtl/math", "docs/registers"]
GENERATED = "rtl/chips/generated"
CASES = [  # what, tool, file, what becomes what there (no new text: the file goes), files named
    ("nothing", "gen-register-map", None, "", "", []),
    ("another reset value in the map", "gen-register-map", "rtl/chips/kung_xy.rdl",
     "mant[10:0] = 768", "mant[10:0] = 769",
     [f"{GENERATED}/kung_xy_regs.sv", f"{GENERATED}/kung_xy_regs.hpp",
      "docs/registers/kung_xy.md"]),
    ("another signal behind a field", "gen-register-map", "rtl/chips/kung_xy.rdl",
     "u_afc.de_q", "u_afc.e_q", [f"{GENERATED}/kung_xy_signals.hpp"]),
    ("another description", "gen-register-map", "rtl/chips/mcafee_xy.rdl",
     '"pin HI of X"', '"pin HI of Y"',
     [f"{GENERATED}/mcafee_xy_regs.hpp", "docs/registers/mcafee_xy.md"]),
    ("another address in the header", "gen-register-map", f"{GENERATED}/mcafee_xy_regs.hpp",
     "kStatus = 0x0Cu", "kStatus = 0x10u", [f"{GENERATED}/mcafee_xy_regs.hpp"]),
    ("another width in the package", "gen-register-map", f"{GENERATED}/kung_xy_regs_pkg.sv",
     "logic [31:0] next", "logic [30:0] next", [f"{GENERATED}/kung_xy_regs_pkg.sv"]),
    ("no page", "gen-register-map", "docs/registers/mcafee_xy.md", "", None,
     ["docs/registers/mcafee_xy.md"]),
    ("nothing", "gen-sine", None, "", "", []),
    ("another value of the sine", "gen-sine", "rtl/math/sine_pkg.sv", "12'd0013", "12'd0014",
     ["sine_pkg.sv"]),
    ("no sine", "gen-sine", "rtl/math/sine_pkg.sv", "", None, ["sine_pkg.sv"]),
]


def complaint(folder, tool):
    """(exit code, lines) of its --check."""
    done = subprocess.run([sys.executable, folder / "scripts" / "tool", tool, "--check"],
                          capture_output=True, text=True, check=False)
    return done.returncode, sorted(done.stderr.splitlines())


def wrong(folder, case):
    """What is wrong with a case; its file is as it was afterwards."""
    name, tool, file, old, new, named = case
    before = (folder / file).read_text(encoding="utf-8") if file else ""
    if old not in before:
        return f"{name}: {file} has no {old}"
    if file and new is None:
        (folder / file).unlink()
    elif file:
        (folder / file).write_text(before.replace(old, new, 1), encoding="utf-8")
    code, lines = complaint(folder, tool)
    if file:
        (folder / file).write_text(before, encoding="utf-8")
    if code != (1 if named else 0) or len(lines) != len(named) \
            or not all(any(n in line.split() for line in lines) for n in named):
        return f"{name}: {tool} --check ends with {code}: {'; '.join(lines) or 'no complaint'}"
    return None


def main():
    python_tools.need("peakrdl_regblock", "generated_test")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part in COPIED:
            shutil.copytree(ROOT / part, folder / part)
        found = [what for what in (wrong(folder, case) for case in CASES) if what]
    print("\n".join([*found, f"{len(CASES) - len(found)} of {len(CASES)} cases"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
