# SPDX-License-Identifier: Apache-2.0
"""What is shown of texts that others made."""

import unittest

from trammel_tools import text


class TextTest(unittest.TestCase):
    def test_what_has_no_shape_is_shown_by_its_code(self):
        for plain in "a b\tc\n", "\u00b5\u4e2d\U0001f600":
            self.assertEqual(text.shown(plain), plain)
        self.assertEqual(text.shown("\x1b[1m\x9b\r"), "\\u001b[1m\\u009b\\u000d")
        self.assertEqual(text.shown("a\u202eb\u200b\u2028"), "a\\u202eb\\u200b\\u2028")
        self.assertEqual(text.shown("\U000e0041"), "\\U000e0041")
        self.assertEqual(text.shown(b"\xff".decode("utf-8", "surrogateescape")), "\\xff")
        # No characters, nor in XML.
        self.assertEqual(text.shown("a\ufffe\U0010ffff"), "a\\ufffe\\U0010ffff")

    def test_on_one_line_its_ends_are_seen_too(self):
        for plain in "a b", "\u00b5\u4e2d":
            self.assertEqual(text.one_line(plain), plain)
        self.assertEqual(text.one_line("a\nb\t\u00b5\r\n"), "a\\u000ab\\u0009\u00b5\\u000d\\u000a")
