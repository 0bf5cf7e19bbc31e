// SPDX-License-Identifier: Apache-2.0
//
// Reads controller words out of a verilated chip; the signals are those of public.vlt.
// The names are Verilator's, so a macro joins them; `Root` is the model's root structure.
#pragma once

#include <cstdint>

#include "machines/kung/chip/chip.hpp"
#include "models/exact/control/precision.hpp"

namespace trammel::kung {

namespace probe {
constexpr std::int32_t word(std::uint32_t bits) {  // 12 bits, two's complement
  return static_cast<std::int32_t>(bits << 20) >> 20;
}
constexpr std::int32_t count(std::uint32_t bits) {  // 24 bits
  return static_cast<std::int32_t>(bits << 8) >> 8;
}
}  // namespace probe

#define TRAMMEL_AXIS(name)                                                \
  (axis == 0 ? root.kung_xy__DOT__gen_axis__BRA__0__KET____DOT__u_axis__DOT__##name \
             : root.kung_xy__DOT__gen_axis__BRA__1__KET____DOT__u_axis__DOT__##name)

template <class Root>
bool probe_precise(const Root& root, int axis) {
  return axis == 0 ? root.kung_xy__DOT__u_regs__DOT__field_storage_x_ctrl_precision_value
                   : root.kung_xy__DOT__u_regs__DOT__field_storage_y_ctrl_precision_value;
}

// A word of the precision controller, of 48 bits.
template <class Root>
std::int64_t probe_stored(const Root& root, int axis, exact::PrecisionStore::Word of) {
  const auto at = static_cast<std::size_t>(64 * axis + static_cast<int>(of));
  return fixed::wrap(
      static_cast<std::int64_t>(
          root.kung_xy__DOT__u_precision__DOT__u_precision__DOT__u_store__DOT__mem_q[at]),
      48);
}

template <class Root>
void probe_words(const Root& root, int axis, AxisSample& s) {
  using probe::count;
  using probe::word;
  s.r = count(TRAMMEL_AXIS(u_afc__DOT__r_q));
  s.x_p = count(TRAMMEL_AXIS(u_afc__DOT__x_p_q));
  s.x_m = static_cast<std::int32_t>(TRAMMEL_AXIS(u_afc__DOT__x_m_q));
  s.x_r = count(TRAMMEL_AXIS(u_afc__DOT__x_r_q));
  s.dx = count(TRAMMEL_AXIS(u_afc__DOT__dx_q));
  s.e = word(TRAMMEL_AXIS(u_afc__DOT__e_q));
  s.de = word(TRAMMEL_AXIS(u_afc__DOT__de_q));
  s.u = word(TRAMMEL_AXIS(u_afc__DOT__u_q));
  s.v_star = word(TRAMMEL_AXIS(u_afc__DOT__v_star_q));
  s.v = word(TRAMMEL_AXIS(u_afc__DOT__v_q));
  s.i_q_ref = word(TRAMMEL_AXIS(u_afc__DOT__i_q_ref_q));
  s.i_d = word(TRAMMEL_AXIS(u_current_loop__DOT__i_d_o));
  s.i_q = word(TRAMMEL_AXIS(u_current_loop__DOT__i_q_o));
  s.v_d = word(TRAMMEL_AXIS(u_current_loop__DOT__v_d_o));
  s.v_q = word(TRAMMEL_AXIS(u_current_loop__DOT__v_q_o));
  if (!probe_precise(root, axis)) return;
  s.x_p = count(TRAMMEL_AXIS(x_p_q));
  s.i_q_ref = word(TRAMMEL_AXIS(iq_position));
  using Word = exact::PrecisionStore::Word;
  const auto spline = fixed::wrap(fixed::rs(probe_stored(root, axis, Word::kSpline), 15), 32);
  show_precision(static_cast<std::int32_t>(spline),
                 static_cast<std::int32_t>(probe_stored(root, axis, Word::kV24)), s);
}

template <class Root>
AxisLaw probe_law(const Root& root, int axis) {
  if (!probe_precise(root, axis)) return {};
  using Word = exact::PrecisionStore::Word;
  const auto word = [&](Word of) {
    return static_cast<std::int32_t>(probe_stored(root, axis, of));
  };
  return {word(Word::kD),    word(Word::kAcc),
          word(Word::kAff),  word(Word::kVff),
          word(Word::kIacc), exact::Precision::gain(word(Word::kKmNow)),
          exact::Precision::gain(word(Word::kKbNow)), word(Word::kFcNow)};
}

template <class Root>
bool probe_busy(const Root& root, int axis) {
  return TRAMMEL_AXIS(u_current_loop__DOT__busy_o) != 0;
}

template <class Root>
CurrentWords probe_current(const Root& root, int axis) {
  using probe::word;
  CurrentWords c;
  c.code_a = TRAMMEL_AXIS(code_a);
  c.code_b = TRAMMEL_AXIS(code_b);
  c.count = probe::count(TRAMMEL_AXIS(count_cur_q));
  c.i_q_ref = word(TRAMMEL_AXIS(i_q_ref_q));
  c.cmp_a = TRAMMEL_AXIS(u_current_loop__DOT__cmp_a_o);
  c.cmp_b = TRAMMEL_AXIS(u_current_loop__DOT__cmp_b_o);
  c.cmp_c = TRAMMEL_AXIS(u_current_loop__DOT__cmp_c_o);
  c.i_d = word(TRAMMEL_AXIS(u_current_loop__DOT__i_d_o));
  c.i_q = word(TRAMMEL_AXIS(u_current_loop__DOT__i_q_o));
  c.v_d = word(TRAMMEL_AXIS(u_current_loop__DOT__v_d_o));
  c.v_q = word(TRAMMEL_AXIS(u_current_loop__DOT__v_q_o));
  c.busy = TRAMMEL_AXIS(u_current_loop__DOT__busy_o) != 0;
  c.clear = TRAMMEL_AXIS(loop_clear) != 0;
  return c;
}

// Integrator of v*, 1 LSB = v* LSB / 4096.
template <class Root>
std::int32_t probe_integral(const Root& root, int axis) {
  return probe::count(TRAMMEL_AXIS(u_afc__DOT__integral_q));
}

// Rule 7 j + i lies at {j, i}.
template <class Root>
std::int32_t probe_rule(const Root& root, int axis, int index) {
  const auto at = static_cast<std::size_t>(index / 7 * 8 + index % 7);
  return probe::count(TRAMMEL_AXIS(u_afc__DOT__u_rules__DOT__mem_q)[at]);
}

#undef TRAMMEL_AXIS

template <class Root>
Fault probe_fault(const Root& root) {
  return {static_cast<FaultCode>(root.kung_xy__DOT__u_supervisor__DOT__code_q),
          root.kung_xy__DOT__u_supervisor__DOT__axis_q,
          root.kung_xy__DOT__u_supervisor__DOT__tick_q};
}

}  // namespace trammel::kung
