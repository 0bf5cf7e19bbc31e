// SPDX-License-Identifier: Apache-2.0
//
// The twin of sincos_observer on a sensor in motion, a conversion each tick, and calibration data
// fitted to a sensor with errors.
#pragma once

#include <eigen3/Eigen/Dense>  // also where no path to it is set: waves, mutants
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "models/exact/sense/conversion_slots.hpp"
#include "models/exact/sense/sincos_observer.hpp"
#include "tests/support/stripe_sensor.hpp"

namespace trammel::test {

class ObserverTrack {
 public:
  exact::Calibration calib = ideal_calibration();
  StripeSensor sensor;
  bool loaded = false;     // the requester asks for the current all the time
  double x_sampled = 0;    // [mm] at the last code of an encoder
  bool is_encoder = false;  // the last code was of one

  const exact::SincosObserver::Out& out() const { return observer_.out(); }
  double position_mm() const { return out().position * kUnit_mm; }
  double velocity_mm_s() const { return out().velocity * kUnit_mm / 512 / kTick_s; }

  // One tick, with the sensor at x.
  void tick(double x_mm, double v_mm_s) {
    exact::ConversionSlots::In slots;
    slots.wants = true;
    slots.pick = true;
    slots.ask = loaded ? 0x40 : 0;
    const auto turn = slots_.pick(slots);
    slots_.step(slots);
    exact::SincosObserver::In in;
    in.active = in.velocity = true;
    in.tick = true;
    in.ask = turn == exact::ConversionSlots::Client::kObserver;
    std::optional<std::uint32_t> channel = observer_.asked(in);
    observer_.step(in, calib);
    in.tick = in.ask = false;
    while (observer_.busy()) {
      if (!channel) channel = observer_.asked(in);
      observer_.step(in, calib);
    }
    if (!channel) channel = 6;
    is_encoder = *channel % 2 == 0 && *channel < 4;
    if (is_encoder) x_sampled = x_mm;
    in.sample = true;
    in.channel = *channel;
    in.code = static_cast<std::uint32_t>(sensor.code(static_cast<int>(*channel), x_mm, v_mm_s));
    observer_.step(in, calib);
    in.sample = false;
    while (observer_.busy()) observer_.step(in, calib);
  }

 private:
  exact::SincosObserver observer_;
  exact::ConversionSlots slots_;
};

// Cubics of the phase by least squares over each region, as the thesis' routine fits them from a
// run; the regions a little wider than they are used.
inline exact::Calibration fitted(const StripeSensor& sensor) {
  exact::Calibration c = ideal_calibration();
  constexpr int kPoints = 400;
  constexpr double kHalf = 0.16;  // of a period
  for (std::size_t region = 0; region < 4; ++region) {
    const int channel = region % 2 == 0 ? 2 : 0;
    const double offset = channel == 2 ? sensor.offset_b : sensor.offset_a;
    const int ymid = static_cast<int>(std::lround(64 * offset));
    c.words[10 + region] = static_cast<std::uint16_t>(ymid);
    Eigen::MatrixXd powers(kPoints, 4);
    Eigen::VectorXd phases(kPoints);
    const double middle = static_cast<double>(region) / 4;  // of a period
    for (int k = 0; k < kPoints; ++k) {
      const double turn = middle + kHalf * (2.0 * k / (kPoints - 1) - 1);
      const double code = sensor.code(channel, turn * kPeriod_mm, 0);
      const double x = (64 * (code - 512) - ymid) / 16384;
      powers.row(k) << x * x * x, x * x, x, 1;
      phases(k) = 16384 * turn;
    }
    const Eigen::VectorXd fit = powers.colPivHouseholderQr().solve(phases);
    for (std::size_t k = 0; k < 4; ++k) {
      c.words[14 + 4 * region + k] =
          static_cast<std::uint16_t>(std::lround(fit(static_cast<Eigen::Index>(k))) & 0xFFFF);
    }
  }
  return exact::sealed(c);
}

}  // namespace trammel::test
