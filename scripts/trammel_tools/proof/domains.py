# SPDX-License-Identifier: Apache-2.0
"""The lemmas that allow clocks by domain and timers that lag, for chips with the ports clock_en_i,
awake_o and timed_o (docs/leap.md).

A domain is a bit of clock_en_i; a register is in that whose bit gates its clock, or runs freely. In
the gates all clocks are one. A domain is timed if it is never awake without timed_o.
"""

import itertools
import json

from trammel_tools.proof import assumed, miter
from trammel_tools.proof.properties import PropertiesError

LEMMAS = {
    "sleep": "a domain that is not awake is left as it is by a clock",
    "free_running": "next > 0: so is what has the free-running clock, beside the timers",
    "timed_awake": "timed_o is high only where a domain is awake",
    "lag_read": "wherever next is read, it is no more than in a state not timed of others",
    "lag_asleep": "next > 1, not timed: timed a clock later only if the timers' old state says so",
    "lag_next": "next > 1, not timed: next falls by one at most, whatever the others do",
    "lag_alone": "next > n, not timed: a leap of n of the timers does not depend on the others",
    "lag_compose": "nor does that a leap of n + 1 is a clock and a leap of n",
    "lag_still": "not timed: nor does it move what else has the free-running clock",
    "unseen": "nor does what the others see: their registers, awake bits and the outputs",
}
# With the products, since equal factors give equal ones; the others take them as free values.
WHOLE = ("unseen",)
ASKING = ("quiescent_o", "awake_o", "timed_o")  # outputs that may move at the end of a leap


def netlist(path):
    """The module with the clocks in a file of write_json."""
    modules = json.loads(path.read_text(encoding="utf-8"))["modules"].values()
    return next((m for m in modules if "clock_en_i" in m["ports"] and "awake_o" in m["ports"]),
                None)


class Domains:
    """Of each register of a chip, by the clocks of its netlist."""

    def __init__(self, top, chip):
        self.top = top
        enables = {bit: n for n, bit in enumerate(top["ports"]["clock_en_i"]["bits"])}
        names = {bits["bits"][0]: name.removeprefix("awake_")
                 for name, bits in top["netnames"].items()
                 if name.startswith("awake_") and len(bits["bits"]) == 1}
        self.names = [names.get(bit, str(n))
                      for n, bit in enumerate(top["ports"]["awake_o"]["bits"])]
        free = top["ports"]["clk_i"]["bits"]
        self.gate = {free[0]: None}  # net of a clock: domain
        for cell in top["cells"].values():
            pins = cell["connections"]
            for side, other in (("A", "B"), ("B", "A")):
                if cell["type"] in ("$and", "$logic_and", "$_AND_") and \
                        pins[side][0] in enables and len(pins["Y"]) == 1 and pins[other] == free:
                    self.gate[pins["Y"][0]] = enables[pins[side][0]]
        self.clocked = clocks = {}  # bit of a register: net of its clock
        for cell in top["cells"].values():
            if "dff" in cell["type"] and "CLK" in cell["connections"]:
                rises = int(cell["parameters"].get("CLK_POLARITY", "1"), 2)
                clock = cell["connections"]["CLK"][0] if rises else None
                clocks |= dict.fromkeys(cell["connections"]["Q"], clock)
        self.nets = {f"{name}[{n + net.get('offset', 0)}]": bit
                 for name, net in top["netnames"].items()
                 for n, bit in enumerate(net["bits"]) if bit in clocks}
        for bit in chip.registers:
            if bit not in self.nets:
                raise PropertiesError(f"register {bit} has no clock")
        self.of = {bit: self.domain(f"register {bit}", clocks[self.nets[bit]])
                   for bit in chip.registers}
        self.memories = {}
        for name in chip.memories:
            found = {self.domain(f"memory {name}", clock)
                     for clock in top["ports"].get(f"{name}.WR_CLK", {"bits": []})["bits"]}
            if len(found) > 1:
                raise PropertiesError(f"memory {name} is written in more than one domain")
            self.memories |= dict.fromkeys([name] * len(found), *found)

    def domain(self, what, clock):
        """Of what has this clock: a bit of clock_en_i, or None where it runs freely."""
        if clock not in self.gate:
            raise PropertiesError(f"{what}: its clock is neither clk_i nor clk_i with one enable "
                                  "of clock_en_i")
        return self.gate[clock]


