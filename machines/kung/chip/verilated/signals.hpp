// SPDX-License-Identifier: Apache-2.0
//
// Reads by name what a trigger may watch: words of the controllers and pins, listed here, and the
// registers, whose list is that of the register map. The signals are those of public.vlt.
#pragma once

#include <cstdint>
#include <vector>

#include "machines/kung/chip/chip.hpp"
#include "rtl/chips/generated/kung_xy_signals.hpp"

namespace trammel::kung {

using cosim::Word;

template <class Root>
struct SignalRow {
  Signal signal;
  std::uint32_t (*read)(const Root& root, int axis);
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
#define TRAMMEL_ROW(word, of_axis, value)                                                   \
  {                                                                                         \
    {word, of_axis}, [](const Root& root, [[maybe_unused]] int axis) {                      \
      return static_cast<std::uint32_t>(value);                                             \
    }                                                                                       \
  }

// A word that a column shows too; signed and unsigned values of an axis that none shows.
#define TRAMMEL_W(word, path) TRAMMEL_ROW(words::word, true, TRAMMEL_IN_AXIS(path))
#define TRAMMEL_S(name, bits, path, unit, help) \
  TRAMMEL_ROW((Word{name, unit, help, bits, true}), true, TRAMMEL_IN_AXIS(path))
#define TRAMMEL_U(name, bits, path, help) \
  TRAMMEL_ROW((Word{name, "", help, bits, false}), true, TRAMMEL_IN_AXIS(path))

template <class Root>
std::vector<SignalRow<Root>> inner_rows() {
  return {
      TRAMMEL_S("r", 24, u_afc__DOT__r_q, "count", "command of the sample"),
      TRAMMEL_S("x_p", 24, u_afc__DOT__x_p_q, "count", "position of the sample"),
      TRAMMEL_S("x_m", 32, u_afc__DOT__x_m_q, "count Q14", "model"),
      TRAMMEL_S("x_r", 24, u_afc__DOT__x_r_q, "count", "model, rounded"),
      TRAMMEL_S("dx", 24, u_afc__DOT__dx_q, "count Q14 per sample", "model increment"),
      TRAMMEL_W(kE, u_afc__DOT__e_q),
      TRAMMEL_W(kDe, u_afc__DOT__de_q),
      TRAMMEL_W(kU, u_afc__DOT__u_q),
      TRAMMEL_W(kVStar, u_afc__DOT__v_star_q),
      TRAMMEL_W(kV, u_afc__DOT__v_q),
      TRAMMEL_W(kIqRef, u_afc__DOT__i_q_ref_q),
      TRAMMEL_U("afc", 1, u_afc__DOT__running_q, "position controller in its 35 steps"),
      TRAMMEL_U("step", 6, u_afc__DOT__step_q, "its step, 0..34"),
      TRAMMEL_S("count", 24, u_qep__DOT__count_q, "count", "encoder counter"),
      TRAMMEL_U("code_a", 12, code_a, "converter, phase a; 2048 = 0 A"),
      TRAMMEL_U("code_b", 12, code_b, "converter, phase b; 2048 = 0 A"),
      TRAMMEL_S("i_a", 12, u_current_loop__DOT__i_a_o, "I_fs / 2048", "phase current"),
      TRAMMEL_S("i_b", 12, u_current_loop__DOT__i_b_o, "I_fs / 2048", "phase current"),
      TRAMMEL_W(kId, u_current_loop__DOT__i_d_o),
      TRAMMEL_W(kIq, u_current_loop__DOT__i_q_o),
      TRAMMEL_W(kVd, u_current_loop__DOT__v_d_o),
      TRAMMEL_W(kVq, u_current_loop__DOT__v_q_o),
      TRAMMEL_U("cmp_a", 12, u_current_loop__DOT__cmp_a_o, "compare value of phase a"),
      TRAMMEL_U("cmp_b", 12, u_current_loop__DOT__cmp_b_o, "compare value of phase b"),
      TRAMMEL_U("cmp_c", 12, u_current_loop__DOT__cmp_c_o, "compare value of phase c"),
      TRAMMEL_ROW((Word{"gate_hi", "", "upper gates c b a", 3, false}), true,
                  root.gate_hi_o >> (3 * axis)),
      TRAMMEL_ROW((Word{"gate_lo", "", "lower gates c b a", 3, false}), true,
                  root.gate_lo_o >> (3 * axis)),
      TRAMMEL_ROW((Word{"irq", "", "interrupt line", 1, false}), false, root.irq_o),
      TRAMMEL_ROW((Word{"trip", "", "trip pin", 1, false}), false, root.trip_i),
  };
}

#undef TRAMMEL_IN_AXIS
#undef TRAMMEL_ROW
#undef TRAMMEL_S
#undef TRAMMEL_U
#undef TRAMMEL_W

template <class Root>
const std::vector<SignalRow<Root>>& signal_rows() {
  static const std::vector<SignalRow<Root>> rows = [] {
    std::vector<SignalRow<Root>> all = inner_rows<Root>();
    for (const auto& [field, read] : kung_xy_regs::kReadings<Root>) {
      all.push_back({{{field.name, "", field.help, field.bits, field.is_signed}, field.of_axis},
                     read});
    }
    return all;
  }();
  return rows;
}

}  // namespace trammel::kung
