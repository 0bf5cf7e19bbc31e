# SPDX-License-Identifier: Apache-2.0
"""The layout check on machines: companions, names in shared text, chips without a contract."""

from scratch import Scratch
from trammel_tools.check import check_layout, layout_uses
from trammel_tools.check.rooms import ROOMS

LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"
PLAIN = LICENCE + """module winder_pwm (
    input logic clk_i
);
  always_ff @(posedge clk_i) on_o <= 1;
endmodule
"""
PAGE = """# chips/winder_pwm

| | |
|---|---|
| Shape | a |
| Latency | 1 |
| Source | - |
| Twin | - |
| Properties | none |
"""
MACHINE = "machines/winder/machine.cpp"
CHIP = "rtl/chips/winder_pwm.sv"
NO_CONTRACT = LICENCE + "  m.can.leap = false;\n  m.can.twin = false;\n"
GOOD = {
    MACHINE: NO_CONTRACT,
    "machines/winder/README.md": "# winder\n",
    "machines/winder/chip.cmake": "trammel_chip(winder_pwm)\n",
    "machines/winder/scenarios/winder-spin.toml": 'machine = "winder"\n',
    "machines/winder/tests/keys_test.cpp": LICENCE,
    "sw_nios/apps/winder/winder.hpp": LICENCE,
    "sw_nios/apps/winder/winder.cpp": LICENCE,
    "waves/winder.toml": "[*] winder\n",
    CHIP: PLAIN,
    "rtl/chips/winder_pwm.md": PAGE,
    "docs/page.md": "The machine winder.\n",
}


class Layout(Scratch):
    def findings(self, changes):
        """Of a good repository with these files added, changed, or, with None, left out."""
        self.setUp()
        self.init()
        for path, text in {**GOOD, **changes}.items():
            if text is not None:
                self.write(path, text)
        return list(check_layout.findings(self.folder))

    def finds(self, told, changes):
        with self.subTest(told):
            self.assertEqual(self.findings(changes), [told])


class CompanionsTest(Layout):
    def test_a_machine_of_examples_has_all_in_its_folder(self):
        own = "examples/drives/lathe"
        files = {f"{own}/machine.cpp": NO_CONTRACT, f"{own}/README.md": "# lathe\n",
                 f"{own}/view.toml": "[*] lathe\n", f"{own}/scenarios/turn.toml": "",
                 f"{own}/tests/keys_test.cpp": LICENCE,
                 f"{own}/chip.cmake": "trammel_chip(lathe_pwm)\n",
                 f"{own}/rtl/lathe_pwm.sv": PLAIN.replace("winder", "lathe"),
                 f"{own}/rtl/lathe_pwm.md": PAGE.replace("chips/winder", "lathe/lathe")}
        self.assertEqual(self.findings(files), [])
        self.finds(f"{own}/: companion {own}/view.toml is missing",
                   {**files, f"{own}/view.toml": None})
        self.finds(f"{own}/chip.cmake: there is no {own}/rtl/lathe_pwm.sv",
                   {**files, f"{own}/rtl/lathe_pwm.sv": None})

    def test_there_is_nothing_to_say_of_a_good_machine(self):
        self.assertEqual(self.findings({}), [])

    def test_a_missing_companion_is_named(self):
        for path in ("machines/winder/README.md", "sw_nios/apps/winder/winder.cpp",
                     "sw_nios/apps/winder/winder.hpp", "waves/winder.toml"):
            self.finds(f"machines/winder/: companion {path} is missing", {path: None})
        self.finds("machines/winder/: no scenario in machines/winder/scenarios/",
                   {"machines/winder/scenarios/winder-spin.toml": None})
        self.finds("machines/winder/: no test in machines/winder/tests/",
                   {"machines/winder/tests/keys_test.cpp": None})

    def test_a_description_of_another_name_is_missing(self):
        self.assertIn("machines/winder/: companion machines/winder/machine.cpp is missing",
                      self.findings({MACHINE: None, "machines/winder/machines.cpp": NO_CONTRACT}))

    def test_a_machine_has_a_chip_or_that_of_a_part(self):
        bare = {"machines/winder/chip.cmake": None, CHIP: None, "rtl/chips/winder_pwm.md": None}
        told = ("machines/winder/: neither machines/winder/chip.cmake nor the chip of a part of "
                "parts/")
        self.finds(told, bare)
        part = {"parts/servo/chip.cmake": "trammel_chip(servo)\n", "parts/servo/pins.hpp": LICENCE}
        self.finds(told, {**bare, **part})
        used = {MACHINE: NO_CONTRACT + '#include "parts/servo/pins.hpp"\n'}
        self.assertEqual(self.findings({**bare, **part, **used}), [])

    def test_firmware_and_views_of_no_machine_are_named(self):
        stray = "there is no machines/winde/; did you mean winder?"
        self.finds(f"sw_nios/apps/winde: {stray}", {"sw_nios/apps/winde/winde.hpp": LICENCE})
        self.finds(f"waves/winde.toml: {stray}", {"waves/winde.toml": "[*] x\n"})
        self.finds("waves/zz.toml: there is no machines/zz/", {"waves/zz.toml": "[*] x\n"})


