# SPDX-License-Identifier: Apache-2.0
"""The register map of a chip, read from its SystemRDL: what gen_register_map's units share."""

import textwrap
from typing import NamedTuple

from peakrdl_regblock.udps import ALL_UDPS
from systemrdl import RDLCompiler
from systemrdl.node import FieldNode, RegfileNode, RegNode


def read(source):
    """The map of rtl/chips/<chip>.rdl."""
    compiler = RDLCompiler()
    for udp in ALL_UDPS:
        compiler.register_udp(udp)
    compiler.compile_file(str(source))
    return compiler.elaborate(top_def_name=source.stem).top


def camel(name):
    return "".join(part.capitalize() for part in name.split("_"))


def blocks(top):
    """(name, base, node) of each register file, then of the registers of the map itself."""
    for child in top.children():
        if isinstance(child, RegfileNode):
            yield child.inst_name, child.absolute_address, child
    yield "system", 0, top


def distinct_blocks(top):
    """(type, nodes): register files of one type share their offsets."""
    kinds = {}
    for _, _, node in blocks(top):
        kind = node.type_name if isinstance(node, RegfileNode) else "system"
        kinds.setdefault(kind, []).append(node)
    return kinds.items()


def registers(node):
    return [child for child in node.children() if isinstance(child, RegNode)]


class Word(NamedTuple):
    """A field, or a register as one number: in a register file once for all of its type."""

    name: str  # "CTRL.enable"; a register of one field has its name alone
    of_axis: bool
    nodes: tuple  # that of each register file

    @property
    def reg(self):
        node = self.nodes[0]
        return node.parent if isinstance(node, FieldNode) else node


def fields(top):
    for kind, files in distinct_blocks(top):
        for regs in zip(*map(registers, files), strict=True):
            for same in zip(*(reg.fields() for reg in regs), strict=True):
                name = regs[0].inst_name.upper()
                alone = len(list(regs[0].fields())) == 1
                yield Word(name if alone else f"{name}.{same[0].inst_name}", kind != "system", same)


def whole_words(top):
    for kind, files in distinct_blocks(top):
        for regs in zip(*map(registers, files), strict=True):
            if regs[0].get_property("whole_word"):
                yield Word(regs[0].inst_name.upper(), kind != "system", regs)


def encodings(top):
    found = {}
    for node in top.descendants():
        if isinstance(node, FieldNode) and node.get_property("encode"):
            encode = node.get_property("encode")
            found[encode.type_name] = encode
    return found.values()


def mask(fields):
    return sum(((1 << f.width) - 1) << f.low for f in fields)


def reset(reg):
    return sum((f.get_property("reset") or 0) << f.low for f in reg.fields())


def access(field):
    if field.get_property("onwrite") is not None and field.is_sw_writable:
        return "W1C"
    return {(True, True): "RW", (True, False): "R", (False, True): "W"}[
        field.is_sw_readable, field.is_sw_writable]


def file_head(note, text):
    """The first lines of a C++ header."""
    return [f"// {note}", "// SPDX-License-Identifier: Apache-2.0", "//",
            *textwrap.wrap(text, 100, initial_indent="// ", subsequent_indent="// "),
            "#pragma once", "", "#include <array>", "#include <cstdint>", ""]
