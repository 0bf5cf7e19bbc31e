# SPDX-License-Identifier: Apache-2.0
"""The C++ header that reads what the registers hold in a verilated chip, for triggers."""

from trammel_tools.generate import register_map
from trammel_tools.generate.register_map import mask


def verilated(path):
    """The name of a signal in a verilated model."""
    return path.replace(".", "__DOT__").replace("[", "__BRA__").replace("]", "__KET__")


def held(field, number):
    """(whether it is in the register block, its path there or in the chip) of the signal that holds
    what a field shows, or None; `number` is that of its register file."""
    reg, block, top = field.parent, field.parent.parent, field.owning_addrmap
    source = field.get_property("rtl_source")
    if source and block is not top:
        source = f"{block.get_property('rtl_instance').replace('#', str(number))}.{source}"
    if source:
        return False, verilated(source)
    if reg.external or not field.implements_storage or not field.is_sw_readable:
        return None
    return True, "_".join(field.get_path_segments()[1:])


def value(word):
    """What reads a field; None where nothing in the chip holds it."""
    signals = [held(field, number) for number, field in enumerate(word.nodes)]
    if None in signals:
        return None
    (stored, path), *others = signals
    if not others:
        return f"{'TRAMMEL_STORED' if stored else 'TRAMMEL_HELD'}({path})"
    if stored:
        return f"TRAMMEL_STORED_OF_AXIS({path.partition('_')[2]})"
    axis = verilated(word.nodes[0].parent.parent.get_property("rtl_instance").replace("#", "0"))
    return f"TRAMMEL_HELD_OF_AXIS({path.removeprefix(axis + '__DOT__')})"


def whole(word, fields):
    """What reads a register of several fields."""
    return [f"({value(part)} & 0x{mask([field]) >> field.low:X}u) << {field.low}"
            for part in fields if part.reg.get_path() == word.reg.get_path()
            for field in part.nodes[:1]]


def readings(top):
    """Rows of the table: what a trigger may name, in order."""
    rows = []
    fields = list(register_map.fields(top))
    for n, word in enumerate(fields):
        if value(word) and not word.nodes[0].get_property("unwatched"):
            rows.append((word, f"    {{kFields[{n}], TRAMMEL_READ({value(word)})}},"))
    for n, word in enumerate(register_map.whole_words(top)):
        parts = whole(word, fields)
        lines = [f"                     {part} |" for part in parts]
        lines[-1] = lines[-1].removesuffix(" |") + ")},"
        lines[0] = f"    {{kWords[{n}], TRAMMEL_READ({parts[0]} |"
        rows.append((word, "\n".join(lines)))
    rows.sort(key=lambda row: (not row[0].of_axis, row[0].reg.address_offset, "." in row[0].name))
    return [line for _, line in rows]


MACROS = """// A signal of the chip and a field of the register block, each also of an axis.
#define TRAMMEL_HELD(path) root.{chip}__DOT__##path
#define TRAMMEL_STORED(path) root.{chip}__DOT__u_regs__DOT__field_storage_##path##_value
#define TRAMMEL_HELD_OF_AXIS(path) \\
  (axis == 0 ? TRAMMEL_HELD({x}__DOT__##path) \\
             : TRAMMEL_HELD({y}__DOT__##path))
#define TRAMMEL_STORED_OF_AXIS(path) \\
  (axis == 0 ? TRAMMEL_STORED(x_##path) : TRAMMEL_STORED(y_##path))
#define TRAMMEL_READ(value) \\
  [](const Root& root, [[maybe_unused]] int axis) -> std::uint32_t {{ return value; }}"""
NAMES = ("READ", "STORED_OF_AXIS", "HELD_OF_AXIS", "STORED", "HELD")


def macros(top):
    instances = {block.get_property("rtl_instance") for word in register_map.fields(top)
                 for block in [word.nodes[0].parent.parent] if block is not top}
    instance = instances.pop()
    x, y = (verilated(instance.replace("#", n)) for n in "01")
    return MACROS.format(chip=top.inst_name, x=x, y=y).split("\n")


def header(top, note):
    """None where the map names no signals of the chip."""
    if not any(word.nodes[0].get_property("rtl_source") for word in register_map.fields(top)):
        return None
    space = f"trammel::{top.inst_name}_regs"
    rows = readings(top)
    head = (f"What the registers of a verilated {top.inst_name} hold: storage of the register "
            "block, and the signals that the hardware shows in the others.")
    return "\n".join([
        *register_map.file_head(note, head),
        f'#include "rtl/chips/generated/{top.inst_name}_regs.hpp"', "", f"namespace {space} {{", "",
        *macros(top), "", "// What a trigger may name, and its bits.", "template <class Root>",
        "struct Reading {", "  const Field& field;",
        "  std::uint32_t (*read)(const Root& root, int axis);", "};", "", "template <class Root>",
        f"inline constexpr std::array<Reading<Root>, {len(rows)}> kReadings{{{{", *rows, "}};", "",
        *(f"#undef TRAMMEL_{name}" for name in NAMES), "",
        f"}}  // namespace {space}", ""])
