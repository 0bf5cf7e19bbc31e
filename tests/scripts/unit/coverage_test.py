# SPDX-License-Identifier: Apache-2.0
"""What is made of coverage counts: tables, floors, exceptions."""

import json
from collections import Counter
from pathlib import Path
from unittest import mock

from scratch import Scratch, call
from trammel_tools.check import coverage, coverage_cpp, rtl_counts

SOURCE = "module toy;\n  if (a) b <= c;\n  else   b <= d;\nendmodule\n"


def point(count, page, note, line=2, file="rtl/math/toy.sv", column=3):
    fields = {"f": file, "l": line, "n": column, "page": f"{page}/toy", "o": note}
    return "C '" + "".join(f"\1{key}\2{value}" for key, value in fields.items()) + f"' {count}\n"


class CoverageTest(Scratch):
    def blocks(self, *points):
        return rtl_counts.read_blocks(self.write("rtl.dat", "# a head\n" + "".join(points)))

    def test_points_are_lines_toggles_and_covers_of_their_block(self):
        blocks = self.blocks(
            point(5, "v_branch", "if"), point(0, "v_branch", "else"), point(3, "v_toggle", "b"),
            point(0, "v_toggle", "c"), point(0, "v_toggle", "d"), point(2, "v_toggle", "d"),
            point(7, "v_user", "reaches_far", file="rtl/math/toy_props.sv"),
            point(1, "v_line", "block", file="rtl/math/toy_props.sv"),
            point(0, "v_line", "block", file="rtl/chips/generated/regs.sv"),
            point(0, "v_line", "block", file="tests/math/toy_test.cpp"))
        self.assertEqual(list(blocks), ["math/toy"])
        toy = blocks["math/toy"]
        self.assertEqual(toy.lines, {(2, 3, "if"): 5, (2, 3, "else"): 0})
        self.assertEqual(toy.toggles, {(2, "b"): 3, (2, "c"): 0, (2, "d"): 2})
        self.assertEqual(toy.covers, {"reaches_far": 7})
        self.assertAlmostEqual(toy.share(toy.toggles), 200 / 3)

    def test_counts_that_are_missing_or_not_whole_are_an_error_that_names_the_file(self):
        self.patch(coverage, ROOT=self.folder, COUNTS=self.folder / "counts")
        whole = "# a head\n" + point(5, "v_branch", "if") + point(0, "v_branch", "else")
        for n, text in enumerate((None, "", "# a head\n", whole[:-1], whole[:-9])):
            data = self.folder / f"{n}.dat"
            program = self.write(f"{n}.sh", "#!/bin/sh\n" + (
                f"cp {data} $TRAMMEL_COVERAGE.0\n" if text is not None else ""))
            program.chmod(0o755)
            data.write_text(text or "", encoding="utf-8")
            code, out, said = call(coverage.main, "--count", "math/toy", "--program", program)
            self.assertEqual((code, out, said.count("\n")), (2, "", 1), text)
            self.assertIn("counts/math.toy.dat", said)
        data.write_text(whole, encoding="utf-8")
        self.assertEqual(call(coverage.main, "--count", "math/toy", "--program", program)[0], 0)

    def test_the_table_has_a_row_a_block_and_one_for_all(self):
        blocks = self.blocks(point(5, "v_branch", "if"), point(0, "v_branch", "else"),
                             point(3, "v_toggle", "b"),
                             point(1, "v_branch", "if", file="rtl/drive/pwm.sv"),
                             point(1, "v_branch", "else", file="rtl/drive/pwm.sv"))
        _, out, _ = call(lambda: coverage.print_rtl(blocks))
        self.assertEqual([line.split() for line in out.splitlines()[1:]],
                         [["drive/pwm", "100.0", "%", "of", "2", "-", "-"],
                          ["math/toy", "50.0", "%", "of", "2", "100.0", "%", "of", "1", "-"],
                          ["all", "75.0", "%", "of", "4", "100.0", "%", "of", "1", "-"]])

    def lines(self, *exceptions, counted=True):
        """What check_lines says of a block whose `else` is never executed."""
        self.write("rtl/math/toy.sv", SOURCE)
        self.patch(coverage, ROOT=self.folder)
        blocks = self.blocks(point(5, "v_branch", "if"),
                             point(0, "v_branch", "else", line=3)) if counted else {}
        with mock.patch.object(coverage.lint, "blocks", return_value=["math/toy"]):
            return list(coverage.check_lines(blocks, [
                {"file": "rtl/math/toy.sv", "branch": branch, "text": text}
                for branch, text in exceptions]))

    def test_a_line_that_is_never_executed_is_told_unless_excepted(self):
        self.assertEqual(self.lines(),
                         ["rtl/math/toy.sv:3: never executed (else): else   b <= d;"])
        self.assertEqual(self.lines(("else", "else   b <= d;")), [])

    def test_an_exception_is_of_one_line_and_of_all_points_in_it(self):
        text = "      default: b <= d;"
        self.write("rtl/math/toy.sv", f"{SOURCE}{text}\n{text}\n")
        self.patch(coverage, ROOT=self.folder)
        first = SOURCE.count("\n") + 1
        blocks = self.blocks(*(point(0, "v_line", "elsif", line=line, column=column)
                               for line in (first, first + 1) for column in (7, 16)))
        one = {"file": "rtl/math/toy.sv", "branch": "elsif", "text": text.strip()}
        with mock.patch.object(coverage.lint, "blocks", return_value=["math/toy"]):
            for count, told in ((0, [first] * 2 + [first + 1] * 2), (1, [first + 1] * 2), (2, [])):
                with self.subTest(exceptions=count):
                    self.assertEqual(list(coverage.check_lines(blocks, [one] * count)), [
                        f"rtl/math/toy.sv:{line}: never executed (elsif): {text.strip()}"
                        for line in told])
            self.assertEqual(list(coverage.check_lines(blocks, [one] * 3)), [
                f"coverage.toml: stale exception: rtl/math/toy.sv (elsif): {text.strip()}"])

    def test_an_exception_that_nothing_needs_is_stale(self):
        self.assertEqual(self.lines(("else", "else   b <= d;"), ("if", "if (a) b <= c;")),
                         ["coverage.toml: stale exception: rtl/math/toy.sv (if): if (a) b <= c;"])

    def test_a_block_that_no_test_counts_is_told(self):
        self.assertEqual(self.lines(counted=False), ["rtl/math/toy.sv: no test counts it"])

    def test_a_share_below_its_floor_is_told_and_a_floor_of_no_block(self):
        blocks = self.blocks(point(3, "v_toggle", "b"), point(0, "v_toggle", "c"))

        def check(**floors):
            return list(coverage.check_floors(blocks, "toggles", floors,
                                              lambda b: b.share(b.toggles)))

        self.assertEqual(check(default=50), [])
        self.assertEqual(check(default=51),
                         ["math/toy: toggles 50.0 %, below its floor of 51 %"])
        self.assertEqual(check(default=95, **{"math/toy": 40}), [])
        self.assertEqual(check(default=0, **{"math/none": 40}),
                         ["coverage.toml: toggles: no block math/none"])


