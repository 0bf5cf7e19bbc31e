// Generated from rtl/chips/kung_xy.rdl by scripts/tool gen-regs; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// What the registers of a verilated kung_xy hold: storage of the register block, and the signals
// that the hardware shows in the others.
#pragma once

#include <array>
#include <cstdint>

#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::kung_xy_regs {

template <class Root>
std::uint32_t read_ctrl_enable(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_enable_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_enable_value;
}

template <class Root>
std::uint32_t read_ctrl_current_loop(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_current_loop_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_current_loop_value;
}

template <class Root>
std::uint32_t read_ctrl_position_loop(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_position_loop_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_position_loop_value;
}

template <class Root>
std::uint32_t read_ctrl_adapt(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_adapt_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_adapt_value;
}

template <class Root>
std::uint32_t read_ctrl_reset_model(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_reset_model_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_reset_model_value;
}

template <class Root>
std::uint32_t read_ctrl_reset_table(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_reset_table_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_reset_table_value;
}

template <class Root>
std::uint32_t read_ctrl_interpolate(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_interpolate_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_interpolate_value;
}

template <class Root>
std::uint32_t read_ctrl_feedforward(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_feedforward_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_feedforward_value;
}

template <class Root>
std::uint32_t read_ctrl_precision(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_precision_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_precision_value;
}

template <class Root>
std::uint32_t read_status_busy(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__afc_busy
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__afc_busy;
}

template <class Root>
std::uint32_t read_status_overrun(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_overrun_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_overrun_value;
}

template <class Root>
std::uint32_t read_status_qep_error(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_qep_error_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_qep_error_value;
}

template <class Root>
std::uint32_t read_status_saturated(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_saturated_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_saturated_value;
}

template <class Root>
std::uint32_t read_status_limited(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_limited_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_limited_value;
}

template <class Root>
std::uint32_t read_status_underrun(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_underrun_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_underrun_value;
}

template <class Root>
std::uint32_t read_status_clipped(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_status_clipped_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_status_clipped_value;
}

template <class Root>
std::uint32_t read_status_step(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__step_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__step_q;
}

template <class Root>
std::uint32_t read_pos_cmd(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_pos_cmd_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_pos_cmd_value_value;
}

template <class Root>
std::uint32_t read_pos(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__x_p_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__x_p_q;
}

template <class Root>
std::uint32_t read_pos_model(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__x_r_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__x_r_q;
}

template <class Root>
std::uint32_t read_err(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__e_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__e_q;
}

template <class Root>
std::uint32_t read_derr(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__de_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__de_q;
}

template <class Root>
std::uint32_t read_u(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__u_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__u_q;
}

template <class Root>
std::uint32_t read_vstar(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__v_star_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__v_star_q;
}

template <class Root>
std::uint32_t read_iq_cmd(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__iq_ref
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__iq_ref;
}

template <class Root>
std::uint32_t read_speed(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_afc__DOT__v_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_afc__DOT__v_q;
}

template <class Root>
std::uint32_t read_id_iq_i_d(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_d_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_d_o;
}

template <class Root>
std::uint32_t read_id_iq_i_q(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_q_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_q_o;
}

template <class Root>
std::uint32_t read_vd_vq_v_d(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__v_d_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__v_d_o;
}

template <class Root>
std::uint32_t read_vd_vq_v_q(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__v_q_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__v_q_o;
}

template <class Root>
std::uint32_t read_kp_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kp_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kp_mant_value;
}

template <class Root>
std::uint32_t read_kp_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kp_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kp_exp_value;
}

template <class Root>
std::uint32_t read_ki_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ki_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ki_mant_value;
}

template <class Root>
std::uint32_t read_ki_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ki_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ki_exp_value;
}

template <class Root>
std::uint32_t read_kv_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kv_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kv_mant_value;
}

template <class Root>
std::uint32_t read_kv_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kv_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kv_exp_value;
}

template <class Root>
std::uint32_t read_eta_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_eta_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_eta_mant_value;
}

template <class Root>
std::uint32_t read_eta_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_eta_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_eta_exp_value;
}

template <class Root>
std::uint32_t read_shift_e(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_shift_e_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_shift_e_value;
}

template <class Root>
std::uint32_t read_shift_de(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_shift_de_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_shift_de_value;
}

template <class Root>
std::uint32_t read_a0_value(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_a0_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_a0_value_value;
}

template <class Root>
std::uint32_t read_a0_scale(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_a0_scale_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_a0_scale_value;
}

template <class Root>
std::uint32_t read_b2(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_b2_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_b2_value_value;
}

template <class Root>
std::uint32_t read_kp_cur_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kp_cur_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kp_cur_mant_value;
}

template <class Root>
std::uint32_t read_kp_cur_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_kp_cur_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_kp_cur_exp_value;
}

template <class Root>
std::uint32_t read_ki_cur_mant(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ki_cur_mant_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ki_cur_mant_value;
}

template <class Root>
std::uint32_t read_ki_cur_exp(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ki_cur_exp_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ki_cur_exp_value;
}

