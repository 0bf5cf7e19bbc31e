// SPDX-License-Identifier: Apache-2.0
//
// Pins of the two-axis table in packed words; the machine with such a table tests that its chip
// has the same packing.
#pragma once

#include <cstdint>

namespace trammel::plant {

using Clk = std::int64_t;
using Lines = std::uint64_t;

namespace xy {

inline constexpr int kAxes = 2;

constexpr int encoder_a(int axis) { return 3 * axis; }
constexpr int encoder_b(int axis) { return 3 * axis + 1; }
constexpr int encoder_z(int axis) { return 3 * axis + 2; }
constexpr int gate_hi(int axis, int phase) { return 6 * axis + phase; }
constexpr int gate_lo(int axis, int phase) { return 6 * axis + 3 + phase; }
constexpr int adc_channel(int axis, int phase) { return 2 * axis + phase; }
constexpr unsigned axis_gates(Lines drive, int axis) {
  return static_cast<unsigned>(drive >> (6 * axis)) & 63u;
}

}  // namespace xy
}  // namespace trammel::plant
