# SPDX-License-Identifier: Apache-2.0
"""Make register block, C++ headers and documentation from each rtl/chips/<chip>.rdl.

Writes into rtl/chips/generated/ <chip>_regs.sv and <chip>_regs_pkg.sv (PeakRDL, AXI4-Lite),
<chip>_regs.hpp for firmware, twin and tests and, where the map names signals of the chip,
<chip>_signals.hpp for triggers; and docs/registers/<chip>.md.
With --check nothing is written; the exit code is 1 when an output is stale.

Exit codes: 0 done, 1 stale, 2 usage, 3 PeakRDL is missing (under CTest 77).
"""

import argparse
import difflib
import sys

from trammel_tools import python_tools
from trammel_tools.paths import ROOT

NOTE = "Generated from {source} by scripts/tool gen-register-map; do not edit."


def outputs(root):
    """{path: text} of all that is generated below a copy of the repository."""
    # Here, since they need PeakRDL.
    from trammel_tools.generate import (
        register_block,
        register_header,
        register_map,
        register_page,
        register_signals,
    )
    texts = {}
    for source in sorted(root.glob("rtl/chips/*.rdl")):
        top, chip = register_map.read(source), source.stem
        note = NOTE.format(source=source.relative_to(root).as_posix())
        files = {**register_block.sources(top, note),
                 f"{chip}_regs.hpp": register_header.header(top, note),
                 f"{chip}_signals.hpp": register_signals.header(top, note)}
        texts |= {root / "rtl/chips/generated" / name: text for name, text in files.items() if text}
        texts[root / f"docs/registers/{chip}.md"] = register_page.page(top, note)
    return texts


def stale(root):
    """{path: text} of the outputs that are not as they would be written."""
    return {path: text for path, text in outputs(root).items()
            if not path.exists() or path.read_text(encoding="utf-8") != text}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare only; 1 when stale")
    check = parser.parse_args().check
    python_tools.need("peakrdl_regblock", "gen-register-map")
    changed = stale(ROOT)
    for path, text in changed.items():
        if check and path.suffix == ".md":
            before = path.read_text(encoding="utf-8") if path.exists() else ""
            print(*difflib.unified_diff(before.splitlines(), text.splitlines(), "now", "by the map",
                                        lineterm="", n=0), sep="\n")
        if not check:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        print(f"{'stale, run scripts/tool gen-register-map:' if check else 'wrote'} "
              f"{path.relative_to(ROOT)}", file=sys.stderr if check else sys.stdout)
    return 1 if check and changed else 0
