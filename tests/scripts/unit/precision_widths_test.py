# SPDX-License-Identifier: Apache-2.0
"""No sum of the precision controller loses a bit: ranges along its program, from its words'.

If every stored word lies in its range, then so does every result, every factor x has 35 bits, every
term and sum 52, and whatever is stored lies in its word's range again: by induction, always. Ranges
alone do not tell that of four words; why it holds for them stands beside RELATED.
"""

import re
import unittest

from trammel_tools.paths import RTL

PACKAGE = RTL / "pkg" / "precision_pkg.sv"
WRAPPED = 48  # what wraps in memory, as the spline does
# C1 to C3: written points have 32 bits; coasting can take them beyond 35, where they wrap in the
# twin too. Iacc: 32 IFF' + k (IFF - IFF') at k = 0 to 32 ticks behind the knot.
BITS = {
    WRAPPED: ("P", "V", "A", "J", "ErrSum", "IqSum", "ErrLast", "IqLast", "Knots", "P15"),
    35: ("C1", "C2", "C3"),
    32: ("WC", "WIff", "WKm", "WKmi", "WRatio", "WKb", "WFc", "WL1", "WL2", "WL3", "WK1", "WK2",
         "WMisc", "Km", "Kmi", "Kb", "Fc"),
    25: ("Iacc",),
    24: ("E1", "E2", "D", "Acc", "Vff", "V24", "A24", "Aff", "U1", "U2", "Um", "I8", "Dist"),
    21: ("Istep",),
    20: ("E", "Iff"),
    12: ("Iq",),
    1: ("Zero",),
}
WORDS = {word: bits for bits, words in BITS.items() for word in words}
RELATED = {
    # What lies between IFF' and IFF, and between um and u2: um + rs(u2 - um, 2) is no further out.
    "full(Istep)": 25, "full(Um), Plus, Free, Um": 24,
    # Points: see above.
    "Minus, Free, T1, AtCoast": 35,
    # Only what was saturated counts here, and what was cut off has the sign of i8 and is no larger.
    "full(I8), Plus": 24,
}
# Written before they are read: T1 by one of three at a knot, else nothing of it is stored.
SCRATCH = {"T1", "T2", "Y"}
FACTORS = {"FMant": (0, 2047), "FLead": (0, 15), "FHyst": (0, 255), "FKnee": (1, 1 << 15),
           "FTime": (-(1 << 17), (1 << 17) - 1), "FAge": (5369, 5369)}


def signed(bits):
    return -(1 << (bits - 1)), (1 << (bits - 1)) - 1


def inside(x, bits):
    return signed(bits)[0] <= x[0] and x[1] <= signed(bits)[1]


def cut(x, bits):
    low, high = signed(bits)
    return tuple(min(max(end, low), high) for end in x)


def join(*ranges):
    return min(r[0] for r in ranges), max(r[1] for r in ranges)


def times(x, f):
    products = [a * b for a in x for b in f]
    return min(products), max(products)


def shifted(x, right):
    return tuple((end + (1 << right >> 1)) >> right for end in x) if right > 0 else times(
        x, (1 << -right, 1 << -right))


def by_power(x, shift):
    """As the RTL shifts: 32 is none; the part of 16 and more by the place in the product."""
    shift &= 63
    right = 0 if shift & 32 else 16 if shift & 16 else 32
    return shifted(times(x, (1 << (shift & 15),) * 2), right)


def arguments(text):
    """Of a call, without those inside calls."""
    return [part.strip() for part in re.findall(r"(?:[^,()]|\([^()]*\))+", text)]


