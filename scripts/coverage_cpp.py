# SPDX-License-Identifier: Apache-2.0
"""Coverage of the C++ code: gcovr over the counts that scripts/sanitize.py left in build/asan."""

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

import python_tools

ROOT = Path(__file__).resolve().parent.parent
OBJECTS = ROOT / "build" / "asan"
PAGES = ROOT / "build" / "coverage" / "cpp"
FOLDERS = ("models", "sw_nios", "cosim", "systemc", "testbench")


class NoCounts(Exception):
    """The sanitized build has not run."""


def counted():
    return next(OBJECTS.rglob("*.gcda"), None) is not None


def gcovr(*output):
    python_tools.need("gcovr", "coverage")
    if not counted():
        raise NoCounts(f"no counts in {OBJECTS.relative_to(ROOT)}: run `trammel coverage`")
    filters = [f"--filter={ROOT}/{folder}/" for folder in FOLDERS]
    done = subprocess.run([sys.executable, "-m", "gcovr", "--root", ROOT, *filters, "-j", "2",
                           "--exclude=.*/generated/.*", "--merge-mode-functions=separate",
                           *output, OBJECTS], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise NoCounts(f"gcovr: {done.stderr.strip()[-1000:]}")


def folder_of(name):
    parts = Path(name).parts
    return "/".join(parts[:2]) if parts[0] == "models" else parts[0]


def read_lines():
    """Lines of each folder: (executed, all). A line of a template counts once."""
    PAGES.mkdir(parents=True, exist_ok=True)
    counts = PAGES / "counts.json"
    gcovr("--json", counts)
    hit, total = Counter(), Counter()
    for file in json.loads(counts.read_text(encoding="utf-8"))["files"]:
        lines = Counter()
        for line in file["lines"]:
            lines[line["line_number"]] += line["count"]
        folder = folder_of(file["file"])
        hit[folder] += sum(count > 0 for count in lines.values())
        total[folder] += len(lines)
    return {folder: (hit[folder], total[folder]) for folder in sorted(total)}


def check(floors):
    """Prints the table; what lies below its floor."""
    lines = read_lines()
    print(f"{'C++ folder':<24}{'lines':>16}")
    wrong = []
    for folder, (hit, total) in lines.items():
        share = 100 * hit / total
        print(f"{folder:<24}{f'{share:.1f} % of {total}':>16}")
        if share < floors.get(folder, 100):
            wrong.append(f"{folder}: {share:.1f} % of the lines, below its floor of "
                         f"{floors.get(folder, 100)} %")
    wrong += [f"coverage.toml: no folder {folder}" for folder in floors.keys() - lines.keys()]
    return wrong


def annotate():
    gcovr("--html-nested", PAGES / "index.html")
