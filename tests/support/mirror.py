# SPDX-License-Identifier: Apache-2.0
"""A motion and the same one backwards: what is told of both is alike but for its sign."""

import json
import shutil
import subprocess
import unittest

SLACK = {"counts": 2, "A": 0.3, "V": 1, "s": 0.25}  # rounding is not alike


class Mirror(unittest.TestCase):
    moves = {}     # scenario: {key: value}, of which positions are turned round
    signed = ()    # ids of figures that have the sign of the motion
    unlike = ()    # ids of figures that depend on how the motor hunts within a count
    program, folder = None, None

    def figures(self, scenario, keys, name):
        shutil.rmtree(self.folder / name, ignore_errors=True)
        words = [word for key, value in keys.items() for word in ("-s", f"{key}={value}")]
        done = subprocess.run([self.program, "run", scenario, "--engine", "twin", *words, "-o",
                               self.folder / name], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        metrics = json.loads((self.folder / name / "metrics.json").read_text(encoding="utf-8"))
        return metrics["verdict"], {f["id"]: f for f in metrics["figures"]}

    def test_a_motion_backwards_has_the_figures_of_the_one_forwards(self):
        for scenario, keys in self.moves.items():
            with self.subTest(scenario=scenario):
                turned = {key: -value if "position" in key else value
                          for key, value in keys.items()}
                verdict, ahead = self.figures(scenario, keys, "ahead")
                other, back = self.figures(scenario, turned, "back")
                self.assertEqual(verdict, other)
                self.assertEqual(set(ahead), set(back))
                for name, figure in ahead.items():
                    if name in self.unlike:
                        continue
                    value, sign = figure["value"], -1 if name in self.signed else 1
                    self.assertAlmostEqual(
                        back[name]["value"] * sign, value,
                        delta=0.03 * abs(value) + SLACK.get(figure["unit"], 0), msg=name)
