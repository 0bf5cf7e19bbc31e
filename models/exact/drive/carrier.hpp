// SPDX-License-Identifier: Apache-2.0
//
// Frequencies of the PWM carrier (rtl/pkg/trammel_pkg.sv): period, top and ticks in a millisecond
// by the number that RATES.carrier holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trammel::exact {

inline constexpr std::array<std::uint32_t, 4> kCarrierHz{16000, 8000, 20000, 40000};
inline constexpr std::uint32_t kCarrier8kHz = 1;

// [clk] at 50 MHz.
constexpr std::uint32_t pwm_period(std::uint32_t carrier) {
  return 50'000'000 / kCarrierHz[static_cast<std::size_t>(carrier)];
}

// Top of the carrier.
constexpr std::uint32_t cmp_max(std::uint32_t carrier) { return pwm_period(carrier) / 2; }

// Ticks of the carrier in a position sample; RATES.position: 0 1 kHz, 1 2 kHz, others 4 kHz.
constexpr std::uint32_t ticks_of_position(std::uint32_t carrier, std::uint32_t rate) {
  return kCarrierHz[static_cast<std::size_t>(carrier)] / 1000 >> (rate < 2 ? rate : 2);
}

}  // namespace trammel::exact
