# SPDX-License-Identifier: Apache-2.0
"""A chip as gates: one clock of it as a function of its registers, its inputs and leap_i.

Found by the folder: a chip that leaps is a module of rtl/chips with the ports of PORTS that no
other chip contains, or that has its own broken designs. Multipliers are free values. Registers
that no output shows are kept too. A large memory with one read port and no register in it is left
out: its ports become ports of the chip.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

from trammel_tools.paths import RTL
from trammel_tools.proof import aiger, formal, properties
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.rtl import hierarchy

PORTS = ("leap_i", "next_o", "quiescent_o")
DOMAIN_PORTS = ("clock_en_i", "awake_o", "timed_o")
MEMORY_PORTS = tuple(f".{side}_{port}" for side in ("RD", "WR")
                     for port in ("ADDR", "ARST", "CLK", "DATA", "EN", "SRST"))
# The state before the edge is asked about: no check waits for its clock.
TO_GATES = """setparam -set TRG_ENABLE 0 t:$check
chformal -lower
memory_collect
expose -evert t:$mem_v2 r:SIZE>=32 %i r:RD_PORTS=1 %i r:RD_CLK_ENABLE=1'b0 %i
memory_map
setattr -set keep 1 t:$*dff* c:*_props.* %d
opt_clean
expose w:*.next_o w:*_props.* %d
opt -full
write_json {name}.cells.json
{products}
async2sync
setundef -undriven -anyseq
techmap
dffunmap
aigmap
write_aiger -symbols -map {name}.map {name}.aig
"""


def chips():
    """chips/<chip> of every chip that leaps."""
    texts = {p.stem: p.read_text(encoding="utf-8") for p in sorted(RTL.glob("chips/*.sv"))
             if not p.stem.endswith(("_props", "_pkg"))}
    return [f"chips/{name}" for name, text in texts.items()
            if all(re.search(rf"\b{port}\b", text) for port in PORTS)
            and ((RTL / f"chips/{name}_leap.toml").exists()
                 or not any(re.search(rf"^\s*{name}\s+(#|u_\w+\s*\()", other, re.M)
                            for other in texts.values()))]


def has_domains(chip):
    """Whether chips/<chip> has clocks by domain."""
    text = (RTL / f"{chip}.sv").read_text(encoding="utf-8")
    return all(re.search(rf"\b{port}\b", text) for port in DOMAIN_PORTS)


def rests(chip):
    """{properties file: labels} of what the leap proof of a chip may rest on: proven in the proofs
    of its blocks."""
    inside = hierarchy.modules(chip, [*RTL.glob("*/*.sv"), *RTL.glob("chips/generated/*.sv")])
    found = {props.path: props.leap for props in map(properties.read, properties.blocks())
             if props.stem in inside}
    return {path: labels for path, labels in found.items() if labels}


@dataclass
class Source:
    """One model to be made: a chip, perhaps with a changed file."""

    chip: str
    name: str
    changed: dict[Path, str] = field(default_factory=dict)
    behind: list[str] = field(default_factory=list)  # lines of the script behind the reading
    products: bool = False  # multipliers are there; else what they give is free

    @property
    def stem(self):
        return self.chip.split("/")[1]


def script(source, folder):
    assumed = rests(source.stem)
    files = formal.design(source.changed, folder, source.name, *assumed)
    checks = [f"c:*u_{path.stem}.{label}" for path, labels in assumed.items() for label in labels]
    lines = [f"read_slang --top {source.stem} {' '.join(map(str, files))}", *source.behind]
    lines += [f"delete t:$check {' '.join(f'{check} %d' for check in checks)}"]
    return "\n".join(lines) + "\n" + TO_GATES.format(
        name=source.name, products="" if source.products else "cutpoint t:$mul")


@dataclass
class Memory:
    """What is asked of a memory that was left out."""

    address: list[int]  # literals
    data: list[int]  # variables of what is read
    enables: list[int]  # literals of what lets a bit be written
    written: list[int]  # literals of its address and data


@dataclass
class Chip:
    """Variables of the gates by name; a bit's name is like u_timebase.u_phase.count_q[3]."""

    gates: aiger.Model
    inputs: dict[str, int]  # ports; every other input is a free value
    outputs: dict[str, list[int]]  # literals, lowest bit first; `next_o` of the blocks too
    memories: dict[str, Memory]
    registers: dict[str, int]  # variable
    nexts: dict[str, int]  # literal of the next value
    shadows: dict[int, str]  # registers of properties by their variable
    timers: list[str]  # registers that a leap moves
    peeking: list[str]  # outputs and ports of memories that show leap_i


