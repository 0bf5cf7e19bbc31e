# SPDX-License-Identifier: Apache-2.0
"""Several broken designs of a chip as one model, since Yosys takes most of the time.

Each net that a change gives another value is cut (rtl/rewire.py): what its readers see is an input
of the model, what the sources make of it an output, and so is the value of each change. A broken
design is the model with its own value joined to the input of its cut, and at every other cut what
the sources make of the net: in the gates, and in the netlist that says which clock a register has.
"""

import re
from dataclasses import replace

from trammel_tools.proof import domains, leap_model, miter
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.proof.seeded_bugs import SeededBugError
from trammel_tools.rtl import rewire

PORTS = re.compile(rf"(?:.*\.)?(?:{rewire.SEEN}|{rewire.OLD}|{rewire.NEW})\d+(?:_\d+)?")
SEEN = re.compile(rf"((?:.*\.)?){rewire.SEEN}(\d+)")


class Alone:
    """One broken design, made by itself."""

    def __init__(self, folder, source, said):
        self.folder, self.source, self.said = folder, source, said

    def chip(self, _):
        return leap_model.made(self.folder, self.source, self.said)

    def netlist(self, _):
        return domains.netlist(self.folder / f"{self.source.name}.cells.json")


class Joined:
    """Broken designs {number: SeededBug} in one model."""

    def __init__(self, folder, chip, name, seeded_bugs, products):
        self.seeded_bugs, self.cuts, texts = seeded_bugs, {}, {}
        for n, bug in seeded_bugs.items():
            cut = self.cuts.setdefault((bug.module, bug.name, bug.sign),
                                       str(len(self.cuts)))
            path, = bug.changed()[0]
            text = texts.get(path) or path.read_text(encoding="utf-8")
            texts[path] = bug.spliced(text, cut, f"_{n}")
        cuts = " ".join(f"{net} {rewire.KINDS[sign]} {cut}"
                        for (_, net, sign), cut in self.cuts.items())
        source = leap_model.Source(chip, name, texts, [f"rewire {cuts}"], products)
        said = leap_model.make(folder, [source])
        self.parts = gates, inputs, *_ = leap_model.made_parts(folder, source, said)
        self.start = Start(gates, [v for port, v in inputs.items()
                                   if SEEN.fullmatch(port.rpartition("[")[0])])
        self.top = domains.netlist(folder / f"{name}.cells.json")

    def shown(self, number, place, cut):
        """The port that shows what readers of the net see in this design; None changes nothing."""
        bug = self.seeded_bugs.get(number)
        if bug and self.cuts[bug.module, bug.name, bug.sign] == cut:
            return f"{place}{rewire.NEW}{cut}_{number}"
        return f"{place}{rewire.OLD}{cut}"

    def chip(self, number):
        gates, inputs, words, aliases = self.parts
        joins = {}
        for port, variable in inputs.items():
            name, _, bit = port[:-1].rpartition("[")
            if found := SEEN.fullmatch(name):
                joins[variable] = words[self.shown(number, *found.groups())][int(bit)]
        words = {port: word for port, word in words.items() if not PORTS.fullmatch(port)}
        inputs = {port: v for port, v in inputs.items() if v not in joins}
        gates, words = join(gates, joins, words, self.start)
        aliases = {index: [(self.original(number, signal), bit) for signal, bit in names]
                   for index, names in aliases.items()}
        return leap_model.chip_of(gates, inputs, words, aliases)

    def original(self, number, signal):
        """The net that has this signal of a cut, where nothing is changed."""
        found = re.fullmatch(rf"((?:.*\.)?)(?:{rewire.BEFORE}|{rewire.OLD})(\d+)", signal)
        if not found or rewire.NEW in self.shown(number, *found.groups()):
            return signal
        return found[1] + next(net for (_, net, _), cut in self.cuts.items() if cut == found[2])

    def netlist(self, number):
        """The top as Yosys writes it, with the cuts joined."""
        ports = self.top["ports"]
        joins = {}
        for port, pins in ports.items():
            if found := SEEN.fullmatch(port):
                joins |= zip(pins["bits"], ports[self.shown(number, *found.groups())]["bits"])

        def joined(bits):
            return [bit if bit not in joins else end(bit) for bit in bits]

        def end(bit):
            passed = set()
            while bit in joins:
                if bit in passed:
                    raise PropertiesError("a net became its own driver")
                passed.add(bit)
                bit = joins[bit]
            return bit

        return self.top | {
            "ports": {name: port | {"bits": joined(port["bits"])} for name, port in ports.items()
                      if not PORTS.fullmatch(name)},
            "netnames": {name: net | {"bits": joined(net["bits"])}
                         for name, net in self.top["netnames"].items()},
            "cells": {name: cell | {"connections": {pin: joined(bits) for pin, bits
                                                    in cell["connections"].items()}}
                      for name, cell in self.top["cells"].items()}}


