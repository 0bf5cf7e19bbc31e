// SPDX-License-Identifier: Apache-2.0
#include "models/plant/pmsm_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "models/plant/root.hpp"
#include "models/plant/spans.hpp"

namespace trammel::plant {
namespace {

constexpr double kSegment = 6.25e-6;  // [s] span of one series, whatever the motor
constexpr double kTurn = 0.0124;      // the same in time constants or radians: kTurn^4/24 is 1e-9
constexpr double kPoles = 0.025;      // [rad] the same where that needs less than kSegment
constexpr double kGap = 3.125e-6;     // [s] the same with a leg off: dead times are shorter
constexpr double kHorizon = 62.5e-6;  // [s] look-ahead, at whose end the axis is committed
constexpr double kAhead = 1e-6;       // [s] an event that is nearer is searched for
constexpr double kShortest = 1e-9;    // [s] keeps a chain of events finite
constexpr std::array<AlphaBeta, 3> kPhase{AlphaBeta{1, 0}, AlphaBeta{-0.5, 0.86602540378443865},
                                          AlphaBeta{-0.5, -0.86602540378443865}};

double dot(const AlphaBeta& a, const AlphaBeta& b) { return a.alpha * b.alpha + a.beta * b.beta; }

// The sum of the currents of some legs is that of one leg with a sign: the sum of all three is 0.
constexpr std::array<std::uint8_t, 8> kLegOf{0, 0, 1, 2, 2, 1, 0, 0};
constexpr std::array<double, 8> kSignOf{0, 1, 1, -1, 1, -1, -1, 0};

// Slow motors allow longer spans; but a switch's drop has one sign for all of a span.
double longest_span(const PmsmAxisConfig& c) {
  double longest = c.longest_span;
  if (c.inverter.switch_drop != 0 || c.inverter.diode_drop != 0) {
    longest = std::min(longest, kSegment);
  }
  const MotorRates motor(c.motor);
  const double rate = std::max({motor.winding, motor.thrust, motor.viscous, motor.cogging,
                                2 * kPi * c.motor.mode_frequency});
  const double usual = std::min(kSegment, longest);
  return std::min(motor.span(), std::clamp(kTurn / rate, usual, longest));
}

InverterConfig fed_by(const DcLinkConfig& link, InverterConfig inverter) {
  inverter.dc_link = link.source;
  return inverter;
}

}  // namespace

PmsmAxis::PmsmAxis(const PmsmAxisConfig& config, double period_s)
    : period_(period_s),
      horizon_(static_cast<Clk>(kHorizon / period_s)),
      ahead_(static_cast<Clk>(kAhead / period_s)),
      mount_(config.mount),
      external_force_(config.motor.external_force),
      source_(config.link.source),
      motor_(config.motor),
      segment_(longest_span(config)),
      bend_(config.motor.resistance *
            (1 / config.motor.inductance_d + 1 / config.motor.inductance_q) / 24),
      rest_(4 * std::max(config.motor.friction_speed,
                         config.motor.stribeck == 0 ? 0 : config.motor.stribeck_speed)),
      waves_(motor_.angular_speed(config.motor.harmonic_force != 0 ? 2 * config.motor.harmonic
                                                                   : 2)),
      inverter_(fed_by(config.link, config.inverter)),
      link_(config.link),
      sensors_{CurrentSensor(config.sensors[0]), CurrentSensor(config.sensors[1])},
      encoder_(config.encoder, config.mount.start),
      braked_(config.mount.brake || config.mount.locked) {
  if (!(period_s > 0 && period_s <= kSegment)) throw std::invalid_argument("clock period");
  if (!(segment_ >= kShortestSpan)) throw std::invalid_argument("axis: too fast for its spans");
  if (mount_.load != 0) {
    constexpr Clk kNever = std::numeric_limits<Clk>::max();
    const auto edge = [period_s](double t) { return static_cast<Clk>(std::llround(t / period_s)); };
    load_begin_ = edge(mount_.load_begin);
    load_end_ = mount_.load_end == 0 ? kNever : edge(mount_.load_end);
  }
  load(0);
  const MotorState rest{mount_.start, 0, 0, 0, 0, 0};
  begin({rest, motor_.angle(rest.x)}, 7);
  look_ahead(0);
}

double PmsmAxis::phase_current(const Span& f, double t, std::size_t leg) const {
  const SinCos a = motor_.angle_at(f, f.position(t));
  const AlphaBeta i = Pmlsm::stator(Span::cubic(f.i_d, t), Span::cubic(f.i_q, t), a);
  return dot(i, kPhase[leg]);
}

// Motor state t seconds into a segment, with the currents of the legs in `zero` exactly removed.
PmsmAxis::Point PmsmAxis::point(const Segment& s, double t, unsigned zero) const {
  Point p{s.span.at(t), {}};
  p.angle = motor_.angle_at(s.span, p.motor.x);
  if (zero == 0) return p;
  if ((zero & (zero - 1)) != 0) {  // two currents are zero: all are
    p.motor.i_d = p.motor.i_q = 0;
    return p;
  }
  const AlphaBeta& n = kPhase[zero == 1 ? 0 : zero == 2 ? 1 : 2];
  const double d = n.alpha * p.angle.cos + n.beta * p.angle.sin;
  const double q = n.beta * p.angle.cos - n.alpha * p.angle.sin;
  const double along = d * p.motor.i_d + q * p.motor.i_q;
  p.motor.i_d -= along * d;
  p.motor.i_q -= along * q;
  return p;
}

void PmsmAxis::begin(const Point& p, unsigned zero) {
  if (chain_.empty()) chain_.emplace_back();
  build(chain_[0], 0, p, zero);
  known_ = 1;
}

// Of a span from state m: short where friction may turn over, the magnets' forces change fast, or
// the poles pass fast.
double PmsmAxis::length(const MotorState& m) const {
  const double v = std::fabs(m.v), turning = motor_.angular_speed(v);
  if (turning * kSegment > kPoles) {
    return std::min(segment_, std::max(kShortestSpan, kPoles / turning));
  }
  if (segment_ <= kSegment) return segment_;
  if (v < rest_ + std::fabs(motor_.force(m)) / motor_.config().mass * segment_) return kSegment;
  return waves_ * v * segment_ > kTurn ? std::max(kSegment, kTurn / (waves_ * v)) : segment_;
}

// Writes every member of s.
void PmsmAxis::build(Segment& s, double start, const Point& at, unsigned zero) const {
  s.start = start;
  s.length = length(at.motor);
  s.held = s.meets_stop = false;
  s.dies = 0;
  s.stop = 0;
  Point p = at;
  if (braked_) {
    motor_.halt(p.motor);
    s.held = true;
  } else if (mount_.hard_stops) {
    const bool low = p.motor.x <= mount_.stroke_min && p.motor.v <= 0;
    const bool high = p.motor.x >= mount_.stroke_max && p.motor.v >= 0;
    if (low || high) {
      motor_.halt(p.motor);
      const double push = motor_.push(p.motor);
      s.held = low ? push <= 0 : push >= 0;
    }
  }
  const std::array<double, 3> current = to_phases(Pmlsm::stator(p.motor.i_d, p.motor.i_q, p.angle));
  s.current = current;
  const bool some_off =
      opened_ != 0 || both_off(gates_, 0) || both_off(gates_, 1) || both_off(gates_, 2);
  if (some_off) s.length = std::min(s.length, kGap);
  const std::array<double, 3> emf =
      some_off ? to_phases(motor_.emf(p.motor, p.angle)) : std::array<double, 3>{};
  const auto keep_zero = [&](std::size_t leg, std::array<double, 3> volt) {
    volt[leg] = 0;
    const AlphaBeta slope = motor_.current_slope(p.motor, p.angle, clarke(volt));
    const double per_volt = motor_.slope_per_volt(p.angle, kPhase[leg]) * (2.0 / 3);
    return -dot(slope, kPhase[leg]) / per_volt;
  };
  s.legs = inverter_.resolve(gates_, current, zero, emf, keep_zero, opened_);
  motor_.span(s.span, p.motor, p.angle, clarke(s.legs.volt), {s.held, s.legs.open});
  if (some_off && !s.legs.open) end_at_dead_current(s, current);
  if (mount_.hard_stops && !s.held) end_at_stop(s);
}

// Ends the segment where the current of a diode dies out. What begins above all that the currents
// can change by, in the rotating and in the stator's frame, needs no search.
void PmsmAxis::end_at_dead_current(Segment& s, const std::array<double, 3>& current) const {
  const double length = s.length, turn = motor_.turn_bound(s.span, length);
  const auto most = [length](const std::array<double, 4>& c) {
    return length * (std::fabs(c[1]) + length * (std::fabs(c[2]) + length * std::fabs(c[3])));
  };
  const double d = most(s.span.i_d), q = most(s.span.i_q);
  const double before = std::fabs(s.span.i_d[0]) + std::fabs(s.span.i_q[0]);
  const double change = d + q + turn * (d + q + before);
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const int sign = s.legs.diode[leg];
    if (sign == 0 || std::fabs(current[leg]) > change) continue;
    const auto flow = [&](double t) { return sign * phase_current(s.span, t, leg); };
    if (flow(s.length) > 0) continue;
    if (flow(0) > 0) {
      const double t = std::max(root(flow, s.length), kShortest);
      if (t < s.length) {
        s.length = t;
        s.dies = 0;
      }
    }
    s.dies |= 1u << leg;
  }
}

