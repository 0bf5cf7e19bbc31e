// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "models/ideal/reference_model.hpp"

namespace trammel::kung {
namespace {

double sign(double v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

class AxisDemand {
 public:
  AxisDemand(const Options& options, std::size_t axis, double start_m)
      : plant_(options.plant.axis[axis]), sample_s_(options.chip.sample_s()),
        dead_V_(4 / kPi * plant_.dc_link_v * 1e-9 * options.chip.axis[axis].dead_time_ns *
                options.chip.carrier_Hz),
        model_({options.gains[axis].omega_n_rad_s, options.gains[axis].zeta, sample_s_}),
        x_(start_m) {
    model_.reset(start_m);
  }

  void add(double command_m) {
    const double x = model_.step(command_m);
    const double v = (x - x_) / sample_s_, a = (v - v_) / sample_s_;
    x_ = x;
    v_ = v;
    const double force = (plant_.mass_kg + plant_.payload_kg) * a + held_back_N(x, v);
    if (std::abs(force) > most.force_N) most.force_N = std::abs(force), most.at_force_m_s = v;
    // lambda omega_e = 2/3 K_F v, and the drops of that thrust's current.
    const double i = force / plant_.force_constant_n_a;
    const double volt = dead_V_ + std::hypot(
        2.0 / 3 * plant_.force_constant_n_a * v + plant_.resistance_ohm * i,
        kPi / plant_.pole_pitch_m * v * plant_.inductance_q_h * i);
    most.drop_V = std::max(most.drop_V, plant_.resistance_ohm * std::abs(i));
    if (volt > most.volt) most.volt = volt, most.at_volt_m_s = v;
    most.speed_m_s = std::max(most.speed_m_s, std::abs(v));
  }

  Demand most;

 private:
  // By friction, magnets, cable and load, as models/plant/pmlsm.hpp has them.
  double held_back_N(double x, double v) {
    time_s_ += sample_s_;
    const double w = v / plant_.stribeck_speed_m_s, slots = 2 * kPi * x / plant_.pole_pitch_m;
    const bool loaded = time_s_ >= plant_.load_begin_s &&
                        (plant_.load_end_s == 0 || time_s_ < plant_.load_end_s);
    return plant_.viscous_n_s_m * v +
           (plant_.coulomb_n + plant_.stribeck_n * std::exp(-w * w)) * sign(v) +
           plant_.cogging_n * std::sin(slots) +
           plant_.cogging_harmonic_n * std::sin(plant_.cogging_harmonic * slots + 1) +
           plant_.cable_n_m * (x - plant_.cable_rest_m) + plant_.external_force_n +
           (loaded ? plant_.load_n : 0);
  }

  const plant::AxisConfig& plant_;
  double sample_s_;
  double dead_V_;  // that the dead times take: a square wave of V_dc times their share
  ideal::ReferenceModel model_;
  double x_, v_ = 0, time_s_ = 0;  // since the path began, soon after the run
};

}  // namespace

Walk walk_path(const Options& options, const sw::PathSetup& setup) {
  sw::PathSetup once = setup;  // every pass has the same bounds
  once.repeats = 1;
  sw::Trajectory path(once);
  sw::Point p = path.start();
  Walk walk{p, p};
  const double count_m = options.plant.axis[0].encoder_count_m;
  AxisDemand x(options, 0, p.x * count_m), y(options, 1, p.y * count_m);
  const int held = ticks_per_point(options);
  double left_s = options.path.is_sweep() ? 0 : options.run.max_s;  // what comes later is not run
  for (std::uint32_t n = path.size(); n > 0; --n) {
    const sw::Point last = p;
    p = path.next();
    walk.low = {std::min(walk.low.x, p.x), std::min(walk.low.y, p.y)};
    walk.high = {std::max(walk.high.x, p.x), std::max(walk.high.y, p.y)};
    if (left_s <= 0) continue;
    left_s -= held * options.chip.sample_s();
    for (int k = 1; k <= held; ++k) {
      const auto at = [&](const AxisGains& g, std::int32_t from, std::int32_t to) {
        return count_m * (g.interpolate ? from + static_cast<double>(to - from) * k / held : to);
      };
      x.add(at(options.gains[0], last.x, p.x));
      y.add(at(options.gains[1], last.y, p.y));
    }
  }
  walk.demand = {x.most, y.most};
  return walk;
}

}  // namespace trammel::kung