class Start:
    """Gates that read no cut, which are the same in each design; equal ones are one."""

    def __init__(self, model, cuts):
        self.graph = miter.Graph()
        first = 1 + model.inputs + len(model.nexts)
        self.graph.gates = [None] * first
        self.value = value = [2 * node for node in range(first)]
        for variable in cuts:
            value[variable] = None
        for a, b in model.gates:
            x, y = value[a >> 1], value[b >> 1]
            value.append(None if x is None or y is None else
                         self.graph.both(x ^ a & 1, y ^ b & 1))

    def copy(self):
        graph = miter.Graph()
        graph.gates, graph.known = list(self.graph.gates), dict(self.graph.known)
        return graph, list(self.value)


def join(model, joins, words, start):
    """The model and words of its literals, with `joins` {input: literal} joined. The inputs stay,
    but nothing reads those that were joined."""
    first = 1 + model.inputs + len(model.nexts)
    graph, value = start.copy()
    roots = [*model.nexts, *model.bad, *(literal for word in words.values() for literal in word)]
    begun = bytearray(len(value))
    rest = [root >> 1 for root in roots]
    while rest:
        node = rest[-1]
        if value[node] is not None:
            rest.pop()
            continue
        reads = (joins[node],) if node < first else model.gates[node - first]
        missing = [literal >> 1 for literal in reads if value[literal >> 1] is None]
        if not missing:
            ends = [value[literal >> 1] ^ literal & 1 for literal in reads]
            value[node] = ends[0] if node < first else graph.both(*ends)
            continue
        begun[node] = 1
        if any(begun[other] for other in missing):
            raise PropertiesError("the change makes a loop of gates")
        rest += missing

    def joined(literals):
        return [value[literal >> 1] ^ literal & 1 for literal in literals]

    gates = replace(model, nexts=joined(model.nexts), bad=joined(model.bad), outputs=[],
                    gates=graph.gates[first:])
    return gates, {port: joined(word) for port, word in words.items()}


def models(folder, chip, designs):
    """{number: model} of broken designs {number: (SeededBug, whether with products)}, and {number:
    why its change does not apply}. As many at once as can be."""
    found, wrong, alone = {}, {}, {}
    groups = {False: {}, True: {}}
    for n, (bug, products) in designs.items():
        try:
            texts, behind = bug.changed()
        except SeededBugError as error:
            wrong[n] = error
            continue
        alone[n] = leap_model.Source(chip, f"broken{n}", texts, behind, products)
        if behind:
            groups[products][n] = bug
    for products, seeded_bugs in groups.items():
        if len(seeded_bugs) > 1:
            try:
                model = Joined(folder, chip, "whole" if products else "joined", seeded_bugs,
                               products)
                if model.chip(None).peeking:
                    raise PropertiesError("without a change the model refutes no_peeking")
            except PropertiesError as error:
                print(f"  each broken design is made by itself: {error}", flush=True)
                continue
            found |= dict.fromkeys(seeded_bugs, model)
    single = [source for n, source in alone.items() if n not in found]
    said = leap_model.make(folder, single)
    found |= {n: Alone(folder, source, said) for n, source in alone.items() if n not in found}
    return found, wrong
