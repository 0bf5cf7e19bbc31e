# SPDX-License-Identifier: Apache-2.0
"""Turns a block with its bound properties into AIGER files and asks abc about them.

Yosys (pyosys) reads the RTL, slang its SystemVerilog; every assertion becomes an output that must
stay 0, every cover one that must be able to rise. abc's pdr finds the invariants itself.
"""

import json
import re
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import lint

ROOT = Path(__file__).resolve().parent.parent
RTL = ROOT / "rtl"

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
opt -fast
dffunmap
aigmap
opt_clean
write_aiger -I -B -zinit -ywmap {stem}.json {stem}.aig
"""


class FormalError(Exception):
    """What is wrong with a properties file or with what the tools said of it; one line."""


@dataclass
class Control:
    """A change of a module's text that must refute: `// breaks a, b (module): old => new`."""

    promises: list[str]
    module: str
    old: str
    new: str
    line: int


@dataclass
class Properties:
    block: str  # layer/stem
    promises: list[str] = field(default_factory=list)
    helpers: list[str] = field(default_factory=list)  # inv_*: they only help the proof
    covers: list[str] = field(default_factory=list)
    controls: list[Control] = field(default_factory=list)
    cut: list[str] = field(default_factory=list)  # modules whose outputs are free
    free: list[str] = field(default_factory=list)  # cell types whose outputs are free
    parameters: list[str] = field(default_factory=list)  # Name=value of the block
    frames: int = 100  # depth of the search for covers and refutations

    @property
    def stem(self):
        return self.block.split("/")[1]

    @property
    def path(self):
        return RTL / f"{self.block}_props.sv"

    @property
    def asserts(self):
        return self.promises + self.helpers


def module_file(stem):
    found = sorted(p for p in RTL.rglob(f"{stem}.sv"))
    if not found:
        raise FormalError(f"no module {stem} in rtl/")
    return found[0]


def read_properties(block):
    """Labels, negative controls and options of rtl/<block>_props.sv."""
    props = Properties(block)
    where = f"rtl/{block}_props.sv"
    text = props.path.read_text(encoding="utf-8")
    code = "\n".join(line.split("//")[0] for line in text.split("\n"))
    for label, kind in re.findall(r"(\w+)\s*:\s*(assert|cover)\s*\(", code):
        wanted = props.covers if kind == "cover" else (
            props.helpers if label.startswith("inv_") else props.promises)
        wanted.append(label)
    bare = len(re.findall(r"\b(?:assert|cover)\s*\(", code))
    if bare != len(props.asserts) + len(props.covers):
        raise FormalError(f"{where}: every assert and cover needs a label")
    if re.search(r"\bassume\b", code):
        raise FormalError(f"{where}: no assume; make the restriction an antecedent")
    for number, line in enumerate(text.split("\n"), 1):
        breaks = re.match(r"\s*// breaks ([\w, ]+?)(?: \((\w+)\))?: (.+?) => (.*)$", line)
        if breaks:
            names = [n.strip() for n in breaks[1].split(",")]
            props.controls.append(Control(names, breaks[2] or props.stem, breaks[3],
                                          breaks[4], number))
            for name in names:
                if name not in props.promises:
                    raise FormalError(f"{where}:{number}: no promise {name}")
        elif re.match(r"\s*// breaks\b", line):
            raise FormalError(f"{where}:{number}: not `breaks name: old => new`")
        option = re.match(r"\s*// prove: (\w+) (.+)$", line)
        if option:
            words = option[2].split()
            match option[1]:
                case "cut": props.cut += words
                case "free": props.free += words
                case "set": props.parameters += words
                case "frames": props.frames = int(words[0])
                case _: raise FormalError(f"{where}:{number}: unknown option {option[1]}")
    if not props.promises:
        raise FormalError(f"{where}: promises nothing")
    return props


def sources(props):
    """Every module but the cut ones' properties; slang takes what the top needs."""
    own = sorted(p for p in RTL.glob("*/*.sv")
                 if p.parent.name != "boards" and not p.stem.endswith(("_pkg", "_props")))
    generated = sorted(p for p in (RTL / "chips" / "generated").glob("*.sv")
                       if not p.stem.endswith("_pkg"))
    return [*lint.packages(), *own, *generated, props.path]


