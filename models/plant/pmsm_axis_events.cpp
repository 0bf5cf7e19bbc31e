// SPDX-License-Identifier: Apache-2.0
//
// When an axis' next event is: the encoder's next edge, or the carriage at a stop.
#include <algorithm>
#include <cmath>

#include "models/plant/pmsm_axis.hpp"
#include "models/plant/root.hpp"

namespace trammel::plant {
// An event that is far away is not searched for: a bound says how far it is at least, for as many
// commits as it holds.
void PmsmAxis::look_ahead(Clk n) {
  if (safe_ - n < ahead_ || !link_.stiff()) safe_ = n + safe_clocks();
  early_ = safe_ - n >= ahead_ && safe_ < n + horizon_;
  next_ = until_load(n, early_ ? safe_ : safe_ >= n + horizon_ ? n + horizon_ : predict());
}

Clk PmsmAxis::until_load(Clk n, Clk due) const {
  return n < load_begin_ ? std::min(due, load_begin_)
         : n < load_end_ ? std::min(due, load_end_)
                         : due;
}

// How many clocks from the last commit on no edge and no stop can be reached, whatever the inverter
// does: acceleration is bounded.
Clk PmsmAxis::safe_clocks() const {
  const Segment& s = chain_[0];
  const MotorState m{s.span.x[0],   s.span.v[0], s.span.i_d[0],
                     s.span.i_q[0], s.span.y[0], s.span.y_speed[0]};
  double up = encoder_.high() - m.x, down = m.x - encoder_.low();
  if (mount_.hard_stops) {
    if (!s.held || m.x < mount_.stroke_max) up = std::min(up, mount_.stroke_max - m.x);
    if (!s.held || m.x > mount_.stroke_min) down = std::min(down, m.x - mount_.stroke_min);
  }
  if (!(up > 0 && down > 0)) return 0;
  const double time = seconds(horizon_);
  const double volt = inverter_.config().dc_link + inverter_.config().diode_drop;
  const double a = motor_.acceleration_bound(m, volt, time);
  // room = v t + a t^2/2
  const double v = std::fabs(m.v), ahead = m.v > 0 ? up : down, behind = m.v > 0 ? down : up;
  if (a * time > motor_.config().speed_room) return 0;
  const double t = std::min({time, 2 * ahead / (v + std::sqrt(v * v + 2 * a * ahead)),
                             (v + std::sqrt(v * v + 2 * a * behind)) / a});
  return t < time ? static_cast<Clk>(t / period_) - 1 : horizon_;
}

// No edge and no stop can be reached within `time`, whatever the inverter does.
bool PmsmAxis::far_from_events(const Segment& s, double time) const {
  const MotorState m{s.span.x[0],   s.span.v[0], s.span.i_d[0],
                     s.span.i_q[0], s.span.y[0], s.span.y_speed[0]};
  double room = std::min(encoder_.high() - m.x, m.x - encoder_.low());
  if (mount_.hard_stops && !s.held) {
    room = std::min({room, m.x - mount_.stroke_min, mount_.stroke_max - m.x});
  }
  const double speed = std::fabs(m.v);
  if (speed * time >= room) return false;
  const double volt = inverter_.config().dc_link + inverter_.config().diode_drop;
  const double a = motor_.acceleration_bound(m, volt, time);
  return a * time <= motor_.config().speed_room && (speed + a * time) * time < room;
}

Clk PmsmAxis::predict() const {
  Clk from = 1;
  for (std::size_t k = 0;; ++k) {
    const Segment& s = k == 0 ? chain_[0] : successor(k - 1);
    if (far_from_events(s, seconds(horizon_) - s.start)) return anchor_ + horizon_;
    const double end = s.start + s.length;
    Clk to = std::min(horizon_, static_cast<Clk>(end / period_) + 1);
    while (to >= from && seconds(to) > end) --to;
    const Clk edge = to >= from ? first_edge(s, from, to) : kNoEdge;
    if (edge != kNoEdge) return anchor_ + edge;
    if (to >= horizon_) return anchor_ + horizon_;
    if (s.meets_stop) return anchor_ + std::max(to, from - 1) + 1;
    from = std::max(from, to + 1);
  }
}

// First clock in [from, to] of a segment at which the position is outside the encoder's count.
Clk PmsmAxis::first_edge(const Segment& s, Clk from, Clk to) const {
  const double t_0 = seconds(from - 1) - s.start;
  const double t_1 = seconds(to) - s.start;
  if ((s.span.speed(t_0) > 0) != (s.span.speed(t_1) > 0) && to > from) {
    // The carriage reverses: the extreme position may lie in between.
    const double turn =
        t_0 + root([&](double t) { return s.span.speed(t_0 + t); }, t_1 - t_0) + s.start;
    const Clk m = std::clamp(static_cast<Clk>(turn / period_), from, to - 1);
    if (outside(s, m)) return search(s, from - 1, m);
    if (outside(s, m + 1)) return m + 1;
    return outside(s, to) ? search(s, m + 1, to) : kNoEdge;
  }
  return outside(s, to) ? search(s, from - 1, to) : kNoEdge;
}

// First outside clock in (in, out], the position being monotonic: regula falsi, then halving.
Clk PmsmAxis::search(const Segment& s, Clk in, Clk out) const {
  const auto at = [&](Clk m) { return s.span.position(seconds(m) - s.start); };
  const double x_out = at(out);
  const double edge = x_out >= encoder_.high() ? encoder_.high() : encoder_.low();
  double gap_in = at(in) - edge, gap_out = x_out - edge;
  for (int k = 0; out - in > 1; ++k) {
    Clk m = (in + out) / 2;
    if (k < 4 && gap_out != gap_in) {
      const double guess = gap_in / (gap_in - gap_out) * static_cast<double>(out - in);
      const Clk step = guess >= 1 ? static_cast<Clk>(std::fmin(guess, 1e9)) : 0;
      m = std::clamp(in + step + (k & 1), in + 1, out - 1);
    }
    if (outside(s, m)) {
      out = m;
      gap_out = at(m) - edge;
    } else {
      in = m;
      gap_in = at(m) - edge;
    }
  }
  return out;
}

}  // namespace trammel::plant
