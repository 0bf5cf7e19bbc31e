# SPDX-License-Identifier: Apache-2.0
"""Which mutants a block has, what they are called, and what is made of those that survive."""

from unittest import mock

from scratch import Scratch, call
from trammel_tools import paths
from trammel_tools.mutation import mutant_floors, mutant_proofs, mutant_tests, mutants, verify

SOURCE = """module toy (input logic clk_i);
  // a comment
  assign y_o = a_i + b_i;
endmodule
"""
NETLIST = """module \\other
  attribute \\src "math/other.sv:9.3-9.20"
  cell $add $add1
  end
end
module \\toy
  wire \\y_o
  attribute \\src "toy.sv:3.3-3.26|toy.sv:3.16-3.25"
  cell $add $add1
    parameter \\A_WIDTH 4
  end
  cell $mux $mux2
  end
end
"""


def mutation(port, bit=0, mode="inv", cell="$add1", wire="\\y_o"):
    return (f"mutate -mode {mode} -module \\toy -cell {cell} -port {port} -portbit {bit} "
            f"-ctrlbit 3 -wire {wire} -wirebit 2 -src toy.sv:3.16-3.25")


class MutantsTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(paths, RTL=self.folder / "rtl", ROOT=self.folder)
        self.patch(mutants, OUT=self.folder, ROOT=self.folder)
        self.write("rtl/math/toy.sv", SOURCE)

    def make(self, listed, **how):
        """The mutants of a block of which Yosys lists these; and the script that applies them."""
        self.write("math_toy/list.txt", "".join(f"{line}\n" for line in listed))
        self.write("math_toy/plain.il", NETLIST)
        self.write("math_toy/toy.sv", SOURCE)
        with mock.patch.object(mutants.yosys, "make") as make:
            found = mutants.make("math/toy", **how)
        return found, make.call_args.args[0]

    def test_clocks_and_ports_that_no_memory_of_ours_has_are_left_out(self):
        found, _ = self.make([mutation("A"), mutation("CLK"), mutation("clk_i"), mutation("RD_EN"),
                              "# no mutation", mutation("Y")])
        self.assertEqual([(m.number, mutants.field(m.command, "port")) for m in found],
                         [(1, "A"), (2, "Y")])

    def test_there_are_as_many_as_wanted_and_spare_ones_only_fill_up(self):
        found, _ = self.make([mutation("CLK")] + [mutation("A", bit) for bit in range(9)], count=4)
        self.assertEqual([m.number for m in found], [1, 2, 3, 4])
        self.assertEqual(mutants.field(found[-1].command, "portbit"), "3")

    def test_each_is_chosen_by_its_number(self):
        _, script = self.make([mutation("A"), mutation("B")])
        chosen = [line for line in script.split("\n") if line.startswith("mutate")]
        self.assertEqual([line.split(" -mode")[0] for line in chosen],
                         ["mutate -ctrl trammel_mutant 8 1", "mutate -ctrl trammel_mutant 8 2"])
        self.assertNotIn("-src", "".join(chosen))

    def test_it_is_called_by_the_narrowest_text_of_its_cell(self):
        found, _ = self.make([mutation("A", 1, "const0"), mutation("A", 2, "cnot1")])
        self.assertEqual([m.words for m in found],
                         ["add `a_i + b_i`, A[1] stuck at 0 (\\y_o[2])",
                          "add `a_i + b_i`, A[2] inverted while bit 3 is 1 (\\y_o[2])"])
        self.assertEqual(found[0].where, "math_toy/toy.sv:3")

    def test_cells_of_other_modules_have_no_part_in_it(self):
        self.make([mutation("A")])
        cells = mutants.read_cells(self.folder / "math_toy/plain.il", "toy")
        self.assertEqual(cells["$add1"], ["toy.sv:3.3-3.26", "toy.sv:3.16-3.25"])
        self.assertEqual((cells["$mux2"], cells["$mux2 type"]), ([], "mux"))

    def test_comments_and_spacing_do_not_change_the_hash(self):
        before = mutants.source_hash("math/toy")
        self.write("rtl/math/toy.sv", SOURCE.replace("// a comment", "\n  // more\n  "))
        self.assertEqual(mutants.source_hash("math/toy"), before)
        self.write("rtl/math/toy.sv", SOURCE.replace("a_i + b_i", "a_i - b_i"))
        self.assertNotEqual(mutants.source_hash("math/toy"), before)

    def test_the_selector_is_declared_once(self):
        net = "  wire [7:0] trammel_mutant;\n"
        self.write("math_toy/mutants.v", f"module toy;\n{net}endmodule\n")
        path = mutants.with_selector("math/toy", "mutants.v", "  input selector;\n", "toy.sv")
        self.assertEqual(path.read_text(), "module toy;\n  input selector;\nendmodule\n")
        self.write("math_toy/mutants.v", f"module toy;\n{net}{net}endmodule\n")
        with self.assertRaisesRegex(mutants.MutationError, "selector is not there once"):
            mutants.with_selector("math/toy", "mutants.v", "", "toy.sv")


