# SPDX-License-Identifier: Apache-2.0
"""The margins of the precision controller's loop are those of its specification and page."""

import math
import unittest

import precision_step

try:
    import precision_margins
except ModuleNotFoundError:  # numpy
    precision_margins = None

MODES_HZ = (60, 100, 160, 250, 400, 500, 600, 800, 1000)
MASS = 3.9  # factor, either way


@unittest.skipIf(precision_margins is None, "numpy is not installed")
class PrecisionMarginsTest(unittest.TestCase):
    def setUp(self):
        self.sets = precision_margins.sets()

    def test_margins_are_those_of_the_specification(self):
        # Of its section 5.
        specified = {"full": (629, 40.2, 12.2, -11.8, 1.59),
                     "soft": (167, 51.8, 20, -math.inf, 1.27)}
        printed = precision_margins.printed()
        self.assertEqual(set(printed), set(specified))
        for name, values in specified.items():
            found = precision_margins.margins(self.sets[name][1])
            for own, wanted, shown, off in zip(vars(found).values(), values,
                                               vars(printed[name]).values(),
                                               (1, 0.06, 0.06, 0.06, 0.006)):
                with self.subTest(set=name, wanted=wanted):
                    if math.isinf(wanted):
                        self.assertEqual((own, shown), (wanted, wanted))
                    else:
                        self.assertLess(abs(own - wanted), off)
                        self.assertLess(abs(own - shown), off)
            self.assertLess(found.sensitivity, 1.7)

    def test_the_words_are_the_nearest_of_the_poles(self):
        for name, ((w1, zeta, w2, w3), words) in self.sets.items():
            for (mant, exp), gain in zip(words, precision_step.gains(w1, zeta, w2, w3)):
                with self.subTest(set=name, gain=gain):
                    self.assertLessEqual(abs(mant - gain * 2048 / 2.0**exp), 0.5)

    def test_a_jump_swings_only_where_the_current_is_at_its_limit(self):
        for mass in (2.5, 25):
            found = precision_step.step(mass, length=1e-4)
            self.assertEqual(found.swings, 0)
            self.assertLess(found.settled_s, 0.02)
            self.assertLess(found.beyond_m, 1e-5)
        self.assertEqual(precision_step.step(2.5).swings, 2)  # as the page says
        self.assertEqual(precision_step.step(25).swings, 4)
        self.assertEqual(precision_step.step(25, (150, 0.7, 2000, 200)).swings, 2)

    def test_a_mass_that_is_wrong_by_a_factor_keeps_the_loop(self):
        controller, table = precision_margins.law(self.sets["full"][1]), precision_margins.plant()
        for factor in (1 / MASS, 1, MASS):
            self.assertTrue(precision_margins.stable(controller, table, factor))
        for factor in (1 / 4, 4.2):
            self.assertFalse(precision_margins.stable(controller, table, factor))

    def test_elastic_modes_leave_a_gain_margin(self):
        up = {}
        for hertz in MODES_HZ:
            found = precision_margins.gain_margins(self.sets["full"][1], hertz)
            self.assertIsNotNone(found, f"unstable at {hertz} Hz")
            self.assertLess(found[1], -10)
            up[hertz] = found[0]
        # The specification's 3.9 dB, at 400 and 600 Hz; the least is between them.
        self.assertGreater(min(up[400], up[600]), 3.85)
        self.assertGreater(min(up.values()), 2.75)
        self.assertEqual(min(up, key=up.get), 500)


if __name__ == "__main__":
    unittest.main()