template <class Root>
std::uint32_t read_theta_ofs(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_theta_ofs_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_theta_ofs_value_value;
}

template <class Root>
std::uint32_t read_deadtime_clk(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_deadtime_clk_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_deadtime_clk_value;
}

template <class Root>
std::uint32_t read_deadtime_qep_filter(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_deadtime_qep_filter_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_deadtime_qep_filter_value;
}

template <class Root>
std::uint32_t read_tab_addr(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_tab_addr_index_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_tab_addr_index_value;
}

template <class Root>
std::uint32_t read_index_latch(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_qep__DOT__latch_q
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_qep__DOT__latch_q;
}

template <class Root>
std::uint32_t read_stroke_min(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_stroke_min_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_stroke_min_value_value;
}

template <class Root>
std::uint32_t read_stroke_max(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_stroke_max_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_stroke_max_value_value;
}

template <class Root>
std::uint32_t read_stroke_en(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_stroke_en_enable_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_stroke_en_enable_value;
}

template <class Root>
std::uint32_t read_iq_manual(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_iq_manual_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_iq_manual_value_value;
}

template <class Root>
std::uint32_t read_prec_addr(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_prec_addr_word_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_prec_addr_word_value;
}

template <class Root>
std::uint32_t read_angle_step(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_angle_step_value_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_angle_step_value_value;
}

template <class Root>
std::uint32_t read_current_offset_a(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_current_offset_a_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_current_offset_a_value;
}

template <class Root>
std::uint32_t read_current_offset_b(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_current_offset_b_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_current_offset_b_value;
}

template <class Root>
std::uint32_t read_phase_currents_i_a(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_a_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_a_o;
}

template <class Root>
std::uint32_t read_phase_currents_i_b(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_b_o
         : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__u_current_loop__DOT__i_b_o;
}

template <class Root>
std::uint32_t read_adc_frame(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_adc_frame_zeros_value
         : root.kung_xy__DOT__u_regs__DOT__field_storage_y_adc_frame_zeros_value;
}

template <class Root>
std::uint32_t read_irq_en_tick(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_irq_en_tick_value;
}

template <class Root>
std::uint32_t read_irq_en_fault(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_irq_en_fault_value;
}

template <class Root>
std::uint32_t read_irq_stat_tick(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_irq_stat_tick_value;
}

template <class Root>
std::uint32_t read_irq_stat_fault(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_irq_stat_fault_value;
}

template <class Root>
std::uint32_t read_tick(const Root& root, int) {
  return root.kung_xy__DOT__tick_count;
}

template <class Root>
std::uint32_t read_fault_code(const Root& root, int) {
  return root.kung_xy__DOT__u_supervisor__DOT__code_q;
}

template <class Root>
std::uint32_t read_fault_axis(const Root& root, int) {
  return root.kung_xy__DOT__u_supervisor__DOT__axis_q;
}

template <class Root>
std::uint32_t read_fault_tick(const Root& root, int) {
  return root.kung_xy__DOT__u_supervisor__DOT__tick_q;
}

template <class Root>
std::uint32_t read_watchdog(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_watchdog_limit_value;
}

template <class Root>
std::uint32_t read_lock(const Root& root, int) {
  return root.kung_xy__DOT__locked_q;
}

template <class Root>
std::uint32_t read_current_limit(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_current_limit_value_value;
}

template <class Root>
std::uint32_t read_deadtime_min(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_deadtime_min_clk_value;
}

template <class Root>
std::uint32_t read_irq_period(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_irq_period_ticks_value;
}

template <class Root>
std::uint32_t read_rates_carrier(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_rates_carrier_value;
}

template <class Root>
std::uint32_t read_rates_position(const Root& root, int) {
  return root.kung_xy__DOT__u_regs__DOT__field_storage_rates_position_value;
}

template <class Root>
std::uint32_t read_ctrl(const Root& root, int axis) {
  return (read_ctrl_enable(root, axis) & 0x1u) << 0 |
         (read_ctrl_current_loop(root, axis) & 0x1u) << 1 |
         (read_ctrl_position_loop(root, axis) & 0x1u) << 2 |
         (read_ctrl_adapt(root, axis) & 0x1u) << 3 |
         (read_ctrl_reset_model(root, axis) & 0x1u) << 4 |
         (read_ctrl_reset_table(root, axis) & 0x1u) << 5 |
         (read_ctrl_interpolate(root, axis) & 0x1u) << 6 |
         (read_ctrl_feedforward(root, axis) & 0x1u) << 7 |
         (read_ctrl_precision(root, axis) & 0x1u) << 8;
}

template <class Root>
std::uint32_t read_status(const Root& root, int axis) {
  return (read_status_busy(root, axis) & 0x1u) << 0 |
         (read_status_overrun(root, axis) & 0x1u) << 1 |
         (read_status_qep_error(root, axis) & 0x1u) << 2 |
         (read_status_saturated(root, axis) & 0x1u) << 3 |
         (read_status_limited(root, axis) & 0x1u) << 4 |
         (read_status_underrun(root, axis) & 0x1u) << 5 |
         (read_status_clipped(root, axis) & 0x1u) << 6 |
         (read_status_step(root, axis) & 0x7Fu) << 8;
}