class CoverageCppTest(Scratch):
    def check(self, files, floors, own=None):
        self.patch(coverage_cpp, PAGES=self.folder, COUNTS=self.folder,
                   own_files=lambda _: own or files)

        def gcovr(kind, target, _):
            self.assertEqual(kind, "--json")
            Path(target).write_text(json.dumps({"files": [
                {"file": name, "lines": [{"line_number": n, "count": c} for n, c in lines]}
                for name, lines in files.items()]}), encoding="utf-8")

        with mock.patch.object(coverage_cpp, "gcovr", gcovr):
            text = "\n".join(coverage_cpp.short(coverage_cpp.count("some")))
        wrong = []
        _, out, _ = call(lambda: wrong.extend(
            coverage_cpp.check(floors, coverage_cpp.read_short(text))))
        return out, wrong

    def test_a_line_of_a_template_counts_once_and_is_executed_in_any_instance(self):
        out, wrong = self.check({"models/exact/a.hpp": [(1, 2), (1, 0), (2, 0), (3, 1), (4, 1)]},
                                {"models/exact": 75})
        self.assertEqual(wrong, [])
        self.assertEqual(out.splitlines()[1].split(), ["models/exact", "75.0", "%", "of", "4"])

    def test_a_group_keeps_no_lines_of_files_that_it_does_not_depend_on(self):
        files = {"models/exact/a.hpp": [(1, 1)], "models/exact/b.hpp": [(1, 0)]}
        self.assertEqual(self.check(files, {}, own=["models/exact/a.hpp"])[1], [])
        self.assertEqual(len(self.check(files, {})[1]), 1)

    def test_folders_are_held_at_their_floors_or_at_all_lines(self):
        files = {"cosim/a.cpp": [(1, 1), (2, 0)], "models/plant/b.cpp": [(1, 0)]}
        self.assertEqual(self.check(files, {"cosim": 50, "none": 1})[1],
                         ["models/plant: 0.0 % of the lines, below its floor of 100 %",
                          "coverage.toml: no folder none"])

    def test_a_folder_without_a_floor_has_that_of_the_folder_around_it(self):
        files = {"machines/saw/a.cpp": [(1, 1), (2, 0)], "machines/winder/b.cpp": [(1, 1)]}
        self.assertEqual(self.check(files, {"machines": 50, "machines/winder": 100})[1], [])
        self.assertEqual(self.check(files, {"machines": 51})[1],
                         ["machines/saw: 50.0 % of the lines, below its floor of 51 %"])

    def test_folders_of_models_machines_and_parts_are_told_apart(self):
        self.assertEqual(Counter(map(coverage_cpp.folder_of, (
            "models/exact/a/b.hpp", "models/plant/c.cpp", "cosim/d/e.cpp", "cosim/f.cpp",
            "machines/saw/keys.cpp", "parts/servo/motor.cpp"))),
            {"models/exact": 1, "models/plant": 1, "cosim": 2, "machines/saw": 1,
             "parts/servo": 1})