def read(folder, name):
    """(gates, {port: variable}, {port: literals}, {latch: its names}) of a model."""
    gates = aiger.read(folder / f"{name}.aig")
    inputs, outputs, aliases = {}, {}, {}
    for line in (folder / f"{name}.map").read_text(encoding="utf-8").splitlines():
        kind, index, bit, signal = line.split(maxsplit=3)
        if kind == "input":
            inputs[f"{signal}[{bit}]"] = int(index) + 1
        elif kind == "latch":
            aliases.setdefault(int(index), []).append((signal, bit))
    # The map has no outputs that are constant.
    for index, names in re.findall(r"^o(\d+) (.+)$", gates.symbols, re.M):
        for name in names.split():
            signal, bit = re.fullmatch(r"(.+?)(?:\[(\d+)\])?", name).groups()
            outputs.setdefault(signal, {})[int(bit or 0)] = gates.outputs[int(index)]
    words = {port: [bits[n] for n in sorted(bits)] for port, bits in outputs.items()}
    return gates, inputs, words, aliases


def chip_of(gates, inputs, words, aliases):
    """The Chip of what read() gives."""
    ports = {port for port in words if port.endswith(MEMORY_PORTS)}
    registers, nexts, shadows = {}, {}, {}
    for index, literal in enumerate(gates.nexts):
        variable = gates.inputs + index + 1
        own = [a for a in aliases.get(index, []) if "_props." not in a[0] and a[0] not in ports]
        if own:
            # The deepest name is that of the register itself; where a port has one too, its _q.
            signal, bit = max(own, key=lambda a: (a[0].count("."), a[0].endswith("_q"), a[0]))
            registers[f"{signal}[{bit}]"] = variable
            nexts[f"{signal}[{bit}]"] = literal
        else:
            shadows[variable] = aliases.get(index, [("", 0)])[0][0]
    leap = {variable for port, variable in inputs.items() if port.startswith("leap_i[")}
    moved = reached(gates, leap)
    kept = {port: word for port, word in words.items() if port not in ports}
    return Chip(gates, inputs, kept, memories(inputs, words), registers, nexts, shadows,
                [bit for bit, literal in nexts.items() if moved[literal >> 1]],
                [port for port, bits in words.items() if any(moved[b >> 1] for b in bits)])


def memories(inputs, words):
    """{name: Memory} of those that were left out."""
    found = {}
    for port, address in words.items():
        name, _, kind = port.rpartition(".")
        if kind == "RD_ADDR":
            data = []
            while (bit := f"{name}.RD_DATA[{len(data)}]") in inputs:
                data.append(inputs[bit])
            found[name] = Memory(address, data, *(
                [bit for port in ports for bit in words.get(f"{name}.WR_{port}", [])]
                for ports in (("EN",), ("ADDR", "DATA"))))
    return found


def reached(gates, variables):
    """Whether each node depends on one of the variables."""
    first = 1 + gates.inputs + len(gates.nexts)
    depends = bytearray(first + len(gates.gates))
    for variable in variables:
        depends[variable] = 1
    for node, (a, b) in enumerate(gates.gates, first):
        depends[node] = depends[a >> 1] | depends[b >> 1]
    return depends


def make(folder, sources):
    """Runs Yosys for each source; what it said beside its logs."""
    for source in sources:
        (folder / f"{source.name}.ys").write_text(script(source, folder), encoding="utf-8")
    return formal.run_scripts(folder, [source.name for source in sources], ("aig", "map", "log"))


def made_parts(folder, source, said):
    """What read() gives of the model that Yosys made of a source."""
    formal.check_made(folder, source.name, "map", said)
    parts = read(folder, source.name)
    if not parts[0].bad and rests(source.stem):
        raise PropertiesError(f"{source.chip}: what the proof rests on did not arrive")
    return parts


def made(folder, source, said):
    """The Chip that Yosys made of a source."""
    return chip_of(*made_parts(folder, source, said))
