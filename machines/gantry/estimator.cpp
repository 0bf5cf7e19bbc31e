// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/estimator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lab/settings.hpp"
#include "machines/gantry/track.hpp"
#include "machines/gantry/units.hpp"

namespace trammel::gantry {
namespace {

ideal::Butterworth low_pass_of(const EstimatorConfig& c) {
  return {c.filter == Filter::kLowPass1 ? 1 : 2, c.corner, 1e3 / kEstimate_ms};
}

ideal::Kalman<kMostOrder> kalman_of(const EstimatorConfig& c, const TrackModel& m) {
  return {m, c.doubt * c.doubt * m.psi * m.psi.transpose(), c.noise * c.noise};
}

}  // namespace

// Of a lower order the states behind it stay 0.
TrackModel read_model(const std::string& text) {
  TrackModel m;
  m.c(0) = 1;
  for (int n = 0; n + 1 < kMostOrder; ++n) m.phi(n, n + 1) = 1;
  const auto refuse = [&text](const std::string& why) {
    throw host::ConfigError(fmt::format(
        "velocity.model: \"{}\" {}; permitted: a1 ... an b1 ... bn of a stable model of order 1 to "
        "{}, as a run of gantry-identify prints it",
        text, why, kMostOrder));
  };
  if (text.empty()) {
    const auto stored = stored_track();
    m.phi.col(0).head<3>() = stored.phi.col(0);
    m.psi.head<3>() = stored.psi;
    return m;
  }
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    double number = 0;
    try {
      number = std::stod(word, &used);
    } catch (const std::exception&) {
    }
    if (used != word.size() || !std::isfinite(number)) refuse("has the word \"" + word + "\"");
    numbers.push_back(number);
  }
  const auto order = static_cast<Eigen::Index>(numbers.size() / 2);
  if (numbers.size() % 2 != 0 || order < 1 || order > kMostOrder) {
    refuse(fmt::format("has {} numbers", numbers.size()));
  }
  for (Eigen::Index n = 0; n < order; ++n) {
    m.phi(n, 0) = numbers[static_cast<std::size_t>(n)];
    m.psi(n) = numbers[static_cast<std::size_t>(n + order)];
  }
  if (!m.stable()) refuse("is not stable");
  return m;
}

std::string model_text(const std::vector<double>& a, const std::vector<double>& b) {
  return fmt::format("{:.6g} {:.6g}", fmt::join(a, " "), fmt::join(b, " "));
}

Estimator::Estimator(const EstimatorConfig& config, double pass_ms, bool keep)
    : c_(config),
      passes_(static_cast<std::uint32_t>(std::max(1.0, std::round(kEstimate_ms / pass_ms)))),
      keep_(keep),
      model_(read_model(config.model)),
      low_pass_(low_pass_of(config)),
      kalman_(kalman_of(config, model_)),
      forces_(static_cast<std::size_t>(config.dead_samples), 0.0) {}

void Estimator::restart() {
  mean_ = {};
  low_pass_ = low_pass_of(c_);
  kalman_ = kalman_of(c_, model_);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  force_sum_ = 0;
  pass_ = 0;
  now_ = 0;
  samples_ = {};
}

// A force is positive to the right, a velocity to the left.
std::int32_t Estimator::step(std::int32_t velocity, sw::MotorForces forces) {
  force_sum_ -= 0.5 * (forces.one + forces.two);
  if (c_.filter == Filter::kMean) now_ = mean_.step(velocity);
  if (pass_++ % passes_ != 0) return now_;
  const double z = kVelocity_mm_s * velocity, u = force_sum_ / passes_;
  force_sum_ = 0;
  if (keep_) {
    if (!samples_.y.empty()) samples_.u.push_back(u);
    samples_.y.push_back(z);
  }
  std::rotate(forces_.begin(), forces_.begin() + 1, forces_.end());
  forces_.back() = u;
  if (c_.filter == Filter::kMean) return now_;
  const double out =
      c_.filter == Filter::kKalman ? kalman_.step(forces_.front(), z) : low_pass_.step(z);
  now_ = static_cast<std::int32_t>(std::lround(out / kVelocity_mm_s));
  return now_;
}

}  // namespace trammel::gantry
