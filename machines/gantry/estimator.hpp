// SPDX-License-Identifier: Apache-2.0
//
// Filters of the velocity that a computer beside the chip has room for (Brochier 2006, 3.2):
// low-pass filters of order 1 and 2 and a Kalman filter, each at 100 Hz. It keeps input and output
// of a run without controller, from which a model is identified.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "models/ideal/butterworth.hpp"
#include "models/ideal/kalman.hpp"
#include "sw_nios/apps/gantry/gantry.hpp"

namespace trammel::gantry {

inline constexpr double kEstimate_ms = 10;  // from one sample to the next
inline constexpr int kMostOrder = 4;        // of a model

enum class Filter : std::uint8_t { kMean, kLowPass1, kLowPass2, kKalman };

struct EstimatorConfig {
  Filter filter = Filter::kMean;  // the firmware's own
  double corner = 5;              // [Hz] of the low-pass filters
  std::string model;              // a1 ... an b1 ... bn of the Kalman filter; "": the stored model
  int dead_samples = 2;           // from a force to its first effect; 1: the next sample
  double noise = 20;              // [mm/s] rms, of the measured velocity
  double doubt = 60;              // [count] rms, of the force that the model leaves out
};

using TrackModel = ideal::LinearModel<kMostOrder>;

// Throws host::ConfigError that names the key.
TrackModel read_model(const std::string& text);
std::string model_text(const std::vector<double>& a, const std::vector<double>& b);

// What an identification takes: u[k] holds from sample k to k + 1.
struct Samples {
  std::vector<double> u, y;  // [count] positive to the left, [mm/s]
};

class Estimator final : public sw::VelocityFilter {
 public:
  Estimator(const EstimatorConfig& config, double pass_ms, bool keep);

  std::int32_t step(std::int32_t velocity, sw::MotorForces forces) override;
  void restart() override;

  const Samples& samples() const { return samples_; }

 private:
  EstimatorConfig c_;
  std::uint32_t passes_;  // of a sample
  bool keep_;             // the samples
  TrackModel model_;
  sw::MeanFilter mean_;
  ideal::Butterworth low_pass_;
  ideal::Kalman<kMostOrder> kalman_;
  std::vector<double> forces_;  // [count] the last ones, each of a sample, newest last
  double force_sum_ = 0;
  std::uint32_t pass_ = 0;
  std::int32_t now_ = 0;
  Samples samples_;
};

}  // namespace trammel::gantry
