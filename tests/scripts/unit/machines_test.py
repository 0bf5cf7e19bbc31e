# SPDX-License-Identifier: Apache-2.0
"""What the files of machines tell the tools: budgets and floors as one table, runs, scenarios."""

from types import SimpleNamespace
from unittest import mock

from scratch import Scratch
from trammel_tools import machines
from trammel_tools.check import engines, sanitize


class MachinesTest(Scratch):
    def setUp(self):
        super().setUp()
        self.patch(machines, ROOT=self.folder)
        for name in ("saw", "winder"):
            self.write(f"machines/{name}/machine.cpp", "")

    def test_a_folder_with_a_description_is_a_machine(self):
        self.write("machines/draft/README.md", "")
        self.write("machines/saw/scenarios/saw-cut.toml", "")
        self.write("machines/winder/scenarios/spin.toml", "")
        self.assertEqual(list(machines.folders()), ["saw", "winder"])
        self.assertEqual(machines.scenarios(), {"saw-cut": "saw", "spin": "winder"})

    def test_a_machine_may_be_anywhere_in_examples_but_has_a_name_of_its_own(self):
        self.write("examples/drives/lathe/machine.cpp", "")
        self.write("examples/drives/lathe/scenarios/turn.toml", "")
        self.assertEqual(machines.folders()["lathe"], self.folder / "examples/drives/lathe")
        self.assertEqual(machines.scenarios(), {"turn": "lathe"})
        self.write("examples/saw/machine.cpp", "")
        with self.assertRaisesRegex(machines.MachineError,
                                    "machines/saw/machine.cpp: examples/saw/ is a machine of that"):
            machines.folders()

    def test_tables_of_all_files_are_one(self):
        shared = self.write("scripts/floors.toml", "[toggles]\ndefault = 95\n[[list]]\nfile = 1\n")
        self.write("machines/saw/floors.toml", "[toggles]\nsaw = 9\n[[list]]\nfile = 2\n")
        self.write("parts/servo/floors.toml", "[other]\nservo = 8\n")
        self.assertEqual(machines.tables("floors.toml", shared),
                         {"toggles": {"default": 95, "saw": 9}, "other": {"servo": 8},
                          "list": [{"file": 1}, {"file": 2}]})

    def test_a_value_of_two_files_and_a_file_that_is_no_table_are_named(self):
        self.write("machines/saw/floors.toml", "[cells]\na = 1\n")
        second = self.write("machines/winder/floors.toml", "[cells]\na = 2\n")
        with self.assertRaisesRegex(machines.MachineError,
                                    "machines/winder/floors.toml: a is in another file too"):
            machines.tables("floors.toml")
        second.write_text("[cells\n", encoding="utf-8")
        with self.assertRaisesRegex(machines.MachineError, "machines/winder/floors.toml: "):
            machines.tables("floors.toml")

    def test_a_program_that_fails_says_nothing(self):
        with self.assertRaisesRegex(machines.MachineError, "exit 1"):
            machines.described("false")

    def test_both_engines_run_what_each_machine_says(self):
        self.write("machines/saw/scenarios/cut.toml", "")
        self.write("machines/saw/scenarios/long.toml", "")
        self.write("machines/winder/scenarios/spin.toml", "")
        self.write("machines/saw/tests/runs.toml",
                   "[engines]\nvariants = ['a=1', 'a=2']\nshort = ['cut']\n")
        self.assertEqual(engines.scenarios(), ["cut", "long", "spin"])
        self.assertEqual(engines.scenarios(short=True), ["cut"])
        self.assertEqual(engines.variants("saw"), ["a=1", "a=2"])
        self.assertEqual(engines.variants("winder"), [""])
        with mock.patch.object(machines, "described", return_value=[
                {"name": "saw", "twin": True}, {"name": "winder", "twin": False}]):
            self.assertEqual(engines.with_twin(["cut", "spin"]), [("cut", "saw")])

    def test_faults_of_a_machine_are_those_that_its_key_offers(self):
        program = self.write("program", '#!/bin/sh\necho "[{\\"key\\": \\"$KEY\\", '
                             '\\"range\\": \\"one of none, open, short\\"}]"\n')
        program.chmod(0o755)
        for key, kinds in (("inject.fault", ["open", "short"]), ("other", [])):
            self.assertEqual(machines.fault_kinds(program, "saw", {"KEY": key}), kinds)

    def test_runs_of_the_sanitizers_are_those_of_every_machine(self):
        self.write("machines/saw/tests/sanitize.py",
                   "RUNS = [(0, 'run', 'cut', '-o', 'OUT/cut')]\n"
                   "REFUSED = [(2, 'no', 'cut')]\nFOLDER = 'OUT/cut'\n")
        cases = machines.modules("sanitize")
        self.assertEqual(list(cases), ["saw"])
        cases["winder"] = SimpleNamespace(RUNS=[(5, "run", "spin", "-o", "OUT/spin")], REFUSED=[],
                                          FOLDER="OUT/spin", passes=lambda *_: False)
        runs, refused = sanitize.of_machine("saw", cases["saw"], [])
        self.assertIn((0, "run", "cut", "-o", "OUT/cut"), runs)
        self.assertIn((0, "list", "keys", "saw"), runs)
        self.assertIn((2, "no", "cut"), refused)
        runs, refused = sanitize.of_all(cases)
        self.assertIn((5, "run", "spin", "-o", "OUT/spin"), runs)
        self.assertIn((2, "only runs of one machine", "report", "OUT/cut", "OUT/spin", "-o",
                       "OUT/two.html"), refused)
        cases = cases.values()
        self.assertEqual(sanitize.call_each(cases, "passes", 1, 2, 3), [False])
