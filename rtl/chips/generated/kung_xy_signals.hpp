// Generated from rtl/chips/kung_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// What the registers of a verilated kung_xy hold: storage of the register block, and the signals
// that the hardware shows in the others.
#pragma once

#include <array>
#include <cstdint>

#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::kung_xy_regs {

// A signal of the chip and a field of the register block, each also of an axis.
#define TRAMMEL_HELD(path) root.kung_xy__DOT__##path
#define TRAMMEL_STORED(path) root.kung_xy__DOT__u_regs__DOT__field_storage_##path##_value
#define TRAMMEL_HELD_OF_AXIS(path) \
  (axis == 0 ? TRAMMEL_HELD(gen_axis__BRA__0__KET____DOT__u_axis__DOT__##path) \
             : TRAMMEL_HELD(gen_axis__BRA__1__KET____DOT__u_axis__DOT__##path))
#define TRAMMEL_STORED_OF_AXIS(path) \
  (axis == 0 ? TRAMMEL_STORED(x_##path) : TRAMMEL_STORED(y_##path))
#define TRAMMEL_READ(value) \
  [](const Root& root, [[maybe_unused]] int axis) -> std::uint32_t { return value; }

// What a trigger may name, and its bits.
template <class Root>
struct Reading {
  const Field& field;
  std::uint32_t (*read)(const Root& root, int axis);
};

template <class Root>
inline constexpr std::array<Reading<Root>, 77> kReadings{{
    {kWords[0], TRAMMEL_READ((TRAMMEL_STORED_OF_AXIS(ctrl_enable) & 0x1u) << 0 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_current_loop) & 0x1u) << 1 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_position_loop) & 0x1u) << 2 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_adapt) & 0x1u) << 3 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_reset_model) & 0x1u) << 4 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_reset_table) & 0x1u) << 5 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_interpolate) & 0x1u) << 6 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_feedforward) & 0x1u) << 7 |
                     (TRAMMEL_STORED_OF_AXIS(ctrl_precision) & 0x1u) << 8)},
    {kFields[0], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_enable))},
    {kFields[1], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_current_loop))},
    {kFields[2], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_position_loop))},
    {kFields[3], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_adapt))},
    {kFields[4], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_reset_model))},
    {kFields[5], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_reset_table))},
    {kFields[8], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ctrl_precision))},
    {kWords[1], TRAMMEL_READ((TRAMMEL_HELD_OF_AXIS(afc_busy) & 0x1u) << 0 |
                     (TRAMMEL_STORED_OF_AXIS(status_overrun) & 0x1u) << 1 |
                     (TRAMMEL_STORED_OF_AXIS(status_qep_error) & 0x1u) << 2 |
                     (TRAMMEL_STORED_OF_AXIS(status_saturated) & 0x1u) << 3 |
                     (TRAMMEL_STORED_OF_AXIS(status_limited) & 0x1u) << 4 |
                     (TRAMMEL_STORED_OF_AXIS(status_underrun) & 0x1u) << 5 |
                     (TRAMMEL_STORED_OF_AXIS(status_clipped) & 0x1u) << 6 |
                     (TRAMMEL_HELD_OF_AXIS(u_afc__DOT__step_q) & 0x7Fu) << 8)},
    {kFields[9], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(afc_busy))},
    {kFields[10], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_overrun))},
    {kFields[11], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_qep_error))},
    {kFields[12], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_saturated))},
    {kFields[13], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_limited))},
    {kFields[14], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_underrun))},
    {kFields[15], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(status_clipped))},
    {kFields[16], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__step_q))},
    {kFields[17], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(pos_cmd_value))},
    {kFields[18], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(x_p_q))},
    {kFields[19], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__x_r_q))},
    {kFields[20], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__e_q))},
    {kFields[21], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__de_q))},
    {kFields[22], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__u_q))},
    {kFields[23], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__v_star_q))},
    {kFields[24], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(iq_ref))},
    {kFields[25], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_afc__DOT__v_q))},
    {kFields[26], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__i_d_o))},
    {kFields[27], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__i_q_o))},
    {kFields[28], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__v_d_o))},
    {kFields[29], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__v_q_o))},
    {kFields[30], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kp_mant))},
    {kFields[31], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kp_exp))},
    {kFields[32], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ki_mant))},
    {kFields[33], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ki_exp))},
    {kFields[34], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kv_mant))},
    {kFields[35], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kv_exp))},
    {kFields[36], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(eta_mant))},
    {kFields[37], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(eta_exp))},
    {kFields[38], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(shift_e))},
    {kFields[39], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(shift_de))},
    {kFields[40], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(a0_value))},
    {kFields[42], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(b2_value))},
    {kFields[43], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kp_cur_mant))},
    {kFields[44], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(kp_cur_exp))},
    {kFields[45], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ki_cur_mant))},
    {kFields[46], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(ki_cur_exp))},
    {kFields[47], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(theta_ofs_value))},
    {kFields[48], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(deadtime_clk))},
    {kFields[49], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(deadtime_qep_filter))},
    {kFields[50], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(tab_addr_index))},
    {kFields[53], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_qep__DOT__latch_q))},
    {kFields[54], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(stroke_min_value))},
    {kFields[55], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(stroke_max_value))},
    {kFields[56], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(stroke_en_enable))},
    {kFields[57], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(iq_manual_value))},
    {kFields[58], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(prec_addr_word))},
    {kFields[64], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(angle_step_value))},
    {kFields[65], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(current_offset_a))},
    {kFields[66], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(current_offset_b))},
    {kFields[67], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__i_a_o))},
    {kFields[68], TRAMMEL_READ(TRAMMEL_HELD_OF_AXIS(u_current_loop__DOT__i_b_o))},
    {kFields[69], TRAMMEL_READ(TRAMMEL_STORED_OF_AXIS(adc_frame_zeros))},
    {kFields[73], TRAMMEL_READ(TRAMMEL_STORED(irq_en_tick))},
    {kFields[74], TRAMMEL_READ(TRAMMEL_STORED(irq_en_fault))},
    {kFields[75], TRAMMEL_READ(TRAMMEL_STORED(irq_stat_tick))},
    {kFields[76], TRAMMEL_READ(TRAMMEL_STORED(irq_stat_fault))},
    {kFields[77], TRAMMEL_READ(TRAMMEL_HELD(tick_count))},
    {kWords[2], TRAMMEL_READ((TRAMMEL_HELD(u_supervisor__DOT__code_q) & 0xFu) << 0 |
                     (TRAMMEL_HELD(u_supervisor__DOT__axis_q) & 0x1u) << 4 |
                     (TRAMMEL_HELD(u_supervisor__DOT__tick_q) & 0xFFFFFFu) << 8)},
    {kFields[78], TRAMMEL_READ(TRAMMEL_HELD(u_supervisor__DOT__code_q))},
    {kFields[79], TRAMMEL_READ(TRAMMEL_HELD(u_supervisor__DOT__axis_q))},
    {kFields[82], TRAMMEL_READ(TRAMMEL_STORED(watchdog_limit))},
    {kFields[83], TRAMMEL_READ(TRAMMEL_HELD(locked_q))},
    {kFields[84], TRAMMEL_READ(TRAMMEL_STORED(current_limit_value))},
    {kFields[85], TRAMMEL_READ(TRAMMEL_STORED(deadtime_min_clk))},
    {kFields[86], TRAMMEL_READ(TRAMMEL_STORED(irq_period_ticks))},
    {kFields[88], TRAMMEL_READ(TRAMMEL_STORED(rates_carrier))},
    {kFields[89], TRAMMEL_READ(TRAMMEL_STORED(rates_position))},
}};

#undef TRAMMEL_READ
#undef TRAMMEL_STORED_OF_AXIS
#undef TRAMMEL_HELD_OF_AXIS
#undef TRAMMEL_STORED
#undef TRAMMEL_HELD

}  // namespace trammel::kung_xy_regs
