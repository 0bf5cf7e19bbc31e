# SPDX-License-Identifier: Apache-2.0
"""Two copies of a netlist side by side, as AIGER models for abc.

A block and its mutant have the same registers, so each register of one has a partner in the other.
step() asks whether equal registers make equal outputs and equal registers again: then the two are
equivalent by induction. chase() is for those where that depends on the reachable states: it shares
all registers that the mutation never reaches, and doubles the others.
"""

from dataclasses import dataclass

from trammel_tools.proof import aiger, miter


@dataclass
class Netlist:
    gates: aiger.Model
    inputs: list[str]  # name[bit]
    latches: list[set[str]]  # a register may have several names
    outputs: list[str]
    wires: list[tuple[str, int]]  # name[bit] and literal


def read(stem):
    """stem.aig and stem.map by Yosys; all registers begin at 0."""
    gates = aiger.read(stem.with_suffix(".aig"))
    names = {"input": {}, "latch": {}, "output": {}}
    wires = []
    for line in stem.with_suffix(".map").read_text(encoding="utf-8").split("\n"):
        word = line.split()
        if len(word) == 4 and word[0] == "wire" and not word[3].startswith("$"):
            wires.append((f"{word[3]}[{word[2]}]", int(word[1])))
        elif len(word) == 4 and word[0] in names:
            names[word[0]].setdefault(int(word[1]), set()).add(f"{word[3]}[{word[2]}]")
    # Inputs without a name are the unknowns of the netlist.
    free = (f"unknown[{n}]" for n in range(gates.inputs))
    return Netlist(gates,
                   [min(names["input"].get(n) or {next(free)}) for n in range(gates.inputs)],
                   [names["latch"].get(n, set()) for n in range(len(gates.nexts))],
                   [min(names["output"].get(n, {"a constant"})) for n in range(len(gates.outputs))],
                   wires)


def partners(ours, theirs):
    """For each register of theirs the place of ours with a name in common; beyond ours for others.

    A wrong one proves nothing, for all registers begin at 0 and are then compared.
    """
    place = {name: n for n, names in enumerate(ours) for name in names}
    found, taken, beyond = [], set(), len(ours)
    for names in theirs:
        places = {place[name] for name in names if name in place} - taken
        found.append(min(places, default=beyond))
        taken.add(found[-1])
        beyond += not places
    return found


class Pair:
    """`gold` with the selector at 0, `gate` with it at `number`; alike gates are made once."""

    def __init__(self, gold, gate, selector, selected):
        self.gold, self.gate = gold, gate
        self.names = [name for name in dict.fromkeys(gold.inputs + gate.inputs)
                      if not name.startswith(f"{selector}[")]
        self.graph = miter.Graph()
        # Two netlists do not number their unknowns alike: there they are 0, else free.
        place = {name: 0 if gate is not gold and name.startswith("unknown[")
                 else self.graph.free() for name in self.names}
        for bit in range(32):
            place[f"{selector}[{bit}]"] = 0
        chosen = {**place, **{f"{selector}[{bit}]": selected >> bit & 1 for bit in range(32)}}
        self.gold_inputs = [place[name] for name in gold.inputs]
        self.gate_inputs = [chosen[name] for name in gate.inputs]
        # Registers that only gate has, because the block does not need them, come behind gold's.
        size = len(gold.latches) + len(gate.latches) * (gate is not gold)
        self.state = self.graph.word(size)
        self.double = self.graph.word(size)
        self.order = range(size) if gate is gold else partners(gold.latches, self.known())

    def known(self):
        """Names of the registers of `gate`; a mutated one has its name behind the mutation."""
        state = self.state[:len(self.gate.latches)]
        value = self.copy(self.gate, self.gate_inputs, state, [w for _, w in self.gate.wires])
        names = {literal: set() for literal in state}
        for (name, _), literal in zip(self.gate.wires, value):
            names.get(literal, set()).add(name)
        return [names[literal] for literal in state]

    def copy(self, netlist, inputs, state, roots):
        """The literals `roots` of a copy."""
        return self.graph.copy(netlist.gates, dict(enumerate([*inputs, *state], 1)), roots)

    def next(self, netlist, inputs, state):
        """Literals of (next states, outputs) of a copy."""
        nexts, outputs = netlist.gates.nexts, netlist.gates.outputs
        value = self.copy(netlist, inputs, state, [*nexts, *outputs])
        return value[:len(nexts)], value[len(nexts):]

    def copies(self, doubled):
        """(next states of gold, of gate in gold's order, how the outputs differ)."""
        size = len(self.gold.latches)
        nexts, results = self.next(self.gold, self.gold_inputs, self.state[:size])
        nexts += [0] * (len(self.state) - size)
        mixed = [self.double[n] if n in doubled else self.state[n] for n in self.order]
        changed, others = self.next(self.gate, self.gate_inputs, mixed)
        again = list(nexts)
        for n, literal in zip(self.order, changed):
            again[n] = literal
        *results, care = results  # the same ports in the same order
        return nexts, again, [self.graph.both(care, self.graph.differ(a, b))
                              for a, b in zip(results, others)]

    def write(self, path, nexts, results):
        """AIGER; the states are inputs when there is no next one."""
        given = len(self.graph.inputs)
        gates = self.graph.gates[given + 1:]
        aiger.write(path, aiger.Model(given - len(nexts), nexts, results, [], gates))

    def step(self, path):
        """One output: equal registers, but unequal outputs or next states."""
        nexts, again, results = self.copies(frozenset())
        nexts = nexts[:len(self.gold.latches)]
        wrong = [self.graph.differ(a, b) for a, b in zip(nexts, again) if a != b]
        self.write(path, [], [self.graph.some([*wrong, *results])])

    def chase(self, path):
        """The product from reset on; one output an output of the block. Returns their names."""
        doubled = frozenset()
        while True:
            nexts, again, results = self.copies(doubled)
            reached = doubled | {n for n, a in enumerate(nexts) if a != again[n]}
            if reached == doubled:
                break
            doubled = reached
        ports = {}
        for name, literal in zip(self.gold.outputs, results):
            ports.setdefault(name.rsplit("[", 1)[0], []).append(literal)
        twice = [literal if n in doubled else 0 for n, literal in enumerate(again)]
        tests = [self.graph.some(literals) for literals in ports.values()]
        self.write(path, nexts + twice, tests)
        return list(ports)
