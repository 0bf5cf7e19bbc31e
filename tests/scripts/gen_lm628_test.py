#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that the assembler of the LM628's program refuses what its engine cannot read in time."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools.generate import gen_lm628

CASES = [  # what becomes what, and the complaint; none where it is right
    ("nothing", "", "", None),
    ("a load after its store", "st control", "st control\n ld control", "reads control in the"),
    ("a factor after its store", "st slow", "st slow\n mul slow 30", "reads slow in the"),
    ("another register after a store", "st slow", "st slow\n ld rest\n", None),
    ("the store again", "st slow", "st slow\n st slow\n ld rest\n ld slow\n", None),
    ("a store and a branch", "st slow", "st slow\n jmp there\nthere: ld slow", None),
    ("a sample that begins with a register", "sample: in count", "sample: ld count\n in count",
     "reads count; it may read no register"),
    ("a command that begins with a register", "jmp dfh", "add pos", "reads pos; it may read no"),
]


def complaint(old, new):
    assembler = gen_lm628.Assembler(gen_lm628.PACKAGE.read_text(encoding="utf-8"))
    try:
        assembler.read(lambda text: text.replace(old, new, 1) if old else text)
        assembler.assemble()
        assembler.check_reads()
    except gen_lm628.AsmError as error:
        return str(error)
    return None


def main():
    wrong = 0
    for name, old, new, wanted in CASES:
        said = complaint(old, new)
        if (said is None) != (wanted is None) or (wanted and wanted not in said):
            wrong += 1
            print(f"{name}: {said}")
    print(f"{len(CASES) - wrong} of {len(CASES)} cases")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