def yosys(script, folder, name):
    """Runs a Yosys script in a process of its own; its log stays in the folder."""
    (folder / f"{name}.ys").write_text(script, encoding="utf-8")
    code = ("from pyosys import libyosys as ys\n"
            f"ys.run_pass('tee -q -o {name}.log script {name}.ys', ys.Design())")
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True,
                          text=True, check=False)
    log = folder / f"{name}.log"
    text = log.read_text(encoding="utf-8") if log.exists() else done.stdout + done.stderr
    if done.returncode != 0:
        lines = [line for line in text.split("\n") if "rror" in line] or [text.strip()[-300:]]
        raise FormalError(lines[0])
    if "implicitly declared" in text:
        raise FormalError("a name became a free net: 'implicitly declared' in the log")
    return text


def read_script(props, replaced=None):
    """Yosys lines that read the block; `replaced` maps a module's file to another text's."""
    files = [str((replaced or {}).get(p, p)) for p in sources(props)]
    options = [f"-G {p}" for p in props.parameters]
    options += [f"--blackboxed-module {m}" for m in props.cut]
    lines = [f"read_slang --top {props.stem} {' '.join(options)} {' '.join(files)}",
             f"prep -flatten -top {props.stem}"]
    lines += ["cutpoint -blackbox"] if props.cut else []
    lines += [f"cutpoint t:{cell}" for cell in props.free]
    return "\n".join([*lines, "memory_map -rom-only", "async2sync", "chformal -lower"]) + "\n"


def write_asserts(props, folder, name, replaced=None):
    """name.aig with all assertions; returns their labels in the order of its outputs."""
    script = (read_script(props, replaced) + "chformal -cover -remove\n"
              + TO_AIGER.format(stem=name))
    yosys(script, folder, name)
    return labels(folder / f"{name}.json")


def write_covers(props, folder, name):
    (folder / "cover_map.v").write_text(COVER_MAP, encoding="utf-8")
    script = (read_script(props) + "chformal -assert -remove\ntechmap -map cover_map.v\n"
              + TO_AIGER.format(stem=name))
    yosys(script, folder, name)
    return labels(folder / f"{name}.json")


def labels(witness_map):
    found = json.loads(witness_map.read_text(encoding="utf-8"))["asserts"]
    return [path[0].split(".")[-1].lstrip("\\") for path in found]


def abc_program():
    import pyosys  # it brings abc along
    return Path(pyosys.__file__).parent / "yosys-abc"


def abc(folder, commands, limit):
    try:
        done = subprocess.run([abc_program(), "-c", commands], cwd=folder, capture_output=True,
                              text=True, check=False, timeout=limit + 30)
    except subprocess.TimeoutExpired:
        return ""
    text = done.stdout + done.stderr
    if "cmd error" in text or "Cannot open" in text:
        raise FormalError(f"abc: {text.strip().splitlines()[-1]}")
    return text


def verdict(text):
    if re.search(r"Property proved|was proved|are equivalent|successfully proved", text):
        return "proven"
    if "was asserted in frame" in text:
        return "refuted"
    return "open"


def frame(text):
    found = re.search(r"was asserted in frame (\d+)", text)
    return int(found[1]) if found else None


def prove_all(folder, name, count, limit):
    """Verdict of all outputs together: one invariant may need another's help."""
    join = "orpos; " if count > 1 else ""
    text = abc(folder, f"read_aiger {name}.aig; {join}scleanup; dc2; scorr; pdr -T {limit}", limit)
    return verdict(text)


def prove_one(folder, name, output, limit):
    text = abc(folder, f"read_aiger {name}.aig; cone -O {output}; scleanup; dc2; scorr; "
                       f"pdr -T {limit}", limit)
    return verdict(text)


def reach(folder, name, output, frames, limit):
    """The clock at which an output rises, found by bounded search; None when it is not."""
    text = abc(folder, f"read_aiger {name}.aig; cone -O {output}; scleanup; "
                       f"bmc3 -F {frames} -T {limit}", limit)
    return frame(text)


def mutate_text(control, folder, number):
    """Writes the changed module; returns {original file: changed file}."""
    original = module_file(control.module)
    text = original.read_text(encoding="utf-8")
    if text.count(control.old) != 1:
        raise FormalError(f"line {control.line}: '{control.old}' occurs {text.count(control.old)} "
                          f"times in {original.relative_to(ROOT)}, not once")
    changed = folder / f"control{number}_{original.name}"
    changed.write_text(text.replace(control.old, control.new), encoding="utf-8")
    return {original: changed}


def stopwatch():
    begin = time.monotonic()
    return lambda: time.monotonic() - begin
