# SPDX-License-Identifier: Apache-2.0
"""Map the paper's equations to the lines that implement them: docs/equations.md.

usage: scripts/tool gen-equations [--check]     --check writes nothing; exit 1 if the map is stale

A line implements an equation when a comment on it, or just above it, marks it: "Kung eq. 23",
"Kung eq. 28, 29", "Kung eq. 30 to 38". A test is named by its file alone. docs/equations.toml holds
what each equation says and where it must be marked. An equation that is marked nowhere, or not
where it must be, or that does not exist, is an error in both modes.
"""

import re
import sys
import tomllib
from pathlib import Path

from trammel_tools.paths import ROOT

SOURCE = ROOT / "docs" / "equations.toml"
TARGET = ROOT / "docs" / "equations.md"
# Kind of file, as a reader would call it; the longest fitting folder counts.
KINDS = {"rtl": "RTL", "models/exact": "twin", "models/ideal": "ideal", "models/plant": "plant",
         "sw_nios": "firmware", "cosim": "set-up", "machines": "set-up", "lab": "metric",
         "tests": "test"}
METRICS = {"figures", "measures"}  # files of a machine
SUFFIXES = {".sv", ".hpp", ".cpp"}

HEAD = """<!-- Generated from docs/equations.toml and the sources by scripts/tool gen-equations; \
do not edit. -->
# Equations of the paper and where they are

Kung, Huang and Huang, "FPGA-Based Motion Control IC for Linear Motor Drive X-Y Table Using Adaptive
Fuzzy Control", 2012 (DOI 10.5772/48457). Every numbered equation is implemented at the lines named
here, or has a reason why not. RTL and twin compute the same integers; the ideal model is the same
law in double precision; firmware writes the path; set-up converts physical values to register
words; a test is named by its file. Where the paper is silent or we differ:
[deviations.md](deviations.md).

| Eq. | What | Where |
|---|---|---|
"""


def numbers(text):
    """ "28, 29" or "30 to 38" or "9 and 10" as a list of integers. """
    found = []
    for first, last in re.findall(r"(\d+)(?:\s*(?:to|-)\s*(\d+))?", text):
        found += range(int(first), int(last or first) + 1)
    return found


def marks(paper):
    """(equation, file, line) of every mark."""
    one = r"\d+(?:\s*(?:to|-)\s*\d+)?"
    pattern = re.compile(rf"\b{paper} eq\. ({one}(?:(?:,| and)\s*{one})*)")
    for top in sorted({Path(kind).parts[0] for kind in KINDS}):
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix not in SUFFIXES or "generated" in path.parts:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
                for mark in pattern.findall(line):
                    for equation in numbers(mark):
                        yield equation, path.relative_to(ROOT), number


def kind_of(path):
    if path.parts[0] == "machines" and "tests" in path.parts:
        return "test"
    if path.parts[0] == "machines" and path.stem in METRICS:
        return "metric"
    fitting = [folder for folder in KINDS if path.is_relative_to(folder)]
    return KINDS[max(fitting, key=len)] if fitting else None


def collect(source):
    """Equation -> kind -> file -> lines, and what is wrong with it."""
    table = {n: {} for n in range(1, source["count"] + 1)}
    problems = []
    for equation, path, line in marks(source["paper"]):
        if equation not in table:
            problems.append(f"{path}:{line}: {source['paper']} has no equation {equation}")
            continue
        kind = kind_of(path)
        if kind is None:
            problems.append(f"{path}:{line}: a mark in a folder that implements nothing")
            continue
        lines = table[equation].setdefault(kind, {}).setdefault(path, [])
        if line not in lines:
            lines.append(line)
    name = SOURCE.relative_to(ROOT)
    for equation, found in table.items():
        entry = source.get(str(equation))
        if entry is None:
            problems.append(f"{name}: equation {equation} is missing")
            continue
        if ("in" in entry) == ("none" in entry):
            problems.append(f"{name}: equation {equation} needs either `in` or `none`")
        for kind in entry.get("in", []):
            if kind not in found:
                problems.append(f"{name}: equation {equation}: no mark in {kind}")
        if "none" in entry and set(found) - {"test"}:
            problems.append(f"{name}: equation {equation} is marked, yet has a reason for none")
    return table, problems


def where(found):
    parts = []
    for kind in filter(found.get, dict.fromkeys(KINDS.values())):
        links = []
        for path, (first, *more) in found[kind].items():
            if kind == "test":  # without lines: tests change more often than the law they hold
                links.append(f"[{path.name}](../{path})")
                continue
            links.append(f"[{path.name}:{first}](../{path}#L{first})")
            links += [f"[{n}](../{path}#L{n})" for n in more]
        parts.append(f"{kind} {', '.join(links)}")
    return "; ".join(parts)


def page(source, table):
    text = HEAD
    for equation, found in table.items():
        entry = source[str(equation)]
        what = entry["what"] + (f". *{entry['note']}.*" if "note" in entry else "")
        place = "; ".join(filter(None, [entry.get("none"), where(found)]))
        text += f"| {equation} | {what} | {place} |\n"
    return text


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    if sys.argv[1:] not in ([], ["--check"]):
        print("gen-equations: expects nothing or --check", file=sys.stderr)
        return 2
    source = tomllib.loads(SOURCE.read_text(encoding="utf-8"))
    table, problems = collect(source)
    for problem in problems:
        print(problem, file=sys.stderr)
    if problems:
        return 1
    text = page(source, table)
    if "--check" not in sys.argv:
        TARGET.write_text(text, encoding="ascii")
        print(TARGET.relative_to(ROOT))
    elif not TARGET.exists() or TARGET.read_text(encoding="utf-8") != text:
        print("docs/equations.md is stale: scripts/tool gen-equations", file=sys.stderr)
        return 1
    return 0
