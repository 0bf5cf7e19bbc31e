// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/options.hpp"

#include <fmt/format.h>

#include "host/errors.hpp"

namespace trammel::lm628 {
namespace {

void check_either(const char* key, int value, int one, int other) {
  if (value == one || value == other) return;
  throw host::ConfigError(fmt::format("{}: value {} is neither {} nor {}", key, value, one, other));
}

}  // namespace

void check_clock(int clock_MHz) { check_either("chip.clock_MHz", clock_MHz, 6, 8); }

void check_part(const PartOptions& part) {
  check_clock(part.clock_MHz);
  check_either("chip.dac_bits", part.dac_bits, 8, 12);
}

std::string part_warning(const PartOptions& part) {
  if (!part.pulses() || part.dac_bits == PartOptions().dac_bits) return "";
  return fmt::format("chip.dac_bits = {} has no effect: an LM629 has no converter", part.dac_bits);
}

}  // namespace trammel::lm628
