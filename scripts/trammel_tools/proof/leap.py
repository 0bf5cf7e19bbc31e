# SPDX-License-Identifier: Apache-2.0
"""The lemmas that allow a leap, asked of every chip that leaps (docs/leap.md), and the broken
designs that must refute them: rtl/chips/<chip>_leap.toml, a table [[broken]] each with

  what = "..."       the mistake
  lemma = "..."      that must be refuted, or a list of them
  module = "..."     that changes
  change = "..."     as a negative control: net = expression (proof/seeded_bugs.py)
"""

import itertools
import sys
import time
import tomllib
from collections import Counter

from trammel_tools.paths import ROOT, RTL
from trammel_tools.proof import abc, domains, joined, leap_model, miter
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.proof.seeded_bugs import SeededBugError, parse

OUT = ROOT / "build" / "formal"
LEMMAS = {
    "no_peeking": "no output and no memory depends on leap_i",
    "stay": "next > 0: a clock leaves memories and registers outside the timers as they are",
    "stay_n": "so does a leap, for none of these reads leap_i",
    "compose": "next > n: a leap of n + 1 clocks is a clock, then a leap of n, on the timers",
    "down_outputs": "next > 0: a clock moves no output",
    "down_quiescent": "next > 1: still quiescent after a clock",
    "down_next": "next > 1: next falls by one at most",
}
WORD = 12  # bits of leap_i and next_o


class Questions:
    """Each method gives what must never be true: the opposite of a lemma."""

    def __init__(self, chip):
        self.chip = chip
        self.graph = g = miter.Graph()
        self.ports = {v: g.free() for p, v in chip.inputs.items() if not p.startswith("leap_i[")}
        reset = next(port for port in ("rst_i[0]", "rst[0]") if port in chip.inputs)
        self.ports[chip.inputs[reset]] = 0
        # Properties hold from the first reset on, which live_q remembers.
        self.ports |= {v: 1 if name.endswith(".live_q") else g.free()
                       for v, name in chip.shadows.items()}
        self.now = {v: g.free() for v in chip.registers.values()}
        self.reads = []  # (memory, address, word) of the graph
        self.more = g.word(WORD)  # clocks of a leap behind its first one
        timers = set(chip.timers)
        self.still = [bit for bit in chip.registers if bit not in timers]
        nexts = [chip.nexts[bit] for bit in chip.registers]
        outputs = [literal for word in chip.outputs.values() for literal in word]
        enables = [literal for memory in chip.memories.values() for literal in memory.enables]
        plain = self.clock(self.now, [0] * WORD, nexts + outputs + enables + chip.gates.bad)
        self.after = dict(zip(chip.registers, plain))
        self.before_words = self.words(plain[len(nexts):])
        rests = plain[len(nexts) + len(outputs):]
        self.writes = dict(zip((f"{name}[{n}]" for name, memory in chip.memories.items()
                                for n in range(len(memory.enables))), rests))
        # One clock later only the timers have moved: that is what `stay` says.
        self.then = {v: self.after[bit] if bit in timers else self.now[v]
                     for bit, v in chip.registers.items()}
        self.after_words = self.words(self.clock(self.then, [0] * WORD, outputs))
        self.next = self.before_words["next_o"]
        self.quiet = g.both(g.every(bad ^ 1 for bad in rests[len(enables):]),
                            self.before_words["quiescent_o"][0])

    def clock(self, registers, leap, roots):
        given = self.ports | registers
        given |= {self.chip.inputs[f"leap_i[{n}]"]: literal for n, literal in enumerate(leap)}
        # An address may show what another memory reads: all words are there before any address.
        read = [(memory, self.graph.word(len(memory.data)))
                for memory in self.chip.memories.values()]
        given |= {v: bit for memory, word in read for v, bit in zip(memory.data, word)}
        self.reads += [(memory, self.graph.copy(self.chip.gates, given, memory.address), word)
                       for memory, word in read]
        return self.graph.copy(self.chip.gates, given, roots)

    def quiet_for(self, clocks):
        """Quiescent, `clocks` (1 or 2) before the next event at least, and of each memory the same
        word at the same address: none is written, says `stay`."""
        g = self.graph
        same = [g.either(g.unequal(a, b), g.unequal(x, y) ^ 1)
                for (one, a, x), (other, b, y) in itertools.combinations(self.reads, 2)
                if one is other]
        return g.every([self.quiet, g.some(self.next[clocks - 1:]), *same])

    def words(self, literals):
        literals = iter(literals)
        return {port: [next(literals) for _ in bits] for port, bits in self.chip.outputs.items()}

    def pairs(self, lemma):
        """{name: two literals that the lemma says are equal}."""
        if lemma == "stay":
            written = {bit: (0, enable) for bit, enable in self.writes.items()}
            return written | {bit: (self.now[self.chip.registers[bit]], self.after[bit])
                              for bit in self.still}
        if lemma == "compose":
            roots = [self.chip.nexts[bit] for bit in self.chip.timers]
            at_once = self.clock(self.now, self.graph.plus_one(self.more)[:WORD], roots)
            return dict(zip(self.chip.timers, zip(
                at_once, self.clock(self.then, self.more, roots), strict=True)))
        return {f"{port}[{n}]": pair for port, word in self.before_words.items()
                if port not in domains.ASKING and not port.endswith("next_o")
                for n, pair in enumerate(zip(word, self.after_words[port], strict=True))}

    def differs(self, lemma, pairs):
        g = self.graph
        may = self.quiet_for(1)
        if lemma == "compose":
            longer = g.plus_one(self.more)
            may = g.both(may, g.less(longer, [*self.next, 0]))
        return g.both(may, g.some(g.differ(a, b) for a, b in pairs.values()))

    def no_more_quiescent(self):
        return self.graph.both(self.quiet_for(2), self.after_words["quiescent_o"][0] ^ 1)

    def falls_fast(self, port):
        """The number at this port, a next_o of the chip or of a block, falls by more than one."""
        g = self.graph
        return g.both(self.quiet_for(2), g.less(g.plus_one(self.after_words[port]),
                                             [*self.before_words[port], 0]))


