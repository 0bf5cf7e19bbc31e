# SPDX-License-Identifier: Apache-2.0
"""Proves the outputs of an AIGER model to stay 0, in the order of docs/proofs.md."""

import re
import time
from dataclasses import dataclass

from trammel_tools.proof import abc, aiger

EASY = 20000  # conflicts for all at once: together they are harder than one by one
BRIEF = 10  # [s] for all that is left once something is refuted: much of it rests on that
GOOD = re.compile("Networks are equivalent|network is combinational")


@dataclass
class Verdict:
    word: str  # proven, refuted or open
    clock: int | None = None  # whose end, an edge, sees a refuted one fail


class Proof:
    """tell(label, Verdict) is called as soon as a verdict is known."""

    def __init__(self, folder, name, labels, props, limit, tell):
        self.folder, self.name, self.limit, self.tell = folder, name, limit, tell
        self.labels = labels
        self.order = {label: n for n, label in enumerate(props.all_assertions)}
        self.state = {}  # output: Verdict
        self.end = None  # of asking, once something is refuted

    def place(self, output):
        """In the order of the properties file."""
        return self.order[self.labels[output]]

    def left(self):
        return sorted((n for n in range(len(self.labels)) if n not in self.state), key=self.place)

    def settle(self, output, word, clock=None):
        self.state[output] = Verdict(word, clock)
        self.tell(self.labels[output], self.state[output])

    def proven(self, outputs):
        for n in sorted(outputs, key=self.place):
            self.settle(n, "proven")

    def refuted(self, risen):
        """Assertions are sampled at an edge: their outputs rise in the clock behind it."""
        for n in sorted(risen, key=self.place):
            self.settle(n, "refuted", risen[n] - 1)
        if risen and self.end is None:
            self.end = time.monotonic() + BRIEF

    def ask(self, outputs, engine, model=None):
        limit = self.limit
        if self.end is not None:
            limit = min(limit, int(self.end - time.monotonic()))
            if limit < 1:
                return ""
        lemmas = [n for n, verdict in self.state.items() if verdict.word == "proven"]
        lines = [f"read_aiger {model or self.name}.aig",
                 f"cone -N {','.join(map(str, [*outputs, *lemmas]))}"]
        lines += [f"constr -N {len(lemmas)}", "fold"] if lemmas else []
        lines += ["orpos"] if len(outputs) > 1 else []
        lines += ["scleanup", f"{engine} -T {limit}"]
        # Some commands before the engine know no limit.
        return abc.ask(self.folder, "; ".join(lines), limit + (30 if self.end is None else 1))

    def all_at_once(self, depth):
        if GOOD.search(self.ask(self.left(), f"ind -F {depth} -C {EASY}")):
            self.proven(self.left())

    def one_by_one(self, depth):
        """Mutual induction: none is the first to fail. Those that cannot be shown so are left out
        and the rest tried again; what is proven is a lemma for what is not yet."""
        hoped, guarded = self.left(), f"{self.name}_guarded"
        while hoped:
            aiger.guard(self.folder / f"{self.name}.aig", self.folder / f"{guarded}.aig", hoped)
            shown = [n for n in hoped if GOOD.search(self.ask([n], f"ind -F {depth}", guarded))]
            if shown == hoped:
                self.proven(shown)
                shown = self.left() if shown else []
            hoped = shown

    def reachability(self):
        for n in self.left():
            text = self.ask([n], "dc2; scorr; pdr")
            late = re.search(r"was asserted in frame +(\d+)", text)
            if "Property proved" in text:
                self.proven([n])
            elif late:
                self.refuted({n: int(late[1])})


def prove(folder, name, labels, props, limit, tell):
    """Tells the verdict on each output of name.aig.

    abc's induction is the step only; the bounded search before it is its base.
    """
    proof = Proof(folder, name, labels, props, limit, tell)
    depth = props.depth
    found, complete = abc.base(folder, name, depth, limit)
    proof.refuted(found)
    if complete and proof.left():
        proof.all_at_once(depth)
    if proof.left():
        wanted = [n for n in proof.left() if labels[n] in props.assertions]
        found = abc.quick(folder, name, wanted, props.frames)
        proof.refuted({n: clock for n, clock in found.items() if n in proof.left()})
        if complete:
            proof.one_by_one(depth)
        proof.reachability()
    for n in proof.left():
        proof.settle(n, "open")
