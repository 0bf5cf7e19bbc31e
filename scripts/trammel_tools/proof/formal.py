# SPDX-License-Identifier: Apache-2.0
"""Turns a block with its bound properties into AIGER files.

Yosys (pyosys) reads the RTL, slang its SystemVerilog; every assertion becomes an output that must
stay 0, every cover one that must be able to rise.
"""

import json
import re
from dataclasses import dataclass, field, replace
from pathlib import Path

from trammel_tools.paths import ROOT
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.rtl import yosys

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
write_aiger -I -B -zinit {names} {name}.aig
"""
NAMES = {"-ywmap": "json", "-vmap": "map"}


@dataclass
class Model:
    """One AIGER file to be: assertions or covers of a block, perhaps with a changed file."""

    name: str
    only: list[str]  # labels
    parameters: list[str] = field(default_factory=list)
    changed: dict[Path, str] = field(default_factory=dict)  # {file: its text instead}
    behind: list[str] = field(default_factory=list)  # lines of the script behind the reading


def design(changed, folder, name, *more):
    """The modules and more files; changed texts are put into folder."""
    files = [*yosys.design(), *more]
    for original, text in changed.items():
        copy = folder / f"{name}_{original.name}"
        copy.write_text(text, encoding="utf-8")
        files[files.index(original)] = copy
    return files


def write_script(props, folder, model, kind="-ywmap"):
    """name.ys, the Yosys script that makes name.aig, and name.json or name.map with its names."""
    files = design(model.changed, folder, model.name, props.path)
    options = [f"-G {p}" for p in model.parameters]
    options += [f"--blackboxed-module {m}" for m in props.cut]
    kept = " ".join(f"c:*.{label} %d" for label in model.only)
    lines = [f"read_slang --top {props.stem} {' '.join(options)} {' '.join(map(str, files))}",
             *model.behind, f"delete t:$check {kept}", f"prep -flatten -top {props.stem}"]
    lines += ["cutpoint -blackbox"] if props.cut else []
    lines += [f"cutpoint t:{cell} c:*_props.* %d" for cell in props.free]
    lines += ["memory_map", "async2sync", "chformal -lower", "techmap -map cover_map.v"]
    text = "\n".join(lines) + "\n" + TO_AIGER.format(
        name=model.name, names=f"{kind} {model.name}.{NAMES[kind]}")
    (folder / f"{model.name}.ys").write_text(text, encoding="utf-8")


def write_models(props, folder, models):
    """Runs the models' scripts; what Yosys said beside its logs."""
    (folder / "cover_map.v").write_text(COVER_MAP, encoding="utf-8")
    for model in models:
        write_script(props, folder, model)
    return run_scripts(folder, [m.name for m in models], ("aig", "json", "map", "log"))


def run_scripts(folder, names, endings):
    """Runs each name.ys, old files with these endings removed; what Yosys said beside its logs.

    The last ending is the log. One process serves until a script fails, another goes on behind it.
    """
    for name in names:
        for ending in endings:
            (folder / f"{name}.{ending}").unlink(missing_ok=True)
    said = ""
    while names:
        done = yosys.run(folder, names)
        said += done.stdout + done.stderr
        begun = [n for n, name in enumerate(names) if (folder / f"{name}.log").exists()]
        names = names[begun[-1] + 1:] if begun and done.returncode else []
    return said


def read_labels(folder, name, output):
    """The labels of name.aig in the order of its outputs."""
    check_made(folder, name, "json", output)
    return [path.split(".")[-1] for path in read_paths(folder, name)]


def read_paths(folder, name):
    """The assertions of name.aig with their scopes."""
    found = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))["asserts"]
    return [path[0].replace("\\", "") for path in found]


def write_map(props, folder, model):
    """name.map, the names of all nets of name.aig; large, so it is only made to look at waves."""
    gates, named = folder / f"{model.name}.aig", replace(model, name=f"{model.name}_named")
    if (folder / f"{model.name}.map").exists():
        return
    write_script(props, folder, named, "-vmap")
    said = run_scripts(folder, [named.name], ("aig", "map", "log"))
    check_made(folder, named.name, "map", said)
    if (folder / f"{named.name}.aig").read_bytes() != gates.read_bytes():
        raise PropertiesError(f"{named.name}: Yosys does not make the same gates again")
    (folder / f"{named.name}.map").rename(folder / f"{model.name}.map")


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

