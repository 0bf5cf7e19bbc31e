// SPDX-License-Identifier: Apache-2.0
//
// The feed profile in double precision (docs/precision.md, "Feed profile"): the command at any time
// in closed form. A chain of moves begins and ends at rest. Along it the speed is a list of phases
// of constant acceleration, S(t) its integral, and the command the place of the path at the mean of
// N values S(t - i h), h the time of a point. Lengths in metres, times in seconds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "models/ideal/moves.hpp"

namespace trammel::ideal {

class FeedProfile {
 public:
  struct Limits {
    double accel_x = 8, accel_y = 8;  // [m/s^2]
    int mean = 8;                     // N
    double period = 2e-3;             // h [s]
  };
  struct Command {
    Place p, v, a;  // [m], [m/s], [m/s^2]
  };

  static constexpr int kRest = 2;  // points behind the last: the set point is two knots late

  // `laps`: of a path that ends where it begins.
  FeedProfile(const Moves& moves, const Limits& limits, int laps = 1)
      : lim_(limits), laps_(laps), start_(moves.start) {
    begin_ = dwell_ticks(moves.start_dwell);
    for (const Move& m : moves.moves) segments_.push_back(segment(m));
    std::size_t first = 0;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      if (k + 1 < segments_.size() && !stops(k)) continue;
      chain(first, k + 1);
      first = k + 1;
    }
  }

  std::size_t points() const { return static_cast<std::size_t>(begin_ + laps_ * lap()) + kRest; }
  double seconds() const { return static_cast<double>(begin_ + laps_ * lap()) * lim_.period; }
  // Points at which chain after chain begins.
  std::vector<std::size_t> chain_begins() const {
    std::vector<std::size_t> all;
    for (const Chain& c : chains_) all.push_back(static_cast<std::size_t>(c.begin));
    return all;
  }

