# SPDX-License-Identifier: Apache-2.0
"""docs/gcode.md has every message of the reader of G-code, word for word."""

import re
import unittest

from trammel_tools.paths import ROOT

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def messages(source):
    """Its texts for people, in parts as {fmt} takes them; literals behind each other are one."""
    code = re.sub(r"^#include.*$|//.*$", "", source, flags=re.M)
    code = re.sub(r'"\s*\n\s*"', "", code)
    return [text for text in LITERAL.findall(code) if re.search(r"[a-z]{4}", text)]


def is_told(message, spans):
    """Whether one of these texts is that message, with anything in its places."""
    parts = map(re.escape, re.split(r"\{[^}]*\}", message))
    pattern = re.compile(".*".join(parts))
    return any(pattern.search(span) for span in spans)


class Page(unittest.TestCase):
    def test_each_message_is_on_the_page(self):
        page = (ROOT / "docs" / "gcode.md").read_text(encoding="utf-8")
        spans = re.findall(r"`([^`\n]+)`", page.replace("```", ""))
        found = [text for file in sorted((ROOT / "paths").glob("gcode*.cpp"))
                 for text in messages(file.read_text(encoding="utf-8"))]
        self.assertGreater(len(found), 50)
        self.assertEqual([text for text in found if not is_told(text, spans)], [])

    def test_a_message_that_is_missing_is_seen(self):
        source = '#include "some.hpp"\nno("{} is "\n   "gone", "X");  // "then"\n'
        self.assertEqual(messages(source), ["{} is gone"])
        self.assertTrue(is_told("{} is gone", ["X is gone"]))
        self.assertFalse(is_told("{} is gone", ["X is there"]))
