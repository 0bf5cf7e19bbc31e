# SPDX-License-Identifier: Apache-2.0
"""The C++ header of a register map: plain constants for firmware, twin, triggers and tests."""

import json
import textwrap

from trammel_tools.generate import register_map
from trammel_tools.generate.register_map import camel, mask

ACCESS = {"R": "kRead", "W": "kWrite", "RW": "kReadWrite", "W1C": "kWriteOneToClear"}
TYPES = """enum class Access { kRead, kWrite, kReadWrite, kWriteOneToClear };

// A register at its own address, and what a read and a write do to its bits.
struct Register {
  const char* name;  // "x.CTRL", "TICK"
  std::uint32_t address;
  std::uint32_t reset;
  std::uint32_t readable;
  std::uint32_t written;  // bits that keep what is written
  std::uint32_t locked;   // of them, those that LOCK protects
  std::uint32_t cleared;  // bits that a written one clears
  std::uint32_t pulsed;   // bits that a written one sets for one clock
};

// Bits of a register, and the number in them.
struct Field {
  const char* name;  // "CTRL.enable"; a register of one field has its name alone
  const char* help;
  std::uint32_t address;  // of its register; in a register file, an offset
  int shift;
  int width;
  int bits;  // of the number: bits of the field above repeat its sign, or are 0
  bool is_signed;
  bool of_axis;  // each register file has one
  Access access;
};
"""


def field_constants(reg):
    """One-bit fields are masks under their own name; wider ones have a shift and a mask."""
    fields = list(reg.fields())
    if len(fields) == 1 and fields[0].low == 0 and fields[0].inst_name in ("value", "key"):
        return
    for field in fields:
        name = f"k{camel(reg.inst_name)}{camel(field.inst_name)}"
        if field.width == 1:
            yield name, f"0x{mask([field]):X}u"
        else:
            yield f"{name}Shift", f"{field.low}u"
            yield f"{name}Mask", f"0x{mask([field]):08X}u"


def constant(name, value, comment=""):
    line = f"inline constexpr std::uint32_t {name} = {value};"
    return f"{line}  // {comment}" if comment and len(line) + len(comment) < 95 else line


def paragraph(pairs):
    """Constants of one register."""
    whole = ", ".join(f"{name}~=~{value}" for name, value in pairs)
    return textwrap.fill(f"inline constexpr std::uint32_t {whole};", 100,
                         subsequent_indent="    ").replace("~", " ").split("\n")


def constants(top):
    """Addresses, bits and encodings as C++ lines."""
    lines = [constant(f"k{camel(name)}", f"0x{base:03X}u")
             for name, base, node in register_map.blocks(top) if node is not top]
    for kind, nodes in register_map.distinct_blocks(top):
        lines += [""] * bool(lines) + [f"// {kind}"]
        for reg in register_map.registers(nodes[0]):
            name = f"k{camel(reg.inst_name)}"
            found = [(name, f"0x{reg.address_offset:02X}u"), *field_constants(reg)]
            if all(not f.is_hw_writable and not f.is_sw_writable for f in reg.fields()):
                found.append((f"{name}Value", f"0x{register_map.reset(reg):08X}u"))
            lines += paragraph(found)
    for encode in register_map.encodings(top):
        lines += ["", f"// {encode.type_name}"]
        for member in encode:
            name = f"k{camel(encode.type_name)}{camel(member.name)}"
            lines.append(constant(name, f"0x{member.value:X}u", member.rdl_desc))
    return lines


def register_row(reg, file):
    """Of an external register nothing is kept in the register block."""
    kept = [] if reg.external else [f for f in reg.fields() if f.is_sw_writable]
    plain = [f for f in kept if f.get_property("onwrite") is None]
    pulsed = [f for f in plain if f.get_property("singlepulse")]
    columns = [reg.absolute_address, 0 if reg.external else register_map.reset(reg),
               mask(f for f in reg.fields() if f.is_sw_readable),
               mask(f for f in plain if f not in pulsed),
               mask(f for f in plain if f.get_property("swwel")),
               mask(f for f in kept if f not in plain), mask(pulsed)]
    name = f"{file}.{reg.inst_name.upper()}".removeprefix("system.")
    address, *bits = columns
    return f'    {{"{name}", 0x{address:03X}u, {", ".join(f"0x{b:08X}u" for b in bits)}}},'


def register_rows(top):
    found = [(reg, name) for name, _, node in register_map.blocks(top)
             for reg in register_map.registers(node)]
    return [register_row(*pair) for pair in sorted(found, key=lambda p: p[0].absolute_address)]


def remark(*nodes):
    """The first description as the end of a line of help."""
    text = next((node.get_property("desc") for node in nodes if node.get_property("desc")), "")
    text = " ".join(text.split()).removesuffix(".")
    return text[0].lower() + text[1:] if text[1:2].islower() or text[1:2] == " " else text


def table_row(word, low, width, bits, is_signed, access):
    help_text = remark(word.nodes[0], word.reg)
    return (f"    {{{json.dumps(word.name)}, {json.dumps(help_text)}, "
            f"0x{word.reg.address_offset:02X}u, {low}, {width}, {bits}, "
            f"{'true' if is_signed else 'false'}, {'true' if word.of_axis else 'false'}, "
            f"Access::{ACCESS[access]}}},")


def field_row(word):
    field = word.nodes[0]
    return table_row(word, field.low, field.width, field.get_property("number_bits") or field.width,
                     field.get_property("twos_complement"), register_map.access(field))


def whole_row(word):
    width = max(field.high for field in word.reg.fields()) + 1
    writable = any(field.is_sw_writable for field in word.reg.fields())
    return table_row(word, 0, width, width, False, "RW" if writable else "R")


def table(kind, name, rows):
    rows = list(rows)
    return [f"inline constexpr std::array<{kind}, {len(rows)}> {name}{{{{", *rows, "}};", ""]


def header(top, note):
    space = f"trammel::{top.inst_name}_regs"
    whole = [whole_row(word) for word in register_map.whole_words(top)]
    head = (f"Registers of {top.inst_name}: addresses in bytes, bits, and what reads and writes "
            "do. Those of a register file are at base + offset, a system register at its own "
            "address.")
    lines = [*register_map.file_head(note, head),
             f"namespace {space} {{", "", *constants(top), "", TYPES,
             "// By address.", *table("Register", "kRegisters", register_rows(top)),
             *table("Field", "kFields", map(field_row, register_map.fields(top)))]
    if whole:
        lines += ["// Registers of several fields as one number.", *table("Field", "kWords", whole)]
    return "\n".join([*lines, f"}}  // namespace {space}", ""])
