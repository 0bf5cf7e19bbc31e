# SPDX-License-Identifier: Apache-2.0
"""Marks of equations in the sources: found, listed, and missed where they must be."""

from pathlib import Path

from scratch import Scratch
from trammel_tools.generate import gen_equations


class GenEquationsTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(gen_equations, ROOT=self.folder, SOURCE=self.folder / "docs/equations.toml")

    def collect(self, **equations):
        return gen_equations.collect({"paper": "Kung", "count": 3, **equations})

    def test_numbers_are_lists_and_ranges(self):
        for text, wanted in (("28, 29", [28, 29]), ("30 to 33", [30, 31, 32, 33]),
                             ("7-9", [7, 8, 9]), ("9 and 10", [9, 10])):
            self.assertEqual(gen_equations.numbers(text), wanted)

    def test_a_mark_counts_for_the_kind_of_its_folder(self):
        self.write("rtl/math/a.sv", "// Kung eq. 1, 3\nlogic a;  // Kung eq. 1\n")
        self.write("models/exact/math/a.hpp", "\n// Kung eq. 1 and 2: both\n")
        self.write("rtl/generated/b.sv", "// Kung eq. 2\n")
        self.write("rtl/math/a.md", "Kung eq. 2\n")
        table, problems = self.collect(**{"1": {"what": "a", "in": ["RTL", "twin"]},
                                          "2": {"what": "b", "in": ["twin"]},
                                          "3": {"what": "c", "in": ["RTL"], "note": "Ours"}})
        self.assertEqual(problems, [])
        rtl, twin = Path("rtl/math/a.sv"), Path("models/exact/math/a.hpp")
        self.assertEqual(table, {1: {"RTL": {rtl: [1, 2]}, "twin": {twin: [2]}},
                                 2: {"twin": {twin: [2]}}, 3: {"RTL": {rtl: [1]}}})
        self.assertEqual(gen_equations.where(table[1]),
                         "RTL [a.sv:1](../rtl/math/a.sv#L1), [2](../rtl/math/a.sv#L2); "
                         "twin [a.hpp:2](../models/exact/math/a.hpp#L2)")

    def test_a_test_is_named_without_lines_so_that_its_edits_leave_the_page_as_it_is(self):
        place = Path("tests/math/a_test.cpp")
        self.assertEqual(gen_equations.where({"test": {place: [3, 5]}}),
                         "test [a_test.cpp](../tests/math/a_test.cpp)")

    def test_files_of_a_machine_have_the_kind_of_their_role(self):
        for path, kind in (("machines/saw/words.hpp", "set-up"), ("sw_nios/path/a.hpp", "firmware"),
                           ("machines/saw/figures.cpp", "metric"),
                           ("machines/saw/chip/measures.cpp", "metric"),
                           ("machines/saw/tests/figures_test.cpp", "test"), ("docs/a.md", None)):
            self.assertEqual(gen_equations.kind_of(Path(path)), kind, path)

    def test_what_is_missing_or_too_much_is_told(self):
        self.write("rtl/a.sv", "// Kung eq. 4\n// Kung eq. 2\n")
        _, problems = self.collect(**{"1": {"what": "a", "in": ["RTL"]},
                                      "2": {"what": "b", "none": "an example"}})
        self.assertEqual(problems, [
            "rtl/a.sv:1: Kung has no equation 4",
            "docs/equations.toml: equation 1: no mark in RTL",
            "docs/equations.toml: equation 2 is marked, yet has a reason for none",
            "docs/equations.toml: equation 3 is missing"])
