#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Make register block, C++ header and documentation from each rtl/chips/<chip>.rdl.

Writes rtl/chips/generated/<chip>_regs.sv and <chip>_regs_pkg.sv (PeakRDL, AXI4-Lite),
sw_nios/hal/generated/<chip>_regs.hpp, models/exact/chips/generated/<chip>_map.hpp and
docs/registers/<chip>.md.
With --check nothing is written; the exit code is 1 when an output is stale.
"""

import argparse
import pathlib
import re
import sys
import tempfile

try:
    from peakrdl_regblock import RegblockExporter
    from peakrdl_regblock.cpuif.axi4lite import AXI4Lite_Cpuif_flattened
    from peakrdl_regblock.udps import ALL_UDPS
    from systemrdl import RDLCompiler
    from systemrdl.node import FieldNode, RegfileNode, RegNode
except ImportError as error:
    sys.exit(f"gen_regs.py: {error.name} is missing: pip install -r scripts/requirements.txt")

ROOT = pathlib.Path(__file__).resolve().parent.parent
NOTE = "Generated from {source} by scripts/gen_regs.py; do not edit."


class Cpuif(AXI4Lite_Cpuif_flattened):
    """Port names of the house: s_axil_awvalid_i, s_axil_awready_o."""

    _inputs = {"awvalid", "awaddr", "awprot", "wvalid", "wdata", "wstrb", "bready",
               "arvalid", "araddr", "arprot", "rready"}

    def signal(self, name: str) -> str:
        return f"s_axil_{name}_{'i' if name in self._inputs else 'o'}"


def camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def blocks(top):
    """(name, base, node) of each register file, then of the registers of the map itself."""
    for child in top.children():
        if isinstance(child, RegfileNode):
            yield child.inst_name, child.absolute_address, child
    yield "system", 0, top


def registers(node):
    return [child for child in node.children() if isinstance(child, RegNode)]


def encodings(top):
    found = {}
    for node in top.descendants():
        if isinstance(node, FieldNode) and node.get_property("encode"):
            encode = node.get_property("encode")
            found[encode.type_name] = encode
    return found.values()


def distinct_blocks(top):
    """Register files of one type share their offsets: each type once."""
    seen = set()
    for name, base, node in blocks(top):
        kind = node.type_name if isinstance(node, RegfileNode) else "system"
        if kind not in seen:
            seen.add(kind)
            yield kind, node


def field_constants(reg):
    """One-bit fields are masks under their own name; wider ones have a shift and a mask."""
    fields = list(reg.fields())
    if len(fields) == 1 and fields[0].low == 0 and fields[0].inst_name in ("value", "key"):
        return
    for field in fields:
        name = f"k{camel(reg.inst_name)}{camel(field.inst_name)}"
        mask = ((1 << field.width) - 1) << field.low
        if field.width == 1:
            yield name, f"0x{mask:X}u"
        else:
            yield f"{name}Shift", f"{field.low}u"
            yield f"{name}Mask", f"0x{mask:08X}u"


def constant(name: str, value: str, comment: str = "") -> str:
    line = f"inline constexpr std::uint32_t {name} = {value};"
    return f"{line}  // {comment}" if comment and len(line) + len(comment) < 95 else line


def constants(top) -> list:
    """Addresses, bits and encodings as C++ lines."""
    lines = []
    for name, base, node in blocks(top):
        if node is not top:
            lines.append(constant(f"k{camel(name)}", f"0x{base:03X}u"))
    for kind, node in distinct_blocks(top):
        lines += ["", f"// {kind}"]
        for reg in registers(node):
            offset = reg.address_offset
            lines.append(constant(f"k{camel(reg.inst_name)}", f"0x{offset:02X}u"))
            lines += [constant(*pair) for pair in field_constants(reg)]
            fields = list(reg.fields())
            if all(not f.is_hw_writable and not f.is_sw_writable for f in fields):
                value = sum((f.get_property("reset") or 0) << f.low for f in fields)
                lines.append(constant(f"k{camel(reg.inst_name)}Value", f"0x{value:08X}u"))
    for encode in encodings(top):
        lines += ["", f"// {encode.type_name}"]
        for member in encode:
            name = f"k{camel(encode.type_name)}{camel(member.name)}"
            lines.append(constant(name, f"0x{member.value:X}u", member.rdl_desc))
    return lines


def header(top, note: str) -> str:
    space = f"trammel::sw::{top.inst_name}_regs"
    lines = [f"// {note}", "// SPDX-License-Identifier: Apache-2.0", "//",
             f"// Byte addresses and bits of the registers of {top.inst_name}: those of a file",
             "// are at base + offset, a system register at its own address.", "#pragma once", "",
             "#include <cstdint>", "", f"namespace {space} {{", "", *constants(top)]
    return "\n".join(lines + ["", f"}}  // namespace {space}", ""])


def bits(fields) -> str:
    return f"0x{sum(((1 << f.width) - 1) << f.low for f in fields):08X}u"


def stored(reg):
    """Row of the map: what a write does to a register; none where nothing is stored."""
    fields = [] if reg.external else list(reg.fields())
    plain = [f for f in fields if f.is_sw_writable and f.get_property("onwrite") is None]
    pulsed = [f for f in plain if f.get_property("singlepulse")]
    reset = sum((f.get_property("reset") or 0) << f.low for f in fields)
    if not plain and not reset:
        return
    yield (f"    {{0x{reg.absolute_address:03X}u, 0x{reset:08X}u, "
            f"{bits(f for f in plain if f not in pulsed)}, "
            f"{bits(f for f in plain if f.get_property('swwel'))}, {bits(pulsed)}}},"
            f"  // {'.'.join(reg.get_path_segments()[1:])}")


def twin_map(top, note: str) -> str:
    space = f"trammel::exact::{top.inst_name}_map"
    rows = [row for _, _, node in blocks(top) for reg in registers(node) for row in stored(reg)]
    lines = [f"// {note}", "// SPDX-License-Identifier: Apache-2.0", "//",
             f"// Registers of {top.inst_name} for its twin: names of the firmware's header, and",
             "// what a write does to the stored bits of each.", "#pragma once", "",
             "#include <array>", "#include <cstdint>", "", f"namespace {space} {{", "",
             *constants(top), "",
             "struct Register {",
             "  std::uint32_t address;",
             "  std::uint32_t reset;",
             "  std::uint32_t written;  // bits that keep what is written",
             "  std::uint32_t locked;   // of them, those that LOCK protects",
             "  std::uint32_t pulsed;   // bits that a written one sets for one clock",
             "};", "",
             f"inline constexpr std::array<Register, {len(rows)}> kRegisters{{{{", *rows, "}};"]
    return "\n".join(lines + ["", f"}}  // namespace {space}", ""])


def access(field) -> str:
    if field.get_property("onwrite") is not None and field.is_sw_writable:
        return "W1C"
    return {(True, True): "RW", (True, False): "R", (False, True): "W"}[
        field.is_sw_readable, field.is_sw_writable]


def document(top, note: str) -> str:
    lines = [f"<!-- {note} -->", f"# Registers of {top.inst_name}", "", top.get_property("desc"),
             ""]
    bases = [f"{name.upper()} 0x{base:03X}" for name, base, node in blocks(top)
             if node is not top]
    lines += [f"Bases: {', '.join(bases)}. " * bool(bases) + "Access W1C: write one to clear.", ""]
    for kind, node in distinct_blocks(top):
        lines += [f"## {kind}", "",
                  "| Offset | Register | Bits | Field | Access | Reset | Meaning |",
                  "|---|---|---|---|---|---|---|"]
        for reg in registers(node):
            head = f"| 0x{reg.address_offset:03X} | **{reg.inst_name.upper()}** |"
            lines.append(f"{head} | | | | {reg.get_property('desc') or ''} |")
            for field in reg.fields():
                reset = field.get_property("reset")
                bits = f"{field.high}..{field.low}" if field.width > 1 else f"{field.low}"
                lines.append(f"| | | {bits} | {field.inst_name} | {access(field)} | "
                             f"{'' if reset is None else reset} | "
                             f"{field.get_property('desc') or ''} |")
        lines.append("")
    for encode in encodings(top):
        lines += [f"## {encode.type_name}", "", "| Value | Name | Meaning |", "|---|---|---|"]
        lines += [f"| 0x{m.value:X} | {m.name.upper()} | {m.rdl_desc or ''} |" for m in encode]
        lines.append("")
    return "\n".join(lines)


def flatten(text: str, name: str) -> str:
    """Members of the internal struct <name> become signals <name>_<path>."""
    start = text.index("    typedef struct packed {", text.rindex("//---", 0, text.index(
        f"}} {name}_t;")))
    end = text.index(f"    {name}_t {name};\n")
    path, signals = [], {}
    for line in reversed(text[start:end].splitlines()[1:-1]):
        opened, leaf = re.match(r"\s*\} (\w+);", line), re.match(r"\s*logic (\[.*\] )?(\w+);", line)
        if opened:
            path.append(opened[1])
        elif leaf:
            signals[".".join([name, *path, leaf[2]])] = leaf[1] or ""
        else:
            path.pop()
    text = text[:start] + text[end + len(f"    {name}_t {name};\n"):]
    names = {old: old.replace(".", "_") for old in reversed(signals)}
    assert len(set(names.values())) == len(names)
    text = re.sub(rf"\b{name}(\.\w+)+", lambda match: names[match[0]], text)
    used = [old for old in names if len(re.findall(rf"\b{names[old]}\b", text)) > 1]
    for old in names:
        if old not in used:  # nothing but its own assignment
            text = re.sub(rf"^ +{names[old]} = .*\n", "", text, flags=re.M)
    declared = "".join(f"    logic {signals[old]}{names[old]};\n" for old in used)
    return text[:start] + declared + text[start:]


FIELD = re.compile(r"""    // Field: (?P<name>\S+)
    always_comb begin
        automatic logic \S+ next_c;
        automatic logic load_next_c;
        next_c = (?P<storage>\S+);
        load_next_c = '0;
