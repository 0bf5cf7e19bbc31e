// SPDX-License-Identifier: Apache-2.0
//
// Reads by name what a trigger may watch; the signals are those of public.vlt.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim/kung/chip.hpp"

namespace trammel::kung {

template <class Root>
struct SignalRow {
  Signal signal;
  std::int64_t (*read)(const Root& root, int axis);
};

// `bits` low bits of a value; two's complement when `is_signed`.
constexpr std::int64_t bits_of(std::uint64_t value, int bits, bool is_signed) {
  const std::uint64_t low = value & ((std::uint64_t{1} << bits) - 1);
  const bool negative = is_signed && ((low >> (bits - 1)) & 1u) != 0;
  return static_cast<std::int64_t>(low) - (negative ? std::int64_t{1} << bits : 0);
}

#define TRAMMEL_IN_AXIS(path)                                                       \
  (axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__##path \
             : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__##path)
#define TRAMMEL_STORED(field) root.kung_xy__DOT__u_regs__DOT__field_storage_##field##_value
#define TRAMMEL_STORED_AXIS(field) \
  (axis == 0 ? TRAMMEL_STORED(x_##field) : TRAMMEL_STORED(y_##field))
#define TRAMMEL_ROW(name, bits, is_signed, of_axis, value, help)                              \
  {                                                                                           \
    {name, help, bits, is_signed, of_axis}, [](const Root& root, [[maybe_unused]] int axis) { \
      return bits_of(static_cast<std::uint64_t>(value), bits, is_signed);                     \
    }                                                                                         \
  }

// Signed and unsigned values of an axis; plain names are the words of trace.csv and the block
// pages, upper-case ones the register map's.
#define TRAMMEL_S(name, bits, path, help) \
  TRAMMEL_ROW(name, bits, true, true, TRAMMEL_IN_AXIS(path), help)
#define TRAMMEL_U(name, bits, path, help) \
  TRAMMEL_ROW(name, bits, false, true, TRAMMEL_IN_AXIS(path), help)
#define TRAMMEL_FIELD(name, bits, is_signed, field, help) \
  TRAMMEL_ROW(name, bits, is_signed, true, TRAMMEL_STORED_AXIS(field), help)
#define TRAMMEL_SYSTEM(name, bits, value, help) TRAMMEL_ROW(name, bits, false, false, value, help)

template <class Root>
std::uint64_t ctrl_word(const Root& root, int axis) {
  return TRAMMEL_STORED_AXIS(ctrl_enable) | TRAMMEL_STORED_AXIS(ctrl_current_loop) << 1 |
         TRAMMEL_STORED_AXIS(ctrl_position_loop) << 2 | TRAMMEL_STORED_AXIS(ctrl_adapt) << 3 |
         TRAMMEL_STORED_AXIS(ctrl_reset_model) << 4 | TRAMMEL_STORED_AXIS(ctrl_reset_table) << 5 |
         TRAMMEL_STORED_AXIS(ctrl_interpolate) << 6 | TRAMMEL_STORED_AXIS(ctrl_feedforward) << 7;
}

template <class Root>
std::uint64_t status_word(const Root& root, int axis) {
  return TRAMMEL_IN_AXIS(afc_busy) | TRAMMEL_STORED_AXIS(status_overrun) << 1 |
         TRAMMEL_STORED_AXIS(status_qep_error) << 2 | TRAMMEL_STORED_AXIS(status_saturated) << 3 |
         TRAMMEL_STORED_AXIS(status_limited) << 4 | TRAMMEL_IN_AXIS(u_afc__DOT__step_q) << 8;
}

template <class Root>
std::uint64_t fault_word(const Root& root) {
  return root.kung_xy__DOT__u_supervisor__DOT__code_q |
         root.kung_xy__DOT__u_supervisor__DOT__axis_q << 4 |
         static_cast<std::uint64_t>(root.kung_xy__DOT__u_supervisor__DOT__tick_q) << 8;
}

template <class Root>
const std::vector<SignalRow<Root>>& signal_rows() {
  static const std::vector<SignalRow<Root>> rows{
      TRAMMEL_S("r", 24, u_afc__DOT__r_q, "command of the sample [count]"),
      TRAMMEL_S("x_p", 24, u_afc__DOT__x_p_q, "position of the sample [count]"),
      TRAMMEL_S("x_m", 32, u_afc__DOT__x_m_q, "model [count Q14]"),
      TRAMMEL_S("x_r", 24, u_afc__DOT__x_r_q, "model, rounded [count]"),
      TRAMMEL_S("dx", 24, u_afc__DOT__dx_q, "model increment [count Q14 a sample]"),
      TRAMMEL_S("e", 12, u_afc__DOT__e_q, "error to the model [count]"),
      TRAMMEL_S("de", 12, u_afc__DOT__de_q, "its change a sample [count]"),
      TRAMMEL_S("u", 12, u_afc__DOT__u_q, "fuzzy output [1/256 unit]"),
      TRAMMEL_S("v_star", 12, u_afc__DOT__v_star_q, "speed command [1/16 count a sample]"),
      TRAMMEL_S("v", 12, u_afc__DOT__v_q, "speed [1/16 count a sample]"),
      TRAMMEL_S("i_q_ref", 12, u_afc__DOT__i_q_ref_q, "current command [4.8 A / 2048]"),
      TRAMMEL_U("afc", 1, u_afc__DOT__running_q, "position controller in its 35 steps"),
      TRAMMEL_U("step", 6, u_afc__DOT__step_q, "its step, 0..34"),
      TRAMMEL_S("count", 24, u_qep__DOT__count_q, "encoder counter [count]"),
      TRAMMEL_U("code_a", 12, code_a, "converter, phase a; 2048 = 0 A"),
      TRAMMEL_U("code_b", 12, code_b, "converter, phase b; 2048 = 0 A"),
      TRAMMEL_S("i_a", 12, u_current_loop__DOT__i_a_o, "phase current [9.6 A / 2048]"),
      TRAMMEL_S("i_b", 12, u_current_loop__DOT__i_b_o, "phase current [9.6 A / 2048]"),
      TRAMMEL_S("i_d", 12, u_current_loop__DOT__i_d_o, "direct current [9.6 A / 2048]"),
      TRAMMEL_S("i_q", 12, u_current_loop__DOT__i_q_o, "quadrature current [9.6 A / 2048]"),
      TRAMMEL_S("v_d", 12, u_current_loop__DOT__v_d_o, "voltage [V_dc / sqrt 3 / 2048]"),
      TRAMMEL_S("v_q", 12, u_current_loop__DOT__v_q_o, "voltage [V_dc / sqrt 3 / 2048]"),
      TRAMMEL_U("cmp_a", 11, u_current_loop__DOT__cmp_a_o, "compare value of phase a, 0..1562"),
      TRAMMEL_U("cmp_b", 11, u_current_loop__DOT__cmp_b_o, "compare value of phase b, 0..1562"),
      TRAMMEL_U("cmp_c", 11, u_current_loop__DOT__cmp_c_o, "compare value of phase c, 0..1562"),
      TRAMMEL_ROW("gate_hi", 3, false, true, root.gate_hi_o >> (3 * axis), "upper gates c b a"),
      TRAMMEL_ROW("gate_lo", 3, false, true, root.gate_lo_o >> (3 * axis), "lower gates c b a"),
      TRAMMEL_ROW("CTRL", 8, false, true, ctrl_word(root, axis), "operating mode"),
      TRAMMEL_FIELD("CTRL.enable", 1, false, ctrl_enable, "inverter on"),
      TRAMMEL_FIELD("CTRL.current_loop", 1, false, ctrl_current_loop, "current loop closed"),
      TRAMMEL_FIELD("CTRL.position_loop", 1, false, ctrl_position_loop, "position loop closed"),
      TRAMMEL_FIELD("CTRL.adapt", 1, false, ctrl_adapt, "the rule table is tuned"),
      TRAMMEL_FIELD("CTRL.reset_model", 1, false, ctrl_reset_model, "model held in reset"),
      TRAMMEL_FIELD("CTRL.reset_table", 1, false, ctrl_reset_table, "rule table being reset"),
      TRAMMEL_ROW("STATUS", 15, false, true, status_word(root, axis), "step and sticky bits"),
      TRAMMEL_U("STATUS.busy", 1, afc_busy, "position controller or table reset running"),
      TRAMMEL_FIELD("STATUS.overrun", 1, false, status_overrun, "a tick came too early"),
      TRAMMEL_FIELD("STATUS.qep_error", 1, false, status_qep_error, "both encoder lines moved"),
      TRAMMEL_FIELD("STATUS.saturated", 1, false, status_saturated, "i_q* was saturated"),
      TRAMMEL_FIELD("STATUS.limited", 1, false, status_limited, "the voltage was limited"),
      TRAMMEL_U("STATUS.step", 7, u_afc__DOT__step_q, "step of the position controller"),
      TRAMMEL_FIELD("POS_CMD", 24, true, pos_cmd_value, "command, taken after COMMIT [count]"),
      TRAMMEL_S("POS", 24, x_p_q, "position at the 2 kHz tick [count]"),
      TRAMMEL_S("POS_MODEL", 24, u_afc__DOT__x_r_q, "x_r [count]"),
      TRAMMEL_S("ERR", 12, u_afc__DOT__e_q, "e [count]"),
      TRAMMEL_S("DERR", 12, u_afc__DOT__de_q, "de [count]"),
      TRAMMEL_S("U", 12, u_afc__DOT__u_q, "u [1/256 unit]"),
      TRAMMEL_S("VSTAR", 12, u_afc__DOT__v_star_q, "v* [1/16 count a sample]"),
      TRAMMEL_S("IQ_CMD", 12, iq_ref, "i_q* in effect [4.8 A / 2048]"),
      TRAMMEL_S("SPEED", 12, u_afc__DOT__v_q, "v [1/16 count a sample]"),
      TRAMMEL_S("ID_IQ.i_d", 12, u_current_loop__DOT__i_d_o, "i_d [9.6 A / 2048]"),
      TRAMMEL_S("ID_IQ.i_q", 12, u_current_loop__DOT__i_q_o, "i_q [9.6 A / 2048]"),
      TRAMMEL_S("VD_VQ.v_d", 12, u_current_loop__DOT__v_d_o, "v_d [V_dc / sqrt 3 / 2048]"),
      TRAMMEL_S("VD_VQ.v_q", 12, u_current_loop__DOT__v_q_o, "v_q [V_dc / sqrt 3 / 2048]"),
      TRAMMEL_FIELD("KP.mant", 11, false, kp_mant, "Kp: mantissa / 2048"),
      TRAMMEL_FIELD("KP.exp", 5, true, kp_exp, "Kp: exponent of 2"),
      TRAMMEL_FIELD("KI.mant", 11, false, ki_mant, "Ki: mantissa / 2048"),
      TRAMMEL_FIELD("KI.exp", 5, true, ki_exp, "Ki: exponent of 2"),
      TRAMMEL_FIELD("KV.mant", 11, false, kv_mant, "Kv: mantissa / 2048"),
      TRAMMEL_FIELD("KV.exp", 5, true, kv_exp, "Kv: exponent of 2"),
      TRAMMEL_FIELD("ETA.mant", 11, false, eta_mant, "eta: mantissa / 2048"),
      TRAMMEL_FIELD("ETA.exp", 5, true, eta_exp, "eta: exponent of 2"),
      TRAMMEL_FIELD("KP_CUR.mant", 11, false, kp_cur_mant, "Kp, currents: mantissa / 2048"),
      TRAMMEL_FIELD("KP_CUR.exp", 5, true, kp_cur_exp, "Kp, currents: exponent of 2"),
      TRAMMEL_FIELD("KI_CUR.mant", 11, false, ki_cur_mant, "Ki, currents: mantissa / 2048"),
      TRAMMEL_FIELD("KI_CUR.exp", 5, true, ki_cur_exp, "Ki, currents: exponent of 2"),
      TRAMMEL_FIELD("SHIFT.e", 4, false, shift_e, "shift of e to the universe"),
      TRAMMEL_FIELD("SHIFT.de", 4, false, shift_de, "shift of de to the universe"),
      TRAMMEL_FIELD("A0", 18, false, a0_value, "of the model, 2^-32"),
      TRAMMEL_FIELD("B2", 24, true, b2_value, "of the model, 2^-23"),
      TRAMMEL_FIELD("THETA_OFS", 32, false, theta_ofs_value, "electrical angle at count 0"),
      TRAMMEL_FIELD("DEADTIME.clk", 10, false, deadtime_clk, "dead time [clk]"),
      TRAMMEL_FIELD("DEADTIME.qep_filter", 4, false, deadtime_qep_filter, "encoder filter"),
      TRAMMEL_FIELD("STROKE_MIN", 24, true, stroke_min_value, "lower limit [count]"),
      TRAMMEL_FIELD("STROKE_MAX", 24, true, stroke_max_value, "upper limit [count]"),
      TRAMMEL_FIELD("STROKE_EN", 1, false, stroke_en_enable, "the stroke is watched"),
      TRAMMEL_FIELD("IQ_MANUAL", 12, true, iq_manual_value, "manual command [4.8 A / 2048]"),
      TRAMMEL_FIELD("TAB_ADDR", 6, false, tab_addr_index, "rule for outside access, 7 j + i"),
      TRAMMEL_S("INDEX_LATCH", 24, u_qep__DOT__latch_q, "count at the last index pulse"),
      TRAMMEL_SYSTEM("TICK", 32, root.kung_xy__DOT__tick_count, "2 kHz samples"),
      TRAMMEL_SYSTEM("FAULT", 32, fault_word(root), "first fault: code, axis, tick"),
      TRAMMEL_SYSTEM("FAULT.code", 4, root.kung_xy__DOT__u_supervisor__DOT__code_q,
                     "its cause, 1..5; 0 = none"),
      TRAMMEL_SYSTEM("FAULT.axis", 1, root.kung_xy__DOT__u_supervisor__DOT__axis_q, "0 X, 1 Y"),
      TRAMMEL_SYSTEM("IRQ_STAT.tick", 1, TRAMMEL_STORED(irq_stat_tick), "interrupt: ticks"),
      TRAMMEL_SYSTEM("IRQ_STAT.fault", 1, TRAMMEL_STORED(irq_stat_fault), "interrupt: fault"),
      TRAMMEL_SYSTEM("IRQ_EN.tick", 1, TRAMMEL_STORED(irq_en_tick), "interrupts by ticks"),
      TRAMMEL_SYSTEM("IRQ_EN.fault", 1, TRAMMEL_STORED(irq_en_fault), "interrupts by faults"),
      TRAMMEL_SYSTEM("IRQ_PERIOD", 8, TRAMMEL_STORED(irq_period_ticks), "ticks an interrupt"),
      TRAMMEL_SYSTEM("WATCHDOG", 16, TRAMMEL_STORED(watchdog_limit), "ticks to COMMIT; 0 = off"),
      TRAMMEL_SYSTEM("CURRENT_LIMIT", 12, TRAMMEL_STORED(current_limit_value), "trips; 0 = off"),
      TRAMMEL_SYSTEM("DEADTIME_MIN", 10, TRAMMEL_STORED(deadtime_min_clk), "least dead time [clk]"),
      TRAMMEL_SYSTEM("LOCK", 1, root.kung_xy__DOT__locked_q, "limits and dead times locked"),
      TRAMMEL_SYSTEM("irq", 1, root.irq_o, "interrupt line"),
      TRAMMEL_SYSTEM("trip", 1, root.trip_i, "trip pin"),
  };
  return rows;
}

#undef TRAMMEL_IN_AXIS
#undef TRAMMEL_STORED
#undef TRAMMEL_STORED_AXIS
#undef TRAMMEL_ROW
#undef TRAMMEL_S
#undef TRAMMEL_U
#undef TRAMMEL_FIELD
#undef TRAMMEL_SYSTEM

}  // namespace trammel::kung
