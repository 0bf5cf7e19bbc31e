# SPDX-License-Identifier: Apache-2.0
"""Run one of the tools: a module with a `main`, of this package or of machines/<m>/tests/tools/.

usage: scripts/tool NAME [argument ...]    its arguments: scripts/tool NAME --help
       scripts/tool --list                 the names, and what each does

Exit codes: those of the tool; 2 if there is no such tool.
"""

import ast
import difflib
import importlib
import re
import sys
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import ROOT

PACKAGE = Path(__file__).resolve().parent


def every():
    """{name: module's file} of all tools."""
    return {path.stem.replace("_", "-"): path
            for path in sorted([*PACKAGE.glob("*/*.py"),
                                *ROOT.glob("machines/*/tests/tools/*.py")],
                               key=lambda path: path.stem)
            if re.search(r"^def main\(", path.read_text(encoding="utf-8"), re.M)}


def summary(path):
    """The first paragraph of the module's docstring, on one line and without its full stop."""
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))
    return text.partition("\n\n")[0].replace("\n", " ").rstrip(".")


def run(name, words):
    """The exit code of a tool with these arguments."""
    path = every()[name]
    sys.argv = [f"scripts/tool {name}", *words]
    module = f"trammel_tools.{path.parent.name}.{path.stem}"
    if not path.is_relative_to(PACKAGE):  # beside the modules that it is made of
        sys.path.insert(0, str(path.parent))
        module = path.stem
    try:
        return importlib.import_module(module).main()
    except KeyboardInterrupt:
        python_tools.progress("")
        return 130


def main():
    name, *words = sys.argv[1:] or [""]
    if name in ("", "-h", "--help", "--list"):
        if name != "--list":
            print(f"{__doc__}\nTools:", file=sys.stdout if name else sys.stderr)
        for tool, path in every().items():
            print(f"  {tool:<17}{summary(path)}", file=sys.stdout if name else sys.stderr)
        return 0 if name else 2
    if name not in every():
        near = difflib.get_close_matches(name, every(), 1)
        hint = f"did you mean {near[0]}?" if near else "see scripts/tool --list"
        print(f"tool: {name}: no such tool; {hint}", file=sys.stderr)
        return 2
    return run(name, words)
