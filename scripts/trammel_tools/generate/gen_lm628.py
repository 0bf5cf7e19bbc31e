# SPDX-License-Identifier: Apache-2.0
"""Assemble rtl/motion/lm628_engine*.asm into rtl/pkg/lm628_code_pkg.sv.

usage: scripts/tool gen-lm628 [--check]     --check: write nothing, fail if the package is stale

Operations, conditions, sources, flags and their numbers are the enumerations of
rtl/pkg/lm628_pkg.sv; the program's own comments say how it is written.
"""

import re
import sys

from trammel_tools.paths import RTL

PACKAGE = RTL / "pkg" / "lm628_pkg.sv"
SOURCES = ["lm628_engine.asm", "lm628_engine_parts.asm", "lm628_engine_commands.asm"]
TARGET = RTL / "pkg" / "lm628_code_pkg.sv"
REGISTERS = 64
SAMPLE, COMMAND = 400, 127  # most clocks
PER_LINE = 8
ENTRIES = 0x22  # of boot and the commands
READERS = ("ld", "add", "sub", "mul", "div")  # of a register


class AsmError(Exception):
    """One line: where and what."""


def enumeration(text, name):
    """{item without its prefix, in snake case: number}."""
    body = re.search(r"typedef enum logic \[\d+:0\] \{([^}]*)\} " + name, text)[1]
    body = re.sub(r"//.*", "", body)
    items, number = {}, 0
    for item, value in re.findall(r"(\w+)\s*(?:=\s*\d+'d(\d+))?\s*(?:,|$)", body.strip()):
        number = int(value) if value else number
        words = re.findall(r"[A-Z][a-z0-9]*", item)
        items["_".join(words[1:]).lower()] = number
        number += 1
    return items


class Assembler:
    def __init__(self, package):
        self.ops = enumeration(package, "op_e")
        self.conds = enumeration(package, "cond_e")
        self.sources = enumeration(package, "source_e")
        self.exts = enumeration(package, "ext_e")
        self.flags = enumeration(package, "flag_e")
        self.registers, self.zeroed = {}, []
        self.labels, self.lines = {}, {}  # address -> (place, words)

    def read(self, edit=lambda text: text):
        texts = {name: edit((RTL / "motion" / name).read_text(encoding="utf-8"))
                 for name in SOURCES}
        lines = [(f"{name}:{number}", line) for name, text in texts.items()
                 for number, line in enumerate(text.split("\n"), 1)]
        address = 0
        for number, line in lines:
            code = line.split(";")[0].strip()
            label = re.match(r"(\w+):\s*", code)
            if label:
                if label[1] in self.labels:
                    raise AsmError(f"{number}: label {label[1]} twice")
                self.labels[label[1]] = address
                code = code[label.end():]
            words = code.split()
            if not words:
                continue
            match words[0]:
                case ".zero" | ".var":
                    for name in words[1:]:
                        self.registers[name] = len(self.registers)
                    if words[0] == ".zero":
                        self.zeroed += words[1:]
                case ".at":
                    if int(words[1], 0) < address:
                        raise AsmError(f"{number}: already at {address:#x}")
                    address = int(words[1], 0)
                case ".clear":
                    for name in self.zeroed:
                        self.lines[address] = (number, ["st", name])
                        address += 1
                case _:
                    self.lines[address] = (number, words)
                    address += 1
        if len(self.registers) > REGISTERS:
            raise AsmError(f"{len(self.registers)} registers, not {REGISTERS}")

    def find(self, table, name):
        if name not in table:
            raise AsmError(f"unknown name {name}")
        return table[name]

    def op(self, name, argument=0):
        return self.ops[name] << 12 | argument

    def condition(self, name):
        bit = re.fullmatch(r"bit(\d+)", name)
        if bit:
            return self.conds["bit"] + int(bit[1])
        if name in ("n", "z", "wrap", "take"):
            return self.conds[name]
        return self.conds["flag"] + self.find(self.flags, name)

    def word(self, words):
        name, rest = words[0], words[1:]
        match name, len(rest):
            case "jmp", 1: return 3 << 16 | self.find(self.labels, rest[0])
            case ("if" | "ifn"), 2:
                return (2 | (name == "if")) << 16 | self.condition(rest[0]) << 10 | \
                    self.find(self.labels, rest[1])
            case ("ld" | "add" | "sub" | "st"), 1:
                return self.op(name, self.find(self.registers, rest[0]))
            case ("mul" | "div"), 2:
                return self.op(name, int(rest[1]) - 1 << 6 | self.find(self.registers, rest[0]))
            case "shl", 1: return self.op("shl", int(rest[0]) - 1 << 6)
            case "num", 1: return self.op("in", self.sources["number"] << 9 | int(rest[0]))
            case "in", 1: return self.op("in", self.find(self.sources, rest[0]) << 9)
            case "ext", 1: return self.op("ext", self.find(self.exts, rest[0]))
            case ("set" | "clr"), 1:
                return self.op("flag", (name == "set") << 5 | self.find(self.flags, rest[0]))
            case "call", 1: return self.op("call", self.find(self.labels, rest[0]))
            case ("halt" | "shr8" | "toq" | "toq15" | "ret" | "out" | "reply"), 0:
                return self.op(name)
        raise AsmError(f"not an instruction: {' '.join(words)}")

    def longest(self, start):
        """Clocks from here to the end on the longest path: the program has no loops."""
        done = {}

        def clocks(address):
            if address not in done:
                done[address] = step(*self.lines[address][1], address=address)
            return done[address]

        def step(name, *rest, address):
            match name:
                case "halt" | "ret": return 1
                case "jmp": return 1 + clocks(self.labels[rest[0]])
                case "if" | "ifn":
                    return 1 + max(clocks(self.labels[rest[1]]), clocks(address + 1))
                case "call":
                    return 1 + clocks(self.labels[rest[0]]) + clocks(address + 1)
            return (int(rest[-1]) if name in ("mul", "div", "shl") else 1) + clocks(address + 1)

        return clocks(start)

    def check_reads(self):
        """A register is read as its instruction is fetched: a store of the clock before is not yet
        done then, and before the first one of a command or sample the register is not known."""
        for address, (number, words) in self.lines.items():
            reads = words[1] if words[0] in READERS else None
            if reads and (address < ENTRIES or address == self.labels["sample"]):
                raise AsmError(f"{number}: the first instruction of a command or sample reads "
                               f"{reads}; it may read no register")
            if reads and self.lines.get(address - 1, (0, []))[1] == ["st", reads]:
                raise AsmError(f"{number}: reads {reads} in the clock after its store; "
                               "one instruction must lie between")

    def assemble(self):
        code = [self.op("halt")] * (max(self.lines) + 1)
        for address, (number, words) in self.lines.items():
            try:
                code[address] = self.word(words)
            except AsmError as error:
                raise AsmError(f"{number}: {error}") from error
        return code


