// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "machines/kung/plan/believed.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "models/plant/ad7476.hpp"
#include "models/plant/spans.hpp"

namespace trammel::kung {
namespace {

constexpr int kMaxStrokeCounts = 130000;  // the model's integrator holds 131071 (section 3)
constexpr double kLeastTurnCounts = 16;
constexpr int kInterpolated = 4;  // position samples in which the chip reaches a point

sw::Gain gain(const std::string& key, double value, double unit = 1,
              const std::string& reason = "") {
  in_range(key, value, 0, 63.9 / unit, reason);
  const fixed::Gain g = gain_word(value * unit);
  return {g.mant, g.exp};
}

// An error changes by half as much in a sample half as long.
std::int32_t shift_de_word(const std::string& key, int shift, int position_hz) {
  const int more = position_hz == 4000 ? 1 : position_hz == 1000 ? -1 : 0;
  in_range(key, shift, std::max(kLeastShift, kLeastShift - more),
           std::min(kMostShift, kMostShift - more),
           fmt::format("at chip.position_Hz = {}", position_hz));
  return shift + more;
}

// The plant can follow winding, thrust and friction.
void check_motor(const plant::AxisConfig& plant, std::size_t axis) {
  const plant::MotorRates rates(plant::motor_config(plant));
  const std::string at = fmt::format("plant.{}.", axis == 0 ? 'x' : 'y');
  const double shortest_us = 1e7 * plant::kShortestSpan;
  require(1e6 / rates.winding >= shortest_us,
          fmt::format("{}resistance_ohm over inductance: a winding of {:.3g} us is faster than the "
                      "{:g} us that the plant can follow", at, 1e6 / rates.winding, shortest_us));
  require(1e6 / rates.thrust >= shortest_us,
          fmt::format("{}force_constant_N_A: {:g} kg and the inductance swing against each other "
                      "in {:.3g} us, faster than the {:g} us that the plant can follow", at,
                      plant::motor_config(plant).mass, 1e6 / rates.thrust, shortest_us));
  require(rates.span() >= plant::kShortestSpan,
          fmt::format("{0}viscous_N_s_m, {0}friction_speed_m_s: friction that stops {1:g} kg in "
                      "{2:.3g} us is faster than the plant can follow", at,
                      plant::motor_config(plant).mass,
                      1e6 / std::max(rates.friction, rates.viscous)));
}

}  // namespace

sw::AxisSetup plan_axis(const Options& options, std::size_t axis) {
  check_believed(options, axis);
  const AxisGains g = gains_of(options, axis);
  const AxisChip& c = options.chip.axis[axis];
  const plant::AxisConfig& plant = options.plant.axis[axis];
  const auto key = [axis](const char* section, const char* name) {
    return fmt::format("{}.{}.{}", section, axis == 0 ? 'x' : 'y', name);
  };
  const double volt_unit = current_gain_value(1, plant.dc_link_v, plant.current_full_scale_a);
  const std::string at_voltage =
      fmt::format("at {} = {:g} and {} = {:g}", key("plant", "dc_link_V"), plant.dc_link_v,
                  key("plant", "current_full_scale_A"), plant.current_full_scale_a);
  // Speeds are words per sample; the same loop in seconds has these words at another rate.
  const double per_sample = options.chip.sample_s() / kGainSampleS;
  // gains.kv is the word of the paper's sensors; with others the amperes per speed are the same.
  const plant::AxisConfig reference;
  const double speed_unit = plant.encoder_count_m / reference.encoder_count_m / per_sample *
                            reference.current_full_scale_a / plant.current_full_scale_a;

  sw::AxisSetup s;
  const std::string at_rate = fmt::format("at chip.position_Hz = {}", options.chip.position_Hz);
  s.kp = gain(key("gains", "kp"), g.kp, per_sample, at_rate);
  s.ki = gain(key("gains", "ki"), g.ki, per_sample * per_sample, at_rate);
  s.kv = gain(key("gains", "kv"), g.kv, speed_unit,
              fmt::format("{}at {} = {:g} and {} = {:g}",
                          gain_by(options, axis, {"mass_kg", "force_constant_N_A"}),
                          key("plant", "encoder_count_m"), plant.encoder_count_m,
                          key("plant", "current_full_scale_A"), plant.current_full_scale_a));
  s.adapt = options.controller == Controller::kAfc;
  s.eta = s.adapt ? gain(key("gains", "learning_rate") + " as ETA",
                         eta_value(g.learning_rate, g.kp, g.ki, g.kv), per_sample, at_rate)
                  : sw::Gain{};
  s.kp_cur = gain(key("gains", "current_kp_V_A"), g.current_kp_V_A, volt_unit,
                  gain_by(options, axis, {"inductance_q_H"}) + at_voltage);
  s.ki_cur = gain(key("gains", "current_ki_V_A"), g.current_ki_V_A,
                  volt_unit * kGainCarrierHz / options.chip.carrier_Hz,
                  gain_by(options, axis, {"resistance_ohm"}) + at_voltage);
  s.shift_e = g.shift_e;
  s.shift_de = shift_de_word(key("gains", "shift_de"), g.shift_de, options.chip.position_Hz);

  const ModelWords model = model_words(g.omega_n_rad_s, g.zeta, options.chip.sample_s());
  s.a0 = word(model.a0);
  s.a0_scale = model.a0_scale;
  s.b2 = word(model.b2) & 0xFFFFFFu;

  check_motor(plant, axis);
  const double pole_pitch_m = believed_motor(options, axis).pole_pitch_m;
  const double turn_counts = 2 * pole_pitch_m / plant.encoder_count_m;
  require(turn_counts >= kLeastTurnCounts,
          fmt::format("{}: value {:g} is {:.3g} counts of {} an electrical turn, which takes at "
                      "least {:g}",
                      motor_key(options, axis, "pole_pitch_m"), pole_pitch_m, turn_counts,
                      key("plant", "encoder_count_m"), kLeastTurnCounts));
  // Rounded up, as the specification's 352047 of 12 200 counts.
  s.angle_step = static_cast<std::uint32_t>(std::ceil(std::ldexp(1, 32) / turn_counts - 1e-6));
  const double revolutions = g.theta_offset_rad / (2 * kPi);
  s.theta_ofs = static_cast<std::uint32_t>(
      std::llround(std::ldexp(revolutions - std::floor(revolutions), 32)));
  require(c.dead_time_ns >= options.chip.dead_time_min_ns,
          fmt::format("{}: value {} is below chip.dead_time_min_ns = {}",
                      key("chip", "dead_time_ns"), c.dead_time_ns, options.chip.dead_time_min_ns));
  s.dead_time = clocks(c.dead_time_ns, options.run.clock_ps);
  s.qep_filter = word(c.qep_filter_clk);
  s.adc_zeros = word(plant::leading_zeros(plant.adc_bits));
  const Encoder encoder{plant.encoder_count_m, options.chip.sample_s()};
  const double furthest_m = kMaxStrokeCounts * encoder.count_m;
  const std::string reach = fmt::format("the chip's model reaches {} counts of {} = {:g}",
                                        kMaxStrokeCounts, key("plant", "encoder_count_m"),
                                        plant.encoder_count_m);
  in_range(key("chip", "stroke_min_m"), c.stroke_min_m, -furthest_m, furthest_m, reach);
  in_range(key("chip", "stroke_max_m"), c.stroke_max_m, -furthest_m, furthest_m, reach);
  require(c.stroke_min_m < c.stroke_max_m,
          fmt::format("{}: value {:g} must be below {} = {:g}", key("chip", "stroke_min_m"),
                      c.stroke_min_m, key("chip", "stroke_max_m"), c.stroke_max_m));
  s.stroke_min = encoder.counts(c.stroke_min_m);
  s.stroke_max = encoder.counts(c.stroke_max_m);
  s.stroke_check = c.stroke_check;
  require(plant.stroke_min_m < plant.stroke_max_m,
          fmt::format("{}: must be below {} = {:g}", key("plant", "stroke_min_m"),
                      key("plant", "stroke_max_m"), plant.stroke_max_m));
  const double steepest_m = plant.encoder_period_m / (2 * kPi);
  require(plant.encoder_error_m < steepest_m,
          fmt::format("{}: value {:g} must be below {:.3g}, {} = {:g} over 2 pi: the counts would "
                      "not rise with the position", key("plant", "encoder_error_m"),
                      plant.encoder_error_m, steepest_m, key("plant", "encoder_period_m"),
                      plant.encoder_period_m));
  require(plant.chopper_v == 0 || plant.chopper_v >= plant.dc_link_v,
          fmt::format("{}: value {:g} must be 0 or at least {} = {:g}: it would burn the supply",
                      key("plant", "chopper_V"), plant.chopper_v, key("plant", "dc_link_V"),
                      plant.dc_link_v));
  require(plant.load_end_s == 0 || plant.load_end_s > plant.load_begin_s,
          fmt::format("{}: value {:g} must be 0 or above {} = {:g}", key("plant", "load_end_s"),
                      plant.load_end_s, key("plant", "load_begin_s"), plant.load_begin_s));
  const int held = ticks_per_point(options);
  require(!g.interpolate || !options.path.is_sweep(),
          key("gains", "interpolate") + ": must be off in a sweep, which has a point each sample");
  require(!g.interpolate || held == kInterpolated || options.path.kind == PathKind::kSquare,
          fmt::format("{}: must be off with chip.irq_period_ticks = {}: the chip reaches a point "
                      "in {} position samples", key("gains", "interpolate"), held,
                      kInterpolated));
  require(c.dead_time_ns < 0.5e9 / options.chip.carrier_Hz,
          fmt::format("{}: value {} must be below {:g}, half a period of chip.carrier_Hz = {}: no "
                      "gate would turn on", key("chip", "dead_time_ns"), c.dead_time_ns,
                      0.5e9 / options.chip.carrier_Hz, options.chip.carrier_Hz));
  s.interpolate = g.interpolate;
  s.feedforward = g.feedforward;
  return s;
}

}  // namespace trammel::kung
