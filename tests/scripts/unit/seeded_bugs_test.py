# SPDX-License-Identifier: Apache-2.0
"""What a negative control makes of the text of a module."""

from scratch import Scratch
from trammel_tools import paths
from trammel_tools.proof import seeded_bugs

MODULE = """module toy (input logic clk_i, output logic [3:0] count_o);
  localparam logic [3:0] First = 4'd1, Last = 4'(First + 8);
  logic [3:0] count_d, count_q;
  assign count_d = count_q == Last ? First : count_q + 4'd1;
  part u_part (.value_i(count_q));
endmodule
"""


class ControlsTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(paths, RTL=self.folder, ROOT=self.folder)
        self.patch(seeded_bugs, RTL=self.folder, ROOT=self.folder)
        self.write("math/toy.sv", MODULE)

    def changed(self, words):
        bug = seeded_bugs.parse(f" small (toy): {words}")
        texts, lines = bug.changed()
        (text,) = texts.values()
        return text, lines

    def test_a_net_stands_for_what_drives_it(self):
        text, lines = self.changed("count_d = count_d ^ u_x.count_d")
        self.assertEqual(lines, ["rewire count_d value"])
        self.assertIn("wire type(count_d) trammel_before;\n", text)
        self.assertIn("= trammel_before ^ u_x.count_d;\nendmodule\n", text)
        self.assertIn(MODULE.removesuffix("endmodule\n"), text)

    def test_next_is_what_a_register_would_load(self):
        text, lines = self.changed("count_q <= next_q ? count_q : next")
        self.assertEqual(lines, ["rewire count_q load"])
        self.assertIn("= next_q ? count_q : trammel_before;\n", text)

    def test_a_port_of_an_instance_needs_no_type(self):
        text, lines = self.changed("u_part.value_i = u_part.value_i + 4'd1")
        self.assertEqual(lines, ["rewire u_part.value_i value"])
        self.assertIn("= trammel_before + 4'd1;\n", text)
        self.assertNotIn("type(", text)

    def test_a_constant_is_changed_where_it_stands(self):
        for words, line in (("First = First + 4'd2", "First = (4'd1) + 4'd2, Last = 4'(First + 8)"),
                            ("Last = 4'd7", "First = 4'd1, Last = 4'd7")):
            with self.subTest(words):
                text, lines = self.changed(words)
                self.assertEqual(lines, [])
                self.assertIn(f"localparam logic [3:0] {line};", text)

    def test_a_text_must_occur_once(self):
        text, lines = self.changed("count_q + 4'd1 => count_q")
        self.assertEqual(lines, [])
        self.assertIn("? First : count_q;", text)
        for words, times in (("Fast => x", 0), ("count_q == => x", 1), ("count_q => x", 4)):
            with self.subTest(words):
                if times == 1:
                    self.changed(words)
                    continue
                with self.assertRaisesRegex(seeded_bugs.SeededBugError, f"occurs {times} times"):
                    self.changed(words)

    def test_what_is_gone_is_named(self):
        for words, told in (("gone_q <= 1'b0", "math/toy.sv has no gone_q any more"),
                            ("u_gone.value_i = '0", "math/toy.sv has no u_gone any more")):
            with self.assertRaisesRegex(seeded_bugs.SeededBugError, told):
                self.changed(words)
        with self.assertRaisesRegex(seeded_bugs.SeededBugError, "no module part in rtl/"):
            seeded_bugs.parse(" small (part): value_i = '0").changed()
