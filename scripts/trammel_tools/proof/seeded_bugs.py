# SPDX-License-Identifier: Apache-2.0
"""Negative controls: a change of one named thing of a module that must refute a promise.

  // breaks label, label (module): net = expression       readers of the net see this instead
  // breaks label: register <= expression                 the register loads this at each edge
  // breaks label: Constant = expression                  a parameter or localparam
  // breaks label: old => new                             a text of the module that occurs once

The module is the block unless it is named. The expression is SystemVerilog in the module's scope,
so it survives every edit that keeps the names in it. In it the net stands for what drives it in the
sources, the constant for its own expression, and `next` for what the register would load.
"""

import re
from dataclasses import dataclass

from trammel_tools.paths import ROOT, RTL, rtl_files
from trammel_tools.rtl import rewire

PORT = "logic [2047:0]"  # wider than any port that a control changes


class SeededBugError(Exception):
    """Why a control does not apply; one line."""


@dataclass
class SeededBug:
    assertions: list[str]
    module: str
    words: str
    line: int = 0
    name: str = ""  # of a net, register or constant; empty: a text
    sign: str = "=>"  # =, <= or =>
    old: str = ""  # of a text
    new: str = ""

    def changed(self):
        """({the module's file: its text instead}, lines of the Yosys script behind the reading)"""
        found = rtl_files(f"{self.module}.sv") or list(RTL.rglob(f"{self.module}.sv"))
        if not found:
            raise SeededBugError(f"there is no module {self.module} in rtl/")
        path, text = found[0], found[0].read_text(encoding="utf-8")
        where = path.relative_to(ROOT)
        if not self.name:
            if text.count(self.old) != 1:
                raise SeededBugError(f"its text occurs {text.count(self.old)} times in {where}, "
                                     "not once")
            return {path: text.replace(self.old, self.new)}, []
        first = re.match(r"\w+", self.name)[0]
        bare = re.sub(r"//.*", "", text)
        if not re.search(rf"\b{first}\b", bare):
            raise SeededBugError(f"{where} has no {first} any more")
        constant = find_constant(text, self.name) if self.sign == "=" else None
        if constant:
            begin, end = constant
            new = re.sub(rf"(?<![\w.]){self.name}\b", f"({text[begin:end].strip()})", self.new)
            return {path: text[:begin] + new + text[end:]}, []
        return {path: self.spliced(text)}, [f"rewire {self.name} {rewire.KINDS[self.sign]}"]

    def spliced(self, text, cut="", number=""):
        """The text with declarations of what rewire joins to the net, or to its cut as one of
        several changes, the number of which is `_` and digits."""
        before, value = rewire.BEFORE + cut, rewire.VALUE + cut + number
        name = "next" if self.sign == "<=" else self.name
        new = re.sub(rf"(?<![\w.]){re.escape(name)}(?!\w)", before, self.new)
        head, end, tail = text.rpartition("endmodule")
        # Of a port of an instance no type can be asked; rewire cuts it to its width.
        port = "." in self.name
        kind = PORT if port else f"type({self.name})"
        bits = PORT if port else f"logic [$bits({self.name})-1:0]"
        declared = f"  wire {kind} {before};\n"
        return (f"{head}{declared if declared not in text else ''}"
                f"  wire {bits} {value} = {new};\n{end}{tail}")


def find_constant(text, name):
    """(begin, end) of the expression of a parameter or localparam of the module, or nothing."""
    found = re.search(rf"\b(?:localparam|parameter)\b[^;=]*(?:=[^;]*?,\s*)?\b{name}\s*=", text)
    if not found:
        return None
    depth, end = 0, found.end()
    while depth or text[end] not in ",;)":
        depth += (text[end] in "([{") - (text[end] in ")]}")
        end += 1
    return found.end() + 1, end


def parse(text):
    """SeededBug of `label, label (module): change` with all its labels; SeededBugError."""
    found = re.match(r" ([\w, ]+?)(?: \((\w+)\))?: (.+)$", text)
    if not found:
        raise SeededBugError("not `breaks label: name = expression`")
    bug = SeededBug([n.strip() for n in found[1].split(",")], found[2] or "", found[3].strip())
    if " => " in bug.words:
        bug.old, bug.new = bug.words.split(" => ", 1)
        return bug
    change = re.match(r"([\w.\[\]]+) (<=|=) (.+)$", bug.words)
    if not change:
        raise SeededBugError(f"`{bug.words}` is not `name = expression`")
    bug.name, bug.sign, bug.new = change.groups()
    return bug