(?P<body>(?:        .*\n)+?)        field_combo\S+ = next_c;
        field_combo\S+ = load_next_c;
    end
    always_ff @\(posedge clk_i\) begin
        if\(rst_i\) begin
            \S+ <= (?P<reset>\S+);
        end else begin
            if\(field_combo\S+\) begin
                .*
            end
        end
    end
""")
PLAIN = re.compile(r"""        if\((?P<strobe>decoded_reg_strb\S+) && decoded_req_is_wr"""
                   r"""(?P<lock> && \S+)?\) begin // SW write
            next_c = \(\S+ & ~decoded_wr_biten\[\d+:\d+\]\) \| """
                   r"""\(decoded_wr_data\[(?P<high>\d+):(?P<low>\d+)\] & \S+\);
            load_next_c = '1;
        end
""")


def byte_writes(storage: str, high: int, low: int):
    """An enable a byte, which flip-flops have; the exporter's masks cost a logic cell a bit."""
    for byte in range(low // 8, high // 8 + 1):
        last, first = min(high, 8 * byte + 7), max(low, 8 * byte)
        part = f"[{last - low}:{first - low}]" if high > low else ""
        yield (f"                if(decoded_wr_biten[{first}]) "
               f"{storage}{part} <= decoded_wr_data[{last}:{first}];\n")


def gather(text: str) -> str:
    """One process of all fields that software alone writes, skipped where no write comes.

    The exporter makes a next value and a load strobe of every field and a strobe of every
    register, and reads the map back, all in every clock: a third of the time of a simulation.
    """
    address = dict(re.findall(r"(decoded_reg_strb\S+) = cpuif_req_masked & \(cpuif_addr == (\S+)\)",
                              text))
    resets, writes = [], {}

    def rewrite(match):
        storage, body = match["storage"], match["body"]
        plain = PLAIN.fullmatch(body)
        if plain:
            resets.append(f"            {storage} <= {match['reset']};\n")
            key = address[plain["strobe"]] + ("" if not plain["lock"] else plain["lock"])
            writes.setdefault(key, []).extend(
                byte_writes(storage, int(plain["high"]), int(plain["low"])))
            return ""
        body = re.sub(r" +load_next_c = .*\n", "", body).replace("next_c =", f"{storage} <=")
        return (f"    // Field: {match['name']}\n    always_ff @(posedge clk_i) begin\n"
                f"        if(rst_i) begin\n            {storage} <= {match['reset']};\n"
                f"        end else {body.lstrip()}    end\n")

    begin = text.index("    // Field: ")
    text = FIELD.sub(rewrite, text)
    block = ("    // Fields that software alone writes\n    always_ff @(posedge clk_i) begin\n"
             "        if(rst_i) begin\n" + "".join(resets) +
             "        end else if(decoded_req && decoded_req_is_wr) begin\n" +
             "".join(f"            if(decoded_addr == {key}) begin\n{''.join(lines)}"
                     "            end\n" for key, lines in writes.items()) +
             "        end\n    end\n")
    text = text[:begin] + block + text[begin:]
    # The map is read back in the clock of an answer only.
    done = re.search(r" +readback_done = (.*);\n", text)
    text = text.replace(done[0], "")
    text = text.replace("    logic readback_done;\n",
                        f"    logic readback_done;\n    assign readback_done = {done[1]};\n")
    first, last = "        if(rd_mux_addr == ", "        readback_data = readback_data_var;\n"
    head, rest = text.split(first, 1)
    chain, tail = (first + rest).split(last, 1)
    # An answer's address is that of the read channel, without the choice between read and write.
    read = re.search(r"cpuif_addr = (\{axil_araddr.*\});", text)[1]
    head = head.replace("rd_mux_addr = decoded_req ? decoded_addr : pending_rd_addr;",
                        f"rd_mux_addr = external_pending ? pending_rd_addr : {read};")
    # One choice of many, not a chain of them.
    chain = re.sub(r"if\(rd_mux_addr == (\S+)\)", r"\1:", chain)
    chain = re.sub("^", "        ", chain, flags=re.M).rstrip(" ")
    return (f"{head}        if(cpuif_rd_ack) begin\n            unique case(rd_mux_addr)\n{chain}"
            f"                default: ;\n            endcase\n        end\n{last}{tail}")


def unbundle(text: str, package: str) -> str:
    """Inputs read in processes become signals of their own, hwif_in_<path>."""
    types = {name: {member: kind for kind, member in re.findall(r"(\S.*?) (\w+);", body)}
             for body, name in re.findall(r"typedef struct \w*\s*\{([^}]*)\} (\w+);", package)}
    module = re.search(r"(\w+__in_t) hwif_in", text)[1]
    found = {}
    for path in re.findall(r"\bhwif_in((?:\.\w+)+)", text):
        kind = module
        for member in path[1:].split("."):
            kind = types[kind][member]
        width = sum(int(n) + 1 for n in re.findall(r"\[(\d+):0\]", kind)) or 1
        if kind in types:
            width = sum(1 + int((re.findall(r"\[(\d+):0\]", k) or ["0"])[0])
                        for k in types[kind].values())
        found["hwif_in" + path] = f"[{width - 1}:0] " if width > 1 else ""
    text = re.sub(r"\bhwif_in(\.\w+)+", lambda match: match[0].replace(".", "_"), text)
    lines = "".join(f"    logic {width}{name.replace('.', '_')};\n"
                    f"    assign {name.replace('.', '_')} = {name};\n"
                    for name, width in found.items())
    return text.replace(");\n", f");\n\n{lines}", 1)


def adapt(text: str, note: str, top, package: str) -> str:
    """House names of clock and reset; packed structs, which Verilator 5.006 needs; the keys."""
    text = re.sub(r"^// Generated by .*\n(//.*\n)*", "", text)
    text = re.sub(r"\bstruct \{", "struct packed {", text)
    for old, new in (("input wire clk,", "input wire clk_i,"), ("posedge clk)", "posedge clk_i)"),
                     ("input wire rst,", "input wire rst_i,"), ("if(rst)", "if(rst_i)")):
        text = text.replace(old, new)
    if re.search(r"^module", text, flags=re.M):
        text = gather(text)
        for name in ("decoded_reg_strb", "field_combo", "field_storage"):
            text = flatten(text, name)
        text = unbundle(text, package)
    constants = [
        f"    localparam logic [31:0] {camel(e.type_name)}{camel(m.name)} = 32'h{m.value:08X};"
        for e in encodings(top) if f"{e.type_name}_e;" not in text for m in e]
    text = re.sub(r"^endpackage", "\n".join(["", *constants, "endpackage"]), text, flags=re.M)
    text = "\n".join(line.rstrip() for line in text.splitlines()) + "\n"
    unused = ("UNUSEDSIGNAL", "UNUSEDPARAM")  # the generator's own helpers, not all needed here
    off, on = ("".join(f"// verilator lint_{what} {rule}\n" for rule in unused)
               for what in ("off", "on"))
    return f"// {note}\n// SPDX-License-Identifier: Apache-2.0\n{off}{text}{on}"


def generate(source: pathlib.Path) -> dict:
    chip = source.stem
    note = NOTE.format(source=source.relative_to(ROOT).as_posix())
    compiler = RDLCompiler()
    for udp in ALL_UDPS:
        compiler.register_udp(udp)
    compiler.compile_file(str(source))
    top = compiler.elaborate(top_def_name=chip).top
    outputs = {
        ROOT / f"sw_nios/hal/generated/{chip}_regs.hpp": header(top, note),
        ROOT / f"models/exact/chips/generated/{chip}_map.hpp": twin_map(top, note),
        ROOT / f"docs/registers/{chip}.md": document(top, note),
    }
    with tempfile.TemporaryDirectory() as folder:
        RegblockExporter().export(top, folder, cpuif_cls=Cpuif, module_name=f"{chip}_regs",
                                  package_name=f"{chip}_regs_pkg")
        for path in pathlib.Path(folder).glob("*.sv"):
            outputs[ROOT / "rtl/chips/generated" / path.name] = adapt(
                path.read_text(), note, top,
                pathlib.Path(folder, f"{chip}_regs_pkg.sv").read_text())
    return outputs


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare only; 1 when stale")
    check, stale = parser.parse_args().check, 0
    for source in sorted((ROOT / "rtl/chips").glob("*.rdl")):
        for path, text in generate(source).items():
            if path.exists() and path.read_text() == text:
                continue
            stale += 1
            if not check:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            print(f"{'stale' if check else 'wrote'} {path.relative_to(ROOT)}")
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
