// SPDX-License-Identifier: Apache-2.0
//
// What the units of the plan share: checks of a range, and lengths in counts.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "machines/kung/options.hpp"

namespace trammel::kung {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kMaxPoints = 2147483647;  // of a whole path
inline constexpr int kMaxFeedCounts = 128;  // a sample; the speed words saturate above (section 3)

// Whole numbers in full: 1048576, not 1.04858e+06.
inline std::string number_text(double value) {
  return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

inline void require(bool good, const std::string& message) {
  if (!good) throw std::invalid_argument(message);
}

inline void in_range(const std::string& key, double value, double low, double high,
              const std::string& reason = "") {
  require(value >= low && value <= high,
          fmt::format("{}: value {} is out of range {}..{}{}", key, number_text(value),
                      number_text(low), number_text(high),
                      reason.empty() ? "" : " (" + reason + ")"));
}

inline void require_step(const PathOptions& path) {
  require(path.square_low_m != path.square_high_m,
          "path.square_high_m: must differ from path.square_low_m");
}

// Metres in counts of an encoder.
struct Encoder {
  double count_m;
  double sample_s;  // of the position loop

  sw::Q32 q32(double metres) const {
    return static_cast<sw::Q32>(std::llround(std::ldexp(metres / count_m, 32)));
  }
  sw::Vec q32(double x_m, double y_m) const { return {q32(x_m), q32(y_m)}; }
  std::int32_t counts(double metres) const {
    return static_cast<std::int32_t>(std::floor(metres / count_m + 0.5));
  }
  double max_feed_m_s() const { return kMaxFeedCounts * count_m / sample_s; }
};

constexpr std::uint32_t word(int value) { return static_cast<std::uint32_t>(value); }

inline std::uint32_t clocks(int ns, std::int64_t clock_ps) {
  return static_cast<std::uint32_t>((std::int64_t{1000} * ns + clock_ps - 1) / clock_ps);
}

inline std::string feed_text(const Encoder& encoder) {
  return fmt::format("feed at most {:g} m/s at plant.encoder_count_m = {:g}",
                     encoder.max_feed_m_s(), encoder.count_m);
}

// stepped_sine.cpp
sw::SteppedSine::Setup plan_stepped_sine(const Options& options, const Encoder& encoder);
void check_sweep(const Options& options);  // that a response can be computed from its records

}  // namespace trammel::kung
