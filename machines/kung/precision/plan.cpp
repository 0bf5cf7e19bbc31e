// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "machines/kung/plan/believed.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "models/ideal/normal_equations.hpp"

namespace trammel::kung {
namespace {

constexpr int kLawCarrierHz = 16000, kLawPositionHz = 2000, kIrqTicks = 4;
constexpr double kTickS = 1.0 / kLawCarrierHz, kKnotS = 2e-3;
constexpr int kSubTicks = 15;   // an edge is fresh for that long
constexpr double kLeastMantissa = 32;  // a gain whose word is within 2 %
constexpr std::array<double, 2> kLightest{2, 6}, kHeaviest{32, 40};  // [kg]
constexpr double kWaveM = 0.8e-3;      // of the identification move
constexpr double kReferenceCountM = 5e-6;  // of the encoder whose scales are 3 and 12
constexpr double kMostTheta = 1 << 27, kLeastMass = 1 << 10;

// By which the current of a sample may differ from that of the model, with all that the samples
// have in common [LSB of i_q* / 128]: within what follows from it the true mass was in 19 of 20
// estimates of 120 random programs of 1 to 400 mm/s with the plants of docs/precision.md, 13.
constexpr double kDoubt = 6000;

std::string axis_keys(std::size_t axis) {
  return fmt::format("precision.{}.", axis == 0 ? 'x' : 'y');
}

// What one unit is in words of theta.
struct ThetaUnits {
  std::uint32_t accel_shift, speed_shift;
  double mass, viscous, force;  // of a kg, an N s/m, an N

