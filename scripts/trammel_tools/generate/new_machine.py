# SPDX-License-Identifier: Apache-2.0
"""Start a new machine: a DC motor, a chip that drives it by PWM, and its firmware.

usage: scripts/tool new-machine NAME [--contract]

NAME is a lower-case word that the sources do not use yet. The machine builds, runs and reports, its
chip can be proven, and no existing file changes: CMake, the program and the scripts find a machine
by its folder. The chip is plain Verilog, and every clock of it is evaluated. With --contract it has
the ports of docs/leap.md; if the machine exists and its chip still is the plain one, only the files
of the chip are written again.

The files are made from scripts/machine_template. Exit codes: 0 written, 2 the name cannot be used.
"""

import re
import sys
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.check import check_layout
from trammel_tools.paths import ROOT

TEMPLATE = Path(__file__).resolve().parents[2] / "machine_template"
LONGEST = 12
# Words of C++ and SystemVerilog that cannot name anything and may not occur in the sources yet.
RESERVED = {"alignof", "asm", "compl", "export", "extern", "goto", "mutable", "register", "union",
            "volatile", "xor", "xnor", "wand", "wor", "tri", "supply", "primitive", "specify"}


class NameTaken(Exception):
    """Why a name cannot be that of a machine; one line."""


def rendered(name, contract):
    """{path in the repository: text} of a machine's files."""
    words = {"@name@": name, "@Name@": name.capitalize(), "@leap@": str(contract).lower()}

    def put(text):
        return re.sub(r"@\w+@", lambda found: words[found[0]], text)

    files = {}
    for folder in ("plain", "contract") if contract else ("plain",):
        base = TEMPLATE / folder
        for path in sorted(p for p in base.rglob("*") if p.is_file()):
            files[Path(put(str(path.relative_to(base))))] = put(path.read_text(encoding="ascii"))
    return files


def check_name(name):
    """Raises where the word means something already."""
    if not re.fullmatch(r"[a-z][a-z0-9]*", name) or len(name) > LONGEST:
        raise NameTaken(f"'{name}' is no name of a machine: a lower-case letter, then up to "
                        f"{LONGEST - 1} lower-case letters and digits")
    if name in RESERVED:
        raise NameTaken(f"'{name}' is a reserved word of C++ or SystemVerilog")
    if (ROOT / "machines" / name).exists():
        raise NameTaken(f"machines/{name} exists")
    word = re.compile(rf"\b{name}\b")
    for path in check_layout.tracked(ROOT):
        if path.suffix in check_layout.CODE and (word.search(str(path)) or word.search(
                (ROOT / path).read_text(encoding="utf-8", errors="replace"))):
            raise NameTaken(f"'{name}' is a word that {path} uses; take one that no source does")


def to_write(name, contract):
    """The files that are to be written. Raises where one would be lost."""
    files = rendered(name, contract)
    if contract and (ROOT / "machines" / name).exists():
        plain = rendered(name, False)
        files = {path: text for path, text in files.items() if text != plain.get(path)}
        if all((ROOT / path).exists() and (ROOT / path).read_text(encoding="utf-8") == text
               for path, text in files.items()):
            raise NameTaken(f"machines/{name} has the contract already")
        for path in files:
            there = (ROOT / path).exists()
            if there != (path in plain):
                raise NameTaken(f"{path} {'exists' if there else 'is missing'}: not the plain "
                                "machine that this tool wrote")
            if there and (ROOT / path).read_text(encoding="utf-8") != plain[path]:
                raise NameTaken(f"{path} was changed: the contract would undo that")
        return files
    check_name(name)
    for path in files:
        if (ROOT / path).exists():
            raise NameTaken(f"{path} exists")
    return files


def main():
    parser = python_tools.Parser(prog="scripts/tool new-machine", description=__doc__)
    parser.add_argument("name", metavar="NAME")
    parser.add_argument("--contract", action="store_true")
    arguments = parser.parse_args()
    try:
        files = to_write(arguments.name, arguments.contract)
    except NameTaken as error:
        print(f"new-machine: {error}", file=sys.stderr)
        return 2
    for path, text in files.items():
        (ROOT / path).parent.mkdir(parents=True, exist_ok=True)
        (ROOT / path).write_text(text, encoding="ascii")
        print(path)
    print(f"next: ./trammel run {arguments.name}-step", file=sys.stderr)
    return 0
