# SPDX-License-Identifier: Apache-2.0
"""Files that a check depends on: what a module, a test or a folder is made of."""

import ast
import functools
import os
import re
import subprocess
from pathlib import Path

from trammel_tools.check.rooms import ROOMS
from trammel_tools.paths import ROOT

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
TOOLS = "scripts/trammel_tools"
BUILD = ("CMakeLists.txt", "*/CMakeLists.txt", "CMakePresets.json", "cmake/**")


@functools.cache
def every():
    """Paths of all files of the repository, below its root. A file that is not yet added to Git
    counts, because CMake finds sources by folder. A link that leads nowhere, as an editor's lock,
    is no file. An unpacked archive may lie in another repository, which ignores it."""
    if (ROOT / ".git").exists():
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=ROOT, capture_output=True, text=True, check=False)
        if listed.returncode == 0:
            names = set(listed.stdout.split("\0")) - {""}
            return sorted(name for name in names if (ROOT / name).is_file())
    found = []
    for folder, inside, files in os.walk(ROOT):
        inside[:] = [name for name in inside
                     if not name.startswith((".", "build")) and name not in ("out", "__pycache__")]
        found += [str((Path(folder) / name).relative_to(ROOT)) for name in files
                  if (Path(folder) / name).is_file()]
    return sorted(found)


def matching(*patterns):
    """Files of the repository that match: `*` within a folder, `**` any folders."""
    wanted = re.compile("|".join(
        re.escape(one).replace(r"\*\*", ".*").replace(r"\*", "[^/]*") for one in patterns))
    return {name for name in every() if wanted.fullmatch(name)}


def with_imports(files):
    """These, and the scripts that they import but this package's, which keep results and make
    none."""
    used = reached(files, imported)
    return set(files) | {name for name in used if not name.startswith(f"{TOOLS}/evidence/")}


def tools(*names):
    """The scripts of these packages, or these modules of one, and all that they import."""
    return with_imports(matching("scripts/tool", *(f"{TOOLS}/{one}{end}" for one in names
                                                   for end in ("/**", ".py"))))


@functools.cache
def imported(name):
    """Scripts of the repository that a script imports."""
    if not name.endswith((".py", "/tool")):
        return set()
    found = set()
    for node in ast.walk(ast.parse((ROOT / name).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith("trammel_tools."):
            folder = f"scripts/{node.module.replace('.', '/')}"
            found |= {f"{folder}.py", f"{folder}/__init__.py",
                      *(f"{folder}/{one.name}.py" for one in node.names)}
    return found & set(every())


@functools.cache
def modules():
    """{name: file} of the modules and packages in rtl/."""
    return {Path(name).stem: name for name in matching("rtl/**.sv", "examples/**/rtl/*.sv")
            if not name.endswith("_props.sv")}


@functools.cache
def names_in(*names):
    """Modules and packages that files name."""
    text = "\n".join((ROOT / one).read_text(encoding="utf-8", errors="replace") for one in names)
    return set(re.findall(r"\b[A-Za-z_]\w*\b", re.sub(r"//.*", "", text))) & modules().keys()


def reached(first, more):
    """These, and all that can be reached from them: more(one) are the next ones."""
    left, found = list(first), set()
    while left:
        one = left.pop()
        if one not in found:
            found.add(one)
            left += more(one)
    return found


def instances(files):
    """These RTL files, all that they contain and the packages that they import."""
    return reached(files, lambda name: [modules()[one] for one in names_in(name)])


def rtl(*blocks):
    """Sources of these blocks (<layer>/<block>), of all that they contain and of the packages that
    these import."""
    first = set()
    for block in blocks:
        layer, _, stem = block.partition("/")
        own = f"{layer}/rtl/{stem}.sv"  # in the folder of a machine in examples/
        found = matching(f"rtl/{block}.sv", f"examples/{own}", f"examples/**/{own}")
        if not found:
            raise KeyError(f"rtl/{block}.sv")
        first |= found
    return instances(first)


def properties(files):
    """The properties of these modules."""
    return {name.replace(".sv", "_props.sv") for name in files} & set(every())


@functools.cache
def included(name):
    """Files of the repository that a C++ file includes."""
    text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
    places = ROOT, (ROOT / name).parent, ROOT / "tests"
    found = set()
    for path in INCLUDE.findall(text):
        there = [place / path for place in places if (place / path).is_file()]
        found |= {os.path.relpath(there[0], ROOT)} if there else set()
    return found


@functools.cache
def units():
    """{header: units that implement it}: a unit includes its own header first, of its folder or of
    one above."""
    found = {}
    for name in matching(*(f"{room}/**.cpp" for room in ROOMS)):
        own = INCLUDE.search((ROOT / name).read_text(encoding="utf-8", errors="replace"))
        if own and "/tests/" not in name and name.startswith(f"{os.path.dirname(own[1])}/"):
            found.setdefault(own[1], set()).add(name)
    return found


def cpp(*files):
    """C++ files that these are made of: what they include, and the units of each header."""
    return reached(files, lambda name: included(name) | units().get(name, set()))


def forget():
    """The next call reads the repository again."""
    for one in (every, imported, modules, names_in, included, units):
        one.cache_clear()
