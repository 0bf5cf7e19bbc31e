# SPDX-License-Identifier: Apache-2.0
"""What proofs say of mutants that the unit test accepts: refuted by a promise, or equivalent.

Equivalent means: under any input, from the first reset on, every output of the mutant equals the
block's in every clock. Both begin with all registers 0, so that what no reset sets is equal too.
Leaps are those that math/timer permits: while quiescent, by less than next_o.
"""

import re

import formal
import mutants
import properties

FRAMES = 60  # clocks of the search for the outputs in which a mutant differs

# The block and a mutant side by side; a mutant of the number 0 is the control.
MITER = """read_rtlil plain.il
hierarchy -top {top}
flatten
opt_clean
rename {top} gold
design -stash gold
read_rtlil mutants.il
rename {top} gate
cd gate
connect -set {selector} {width}'d{number}
cd ..
design -stash gate
read_verilog miter.v
proc
design -copy-from gold -as gold gold
design -copy-from gate -as gate gate
hierarchy -check -top miter
flatten
memory_map
opt -full
formalff -clk2ff
setundef -undriven -init -zero
opt -full
techmap
opt -fast
dffunmap
aigmap
opt_clean
write_aiger -zinit miter.aig
"""


def ports(netlist):
    """(direction, range, name) of each port of the first module of a netlist by Yosys."""
    text = netlist.read_text(encoding="utf-8").split("endmodule")[0]
    found = re.findall(r"^  (input|output)(?: signed)?( \[\d+:\d+\])? (\S+);$", text, re.M)
    return [(direction, width.strip(), name) for direction, width, name in found]


def write_miter(block):
    """miter.v: one output `differ_<name>` an output of the block; returns their names."""
    folder = mutants.folder_of(block)
    pins = ports(folder / "mutants.v")
    inputs = [(width, name) for direction, width, name in pins if direction == "input"]
    outputs = [(width, name) for direction, width, name in pins if direction == "output"]
    head = [f"input {width} {name}" for width, name in inputs]
    head += [f"output differ_{name}" for _, name in outputs]
    names = {name for _, name in inputs + outputs}
    lines = ["module miter(", ",\n".join(head), ");", "reg live = 1'b0;", "reg legal = 1'b1;",
             "always @(posedge clk_i) if (rst_i) live <= 1'b1;"]
    if {"leap_i", "next_o"} <= names:
        still = " || !gold_quiescent_o" if "quiescent_o" in names else ""
        lines.append(f"always @(posedge clk_i) if (leap_i != 0 && (leap_i >= gold_next_o{still})) "
                     "legal <= 1'b0;")
    for module in ("gold", "gate"):
        lines += [f"wire {width} {module}_{name};" for width, name in outputs]
        links = [f".{name}({name})" for _, name in inputs]
        links += [f".{name}({module}_{name})" for _, name in outputs]
        lines.append(f"{module} u_{module} ({', '.join(links)});")
    lines += [f"assign differ_{name} = live && legal && gold_{name} != gate_{name};"
              for _, name in outputs]
    (folder / "miter.v").write_text("\n".join([*lines, "endmodule", ""]), encoding="utf-8")
    return [name for _, name in outputs]


def compare(block, number, outputs, limit):
    """("equivalent", kind of proof), or ("different" | "open", what is known)."""
    folder = mutants.folder_of(block)
    mutants.yosys(MITER.format(top=block.split("/")[1], selector=mutants.SELECTOR,
                               width=mutants.WIDTH, number=number), folder, "miter")
    read = "read_aiger miter.aig; orpos; scleanup; scorr; dc2; scorr"
    # Where all registers were equal pairs, nothing sequential is left.
    if "UNSATISFIABLE" in formal.abc(folder, f"{read}; iprove", limit):
        return "equivalent", "induction"
    for engine in ("pdr", "dprove"):
        text = formal.abc(folder, f"{read}; {engine} -T {limit}", 3 * limit)
        if re.search("Property proved|Networks are equivalent", text):
            return "equivalent", "reachability"
        late = re.search(r"was asserted in frame (\d+)", text)
        if late:
            seen = formal.reach(folder, "miter", outputs, min(int(late[1]) + 1, FRAMES), limit)
            words = [f"{name} at clock {clock}" for name, clock in sorted(seen.items())]
            return "different", "differs in " + (", ".join(words) or f"clock {late[1]}")
    return "open", f"neither proven nor found different in {2 * limit} s"


def refuted_by(block, number, limit):
    """Label of a promise that the mutant breaks; None when there is none."""
    source = properties.RTL / f"{block}.sv"
    if not source.with_name(f"{source.stem}_props.sv").exists():
        return None
    props = properties.read(block)
    folder = mutants.folder_of(block)
    # The bound properties see the block's parameters by name.
    constants = [f"  localparam {line};\n" for line in re.findall(
        r"^ *parameter +(.+?),?$", source.read_text(encoding="utf-8"), re.M)]
    constants.append(f"  localparam logic [{mutants.WIDTH - 1}:0] {mutants.SELECTOR} = {number};\n")
    netlist = mutants.with_selector(block, "mutants.v", "".join(constants), "mutant.sv")
    model = formal.Model("promises", only=props.promises, changed={
        source: netlist.read_text(encoding="utf-8"), props.path: named_bind(props.path)})
    labels = formal.write_models(props, folder, [model])["promises"]
    broken = formal.reach(folder, "promises", labels, props.frames, limit)
    return min(broken, key=broken.get) if broken else None


def named_bind(path):
    """The properties with ports bound by name: `.*` wants types, which a netlist has not."""
    text = path.read_text(encoding="utf-8")
    head, bind, tail = text.partition("\nbind ")
    names = re.findall(r"^ +input .*?(\w+)(?: \[[^]]*\])?,?(?: *//.*)?$", head.split(");")[0], re.M)
    links = [f".{name}({name})" for name in names if not re.search(rf"\.{name}\b", tail)]
    # A name inside a generated scope is one word of the netlist.
    tail = re.sub(r"(?<=[({ ])\w+(\[\d+\])?(\.\w+)+", lambda found: f"\\{found[0]} ", tail)
    return head + bind + tail.replace(".*", ", ".join(links))