def ask(folder, name, graph, bad, limit):
    """Whether `bad` can be true: proven (it cannot), refuted or open; and the values that do it."""
    if bad == 0:
        return "proven", None
    graph.write(folder / f"{name}.aig", bad)
    witness = folder / f"{name}.cex"
    witness.unlink(missing_ok=True)
    said = abc.ask(folder, f"read_aiger {name}.aig; strash; &get; &glucose; "
                           f"write_cex -a {name}.cex", limit)
    if "UNSATISFIABLE" in said:
        return "proven", None
    if "SATISFIABLE" not in said or not witness.exists():
        return "open", None
    bits = max(witness.read_text(encoding="ascii").split(), key=len)
    value = graph.simulate(map(int, bits))
    if not value(bad):
        raise PropertiesError(f"{name}: abc's values do not refute the lemma")
    return "refuted", value


def number(value, word):
    return sum(value(bit) << n for n, bit in enumerate(word))


def settle(folder, name, chip, questions, lemma, limit):
    """The verdict on one lemma, and what refutes it."""
    if lemma == "no_peeking":
        return ("refuted", ", ".join(chip.peeking)) if chip.peeking else ("proven", "")
    if lemma == "stay_n":  # what reads leap_i is called a timer, and no memory does: no_peeking
        return "proven", ""
    if lemma == "down_next":
        return fall(folder, name, questions, limit)
    if lemma == "down_quiescent":
        verdict, value = ask(folder, name, questions.graph, questions.no_more_quiescent(), limit)
        return verdict, f"next {number(value, questions.next)}" if value else ""
    pairs = questions.pairs(lemma)
    verdict, value = ask(folder, name, questions.graph, questions.differs(lemma, pairs), limit)
    if verdict != "refuted":
        return verdict, ""
    moved = list(dict.fromkeys(bit.rpartition("[")[0] for bit, (a, b) in pairs.items()
                               if value(a) != value(b)))
    return verdict, f"{', '.join(moved[:3])}{' ...' if moved[3:] else ''} with next " \
                    f"{number(value, questions.next)}"


def fall(folder, name, questions, limit):
    """down_next. All at once is too hard: that the next_o of each block falls by one at most is
    asked first, the innermost first, and helps where it is so."""
    g = questions.graph
    known = {}
    ports = [port for port in questions.before_words if port.endswith("next_o")]
    for port in sorted(ports, key=lambda port: -port.count(".")):
        word = tuple(questions.before_words[port])
        if word in known and port != "next_o":
            continue
        bad = questions.falls_fast(port)
        lemmas = g.every(other ^ 1 for other in known.values())
        verdict, value = ask(folder, name, g, g.both(bad, lemmas), limit)
        if verdict == "proven":
            known[word] = bad
    if not value:
        return verdict, ""
    return verdict, f"from {number(value, questions.next)} to " \
                    f"{number(value, questions.after_words['next_o'])}"


def domain_questions(netlist, made):
    return domains.Questions(made, domains.Domains(netlist, made), WORD)


def settle_domains(folder, name, asked, lemma, limit):
    """As settle(), of a lemma of clock domains."""
    return domains.settle(asked, lemma, lambda bad: ask(folder, name, asked.graph, bad, limit))


