# SPDX-License-Identifier: Apache-2.0
"""Coverage of the C++ code: gcovr over the counts that scripts/tool sanitize left in build/asan."""

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.check.rooms import ROOMS
from trammel_tools.paths import ROOT

OBJECTS = ROOT / "build" / "asan"
PAGES = ROOT / "build" / "coverage" / "cpp"
EACH = ("models", "parts", "machines")  # whose folders have floors of their own


class NoCounts(Exception):
    """The sanitized build has not run."""


def counted():
    return next(OBJECTS.rglob("*.gcda"), None) is not None


def gcovr(*output):
    python_tools.need("gcovr", "coverage")
    if not counted():
        raise NoCounts(f"no counts in {OBJECTS.relative_to(ROOT)}: run `trammel coverage`")
    filters = [f"--filter={ROOT}/{folder}/" for folder in ROOMS]
    done = subprocess.run([sys.executable, "-m", "gcovr", "--root", ROOT, *filters, "-j", "2",
                           "--exclude=.*/generated/.*", "--exclude=.*/machines/.*/tests/.*",
                           "--merge-mode-functions=separate", *output, OBJECTS],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise NoCounts(f"gcovr: {done.stderr.strip()[-1000:]}")


def folder_of(name):
    parts = Path(name).parts
    return "/".join(parts[:2]) if parts[0] in EACH else parts[0]


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
        floor = floors.get(folder, floors.get(Path(folder).parts[0], 100))
        if share < floor:
            wrong.append(f"{folder}: {share:.1f} % of the lines, below its floor of {floor} %")
    there = lines.keys() | {Path(folder).parts[0] for folder in lines}
    wrong += [f"coverage.toml: no folder {folder}" for folder in floors.keys() - there]
    return wrong


def annotate():
    gcovr("--html-nested", PAGES / "index.html")
