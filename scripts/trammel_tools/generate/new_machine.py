# SPDX-License-Identifier: Apache-2.0
"""Start a new machine: a DC motor, a chip that drives it by PWM, and its firmware.

usage: scripts/tool new-machine NAME [--contract]

NAME is a lower-case word that the sources do not use yet. The machine builds, runs and reports, its
chip can be proven, and no existing file changes: CMake, the program and the scripts find a machine
by its folder. The chip is plain Verilog, and every clock of it is evaluated. With --contract it has
the ports of docs/leap.md; if the machine exists and its chip still is the plain one, only the files
of the chip are written again.

The files are made from scripts/machine_template. A line after @p@ and a file with @p@ in its name
are of the plain chip alone, those with @c@ of the chip with the contract.

Exit codes: 0 written, 2 the name cannot be used.
"""

import re
import sys
from pathlib import Path

from trammel_tools import output_file, python_tools
from trammel_tools.check import check_layout
from trammel_tools.output_file import Refused
from trammel_tools.paths import ROOT

TEMPLATE = Path(__file__).resolve().parents[2] / "machine_template"
LONGEST = 12
# Words of C++ and SystemVerilog that cannot name anything and may not occur in the sources yet.
RESERVED = {"alignof", "asm", "compl", "export", "extern", "goto", "mutable", "register", "union",
            "volatile", "xor", "xnor", "wand", "wor", "tri", "supply", "primitive", "specify"}


def rendered(name, contract):
    """{path in the repository: text} of a machine's files."""
    words = {"@name@": name, "@Name@": name.capitalize(), "@leap@": str(contract).lower(),
             "@c@": "", "@p@": ""}
    own, other = ("@c@", "@p@") if contract else ("@p@", "@c@")

    def put(text):
        text = re.sub(f"^{other}.*\n", "", re.sub(f"^{own} ?", "", text, flags=re.M), flags=re.M)
        return re.sub(r"@\w+@", lambda found: words[found[0]], text)

    return {Path(put(str(path.relative_to(TEMPLATE)))): put(path.read_text(encoding="ascii"))
            for path in sorted(TEMPLATE.rglob("*")) if path.is_file() and other not in path.name}


def is_made(name):
    return output_file.is_there(ROOT / "machines" / name)


def check_name(name):
    """Raises where the word means something already."""
    if name in RESERVED:
        raise Refused(f"'{name}' is a reserved word of C++ or SystemVerilog")
    if is_made(name):
        raise Refused(f"machines/{name} exists")
    word = re.compile(rf"\b{name}\b")
    for path in check_layout.tracked(ROOT):
        if path.suffix in check_layout.CODE and (word.search(str(path)) or word.search(
                (ROOT / path).read_text(encoding="utf-8", errors="replace"))):
            raise Refused(f"'{name}' is a word that {path} uses; take one that no source does")


def text_of(path):
    """What a file of a machine says; None where there is none."""
    output_file.check(ROOT / path)  # a pipe has no end
    if not output_file.is_there(ROOT / path):
        return None
    return (ROOT / path).read_text(encoding="utf-8", errors="replace")


def add_contract(name):
    """The files written: those in which the chip differs. Raises where one would be lost."""
    plain = rendered(name, False)
    files = {path: text for path, text in rendered(name, True).items() if text != plain.get(path)}
    there = {path: text_of(path) for path in files}
    if there == files:
        raise Refused(f"machines/{name} has the contract already")
    for path, text in there.items():
        if (text is not None) != (path in plain):
            raise Refused(f"{path} {'is missing' if text is None else 'exists'}: not the plain "
                          "machine that this tool wrote")
        if text is not None and text != plain[path]:
            raise Refused(f"{path} was changed: the contract would undo that")
    output_file.create(ROOT, {path: text for path, text in files.items() if path not in plain})
    for path in plain.keys() & files.keys():
        output_file.replace(ROOT / path, files[path])
    return files


def write(name, contract):
    """The files written."""
    if not re.fullmatch(r"[a-z][a-z0-9]*", name) or len(name) > LONGEST:
        raise Refused(f"'{name}' is no name of a machine: a lower-case letter, then up to "
                      f"{LONGEST - 1} lower-case letters and digits")
    if contract and is_made(name):
        return add_contract(name)
    check_name(name)
    files = rendered(name, contract)
    output_file.create(ROOT, files)
    return files


def main():
    parser = python_tools.Parser(prog="scripts/tool new-machine", description=__doc__)
    parser.add_argument("name", metavar="NAME")
    parser.add_argument("--contract", action="store_true")
    arguments = parser.parse_args()
    try:
        files = write(arguments.name, arguments.contract)
    except Refused as error:
        return python_tools.refuse("new-machine", error)
    print("\n".join(map(str, files)))
    print(f"next: ./trammel run {arguments.name}-step", file=sys.stderr)
    return 0
