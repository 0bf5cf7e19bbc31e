# SPDX-License-Identifier: Apache-2.0
"""The description for FuseSoC, trammel.core, is whole for each of its targets."""

import unittest

from trammel_tools.paths import ROOT

try:
    import yaml
except ModuleNotFoundError:
    yaml = None


@unittest.skipIf(yaml is None, "PyYAML of scripts/requirements.txt is missing")
class CoreTest(unittest.TestCase):
    def setUp(self):
        self.core = yaml.safe_load((ROOT / "trammel.core").read_text(encoding="utf-8"))

    def files(self, target):
        for name in target["filesets"]:
            for file in self.core["filesets"][name]["files"]:
                yield file if isinstance(file, str) else next(iter(file))

    def test_a_target_has_the_file_of_its_top_level_and_of_all_that_is_below(self):
        for name, target in self.core["targets"].items():
            with self.subTest(target=name):
                stems = [file.rsplit("/", 1)[-1] for file in self.files(target)]
                self.assertIn(f"{target['toplevel']}.sv", stems)
                self.assertIn("kung_xy.sv", stems)
                self.assertEqual(len(stems), len(set(stems)))

    def test_each_file_is_there_and_each_fileset_is_of_some_target(self):
        used = set()
        for target in self.core["targets"].values():
            used.update(target["filesets"])
            for file in self.files(target):
                self.assertTrue((ROOT / file).is_file(), file)
        self.assertEqual(used, set(self.core["filesets"]))
