# SPDX-License-Identifier: Apache-2.0
"""The page of a register map, docs/registers/<chip>.md."""

from trammel_tools.generate import register_map


def field_row(field, head="| | |"):
    reset = field.get_property("reset")
    bits = f"{field.high}..{field.low}" if field.width > 1 else f"{field.low}"
    signed, own = field.get_property("twos_complement"), field.get_property("number_bits")
    number = " ".join([*(["signed"] if signed else []), *([str(own)] if own else [])])
    desc = " ".join(filter(None, (field.parent.get_property("desc") if "*" in head else "",
                                  field.get_property("desc")))).replace("|", "\\|")
    return (f"{head} {bits} | {field.inst_name} | {number} | {register_map.access(field)} | "
            f"{'' if reset is None else reset} | {desc} |")


def page(top, note):
    lines = [f"<!-- {note} -->", f"# Registers of {top.inst_name}", "", top.get_property("desc"),
             ""]
    bases = [f"{name.upper()} 0x{base:03X}" for name, base, node in register_map.blocks(top)
             if node is not top]
    lines += [f"Bases: {', '.join(bases)}. " * bool(bases) + "Access W1C: write one to clear. "
              "Number: two's complement if signed, and its bits if these are others.", ""]
    for kind, nodes in register_map.distinct_blocks(top):
        lines += [f"## {kind}", "",
                  "| Offset | Register | Bits | Field | Number | Access | Reset | Meaning |",
                  "|---|---|---|---|---|---|---|---|"]
        for reg in register_map.registers(nodes[0]):
            head = f"| 0x{reg.address_offset:03X} | **{reg.inst_name.upper()}** |"
            if len(fields := list(reg.fields())) == 1:
                lines.append(field_row(fields[0], head))
                continue
            lines.append(f"{head} | | | | | {reg.get_property('desc') or ''} |")
            lines += [field_row(field) for field in fields]
        lines.append("")
    for encode in register_map.encodings(top):
        lines += [f"## {encode.type_name}", "", "| Value | Name | Meaning |", "|---|---|---|"]
        lines += [f"| 0x{m.value:X} | {m.name.upper()} | {m.rdl_desc or ''} |" for m in encode]
        lines.append("")
    return "\n".join(lines)
