// SPDX-License-Identifier: Apache-2.0
//
// What the precision controller takes for mass and error has a range: samples at its limits, and
// how far the move before the path may swing.
#pragma once

#include <array>
#include <cstdint>

#include "machines/kung/chip/record.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

class LimitWatch {
 public:
  // `program`: whose estimators are seen; null: they are not.
  void on(const Sample& sample, const sw::KungMailbox* program, Result& result);

 private:
  std::array<std::uint32_t, 2> mass_limited_{};  // up to now
};

// The move before the path goes far beyond its way: start values that the plant does not bear. How
// far [m], 0 where it does not.
double swing_m(const Options& options, const Sample& sample);

}  // namespace trammel::kung