def check_chip(chip, limit):
    """Asks every lemma of a chip; lines of what went wrong."""
    folder = OUT / f"{chip.replace('/', '_')}_leap"
    folder.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    source = leap_model.Source(chip, "chip")
    whole = leap_model.Source(chip, "whole", products=True)
    said = leap_model.make(folder, [source])
    made = leap_model.made(folder, source, said)
    widths = {}
    for bit in made.timers:
        widths[bit.rpartition("[")[0]] = widths.get(bit.rpartition("[")[0], 0) + 1
    print(f"{chip}: {len(made.registers)} register bits, {len(made.timers)} of them move with a "
          f"leap: {', '.join(f'{name} ({width})' for name, width in widths.items())}")
    questions = Questions(made)
    wrong = []
    for lemma, sentence in LEMMAS.items():
        start = time.monotonic()
        verdict, how = settle(folder, lemma, made, questions, lemma, limit)
        took = time.monotonic() - start
        print(f"  {lemma:<15} {verdict:<8} {took:5.1f} s  {sentence}", flush=True)
        if verdict != "proven":
            wrong.append(f"{lemma}: {verdict} {how}".rstrip())
    asked = len(LEMMAS)
    if leap_model.has_domains(chip):
        said = leap_model.make(folder, [whole])
        models = {source.products: (source.name, domain_questions(
            domains.netlist(folder / f"{source.name}.cells.json"), model))
            for source, model in ((source, made), (whole, leap_model.made(folder, whole, said)))}
        for lemma, sentence in domains.LEMMAS.items():
            start = time.monotonic()
            name, questions = models[lemma in domains.WHOLE]
            verdict, how = settle_domains(folder, f"{name}_{lemma}", questions, lemma, limit)
            took = time.monotonic() - start
            print(f"  {lemma:<15} {verdict:<8} {took:5.1f} s  {sentence}", flush=True)
            if verdict != "proven":
                wrong.append(f"{lemma}: {verdict} {how}".rstrip())
        asked += len(domains.LEMMAS)
    print(f"{chip}: {asked} lemmas in {time.monotonic() - begin:.1f} s")
    return wrong


def as_list(lemma):
    return [lemma] if isinstance(lemma, str) else lemma


def broken_designs(chip):
    """[(what, lemmas, SeededBug)] of rtl/<chip>_leap.toml."""
    path = RTL / f"{chip}_leap.toml"
    where = f"rtl/{chip}_leap.toml"
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))["broken"]
        found = [(d["what"], as_list(d["lemma"]),
                  parse(f" {as_list(d['lemma'])[0]} ({d['module']}): {d['change']}"))
                 for d in table]
    except (OSError, KeyError, tomllib.TOMLDecodeError, SeededBugError) as error:
        raise PropertiesError(f"{where}: no table of broken designs: {error!r}") from error
    named = Counter(lemma for _, lemmas, _ in found for lemma in lemmas)
    wanted = dict.fromkeys(set(LEMMAS) - {"stay_n"}, 1)
    if leap_model.has_domains(chip):
        wanted |= dict.fromkeys(domains.LEMMAS, 2)
    for lemma in sorted(set(named) - set(LEMMAS) - set(domains.LEMMAS)):
        raise PropertiesError(f"{where}: {lemma}: no lemma")
    for lemma, number in sorted(wanted.items()):
        if named[lemma] < number:
            raise PropertiesError(f"{where}: {lemma}: refutes broken designs: "
                                  f"{named[lemma]}, at least {number}")
    return found


def check_broken(chip, limit):
    """Each broken design must be refuted by its lemma; lines of what went wrong."""
    folder = OUT / f"{chip.replace('/', '_')}_broken"
    folder.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    designs = broken_designs(chip)
    models, failed = joined.models(folder, chip, {
        n: (bug, bool(set(lemmas) & set(domains.WHOLE)))
        for n, (_, lemmas, bug) in enumerate(designs)})
    wrong = []
    for n, (what, lemmas, bug) in enumerate(designs):
        try:
            if n in failed:
                raise failed[n]
            made = models[n].chip(n)
        except (SeededBugError, PropertiesError) as error:
            wrong.append(f"{what}: `{bug.words}` does not apply any more: {error}")
            continue
        plain = timed = None
        for lemma in lemmas:
            name = f"broken{n}_{lemma}"
            if lemma in domains.LEMMAS:
                timed = timed or domain_questions(models[n].netlist(n), made)
                verdict, how = settle_domains(folder, name, timed, lemma, limit)
            else:
                plain = plain or Questions(made)
                verdict, how = settle(folder, name, made, plain, lemma, limit)
            print(f"  {lemma:<15} {verdict:<8} {what}{': ' * bool(how)}{how}", flush=True)
            if verdict != "refuted":
                wrong.append(f"{what}: {lemma} does not refute `{bug.words}`")
    print(f"{chip}: {len(designs)} broken designs in {time.monotonic() - begin:.1f} s")
    return wrong


def run(chips, broken, limit):
    """The exit code; prints a line a lemma or a broken design."""
    bad = 0
    for chip in chips:
        try:
            wrong = check_broken(chip, limit) if broken else check_chip(chip, limit)
        except PropertiesError as error:
            wrong = [str(error)]
        for line in wrong:
            print(f"prove: {chip}: {line}", file=sys.stderr)
        bad += bool(wrong)
    return 1 if bad else 0
