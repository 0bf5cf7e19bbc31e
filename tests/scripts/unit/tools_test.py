# SPDX-License-Identifier: Apache-2.0
"""scripts/tool finds every tool by its folder, and each of them says what it does."""

import ast
import importlib.util
import re
import sys
import unittest
from unittest import mock

from scratch import call
from trammel_tools import tools
from trammel_tools.paths import ROOT

WITHOUT_HELP = {"gen-sine"}  # writes its table whatever it is told


class ToolsTest(unittest.TestCase):
    def test_the_verbs_of_the_launcher_are_tools(self):
        launcher = (ROOT / "trammel").read_text(encoding="utf-8")
        verbs = re.search(r'^tools="([^"]*)"', launcher, re.M)[1].split()
        self.assertGreater(len(verbs), 3)
        self.assertLessEqual(set(verbs), set(tools.every()))

    def test_the_list_has_a_line_a_tool(self):
        code, out, err = call(tools.main, "--list")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual([line.split()[0] for line in out.splitlines()], sorted(tools.every()))

    def test_help_is_output_and_no_name_is_a_mistake(self):
        self.assertEqual(call(tools.main, "--help")[::2], (0, ""))
        self.assertEqual(call(tools.main)[:2], (2, ""))

    def test_an_unknown_name_is_one_line_with_the_nearest(self):
        self.assertEqual(call(tools.main, "gen-register-ma"),
                         (2, "", "tool: gen-register-ma: no such tool; did you mean "
                                 "gen-register-map?\n"))
        self.assertEqual(call(tools.main, "xyz"),
                         (2, "", "tool: xyz: no such tool; see scripts/tool --list\n"))
        self.assertEqual(call(tools.main, "x\nyz")[2],
                         "tool: x\\u000ayz: no such tool; see scripts/tool --list\n")

    def test_a_tool_gets_its_words_and_its_code_is_returned(self):
        module = mock.Mock()
        module.main.side_effect = lambda: int(sys.argv[1])
        with mock.patch("importlib.import_module", return_value=module) as imported:
            self.assertEqual(call(tools.main, "prove", "7")[0], 7)
        imported.assert_called_once_with("trammel_tools.proof.prove")

    def test_an_interrupted_tool_ends_with_130(self):
        module = mock.Mock()
        module.main.side_effect = KeyboardInterrupt
        with mock.patch("importlib.import_module", return_value=module):
            self.assertEqual(call(tools.main, "prove"), (130, "", ""))

    def test_every_tool_has_help_that_begins_with_what_it_does(self):
        for name, path in tools.every().items():
            if name in WITHOUT_HELP or (name == "gen-register-map"
                                        and importlib.util.find_spec("peakrdl_regblock") is None):
                continue
            with self.subTest(name):
                code, out, err = call(tools.main, name, "--help")
                self.assertEqual((code, err), (0, ""))
                first = ast.get_docstring(ast.parse(path.read_text("utf-8"))).splitlines()[0]
                self.assertIn(first, out)
                self.assertIn("usage: ", out)