class View:
    """One state of a chip with its inputs, and what a clock or a leap makes of it."""

    def __init__(self, questions, registers, ports, leap=None):
        chip, g = questions.chip, questions.graph
        given = dict(ports) | registers
        given |= {chip.inputs[f"leap_i[{n}]"]: bit
                  for n, bit in enumerate(leap or [0] * questions.width)}
        read = [(memory, g.word(len(memory.data))) for memory in chip.memories.values()]
        given |= {v: bit for memory, word in read for v, bit in zip(memory.data, word)}
        self.reads = [(memory, g.copy(chip.gates, given, memory.address), word)
                      for memory, word in read]
        nexts = [chip.nexts[bit] for bit in chip.registers]
        outputs = [literal for word in chip.outputs.values() for literal in word]
        writes = [w for memory in chip.memories.values() for w in memory.enables + memory.written]
        literals = iter(g.copy(chip.gates, given, nexts + outputs + writes + chip.gates.bad))
        self.after = {bit: next(literals) for bit in chip.registers}
        self.out = {port: [next(literals) for _ in word] for port, word in chip.outputs.items()}
        self.writes, self.written = {}, {}
        for name, memory in chip.memories.items():
            self.writes[name] = [next(literals) for _ in memory.enables]
            self.written[name] = [next(literals) for _ in memory.written]
        self.reached = g.every(bad ^ 1 for bad in literals)
        self.next, self.timed = self.out["next_o"], self.out["timed_o"][0]
        self.awake = self.out["awake_o"]


class Questions:
    """Each method gives what must never be true, and pairs of which one then differs."""

    def __init__(self, chip, domains, width):
        self.chip, self.domains, self.width = chip, domains, width
        self.graph = g = miter.Graph()
        self.timers = set(chip.timers)
        self.known = None  # timed domains, once they are asked for
        self.now = {v: g.free() for v in chip.registers.values()}
        self.ports = self.pins()
        self.state = View(self, self.now, self.ports)

    def pins(self):
        g, chip = self.graph, self.chip
        ports = {v: g.free() for port, v in chip.inputs.items() if not port.startswith("leap_i[")}
        ports[chip.inputs[next(p for p in ("rst_i[0]", "rst[0]") if p in chip.inputs)]] = 0
        return ports | {v: 1 if name.endswith(".live_q") else g.free()
                        for v, name in chip.shadows.items()}

    def timed(self, domain):
        """What is true where the domain is awake without timed_o."""
        s = self.state
        return self.graph.both(s.reached, self.graph.both(s.awake[domain], s.timed ^ 1))

    def others(self, timed, timers):
        """Registers with the timers as `timers` says, those of untimed domains free."""
        found = {}
        for bit, v in self.chip.registers.items():
            if bit in self.timers:
                found[v] = timers[bit]
            else:
                domain = self.domains.of[bit]
                free = domain is not None and domain not in timed
                found[v] = self.graph.free() if free else self.now[v]
        return found

    def same_memory(self, *views):
        g = self.graph
        reads = [read for view in views for read in view.reads]
        return g.every(g.either(g.unequal(a, b), g.unequal(x, y) ^ 1)
                       for (one, a, x), (other, b, y) in itertools.combinations(reads, 2)
                       if one is other)

    def moved(self, pairs):
        return self.graph.some(self.graph.differ(a, b) for a, b in pairs.values())

    def sleep(self, domain):
        s, g = self.state, self.graph
        pairs = {bit: (self.now[v], s.after[bit]) for bit, v in self.chip.registers.items()
                 if self.domains.of[bit] == domain}
        pairs |= self.written(s, domain)
        return g.every([s.reached, s.awake[domain] ^ 1, self.moved(pairs)]), pairs

    def written(self, view, domain):
        """{enable of a write to a memory of the domain: (low, what it is)}"""
        return {f"{name}[{n}]": (0, enable) for name, enables in view.writes.items()
                if name in self.domains.memories and self.domains.memories[name] == domain
                for n, enable in enumerate(enables)}

    def free_running(self):
        s, g = self.state, self.graph
        pairs = {bit: (self.now[v], s.after[bit]) for bit, v in self.chip.registers.items()
                 if self.domains.of[bit] is None and bit not in self.timers}
        pairs |= self.written(s, None)
        return g.every([s.reached, g.some(s.next), self.moved(pairs)]), pairs

    def lagging(self, timed):
        """The state, not timed, and another one a clock later: the timers counted, untimed domains
        and pins did anything."""
        s, g = self.state, self.graph
        later = View(self, self.others(timed, s.after), self.pins())
        may = g.every([s.reached, later.reached, s.timed ^ 1, g.some(s.next[1:])])
        return later, may

    def stale(self, timed):
        """The later one, and what it looks like with the timers' old state."""
        s, g = self.state, self.graph
        registers, ports = self.others(timed, s.after), self.pins()
        old = {v: self.now[v] if bit in self.timers else registers[v]
               for bit, v in self.chip.registers.items()}
        # What is read out of range is the same free value in both.
        known = set(ports) | {v for m in self.chip.memories.values() for v in m.data}
        ports |= {v: g.free() for v in range(1, self.chip.gates.inputs + 1)
                  if v not in known and v not in self.chip.inputs.values()}
        later, stale = View(self, registers, ports), View(self, old, ports)
        may = g.every([s.reached, later.reached, stale.reached, s.timed ^ 1, g.some(s.next[1:])])
        return later, stale, may

    def timed_awake(self):
        s = self.state
        return self.graph.every([s.reached, s.timed, self.graph.some(s.awake) ^ 1]), {}

    def beside(self, timed, leap=None):
        """The same timers, beside untimed domains and pins of any kind."""
        kept = {bit: self.now[self.chip.registers[bit]] for bit in self.timers}
        return View(self, self.others(timed, kept), self.pins(), leap)

    def lag_read(self, timed):
        g, s = self.graph, self.state
        read = self.beside(timed)
        return g.every([s.reached, read.reached, s.timed ^ 1,
                        g.less(s.next, read.next)]), {}

    def lag_asleep(self, timed):
        later, stale, may = self.stale(timed)
        return self.graph.every([may, later.timed, stale.timed ^ 1]), {}

    def lag_next(self, timed):
        """Of each next_o, blocks first: they help with that of the chip."""
        g, s = self.graph, self.state
        later, may = self.lagging(timed)
        may = g.both(may, later.timed ^ 1)
        ports = sorted((p for p in s.out if p.endswith("next_o")), key=lambda p: -p.count("."))
        return {port: g.both(may, g.less(g.plus_one(later.out[port]), [*s.out[port], 0]))
                for port in ports}

    def lag_alone(self, timed):
        g, s = self.graph, self.state
        leap = g.word(self.width)
        one = View(self, self.now, self.ports, leap)
        other = self.beside(timed, leap)
        pairs = {bit: (one.after[bit], other.after[bit]) for bit in self.chip.timers}
        may = g.every([s.reached, one.reached, other.reached, s.timed ^ 1,
                       g.less([*leap, 0], [*s.next, 0])])
        return g.both(may, self.moved(pairs)), pairs

    def lag_still(self, timed):
        g, s = self.graph, self.state
        leap = g.word(self.width)
        other = self.beside(timed, leap)
        pairs = {bit: (self.now[v], other.after[bit]) for bit, v in self.chip.registers.items()
                 if self.domains.of[bit] is None and bit not in self.timers}
        pairs |= self.written(other, None)
        may = g.every([s.reached, other.reached, s.timed ^ 1, g.less([*leap, 0], [*s.next, 0])])
        return g.both(may, self.moved(pairs)), pairs

    def lag_compose(self, timed):
        g, s = self.graph, self.state
        leap = g.word(self.width)
        longer = g.plus_one(leap)
        at_once = View(self, self.now, self.ports, longer[:self.width])
        later = View(self, self.others(timed, s.after), self.pins(), leap)
        pairs = {bit: (at_once.after[bit], later.after[bit]) for bit in self.chip.timers}
        may = g.every([s.reached, later.reached, s.timed ^ 1, g.less(longer, [*s.next, 0])])
        return g.both(may, self.moved(pairs)), pairs

    def unseen(self, timed):
        g = self.graph
        later, stale, may = self.stale(timed)
        untimed = [d for d in range(len(later.awake)) if d not in timed]
        pairs = {bit: (later.after[bit], stale.after[bit]) for bit in self.chip.registers
                 if self.domains.of[bit] in untimed}
        pairs |= {f"awake_{self.domains.names[d]}": (later.awake[d], stale.awake[d])
                  for d in untimed}
        pairs |= {f"{name}[{n}]": pair for name in later.writes
                  if self.domains.memories.get(name) in untimed
                  for n, pair in enumerate(zip(later.writes[name] + later.written[name],
                                               stale.writes[name] + stale.written[name]))}
        pairs |= {f"{port}[{n}]": pair for port, word in later.out.items()
                  if "." not in port and port not in ("next_o", *ASKING)
                  for n, pair in enumerate(zip(word, stale.out[port]))}
        return g.every([may, later.timed ^ 1, stale.timed ^ 1, self.same_memory(later, stale),
                        self.moved(pairs)]), pairs