def package(assembler, code):
    backwards = code[::-1]  # a packed table, for slang reads it far faster: the last word first
    rows = [", ".join(f"18'h{word:05x}" for word in backwards[k:k + PER_LINE])
            for k in range(0, len(code), PER_LINE)]
    return (
        "// SPDX-License-Identifier: Apache-2.0. Generated by scripts/tool gen-lm628: "
        "do not edit.\n//\n"
        "// The program of motion/lm628_engine, see lm628_engine.asm there.\n\n"
        "package lm628_code_pkg;\n\n"
        f"  localparam int unsigned CodeSize = {len(code)};\n"
        f"  localparam logic [9:0] CodeSample = 10'h{assembler.labels['sample']:03x};\n\n"
        "  // The last word first.\n"
        "  localparam logic [CodeSize-1:0][17:0] Code = {\n    "
        + ",\n    ".join(rows) + "\n  };\n\nendpackage\n")


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    assembler = Assembler(PACKAGE.read_text(encoding="utf-8"))
    try:
        assembler.read()
        code = assembler.assemble()
        assembler.check_reads()
        sample = assembler.longest(assembler.labels["sample"])
        commands = max(assembler.longest(address) for address in range(1, 0x22)
                       if address in assembler.lines)
        if sample > SAMPLE or commands > COMMAND:
            raise AsmError(f"a sample takes {sample} clocks, a command {commands}")
    except AsmError as error:
        print(error, file=sys.stderr)
        return 1
    text = package(assembler, code)
    if "--check" in sys.argv[1:]:
        fresh = TARGET.exists() and TARGET.read_text(encoding="utf-8") == text
        if not fresh:
            print(f"{TARGET.name} is stale: run scripts/tool gen-lm628", file=sys.stderr)
        return 0 if fresh else 1
    TARGET.write_text(text, encoding="utf-8")
    print(f"wrote {TARGET.name}: {len(code)} instructions, "
          f"{len(assembler.registers)} registers; a sample takes {sample} clocks at most, "
          f"a command {commands}")
    return 0
