# SPDX-License-Identifier: Apache-2.0
"""Builds one question of gates: copies of a circuit, equal gates shared, for abc to answer.

A literal is 2 * node + inverted; 0 is false, 1 is true. Words are lists of literals, lowest first.
"""

from trammel_tools.proof import aiger


class Graph:
    def __init__(self):
        self.gates = [None]  # per node: two literals, or None for the constant and inputs
        self.inputs = []  # nodes
        self.known = {}

    def free(self):
        self.gates.append(None)
        self.inputs.append(len(self.gates) - 1)
        return 2 * self.inputs[-1]

    def word(self, bits):
        return [self.free() for _ in range(bits)]

    def both(self, a, b):
        if a > b:
            a, b = b, a
        if a == 0 or a == b ^ 1:
            return 0
        if a == 1 or a == b:
            return b
        gate = self.known.get((a, b))
        if gate is None:
            self.gates.append((a, b))
            gate = self.known[a, b] = 2 * len(self.gates) - 2
        return gate

    def either(self, a, b):
        return self.both(a ^ 1, b ^ 1) ^ 1

    def differ(self, a, b):
        return self.either(self.both(a, b ^ 1), self.both(a ^ 1, b))

    def some(self, literals):
        """One of them is true; a balanced tree."""
        row = list(literals) or [0]
        while len(row) > 1:
            row = [self.either(*row[n:n + 2]) if n + 1 < len(row) else row[n]
                   for n in range(0, len(row), 2)]
        return row[0]

    def every(self, literals):
        return self.some(literal ^ 1 for literal in literals) ^ 1

    def unequal(self, a, b):
        return self.some(self.differ(x, y) for x, y in zip(a, b, strict=True))

    def less(self, a, b):
        """a < b, both unsigned."""
        result = 0
        for x, y in zip(a, b, strict=True):
            result = self.either(self.both(x ^ 1, y), self.both(self.differ(x, y) ^ 1, result))
        return result

    def plus_one(self, a):
        """One bit longer than a."""
        carry, total = 1, []
        for x in a:
            total.append(self.differ(x, carry))
            carry = self.both(x, carry)
        return [*total, carry]

    def copy(self, model, given, roots):
        """The literals `roots` of an aiger.Model, with `given` {variable: literal} for its inputs
        and latches; an input that is not given is a free one of this copy."""
        first = 1 + model.inputs + len(model.nexts)
        needed = bytearray(first + len(model.gates))
        for root in roots:
            needed[root >> 1] = 1
        for node in range(len(needed) - 1, first - 1, -1):
            if needed[node]:
                for literal in model.gates[node - first]:
                    needed[literal >> 1] = 1
        value = [0] * len(needed)
        for node in range(1, first):
            if needed[node]:
                value[node] = given[node] if node in given else self.free()
        for node in range(first, len(needed)):
            if needed[node]:
                a, b = model.gates[node - first]
                value[node] = self.both(value[a >> 1] ^ a & 1, value[b >> 1] ^ b & 1)
        return [value[root >> 1] ^ root & 1 for root in roots]

    def write(self, path, output):
        """A binary AIGER file of one output, with all inputs."""
        needed, open_nodes = set(), [output >> 1]
        while open_nodes:
            node = open_nodes.pop()
            if node not in needed and self.gates[node]:
                needed.add(node)
                open_nodes += [literal >> 1 for literal in self.gates[node]]
        number = {node: n for n, node in enumerate([0, *self.inputs, *sorted(needed)])}
        pairs = [[2 * number[literal >> 1] + (literal & 1) for literal in self.gates[node]]
                 for node in sorted(needed)]
        aiger.write(path, aiger.Model(len(self.inputs), [],
                                      [2 * number[output >> 1] + (output & 1)], [], pairs))

    def simulate(self, bits):
        """A function that gives the value of a literal when the inputs are `bits`."""
        value = [0] * len(self.gates)
        for node, bit in zip(self.inputs, bits):
            value[node] = bit
        for node, gate in enumerate(self.gates):
            if gate:
                a, b = gate
                value[node] = (value[a >> 1] ^ a & 1) & (value[b >> 1] ^ b & 1)
        return lambda literal: value[literal >> 1] ^ literal & 1
