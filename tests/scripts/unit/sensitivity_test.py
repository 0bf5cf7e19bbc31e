# SPDX-License-Identifier: Apache-2.0
"""What trammel verify --sensitivity makes of values and figures."""

import unittest
from concurrent.futures import ThreadPoolExecutor
from unittest import mock

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
        for by, text in ((-0.04, "0"), (0.06, "+0.1"), (-0.06, "-0.1"), (9.94, "+9.9"),
                         (9.96, "+10"), (-9.96, "-10"), (100, "+100")):
            self.assertEqual(sensitivity.change(mean, {"value": 2 * (1 + by / 100)}), text)
        self.assertEqual(sensitivity.figure_text(mean), "2.000 mm")
        self.assertEqual(sensitivity.figure_text(overshoot), "20.0 %")
        self.assertEqual(sensitivity.figure_text({"value": 1.23456, "unit": ""}), "1.235")

    def test_a_row_has_the_change_of_the_lower_value_first(self):
        plan = {"variants": ["controller=fc", "controller=afc"], "share": 0.25}
        tried = {"scenario": "toy", "figures": {"err": "error", "over": "peak"},
                 "settings": ["a=1"]}

        def run(scenario, settings, folder):
            variant, more, *key = settings
            self.assertEqual((scenario, more), ("toy", "a=1"))
            value = float(key[0].partition("=")[2]) if key else 4.0
            times = {"controller=fc": 1, "controller=afc": 2}[variant]
            return {"err": {"value": value * times, "unit": "mm"},
                    "over": {"value": value + times, "unit": "%"}}, {"m.x.k": 4.0, "m.y.k": 4.0}

        with mock.patch.object(sensitivity, "run", run), ThreadPoolExecutor(2) as pool:
            text = sensitivity.rows(plan, tried, ["m.k"], "", pool)
        self.assertEqual(text, [
            "| | FC error | FC peak | AFC error | AFC peak |", "|---|---|---|---|---|",
            "| as it is | 4.000 mm | 5.0 % | 8.000 mm | 6.0 % |",
            "| `m.k` | -25, +25 | -1.0, +1.0 | -25, +25 | -1.0, +1.0 |"])


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
