# SPDX-License-Identifier: Apache-2.0
"""A counterexample: the inputs that abc finds, and what is shown of them."""

from types import SimpleNamespace
from unittest import mock

from scratch import Scratch
from trammel_tools.proof import counterexample
from trammel_tools.proof.counterexample import Counterexample, Net
from trammel_tools.proof.properties import PropertiesError
from trammel_tools.waves import vcd


def bare(**fields):
    """A counterexample that nothing was searched for."""
    found = Counterexample.__new__(Counterexample)
    vars(found).update({"props": SimpleNamespace(stem="toy"), "label": "below_ten"} | fields)
    return found


class CounterexampleTest(Scratch):
    def test_each_engine_is_asked_until_one_has_written_inputs(self):
        asked = []

        def ask(folder, commands, limit):
            asked.append((commands, limit))
            if len(asked) == 2:
                (folder / "toy.cex").write_text("1\n010\n001\n# DONE\nmore\n", encoding="ascii")

        self.write("toy.cex", "1\n111\n# DONE\n")  # of an earlier search
        with mock.patch.object(counterexample.abc, "ask", ask):
            bits = counterexample.inputs(self.folder, "toy", 3, 8, 90, 60)
        self.assertEqual(bits, [[False, True, False], [False, False, True]])
        self.assertEqual(len(asked), 2)
        for (commands, limit), engine in zip(asked, ("bmc3 -F 8 -T 2;", "sim3 -F 90 -T 60;")):
            self.assertIn(f"cone -O 3; {engine}", commands)
            self.assertGreater(limit, int(engine.split()[-1].strip(";")))
        with mock.patch.object(counterexample.abc, "ask"), \
                self.assertRaisesRegex(PropertiesError, "^toy: abc does not find"):
            counterexample.inputs(self.folder, "toy", 3, 8, 90, 60)

    def test_nets_with_a_name_have_their_bits_and_those_of_the_tool_are_left_out(self):
        self.write("toy.map", "wire 4 0 a_i\nwire 7 1 a_i\nwire 6 0 $auto\ninput 0 0 a_i\n")
        nets = counterexample.nets(self.folder, "toy")
        self.assertEqual({name: net.bits for name, net in nets.items()}, {"a_i": {0: 4, 1: 7}})
        self.assertEqual((nets["a_i"].width, nets["a_i"].value([0, 0, 1, 1])), (2, 0b01))

    def test_the_promise_falls_in_the_last_clock_and_no_signal_is_shown_twice(self):
        nodes = [[0, 0, 1], [0, 1, 0], [0, 1, 1]]
        found = bare(clock=2).values({
            "clk_i": Net({0: 2}), "up_i": Net({0: 2}), "u_p.up_i": Net({0: 2}),
            "u_p.own": Net({0: 2, 1: 4}), "count_q": Net({0: 4}), "u_p.count_q": Net({0: 5})},
            "u_p", nodes)
        self.assertEqual({(s.path, s.width): values for s, values in found.items()}, {
            ("toy.u_p.below_ten", 1): [1, 1, 0], ("toy.up_i", 1): [0, 1, 1],
            ("toy.u_p.own", 2): [2, 1, 3], ("toy.count_q", 1): [1, 0, 1],
            ("toy.u_p.count_q", 1): [0, 1, 0]})

    def test_an_assertion_is_the_output_of_its_place(self):
        paths = ["u_p.above_ten", "u_a.u_p.below_ten", "below_ten_too"]
        self.assertEqual(bare().place(paths), ("u_a.u_p", 1))
        with self.assertRaisesRegex(PropertiesError, "^no assertion below_ten$"):
            bare().place(paths[::2])

    def test_the_last_values_are_told_and_that_there_are_more(self):
        signals = [vcd.Signal(f"toy.u_p.s{n}", 8) for n in range(7)]
        columns = {signal: [99, n + 6] for n, signal in enumerate(signals)}
        self.assertEqual(bare(says=signals[:6], columns=columns).words(),
                         "s0 6, s1 7, s2 8, s3 9, s4 0xa, s5 0xb")
        self.assertEqual(bare(says=signals, columns=columns).words(),
                         "s0 6, s1 7, s2 8, s3 9, s4 0xa, s5 0xb, ...")
