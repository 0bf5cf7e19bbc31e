# SPDX-License-Identifier: Apache-2.0
"""What is written of a model for the scheduler: its domains, triggers, clocks and registers."""

from scratch import Scratch, call
from trammel_tools.generate import gen_model_state, model_regions

HEADER = """    VL_IN8(clock_en_i,4,0);
    VlTriggerVec<3> __VicoTriggered;
    VlTriggerVec<3> __VactTriggered;
    VlTriggerVec<3> __VnbaTriggered;
"""
CODE = """void Vc___eval_triggers__act(Vc* vlSelf) {
    // Body
    look();
}
void Vc___eval_ico(Vc* vlSelf) {
    // Body
    move();
}
void Vc___eval_nba(Vc* vlSelf) {
    // Body
    if (vlSelf->__VnbaTriggered.at(2U)) {
        Vc___nba_sequent__TOP__0(vlSelf);
    }
}
void Vc___nba_sequent__TOP__0(Vc* vlSelf) {
    // Body
    vlSelf->sum_q = vlSelf->c_d;
}
    VL_DBG_MSGF("'act' region trigger index 0 is active: @(posedge clk_i)");
    VL_DBG_MSGF("'act' region trigger index 1 is active: @(posedge u_gate.clk_o)");
    VL_DBG_MSGF("'nba' region trigger index 1 is active: @(posedge u_gate.clk_o)");
    VL_DBG_MSGF("'act' region trigger index 2 is active: @(posedge u_other.clk_o)");
"""


class RegionsTest(Scratch):
    def regions(self, header=HEADER, code=CODE):
        self.write("Vc.cpp", code)
        return model_regions.regions(self.write("Vc.h", header), lambda member: True)

    def test_a_model_has_a_domain_for_each_bit_and_a_trigger_for_each_clock(self):
        text = self.regions()
        for line in ("struct Regions<Vc> {", "kDomains = 5;", "kTriggers = 3;",
                     "root.__VicoTriggered.at(0) = true;", "Vc___eval_triggers__act(&root);",
                     "static void registers(Root& root) { Vc___eval_nba(&root); }",
                     "    if constexpr ((kRisen & 0x4u) != 0) Vc___nba_sequent__TOP__0(&root);"):
            self.assertIn(line, text)
        for name in ("eval_triggers__act", "eval_ico", "eval_nba", "nba_sequent__TOP__0"):
            self.assertEqual(text.count(f"void Vc___{name}(Vc* root);"), 1, name)

    def test_the_flags_of_a_later_verilator_are_words(self):
        later = HEADER.replace("VlTriggerVec<3>", "VlUnpacked<QData/*63:0*/, 1>")
        text = self.regions(later, CODE.replace("eval_triggers__act", "eval_triggers_vec__act"))
        self.assertIn("root.__VicoTriggered[0] |= 1;", text)
        self.assertIn("Vc___eval_triggers_vec__act(&root);", text)
        self.assertEqual(self.regions(later), "")

    def test_a_region_that_is_not_understood_is_called_as_a_whole(self):
        text = self.regions(code=CODE.replace("vlSelf->__VnbaTriggered.at(2U)", "vlSelf->c_d"))
        self.assertIn("static void registers(Root& root)", text)
        self.assertNotIn("registers_of", text)

    def test_a_model_without_domains_or_with_a_loop_has_no_regions(self):
        self.assertEqual(self.regions(HEADER.replace("clock_en_i", "other_i")), "")
        self.assertEqual(self.regions(HEADER.replace("__VactTriggered", "__Vgone")), "")
        self.assertEqual(self.regions(code=CODE.replace("Vc___eval_ico(", "Vc___gone(")), "")
        for other in ("negedge u_other", "[hybrid] u_other"):
            self.assertEqual(self.regions(code=CODE.replace("posedge u_other", other)), "")


class ClocksTest(Scratch):
    def test_clocks_that_a_model_stores_fall_but_no_expression(self):
        clocks = ("    CData/*0:0*/ __Vtrigrprev__TOP__clk_i;\n"
                  "    CData/*0:0*/ __Vtrigprev__TOP__c__DOT__gated_clk;\n")
        other = "    CData/*0:0*/ __Vtrigrprev__TOP__c__DOT__clkless;\n"
        path = self.write("Vc.h", clocks + other)
        text = gen_model_state.stored_clocks(path)
        self.assertIn("struct StoredClocks<Vc> {", text)
        self.assertIn("#include <Vc.h>", text)
        self.assertEqual([line.strip() for line in text.splitlines() if "= 0;" in line],
                         ["root.__Vtrigrprev__TOP__clk_i = 0;",
                          "root.__Vtrigprev__TOP__c__DOT__gated_clk = 0;"])
        for text in ("", other, clocks + "    CData/*0:0*/ __Vtrigprev_h12__0;\n"):
            self.assertEqual(gen_model_state.stored_clocks(self.write("Vc.h", text)), "")

    def test_a_register_is_visited_with_its_bits_and_inputs_come_first(self):
        header = self.write("Vc.h", "    VL_IN8(clk_i,0,0);\n    VL_IN8(rst_i,0,0);\n"
                            "    VL_OUT8(done_o,0,0);\n    SData/*11:0*/ chip__DOT__a_q;\n"
                            "    QData/*47:8*/ chip__DOT__b_q;\n")
        source = self.write("chip.sv", "a_q <= 1;\nb_q <= 2;\ndone_o <= 3;\n")
        out = self.folder / "chip-saw_state.hpp"
        self.assertEqual(call(gen_model_state.main, out, header, source)[0], 0)
        lines = [line.strip() for line in out.read_text().splitlines()]
        self.assertIn("struct ChipSawState {", lines)
        self.assertEqual([line for line in lines if line.startswith("visit(")], [
            'visit("rst_i", a.rst_i, b.rst_i);', 'visit("chip.a_q", a.chip__DOT__a_q, '
            'b.chip__DOT__a_q);', 'visit("chip.b_q", a.chip__DOT__b_q, b.chip__DOT__b_q);',
            'visit("done_o", a.done_o, b.done_o);', 'visit("chip.a_q", 12, root.chip__DOT__a_q);',
            'visit("chip.b_q", 40, root.chip__DOT__b_q);'])
