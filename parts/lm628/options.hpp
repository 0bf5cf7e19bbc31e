// SPDX-License-Identifier: Apache-2.0
//
// Which LM628 a machine has, and what is behind its outputs.
#pragma once

#include <string>

#include "models/exact/motion/lm628_time.hpp"

namespace trammel::lm628 {

enum class Variant {
  kLm628,  // a converter and a linear amplifier
  kLm629   // pins of sign and magnitude, and an H-bridge
};

struct PartOptions {
  Variant variant = Variant::kLm628;
  int dac_bits = 12;   // 8 or 12, of the converter behind an LM628
  int clock_MHz = 8;   // 6 or 8
  bool wrap = false;   // products and sum of the filter wrap at 16 bits instead of saturating

  bool pulses() const { return variant == Variant::kLm629; }
};

// One of 6 and 8 MHz, of a part in a fabric of 50 MHz.
inline exact::Lm628Clock clock_of(int clock_MHz) {
  return clock_MHz == 6 ? exact::Lm628Clock::k6MHz : exact::Lm628Clock::k8MHz;
}

// From one sample to the next [s]: 2048 ticks of the part's clock.
inline double sample_s(int clock_MHz) { return 2048 / (clock_MHz * 1e6); }

// Throw host::ConfigError, with the key, the value and what is permitted.
void check_clock(int clock_MHz);
void check_part(const PartOptions& part);

// A word on what is asked for and has no effect, or "".
std::string part_warning(const PartOptions& part);

}  // namespace trammel::lm628
