// SPDX-License-Identifier: Apache-2.0
//
// Frequencies of the PWM carrier (rtl/pkg/trammel_pkg.sv): period, top and ticks in a millisecond
// by the number that RATES.carrier holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace trammel::exact {

inline constexpr std::array<std::uint32_t, 4> kCarrierHz{16000, 8000, 20000, 40000};
inline constexpr std::uint32_t kCarrier8kHz = 1;
inline constexpr std::uint32_t kCarrierClockHz = 50'000'000;  // of a block by default

// The same, if each carrier has a whole number of its clocks and the words of the modulation hold
// them; otherwise throws std::invalid_argument.
inline std::uint32_t carrier_clock(std::uint32_t clock_hz) {
  if (clock_hz % 80'000 == 0 && clock_hz >= 8'000'000 && clock_hz <= 55'360'000) return clock_hz;
  throw std::invalid_argument("carrier: clock of " + std::to_string(clock_hz) +
                              " Hz: must be a multiple of 80000 from 8000000 to 55360000");
}

// [clk]
constexpr std::uint32_t pwm_period(std::uint32_t carrier,
                                   std::uint32_t clock_hz = kCarrierClockHz) {
  return clock_hz / kCarrierHz[static_cast<std::size_t>(carrier)];
}

// Top of the carrier.
constexpr std::uint32_t cmp_max(std::uint32_t carrier, std::uint32_t clock_hz = kCarrierClockHz) {
  return pwm_period(carrier, clock_hz) / 2;
}

// Ticks of the carrier in a position sample; RATES.position: 0 1 kHz, 1 2 kHz, others 4 kHz.
constexpr std::uint32_t ticks_of_position(std::uint32_t carrier, std::uint32_t rate) {
  return kCarrierHz[static_cast<std::size_t>(carrier)] / 1000 >> (rate < 2 ? rate : 2);
}

}  // namespace trammel::exact