FLOORS = """[floor]
"drive/toy" = 97
[survivors]
"drive/toy" = [["add `a + b`, Y[3] inverted", "beyond the range"]]
"""


class MutantFloorsTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(mutant_floors, ROOT=self.folder, PAGE=self.folder / "mutation.md")
        self.write("tests/mutants.toml", FLOORS)
        self.write("mutation.md", f"text\n\n{mutant_floors.HEAD}old\n")

    def read(self):
        return mutant_floors.read(["drive/toy", "chips/toy", "control/toy"])

    def test_equivalent_mutants_do_not_count(self):
        result = mutant_floors.Result("drive/toy", 100, equivalent=[{}] * 20, promise=[{}] * 10,
                                      left=[{}] * 4)
        self.assertEqual((result.killed, result.counted, result.score), (76, 80, 95.0))
        self.assertEqual(mutant_floors.Result("drive/toy", 2, equivalent=[{}] * 2).score, 100.0)

    def test_a_block_without_a_line_has_the_floor_of_its_layer(self):
        floors = self.read()
        self.assertEqual([floors.of(block) for block in ("drive/toy", "drive/a", "control/a")],
                         [97, 95.0, 90.0])
        self.assertEqual(floors.known("drive/toy"),
                         {"add `a + b`, Y[3] inverted": "beyond the range"})
        self.assertEqual((floors.known("drive/a"), floors.wrong), ({}, []))

    def test_machines_and_parts_keep_the_floors_of_their_chips(self):
        self.write("machines/m/mutants.toml", '[floor]\n"chips/toy" = 91.5\n')
        self.write("parts/p/mutants.toml", '[floor]\n"control/toy" = 92.5\n')
        floors = self.read()
        self.assertEqual((floors.of("chips/toy"), floors.of("control/toy"), floors.wrong),
                         (91.5, 92.5, []))

    def test_what_is_wrong_in_the_files_is_told(self):
        for text, told in (('[floor]\n"drive/toy" = 94\n', "drive/toy: 94: a floor is 95 to 100"),
                           ('[floor]\n"drive/toy" = 101\n', "101: a floor is"),
                           ('[floor]\n"drive/toy" = "all"\n', "all: a floor is"),
                           ('[floor]\n"drive/gone" = 99\n', "drive/gone: there is no such block"),
                           ('[survivors]\n"drive/gone" = []\n', "drive/gone: there is no such"),
                           ('[survivors]\n"drive/toy" = [["one"]]\n', "tests/mutants.toml: "),
                           ("[score]\n", "score: not floor or survivors"),
                           ("floor", "tests/mutants.toml: ")):
            with self.subTest(text):
                self.write("tests/mutants.toml", text)
                self.assertEqual(len(self.read().wrong), 1)
                self.assertIn(told, self.read().wrong[0])
        self.write("tests/mutants.toml", FLOORS)
        self.write("machines/m/mutants.toml", FLOORS)
        self.assertEqual(self.read().wrong,
                         ["machines/m/mutants.toml: drive/toy: it stands in two files"])

    def test_what_was_proven_before_holds_for_the_same_source_alone(self):
        self.patch(mutants, OUT=self.folder / "out", source_hash=lambda block: "new")
        self.assertEqual(mutant_floors.proven_before("drive/toy"), {})
        for source, known in (("new", [(3, "inv")]), ("old", [])):
            with self.subTest(source=source):
                self.write("out/drive_toy/result.toml", f'source = "{source}"\n'
                           '[[equivalent]]\nnumber = 3\nmutation = "inv"\n')
                self.assertEqual(list(mutant_floors.proven_before("drive/toy")), known)

    def test_the_page_is_written_then_fresh_then_stale(self):
        blocks = ["control/toy", "drive/toy"]
        self.assertEqual(len(list(mutant_floors.problems(blocks))), 1)
        mutant_floors.write_page(blocks)
        self.assertEqual(list(mutant_floors.problems(blocks)), [])
        text = mutant_floors.PAGE.read_text()
        self.assertTrue(text.startswith("text\n\n"))
        self.assertIn("| drive/toy | 97 % | 1 |\n", text)
        self.assertNotIn("control/toy", text)  # it has the floor of its layer
        self.assertIn("| drive/toy | add `a + b`, Y[3] inverted | beyond the range |\n", text)
        self.write("tests/mutants.toml", FLOORS.replace("97", "98"))
        self.assertEqual(len(list(mutant_floors.problems(blocks))), 1)


