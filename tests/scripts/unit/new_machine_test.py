# SPDX-License-Identifier: Apache-2.0
"""A new machine keeps the rules of the layout; nothing is overwritten, and names are checked."""

import os

from scratch import Scratch, call
from trammel_tools.check import check_layout
from trammel_tools.generate import new_machine


class NewMachineTest(Scratch):
    def setUp(self):
        super().setUp()
        self.init()
        self.patch(new_machine, ROOT=self.folder)

    def files(self):
        return {path.relative_to(self.folder): path.read_bytes()
                for path in self.folder.rglob("*") if path.is_file() and ".git" not in path.parts}

    def refuse(self, *words):
        """What is said of them, one line; nothing is written."""
        before = self.files()
        code, out, err = call(new_machine.main, *words)
        self.assertEqual((code, out, err.count("\n")), (2, "", 1))
        self.assertEqual(self.files(), before)
        return err.removeprefix("new-machine: ").rstrip()

    def test_a_new_machine_has_all_that_the_layout_asks_for(self):
        for contract in ([], ["--contract"]):
            with self.subTest(contract):
                name = "a" * new_machine.LONGEST if contract else "axle"
                code, out, err = call(new_machine.main, name, *contract)
                self.assertEqual((code, err), (0, f"next: ./trammel run {name}-step\n"))
                self.assertIn(f"machines/{name}/machine.cpp", out.splitlines())
        self.assertEqual(list(check_layout.findings(self.folder)), [])
        for path, text in self.files().items():
            self.assertNotRegex(text, rb"@[A-Za-z]+@")
            self.assertNotIn("@", str(path))

    def test_the_contract_replaces_the_plain_chip_alone(self):
        call(new_machine.main, "spin")
        plain = self.files()
        code, out, _ = call(new_machine.main, "spin", "--contract")
        self.assertEqual(code, 0)
        changed = {str(path) for path, text in self.files().items() if plain.get(path) != text}
        self.assertEqual(changed, set(out.splitlines()))
        self.assertEqual(changed, {"machines/spin/machine.cpp", "rtl/chips/spin_pwm.sv",
                                   "rtl/chips/spin_pwm.md", "rtl/chips/spin_pwm_props.sv",
                                   "rtl/chips/spin_pwm_leap.toml"})
        self.assertEqual(self.refuse("spin", "--contract"),
                         "machines/spin has the contract already")

    def test_what_was_changed_by_hand_stays(self):
        call(new_machine.main, "spin")
        chip = self.folder / "rtl/chips/spin_pwm.sv"
        chip.write_text(chip.read_text() + "// mine\n")
        self.assertEqual(self.refuse("spin", "--contract"),
                         "rtl/chips/spin_pwm.sv was changed: the contract would undo that")
        chip.unlink()
        self.assertIn("rtl/chips/spin_pwm.sv is missing", self.refuse("spin", "--contract"))
        self.assertEqual(self.refuse("spin"), "machines/spin exists")

    def test_a_file_that_exists_stays(self):
        self.write("waves/spin.toml", "mine\n")
        self.assertEqual(self.refuse("spin"), "waves/spin.toml exists")

    def test_links_and_pipes_are_neither_read_nor_written_through(self):
        (self.folder / "waves").mkdir()
        (self.folder / "waves/spin.toml").symlink_to(self.folder / "victim")
        self.assertEqual(self.refuse("spin"), "waves/spin.toml exists")
        (self.folder / "waves/spin.toml").unlink()
        (self.folder / "machines").mkdir()
        (self.folder / "machines/spin").symlink_to("nowhere")
        self.assertEqual(self.refuse("spin"), "machines/spin exists")
        (self.folder / "machines/spin").unlink()
        call(new_machine.main, "spin")
        chip = self.folder / "rtl/chips/spin_pwm.sv"
        chip.rename(self.folder / "victim")
        chip.symlink_to(self.folder / "victim")
        self.assertIn("not a regular file", self.refuse("spin", "--contract"))
        chip.unlink()
        os.mkfifo(chip)
        self.assertIn("not a regular file", self.refuse("spin", "--contract"))

    def test_a_name_that_is_none_is_told_on_one_line_whatever_it_holds(self):
        self.assertIn("'ab\\u000a' is no name of a machine", self.refuse("ab\n"))
        for name in "a" * 300, "../docs":
            self.assertIn("is no name of a machine", self.refuse(name, "--contract"))

    def test_names_that_mean_something_are_refused(self):
        self.write("lab/gear.hpp", "// SPDX\nint shaft;\n")
        self.write("docs/wheel.md", "a spin is a turn\n")
        long = "a" * (new_machine.LONGEST + 1)
        for name in ("", "Spin", "1st", "two-words", "two_words", "../x", long):
            self.assertIn("is no name of a machine", self.refuse(name))
        self.assertIn("reserved word", self.refuse("goto"))
        for name in ("shaft", "gear"):
            self.assertEqual(self.refuse(name), f"'{name}' is a word that lab/gear.hpp uses; take "
                                                "one that no source does")
        self.assertEqual(call(new_machine.main, "spin")[0], 0)
