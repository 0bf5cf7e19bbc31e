// SPDX-License-Identifier: Apache-2.0
//
// What a sample takes from inside a verilated gantry_tau.
#pragma once

#include <cstdint>

#include "machines/gantry/chip.hpp"

namespace trammel::gantry {

inline std::int32_t extended(std::uint32_t word, int bits) {
  const std::uint32_t sign = 1u << (bits - 1);
  return static_cast<std::int32_t>((word ^ sign) - sign);
}

template <class Root>
Words words_of(const Root& r) {
  Words w;
  w.position = static_cast<std::int32_t>(r.gantry_tau__DOT__position);
  w.velocity = extended(r.gantry_tau__DOT__velocity, 23);
  w.ticks = r.gantry_tau__DOT__ticks_q;
  w.phase = r.gantry_tau__DOT__phase;
  w.region = r.gantry_tau__DOT__region;
  w.known = r.gantry_tau__DOT__known != 0;
  w.force = {extended(r.gantry_tau__DOT__force_1, 11), extended(r.gantry_tau__DOT__force_2, 11)};
  w.codes = {r.gantry_tau__DOT__a, r.gantry_tau__DOT__a_dot, r.gantry_tau__DOT__b,
             r.gantry_tau__DOT__b_dot, r.gantry_tau__DOT__current};
  w.malformed = r.gantry_tau__DOT__malformed;
  w.lost = r.gantry_tau__DOT__lost;
  return w;
}

}  // namespace trammel::gantry
