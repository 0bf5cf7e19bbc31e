# SPDX-License-Identifier: Apache-2.0
"""The proof of one block: its promises first, then its covers, then its negative controls."""

import time

from trammel_tools.paths import ROOT
from trammel_tools.proof import abc, formal, induction, properties
from trammel_tools.proof.counterexample import Counterexample
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.proof.seeded_bugs import SeededBugError

OUT = ROOT / "build" / "formal"


class BlockProof:
    """Prints each result as soon as it is known; `wrong` are lines of what went wrong."""

    def __init__(self, block, limit):
        self.begin = time.monotonic()
        self.block, self.limit = block, limit
        self.props = properties.read(block)
        self.folder = OUT / block.replace("/", "_")
        self.folder.mkdir(parents=True, exist_ok=True)
        self.configurations = self.props.configurations or [[]]
        self.wrong = []
        self.doubted = {}  # label: refuted or open

    def run(self):
        props = self.props
        proofs = [formal.Model(f"asserts{n}", props.all_assertions, parameters)
                  for n, parameters in enumerate(self.configurations)]
        covers = [formal.Model("covers", props.covers, self.configurations[0])]
        said = formal.write_models(props, self.folder, proofs + covers * bool(props.covers))
        self.assertions(proofs, said)
        if props.covers:
            self.covers(formal.read_labels(self.folder, "covers", said))
        if "refuted" in self.doubted.values():
            self.line("negative controls", "not asked: first a promise must hold")
        else:
            self.seeded_bugs()
        print(f"{self.block}: {len(props.assertions)} promises, {len(props.seeded_bugs)} controls, "
              f"{len(props.covers)} covers in {time.monotonic() - self.begin:.1f} s", flush=True)

    def assertions(self, models, said):
        props, times = self.props, dict.fromkeys(self.props.all_assertions, 0)

        def tell(label, verdict, model):
            if verdict.word != "proven":
                self.doubt(label, verdict, model)
                return
            times[label] += 1
            if label in props.assertions and times[label] == len(models):
                seeded_bugs = sum(label in bug.assertions for bug in props.seeded_bugs)
                self.line(label, f"proven, {seeded_bugs} control(s)")

        for model in models:
            labels = formal.read_labels(self.folder, model.name, said)
            if sorted(labels) != sorted(props.all_assertions):
                missing = ", ".join(sorted(set(props.all_assertions) - set(labels)))
                raise PropertiesError(
                    f"rtl/{self.block}_props.sv: assertions that did not arrive: {missing}; "
                    "one that says the same as another is merged with it")
            induction.prove(self.folder, model.name, labels, props, self.limit,
                            lambda label, verdict, model=model: tell(label, verdict, model))

    def doubt(self, label, verdict, model):
        """A promise that is refuted or open; helpers are of interest when no promise is."""
        self.doubted[label] = verdict.word
        when = [] if verdict.clock is None else [f"at clock {verdict.clock}"]
        words = " ".join([verdict.word, *when, *model.parameters])
        if label in self.props.assertions:
            self.line(label, words)
            if verdict.word == "refuted":
                self.show(label, verdict, model)
        elif self.doubted.keys() & set(self.props.assertions):
            return
        self.wrong.append(f"{label}: {words}")

    def show(self, label, verdict, model):
        """Waves of a refuted promise."""
        found = Counterexample(self.props, self.folder, model, label, verdict.clock + 2, self.limit)
        print(f"    at clock {found.clock}: {found.words()}\n"
              f"    to look at it: gtkwave {found.view.relative_to(ROOT)}", flush=True)

    def line(self, label, words):
        print(f"  {label:<44} {words}", flush=True)

    def covers(self, labels):
        reached, clocks = abc.reach(self.folder, "covers", labels, self.props.frames, self.limit)
        for label in self.props.covers:
            if label in reached:
                self.line(label, f"reached at clock {reached[label] - 1}")
                continue
            words = f"not reached within {clocks} clocks: no input from reset on leads there"
            if clocks < self.props.frames:
                words += f"; {self.limit} s were not enough to search {self.props.frames}"
            self.line(label, words)
            self.wrong.append(f"{label}: {words}")

    def seeded_bugs(self):
        """Each control must refute its promises; one that does not apply is a separate fault."""
        props, models = self.props, {}
        for n, bug in enumerate(props.seeded_bugs):
            try:
                models[n] = formal.Model(f"bug{n}", bug.assertions, self.configurations[0],
                                         *bug.changed())
            except SeededBugError as error:
                self.inapplicable(bug, error)
        said = formal.write_models(props, self.folder, list(models.values()))
        good = 0
        for n, model in models.items():
            bug = props.seeded_bugs[n]
            try:
                labels = formal.read_labels(self.folder, model.name, said)
            except PropertiesError as error:
                self.inapplicable(bug, error)
                continue
            reached, clocks = abc.reach(self.folder, model.name, labels, props.frames, self.limit,
                                        props.begin)
            kept = [label for label in bug.assertions if label not in reached]
            self.wrong += [f"{label}: line {bug.line}: the control '{bug.words}' does not "
                           f"refute it in {clocks} clocks" for label in kept]
            good += not kept
        self.line("negative controls", f"{good} of {len(props.seeded_bugs)} refute their promises")
        self.wrong += [f"line {number}: {words}" for number, words in props.complaints]
        tried = {label for bug in props.seeded_bugs for label in bug.assertions}
        self.wrong += [f"{label}: no negative control (// breaks {label}: ...)"
                       for label in props.assertions if label not in tried]

    def inapplicable(self, bug, error):
        self.wrong.append(f"line {bug.line}: the control '{bug.words}' does not apply any "
                          f"more: {error}; adjust it in rtl/{self.block}_props.sv")
