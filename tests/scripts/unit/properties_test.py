# SPDX-License-Identifier: Apache-2.0
"""What a properties file and a page say, and what is refused in them."""

from scratch import Scratch, call
from trammel_tools import paths
from trammel_tools.proof import assertion_table, properties

GOOD = """module toy_props (input logic clk_i);
  below_ten : assert (count_o < 10);  // unlike this_comment : assert (x);
  inv_same : assert (count_q == twin_q);
  reaches_nine : cover (count_o == 9);
  // breaks below_ten: count_q <= up_i ? next : count_q
  // breaks below_ten (other): old text => new text
  // prove: cut multiplier divider
  // prove: set Width=4 Depth=2
  // prove: set Width=8
  // prove: depth 7
  // prove: frames 30
  // prove: from 5
  // prove: leap below_ten inv_same
endmodule
"""
PAGE = """# math/toy

## Promises

- `below_ten`: the count stays
  below ten.
* `other` = another.

## Ports

- `clk_i`: no promise.
"""


class PropertiesTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(paths, RTL=self.folder, ROOT=self.folder)
        self.patch(properties, ROOT=self.folder)

    def read(self, text):
        self.write("math/toy_props.sv", text)
        return properties.read("math/toy")

    def test_labels_controls_and_options_are_read(self):
        props = self.read(GOOD)
        self.assertEqual((props.assertions, props.helpers, props.covers),
                         (["below_ten"], ["inv_same"], ["reaches_nine"]))
        self.assertEqual(
            [(bug.assertions, bug.module, bug.name, bug.sign, bug.old, bug.new, bug.line)
             for bug in props.seeded_bugs],
            [(["below_ten"], "toy", "count_q", "<=", "", "up_i ? next : count_q", 5),
             (["below_ten"], "other", "", "=>", "old text", "new text", 6)])
        self.assertEqual(props.configurations, [["Width=4", "Depth=2"], ["Width=8"]])
        self.assertEqual((props.cut, props.leap),
                         (["multiplier", "divider"], ["below_ten", "inv_same"]))
        self.assertEqual((props.depth, props.frames, props.begin), (7, 30, 5))

    def test_blocks_are_those_with_a_properties_file(self):
        self.write("math/toy_props.sv", GOOD)
        self.write("drive/pwm_props.sv", GOOD)
        self.write("drive/alone.sv", "")
        self.assertEqual(properties.blocks(), ["drive/pwm", "math/toy"])

    def test_mistakes_are_told_with_their_place(self):
        for old, new, told in (
                ("below_ten : assert", "cover_ten : cover", "cover_ten: covers, and only they"),
                ("reaches_nine : cover", "reaches_nine : assert", "reaches_nine: covers, and only"),
                ("  inv_same :", "  assume (up_i); inv_same :", "no assume"),
                ("inv_same : assert (", "inv_same : assert property (", "immediate assertions"),
                ("inv_same : assert", "assert", "needs a label"),
                ("inv_same :", "below_ten : assert (1); inv_same :", "label below_ten twice"),
                ("prove: depth 7", "prove: deepness 7", "toy_props.sv:10: unknown option deepness"),
                ("prove: depth 7", "prove:", "toy_props.sv:10: not `prove: option value`"),
                ("leap below_ten", "leap none", "prove: leap: no assertion none"),
                ("below_ten : assert (count_o < 10);", "", "promises nothing")):
            with self.subTest(told):
                self.assertEqual(GOOD.count(old), 1, old)
                with self.assertRaises(properties.PropertiesError) as refused:
                    self.read(GOOD.replace(old, new))
                self.assertIn(told, str(refused.exception))
                self.assertNotIn("\n", str(refused.exception))

    def test_a_mistake_in_a_control_is_kept_for_later(self):
        for old, new, told in (
                ("breaks below_ten: count_q", "breaks above_ten: count_q",
                 "the control is of no promise above_ten"),
                ("count_q <= up_i ? next : count_q", "up_i",
                 "`up_i` is not `name = expression`"),
                ("below_ten: count_q <= up_i ? next : count_q", "below_ten",
                 "not `breaks label: name = expression`")):
            with self.subTest(told):
                self.assertEqual(GOOD.count(old), 1, old)
                self.assertEqual(self.read(GOOD.replace(old, new)).complaints, [(5, told)])

    def test_sentences_are_those_under_promises(self):
        self.write("math/toy.md", PAGE)
        self.assertEqual(properties.sentences("math/toy"),
                         {"below_ten": "the count stays below ten.", "other": "another."})

    def test_a_row_has_sentence_and_number_of_controls(self):
        self.write("math/toy_props.sv", GOOD)
        self.write("math/toy.md", PAGE.replace("* `other` = another.\n", ""))
        self.assertEqual(list(assertion_table.block_rows("math/toy")),
                         ["| toy | `below_ten` | the count stays below ten. | 2 |\n"])

    def test_a_promise_without_a_sentence_is_its_own(self):
        self.write("math/toy_props.sv", GOOD)
        self.write("math/toy.md", "# math/toy\n")
        self.assertIn("| below ten. |", next(assertion_table.block_rows("math/toy")))

    def test_a_page_promises_nothing_that_the_properties_do_not(self):
        self.write("math/toy_props.sv", GOOD)
        self.write("math/toy.md", PAGE)
        with self.assertRaisesRegex(properties.PropertiesError, "toy.md: other is not promised"):
            list(assertion_table.block_rows("math/toy"))

    def test_a_table_is_written_then_fresh_then_stale(self):
        self.patch(assertion_table, PAGE=self.folder / "assertions" / "table.md")
        self.write("math/toy_props.sv", GOOD)
        self.write("math/toy.md", "# math/toy\n")

        def run(check):
            return call(lambda: assertion_table.run(check))[0]

        self.assertEqual([run(True), run(False), run(True)], [1, 0, 0])
        self.assertIn("# 1 promises of 1 blocks\n", assertion_table.PAGE.read_text())
        self.write("math/toy_props.sv", GOOD.replace("count_o < 10", "count_o < 9"))
        self.assertEqual(run(True), 0)  # the table holds names and sentences, no expressions
        self.write("math/toy_props.sv", GOOD.replace("below_ten", "below_nine"))
        self.assertEqual(run(True), 1)