class SessionTest(Layout):
    def test_a_session_reads_its_firmware_by_the_mailbox(self):
        header = LICENCE + "struct Session {\n  sw::WinderApp app_;\n};\n"
        session = LICENCE + "void f() { app_.isr(b); g(app_.mailbox().done); }\n"
        for folder in ("machines/winder", "machines/winder/run"):
            with self.subTest(folder):
                files = {f"{folder}/session.hpp": header, f"{folder}/session.cpp": session}
                self.assertEqual(self.findings(files), [])
                self.finds(f"{folder}/session.cpp:2: a session calls start(), isr() and mailbox() "
                           "of its firmware, no turns()",
                           {**files, f"{folder}/session.cpp": session.replace("mailbox", "turns")})

    def test_it_reads_a_wrapper_of_its_firmware_by_the_mailbox(self):
        for member, call in (("sw::WinderApp app_", "app_."), ("SlowApp app_", "app_."),
                             ("std::unique_ptr<SlowApp> app_", "app_->"),
                             ("std::unique_ptr<sw::WinderApp> app_", "app_->")):
            with self.subTest(member):
                header = LICENCE + f"struct Session {{\n  {member};\n}};\n"
                session = LICENCE + f"void f() {{ {call}isr(b); g({call}mailbox().done); }}\n"
                files = {"machines/winder/session.hpp": header,
                         "machines/winder/session.cpp": session}
                self.assertEqual(self.findings(files), [])
                self.finds("machines/winder/session.cpp:2: a session calls start(), isr() and "
                           "mailbox() of its firmware, no turns()",
                           {**files, "machines/winder/session.cpp":
                            session.replace("mailbox", "turns")})


class NamesTest(Layout):
    def test_program_text_that_machines_share_does_not_name_one(self):
        for path, line in (("lab/machine.cpp", LICENCE + "// as winder does"),
                           ("lab/page/main.js", LICENCE + "if (name === 'winder') {}"),
                           ("scripts/tools/x.py", LICENCE.replace("//", "#") + "M = 'winder'"),
                           ("cmake/x.cmake", "\nset(all winder)"),
                           ("scripts/floors.toml", "\nwinder = 3"),
                           ("tests/CMakeLists.txt", "\nrun(winder-spin)"),
                           ("go", "#!/bin/sh\n# SPDX-License-Identifier: Apache-2.0\nrun winder"),
                           ("machines/other.cpp", LICENCE + "// winder")):
            number = line.count("\n") + 1
            self.finds(f"{path}:{number}: names the machine winder", {path: line + "\n"})

    def test_a_script_names_no_chip_or_board_of_a_machine(self):
        for name in ("winder_pwm", "ecp5_winder", "ecp5_winder_soc"):
            self.finds("scripts/tools/x.py:2: names the machine winder",
                       {"scripts/tools/x.py": LICENCE.replace("//", "#") + f"TOP = '{name}'\n"})
        self.assertEqual(self.findings({
            "scripts/tools/x.py": LICENCE.replace("//", "#") + "rewinder = winders = 1\n",
            "machines/winder/tests/tools/x.py": LICENCE.replace("//", "#") + "T = 'winder_pwm'\n",
        }), [])

    def test_a_package_or_register_map_of_a_machine_is_among_its_chips(self):
        package = LICENCE + "package winder_pkg;\n"
        for path, kind in (("rtl/pkg/winder_pkg.sv", "package"), ("rtl/drive/winder_pkg.sv",
                                                                  "package"),
                           ("rtl/pkg/winder_pwm.rdl", "register map")):
            self.finds(f"{path}: a {kind} of the machine winder in a general folder; its place is "
                       "rtl/chips/", {path: package})
        self.assertEqual(self.findings({"rtl/chips/winder_pkg.sv": package,
                                        "rtl/chips/winder_pwm.rdl": LICENCE,
                                        "rtl/pkg/rewinder_pkg.sv": package}), [])

    def test_a_model_of_a_machine_is_in_its_folder_or_among_the_chips(self):
        for path in ("models/ideal/winder_track.hpp", "models/plant/winder.cpp"):
            self.finds(f"{path}: a model of the machine winder in a general folder; its place is "
                       "machines/winder/ or models/exact/chips/", {path: LICENCE})
        self.assertEqual(self.findings({"models/exact/chips/winder_pwm.hpp": LICENCE,
                                        "models/ideal/rewinder.hpp": LICENCE}), [])

    def test_only_its_own_code_has_the_register_map_of_a_machine(self):
        use = LICENCE + '#include "rtl/chips/generated/winder_pwm_regs.hpp"\n'
        for path in ("lab/run.cpp", "models/plant/motor.hpp", "models/exact/drive/pwm.hpp"):
            self.finds(f"{path}:2: uses the register map of the machine winder", {path: use})
        own = ("machines/winder/session.cpp", "sw_nios/apps/winder/bus.hpp",
               "tests/chips/bench.hpp", "models/exact/chips/winder_pwm.hpp")
        self.assertEqual(self.findings(dict.fromkeys(own, use)), [])

    def test_a_machine_does_not_name_another_one(self):
        other = {path.replace("winder", "saw"): text.replace("winder", "saw")
                 for path, text in GOOD.items()}
        self.assertEqual(self.findings(other), [])
        self.finds("machines/saw/keys.cpp:2: names the machine winder",
                   {**other, "machines/saw/keys.cpp": LICENCE + "// winder\n"})
        self.finds("sw_nios/apps/saw/saw.cpp:2: names the machine winder",
                   {**other, "sw_nios/apps/saw/saw.cpp": LICENCE + "// winder\n"})

    def test_other_words_names_of_sources_and_pages_are_free(self):
        self.assertEqual(self.findings({
            "lab/machine.cpp": LICENCE + "// Winder 2012 eq. 3; rewinder; winder_pwm\n",
            "README.md": "winder\n", "CHANGELOG.md": "winder\n",
            "rtl/chips/generated/x.hpp": "// winder\n",
            "models/plant/motor.hpp": LICENCE + "// of winder\n"}), [])


