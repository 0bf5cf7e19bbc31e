# SPDX-License-Identifier: Apache-2.0
"""The layout check on a small repository: no finding in a good one, one line per mistake."""

from scratch import Scratch
from trammel_tools.check import check_layout

LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"
MODULE = LICENCE + """module adder (
    input logic clk_i,
    input logic a_i,
    output logic sum_o
);
  always_ff @(posedge clk_i) sum_o <= a_i;
endmodule
"""
MODULE_OF_LAYER = """module {0} (
    input logic a_i
);
  {1} u_{1} (.*);
endmodule
"""
PAGE = """# math/adder

| | |
|---|---|
| Shape | a |
| Latency | 1 |
| Source | - |
| Twin | exact |
| Properties | `adder_props.sv` |

Ports: `a_i`, `sum_*`.
"""
GOOD = {
    "rtl/math/adder.sv": MODULE,
    "rtl/math/adder_props.sv": LICENCE + "module adder_props;\nendmodule\n",
    "rtl/math/adder.md": PAGE,
    "models/exact/math/adder.hpp": LICENCE + '#include "models/fixed/word.hpp"\n',
    "models/fixed/word.hpp": LICENCE + "#include <cstdint>\n",
    "tests/math/adder_test.cpp": LICENCE + "#include <Vadder.h>\n",
}


