# SPDX-License-Identifier: Apache-2.0
"""AIGER files, the memory of mutual induction, and graphs of gates: against their truth tables."""

import itertools
import unittest

from scratch import Scratch
from trammel_tools.proof import aiger, counterexample, miter


def run(model, inputs):
    """The outputs at each clock of a model whose latches begin at 0, under these inputs."""
    state = [0] * len(model.nexts)
    for row in inputs:
        value = [0, *row, *state]
        for high, low in model.gates:
            value.append((value[high >> 1] ^ high & 1) & (value[low >> 1] ^ low & 1))

        def of(literal, value=value):
            return value[literal >> 1] ^ literal & 1

        yield [of(word) for word in model.outputs + model.bad]
        state = [of(word) for word in model.nexts]


# One input, a latch that holds what was; outputs: the input, both, and that it fell.
MODEL = aiger.Model(1, [2], [2, 6], [8], [(4, 2), (4, 3)], "i0 x\n")


class AigerTest(Scratch):
    def test_numbers_of_any_length_are_read_as_they_are_written(self):
        for value in (0, 1, 127, 128, 129, 16383, 16384, 2**40 + 5):
            self.assertEqual(aiger.number(b"?" + aiger.coded(value) + b"?", 1),
                             (value, 1 + len(aiger.coded(value))))

    def test_a_model_is_read_as_it_was_written(self):
        path = self.folder / "m.aig"
        aiger.write(path, MODEL)
        path.write_bytes(path.read_bytes() + MODEL.symbols.encode())
        self.assertEqual(aiger.read(path), MODEL)

    def test_a_guarded_output_rises_only_while_no_member_has_failed_before(self):
        source, target = self.folder / "m.aig", self.folder / "g.aig"
        aiger.write(source, MODEL)
        aiger.guard(source, target, [1, 2])
        guarded = aiger.read(target)
        for row in itertools.product((0, 1), repeat=6):
            inputs = [[bit] for bit in row]
            failed = False
            for plain, seen in zip(run(MODEL, inputs), run(guarded, inputs), strict=True):
                self.assertEqual(seen, [plain[0], *(bit and not failed for bit in plain[1:])])
                failed = failed or any(plain[1:])


class CounterexampleTest(unittest.TestCase):
    def test_inputs_are_played_on_the_gates(self):
        self.assertEqual(list(counterexample.play(MODEL, [[True], [False], [True]])),
                         [[0, 1, 0, 0, 0], [0, 0, 1, 0, 1], [0, 1, 0, 0, 0]])
        inverted = aiger.Model(1, [3], [], [], [(4, 2)])
        self.assertEqual(list(counterexample.play(inverted, [[False], [True], [True]])),
                         [[0, 0, 0, 0], [0, 1, 1, 1], [0, 1, 0, 0]])

    def test_a_net_has_the_bits_that_are_known(self):
        net = counterexample.Net({0: 3, 2: 4, 3: 2})
        self.assertEqual(net.width, 4)
        self.assertEqual([net.value(node) for node in ([0, 0, 0], [0, 1, 0], [0, 0, 1], [0, 1, 1])],
                         [1, 8, 5, 12])

    def test_names_of_an_assertion_and_what_is_behind_them(self):
        text = ("assign a = b + c;\n d_q <= e ? f.g : a;\n assign a_more = h; ok = (a == k);\n"
                "lab : assert ((a == d_q) || x.y && a);\n other : assert (z);\n assign z = w;\n")
        self.assertEqual(counterexample.mentioned(text, "lab"),
                         (["a", "d_q", "x"], ["b", "c", "e", "f"]))
        self.assertEqual(counterexample.mentioned(text, "other"), (["z"], ["w"]))


class GraphTest(unittest.TestCase):
    def check(self, bits, make, wanted):
        """The literals of make(graph, word) are wanted(bits) for all values of the word."""
        graph = miter.Graph()
        word = graph.word(bits)
        made = make(graph, word)
        for values in itertools.product((0, 1), repeat=bits):
            value = graph.simulate(values)
            self.assertEqual([value(literal) for literal in made], wanted(values), values)

    def test_gates_are_what_they_are_called(self):
        def make(graph, word):
            a, b = word
            return [graph.both(a, b), graph.either(a, b), graph.differ(a, b), graph.both(a, a ^ 1),
                    graph.either(a, a ^ 1), graph.both(a, 1), graph.both(a, 0)]

        self.check(2, make, lambda v: [v[0] & v[1], v[0] | v[1], v[0] ^ v[1], 0, 1, v[0], 0])

    def test_some_and_every_of_any_number(self):
        self.check(5, lambda graph, word: [graph.some(word), graph.every(word)],
                   lambda v: [int(any(v)), int(all(v))])
        graph = miter.Graph()
        self.assertEqual((graph.some([]), graph.every([])), (0, 1))

    def test_words_are_compared_and_counted_lowest_bit_first(self):
        def number(bits):
            return sum(bit << n for n, bit in enumerate(bits))

        def wanted(values):
            a, b = values[:3], values[3:]
            total = number(a) + 1
            return [int(a != b), int(number(a) < number(b)), *(total >> n & 1 for n in range(4))]

        self.check(6, lambda graph, word: [graph.unequal(word[:3], word[3:]),
                                           graph.less(word[:3], word[3:]),
                                           *graph.plus_one(word[:3])], wanted)

    def test_equal_gates_are_one(self):
        graph = miter.Graph()
        a, b = graph.word(2)
        self.assertEqual(graph.both(a, b), graph.both(b, a))
        self.assertEqual(len(graph.gates), 4)

    def test_a_copy_of_a_model_computes_what_the_model_does(self):
        graph = miter.Graph()
        now, before = graph.word(2)
        made = graph.copy(MODEL, {1: now, 2: before}, MODEL.outputs + MODEL.bad)
        for bits in itertools.product((0, 1), repeat=2):
            value = graph.simulate(bits)
            self.assertEqual([value(literal) for literal in made],
                             [bits[0], bits[0] & bits[1], (1 - bits[0]) & bits[1]])
