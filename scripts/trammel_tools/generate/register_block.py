# SPDX-License-Identifier: Apache-2.0
"""The register block of a chip, rtl/chips/generated/<chip>_regs.sv and its package: the export of
PeakRDL, with this project's names and in the form that simulates and synthesizes best."""

import re
import tempfile
import textwrap
from pathlib import Path

from peakrdl_regblock import RegblockExporter
from peakrdl_regblock.cpuif.axi4lite import AXI4Lite_Cpuif_flattened

from trammel_tools.generate import register_map


class Cpuif(AXI4Lite_Cpuif_flattened):
    """Port names of this project: s_axil_awvalid_i, s_axil_awready_o."""

    _inputs = {"awvalid", "awaddr", "awprot", "wvalid", "wdata", "wstrb", "bready",
               "arvalid", "araddr", "arprot", "rready"}

    def signal(self, name: str) -> str:
        return f"s_axil_{name}_{'i' if name in self._inputs else 'o'}"


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
    """An enable per byte, which flip-flops have; the exporter's masks cost a logic cell per bit."""
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
    lines = "".join(f"    wire {width}{name.replace('.', '_')} = {name};\n"
                    for name, width in found.items())
    return text.replace(");\n", f");\n\n{lines}", 1)


DECLARED = re.compile(r"( +logic (?:\[\d+:\d+\] )?)(\w+);")
ASSIGNED = re.compile(r"( +)([\w\[\]:]+ (?:<=|\|?=) [\w']+;)")


def paragraphs(text: str) -> str:
    """Declarations of one type, and plain assignments, that follow each other share lines."""
    lines = []
    for line in text.split("\n"):
        last = lines[-1] if lines else ""
        declared, assigned = DECLARED.fullmatch(line), ASSIGNED.fullmatch(line)
        if declared and re.fullmatch(re.escape(declared[1]) + r"[\w, ]+;", last):
            joined = f"{last[:-1]}, {declared[2]};"
        elif assigned and re.match(assigned[1] + r"\w", last) and all(
                ASSIGNED.fullmatch(f"{assigned[1]}{part};")
                for part in last[:-1].strip().split("; ")):
            joined = f"{last} {assigned[2]}"
        else:
            joined = None
        if joined and len(joined) <= 100:
            lines[-1] = joined
        else:
            lines.append(line)
    return "\n".join(lines)


def dense(text: str) -> str:
    """Structures as a paragraph each, and blocks of a single statement on a line."""
    def structure(match):
        members = [line.strip().replace(" ", "~") for line in match[1].splitlines()]
        whole = f"typedef~struct~packed~{{ {' '.join(members)} }}~{match[2]};"
        return textwrap.fill(whole, 100, initial_indent=" " * 4, subsequent_indent=" " * 8,
                             break_on_hyphens=False).replace("~", " ") + "\n"
    text = re.sub(r"^    typedef struct packed \{\n((?:        [^\n{}]+;\n)+)    \} (\w+);\n\n",
                  structure, text, flags=re.M)
    statement = r" begin\n\s+([^\n;]+;)\n\s+end$(?!\n\s+else)"
    for before in (r"\d:", r"\)"):
        text = re.sub(f"({before}){statement}", r"\1 \2", text, flags=re.M)
    return paragraphs(re.sub(r" +//-+\n(.*)\n +//-+$", r"\1", text, flags=re.M))


def adapt(text: str, note: str, top, package: str) -> str:
    """Our names of clock and reset; packed structs, which Verilator 5.006 needs; the keys."""
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
    camel = register_map.camel
    constants = [
        f"    localparam logic [31:0] {camel(e.type_name)}{camel(m.name)} = 32'h{m.value:08X};"
        for e in register_map.encodings(top) if f"{e.type_name}_e;" not in text for m in e]
    text = re.sub(r"^endpackage", "\n".join(["", *constants, "endpackage"]), text, flags=re.M)
    text = dense("\n".join(line.rstrip() for line in text.splitlines()) + "\n")
    unused = ("UNUSEDSIGNAL", "UNUSEDPARAM")  # the generator's own helpers, not all needed here
    off, on = ("".join(f"// verilator lint_{what} {rule}\n" for rule in unused)
               for what in ("off", "on"))
    return f"// {note}\n// SPDX-License-Identifier: Apache-2.0\n{off}{text}{on}"


def sources(top, note):
    """{file name: text} of block and package."""
    name = f"{top.inst_name}_regs"
    with tempfile.TemporaryDirectory() as folder:
        RegblockExporter().export(top, folder, cpuif_cls=Cpuif, module_name=name,
                                  package_name=f"{name}_pkg")
        texts = {path.name: path.read_text() for path in sorted(Path(folder).glob("*.sv"))}
    return {file: adapt(text, note, top, texts[f"{name}_pkg.sv"])
            for file, text in texts.items()}