class ContractTest(Layout):
    def test_a_chip_without_a_contract_says_so(self):
        told = (f"{CHIP}: has no ports leap_i and quiescent_o, and {MACHINE} does not say "
                "`can.leap = false;`")
        twin = (f"{CHIP}: companion models/exact/chips/winder_pwm.hpp is missing, and {MACHINE} "
                "does not say `can.twin = false;`")
        props = f"{CHIP}: companion rtl/chips/winder_pwm_props.sv is missing"
        self.assertEqual(self.findings({MACHINE: LICENCE}), [props, told, twin])
        self.assertEqual(self.findings({
            MACHINE: LICENCE + "  m.can.leap = false;\n",
            "models/exact/chips/winder_pwm.hpp": LICENCE}), [])

    def test_a_chip_with_a_contract_has_the_companions_of_one(self):
        ports = "    input logic leap_i,\n    output logic quiescent_o,\n"
        self.assertEqual(
            self.findings({CHIP: PLAIN.replace("(\n", f"(\n{ports}", 1),
                           "rtl/chips/winder_pwm.md": PAGE + "`leap_i` `quiescent_o`\n"}),
            [f"{CHIP}: companion rtl/chips/winder_pwm_props.sv is missing",
             f"{CHIP}: companion rtl/chips/winder_pwm_leap.toml is missing"])

    def test_a_chip_that_is_named_is_there(self):
        self.finds("machines/winder/chip.cmake: there is no rtl/chips/winder.sv",
                   {"machines/winder/chip.cmake": "trammel_chip(winder)\n", CHIP: None,
                    "rtl/chips/winder_pwm.md": None})