void PmsmAxis::end_at_stop(Segment& s) const {
  const double x_end = s.span.position(s.length);
  for (const bool high : {false, true}) {
    const double stop = high ? mount_.stroke_max : mount_.stroke_min;
    const auto room = [&](double t) {
      return high ? stop - s.span.position(t) : s.span.position(t) - stop;
    };
    if ((high ? stop - x_end : x_end - stop) >= 0 || room(0) <= 0) continue;
    s.length = std::max(root(room, s.length), kShortest);
    s.meets_stop = true;
    s.stop = stop;
    s.dies = 0;
    return;
  }
}

const PmsmAxis::Segment& PmsmAxis::successor(std::size_t k) const {
  if (k + 1 < known_) return chain_[k + 1];
  if (k + 1 == chain_.size()) chain_.emplace_back();
  const Segment& s = chain_[k];
  const unsigned zero = s.legs.open ? 7u : s.legs.floating | s.dies;
  Point p = point(s, s.length, zero);
  if (s.meets_stop) p.motor.x = s.stop;
  if (s.meets_stop || s.held) motor_.halt(p.motor);
  build(chain_[k + 1], s.start + s.length, p, zero);
  known_ = k + 2;
  return chain_[k + 1];
}

// Valid until the next call.
const PmsmAxis::Segment& PmsmAxis::segment_at(double t) const {
  std::size_t k = 0;
  const Segment* s = &chain_[0];
  while (t > s->start + s->length) s = &successor(k++);
  return *s;
}

