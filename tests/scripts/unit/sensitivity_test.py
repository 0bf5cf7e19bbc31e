# SPDX-License-Identifier: Apache-2.0
"""What trammel verify --sensitivity makes of values and figures."""

import unittest

from trammel_tools import machines
from trammel_tools.check import sensitivity


class Changes(unittest.TestCase):

    def test_of_a_figure_are_relative_and_of_one_in_percent_in_its_points(self):
        mean = {"value": 2.0, "unit": "mm"}
        self.assertEqual(sensitivity.change(mean, {"value": 2.1}), "+5.0")
        self.assertEqual(sensitivity.change(mean, {"value": 1.0}), "-50")
        self.assertEqual(sensitivity.change(mean, {"value": 1.9995}), "0")
        overshoot = {"value": 20.0, "unit": "%"}
        self.assertEqual(sensitivity.change(overshoot, {"value": 22.5}), "+2.5")


class Values(unittest.TestCase):

    def test_of_all_axes_must_be_the_same(self):
        options = {"gains.x.kp": 0.5, "gains.y.kp": 0.5, "plant.x.mass_kg": 2, "plant.y.mass_kg": 8,
                   "plant.seed": 1}
        self.assertEqual(sensitivity.value_of(options, "gains.kp"), 0.5)
        self.assertEqual(sensitivity.value_of(options, "plant.y.mass_kg"), 8)
        self.assertEqual(sensitivity.value_of(options, "plant.seed"), 1)
        for key in ("plant.mass_kg", "gains.kx"):
            with self.assertRaisesRegex(machines.MachineError, key):
                sensitivity.value_of(options, key)


if __name__ == "__main__":
    unittest.main()
