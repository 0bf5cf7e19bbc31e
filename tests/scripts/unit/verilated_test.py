# SPDX-License-Identifier: Apache-2.0
"""What is read out of the C++ that Verilator writes: registers, inputs, what a dump depends on."""

import os
from unittest.mock import patch

from scratch import Scratch, call
from trammel_tools.generate import gen_model_state, gen_wave_timers, model_regions
from trammel_tools.rtl import hierarchy

RTL = """module chip;  // old <= new
  always_ff @(posedge clk_i) begin
    count_q <= count_d;
    {sum_q, carry_q} <= a + b;
    memory[address] <= word; if (x <= y) flag_q <= 1;
  end
endmodule
"""
ROOT = """
    VL_IN8(clk_i,0,0);
    VL_IN8(rst_i,0,0);
    VL_INW(word_i,95,0,3);
    VL_OUT8(done_o,0,0);
    CData/*0:0*/ chip__DOT__flag_q;
    SData/*11:0*/ chip__DOT__u_a__DOT__count_q;
    IData/*31:0*/ chip__DOT__u_a__DOT__count_d;
    QData/*47:0*/ chip__DOT__gen_axis__BRA__1__KET____DOT__sum_q;
    CData/*0:0*/ __Vdly__chip__DOT__flag_q;
    VlUnpacked<SData/*15:0*/, 64> chip__DOT__memory;
"""
REGION = """void Vc___eval_nba(Vc* vlSelf) {
    if (false && vlSelf) {}  // Prevent unused
    // Body
    if (vlSelf->__VnbaTriggered.at(0U)) {
        Vc___nba_sequent__TOP__0(vlSelf);
    }
    if (vlSelf->__VnbaTriggered.at(0xaU)) {
        Vc___nba_sequent__TOP__1(vlSelf);
    }
    if ((vlSelf->__VnbaTriggered.at(0U) | vlSelf->__VnbaTriggered.at(0xaU))) {
        Vc___nba_comb__TOP__0(vlSelf);
    }
}
VL_INLINE_OPT void Vc___nba_sequent__TOP__0(Vc* vlSelf) {
    // Body
    vlSelf->tick_q = ((IData)(vlSelf->a_d) == (IData)(vlSelf->b_d));
    vlSelf->many_q[3U] = 1U;
}
VL_INLINE_OPT void Vc___nba_sequent__TOP__1(Vc* vlSelf) {
    // Body
    vlSelf->sum_q = vlSelf->c_d;
}
VL_INLINE_OPT void Vc___nba_comb__TOP__0(Vc* vlSelf) {
    // Body
    vlSelf->y_d = ((IData)(vlSelf->tick_q) + vlSelf->sum_q + vlSelf->b_d);
}
"""
REGION_MEMBERS = """
    CData/*0:0*/ tick_q;
    IData/*31:0*/ sum_q;
    VlUnpacked<CData/*7:0*/, 4> many_q;
"""
DUMP = """void Vchip___024root__trace_chg_sub_0(Vchip___024root* vlSelf, Buffer* bufp) {
    uint32_t* const oldp = bufp->oldp(vlSymsp->__Vm_baseCode + 7);
    VlWide<3>/*95:0*/ __Vtemp_1;
    // Body
    if (VL_UNLIKELY(vlSelf->__Vm_traceActivity[0U])) {
        bufp->chgBit(oldp+0,(vlSelf->chip__DOT__flag_q));
    }
    __Vtemp_1[0U] = vlSelf->chip__DOT__wide[0U];
    bufp->chgWData(oldp+1,(__Vtemp_1),96);
    bufp->chgBit(oldp+4,(vlSelf->clk_i));
}
"""