// What the legs have drawn from the upper rail t seconds after the last commit [C], by Simpson's
// rule over each segment.
double PmsmAxis::link_charge(double t) const {
  double sum = 0;
  for (std::size_t k = 0; k < known_ && chain_[k].start < t; ++k) {
    const Segment& s = chain_[k];
    if (s.legs.open) continue;
    const double length = std::min(s.length, t - s.start);
    for (std::size_t leg = 0; leg < 3; ++leg) {
      if (((s.legs.upper >> leg) & 1u) == 0) continue;
      sum += length / 6 * (phase_current(s.span, 0, leg) +
                           4 * phase_current(s.span, 0.5 * length, leg) +
                           phase_current(s.span, length, leg));
    }
  }
  return sum;
}

void PmsmAxis::commit(Clk n, unsigned gates) {
  if (early_ && n >= next_) {
    early_ = false;
    next_ = until_load(anchor_, predict());
    if (n < next_ && gates == gates_) return;
  }
  const bool own = n >= next_;
  const double t = seconds(n - anchor_);
  const Segment& s = segment_at(t);
  const unsigned zero = s.legs.open ? 7u : s.legs.floating | opened_;
  Point p = point(s, t - s.start, zero);
  if (own) p.angle = motor_.angle(p.motor.x);  // anew, or rounding would add up
  // Only the axis' own event moves the lines, so that a change of the drive never does so unseen.
  if (own) encoder_.follow(p.motor.x);
  if (!link_.stiff()) {
    link_.draw(link_charge(t), t);
    inverter_.set_dc_link(link_.volt());
  } else {
    charge_ += charge(s, t, p);
  }
  anchor_ = n;
  gates_ = gates;
  braked_ = braked_ && (gates == 0 || mount_.locked);
  shoot_through_ = shoot_through_ || plant::shoot_through(gates);
  load(n);
  begin(p, zero);
  look_ahead(n);
}