def settle(questions, lemma, ask):
    """The verdict on one lemma and what refutes it. `ask` gives verdict and value of a literal."""
    domains = range(len(questions.state.awake))
    if lemma == "sleep":
        for domain in domains:
            verdict, how = told(ask, *questions.sleep(domain))
            if verdict != "proven":
                return verdict, f"domain {questions.domains.names[domain]}: {how}"
        return "proven", ""
    if lemma in ("free_running", "timed_awake"):
        return told(ask, *getattr(questions, lemma)())
    if questions.known is None:
        questions.known = [d for d in domains if ask(questions.timed(d))[0] == "proven"]
        assumed.check(questions.domains, questions.timers, questions.known)
    timed = questions.known
    if lemma == "lag_next":
        fall = []
        for bad in questions.lag_next(timed).values():
            verdict, _ = ask(questions.graph.every([bad, *(k ^ 1 for k in fall)]))
            if verdict == "proven":
                fall.append(bad)
        return verdict, ""
    return told(ask, *getattr(questions, lemma)(timed))


def told(ask, bad, pairs):
    verdict, value = ask(bad)
    if verdict != "refuted":
        return verdict, ""
    moved = list(dict.fromkeys(bit.rpartition("[")[0] or bit for bit, (a, b) in pairs.items()
                               if value(a) != value(b)))
    return verdict, f"{', '.join(moved[:3])}{' ...' if moved[3:] else ''}"