class GenRegistersTest(Scratch):
    def test_a_register_is_what_the_rtl_assigns_with_an_arrow(self):
        assigned = gen_model_state.assigned_names(
            "".join(hierarchy.modules("chip", [self.write("chip.sv", RTL)]).values()))
        self.assertLessEqual({"count_q", "sum_q", "carry_q", "memory", "flag_q"}, assigned)
        self.assertNotIn("count_d", assigned)
        self.assertNotIn("old", assigned)
        self.assertEqual(gen_model_state.registers(ROOT, assigned), [
            "chip__DOT__flag_q", "chip__DOT__u_a__DOT__count_q",
            "chip__DOT__gen_axis__BRA__1__KET____DOT__sum_q", "chip__DOT__memory"])

    def test_an_output_that_the_rtl_assigns_with_an_arrow_is_a_register(self):
        self.assertEqual(gen_model_state.outputs(ROOT, {"done_o", "count_q"}), ["done_o"])
        self.assertEqual(gen_model_state.outputs(ROOT, {"count_q"}), [])

    def test_inputs_are_all_but_the_clock(self):
        self.assertEqual(gen_model_state.inputs(ROOT), ["rst_i", "word_i"])
        self.assertEqual(gen_model_state.inputs("VL_IN8(clk,0,0);\nVL_IN8(rst,0,0);"), ["rst"])

    def test_modules_of_other_chips_are_not_looked_at(self):
        inside = hierarchy.modules("chip", [
            self.write("chip.sv", "module chip;\n  part #(\n    .N(1)\n  ) u_part (.x(y));\n"
                                  "  leaf u_leaf (.*);  // other u_other (\nendmodule\n"),
            self.write("part.sv", "module part;\nendmodule\n"),
            self.write("leaf.sv", "module leaf;\nendmodule\n"),
            self.write("other.sv", "module other;\nendmodule\n")])
        self.assertEqual(sorted(inside), ["chip", "leaf", "part"])

    def test_a_member_is_read_as_its_name_in_the_rtl(self):
        self.assertEqual(
            gen_model_state.readable("chip__DOT__gen_axis__BRA__1__KET____DOT__sum_q"),
            "chip.gen_axis[1].sum_q")

    def run_on(self, *members, alone=False):
        """Exit code and complaint of models with two registers, and the second with these too."""
        rtl = self.write("chip.sv", "".join(f"r{n}_q <= 0;\n" for n in range(60)))
        kept = "".join(f"    CData/*0:0*/ chip__DOT__r{n}_q;\n" for n in (7, 8))
        models = [self.write("first.h", kept)]
        more = "".join(f"    CData/*0:0*/ {member};\n" for member in members)
        if not alone:
            models.append(self.write("second.h", f"{kept}{more}CData __Vtrigrprev__TOP__clk_i;\n"))
        code, _, err = call(gen_model_state.main, self.folder / "chip_state.hpp", *models, rtl)
        return code, err

    def test_a_model_has_its_registers_in_a_header_and_others_add_their_clocks_alone(self):
        header = self.folder / "chip_state.hpp"
        self.assertEqual(self.run_on(alone=True), (0, ""))
        self.assertIn("struct ChipState {", header.read_text())
        self.assertIn('    visit("chip.r7_q", a.chip__DOT__r7_q, b.chip__DOT__r7_q);\n',
                      header.read_text())
        os.utime(header, (1, 1))
        self.run_on(alone=True)  # the same text: nothing is compiled again
        self.assertEqual(header.stat().st_mtime, 1)
        self.assertEqual(self.run_on(), (0, ""))
        self.assertIn("struct StoredClocks<second> {", header.read_text())
        self.assertNotIn("ChipState", header.read_text())

    def test_a_register_that_only_another_model_has_is_refused(self):
        self.assertEqual(self.run_on("chip__DOT__u_x_props__DOT__r55_q"), (0, ""))
        code, err = self.run_on("chip__DOT__r55_q")
        self.assertEqual(code, 1)
        self.assertIn("name them in public.vlt: chip.r55_q\n", err)

    def test_a_model_without_a_register_is_refused(self):
        code, _, err = call(gen_model_state.main, self.folder / "chip_state.hpp",
                            self.write("first.h", "    CData/*0:0*/ chip__DOT__r7_q;\n"),
                            self.write("chip.sv", "assign r7_q = 0;\n"))
        self.assertEqual(code, 1)
        self.assertIn("no register in ", err)