// [C] that a stiff link gives until t, at point p of segment s: by the trapezoidal rule, corrected
// for a decay by R/L. Unlike link_charge() it needs no current between the ends of a segment.
double PmsmAxis::charge(const Segment& s, double t, const Point& p) const {
  double sum = 0;
  for (const Segment* one = &chain_[0];; ++one) {
    const bool last = one == &s;
    const unsigned upper = one->legs.upper;
    if (upper != 0 && upper != 7) {
      const std::size_t leg = kLegOf[upper];
      const double length = last ? t - one->start : one->length, from = one->current[leg];
      const double to = last ? dot(Pmlsm::stator(p.motor.i_d, p.motor.i_q, p.angle), kPhase[leg])
                             : (one + 1)->current[leg];
      sum += kSignOf[upper] * length * (0.5 * (from + to) + bend_ * length * (to - from));
    }
    if (last) return sum;
  }
}

double PmsmAxis::supplied(Clk n) const {
  const double t = seconds(n - anchor_);
  segment_at(t);
  const double charge = link_charge(t);
  if (link_.stiff()) return supplied_ + link_.volt() * (charge_ + charge);
  DcLink link = link_;
  link.draw(charge, t);
  return link.supplied();
}

void PmsmAxis::open_phase(Clk n, int phase, bool open) {
  const unsigned bit = 1u << phase;
  opened_ = open ? opened_ | bit : opened_ & ~bit;
  commit(n, gates_);
}

void PmsmAxis::supply(Clk n, double share) {
  const double before = link_.volt();
  link_.set_source(share * source_);
  inverter_.set_dc_link(link_.volt());
  safe_ = n;  // the bound was that of another voltage
  commit(n, gates_);
  supplied_ += before * charge_;
  charge_ = 0;
}

void PmsmAxis::load(Clk n) {
  const bool loaded = n >= load_begin_ && n < load_end_;
  motor_.set_external_force(external_force_ + (loaded ? mount_.load : 0));
  if (n == load_begin_ || n == load_end_) safe_ = n;  // the bound was that of another force
}

PmsmState PmsmAxis::motion(Clk n) const {
  const double t = seconds(n - anchor_);
  const Segment& s = segment_at(t);
  const Point p = point(s, t - s.start, s.legs.open ? 7u : s.legs.floating);
  const std::array<double, 3> i = to_phases(Pmlsm::stator(p.motor.i_d, p.motor.i_q, p.angle));
  return {p.motor, i[0], i[1], motor_.force(p.motor), link_.volt()};
}

double PmsmAxis::position(Clk n) const {
  const double t = seconds(n - anchor_);
  const Segment& s = segment_at(t);
  return s.span.position(t - s.start);
}

int PmsmAxis::code(int phase, std::uint64_t seed, int channel, Clk n) const {
  const PmsmState s = motion(n);
  return sensors_[static_cast<std::size_t>(phase)].code(phase == 0 ? s.i_a : s.i_b, seed, channel,
                                                        n);
}

}  // namespace trammel::plant