class UsesTest(Layout):
    def test_folders_include_only_what_lies_below(self):
        good = {"parts/servo/chip.cmake": "trammel_chip(servo)\n"}
        for path, name, who in (
                ("host/text.hpp", "models/fixed/fixed.hpp", "host"),
                ("host/text.hpp", "lab/record.hpp", "host"),
                ("models/plant/motor.hpp", "host/text.hpp", "models/plant"),
                ("paths/gcode.hpp", "cosim/loop.hpp", "paths"),
                ("cosim/loop.hpp", "host/text.hpp", "cosim"),
                ("cosim/loop.hpp", "lab/record.hpp", "cosim"),
                ("cosim/loop.hpp", "systemc/platform.hpp", "cosim"),
                ("systemc/platform.hpp", "lab/record.hpp", "systemc"),
                ("lab/record.hpp", "testbench/run.hpp", "lab"),
                ("lab/record.hpp", "parts/servo/pins.hpp", "lab"),
                ("lab/record.hpp", "models/plant/motor.hpp", "lab"),
                ("parts/servo/pins.hpp", "testbench/run.hpp", "parts"),
                ("parts/servo/pins.hpp", "systemc/platform.hpp", "parts"),
                ("parts/servo/driver/servo.h", "parts/servo/pins.hpp", "parts/servo/driver"),
                ("parts/servo/driver/servo.c", "sw_nios/hal/bus.hpp", "parts/servo/driver"),
                ("testbench/run.hpp", "parts/servo/pins.hpp", "testbench"),
                ("testbench/run.hpp", "systemc/platform.hpp", "testbench"),
                ("machines/winder/keys.cpp", "systemc/platform.hpp", "machines/winder"),
                ("sw_nios/hal/bus.hpp", "cosim/loop.hpp", "sw_nios"),
                ("sw_nios/apps/winder/winder.hpp", "lab/record.hpp", "sw_nios/apps/winder"),
                ("machines/winder/keys.cpp", "testbench/run.hpp", "machines/winder"),
                ("machines/winder/keys.cpp", "tests/support/x.hpp", "machines/winder"),
                ("machines/winder/keys.cpp", "machines/saw/keys.hpp", "machines/winder"),
                ("machines/winder/keys.cpp", "sw_nios/apps/saw/saw.hpp", "machines/winder"),
                ("machines/winder/keys.cpp", "rtl/chips/generated/x_signals.hpp",
                 "machines/winder"),
                ("machines/winder/keys.cpp", "cosim/verilated/x.hpp", "machines/winder"),
                ("machines/winder/keys.cpp", "verilated.h", "machines/winder"),
                ("machines/winder/keys.cpp", "Vwinder_pwm.h", "machines/winder"),
                ("machines/winder/keys.cpp", "winder_pwm_traced.hpp", "machines/winder"),
                ("cosim/verilated/x.hpp", "rtl/chips/generated/x_signals.hpp", "cosim"),
                ("lab/record.hpp", "systemc", "lab"),
                ("lab/record.hpp", "Eigen/Dense", "lab")):
            self.finds(f"{path}:2: {who} may not include {name}",
                       {**good, path: f'{LICENCE}#include "{name}"\n'})

    def test_what_lies_below_is_free(self):
        for path, names in (
                ("cosim/loop.hpp", ("models/plant/x.hpp", "sw_nios/hal/bus.hpp",
                                    "rtl/chips/generated/x_regs.hpp")),
                ("cosim/verilated/x.hpp", ("verilated.h", "cosim/verilated/y.hpp")),
                ("parts/servo/verilated/x.hpp", ("Vservo.h", "rtl/chips/generated/x_signals.hpp")),
                ("parts/servo/driver/servo.c", ("servo.h", "stddef.h")),
                ("testbench/run.hpp", ("lab/record.hpp", "cosim/loop.hpp")),
                ("lab/wiring.cpp", ("systemc/platform.hpp", "cosim/loop.hpp", "host/text.hpp")),
                ("machines/winder/keys.cpp", ("parts/servo/x.hpp", "lab/x.hpp",
                                              "sw_nios/apps/winder/winder.hpp")),
                ("machines/winder/verbs/verbs.cpp", ("testbench/run.hpp",)),
                ("machines/winder/tests/keys_test.cpp", ("testbench/run.hpp", "verilated.h",
                                                         "tests/support/x.hpp", "systemc"))):
            text = LICENCE + "".join(f'#include "{name}"\n' for name in names)
            self.assertEqual(self.findings({path: text}), [], path)

    def test_no_header_includes_itself(self):
        texts = {"lab/a.hpp": ("lab/b.hpp", "lab/c.hpp"), "lab/b.hpp": ("cosim/x.hpp",),
                 "lab/c.hpp": ("lab/a.hpp",), "lab/a.cpp": ("lab/a.hpp",)}
        self.finds("lab/a.hpp: includes itself: lab/a.hpp -> lab/c.hpp -> lab/a.hpp",
                   {path: LICENCE + "".join(f'#include "{name}"\n' for name in names)
                    for path, names in texts.items()})

    def test_no_folder_of_a_machine_includes_one_above_it(self):
        plan, run = "machines/winder/plan", "machines/winder/run"
        texts = {f"{plan}/a.hpp": (f"{plan}/b.hpp",), f"{plan}/b.hpp": (),
                 f"{plan}/a.cpp": (f"{run}/a.hpp",), f"{run}/a.hpp": (),
                 f"{run}/b.cpp": (f"{plan}/b.hpp", "machines/winder/options.hpp")}
        self.finds(f"{plan}: folders include each other: {plan} -> {run} -> {plan}",
                   {path: LICENCE + "".join(f'#include "{name}"\n' for name in names)
                    for path, names in texts.items()})

    def test_no_room_may_use_one_above_it(self):
        for room, prefixes in layout_uses.USES.items():
            first = room.partition("/")[0]
            used = {prefix.partition("/")[0] for prefix in prefixes} & set(ROOMS)
            if first in ROOMS:
                self.assertLessEqual(max(map(ROOMS.index, used)), ROOMS.index(first), room)
