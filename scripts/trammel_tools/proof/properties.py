# SPDX-License-Identifier: Apache-2.0
"""Reads rtl/<layer>/<block>_props.sv: its promises, covers, negative controls and options; and the
sentence of each promise on the block's page."""

import re
from dataclasses import dataclass, field

from trammel_tools.paths import ROOT, block_file, block_of, rtl_files
from trammel_tools.proof import seeded_bugs
from trammel_tools.proof.seeded_bugs import SeededBug


class PropertiesError(Exception):
    """What is wrong with a properties file or with what the tools said of it; one line."""


@dataclass
class Properties:
    block: str  # layer/stem
    assertions: list[str] = field(default_factory=list)
    helpers: list[str] = field(default_factory=list)  # inv_*: they only help the proof
    covers: list[str] = field(default_factory=list)
    seeded_bugs: list[SeededBug] = field(default_factory=list)
    complaints: list[tuple[int, str]] = field(default_factory=list)  # (line, what a control lacks)
    cut: list[str] = field(default_factory=list)  # modules whose outputs are free
    free: list[str] = field(default_factory=list)  # cell types whose outputs are free
    configurations: list[list[str]] = field(default_factory=list)  # of Name=value
    depth: int = 4  # of the induction, in clocks
    frames: int = 100  # depth of the search for covers and refutations
    begin: int = 0  # first clock of the search for refutations
    leap: list[str] = field(default_factory=list)  # labels on which the leap of a chip rests

    @property
    def stem(self):
        return self.block.split("/")[1]

    @property
    def path(self):
        return block_file(self.block, "_props.sv")

    @property
    def all_assertions(self):
        return self.assertions + self.helpers


def blocks():
    """Every block that has a properties file."""
    return sorted(block_of(p).removesuffix("_props") for p in rtl_files("*_props.sv"))


def read(block):
    """Labels, negative controls and options of rtl/<block>_props.sv."""
    props = Properties(block)
    where = props.path.relative_to(ROOT)
    text = props.path.read_text(encoding="utf-8")
    code = "\n".join(line.split("//")[0] for line in text.split("\n"))
    read_labels(props, code, where)
    for number, line in enumerate(text.split("\n"), 1):
        comment = re.match(r"\s*// (breaks|prove)\b(.*)$", line)
        if comment and comment[1] == "breaks":
            read_seeded_bug(props, comment[2], number)
        elif comment:
            read_option(props, comment[2], f"{where}:{number}")
    if not props.assertions:
        raise PropertiesError(f"{where}: promises nothing")
    for label in props.leap:
        if label not in props.all_assertions:
            raise PropertiesError(f"{where}: prove: leap: no assertion {label}")
    labels = props.all_assertions + props.covers
    for label in labels:
        if labels.count(label) > 1:
            raise PropertiesError(f"{where}: label {label} twice")
    return props


def read_labels(props, code, where):
    for label, kind in re.findall(r"(\w+)\s*:\s*(assert|cover)\s*\(", code):
        if (kind == "cover") != label.startswith("reaches_"):
            raise PropertiesError(f"{where}: {label}: covers, and only they, are named reaches_...")
        wanted = props.covers if kind == "cover" else (
            props.helpers if label.startswith("inv_") else props.assertions)
        wanted.append(label)
    if re.search(r"\bassume\b", code):
        raise PropertiesError(f"{where}: no assume; make the restriction an antecedent")
    if re.search(r"\b(?:assert|cover)\s+(?:property|final)\b|\b(?:assert|cover)\s*#0", code):
        raise PropertiesError(f"{where}: immediate assertions only")
    if len(re.findall(r"\b(?:assert|cover)\b", code)) != (
            len(props.all_assertions) + len(props.covers)):
        raise PropertiesError(f"{where}: every assert and cover needs a label")


def read_seeded_bug(props, text, number):
    """A mistake in it does not hide the verdicts on the promises: it is reported after them."""
    try:
        bug = seeded_bugs.parse(text)
    except seeded_bugs.SeededBugError as error:
        props.complaints.append((number, str(error)))
        return
    for name in bug.assertions:
        if name not in props.assertions:
            props.complaints.append((number, f"the control is of no promise {name}"))
    bug.assertions = [name for name in bug.assertions if name in props.assertions]
    bug.module, bug.line = bug.module or props.stem, number
    props.seeded_bugs.append(bug)


def read_option(props, text, where):
    option, *words = text.removeprefix(":").split() or [""]
    if not words:
        raise PropertiesError(f"{where}: not `prove: option value`")
    match option:
        case "cut": props.cut += words
        case "leap": props.leap += words
        case "free": props.free += words
        case "set": props.configurations.append(words)
        case "depth": props.depth = int(words[0])
        case "frames": props.frames = int(words[0])
        case "from": props.begin = int(words[0])
        case _: raise PropertiesError(f"{where}: unknown option {option}")


def sentences(block):
    """{promise: sentence} of the list under `## Promises` on the block's page."""
    page = block_file(block, ".md").read_text(encoding="utf-8")
    _, _, after = page.partition("\n## Promises\n")
    section = after.split("\n## ")[0]
    items = re.findall(r"^[-*] `(\w+)`\s*[:=]\s*(.+(?:\n  .+)*)", section, re.M)
    return {name: " ".join(text.split()) for name, text in items}
