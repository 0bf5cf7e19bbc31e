# SPDX-License-Identifier: Apache-2.0
"""What proofs say of mutants that the unit test accepts: refuted by a promise, or equivalent.

Equivalent means: under any input, from the first reset on, every output of the mutant equals the
block's in every clock. Both begin with all registers 0, so that what no reset sets is equal too.
Leaps are those that math/timer permits: while quiescent, by less than next_o.
"""

import re

from trammel_tools.mutation import mutant_pair, mutants
from trammel_tools.paths import RTL, block_file
from trammel_tools.proof import abc, formal, properties
from trammel_tools.rtl import yosys

FRAMES = 60  # clocks of the search for the outputs in which a mutant differs

# The block, or all of its mutants, with its outputs and whether they matter.
NETLIST = """read_rtlil {name}.il
hierarchy -top {top}
{choose}
rename {top} block
read_verilog around.v
proc
hierarchy -check -top around
flatten
memory_map -formal
setundef -anyseq
opt_expr
opt_clean
formalff -clk2ff
setundef -undriven -init -zero
techmap
opt_expr
dffunmap
aigmap
opt_clean
write_aiger -zinit -vmap {name}.map {name}.aig
"""
CHOOSE = """cd {top}
add -input choose {width}
connect -set {selector} choose
cd ..
"""


def ports(netlist):
    """(direction, range, name) of each port of the first module of a netlist by Yosys."""
    text = netlist.read_text(encoding="utf-8").split("endmodule")[0]
    found = re.findall(r"^  (input|output)(?: signed)?( \[\d+:\d+\])? (\S+);$", text, re.M)
    return [(direction, width.strip(), name) for direction, width, name in found]


def write_netlists(block):
    """plain.aig and mutants.aig: the block's outputs, and `care`, which a leap too far ends."""
    folder, top = mutants.folder_of(block), block.split("/")[1]
    pins = ports(folder / "mutants.v")
    names = {name for _, _, name in pins}
    clock, reset = ("clk_i", "rst_i") if "clk_i" in names else ("clk", "rst")
    lines = ["reg live = 1'b0;", "reg legal = 1'b1;",
             f"always @(posedge {clock}) if ({reset}) live <= 1'b1;",
             "assign care = live && legal;"]
    if {"leap_i", "next_o"} <= names:
        still = " || !quiescent_o" if "quiescent_o" in names else ""
        lines.append(f"always @(posedge {clock}) if (leap_i != 0 && (leap_i >= next_o{still})) "
                     "legal <= 1'b0;")
    select = (f"input [{mutants.WIDTH - 1}:0] choose", [".choose(choose)"])
    for name, (port, link) in (("plain", (None, [])), ("mutants", select)):
        head = [f"{direction} {width} {pin}" for direction, width, pin in pins]
        head += [port] if port else []
        links = ", ".join([f".{pin}({pin})" for _, _, pin in pins] + link)
        (folder / "around.v").write_text("\n".join([
            "module around(", ",\n".join([*head, "output care"]), ");", *lines,
            f"block u_block ({links});", "endmodule", ""]), encoding="utf-8")
        choose = CHOOSE.format(top=top, selector=mutants.SELECTOR, width=mutants.WIDTH)
        yosys.make(NETLIST.format(name=name, top=top, choose=choose if port else ""), folder,
                   f"{name}_aig")


def compare(block, number, limit):
    """("equivalent", kind of proof), or ("different" | "open", what is known).

    The mutant of the number 0 is the control: none of them, against the block itself.
    """
    folder = mutants.folder_of(block)
    gate = mutant_pair.read(folder / "mutants")
    gold = gate if number else mutant_pair.read(folder / "plain")
    mutant_pair.Pair(gold, gate, "choose", number).step(folder / "step.aig")
    if "UNSATISFIABLE" in abc.ask(folder, "read_aiger step.aig; iprove", limit):
        return "equivalent", "induction"
    outputs = mutant_pair.Pair(gold, gate, "choose", number).chase(folder / "chase.aig")
    (folder / "less.aig").unlink(missing_ok=True)
    text = abc.ask(folder, "read_aiger chase.aig; orpos; scleanup; scorr; dc2; scorr; "
                              "write_aiger less.aig; iprove", 2 * limit)
    # Where all registers were equal pairs, nothing sequential is left.
    if "UNSATISFIABLE" in text:
        return "equivalent", "induction"
    if not (folder / "less.aig").exists():
        return "open", f"neither proven nor found different in {3 * limit} s"
    for engine in ("pdr", "dprove"):
        text = abc.ask(folder, f"read_aiger less.aig; {engine} -T {limit}", 2 * limit)
        if re.search("Property proved|Networks are equivalent", text):
            return "equivalent", "reachability"
        late = re.search(r"was asserted in frame (\d+)", text)
        if late:
            seen, _ = abc.reach(folder, "chase", outputs, min(int(late[1]) + 1, FRAMES), limit)
            words = [f"{name} at clock {clock}" for name, clock in sorted(seen.items())]
            return "different", "differs in " + (", ".join(words) or f"clock {late[1]}")
    return "open", f"neither proven nor found different in {5 * limit} s"


def refuted_by(block, number, limit):
    """Label of a promise that the mutant breaks; None when there is none."""
    source = block_file(block, ".sv")
    if not source.with_name(f"{source.stem}_props.sv").exists():
        return None
    props = properties.read(block)
    folder = mutants.folder_of(block)
    constants = parameters(source.read_text(encoding="utf-8"))
    constants.append(f"  localparam logic [{mutants.WIDTH - 1}:0] {mutants.SELECTOR} = {number};\n")
    netlist = mutants.with_selector(block, "mutants.v", "".join(constants), "mutant.sv")
    model = formal.Model("assertions", only=props.assertions, changed={
        source: netlist.read_text(encoding="utf-8"), props.path: named_bind(props.path)})
    said = formal.write_models(props, folder, [model])
    labels = formal.read_labels(folder, "assertions", said)
    broken, _ = abc.reach(folder, "assertions", labels, props.frames, limit)
    return min(broken, key=broken.get) if broken else None


def parameters(text):
    """Those of a module as constants: the bound properties see them by name."""
    return [f"  localparam {line};\n" for line in re.findall(
        r"^ *parameter +(.+?),?(?: *//.*)?$", text, re.M)]


def enumerations():
    """{type: its name with the package's}."""
    return {kind: f"{package.stem}::{kind}" for package in RTL.glob("pkg/*_pkg.sv")
            for kind in re.findall(r"typedef enum [^;]*\} (\w+);",
                                   package.read_text(encoding="utf-8"))}


def named_bind(path):
    """The properties with ports bound by name: `.*` wants types, which a netlist has not."""
    text = path.read_text(encoding="utf-8")
    head, bind, tail = text.partition("\nbind ")
    ports = re.findall(r"^ +input (\w+).*?(\w+)(?: \[[^]]*\])?,?(?: *//.*)?$",
                       head.split(");")[0], re.M)
    casts = enumerations()  # a port of such a type takes no plain net
    links = [f".{name}({casts[kind]}'({name}))" if kind in casts else f".{name}({name})"
             for kind, name in ports if not re.search(rf"\.{name}\b", tail)]
    # A name inside a generated scope is one word of the netlist.
    tail = re.sub(r"(?<=[({ ])\w+(\[\d+\])?(\.\w+)+", lambda found: f"\\{found[0]} ", tail)
    return head + bind + tail.replace(".*", ", ".join(links))