template <class Root>
std::uint32_t read_fault(const Root& root, int) {
  return (read_fault_code(root, 0) & 0xFu) << 0 |
         (read_fault_axis(root, 0) & 0x1u) << 4 |
         (read_fault_tick(root, 0) & 0xFFFFFFu) << 8;
}

// What a trigger may name, and its bits.
template <class Root>
struct Reading {
  const Field& field;
  std::uint32_t (*read)(const Root& root, int axis);
};

template <class Root>
inline constexpr std::array<Reading<Root>, 77> kReadings{{
    {kWords[0], read_ctrl<Root>},
    {kFields[0], read_ctrl_enable<Root>},
    {kFields[1], read_ctrl_current_loop<Root>},
    {kFields[2], read_ctrl_position_loop<Root>},
    {kFields[3], read_ctrl_adapt<Root>},
    {kFields[4], read_ctrl_reset_model<Root>},
    {kFields[5], read_ctrl_reset_table<Root>},
    {kFields[8], read_ctrl_precision<Root>},
    {kWords[1], read_status<Root>},
    {kFields[9], read_status_busy<Root>},
    {kFields[10], read_status_overrun<Root>},
    {kFields[11], read_status_qep_error<Root>},
    {kFields[12], read_status_saturated<Root>},
    {kFields[13], read_status_limited<Root>},
    {kFields[14], read_status_underrun<Root>},
    {kFields[15], read_status_clipped<Root>},
    {kFields[16], read_status_step<Root>},
    {kFields[17], read_pos_cmd<Root>},
    {kFields[18], read_pos<Root>},
    {kFields[19], read_pos_model<Root>},
    {kFields[20], read_err<Root>},
    {kFields[21], read_derr<Root>},
    {kFields[22], read_u<Root>},
    {kFields[23], read_vstar<Root>},
    {kFields[24], read_iq_cmd<Root>},
    {kFields[25], read_speed<Root>},
    {kFields[26], read_id_iq_i_d<Root>},
    {kFields[27], read_id_iq_i_q<Root>},
    {kFields[28], read_vd_vq_v_d<Root>},
    {kFields[29], read_vd_vq_v_q<Root>},
    {kFields[30], read_kp_mant<Root>},
    {kFields[31], read_kp_exp<Root>},
    {kFields[32], read_ki_mant<Root>},
    {kFields[33], read_ki_exp<Root>},
    {kFields[34], read_kv_mant<Root>},
    {kFields[35], read_kv_exp<Root>},
    {kFields[36], read_eta_mant<Root>},
    {kFields[37], read_eta_exp<Root>},
    {kFields[38], read_shift_e<Root>},
    {kFields[39], read_shift_de<Root>},
    {kFields[40], read_a0_value<Root>},
    {kFields[42], read_b2<Root>},
    {kFields[43], read_kp_cur_mant<Root>},
    {kFields[44], read_kp_cur_exp<Root>},
    {kFields[45], read_ki_cur_mant<Root>},
    {kFields[46], read_ki_cur_exp<Root>},
    {kFields[47], read_theta_ofs<Root>},
    {kFields[48], read_deadtime_clk<Root>},
    {kFields[49], read_deadtime_qep_filter<Root>},
    {kFields[50], read_tab_addr<Root>},
    {kFields[53], read_index_latch<Root>},
    {kFields[54], read_stroke_min<Root>},
    {kFields[55], read_stroke_max<Root>},
    {kFields[56], read_stroke_en<Root>},
    {kFields[57], read_iq_manual<Root>},
    {kFields[58], read_prec_addr<Root>},
    {kFields[64], read_angle_step<Root>},
    {kFields[65], read_current_offset_a<Root>},
    {kFields[66], read_current_offset_b<Root>},
    {kFields[67], read_phase_currents_i_a<Root>},
    {kFields[68], read_phase_currents_i_b<Root>},
    {kFields[69], read_adc_frame<Root>},
    {kFields[73], read_irq_en_tick<Root>},
    {kFields[74], read_irq_en_fault<Root>},
    {kFields[75], read_irq_stat_tick<Root>},
    {kFields[76], read_irq_stat_fault<Root>},
    {kFields[77], read_tick<Root>},
    {kWords[2], read_fault<Root>},
    {kFields[78], read_fault_code<Root>},
    {kFields[79], read_fault_axis<Root>},
    {kFields[82], read_watchdog<Root>},
    {kFields[83], read_lock<Root>},
    {kFields[84], read_current_limit<Root>},
    {kFields[85], read_deadtime_min<Root>},
    {kFields[86], read_irq_period<Root>},
    {kFields[88], read_rates_carrier<Root>},
    {kFields[89], read_rates_position<Root>},
}};

}  // namespace trammel::kung_xy_regs
