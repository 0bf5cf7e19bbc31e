# SPDX-License-Identifier: Apache-2.0
"""Waves of a refuted promise: the inputs that abc found, played on the gates of the model, with the
names of the sources; and a view for GTKWave of the signals that the promise speaks of."""

import re
from dataclasses import dataclass

from trammel_tools.proof import abc, aiger, formal
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.waves import vcd

SHORTEST = 2  # [s] for a shorter one than was found
TOLD = 6  # values on the terminal


@dataclass
class Net:
    """A named signal; its bits are literals of the gates."""

    bits: dict[int, int]

    @property
    def width(self):
        return max(self.bits) + 1

    def value(self, node):
        return sum((node[literal >> 1] ^ literal & 1) << bit for bit, literal in self.bits.items())


def inputs(folder, name, output, clocks, frames, limit):
    """Input bits of each clock up to that in which the output of name.aig rises.

    A search often needs fewer clocks than random inputs did. Inputs that do not matter are 0.
    """
    witness = folder / f"{name}.cex"
    witness.unlink(missing_ok=True)
    for engine, time in ((f"bmc3 -F {clocks}", SHORTEST), (f"sim3 -F {frames}", limit),
                         (f"bmc3 -F {clocks}", limit), ("dc2; scorr; pdr", limit)):
        abc.ask(folder, f"read_aiger {name}.aig; cone -O {output}; {engine} -T {time}; "
                        f"write_cex -a -m {name}.cex", time + 30)
        if witness.exists():
            _, *lines = witness.read_text(encoding="ascii").split("# DONE")[0].split("\n")
            return [[bit == "1" for bit in line] for line in lines if line]
    raise PropertiesError(f"{name}: abc does not find the counterexample again")


def nets(folder, name):
    """{name: Net} of what has a name in the sources."""
    found = {}
    for line in (folder / f"{name}.map").read_text(encoding="utf-8").splitlines():
        word = line.split()
        if word[0] == "wire" and "$" not in word[3]:
            found.setdefault(word[3], Net({})).bits[int(word[2])] = int(word[1])
    return found


def play(gates, frames):
    """The value of each node in each clock."""
    state, first = [0] * len(gates.nexts), 1 + gates.inputs + len(gates.nexts)
    for bits in frames:
        node = [0, *map(int, bits), *state, *[0] * len(gates.gates)]
        for n, (a, b) in enumerate(gates.gates, first):
            node[n] = (node[a >> 1] ^ a & 1) & (node[b >> 1] ^ b & 1)
        yield node
        state = [node[literal >> 1] ^ literal & 1 for literal in gates.nexts]


def mentioned(text, label):
    """Names in the assertion of this label, in their order, and those behind them by one step."""
    start = re.search(rf"\b{label}\s*:\s*assert\s*\(", text).end()
    depth, end = 1, start
    while depth:
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        end += 1
    words = r"(?<![.'\w])[A-Za-z_]\w*"
    names = list(dict.fromkeys(re.findall(words, text[start:end])))
    behind = [name for known in names
              for source in re.findall(rf"\b{known}\s*<?=(?!=)([^;]*);", text)
              for name in re.findall(words, source)]
    return names, [name for name in dict.fromkeys(behind) if name not in names]


class Counterexample:
    """Of the promise `label`, whose output of the model rises within `clocks`; the files are
    <label>.vcd and <label>.gtkw."""

    def __init__(self, props, folder, model, label, clocks, limit):
        self.props, self.folder, self.label = props, folder, label
        formal.write_map(props, folder, model)
        gates = aiger.read(folder / f"{model.name}.aig")
        scope, output = self.place(formal.read_paths(folder, model.name))
        frames = inputs(folder, model.name, output, clocks, props.frames, limit)
        *nodes, last = play(gates, frames)
        bad = (gates.outputs + gates.bad)[output]
        if not last[bad >> 1] ^ bad & 1:
            raise PropertiesError(f"{label}: abc's inputs do not refute it")
        self.clock = len(nodes) - 1  # an assertion is sampled at the edge behind its clock
        self.columns = self.values(nets(folder, model.name), scope, nodes)
        self.write(scope)

    def place(self, paths):
        """(scope of the assertion, its output)"""
        for n, path in enumerate(paths):
            *scope, name = path.split(".")
            if name == self.label:
                return ".".join(scope), n
        raise PropertiesError(f"no assertion {self.label}")

    def values(self, found, scope, nodes):
        """{Signal: its values}; what the properties only see by another name is left out."""
        stem = self.props.stem
        columns = {}
        for name, net in found.items():
            own = found.get(name.removeprefix(f"{scope}."), net)
            if name == "clk_i" or (own is not net and own.bits == net.bits):
                continue
            columns[vcd.Signal(f"{stem}.{name}", net.width)] = [net.value(node) for node in nodes]
        promise = vcd.Signal(f"{stem}.{scope}.{self.label}", 1)
        return {promise: [1] * self.clock + [0], **columns}

    def write(self, scope):
        stem, props = self.props.stem, self.props
        known = {signal.path: signal for signal in self.columns}

        def signals(names):
            found = (known.get(f"{stem}.{name}") or known.get(f"{stem}.{scope}.{name}")
                     for name in names)
            return [signal for signal in found if signal]

        text = "\n".join(line.split("//")[0]
                         for line in props.path.read_text(encoding="utf-8").split("\n"))
        says, behind = map(signals, mentioned(text, self.label))
        reset = [signal for signal in signals(["rst_i"]) if signal not in says + behind]
        ports = [signal for signal, values in self.columns.items()
                 if re.fullmatch(rf"{stem}\.\w+_i", signal.path) and any(values)
                 and signal not in says + behind + reset]
        self.says = says
        clock, promise = vcd.Signal(f"{stem}.clk_i", 1), signals([self.label])
        self.waves = self.folder / f"{self.label}.vcd"
        self.view = self.waves.with_suffix(".gtkw")
        vcd.write(self.waves, clock.path, self.columns)
        vcd.write_view(self.view, self.waves, f"{self.label} of {props.block}, refuted at clock "
                       f"{self.clock}; written by trammel prove",
                       {"Promise": [clock, *reset, *promise], "It says": says, "Behind it": behind,
                        "Inputs that matter": ports},
                       (0, (self.clock + 1) * vcd.PERIOD), self.clock * vcd.PERIOD)

    def words(self):
        """The values in the last clock of what the promise says."""
        shown = [f"{signal.path.split('.')[-1]} {self.columns[signal][-1]:#x}"
                 if self.columns[signal][-1] > 9 else
                 f"{signal.path.split('.')[-1]} {self.columns[signal][-1]}" for signal in self.says]
        return ", ".join(shown[:TOLD]) + (", ..." if len(shown) > TOLD else "")