  // At t seconds after point 0.
  Command at(double t) const {
    Command c;
    c.p = start_;
    const double first = static_cast<double>(begin_), last = static_cast<double>(laps_ * lap());
    // The lap that it is in; behind the last one that goes on.
    const double n = std::min(t / lim_.period - first, last);
    if (n < 0) return c;
    const auto lap_points = static_cast<double>(lap());
    const double done = std::min(std::floor(n / lap_points), laps_ - 1.0) * lap_points;
    t -= (first + done) * lim_.period;
    const Chain* now = nullptr;
    for (std::size_t lo = 0, hi = chains_.size(); lo < hi;) {
      const std::size_t mid = (lo + hi) / 2;
      if (static_cast<double>(chains_[mid].begin) > n - done) {
        hi = mid;
      } else {
        now = &chains_[mid];
        lo = mid + 1;
      }
    }
    if (now == nullptr) return c;
    double s = 0, v = 0, a = 0;
    for (int i = 0; i < lim_.mean; ++i) {
      const double since = t - (static_cast<double>(now->begin) + i) * lim_.period;
      const Along along = path_length(*now, since);
      s += along.s / lim_.mean;
      v += along.v / lim_.mean;
      a += along.a / lim_.mean;
    }
    return place(*now, s, v, a);
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  static constexpr double kShare = 0.7;          // of A along an arc, across it, near a corner
  static constexpr double kTurn = 0.5;           // of A: half the change of speed in a corner
  static constexpr double kCorner = 1.5;         // points that see a corner's turn
  static constexpr double kFull = 2 * kShare / kCorner;  // of A: largest turn, with that of an arc
  static constexpr double kHalf = 0.35;          // of A: along the path where a corner takes kFull
  static constexpr double kSwing = 12;           // points up, and down, between two corners
  static constexpr double kStraight = 0.005;     // of A: a turn that leaves all of it
  static constexpr double kDegree = 0.01745329251994329577;
  static constexpr double kExact = 1;            // [deg] corners below it are passed in any mode
  static constexpr double kBack = 1 - 1.0 / (1 << 30);  // sine of half a turn back, 0.005 deg off
  static constexpr double kSlow = 1024;          // of the segments' speed: a corner that is a stop
  static constexpr double kLate = 1.0 / 1024;    // [points] by which a chain may end late

  struct Segment {
    Move m;
    double length, accel, speed, curvature;
    Place in, out;    // unit vectors along it at its ends
    double from = 0;  // path of its chain until it begins
  };
  struct Phase {
    double t, s, v, a;  // at its beginning
  };
  struct Piece {
    double length, speed, accel;
    bool free;  // of the zones of corners
  };
  struct Chain {
    long begin = 0, ticks = 0;  // [points]
    std::size_t first = 0, last = 0;  // segments [first, last)
    double length = 0;
    std::vector<Phase> phases;  // the last one is rest
  };
  struct Along {
    double s, v, a;
  };
  struct Corner {
    double speed, accel;
  };

  double least_accel() const { return std::min(lim_.accel_x, lim_.accel_y); }
  long lap() const { return chains_.empty() ? 1 : chains_.back().begin + chains_.back().ticks; }
  long dwell_ticks(double seconds) const {
    return static_cast<long>(std::ceil(seconds / lim_.period - kLate));
  }

  Segment segment(const Move& m) const {
    Segment g{m, m.length(), 0, m.feed, 0, {}, {}, 0};
    if (m.kind == Move::Kind::kLine) {
      g.in = g.out = {(m.to.x - m.from.x) / g.length, (m.to.y - m.from.y) / g.length};
      const auto share = [](double limit, double t) {
        return t == 0 ? kNone : limit / std::abs(t);
      };
      g.accel = std::min(share(lim_.accel_x, g.in.x), share(lim_.accel_y, g.in.y));
    } else {
      const double r = m.radius(), sign = m.sweep > 0 ? 1 : -1;
      const double angle = std::atan2(m.from.y - m.center.y, m.from.x - m.center.x);
      g.in = {-sign * std::sin(angle), sign * std::cos(angle)};
      g.out = {-sign * std::sin(angle + m.sweep), sign * std::cos(angle + m.sweep)};
      g.accel = kShare * least_accel();
      g.speed = std::min(g.speed, std::sqrt(g.accel * r));
      g.curvature = 1 / r;
    }
    return g;
  }

  // Sine of half the angle between segment k and the next.
  double half_sine(std::size_t k) const {
    const Place a = segments_[k].out, b = segments_[k + 1].in;
    return std::min(1.0, std::hypot(b.x - a.x, b.y - a.y) / 2);
  }

  bool stops(std::size_t k) const {
    const Move& m = segments_[k].m;
    if (m.stop) return true;
    if (half_sine(k) > (m.exact ? std::sin(kExact / 2 * kDegree) : kBack)) return true;
    return corner(k).speed < std::min(segments_[k].speed, segments_[k + 1].speed) / kSlow;
  }

  // Speed at which the junction behind segment k is passed, and the acceleration along the path
  // around it.
  Corner corner(std::size_t k) const {
    const Segment &p = segments_[k], &q = segments_[k + 1];
    const double A = least_accel(), h = lim_.period, sine = half_sine(k);
    const double tangent = sine / std::sqrt(1 - sine * sine);
    const double shorter = std::min(p.length, q.length);
    const double bend = (p.curvature + q.curvature) / 2;
    Corner c{std::min(p.speed, q.speed), std::min(p.accel, q.accel)};
    if (sine > 0) {
      c.speed = std::min(c.speed, kTurn * A * h / (kCorner * sine));
      if (bend == 0) {
        c.speed = std::min(c.speed, std::sqrt(kShare * A * shorter / (2 * tangent)));
      }
    }
    // Shares of A that the turn takes: of one corner, and of many within a point.
    const auto turn = [&](double v) {
      return std::max(2 * sine * v / (A * h), 2 * tangent * v * v / (shorter * A));
    };
    double load = turn(c.speed) + bend * c.speed * c.speed / A;
    if (bend > 0 && load > kFull && turn(c.speed) > kStraight) {
      c.speed *= kFull / load;
      load = turn(c.speed) + bend * c.speed * c.speed / A;
    }
    if (turn(c.speed) > kStraight) {
      c.accel = std::min(c.accel, (load > kShare + 1e-9 ? kHalf : kShare) * A);
    }
    return c;
  }

  // Where the limits of speed and acceleration change along the chain.
  std::vector<Piece> pieces(const Chain& c) const {
    struct Zone {
      double from, to, speed, accel;
    };
    std::vector<Zone> zones;
    std::vector<double> cuts{0};
    double s = 0;
    for (std::size_t k = c.first; k < c.last; ++k) {
      const Segment& g = segments_[k];
      zones.push_back({s, s + g.length, g.speed, g.accel});
      s += g.length;
      cuts.push_back(s);
      if (k + 1 == c.last) break;
      const Corner j = corner(k);
      const double reach = j.speed * lim_.period * (lim_.mean + 1) / 2;
      zones.push_back({s - reach, s + reach, j.speed, j.accel});
      cuts.push_back(std::max(0.0, s - reach));
      cuts.push_back(std::min(c.length, s + reach));
    }
    std::sort(cuts.begin(), cuts.end());
    std::sort(zones.begin(), zones.end(),
              [](const Zone& a, const Zone& b) { return a.from < b.from; });
    std::vector<Piece> all;
    std::vector<Zone> open;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double from = cuts[i], to = cuts[i + 1], middle = (from + to) / 2;
      if (to <= from) continue;
      while (next < zones.size() && zones[next].from <= middle) open.push_back(zones[next++]);
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](const Zone& z) { return z.to < middle; }),
                 open.end());
      Piece p{to - from, kNone, kNone, open.size() == 1};
      for (const Zone& z : open) {
        p.speed = std::min(p.speed, z.speed);
        p.accel = std::min(p.accel, z.accel);
      }
      all.push_back(p);
    }
    return all;
  }

  // Of a piece that is entered and left at these speeds: gentle between two corners.
  double acceleration(const Piece& p, double in, double out) const {
    if (!p.free || in == 0 || out == 0) return p.accel;
    const double swing = kSwing * lim_.period;
    const double needed = std::abs(out * out - in * in) / (2 * p.length);
    const double slow = (p.length - (in + out) * swing) / (swing * swing);
    return std::min(p.accel, std::max({kHalf * least_accel(), slow, needed}));
  }

  void chain(std::size_t first, std::size_t last) {
    Chain c;
    c.first = first;
    c.last = last;
    for (std::size_t k = first; k < last; ++k) {
      segments_[k].from = c.length;
      c.length += segments_[k].length;
    }
    const std::vector<Piece> all = pieces(c);
    // Square of the speed at each boundary: what both sides allow, and what can be reached.
    std::vector<double> v2(all.size() + 1, 0);
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double v = std::min(all[i - 1].speed, all[i].speed);
      v2[i] = v * v;
    }
    for (std::size_t i = all.size(); i-- > 0;) {
      v2[i] = std::min(v2[i], v2[i + 1] + 2 * all[i].accel * all[i].length);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      v2[i + 1] = std::min(v2[i + 1], v2[i] + 2 * all[i].accel * all[i].length);
    }
    double t = 0, s = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Piece& p = all[i];
      const double vi = std::sqrt(v2[i]), vo = std::sqrt(v2[i + 1]);
      const double accel = acceleration(p, vi, vo);
      const double most = std::sqrt((v2[i] + v2[i + 1]) / 2 + accel * p.length);
      const double vp = std::max({vi, vo, std::min(p.speed, most)});
      const double up = (vp * vp - v2[i]) / (2 * accel);
      const double down = (vp * vp - v2[i + 1]) / (2 * accel);
      const double flat = std::max(0.0, p.length - up - down);
      if (vp > vi) c.phases.push_back({t, s, vi, accel});
      t += (vp - vi) / accel;
      if (flat > 0) c.phases.push_back({t, s + up, vp, 0});
      t += flat / vp;
      if (vp > vo) c.phases.push_back({t, s + p.length - down, vp, -accel});
      t += (vp - vo) / accel;
      s += p.length;
    }
    c.phases.push_back({t, c.length, 0, 0});
    c.begin = chains_.empty() ? 0 : lap();
    c.ticks = static_cast<long>(std::ceil(t / lim_.period - kLate)) + lim_.mean +
              dwell_ticks(segments_[last - 1].m.dwell);
    chains_.push_back(c);
  }

  static Along path_length(const Chain& c, double t) {
    if (t <= 0) return {0, 0, 0};
    const auto after = std::upper_bound(c.phases.begin(), c.phases.end(), t,
                                        [](double x, const Phase& p) { return x < p.t; });
    const Phase& p = *(after - 1);
    const double d = t - p.t;
    return {p.s + (p.v + p.a * d / 2) * d, p.v + p.a * d, p.a};
  }

  Command place(const Chain& c, double s, double v, double a) const {
    const auto begin = segments_.begin() + static_cast<std::ptrdiff_t>(c.first) + 1;
    const auto end = segments_.begin() + static_cast<std::ptrdiff_t>(c.last);
    const Segment& g = *(std::lower_bound(begin, end, s, [](const Segment& x, double at) {
                           return x.from < at;
                         }) - 1);
    s -= g.from;
    const Move& m = g.m;
    if (m.kind == Move::Kind::kLine) {
      const double share = std::min(1.0, s / g.length);
      return {{m.from.x + (m.to.x - m.from.x) * share, m.from.y + (m.to.y - m.from.y) * share},
              {g.in.x * v, g.in.y * v}, {g.in.x * a, g.in.y * a}};
    }
    const double r = m.radius(), sign = m.sweep > 0 ? 1 : -1;
    const double angle = std::atan2(m.from.y - m.center.y, m.from.x - m.center.x) + sign * s / r;
    const Place n{std::cos(angle), std::sin(angle)}, t{-sign * n.y, sign * n.x};
    return {{m.center.x + r * n.x, m.center.y + r * n.y}, {t.x * v, t.y * v},
            {t.x * a - n.x * v * v / r, t.y * a - n.y * v * v / r}};
  }

  Limits lim_;
  int laps_;
  Place start_;
  long begin_ = 0;
  std::vector<Segment> segments_;
  std::vector<Chain> chains_;
};

}  // namespace trammel::ideal
