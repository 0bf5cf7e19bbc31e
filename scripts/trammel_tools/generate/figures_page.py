# SPDX-License-Identifier: Apache-2.0
"""docs/figures.md: the figures that the built-in scenarios report."""

import html
import itertools
import json
import os
import re
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools import machines

HEAD = """<!-- Generated from metrics.json by scripts/tool gen-manual; do not edit. -->
# Figures of a run

A run prints figures at its end and writes them to `metrics.json`; the first column is the place
there. `trammel sweep` and `trammel tune` use the same names. For this page each built-in scenario
ran twice, to its end and cut short after 20 ms; some also ran with the keys that stand behind their
names.

The digits are those behind the point; `whole` is a whole number. A tile opens the report page. A
hidden figure is in `metrics.json` only. In the last column, `cut:` are the scenarios that report
the figure when they are cut short, if these are others. `[x.|y.]` are two figures, one per axis.
`N` is a number that the settings give.
"""
MACHINE = """
## {name}

{title}: [{name}](../machines/{name}/README.md).

| figure | meaning | unit | digits | tile | scenarios |
|---|---|---|---|---|---|
"""
EXPECTED = """
Expected values of {name}; a run with `--check` fails outside the tolerance:

| figure | printed | expected | tolerance | source | scenarios |
|---|---|---|---|---|---|
"""
CUT_S = 0.02
NUMBER = r"\d+(?:\.\d+)?"


class Contradiction(Exception):
    """Figures that one list cannot have."""


def figures(program, scenario, machine, settings):
    """The figures of a run, as metrics.json has them."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "run"
        done = subprocess.run(
            [program, "run", scenario, "--no-report", "-o", out,
             *(["--engine", "twin"] if machine["twin"] else []),
             *itertools.chain.from_iterable(("-s", one) for one in settings)],
            capture_output=True, text=True, check=False, env={**os.environ, "PATH": "/nowhere"})
        if not (out / "metrics.json").is_file():
            raise Contradiction(f"{scenario}: {done.stderr.strip()}")
        return json.loads((out / "metrics.json").read_text(encoding="utf-8"))["figures"]


def shape(figure):
    """A figure without its value: id, meaning, unit, digits, tile."""
    return (figure["id"], figure["name"], figure["unit"], str(figure.get("digits", "whole")),
            figure.get("tile", ""))


def general(shapes):
    """{shape: the same with N for a number that the settings give}, where these differ."""
    alike = {}
    for one in dict.fromkeys(shapes):
        alike.setdefault((one[0], re.sub(NUMBER, "N", one[1]), *one[2:]), []).append(one)
    return {one: same[0] if len(same) == 1 else common
            for common, same in alike.items() for one in same}


def merged(lists):
    """One list in which the members of each come in its order."""
    before = {}
    for one in lists:
        for n, member in enumerate(one):
            before.setdefault(member, set()).update(one[:n])
    order = []
    while before:
        free = next((member for member, earlier in before.items() if not earlier & before.keys()),
                    None)
        if free is None:
            raise Contradiction("two scenarios report the same figures in another order: "
                                + ", ".join(member[0] for member in before))
        del before[free]
        order.append(free)
    return order


def other_axis(text):
    """The text of axis Y from that of X."""
    text = re.sub(r"^x\.", "y.", re.sub(r"\bX\b", "Y", text))
    return re.sub(r"\bx\b", "y", text)


def both_axes(rows):
    """Rows of X and Y that differ in their axis only are one; they must come in the same order."""
    known = set(rows)
    pairs = {row: tuple(map(other_axis, row)) for row in rows if row[0].startswith("x.")}
    pairs = {x: y for x, y in pairs.items() if y in known}
    ys = set(pairs.values())
    if [row for row in rows if row in ys] != list(pairs.values()):
        raise Contradiction("the figures of Y are in another order than those of X")
    return [(f"[x.|y.]{row[0][2:]}", *(re.sub(r"\bX\b", "[X|Y]", cell) for cell in row[1:]))
            if row in pairs else row for row in rows if row not in ys]


def numbered(rows):
    """Rows that differ in a number only are one: "period [1..8]", "rate [1000, 2000]"."""
    def key(row):
        return tuple(re.sub(r"\d+", "#", cell) for cell in row[:2]) + row[2:]

    def counted(texts):
        def span(numbers):
            counts = [int(n) for n in numbers]
            if len(set(counts)) == 1:
                return numbers[0]
            if counts == list(range(counts[0], counts[0] + len(counts))):
                return f"[{counts[0]}..{counts[-1]}]"
            return f"[{', '.join(numbers)}]"

        spans = map(span, zip(*(re.findall(r"\d+", text) for text in texts), strict=True))
        return re.sub(r"\d+", lambda _: next(spans), texts[0])

    left = []
    for _, same in itertools.groupby(rows, key):
        group = list(same)
        left.append((*(counted([row[n] for row in group]) for n in range(2)), *group[0][2:]))
    return left


def listed(names, everything, machine):
    """"all", or which; a scenario's name without that of its machine."""
    short = [re.sub(rf"^{machine}-", "", name) for name in everything if name in names]
    if len(short) == len(everything):
        return "all"
    if len(short) > len(everything) / 2:
        return "all but " + ", ".join(re.sub(rf"^{machine}-", "", name) for name in everything
                                      if name not in names)
    return ", ".join(short) or "none"


