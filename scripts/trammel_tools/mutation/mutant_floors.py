# SPDX-License-Identifier: Apache-2.0
"""What the mutants of a block must come to: tests/mutants.toml, and for chips mutants.toml of their
machine or part; and docs/mutation.md, which shows them.

A mutant is identified by what it changes, not by a number or a hash, so its entry survives edits of
other lines.
"""

import json
import tomllib
from dataclasses import dataclass, field

from trammel_tools.mutation import mutants
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "mutation.md"
STRICT = {"drive", "sense", "bus"}  # what turns gates on and what it trusts
KINDS = ("promise", "equivalent", "left")
HEAD = "| block | at least | known survivors |\n|---|---|---|\n"


@dataclass
class Floors:
    """What the files say, by block, and what is wrong in them."""

    floor: dict[str, float] = field(default_factory=dict)  # per cent
    # {mutation: what is known of it}
    survivors: dict[str, dict[str, str]] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)

    def of(self, block):
        return self.floor.get(block, lowest(block))

    def known(self, block):
        return self.survivors.get(block, {})


def lowest(block):
    return 95.0 if block.split("/")[0] in STRICT else 90.0


def files():
    return [ROOT / "tests" / "mutants.toml", *sorted([*ROOT.glob("machines/*/mutants.toml"),
                                                      *ROOT.glob("parts/*/mutants.toml")])]


def read(blocks):
    """The floors of all files; `blocks` are those that may stand there."""
    found = Floors()
    for path in files():
        where = path.relative_to(ROOT)
        try:
            table = tomllib.loads(path.read_text(encoding="utf-8"))
            floor, survivors = table.get("floor", {}), table.get("survivors", {})
            known = {block: dict(rows) for block, rows in survivors.items()}
        except (OSError, tomllib.TOMLDecodeError, AttributeError, TypeError, ValueError) as error:
            found.wrong.append(f"{where}: {error}")
            continue
        found.wrong += [f"{where}: {key}: not floor or survivors"
                        for key in table.keys() - {"floor", "survivors"}]
        found.wrong += [f"{where}: {block}: there is no such block with a unit test"
                        for block in [*floor, *known] if block not in blocks]
        found.wrong += [f"{where}: {block}: it stands in two files"
                        for block in floor.keys() & found.floor.keys()]
        found.wrong += [f"{where}: {block}: {value}: a floor is {lowest(block):.0f} to 100 per cent"
                        for block, value in floor.items()
                        if not isinstance(value, int | float) or not lowest(block) <= value <= 100]
        found.floor |= floor
        found.survivors |= known
    return found


@dataclass
class Result:
    """What a campaign found; written to build/mutants/<block>/result.toml."""

    block: str
    mutants: int
    promise: list[dict] = field(default_factory=list)  # number, mutation, label
    equivalent: list[dict] = field(default_factory=list)  # number, mutation, proof
    left: list[dict] = field(default_factory=list)  # number, mutation, why

    @property
    def counted(self):
        return self.mutants - len(self.equivalent)

    @property
    def killed(self):
        return self.counted - len(self.left)

    @property
    def score(self):
        return 100.0 * self.killed / self.counted if self.counted else 100.0


def write(result):
    lines = [f"# Written by trammel verify --mutants {result.block}",
             f'source = "{mutants.source_hash(result.block)}"', f"mutants = {result.mutants}"]
    for kind in KINDS:
        for row in getattr(result, kind):
            lines += ["", f"[[{kind}]]"]
            # A JSON string of ASCII is a TOML string.
            lines += [f"{key} = {json.dumps(value)}" for key, value in row.items()]
    path = mutants.folder_of(result.block) / "result.toml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def proven_before(block):
    """{(number, mutation): row} of the equivalent mutants of an earlier campaign on this source."""
    path = mutants.folder_of(block) / "result.toml"
    if not path.exists():
        return {}
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    if table["source"] != mutants.source_hash(block):
        return {}
    return {(row["number"], row["mutation"]): row for row in table.get("equivalent", [])}


def tables(blocks):
    """The generated part of the page."""
    floors = read(blocks)
    text = HEAD + "".join(f"| {block} | {floors.of(block):.0f} % | {len(floors.known(block))} |\n"
                          for block in blocks if block in floors.floor)
    text += "\n## Survivors\n\n| block | mutant | found |\n|---|---|---|\n"
    return text + "".join(f"| {block} | {escaped(mutation)} | {why} |\n" for block in blocks
                          for mutation, why in floors.known(block).items())


def escaped(text):
    return text.replace("|", "\\|")


def problems(blocks):
    """Lines of what is wrong with the files of floors and the page."""
    yield from read(blocks).wrong
    if not PAGE.read_text(encoding="utf-8").endswith("\n" + tables(blocks)):
        yield f"{PAGE.relative_to(ROOT)} is older than the floors: trammel verify --page"


def write_page(blocks):
    """docs/mutation.md: new tables after its text."""
    text, _, _ = PAGE.read_text(encoding="utf-8").partition(HEAD)
    PAGE.write_text(text + tables(blocks), encoding="utf-8")
    return PAGE
