# SPDX-License-Identifier: Apache-2.0
"""Which values verify --keys tries, and which keys it calls tried in vain."""

import contextlib
import io
import unittest

from trammel_tools.check import keys


class Keys(unittest.TestCase):
    def test_both_ends_and_values_between_are_tried(self):
        tried = [float(word) for word in keys.values("plant.mass_kg", 0.1, 500, 2.5, False, 1)]
        self.assertEqual(tried[:2], [0.1, 500])
        self.assertEqual(len(tried), 2 + keys.BETWEEN)
        self.assertTrue(all(0.1 <= value <= 500 for value in tried))
        self.assertTrue(all(2.5 / 4 <= value <= 2.5 * 4 for value in tried[3:]))

    def test_a_key_of_which_no_value_changes_the_run_is_told(self):
        made = {"a": [1, 1, 1], "b": [1, 2, 1], "c": [3], "d": [4, 4]}
        with contextlib.redirect_stdout(io.StringIO()) as said:
            wrong = keys.in_vain("toy", {"inert": {"d": "a warning alone"}}, made)
        self.assertEqual(wrong, ["toy: a: no value of it changes the run"])
        self.assertIn("inert    d: a warning alone", said.getvalue())


if __name__ == "__main__":
    unittest.main()