class ModelRegionsTest(Scratch):
    CALLED = [(1, "Vc___nba_sequent__TOP__0"), (1 << 10, "Vc___nba_sequent__TOP__1"),
              (1 | 1 << 10, "Vc___nba_comb__TOP__0")]

    def guards(self, code, members=REGION_MEMBERS, long=0):
        with patch.object(model_regions, "LONG", long):
            return model_regions.guards(self.CALLED, code, "Vc", members,
                                        lambda member: member.endswith("_q"))

    def test_the_region_of_the_registers_is_read_as_calls_by_clock(self):
        self.assertEqual(model_regions.calls(REGION, "Vc"), self.CALLED)
        self.assertEqual(model_regions.risen(
            "(0x0000000000000021ULL & vlSelfRef.__VnbaTriggered[0U])"), 0x21)

    def test_a_region_that_does_anything_else_is_not_known(self):
        for other in (REGION.replace("Vc___nba_sequent__TOP__1(vlSelf);", "vlSelf->sum_q = 1;"),
                      REGION.replace(".at(0xaU))", ".at(0xaU) & vlSelf->enable)"),
                      REGION.replace("(vlSelf->__VnbaTriggered.at(0U))", "(vlSelf->tick_q)"),
                      REGION.replace("    vlSelf->many_q", "    vlSelf->__VnbaTriggered"),
                      REGION.replace("void Vc___nba_comb__TOP__0(", "void Vc___gone(")):
            self.assertNotEqual(other, REGION)
            self.assertIsNone(model_regions.calls(other, "Vc"))

    def test_logic_is_guarded_by_those_of_its_inputs_that_the_clock_writes(self):
        self.assertEqual(self.guards(REGION),
                         {"Vc___nba_comb__TOP__0": {0: ["tick_q"], 10: ["sum_q"]}})
        self.assertEqual(self.guards(REGION, long=10_000), {})

    def test_what_a_clock_writes_in_an_unknown_way_counts_as_written(self):
        called = REGION.replace("vlSelf->sum_q = vlSelf->c_d;",
                                "Vc_TOP__task(vlSelf->sum_q, vlSelf->b_d);")
        members = REGION_MEMBERS + "    CData/*0:0*/ b_d;\n"
        self.assertEqual(self.guards(called, members)["Vc___nba_comb__TOP__0"][10],
                         ["b_d", "sum_q"])

    def test_a_memory_among_the_inputs_is_no_guard(self):
        read = REGION.replace("vlSelf->b_d);\n}\n", "vlSelf->many_q[1U]);\n}\n")
        self.assertEqual(self.guards(read), {"Vc___nba_comb__TOP__0": {10: ["sum_q"]}})

    def test_logic_with_a_register_of_its_own_is_always_called(self):
        self.assertEqual(self.guards(REGION.replace("y_d", "y_q")), {})

    def test_an_input_that_another_clock_writes_is_no_guard(self):
        reads = REGION.replace("vlSelf->y_d = (", "vlSelf->y_d = (vlSelf->free_d + ")
        self.assertIn("Vc___nba_comb__TOP__0", self.guards(reads))
        called = [*self.CALLED[:2], (1, "Vc___nba_comb__TOP__0")]
        with patch.object(model_regions, "LONG", 0):
            self.assertEqual(model_regions.guards(called, reads, "Vc", REGION_MEMBERS,
                                                  lambda member: member.endswith("_q")), {})

    def test_the_code_compares_before_it_calls(self):
        lines = model_regions.registers_of(
            self.CALLED, {"Vc___nba_comb__TOP__0": {0: ["tick_q"]}})
        self.assertEqual(lines.splitlines(), [
            "    [[maybe_unused]] const auto was_0 = root.tick_q;",
            "    if constexpr ((kRisen & 0x1u) != 0) Vc___nba_sequent__TOP__0(&root);",
            "    if constexpr ((kRisen & 0x400u) != 0) Vc___nba_sequent__TOP__1(&root);",
            "    if constexpr ((kRisen & 0x400u) != 0) {",
            "      Vc___nba_comb__TOP__0(&root);",
            "    } else if constexpr ((kRisen & 0x401u) != 0) {",
            "      if (((kRisen & 0x1u) != 0 && root.tick_q != was_0)) "
            "Vc___nba_comb__TOP__0(&root);",
            "    }"])


class GenWaveTimersTest(Scratch):
    def test_a_dump_is_divided_into_its_statements_with_what_they_compute(self):
        root, first, declared, found = gen_wave_timers.divide(DUMP)
        self.assertEqual((root, first, declared), ("Vchip___024root", "7",
                                                   {"__Vtemp_1": "VlWide<3>"}))
        self.assertEqual(found, [
            "bufp->chgBit(oldp+0,(vlSelf->chip__DOT__flag_q));",
            "__Vtemp_1[0U] = vlSelf->chip__DOT__wide[0U];\n"
            "bufp->chgWData(oldp+1,(__Vtemp_1),96);",
            "bufp->chgBit(oldp+4,(vlSelf->clk_i));"])

    def test_a_dump_that_is_not_understood_is_refused(self):
        for old, new, told in (("    bufp->chgBit(oldp+4", "    other(1);\n    bufp->chgBit(oldp+4",
                                "not understood: other"),
                               ("__Vtemp_1),96", "__Vtemp_2),96", "depends on more than members"),
                               ("}\n", "}\nvoid V__trace_chg_sub_1();\n", "more than one part")):
            with self.subTest(told), self.assertRaisesRegex(ValueError, told):
                gen_wave_timers.divide(DUMP.replace(old, new, 1))

    def test_timers_move_and_other_registers_do_not(self):
        for name, moves in (("clk_i", True), ("clk", True), ("next_o", True), ("u_next_o", True),
                            ("chip__DOT__u_pwm__DOT__phase", True),
                            ("chip__DOT__u_t__DOT__u_period__DOT__count_q", True),
                            ("chip__DOT__u_t__DOT__u_other__DOT__count_q", False),
                            ("chip__DOT__flag_q", False)):
            self.assertEqual(bool(gen_wave_timers.MOVING.fullmatch(name)), moves, name)
