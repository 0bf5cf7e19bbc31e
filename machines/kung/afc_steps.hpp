// SPDX-License-Identifier: Apache-2.0
//
// What multiplier and adder of rtl/control/afc.sv hold after each of its 35 steps, in one sample
// (specification section 6), from the words the sample starts with.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "machines/kung/record.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

struct AfcStep {
  std::optional<std::int64_t> product;  // of the step's two factors, as the multiplier keeps it
  std::optional<std::int64_t> result;   // what the step leaves behind for later ones
};

struct AfcTrace {
  std::array<AfcStep, 35> steps;
  kung::AxisSample end;                 // the words the chip shows after the sample
  std::int32_t integral = 0;
  std::array<int, 4> fired{};           // rules 7 j + i that s31 to s34 change
  int section_e = 0, section_de = 0;    // i and j
};

AfcTrace trace_afc(const sw::AxisSetup& setup, const kung::AfcStart& start);

}  // namespace trammel::kung
