# SPDX-License-Identifier: Apache-2.0
"""Two copies of a netlist side by side, as AIGER models for abc.

A block and its mutant have the same registers, so each register of one has a partner in the other.
step() asks whether equal registers make equal outputs and equal registers again: then the two are
equivalent by induction. chase() is for those where that needs what states are reached: it shares
all registers that the mutation never gets to, and doubles the others.
"""

from dataclasses import dataclass

from aiger import coded, number


@dataclass
class Netlist:
    inputs: list[str]  # name[bit]
    latches: list[set[str]]  # a register may have several names
    outputs: list[str]
    nexts: list[int]
    results: list[int]  # literals of the outputs
    gates: list[tuple[int, int]]
    wires: list[tuple[str, int]]  # name[bit] and literal


def read(stem):
    """stem.aig and stem.map by Yosys; all registers begin at 0."""
    data = stem.with_suffix(".aig").read_bytes()
    head, _, rest = data.partition(b"\n")
    _, inputs, latches, outputs, gates = map(int, head.split()[1:6])
    lines = rest.split(b"\n", latches + outputs)
    place = len(data) - len(lines.pop())
    words = [int(line.split()[0]) for line in lines]
    pairs = []
    for gate in range(gates):
        left = 2 * (inputs + latches + 1 + gate)
        delta, place = number(data, place)
        right, place = number(data, place)
        pairs.append((left - delta, left - delta - right))
    names = {"input": {}, "latch": {}, "output": {}}
    wires = []
    for line in stem.with_suffix(".map").read_text(encoding="utf-8").split("\n"):
        word = line.split()
        if len(word) == 4 and word[0] == "wire" and not word[3].startswith("$"):
            wires.append((f"{word[3]}[{word[2]}]", int(word[1])))
        elif len(word) == 4 and word[0] in names:
            names[word[0]].setdefault(int(word[1]), set()).add(f"{word[3]}[{word[2]}]")
    # Inputs without a name are the unknowns of the netlist.
    free = (f"unknown[{n}]" for n in range(inputs))
    return Netlist([min(names["input"].get(n) or {next(free)}) for n in range(inputs)],
                   [names["latch"].get(n, set()) for n in range(latches)],
                   [min(names["output"].get(n, {"a constant"})) for n in range(outputs)],
                   words[:latches], words[latches:], pairs, wires)


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
        place = {name: 2 * (n + 1) for n, name in enumerate(self.names)}
        for bit in range(32):
            place[f"{selector}[{bit}]"] = 0
        chosen = {**place, **{f"{selector}[{bit}]": selected >> bit & 1 for bit in range(32)}}
        self.gold_inputs = [place[name] for name in gold.inputs]
        self.gate_inputs = [chosen[name] for name in gate.inputs]
        # Registers that only gate has, because the block does not need them, come behind gold's.
        count, size = len(self.names), len(gold.latches) + len(gate.latches) * (gate is not gold)
        self.state = [2 * (count + 1 + n) for n in range(size)]
        self.double = [2 * (count + size + 1 + n) for n in range(size)]
        self.first = 2 * (count + 2 * size + 1)
        self.table, self.gates = {}, []
        self.order = range(size) if gate is gold else partners(gold.latches, self.known())

    def both(self, a, b):
        if a < b:
            a, b = b, a
        if b == 0 or a == b ^ 1:
            return 0
        if b == 1 or a == b:
            return a
        if (a, b) not in self.table:
            self.table[a, b] = self.first + 2 * len(self.gates)
            self.gates.append((a, b))
        return self.table[a, b]

    def differ(self, a, b):
        return self.both(self.both(a, b ^ 1) ^ 1, self.both(a ^ 1, b) ^ 1) ^ 1

    def any(self, literals):
        none = 1
        for literal in literals:
            none = self.both(none, literal ^ 1)
        return none ^ 1

    def known(self):
        """Names of the registers of `gate`; a mutated one has its name behind the mutation."""
        state = self.state[:len(self.gate.latches)]
        value = self.values(self.gate, self.gate_inputs, state)
        names = {literal: set() for literal in state}
        for name, literal in self.gate.wires:
            names.get(value[literal >> 1] ^ (literal & 1), set()).add(name)
        return [names[literal] for literal in state]

    def values(self, netlist, inputs, state):
        value = [0, *inputs, *state]
        both = self.both
        for a, b in netlist.gates:
            value.append(both(value[a >> 1] ^ (a & 1), value[b >> 1] ^ (b & 1)))
        return value

    def copy(self, netlist, inputs, state):
        """Literals of (next states, outputs) of a copy."""
        value = self.values(netlist, inputs, state)
        return ([value[n >> 1] ^ (n & 1) for n in netlist.nexts],
                [value[n >> 1] ^ (n & 1) for n in netlist.results])

    def copies(self, doubled):
        """(next states of gold, of gate in gold's order, how the outputs differ)."""
        size = len(self.gold.latches)
        nexts, results = self.copy(self.gold, self.gold_inputs, self.state[:size])
        nexts += [0] * (len(self.state) - size)
        mixed = [self.double[n] if n in doubled else self.state[n] for n in self.order]
        changed, others = self.copy(self.gate, self.gate_inputs, mixed)
        again = list(nexts)
        for n, literal in zip(self.order, changed):
            again[n] = literal
        *results, care = results  # the same ports in the same order
        return nexts, again, [self.both(care, self.differ(a, b)) for a, b in zip(results, others)]

    def write(self, path, nexts, results, registers):
        """AIGER; the states are inputs when there are no registers."""
        size = 2 * len(self.state)
        count, latches = (len(self.names), size) if registers else (len(self.names) + size, 0)
        head = (f"aig {count + latches + len(self.gates)} {count} {latches} {len(results)} "
                f"{len(self.gates)}\n")
        head += "".join(f"{word}\n" for word in [*(nexts if registers else []), *results])
        body = b"".join(coded(self.first + 2 * n - a) + coded(a - b)
                        for n, (a, b) in enumerate(self.gates))
        path.write_bytes(head.encode() + body)

    def step(self, path):
        """One output: equal registers, but unequal outputs or next states."""
        nexts, again, results = self.copies(frozenset())
        nexts = nexts[:len(self.gold.latches)]
        wrong = [self.differ(a, b) for a, b in zip(nexts, again) if a != b]
        self.write(path, [], [self.any([*wrong, *results])], False)

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
        tests = [self.any(literals) for literals in ports.values()]
        self.write(path, nexts + twice, tests, True)
        return list(ports)
