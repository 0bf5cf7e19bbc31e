# SPDX-License-Identifier: Apache-2.0
"""The C++ header that reads what the registers hold in a verilated chip, for triggers."""

from trammel_tools.generate import register_map
from trammel_tools.generate.register_map import mask


def verilated(path):
    """The name of a signal in a verilated model."""
    return path.replace(".", "__DOT__").replace("[", "__BRA__").replace("]", "__KET__")


def held(field, number):
    """The signal that holds what a field shows, or None; `number` is that of its register file."""
    reg, block, top = field.parent, field.parent.parent, field.owning_addrmap
    source = field.get_property("rtl_source")
    if source and block is not top:
        source = f"{block.get_property('rtl_instance').replace('#', str(number))}.{source}"
    if not source:
        if reg.external or not field.implements_storage or not field.is_sw_readable:
            return None
        source = f"u_regs.field_storage_{'_'.join(field.get_path_segments()[1:])}_value"
    return verilated(f"{top.inst_name}.{source}")


def function_name(word):
    return f"read_{word.name.lower().replace('.', '_')}"


def function(word, value):
    axis = "int axis" if word.of_axis else "int"
    return ["template <class Root>",
            f"std::uint32_t {function_name(word)}(const Root& root, {axis}) {{",
            f"  return {value};", "}", ""]


def field_function(word):
    """None where nothing in the chip holds the field."""
    signals = [held(field, number) for number, field in enumerate(word.nodes)]
    if None in signals:
        return None
    *others, last = [f"root.{signal}" for signal in signals]
    choice = "".join(f"axis == {n} ? {value}\n         : " for n, value in enumerate(others))
    return function(word, choice + last)


def whole_function(word, fields):
    parts = [f"({function_name(part)}(root, {'axis' if word.of_axis else 0}) & "
             f"0x{mask([field]) >> field.low:X}u) << {field.low}"
             for part in fields if part.reg.get_path() == word.reg.get_path()
             for field in part.nodes[:1]]
    return function(word, " |\n         ".join(parts))


def readings(top):
    """(functions, rows of the table)."""
    functions, rows = [], []
    fields = list(register_map.fields(top))
    for n, word in enumerate(fields):
        lines = field_function(word)
        if lines:
            functions += lines
            if not word.nodes[0].get_property("unwatched"):
                rows.append((word, f"kFields[{n}]"))
    for n, word in enumerate(register_map.whole_words(top)):
        functions += whole_function(word, fields)
        rows.append((word, f"kWords[{n}]"))
    rows.sort(key=lambda row: (not row[0].of_axis, row[0].reg.address_offset, "." in row[0].name))
    return functions, [f"    {{{place}, {function_name(word)}<Root>}}," for word, place in rows]


def header(top, note):
    """None where the map names no signals of the chip."""
    if not any(word.nodes[0].get_property("rtl_source") for word in register_map.fields(top)):
        return None
    space = f"trammel::{top.inst_name}_regs"
    functions, rows = readings(top)
    head = (f"What the registers of a verilated {top.inst_name} hold: storage of the register "
            "block, and the signals that the hardware shows in the others.")
    return "\n".join([
        *register_map.file_head(note, head),
        f'#include "rtl/chips/generated/{top.inst_name}_regs.hpp"', "", f"namespace {space} {{", "",
        *functions, "// What a trigger may name, and its bits.", "template <class Root>",
        "struct Reading {", "  const Field& field;",
        "  std::uint32_t (*read)(const Root& root, int axis);", "};", "", "template <class Root>",
        f"inline constexpr std::array<Reading<Root>, {len(rows)}> kReadings{{{{", *rows, "}};", "",
        f"}}  // namespace {space}", ""])
