# SPDX-License-Identifier: Apache-2.0
"""The proof of one block: its promises first, then its covers, then its negative controls."""

import time

from trammel_tools.paths import ROOT
from trammel_tools.proof import abc, formal, induction, properties
from trammel_tools.proof.controls import ControlError
from trammel_tools.proof.counterexample import Counterexample
from trammel_tools.proof.properties import PropertiesError

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
        proofs = [formal.Model(f"asserts{n}", props.asserts, parameters)
                  for n, parameters in enumerate(self.configurations)]
        covers = [formal.Model("covers", props.covers, self.configurations[0])]
        said = formal.write_models(props, self.folder, proofs + covers * bool(props.covers))
        self.promises(proofs, said)
        if props.covers:
            self.covers(formal.read_labels(self.folder, "covers", said))
        if "refuted" in self.doubted.values():
            self.line("negative controls", "not asked: first a promise must hold")
        else:
            self.controls()
        print(f"{self.block}: {len(props.promises)} promises, {len(props.controls)} controls, "
              f"{len(props.covers)} covers in {time.monotonic() - self.begin:.1f} s", flush=True)

    def promises(self, models, said):
        props, times = self.props, dict.fromkeys(self.props.asserts, 0)

        def tell(label, verdict, model):
            if verdict.word != "proven":
                self.doubt(label, verdict, model)
                return
            times[label] += 1
            if label in props.promises and times[label] == len(models):
                controls = sum(label in control.promises for control in props.controls)
                self.line(label, f"proven, {controls} control(s)")

        for model in models:
            labels = formal.read_labels(self.folder, model.name, said)
            if sorted(labels) != sorted(props.asserts):
                missing = ", ".join(sorted(set(props.asserts) - set(labels)))
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
        if label in self.props.promises:
            self.line(label, words)
            if verdict.word == "refuted":
                self.show(label, verdict, model)
        elif self.doubted.keys() & set(self.props.promises):
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

    def controls(self):
        """Each control must refute its promises; one that does not apply is a separate fault."""
        props, models = self.props, {}
        for n, control in enumerate(props.controls):
            try:
                models[n] = formal.Model(f"control{n}", control.promises, self.configurations[0],
                                         *control.changed())
            except ControlError as error:
                self.inapplicable(control, error)
        said = formal.write_models(props, self.folder, list(models.values()))
        good = 0
        for n, model in models.items():
            control = props.controls[n]
            try:
                labels = formal.read_labels(self.folder, model.name, said)
            except PropertiesError as error:
                self.inapplicable(control, error)
                continue
            reached, clocks = abc.reach(self.folder, model.name, labels, props.frames, self.limit,
                                        props.begin)
            kept = [label for label in control.promises if label not in reached]
            self.wrong += [f"{label}: line {control.line}: the control '{control.words}' does not "
                           f"refute it in {clocks} clocks" for label in kept]
            good += not kept
        self.line("negative controls", f"{good} of {len(props.controls)} refute their promises")
        self.wrong += [f"line {number}: {words}" for number, words in props.complaints]
        controlled = {label for control in props.controls for label in control.promises}
        self.wrong += [f"{label}: no negative control (// breaks {label}: ...)"
                       for label in props.promises if label not in controlled]

    def inapplicable(self, control, error):
        self.wrong.append(f"line {control.line}: the control '{control.words}' does not apply any "
                          f"more: {error}; adjust it in rtl/{self.block}_props.sv")
