# SPDX-License-Identifier: Apache-2.0
"""Verbs of the Python package that the build makes."""

import importlib.util
import os
import sys

from trammel_tools import python_tools
from trammel_tools.paths import ROOT

PACKAGE = ROOT / "build" / "python"


def options(verb):
    """The parser of a verb: that of the package, which may not be built yet."""
    file = ROOT / "python" / "trammel" / "command_line.py"
    spec = importlib.util.spec_from_file_location("command_line", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, verb)()


def perform(verb, needed):
    """`python -m trammel VERB` in the place of this process."""
    options(verb).parse_args()
    for module in needed:
        python_tools.need(module, verb)
    if not list(PACKAGE.glob("trammel/_core*.so")):
        print(f"{verb}: the Python package is not built: ./trammel test makes it", file=sys.stderr)
        return 3
    paths = [str(PACKAGE), *filter(None, [os.environ.get("PYTHONPATH")])]
    # A process of its own: workers are started with its main module.
    return os.execve(sys.executable, [sys.executable, "-m", "trammel", verb, *sys.argv[1:]],
                     {**os.environ, "PYTHONPATH": os.pathsep.join(paths)})
