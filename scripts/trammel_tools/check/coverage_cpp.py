# SPDX-License-Identifier: Apache-2.0
"""Coverage of the C++ code: the lines that each group of scripts/tool sanitize executes.

Its programs write their counts below build/asan/counts/<group>; gcovr makes them lines of files,
and these, in a short form, are in the group's kept result.
"""

import json
import re
import shutil
import subprocess
import sys
from collections import Counter, defaultdict
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.check.rooms import ROOMS
from trammel_tools.evidence import evidence, kinds, record
from trammel_tools.paths import ROOT

OBJECTS = ROOT / "build" / "asan"
COUNTS = OBJECTS / "counts"
PAGES = ROOT / "build" / "coverage" / "cpp"
EACH = ("models", "parts", "machines")  # whose folders have floors of their own


class NoCounts(Exception):
    """Counts are missing: a group has not run, or its result does not hold."""


def begin(group):
    """Empties the group's counts; the environment of programs that write them."""
    shutil.rmtree(COUNTS / group, ignore_errors=True)
    return {"GCOV_PREFIX": str(COUNTS / group),
            "GCOV_PREFIX_STRIP": str(len(OBJECTS.parts) - 1)}


def gcovr(*options):
    python_tools.need("gcovr", "coverage")
    filters = [f"--filter={ROOT}/{folder}/" for folder in ROOMS]
    done = subprocess.run([sys.executable, "-m", "gcovr", "--root", ROOT, *filters,
                           "--exclude=.*/generated/.*", "--exclude=.*/machines/.*/tests/.*",
                           "--merge-mode-functions=separate", *options],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise NoCounts(f"gcovr: {done.stderr.strip()[-1000:]}")


def own_files(group):
    """Files that the group's result depends on: of others it would keep lines that have moved."""
    kind, found = kinds.of(f"sanitize.{group}")
    return kind.files(found)


def count(group):
    """{file: {line: executions}} of a group that has run; a line of a template counts once. A
    library that its programs link has more files than its own."""
    folder = COUNTS / group
    for path in folder.rglob("*.gcda"):
        notes = path.with_suffix(".gcno")
        notes.unlink(missing_ok=True)
        notes.symlink_to(OBJECTS / notes.relative_to(folder))
    PAGES.mkdir(parents=True, exist_ok=True)
    counts = PAGES / f"{group}.json"
    gcovr("--json", counts, folder)
    lines, own = defaultdict(Counter), own_files(group)
    for file in json.loads(counts.read_text(encoding="utf-8"))["files"]:
        for line in file["lines"] if file["file"] in own else ():
            lines[file["file"]][line["line_number"]] += line["count"]
    return lines


def short(files):
    """A line of text for each file: the lines with code, `-` before those never executed."""
    for name, lines in sorted(files.items()):
        runs = []
        for line, executed in sorted((line, n > 0) for line, n in lines.items()):
            if runs and runs[-1][1:] == (line - 1, executed):
                runs[-1] = (runs[-1][0], line, executed)
            else:
                runs.append((line, line, executed))
        yield " ".join([name, *(f"{'' if executed else '-'}{first}" +
                                (f"..{last}" if last > first else "")
                                for first, last, executed in runs)])


def read_short(*texts):
    """{file: {line: groups that executed it}} of the lines that `short` makes."""
    files = defaultdict(Counter)
    for name, runs in re.findall(r"^(\S+\.[ch]pp) (.+)$", "\n".join(texts), re.M):
        for never, first, last in re.findall(r"(-?)(\d+)(?:\.\.(\d+))?", runs):
            for line in range(int(first), int(last or first) + 1):
                files[name][line] += not never
    return files


def folder_of(name):
    parts = Path(name).parts
    return "/".join(parts[:2]) if parts[0] in EACH else parts[0]


def counted(groups):
    """{file: {line: groups that executed it}} of the kept results of these groups."""
    names = [f"sanitize.{group}" for group in groups]
    if reasons := [reason for name in names if (reason := evidence.stale(name))]:
        raise NoCounts(f"{reasons[0]}; run `trammel test -R sanitize`")
    return read_short(*(record.read(name).result for name in names))


def lines_of(files):
    """Lines of each folder: (executed, all)."""
    hit, total = Counter(), Counter()
    for file, lines in files.items():
        hit[folder_of(file)] += sum(count > 0 for count in lines.values())
        total[folder_of(file)] += len(lines)
    return {folder: (hit[folder], total[folder]) for folder in sorted(total)}


def check(floors, files):
    """Prints the table; what lies below its floor."""
    lines = lines_of(files)
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
    """Whether there are counts, which become pages."""
    counts = [f"--add-tracefile={path}" for path in sorted(PAGES.glob("*.json"))]
    if counts:
        gcovr(*counts, "--html-nested", PAGES / "index.html")
    return bool(counts)
