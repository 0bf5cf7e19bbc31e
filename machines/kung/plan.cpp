// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "machines/kung/believed.hpp"
#include "machines/kung/machine.hpp"
#include "machines/kung/path_files.hpp"
#include "machines/kung/plan_feed.hpp"
#include "machines/kung/plan_parts.hpp"
#include "machines/kung/plan_precision.hpp"
#include "machines/kung/words.hpp"
#include "models/exact/drive/carrier.hpp"
#include "models/plant/ad7476.hpp"
#include "models/plant/spans.hpp"

namespace trammel::kung {
namespace {

constexpr int kMaxTicks = static_cast<int>(sw::kMaxTicks);
constexpr int kMaxStrokeCounts = 130000;  // the model's integrator holds 131071 (section 3)
constexpr double kLeastTurnCounts = 16;
constexpr int kInterpolated = 4;  // position samples in which the chip reaches a point
constexpr std::array<std::uint32_t, 3> kPositionHz{1000, 2000, 4000};  // by RATES.position

// Interrupts for a stretch of that length: enough to stay below the maximum feed.
std::uint32_t ticks_word(const std::string& key, int ticks, double length_m, double point_s,
                         const Encoder& encoder) {
  const double feed = encoder.max_feed_m_s();
  in_range(key, ticks, std::max(1.0, std::ceil(length_m / (feed * point_s) - 1e-9)), kMaxTicks,
           fmt::format("{:g} m, an interrupt each {:g} s (chip.irq_period_ticks), {}", length_m,
                       point_s, feed_text(encoder)));
  return word(ticks);
}

sw::Window::Setup plan_window(const PathOptions& p, double point_s, const Encoder& encoder) {
  in_range("path.window_radius_m", p.window_radius_m, encoder.count_m,
           p.window_side_m / 2 - encoder.count_m, "the straight parts need some length");
  const double half_stroke_m = p.window_side_m / 2 - p.window_radius_m;
  in_range("path.window_step_m", p.window_step_m, half_stroke_m / kMaxTicks,
           std::min(encoder.max_feed_m_s() * point_s, half_stroke_m),
           feed_text(encoder));
  // The step is adjusted so that every part takes whole ticks.
  const double ticks = std::max(1.0, std::round(half_stroke_m / p.window_step_m));
  return {encoder.q32(p.window_center_x_m, p.window_center_y_m), encoder.q32(p.window_side_m / 2),
          encoder.q32(p.window_radius_m), static_cast<std::uint32_t>(ticks),
          ticks_word("path.window_arc_ticks", p.window_arc_ticks, kPi / 2 * p.window_radius_m,
                     point_s, encoder)};
}

void plan_points(const PathOptions& p, const Encoder& encoder, std::vector<sw::Point>& points) {
  in_range("path.points_file: number of points", static_cast<double>(p.points.size()), 1,
           kMaxTicks);
  points.clear();
  for (const PointM& point : p.points) {
    points.push_back({encoder.counts(point.x_m), encoder.counts(point.y_m)});
  }
  if (!(points.front() == points.back())) {
    in_range("path.repeats", p.repeats, 1, 1, "the points do not end where they begin");
  }
}

sw::PathSetup plan_path(const Options& options, const Encoder& encoder,
                        PathStore& store) {
  const PathOptions& p = options.path;
  if (feeds(p)) return plan_feed(options, store.feed);
  const int irq_period_ticks = options.chip.irq_period_ticks;
  const double point_s = ticks_per_point(p, irq_period_ticks) * encoder.sample_s;
  const auto ticks = [point_s, &encoder](const char* key, int value, double length_m) {
    return ticks_word(key, value, length_m, point_s, encoder);
  };
  const auto q32 = [&encoder](auto... metres) { return encoder.q32(metres...); };
  const auto counts = [&encoder](double metres) { return encoder.counts(metres); };
  sw::PathSetup s;
  s.path = p.kind;
  switch (p.kind) {
    case PathKind::kCircle:
      s.circle = {q32(p.circle_center_x_m, p.circle_center_y_m), q32(p.circle_radius_m),
                  ticks("path.circle_ticks", p.circle_ticks, 2 * kPi * p.circle_radius_m)};
      break;
    case PathKind::kWindow: s.window = plan_window(p, point_s, encoder); break;
    case PathKind::kStar:
      s.star.start = q32(p.star_start_x_m, p.star_start_y_m);
      s.star.edge = q32(p.star_edge_m);
      s.star.stroke_ticks = ticks("path.star_stroke_ticks", p.star_stroke_ticks, p.star_edge_m);
      break;
    case PathKind::kSquare:
      require_step(p);
      s.square = {{counts(p.square_low_m), counts(p.square_low_m)},
                  {counts(p.square_high_m), counts(p.square_high_m)},
                  word(p.square_half_samples)};
      break;
    case PathKind::kLine:
      s.line = {q32(p.line_start_x_m, p.line_start_y_m), q32(p.line_end_x_m, p.line_end_y_m),
                ticks("path.line_ticks", p.line_ticks,
                      std::hypot(p.line_end_x_m - p.line_start_x_m,
                                 p.line_end_y_m - p.line_start_y_m))};
      break;
    case PathKind::kPoints:
      plan_points(p, encoder, store.points);
      s.points = store.points.data();
      s.n_points = static_cast<std::uint32_t>(store.points.size());
      break;
    case PathKind::kSweep: s.sweep = plan_sweep(options, encoder); break;
    case PathKind::kFeed: break;  // G-code, which the feed profile drives
  }
  const bool square = p.kind == PathKind::kSquare;
  const int repeats = square ? p.square_periods : p.repeats;
  in_range(square ? "path.square_periods" : "path.repeats", repeats, 1,
           std::floor(kMaxPoints / sw::Trajectory(s).size()));
  s.repeats = word(repeats);
  return s;
}

sw::Gain gain(const std::string& key, double value, double unit = 1,
              const std::string& reason = "") {
  in_range(key, value, 0, 63.9 / unit, reason);
  const fixed::Gain g = gain_word(value * unit);
  return {g.mant, g.exp};
}

// The index of that rate in a field of RATES.
template <std::size_t N>
std::uint32_t nearest_rate(const char* key, int value, const std::array<std::uint32_t, N>& rates) {
  std::uint32_t best = 0;
  const auto away = [&](std::uint32_t n) { return std::abs(value - static_cast<int>(rates[n])); };
  for (std::uint32_t n = 1; n < N; ++n) {
    if (away(n) < away(best)) best = n;
  }
  require(away(best) == 0,
          fmt::format("{}: value {} is no rate of the chip; the nearest is {}, a whole number of "
                      "clocks and of position samples", key, value, rates[best]));
  return best;
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

std::uint32_t clocks(int ns, std::int64_t clock_ps) {
  return static_cast<std::uint32_t>((std::int64_t{1000} * ns + clock_ps - 1) / clock_ps);
}

// The whole path must lie within the hard stops and the stroke of the chip, which lies within the
// range of the reference model.
void check_extent(const Options& options, const sw::PathSetup& setup) {
  sw::PathSetup once = setup;  // every pass has the same bounds
  once.repeats = 1;
  sw::Trajectory path(once);
  sw::Point low = path.start();
  sw::Point high = low;
  for (std::uint32_t n = path.size(); n > 0; --n) {
    const sw::Point p = path.next();
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::int32_t lows[] = {low.x, low.y};
  const std::int32_t highs[] = {high.x, high.y};
  for (std::size_t a = 0; a < 2; ++a) {
    const char axis = a == 0 ? 'x' : 'y';
    const plant::AxisConfig& plant = options.plant.axis[a];
    const Encoder encoder{plant.encoder_count_m, options.chip.sample_s()};
    const auto inside = [&](double from_m, double to_m, const std::string& what) {
      require(lows[a] >= encoder.counts(from_m) && highs[a] <= encoder.counts(to_m),
              fmt::format("path: {} runs from {:g} to {:g} m, beyond {} = {:g}..{:g}", axis,
                          lows[a] * encoder.count_m, highs[a] * encoder.count_m, what, from_m,
                          to_m));
    };
    const AxisChip& chip = options.chip.axis[a];
    if (plant.hard_stops) {
      inside(plant.stroke_min_m, plant.stroke_max_m,
             fmt::format("the hard stops plant.{}.stroke_min_m..stroke_max_m", axis));
    }
    inside(chip.stroke_min_m, chip.stroke_max_m,
           fmt::format("chip.{}.stroke_min_m..stroke_max_m", axis));
  }
}

}  // namespace

int ticks_per_point(const PathOptions& path, int irq_period_ticks) {
  const bool steps = path.kind == PathKind::kSquare && !feeds(path);
  return steps || path.kind == PathKind::kSweep ? 1 : irq_period_ticks;
}

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
  const int held = ticks_per_point(options.path, options.chip.irq_period_ticks);
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

sw::KungSetup plan_firmware(const Options& given, PathStore& store) {
  Options options = given;
  choose_profile(options);
  const ChipOptions& chip = options.chip;
  sw::KungSetup s;
  s.carrier = nearest_rate("chip.carrier_Hz", chip.carrier_Hz, exact::kCarrierHz);
  s.position_rate = nearest_rate("chip.position_Hz", chip.position_Hz, kPositionHz);
  const double count_m = options.plant.axis[0].encoder_count_m;
  require(count_m == options.plant.axis[1].encoder_count_m,
          fmt::format("plant.y.encoder_count_m: value {:g} must equal plant.x.encoder_count_m = "
                      "{:g}: the processor draws the path in counts",
                      options.plant.axis[1].encoder_count_m, count_m));
  static_cast<sw::PathSetup&>(s) =
      plan_path(options, Encoder{count_m, chip.sample_s()}, store);
  require(options.cpu == Cpu::kNative || !options.fault.of_processor(),
          "inject.fault: those of the processor and its bus need run.cpu = \"native\"; "
          "inject.processor_s is a fault of the core");
  s.current_command = options.path.open_position();
  for (std::size_t a = 0; a < 2; ++a) s.axis[a] = plan_axis(options, a);
  s.irq_period = word(ticks_per_point(options.path, chip.irq_period_ticks));
  s.watchdog_ticks = word(chip.watchdog_ticks);
  if (s.watchdog_ticks != 0) {
    in_range("chip.watchdog_ticks", s.watchdog_ticks, s.irq_period + 1, 65535,
             "or 0; COMMITs come once per chip.irq_period_ticks");
  }
  const double full_scale_A = options.plant.axis[0].current_full_scale_a;
  require(full_scale_A == options.plant.axis[1].current_full_scale_a,
          fmt::format("plant.y.current_full_scale_A: value {:g} must equal "
                      "plant.x.current_full_scale_A = {:g}: CURRENT_LIMIT is that of both axes",
                      options.plant.axis[1].current_full_scale_a, full_scale_A));
  const double lsb_A = current_lsb_A(full_scale_A);
  in_range("chip.current_limit_A", chip.current_limit_A, lsb_A, 2047 * lsb_A,
           fmt::format("at plant.x.current_full_scale_A = {:g}", full_scale_A));
  s.current_limit = static_cast<std::uint32_t>(std::lround(chip.current_limit_A / lsb_A));
  s.offset_samples = word(chip.offset_samples);
  s.following_limit = static_cast<std::int32_t>(
      std::ceil(chip.following_error_m / options.plant.axis[0].encoder_count_m));
  if (chip.d_current_A != 0) {
    in_range("chip.d_current_A", chip.d_current_A, lsb_A, 2047 * lsb_A,
             fmt::format("or 0, at plant.x.current_full_scale_A = {:g}", full_scale_A));
  }
  s.d_current_limit = static_cast<std::int32_t>(std::lround(chip.d_current_A / lsb_A));
  s.dead_time_min = clocks(chip.dead_time_min_ns, options.run.clock_ps);
  check_extent(options, s);
  check_sweep(options);
  s.precision = plan_precision(options, s);
  return s;
}

void validate(lab::Settings& settings) {
  auto& options = static_cast<Options&>(settings);
  PathStore store;
  choose_profile(options);
  try {
    read_path_files(options);
    plan_firmware(options, store);
    check_cpu(options);
  } catch (const std::invalid_argument& error) {
    throw host::ConfigError(error.what());
  }
}

}  // namespace trammel::kung