class Walk:
    """The ranges of all results; what leaves its width is in `wrong`."""

    def __init__(self, text, words, related):
        self.sum_bits, self.x_bits = (int(re.search(rf"{name} = (\d+);", text)[1])
                                      for name in ("SumWidth", "XWidth"))
        program = re.sub(r"//.*", "", text.split("Program[Size] = '{")[1])
        self.lines = re.findall(r"^\s*one\((.*)\)", program, re.M)
        self.words, self.related = {w: signed(b) for w, b in words.items()}, dict(related)
        self.words |= dict.fromkeys(SCRATCH, (0, 0))
        self.wrong, self.used, results = [], set(), [signed(self.x_bits)] * 2
        for line in self.lines:
            self.line = line
            results.append(self.step(*results[-2:]))

    def check(self, what, x, bits):
        if inside(x, bits):
            return x
        self.wrong.append(f"{what}: one({self.line})")
        return signed(bits)

    def term(self, call, before):
        kind, inner = re.fullmatch(r"(\w+)\((.*)\)", call).groups()
        names = arguments(inner)
        if kind == "full":
            return self.words[names[0]]
        factor, name = (names[0], names[1]) if kind == "by" else ("", names[0])
        source = (names[2] if len(names) > 2 else "XAcc") if kind == "by" else \
            names[0] if kind in ("left", "right") else "XAcc"
        x = {"XWord": self.words.get(names[1] if len(names) > 1 else name), "XAcc": before,
             "XCount": signed(24), "XSmall": (0, 65535) if factor == "FAge" else (1, 1)}[source]
        x = self.check("x", x, self.x_bits)
        if kind == "left":
            x = by_power(x, 32 + int(names[2]))
        elif kind == "right":
            x = by_power(x, 32 - int(names[2]))
        elif kind == "ratio":
            x = shifted(times(x, signed(16)), 16)
        elif kind == "scaled":
            x = join(*(by_power(x, 35 - int(names[1]) + exponent) for exponent in range(-16, 16)))
        else:
            if factor == "FTime":
                self.check("time", self.words[name], 18)
            x = times(x, FACTORS[factor])
        return join(x, (0, 0)) if names[-1].startswith("If") else x

    def step(self, before, first):
        call, add, fit, word, when = (arguments(self.line) + ["Load", "Free", "Zero", "Never"][
            len(arguments(self.line)) - 1:])[:5]
        term = self.check("term", self.term(call, before), self.sum_bits)
        if add.startswith(("Minus", "LoadNeg")):
            minus = times(term, (-1, -1))
            term = minus if add in ("Minus", "LoadNeg") else join(term, minus)
        result = term if add.startswith("Load") else (first[0] + term[0], first[1] + term[1])
        result = self.check("sum", result, self.sum_bits)
        if fit.startswith("Sat"):
            result = cut(result, int(fit[3:]))
        elif fit in ("Low", "High"):
            result = tuple((min if fit == "Low" else max)(end, 0) for end in result)
        for words, bits in self.related.items():
            if words in self.line:
                self.used.add(words)
                result = cut(result, bits)
        result = join(result, (0, 0))  # in reset
        if when != "Never":
            self.store(word, result, when)
        return result

    def store(self, word, x, when):
        if word in SCRATCH:
            self.words[word] = x if when == "Always" else join(x, self.words[word])
        elif WORDS[word] != WRAPPED:
            self.check(f"word {word}", x, WORDS[word])


class PrecisionWidthsTest(unittest.TestCase):
    def setUp(self):
        self.text = PACKAGE.read_text(encoding="utf-8")

    def test_no_factor_term_or_sum_loses_a_bit(self):
        walk = Walk(self.text, WORDS, RELATED)
        self.assertEqual(len(walk.lines), int(re.search(r"Size = (\d+)", self.text)[1]))
        self.assertEqual(walk.wrong, [])
        self.assertEqual(walk.used, set(RELATED))

    def test_narrower_ones_would(self):
        for narrow in ("SumWidth = 50", "XWidth = 34"):
            text = re.sub(rf"{narrow.split()[0]} = \d+", narrow, self.text)
            self.assertNotEqual(Walk(text, WORDS, RELATED).wrong, [], narrow)

    def test_ranges_alone_do_not_tell_it_of_related_words(self):
        for words in RELATED:
            rest = {w: bits for w, bits in RELATED.items() if w != words}
            with self.subTest(words):
                self.assertNotEqual(Walk(self.text, WORDS, rest).wrong, [])
