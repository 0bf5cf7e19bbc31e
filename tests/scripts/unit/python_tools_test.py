# SPDX-License-Identifier: Apache-2.0
"""A missing module is reported, or the tool continues with the Python of .venv; one-line errors."""

import os
import sys
from pathlib import Path
from unittest import mock

from scratch import Scratch, call
from trammel_tools import python_tools

NOWHERE = "no_module_has_this_name"


class PythonToolsTest(Scratch):
    def need(self, module, python, **environment):
        """What `need` does: (exit code, standard error, arguments of execv)."""
        self.patch(python_tools, PYTHON=python)
        with mock.patch.dict(os.environ, environment), mock.patch("os.execv") as execv:
            if "CTEST_INTERACTIVE_DEBUG_MODE" not in environment:
                os.environ.pop("CTEST_INTERACTIVE_DEBUG_MODE", None)
            code, _, err = call(lambda: python_tools.need(module, "wave"))
        return code, err, execv.call_args

    def test_a_module_that_is_there_is_no_matter(self):
        self.assertEqual(self.need("json", Path("/nowhere")), (None, "", None))

    def test_a_missing_one_ends_with_3_and_under_ctest_with_77(self):
        told = f"wave: {NOWHERE} is missing (trammel doctor)\n"
        self.assertEqual(self.need(NOWHERE, Path("/nowhere")), (3, told, None))
        self.assertEqual(self.need(NOWHERE, Path("/nowhere"), CTEST_INTERACTIVE_DEBUG_MODE="1"),
                         (77, told, None))

    def test_the_tools_own_python_does_not_start_itself_again(self):
        code, _, started = self.need(NOWHERE, Path(sys.executable))
        self.assertEqual((code, started), (3, None))

    def test_the_python_of_venv_gets_the_whole_command_line(self):
        venv = self.write("python3", "")
        with mock.patch.object(sys, "orig_argv", ["python3", "scripts/tool", "wave", "list", "f"]):
            _, _, started = self.need(NOWHERE, venv)
        self.assertEqual(started.args, (venv, [str(venv), "scripts/tool", "wave", "list", "f"]))

    def test_a_wrong_argument_is_told_in_one_line(self):
        parser = python_tools.Parser(prog="trammel wave")
        parser.add_argument("--number", type=int)
        code, out, err = call(parser.parse_args, "--number", "x")
        self.assertEqual((code, out, err.count("\n")), (2, "", 1))
        self.assertRegex(err, "^wave: argument --number: .*; see trammel wave --help\n$")

    def test_so_is_one_with_ends_of_lines_in_it(self):
        _, _, err = call(python_tools.Parser(prog="trammel wave").parse_args, "a\nb\n")
        self.assertEqual(err, "wave: unrecognized arguments: a\\u000ab\\u000a; "
                              "see trammel wave --help\n")
        self.assertEqual(call(lambda: python_tools.refuse("wave", "a\nb")),
                         (2, "", "wave: a\\u000ab\n"))
