# SPDX-License-Identifier: Apache-2.0
"""Turns a block with its bound properties into AIGER files and asks abc about them.

Yosys (pyosys) reads the RTL, slang its SystemVerilog; every assertion becomes an output that must
stay 0, every cover one that must be able to rise. abc tries induction first, then pdr, which finds
invariants itself.
"""

import json
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import aiger
import yosys
from properties import ROOT, PropertiesError

# A cover is an assertion of the opposite, to be refuted.
COVER_MAP = """(* techmap_celltype = "$cover" *) module cover_as_assert (input A, EN);
  \\$assert _TECHMAP_REPLACE_ (.A(~A), .EN(EN));
endmodule
"""
# Registers without a reset value begin anywhere; nothing is assumed of undriven nets.
TO_AIGER = """formalff -clk2ff -ff2anyinit
setundef -undriven -anyseq
delete -output
opt -full
techmap
dffunmap
aigmap
write_aiger -I -B -zinit -ywmap {name}.json {name}.aig
"""
EASY = 20000  # conflicts for all at once: together they are harder than one by one


@dataclass
class Model:
    """One AIGER file to be: assertions or covers of a block, perhaps with a changed file."""

    name: str
    only: list[str]  # labels
    parameters: list[str] = field(default_factory=list)
    changed: dict[Path, str] = field(default_factory=dict)  # {file: its text instead}


def design(changed, folder, name, *more):
    """The modules and more files; changed texts are put into folder."""
    files = [*yosys.design(), *more]
    for original, text in changed.items():
        copy = folder / f"{name}_{original.name}"
        copy.write_text(text, encoding="utf-8")
        files[files.index(original)] = copy
    return files


def write_script(props, folder, model):
    """name.ys, the Yosys script that makes name.aig and name.json."""
    files = design(model.changed, folder, model.name, props.path)
    options = [f"-G {p}" for p in model.parameters]
    options += [f"--blackboxed-module {m}" for m in props.cut]
    kept = " ".join(f"c:*.{label} %d" for label in model.only)
    lines = [f"read_slang --top {props.stem} {' '.join(options)} {' '.join(map(str, files))}",
             f"delete t:$check {kept}", f"prep -flatten -top {props.stem}"]
    lines += ["cutpoint -blackbox"] if props.cut else []
    lines += [f"cutpoint t:{cell} c:*_props.* %d" for cell in props.free]
    lines += ["memory_map", "async2sync", "chformal -lower", "techmap -map cover_map.v"]
    text = "\n".join(lines) + "\n" + TO_AIGER.format(name=model.name)
    (folder / f"{model.name}.ys").write_text(text, encoding="utf-8")


def write_models(props, folder, models):
    """Runs the models' scripts in one process of Yosys; {name: labels in the order of outputs}."""
    (folder / "cover_map.v").write_text(COVER_MAP, encoding="utf-8")
    for model in models:
        write_script(props, folder, model)
    said = run_scripts(folder, [m.name for m in models], ("aig", "json", "log"))
    return {m.name: read_labels(folder, m.name, said) for m in models}


def run_scripts(folder, names, endings):
    """Runs each name.ys, old files with these endings removed; what Yosys said beside its logs."""
    for name in names:
        for ending in endings:
            (folder / f"{name}.{ending}").unlink(missing_ok=True)
    done = yosys.run(folder, names)
    return done.stdout + done.stderr


def read_labels(folder, name, output):
    """The labels of name.aig."""
    check_made(folder, name, "json", output)
    found = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))["asserts"]
    return [path[0].split(".")[-1].lstrip("\\") for path in found]


def check_made(folder, name, ending, output):
    """An error that says in one line why there is no name.<ending>, the last file of a script."""
    log = folder / f"{name}.log"
    text = log.read_text(encoding="utf-8") if log.exists() else output
    if "implicitly declared" in text:
        raise PropertiesError("a name became a free net: 'implicitly declared' in the log")
    if not (folder / f"{name}.{ending}").exists():
        placed = re.search(r"(\S+\.s?v:\d+): ERROR: (.*)", text)
        if placed:
            place = (folder / placed[1]).resolve()
            where = place.relative_to(ROOT) if place.is_relative_to(ROOT) else place
            raise PropertiesError(f"{where}: {placed[2]}")
        lines = [line for line in text.split("\n") if "ERROR" in line] or [text.strip()[-300:]]
        raise PropertiesError(f"{name}: {lines[0]}")


def abc(folder, commands, limit):
    import pyosys  # it brings abc along
    program = Path(pyosys.__file__).parent / "yosys-abc"
    try:
        done = subprocess.run([program, "-c", commands], cwd=folder, capture_output=True,
                              text=True, check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return ""
    text = done.stdout + done.stderr
    if "cmd error" in text or "Cannot open" in text:
        raise PropertiesError(f"abc: {text.strip().splitlines()[-1]}")
    return text


def prove(folder, name, labels, depth, limit):
    """{label: proven, refuted or open} of the outputs of name.aig.

    First by induction, all in one question. If that is too hard, by mutual induction one by one:
    none is the first to fail. Those that cannot be shown so are left out and the rest tried again;
    what is proven is a lemma for what is not yet. What stays open goes to pdr.

    abc's induction is the step only; the bounded search before it is its base.
    """
    state = dict.fromkeys(range(len(labels)), "open")

    def ask(outputs, engine, model=name):
        lemmas = [n for n, verdict in state.items() if verdict == "proven"]
        lines = [f"read_aiger {model}.aig", f"cone -N {','.join(map(str, [*outputs, *lemmas]))}"]
        lines += [f"constr -N {len(lemmas)}", "fold"] if lemmas else []
        lines += ["orpos"] if len(outputs) > 1 else []
        return abc(folder, "; ".join([*lines, "scleanup", f"{engine} -T {limit}"]), limit + 30)

    def left():
        return [n for n, verdict in state.items() if verdict == "open"]

    def settle(outputs, verdict="proven"):
        state.update(dict.fromkeys(outputs, verdict))

    # An output without state is proven by the base.
    good = re.compile("Networks are equivalent|network is combinational")
    base = abc(folder, f"read_aiger {name}.aig; bmc3 -a -F {depth} -T {limit}", limit + 30)
    settle(risen(base), "refuted")
    if f"No output asserted in {depth} frames" in base:
        if good.search(ask(left(), f"ind -F {depth} -C {EASY}")):
            settle(left())
        hoped = left()
        while hoped:
            aiger.guard(folder / f"{name}.aig", folder / f"{name}_guarded.aig", hoped)
            shown = [n for n in hoped if good.search(ask([n], f"ind -F {depth}",
                                                         f"{name}_guarded"))]
            if shown == hoped:
                settle(shown)
                shown = left() if shown else []
            hoped = shown
    for n in left():
        text = ask([n], "dc2; scorr; pdr")
        if "Property proved" in text:
            settle([n])
        elif "was asserted in frame" in text:
            settle([n], "refuted")
    return {label: state[n] for n, label in enumerate(labels)}


def risen(text):
    """{output: clock at which it rises} from what bmc3 -a says."""
    found = re.findall(r"Output +(\d+) was asserted in frame +(\d+)", text)
    return {int(output): int(clock) for output, clock in found}


def reach(folder, name, labels, frames, limit, begin=0):
    """{label: clock, not before begin, at which its output of name.aig rises}; bounded search."""
    text = abc(folder, f"read_aiger {name}.aig; bmc3 -a -S {begin} -F {frames} -T {limit}",
               limit + 30)
    return {labels[n]: clock for n, clock in risen(text).items()}
