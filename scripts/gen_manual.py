#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write what the programs say of themselves into docs/manual.md and docs/keys.md.

usage: gen_manual.py [--check] [--program FILE]

FILE is the built program, build/testbench/trammel unless given. Verbs come from its --help and
from `tools` in the launcher, each with its own --help; the parameters from `list keys`; the
registers from the page that gen_regs.py makes. In manual.md only the text between the lines
"<!-- begin NAME -->" and "<!-- end NAME -->" is replaced; keys.md is written whole.
--check writes nothing; exit 1 if a page is stale.

Exit codes: 0 ok, 1 stale or a verb without help, 2 usage, 3 the program is not built.
"""

import argparse
import ast
import html
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LAUNCHER = ROOT / "trammel"
MANUAL = ROOT / "docs" / "manual.md"
KEYS = ROOT / "docs" / "keys.md"
REGISTERS = ROOT / "docs" / "registers"

# Unit of a key by the end of its name; the longest fitting end counts.
UNITS = {"_m": "m", "_s": "s", "_kg": "kg", "_N": "N", "_V": "V", "_A": "A", "_H": "H",
         "_ohm": "ohm", "_ns": "ns", "_clk": "clocks", "_rad": "rad", "_rad_s": "rad/s",
         "_m_s": "m/s", "_N_s_m": "N s/m", "_N_A": "N/A", "_V_A": "V/A", "_counts": "counts",
         "_N_m": "N m", "_kg_m2": "kg m2", "_N_m_A": "N m/A", "_N_m_s": "N m s",
         "_ticks": "ticks", "_samples": "samples", "_bits": "bits"}

KEYS_HEAD = """<!-- Generated from `trammel list keys` by scripts/gen_manual.py; do not edit. -->
# Parameters

Every key of a scenario, of `-c FILE`, of `-s key=value`, and (in capitals, `_` for `.`, with
`TRAMMEL_` before it) of the environment. Where a name shows `[x.|y.]`, `gains.kp` sets both axes
and `gains.y.kp` one. Full scale of the words: [section 3](specification.md#3-number-formats).

First those of the machine kung, then [those of an693](#machine-an693).
"""
AN693_HEAD = """
# Machine an693

Keys of a scenario with `machine = "an693"`: [an693.md](an693.md).
"""


class NotSaid(Exception):
    """A command failed instead of saying what it was asked; one line."""


def said(*command):
    """What a command prints, in a fixed width."""
    environment = {**os.environ, "COLUMNS": "100", "NO_COLOR": "1", "TRAMMEL_VERBS": ""}
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False,
                          cwd=ROOT, env=environment)
    if done.returncode != 0:
        last = done.stderr.strip().rpartition("\n")[2]
        raise NotSaid(f"{' '.join(map(str, command))}: exit {done.returncode}: {last}")
    return done.stdout.rstrip()


def program_verbs(program):
    """Name and one line of each subcommand the program lists."""
    listing = said(program, "--help").partition("Subcommands:\n")[2].partition("\n\n")[0]
    return re.findall(r"^  (\S+)\s+(.*)$", listing, re.M)


def script_verbs():
    """The same of the launcher's scripts; a script that is not there yet is no verb."""
    names = re.search(r'^tools="([^"]*)"', LAUNCHER.read_text(encoding="utf-8"), re.M)[1].split()
    for script in (ROOT / "scripts" / f"{name}.py" for name in names):
        if script.exists():
            text = ast.get_docstring(ast.parse(script.read_text(encoding="utf-8")))
            yield script.stem, text.partition("\n\n")[0].replace("\n", " ").rstrip(".")


def fenced(text):
    lines = "\n".join(line.rstrip() for line in text.split("\n"))
    return f"```text\n{lines}\n```\n"


def verbs_text(program):
    own, scripts = program_verbs(program), list(script_verbs())
    text = "| verb | what |\n|---|---|\n"
    for name, what in [*own, ("test", "build and run all tests"), *scripts]:
        text += f"| [`{name}`](#{name}) | {html.escape(what, quote=False)} |\n"
    helps = {name: said(program, name, "--help") for name, _ in own}
    helps["test"] = said(LAUNCHER, "test", "--help")
    helps |= {name: said(sys.executable, ROOT / "scripts" / f"{name}.py", "--help")
              for name, _ in scripts}
    text += "\nOptions of every verb of the program:\n\n"
    text += fenced(said(program, "--help").partition("\n\n")[2].partition("\n\nSubcommands")[0])
    for name, help_text in helps.items():
        text += f"\n### {name}\n\n{fenced(help_text)}"
    return text


def registers_text():
    text = ""
    for page in sorted(REGISTERS.glob("*.md")):
        names = re.findall(r"^\| 0x[0-9A-F]+ \| \*\*(\w+)\*\*", page.read_text(), re.M)
        text += f"[{page.stem}](registers/{page.name}): {', '.join(names)}.\n"
    return text


def unit(name):
    last = re.sub(r"_(min|max)$", "", name.rsplit(".", 1)[-1])
    fitting = [end for end in UNITS if last.endswith(end)]
    return UNITS[max(fitting, key=len)] if fitting else ""


def keys_of(program, machine):
    return json.loads(said(program, "list", "keys", machine, "--json"))


def keys_text(program):
    return (KEYS_HEAD + sections_text(keys_of(program, "kung")) +
            AN693_HEAD + sections_text(keys_of(program, "an693")))


def sections_text(listed):
    rows = {}  # section -> key without its axis -> row
    for key in listed:
        section, _, name = key["key"].rpartition(".")
        head = section.split(".")[0] or "run"
        axis = re.search(r"\.([xy])$", section)
        shown = f"{head}.[x.\\|y.]{name}" if axis else key["key"]
        row = rows.setdefault(head, {}).setdefault(shown, {**key, "values": {}})
        row["values"][axis[1] if axis else ""] = key["default"]
    text = ""
    for section, keys in rows.items():
        text += f"\n## {section}\n\n| key | default | unit | range | meaning |\n"
        text += "|---|---|---|---|---|\n"
        for shown, row in keys.items():
            values = row["values"]
            same = len(set(values.values())) == 1
            default = (next(iter(values.values())) if same else
                       ", ".join(f"{axis} {value}" for axis, value in values.items()))
            cells = [default, unit(row["key"]), row["range"], row["help"]]
            cells = [html.escape(cell, quote=False).replace("|", "\\|") for cell in cells]
            text += f"| `{shown}` | {' | '.join(cells)} |\n"
    return text


def replaced(text, name, content):
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->\n"
    head, found, rest = text.partition(begin)
    _, closed, tail = rest.partition(end)
    if not found or not closed:
        raise NotSaid(f"no lines {begin.strip()} and {end.strip()}")
    return head + begin + content + end + tail


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if not program.exists():
        print(f"gen_manual: {program}: not built", file=sys.stderr)
        return 3
    manual = MANUAL.read_text(encoding="utf-8")
    try:
        manual = replaced(manual, "verbs", verbs_text(program))
        manual = replaced(manual, "registers", registers_text())
        keys = keys_text(program)
    except NotSaid as error:
        print(f"gen_manual: {error}", file=sys.stderr)
        return 1
    stale = False
    for page, text in ((MANUAL, manual), (KEYS, keys)):
        if page.exists() and page.read_text(encoding="utf-8") == text:
            continue
        name = page.relative_to(ROOT)
        if arguments.check:
            print(f"{name} is stale: scripts/gen_manual.py", file=sys.stderr)
            stale = True
        else:
            page.write_text(text, encoding="ascii")
            print(name)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