class CheckLayoutTest(Scratch):
    def findings(self, **changes):
        """Of the good repository with these files added, changed, or, with None, left out."""
        self.setUp()
        self.init()
        for path, text in {**GOOD, **changes}.items():
            if text is not None:
                self.write(path, text)
        return list(check_layout.findings(self.folder))

    def finds(self, told, changes):
        with self.subTest(told):
            self.assertEqual(self.findings(**changes), [told])

    def test_there_is_nothing_to_say_of_a_good_one(self):
        self.assertEqual(self.findings(), [])

    def test_a_missing_companion_is_named(self):
        for path in ("rtl/math/adder_props.sv", "models/exact/math/adder.hpp",
                     "tests/math/adder_test.cpp", "rtl/math/adder.md"):
            self.finds(f"rtl/math/adder.sv: companion {path} is missing", {path: None})
        self.finds("rtl/math/lone_props.sv: properties of no block",
                   {"rtl/math/lone_props.sv": LICENCE + "module lone_props;\nendmodule\n"})

    def test_a_block_without_registers_needs_no_properties(self):
        self.assertEqual(self.findings(**{
            "rtl/math/adder.sv": MODULE.replace("always_ff @(posedge clk_i) sum_o <=",
                                                "assign sum_o ="),
            "rtl/math/adder_props.sv": None}), [])

    def test_a_chip_that_leaps_has_broken_designs_unless_it_is_inside_another(self):
        def chip(name, body):
            return {f"rtl/chips/{name}.sv": LICENCE + f"module {name} (\n    input logic leap_i\n);"
                                                      f"\n{body}endmodule\n",
                    f"rtl/chips/{name}.md": PAGE.replace("math/adder", f"chips/{name}")
                                            + "`leap_i`\n"}

        missing = "rtl/chips/top.sv: companion rtl/chips/top_leap.toml is missing"
        self.assertEqual(self.findings(**chip("top", "  axis u_axis (.*);\n"), **chip("axis", "")),
                         [missing])

    def test_a_page_names_its_block_its_rows_and_every_port(self):
        page = "rtl/math/adder.md"
        for old, new, told in (
                ("# math/adder", "# math/add", f"{page}:1: first line is not '# math/adder'"),
                ("| Latency | 1 |\n", "", f"{page}: does not open with a table of Shape, Latency, "
                                          "Source, Twin, Properties"),
                ("`adder_props.sv`", "none", f"{page}: does not name adder_props.sv"),
                ("`sum_*`", "the sum", f"{page}: port sum_o of the module is missing")):
            self.finds(told, {page: PAGE.replace(old, new)})

    def test_lower_layers_do_not_see_higher_ones(self):
        def layer(name, used):
            stem = f"{name}_block"
            return {f"rtl/{name}/{stem}.sv": LICENCE + MODULE_OF_LAYER.format(stem, used),
                    f"rtl/{name}/{stem}.md": PAGE.replace("math/adder", f"{name}/{stem}"),
                    f"models/exact/{name}/{stem}.hpp": LICENCE,
                    f"tests/{name}/{stem}_test.cpp": LICENCE}

        self.assertEqual(self.findings(**layer("drive", "adder")), [])
        self.assertEqual(self.findings(**layer("math", "drive_block"), **layer("drive", "adder")),
                         ["rtl/math/math_block.sv:5: math may not use drive_block of drive"])
        self.assertEqual(self.findings(**layer("sense", "drive_block"), **layer("drive", "adder")),
                         ["rtl/sense/sense_block.sv:5: sense may not use drive_block of drive"])
        self.finds("rtl/pkg/low_pkg.sv:2: pkg may not use adder of math",
                   {"rtl/pkg/low_pkg.sv": LICENCE + "localparam int X = adder::Y;\n"})

    def test_no_block_uses_the_package_of_a_chip(self):
        self.finds("rtl/math/adder.sv:8: math may not use lathe_pkg of chips",
                   {"rtl/chips/lathe_pkg.sv": LICENCE + "package lathe_pkg;\n",
                    "rtl/math/adder.sv":
                    MODULE.replace("endmodule", "lathe_pkg::word_t a;\nendmodule")})

    def test_a_file_holds_the_module_of_its_name(self):
        self.finds("rtl/math/adder.sv: no module adder",
                   {"rtl/math/adder.sv": MODULE.replace("module adder", "module add")})

    def test_folders_of_cpp_include_only_what_lies_below(self):
        twin = "models/exact/math/adder.hpp"
        for include, told in (
                ('"models/ideal/motor.hpp"', "models/exact may not include models/ideal/motor.hpp"),
                ("<systemc>", "models/exact may not include systemc"),
                ("<cmath>", "models/exact holds integers only, no cmath")):
            self.finds(f"{twin}:2: {told}", {twin: f"{LICENCE}#include {include}\n"})

    def test_links_go_down_and_not_in_circles(self):
        for told, lines in (
                ("", ["cosim loop models", "models models", "machines machine_x loop z"]),
                ("cosim/CMakeLists.txt: loop may not link machine_x, which is of machines/",
                 ["machines machine_x", "cosim loop machine_x"]),
                ("lab/CMakeLists.txt: laboratory may not link program, which is of python/",
                 ["lab laboratory program", "python program"]),
                ("machines/CMakeLists.txt: a circle of links: chips -> model -> hooks -> chips",
                 ["machines chips model", "machines model hooks", "machines hooks chips"])):
            with self.subTest(told):
                text = "".join(f"{line}\n" for line in lines)
                self.assertEqual(self.findings(**{"build/links.txt": text}), [told][:len(told)])

    def test_the_form_of_a_file(self):
        long = "//" + 99 * "x"
        for text, told in (
                (LICENCE + "int a;", ":2: no newline at the end"),
                (LICENCE + "\tint a;\n", ":2: tab"),
                (LICENCE + "// caf\u00e9\n", ":2: not ASCII"),
                (LICENCE + long + "\n", ":2: 101 columns, more than 100"),
                (LICENCE + 400 * "\n", ": 401 lines, more than 400: two files"),
                ("int a;\n", ":1: no line SPDX-License-Identifier: Apache-2.0")):
            self.finds(f"models/fixed/word.hpp{told}", {"models/fixed/word.hpp": text})

    def test_a_file_may_be_as_long_and_as_wide_as_the_bounds(self):
        text = LICENCE + ("//" + 98 * "x" + "\n") * 399
        self.assertEqual(len(text.splitlines()), 400)
        self.assertEqual(self.findings(**{"models/fixed/word.hpp": text}), [])

    def test_what_others_wrote_is_exempt(self):
        self.assertEqual(self.findings(**{"third_party/x/x.hpp": "\tint a;",
                                          "sw_nios/generated/regs.hpp": "int a;",
                                          "out/run/x.cpp": "int a;\n", ".gitignore": "out\n"}), [])
