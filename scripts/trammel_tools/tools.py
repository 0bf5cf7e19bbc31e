# SPDX-License-Identifier: Apache-2.0
"""Run one of the tools: a module with a `main`, of this package or of machines/<m>/tests/tools/.

usage: scripts/tool NAME [argument ...]    its arguments: scripts/tool NAME --help
       scripts/tool --list                 the names, and what each does

Exit codes: those of the tool; 2 if there is no such tool, or where standard output takes no more.
"""

import ast
import contextlib
import difflib
import importlib
import io
import os
import re
import sys
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.paths import ROOT
from trammel_tools.text import shown

PACKAGE = Path(__file__).resolve().parent


def every():
    """{name: module's file} of all tools."""
    return {path.stem.replace("_", "-"): path
            for path in sorted([*PACKAGE.glob("*/*.py"),
                                *ROOT.glob("machines/*/tests/tools/*.py"),
                                *ROOT.glob("examples/**/tests/tools/*.py")],
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


class Stream(io.FileIO):
    """A standard stream that remembers what it did not take."""

    error = None

    def write(self, data):
        try:
            return super().write(data)
        except OSError as error:
            self.error = self.error or error
            raise


class Messages(Stream):
    """Standard error: what it does not take is lost, and changes no exit code."""

    def write(self, data):
        with contextlib.suppress(OSError):
            super().write(data)
        return len(data)


class Shown(io.TextIOWrapper):
    """Texts of others do not reach the terminal: they are shown as `shown` says."""

    def write(self, text):
        super().write(shown(text))
        return len(text)


def opened():
    """Every standard stream is open from here on, so that no file takes its place; where it was
    closed, what is read or written there fails."""
    for stream, mode in ((0, os.O_WRONLY), (1, os.O_RDONLY), (2, os.O_RDONLY)):
        try:
            os.fstat(stream)
        except OSError:
            os.set_inheritable(os.open(os.devnull, mode), True)


def settled(function):
    """The exit code of function(), or 2 where standard output did not take all that it printed. A
    reader that closes the pipe is no error, nor is a standard error that takes nothing."""
    closed = sys.stdout is None
    opened()
    sys.stderr = Shown(io.BufferedWriter(Messages(2, "w", closefd=False)), encoding="utf-8",
                       errors="backslashreplace", line_buffering=True)
    if closed:
        print("tool: standard output: cannot be written: it is closed", file=sys.stderr)
        return 2
    out = Stream(1, "w", closefd=False)
    sys.stdout = Shown(io.BufferedWriter(out), encoding="utf-8", errors="backslashreplace",
                       line_buffering=sys.stdout.isatty())
    code = 2
    try:
        code = function()
        sys.stdout.flush()
    except SystemExit as ended:
        code = ended.code
    except OSError:
        if out.error is None:
            raise
    with contextlib.suppress(OSError):
        sys.stdout.flush()
    if out.error is None:
        return code
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for the last flush, when Python ends
    if isinstance(out.error, BrokenPipeError):
        return 0
    print(f"tool: standard output: cannot be written: {out.error.strerror}", file=sys.stderr)
    return 2


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
        return python_tools.refuse("tool", f"{name}: no such tool; {hint}")
    return run(name, words)