  explicit ThetaUnits(const plant::AxisConfig& motor) {
    // Finer encoders count more on the same way; the regressors remain what they are.
    const double finer = std::round(std::log2(kReferenceCountM / motor.encoder_count_m));
    accel_shift = static_cast<std::uint32_t>(std::clamp(3 + finer, 1.0, 13.0));
    speed_shift = static_cast<std::uint32_t>(std::clamp(12 + finer, 4.0, 22.0));
    const double lsb_N = motor.force_constant_n_a * current_ref_lsb_A(motor.current_full_scale_a);
    const double whole = std::ldexp(1.0, 23) / lsb_N;  // Q16 of 1/128 LSB
    force = whole / 1024;
    mass = whole * std::ldexp(motor.encoder_count_m, static_cast<int>(accel_shift) - 13) /
           (kKnotS * kKnotS);
    viscous = whole * std::ldexp(motor.encoder_count_m, static_cast<int>(speed_shift) - 13) /
              (2 * kKnotS);
  }
};

// Those by which the words of an axis are computed.
std::string motor_text(const Options& options, std::size_t axis) {
  const plant::AxisConfig motor = believed_motor(options, axis);
  const char name = axis == 0 ? 'x' : 'y';
  return fmt::format("at plant.{0}.encoder_count_m = {1:g}, {2} = {3:g} and "
                     "plant.{0}.current_full_scale_A = {4:g}", name, motor.encoder_count_m,
                     motor_key(options, axis, "force_constant_N_A"), motor.force_constant_n_a,
                     motor.current_full_scale_a);
}

sw::Gain nearest_gain(double value) {
  const fixed::Gain g = gain_word(value);
  return {g.mant, g.exp};
}

std::int32_t rounded_word(double value) { return static_cast<std::int32_t>(std::lround(value)); }

sw::EstimatorSetup plan_estimator(const Options& options, std::size_t axis) {
  const AxisPrecision& own = options.precision.axis[axis];
  const plant::AxisConfig plant = believed_motor(options, axis);
  const std::string keys = axis_keys(axis), motor = motor_text(options, axis);
  const ThetaUnits units(plant);
  // The largest range that the start values span, at least the default table's with its payloads.
  constexpr double kDown = 2.6, kUp = 2.5;
  const double least =
      std::max(kLeastMass, std::ldexp(1.0, 4 + static_cast<int>(units.accel_shift)));
  in_range(keys + "mass_kg", own.mass_kg, kDown * least / units.mass,
           kMostTheta / units.mass / kUp, motor);
  in_range(keys + "viscous_N_s_m", own.viscous_n_s_m, 0, kMostTheta / units.viscous, motor);
  in_range(keys + "coulomb_N", own.coulomb_n, 0, 65535 * 32 / units.force, motor);

  sw::EstimatorSetup s;
  s.mass = rounded_word(own.mass_kg * units.mass);
  s.viscous = rounded_word(own.viscous_n_s_m * units.viscous);
  s.coulomb = rounded_word(own.coulomb_n * units.force);
  s.mass_min = rounded_word(
      std::max(least, std::min(kLightest[axis], own.mass_kg / kDown) * units.mass));
  s.mass_max = rounded_word(
      std::min(kMostTheta, std::max(kHeaviest[axis], own.mass_kg * kUp) * units.mass));
  s.pitch = rounded_word(8 * plant.pole_pitch_m / plant.encoder_count_m);
  s.accel_shift = units.accel_shift;
  s.speed_shift = units.speed_shift;
  s.slowest = rounded_word(std::ldexp(1.0, 2 + static_cast<int>(units.speed_shift)));
  return s;
}

// The estimated mass that the largest current accelerates as the path may ask, at most the largest
// there is an estimate of.
std::int32_t heavy_mass(const Options& options, std::size_t axis, std::int32_t mass_max) {
  const plant::AxisConfig plant = believed_motor(options, axis);
  const double most_A = 2047 * current_ref_lsb_A(plant.current_full_scale_a);
  const double mass_kg =
      plant.force_constant_n_a * most_A / options.path.axis[axis].accel_m_s2;
  return rounded_word(std::min<double>(mass_max, mass_kg * ThetaUnits(plant).mass));
}

// The move before the path stays on it.
void check_wave(const Options& options, const sw::KungSetup& setup, std::size_t axis,
                std::int32_t wave) {
  const sw::Point start = sw::Trajectory(setup).start();
  const sw::AxisSetup& chip = setup.axis[axis];
  const std::int32_t at = axis == 0 ? start.x : start.y;
  const bool up = 2 * at <= chip.stroke_min + chip.stroke_max;
  const std::int32_t end = at + (up ? wave : -wave) / 256;
  const plant::AxisConfig& plant = options.plant.axis[axis];
  const double end_m = end * plant.encoder_count_m;
  const bool stops = plant.hard_stops &&
                     (end_m < plant.stroke_min_m || end_m > plant.stroke_max_m);
  const bool leaves = end < chip.stroke_min || end > chip.stroke_max;
  const char name = axis == 0 ? 'x' : 'y';
  const AxisChip& asked = options.chip.axis[axis];
  const auto refused = [&](const std::string& what, double low_m, double high_m) {
    return fmt::format("precision.identify: the move before the path, {:g} m of {} from {:g} m "
                       "towards the middle of the chip's stroke, leaves {}.{}.stroke_min_m.."
                       "stroke_max_m = {:g}..{:g}; false goes without it", kWaveM, name,
                       at * plant.encoder_count_m, what, name, low_m, high_m);
  };
  require(!leaves, refused("chip", asked.stroke_min_m, asked.stroke_max_m));
  require(!stops, refused("the hard stops plant", plant.stroke_min_m, plant.stroke_max_m));
}

void check_rates(const Options& options) {
  const auto fixed = [](const char* key, int value, int wanted) {
    require(value == wanted,
            fmt::format("{}: value {} must be {} with controller = \"precision\", whose law, gains "
                        "and delays are those of that rate", key, value, wanted));
  };
  fixed("chip.carrier_Hz", options.chip.carrier_Hz, kLawCarrierHz);
  fixed("chip.position_Hz", options.chip.position_Hz, kLawPositionHz);
  fixed("chip.irq_period_ticks", options.chip.irq_period_ticks, kIrqTicks);
}

// How well the samples of an estimator know each of its unknowns.
ideal::Knowledge<sw::Estimator::kUnknowns> knowledge_of(const sw::Estimator& estimator) {
  std::array<std::array<double, sw::Estimator::kUnknowns>, sw::Estimator::kUnknowns> r{};
  for (std::uint32_t i = 0; i < r.size(); ++i) {
    for (std::uint32_t j = 0; j < r.size(); ++j) {
      r[i][j] = static_cast<double>(estimator.weight(i, j));
    }
  }
  return ideal::knowledge_of(r);
}

}  // namespace

sw::LawGains law_gains(const std::string& keys, double w1_rad_s, double zeta, double w2_rad_s,
                       double w3_rad_s) {
  require(w2_rad_s > w1_rad_s,
          fmt::format("{}w2_rad_s: value {:g} must be above {}w1_rad_s = {:g}: the observer is "
                      "faster than the feedback", keys, w2_rad_s, keys, w1_rad_s));
  const double z = std::exp(-w2_rad_s * kTickS), y = std::exp(-w3_rad_s * kTickS);
  const double square = (1 - z) * (1 - z);
  const double l3 = square * (1 - y);
  const double smallest = kLeastMantissa * std::ldexp(1.0, -27);
  if (w3_rad_s > 0 && l3 < smallest) {
    const double least = -std::log(1 - smallest / square) / kTickS;
    in_range(keys + "w3_rad_s", w3_rad_s, least, 2000,
             fmt::format("or 0: L3 has no smaller word at {}w2_rad_s = {:g}", keys, w2_rad_s));
  }
  return {nearest_gain(1 - z * z * y), nearest_gain((1 - z) * (1 + z - 2 * z * y)),
          nearest_gain(l3), nearest_gain(w1_rad_s * w1_rad_s * kTickS * kTickS),
          nearest_gain(2 * zeta * w1_rad_s * kTickS)};
}

sw::PrecisionSetup plan_precision(const Options& options, const sw::KungSetup& setup) {
  sw::PrecisionSetup s;
  s.on = options.controller == Controller::kPrecision;
  if (!s.on) return s;
  check_rates(options);
  const PrecisionOptions& p = options.precision;
  require(!options.path.is_sweep(),
          "path.kind: \"sweep\" has a point each position sample, and controller = \"precision\" "
          "one in four");
  require(feeds(options) || options.path.kind == PathKind::kPoints,
          "path.profile: \"constant\" steps in speed, which controller = \"precision\" cannot "
          "follow on a built-in shape; it needs \"feed\"");
  require(!p.learn || options.path.kind != PathKind::kLine,
          "precision.learn: a lap learns from the one before, and path.kind = \"line\" has one "
          "lap; the other shapes can repeat");
  require(!p.learn || setup.repeats > 1,
          fmt::format("precision.learn: needs {} of 2 or more, is {}: a lap learns from the one "
                      "before",
                      options.path.kind == PathKind::kSquare ? "path.square_periods"
                                                             : "path.repeats",
                      setup.repeats));
  const bool feed = setup.path == sw::Path::kFeed;
  const std::uint32_t lap = feed ? setup.feed.ticks : setup.n_points;
  require(!p.learn || lap <= sw::Corrections::kPoints,
          fmt::format("precision.learn: a lap has {} points, of which at most {} are learned; {}",
                      lap, sw::Corrections::kPoints,
                      feed ? "a higher path.feed_m_s makes fewer"
                           : "path.points_file can have fewer"));
  s.identify = p.identify;
  s.adapt = p.adapt;
  s.learn = p.learn;
  s.learn_gain = static_cast<std::uint32_t>(std::lround(std::ldexp(p.learn_gain, 16)));
  for (std::size_t a = 0; a < 2; ++a) {
    const AxisPrecision& own = p.axis[a];
    const std::string keys = axis_keys(a);
    sw::PrecisionAxisSetup& axis = s.axis[a];
    axis.full = law_gains(keys, own.w1_rad_s, own.zeta, own.w2_rad_s, own.w3_rad_s);
    // With masses that nobody knows yet; never stiffer than what was asked for.
    axis.soft = law_gains(keys, std::min(120.0, own.w1_rad_s), 0.7, std::min(1500.0, own.w2_rad_s),
                          0);
    const auto hysteresis = static_cast<std::uint32_t>(std::lround(128 * own.hysteresis_counts));
    axis.misc = word(own.lead_ticks) | word(kKnee) << 4 | word(p.subcount ? kSubTicks : 0) << 8 |
                hysteresis << 12 | 1u << 20;
    axis.wave = rounded_word(256 * kWaveM / options.plant.axis[a].encoder_count_m);
    axis.estimator = plan_estimator(options, a);
    axis.heavy = heavy_mass(options, a, axis.estimator.mass_max);
    if (p.identify) check_wave(options, setup, a, axis.wave);
  }
  return s;
}

AxisEstimate estimate_of(const Options& options, std::size_t axis, const sw::Estimator& found) {
  using E = sw::Estimator;
  constexpr double kOwn = 0.1;
  AxisEstimate e = estimate_of(options, axis, found.theta());
  e.taught = found.weight(0, 0) != E({}, 0).weight(0, 0);
  const auto known = knowledge_of(found);
  const auto& own = known.own_share;
  e.mass_mixed = own[E::kMass] < kOwn;
  e.viscous_mixed = own[E::kViscous] < kOwn;
  e.coulomb_mixed = own[E::kCoulomb] < kOwn;
  e.cogging_mixed = std::min(own[E::kSine], own[E::kCosine]) < kOwn;
  e.force_mixed = own[E::kForce] < kOwn;
  e.mass_within_kg = std::ldexp(kDoubt, 16) / ThetaUnits(believed_motor(options, axis)).mass *
                     std::sqrt(known.variance[E::kMass]);
  return e;
}

AxisEstimate estimate_of(const Options& options, std::size_t axis,
                         const sw::Estimator::Theta& theta) {
  using E = sw::Estimator;
  const ThetaUnits units(believed_motor(options, axis));
  AxisEstimate e;
  e.mass_kg = theta[E::kMass] / units.mass;
  e.viscous_N_s_m = theta[E::kViscous] / units.viscous;
  e.coulomb_N = theta[E::kCoulomb] / units.force;
  e.cogging_sine_N = theta[E::kSine] / units.force;
  e.cogging_cosine_N = theta[E::kCosine] / units.force;
  e.force_N = theta[E::kForce] / units.force;
  const sw::EstimatorSetup range = plan_estimator(options, axis);
  const std::int32_t most = 4 * range.coulomb;
  e.mass_limited = theta[E::kMass] <= range.mass_min || theta[E::kMass] >= range.mass_max;
  e.viscous_limited = theta[E::kViscous] <= 0 || theta[E::kViscous] >= 3 * range.viscous;
  e.coulomb_limited = theta[E::kCoulomb] <= 0 || theta[E::kCoulomb] >= most;
  e.force_limited = std::abs(theta[E::kForce]) >= E::kMostForce;
  e.cogging_limited = std::abs(theta[E::kSine]) >= most || std::abs(theta[E::kCosine]) >= most;
  return e;
}

AxisEstimate told_estimate(const Options& options, std::size_t axis, const AxisLaw& law) {
  const ThetaUnits units(believed_motor(options, axis));
  AxisEstimate e;
  // What the firmware does (sw_nios/apps/kung/precision_values.hpp), backward.
  e.mass_kg = std::ldexp(law.km.value(), 18 + static_cast<int>(units.accel_shift)) / units.mass;
  e.viscous_N_s_m =
      std::ldexp(law.kb.value(), 10 + static_cast<int>(units.speed_shift)) / units.viscous;
  e.coulomb_N = 32.0 * law.fc / units.force;
  e.force_N = law.iacc / units.force;
  return e;
}

}  // namespace trammel::kung