def rows_of(runs, cuts, machine):
    """(id, meaning, unit, digits, tile, scenarios) in order, from {scenario: figures}."""
    common = general(shape(one) for found in (runs, cuts) for own in found.values() for one in own)

    def within(found, row):
        """Scenarios that print a figure, and that hide it."""
        sets = set(), set()
        for name, own in found.items():
            for one in own:
                if common[shape(one)] == row:
                    sets[one.get("shown") is False].add(name)
        return sets

    def text(sets):
        printed, hidden = (listed(names, list(runs), machine) for names in sets)
        return printed if hidden == "none" else (
            f"{printed}; hidden: {hidden}" if printed != "none" else f"hidden: {hidden}")

    rows = []
    for row in merged([[common[shape(one)] for one in own]
                       for found in (runs, cuts) for own in found.values()]):
        whole, cut = within(runs, row), within(cuts, row)
        rows.append((*row, text(whole) + ("" if cut == whole else f"; cut: {text(cut)}")))
    return numbered(both_axes(rows))


def expected_rows(runs, machine):
    """(id, printed, expected, tolerance, source, scenarios)"""
    found = {}
    for name, own in runs.items():
        for one in own:
            if {"printed", "expected", "source"} & one.keys():
                row = (one["id"], *(f"{one[key]:.6g}" if key in one else ""
                                    for key in ("printed", "expected", "tolerance")),
                       one.get("source", ""))
                found.setdefault(row, set()).add(name)
    return [(*row, listed(names, list(runs), machine)) for row, names in found.items()]


def table(rows):
    def cell(text):
        return html.escape(text, quote=False).replace("|", "\\|")

    return "".join(f"| `{cell(row[0])}` | {' | '.join(map(cell, row[1:]))} |\n" for row in rows)


def machine_text(runs, cuts, machine):
    name = machine["name"]
    text = MACHINE.format(**machine) + table(rows_of(runs, cuts, name))
    expected = expected_rows(runs, name)
    return text + (EXPECTED.format(name=name) + table(expected) if expected else "")


def page(program):
    """The page, from runs of all scenarios; takes a quarter of a minute of processor time."""
    described = {one["name"]: one for one in machines.described(program)}
    keys = {name: {key["key"] for key in json.loads(subprocess.run(
        [program, "list", "keys", name, "--json"], capture_output=True, check=True).stdout)}
        for name in described}
    asked = []  # (machine, name, whether it is cut short, scenario, settings)
    for name in described:
        own = {scenario: [scenario] for scenario, of in machines.scenarios().items() if of == name}
        own |= {f"{scenario} {words}": [scenario, *words.split()] for scenario, all_words
                in machines.runs(name).get("figures", {}).items() for words in all_words}
        alone = ["compare=false"] if "compare" in keys[name] else []
        for label, (scenario, *settings) in own.items():
            for cut in ([], [f"run.max_s={CUT_S}"]):
                asked.append((name, label, bool(cut), scenario, alone + settings + cut))
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        found = list(pool.map(lambda one: figures(program, one[3], described[one[0]], one[4]),
                              asked))
    text = HEAD
    for name, machine in described.items():
        runs, cuts = ({one[1]: result for one, result in zip(asked, found, strict=True)
                       if one[0] == name and one[2] == short} for short in (False, True))
        text += machine_text(runs, cuts, machine)
    return text
