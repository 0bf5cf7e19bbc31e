# SPDX-License-Identifier: Apache-2.0
"""Symbols that firmware must not be linked with."""

from pathlib import Path
from unittest import mock

from scratch import Scratch, call
from trammel_tools.check import firmware


class FirmwareTest(Scratch):
    def test_each_kind_is_named_with_its_symbols(self):
        for what, symbols in (("heap", ["malloc", "_Znwj"]), ("streams", ["_ZSt4cout", "printf"]),
                              ("floating point", ["__adddf3", "__fixunssfsi"]),
                              ("exceptions", ["__cxa_throw", "_Unwind_Resume"])):
            self.assertEqual(list(firmware.forbidden({*symbols, "main"})),
                             [f"firmware: {what} is linked: {', '.join(sorted(symbols))}"])

    def test_arithmetic_of_integers_is_not_forbidden(self):
        self.assertEqual(list(firmware.forbidden({"main", "__divdi3", "__muldi3", "memcpy",
                                                  "mallocator", "reprintf"})), [])

    def test_an_app_is_a_program_when_it_has_a_main(self):
        sources = [Path(path) for path in ("apps/a/a.cpp", "apps/a/rv32im/main.cpp", "hal/x.cpp",
                                           "apps/b/b.cpp", "apps/b/rv32im/other.cpp")]
        self.assertEqual(firmware.programs(sources), ["a"])
        self.assertEqual([firmware.app_of(source) for source in sources],
                         ["a", "a", None, "b", "b"])

    def test_words_are_not_written_through_a_link(self):
        program = self.write("app.elf", "")
        self.write("app.bin", "abcdefg")
        victim = self.write("victim", "mine")
        (self.folder / "app.hex").symlink_to(victim)
        with mock.patch.object(firmware, "run", return_value=""), \
                mock.patch.object(firmware, "compiled", return_value=[]), \
                mock.patch.object(firmware, "programs", return_value=["app"]), \
                mock.patch.object(firmware, "link", return_value=program), \
                mock.patch("shutil.which", return_value="g++"):
            code, _, err = call(firmware.main, "--words", "app", self.folder / "app.hex")
            self.assertEqual((code, err.count("\n")), (2, 1))
            self.assertIn("not a regular file", err)
            self.assertEqual(victim.read_text(), "mine")
            (self.folder / "app.hex").unlink()
            self.assertEqual(call(firmware.main, "--words", "app", self.folder / "app.hex"),
                             (0, "", ""))
        self.assertEqual((self.folder / "app.hex").read_text(), "64636261\n00676665\n")

    def test_a_driver_needs_its_own_functions_only_and_keeps_nothing(self):
        right = "a T 0 4\nb t 4 4\na U\ntext r 0 1\n"
        self.assertEqual(list(firmware.driver_problems("x", right)), [])
        self.assertEqual(list(firmware.driver_problems("x", right + "memcpy U\n")),
                         ["firmware: x needs memcpy"])
        self.assertEqual(list(firmware.driver_problems("x", right + "m b 0 4\nn D 0 4\no C 4\n")),
                         ["firmware: x keeps m, n, o"])
