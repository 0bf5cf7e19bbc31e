# SPDX-License-Identifier: Apache-2.0
"""What the verbs share: errors and progress on one line, and the Python of .venv for its tools."""

import argparse
import importlib.util
import os
import sys
from pathlib import Path

from trammel_tools.paths import ROOT
from trammel_tools.text import one_line

PYTHON = ROOT / ".venv" / "bin" / "python3"
SKIPPED = 77  # CTest counts it as skipped


def restart():
    """Starts again with the Python of .venv, if that exists and is not this one."""
    if PYTHON.exists() and Path(sys.executable) != PYTHON:
        os.execv(PYTHON, [str(PYTHON), *sys.orig_argv[1:]])


def need(module, verb):
    """Returns when `module` can be imported; ends with 3 (under CTest 77) when it is nowhere."""
    if importlib.util.find_spec(module) is not None:
        return
    restart()
    print(f"{verb}: {module} is missing (trammel doctor)", file=sys.stderr)
    sys.exit(SKIPPED if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3)


class Missing(Exception):
    """A tool that is needed is not there; one line with its name."""


class Parser(argparse.ArgumentParser):
    """Of `trammel <verb>`: errors in one line."""

    def __init__(self, **more):
        super().__init__(allow_abbrev=False, formatter_class=argparse.RawDescriptionHelpFormatter,
                         **more)

    def error(self, message):
        self.exit(2, f"{self.prog.split()[1]}: {one_line(message)}; see {self.prog} --help\n")


def refuse(tool, why):
    """Says on one line, whatever names it holds, what the user did wrong; the exit code."""
    print(f"{tool}: {one_line(str(why))}", file=sys.stderr)
    return 2


def progress(text):
    """Replaces the line before; prints nothing unless on a terminal."""
    if sys.stderr.isatty():
        sys.stderr.flush()
        os.write(sys.stderr.fileno(), f"\r\033[K{text}".encode())  # not shown as text: a command
