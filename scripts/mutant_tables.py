# SPDX-License-Identifier: Apache-2.0
"""The checked-in result of a block's mutation, tests/mutants/<layer>/<block>.toml, and their page.

A table holds what is expensive to find or to argue: the equivalent mutants with their proof, those
that a promise refutes, those left; and a sample of the mutants that the unit test refuses.
"""

import json
import tomllib
from dataclasses import dataclass, field

import mutants
from properties import ROOT

FOLDER = ROOT / "tests" / "mutants"
PAGE = ROOT / "docs" / "mutation.md"
STRICT = {"drive", "sense", "bus"}  # what turns gates on and what it trusts
SAMPLE = 20
KINDS = ("promise", "equivalent", "left")

INTRODUCTION = """# Mutation scores

Written by `trammel verify --mutants`; the tables are in `tests/mutants/`.

A mutant is the block with one bit of one operator, register or instance port changed: stuck at 0
or 1, inverted, or inverted while another bit of that port is 0 or 1. Yosys picks {count} a block,
spread over its source lines, with a fixed seed. The block's unit test, unmodified, must refuse
each; what it accepts must break a promise of `<block>_props.sv`, or be proven equivalent to the
block: under any input, from the first reset on, all outputs equal in all clocks. Equivalent
mutants do not count: score = refused / (all - equivalent). What is undecided counts as accepted.

Blocks inside a block are not changed with it, they have scores of their own. The modules of a chip
are tested in the whole chip, with its test: both instances of `kung_axis` are the mutant. All
mutants of a module are one netlist with a selector, so it is compiled once.

Equivalent mutants come mostly from bits that cannot matter: the high bits of a wide sum before it
is cut, a selector's don't-care, a count that never gets that far. They are proven in two steps.
Block and mutant have the same registers: if equal registers always give equal outputs and equal
registers again, that is induction, and most need no more. Otherwise the registers that the mutation
reaches are doubled, the others shared, and abc looks for invariants of this product. Where the
netlist leaves a value unknown it is an input of both: the proof holds for any. Only the control,
the netlist with no mutant chosen against the block itself, takes 0 there.

| block | mutants | test | promises | equivalent | left | score | at least |
|---|---|---|---|---|---|---|---|
"""


@dataclass
class Table:
    block: str
    source: str  # mutants.source_hash
    mutants: int
    seed: int = mutants.SEED
    sample: list[int] = field(default_factory=list)  # refused by the unit test
    promise: list[dict] = field(default_factory=list)  # number, mutation, label
    equivalent: list[dict] = field(default_factory=list)  # number, mutation, proof
    left: list[dict] = field(default_factory=list)  # number, mutation, why

    @property
    def by_test(self):
        return self.mutants - len(self.promise) - len(self.equivalent) - len(self.left)

    @property
    def score(self):
        counted = self.mutants - len(self.equivalent)
        return 100.0 * (counted - len(self.left)) / counted if counted else 100.0

    @property
    def floor(self):
        return 95.0 if self.block.split("/")[0] in STRICT else 90.0


def path_of(block):
    return FOLDER / f"{block}.toml"


def write(table):
    lines = [f"# Written by trammel verify --mutants {table.block}",
             f'source = "{table.source}"', f"seed = {table.seed}", f"mutants = {table.mutants}",
             f"sample = {table.sample}"]
    for kind in KINDS:
        for row in getattr(table, kind):
            lines += ["", f"[[{kind}]]"]
            # A JSON string of ASCII is a TOML string.
            lines += [f"{key} = {json.dumps(value)}" for key, value in row.items()]
    path = path_of(table.block)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def read(block):
    """The table of a block; None when there is none."""
    path = path_of(block)
    if not path.exists():
        return None
    return Table(block, **tomllib.loads(path.read_text(encoding="utf-8")))


def problems(blocks):
    """One line a block whose table is stale or under its floor, or whose row of the page is old."""
    rows = []
    for block in blocks:
        table = read(block)
        again = f"run trammel verify --mutants {block}"
        if table is None:
            yield f"{block}: no table of mutants: {again}"
            continue
        rows.append(row(block, table))
        if table.source != mutants.source_hash(block):
            yield f"{block}: table is stale: {again}"
        if table.score < table.floor:
            yield f"{block}: score {table.score:.1f} %, at least {table.floor:.0f} %"
    page = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
    if not set(rows) <= set(page.split("\n")):
        yield f"{PAGE.relative_to(ROOT)} is older than the tables: trammel verify --page"


def row(block, table):
    if table is None:
        return f"| {block} | not measured | | | | | | |"
    return (f"| {table.block} | {table.mutants} | {table.by_test} | {len(table.promise)} "
            f"| {len(table.equivalent)} | {len(table.left)} | {table.score:.1f} % "
            f"| {table.floor:.0f} % |")


def write_page(blocks):
    """docs/mutation.md: scores, and every mutant that is left."""
    text = INTRODUCTION.format(count=mutants.COUNT)
    text += "".join(row(block, read(block)) + "\n" for block in blocks)
    tables = [table for table in map(read, blocks) if table]
    rows = [f"| {table.block} | {mutant['mutation'].replace('|', chr(92) + '|')} | "
            f"{mutant['why']} |\n" for table in tables for mutant in table.left]
    if rows:
        text += ("\n## Left\n\nNeither refused nor proven equivalent.\n\n"
                 "| block | mutant | found |\n")
        text += "|---|---|---|\n" + "".join(rows)
    PAGE.write_text(text, encoding="utf-8")
    return PAGE
