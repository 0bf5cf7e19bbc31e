# SPDX-License-Identifier: Apache-2.0
"""Symbols that firmware must not be linked with."""

import unittest
from pathlib import Path

from trammel_tools.check import firmware


class FirmwareTest(unittest.TestCase):
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

    def test_a_driver_needs_its_own_functions_only_and_keeps_nothing(self):
        right = "a T 0 4\nb t 4 4\na U\ntext r 0 1\n"
        self.assertEqual(list(firmware.driver_problems("x", right)), [])
        self.assertEqual(list(firmware.driver_problems("x", right + "memcpy U\n")),
                         ["firmware: x needs memcpy"])
        self.assertEqual(list(firmware.driver_problems("x", right + "m b 0 4\nn D 0 4\no C 4\n")),
                         ["firmware: x keeps m, n, o"])