class SampleTest(Scratch):
    """The unit test accepts 3 to 5 of 7 mutants; a sample of every second has 3 and 5 of them."""

    def sample(self, verdicts, known=(), control=None):
        found = [mutants.Mutant(n, "", f"mutant {n}", "toy.sv:1") for n in range(1, 8)]
        floors = mutant_floors.Floors(survivors={"drive/toy": dict.fromkeys(known, "")})
        asked = []

        def judge(block, mutant, limit, assertions):
            asked.append(mutant.number)
            self.assertEqual(assertions, not control)
            return verdicts[mutant.number], {"why": "open"}

        with mock.patch.object(mutants, "make", return_value=found), \
                mock.patch.object(mutant_tests, "build"), \
                mock.patch.object(mutant_tests, "survivors", side_effect=lambda _, __, numbers: [
                    n for n in numbers if n in (3, 4, 5)]), \
                mock.patch.object(verify.mutant_proofs, "write_netlists"), \
                mock.patch.object(verify.mutant_proofs, "compare",
                                  return_value=("equivalent", "")), \
                mock.patch.object(verify.mutant_proofs, "refuted_by", return_value=control), \
                mock.patch.object(verify, "judge", judge), mock.patch.object(verify, "SAMPLE", 3):
            wrong, _, _ = call(lambda: verify.sample("drive/toy", 1, floors))
        return asked, wrong

    def test_what_is_explained_may_pass(self):
        asked, wrong = self.sample({3: "equivalent", 5: "promise"})
        self.assertEqual((asked, wrong), ([3, 5], []))

    def test_promises_that_fail_without_a_mutant_are_not_asked(self):
        _, wrong = self.sample({3: "equivalent", 5: "equivalent"}, control="a_promise")
        self.assertEqual(wrong, [])

    def test_what_nobody_explains_is_wrong(self):
        asked, wrong = self.sample({3: "equivalent", 5: "left"})
        self.assertEqual(asked, [3, 5])
        self.assertEqual(len(wrong), 1)
        self.assertIn("drive/toy: mutant 5 toy.sv:1: mutant 5: open; not among", wrong[0])

    def test_a_known_survivor_is_not_judged_again(self):
        self.assertEqual(self.sample({3: "promise"}, ["mutant 5"]), ([3], []))


class MutantTestsTest(Scratch):
    def test_survivors_are_what_the_test_accepts(self):
        with mock.patch.object(mutant_tests, "passes", lambda _, n, limit: n in (0, 3, 5)):
            self.assertEqual(mutant_tests.survivors("a/b", "program", [1, 2, 3, 4, 5]), [3, 5])

    def test_a_netlist_that_fails_without_a_mutant_is_not_the_block(self):
        with mock.patch.object(mutant_tests, "passes", return_value=False), \
                self.assertRaisesRegex(mutants.MutationError, "fails without a mutant"):
            mutant_tests.survivors("a/b", "program", [1])

    def test_a_long_test_has_parts(self):
        self.patch(mutant_tests, ROOT=self.folder)
        test = self.write("tests/math/toy_test.cpp", "")
        part = self.write("tests/math/toy_edges_test.cpp", "")
        self.patch(mutant_tests, RTL=self.folder / "rtl")
        self.write("tests/math/toy_store_test.cpp", "")
        self.write("rtl/math/toy_store.sv", "")  # another block
        self.assertEqual(mutant_tests.files_of("math/toy"), [test, part])


class MutantProofsTest(Scratch):
    def test_promises_see_the_parameters(self):
        text = """module toy #(
    parameter int unsigned Period = 3125,
    parameter logic A = 1  // a comment
"""
        self.assertEqual(mutant_proofs.parameters(text), [
            "  localparam int unsigned Period = 3125;\n", "  localparam logic A = 1;\n"])
