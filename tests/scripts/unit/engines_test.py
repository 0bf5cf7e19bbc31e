# SPDX-License-Identifier: Apache-2.0
"""Two runs are the same when every figure and every byte of their files is."""

import unittest

from trammel_tools.check import engines


class EnginesTest(unittest.TestCase):
    def test_nested_figures_have_names_of_their_own(self):
        self.assertEqual(dict(engines.flat("x", {"rms": 1, "peaks": [2, {"at": 3}]})),
                         {"x.rms": 1, "x.peaks[0]": 2, "x.peaks[1].at": 3})

    def test_what_differs_is_told_with_its_place(self):
        rtl = (1.0, {"hash": "a", "only": 1}, {"trace.csv": b"a\nb\nc", "same": b"x", "e": b"a\n"})
        twin = (2.0, {"hash": "b"}, {"trace.csv": b"a\nB\nc", "same": b"x", "e": b"a\nb"})
        self.assertEqual(engines.differences(rtl, rtl), [])
        self.assertEqual(engines.differences(rtl, twin), [
            "hash a and b", "only 1 and None", "e from line 2 on", "trace.csv from line 2 on"])

    def test_a_file_that_one_has_not_differs(self):
        self.assertEqual(engines.differences((1, {}, {"a": b"1"}), (1, {}, {})),
                         ["a from line 1 on"])
