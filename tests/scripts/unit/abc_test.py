# SPDX-License-Identifier: Apache-2.0
"""What is read from the answers of abc, and what it is asked."""

import importlib.util
import unittest
from unittest import mock

from scratch import Scratch
from trammel_tools.proof import abc
from trammel_tools.proof.properties import PropertiesError

# An input behind two registers, which begin as 0: the output rises in clock 2 at the earliest.
DELAYED = "aig 3 1 2 1 0\n2\n4\n6\n"
NEVER = "aig 5 1 4 1 0\n2\n4\n6\n8\n0\n"


@unittest.skipUnless(importlib.util.find_spec("pyosys"), "pyosys is not installed")
class AbcTest(Scratch):
    def test_an_input_behind_two_registers_rises_in_clock_2(self):
        self.write("a.aig", DELAYED)
        self.assertEqual(abc.base(self.folder, "a", 5, 10)[0], {0: 2})
        self.assertEqual(abc.base(self.folder, "a", 2, 10), ({}, True))  # clocks 0 and 1
        self.assertEqual(abc.first(self.folder, "a", 0, 3, 10), 2)
        self.assertIsNone(abc.first(self.folder, "a", 0, 2, 10))
        self.assertEqual(abc.reach(self.folder, "a", ["promise"], 5, 10)[0], {"promise": 2})
        self.assertEqual(abc.quick(self.folder, "a", [0], 50), {0: 2})

    def test_what_never_rises_is_searched_as_far_as_was_asked(self):
        self.write("a.aig", NEVER)
        self.assertEqual(abc.base(self.folder, "a", 7, 10), ({}, True))
        self.assertEqual(abc.quick(self.folder, "a", [0], 50), {})

    def test_a_file_that_is_not_there_is_an_error_and_no_answer(self):
        with self.assertRaisesRegex(PropertiesError, "^abc: "):
            abc.base(self.folder, "none", 5, 10)


class AnswersTest(unittest.TestCase):
    def test_a_search_that_ended_early_is_not_complete(self):
        for said, clocks, whole in (("No output asserted in 9 frames.", 9, True),
                                    ("No output asserted in 9 frames.", 10, False),
                                    ("timed out\nNo output asserted in 9 frames.", 9, False),
                                    ("", 1, False)):
            with mock.patch.object(abc, "ask", return_value=said):
                self.assertEqual(abc.base(None, "a", clocks, 1), ({}, whole), (said, clocks))

    def test_the_quick_search_looks_for_a_shorter_way_only(self):
        asked = []

        def first(folder, name, output, frames, *_):
            asked.append((output, frames))
            return {0: 3, 1: None, 2: 8}[output]

        with mock.patch.object(abc, "random", return_value={0: 6, 3: 4}), \
                mock.patch.object(abc, "first", first):
            self.assertEqual(abc.quick(None, "a", [0, 1, 2], 20), {0: 3, 2: 8, 3: 4})
        self.assertEqual(asked, [(0, 7), (1, 20), (2, 20)])  # frames are counted from 0
