// SPDX-License-Identifier: Apache-2.0
//
// Random programs of lines and arcs with what is hard for a feed profile: chords of 0.01 mm, sharp
// and flat corners, arcs of 0.1 to 50 mm radius, whole circles, stops, changes of the feed, and
// limits at their ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

#include "models/ideal/feed_profile.hpp"

namespace trammel::test {

struct RandomProgram {
  ideal::Moves moves;
  ideal::FeedProfile::Limits limits;
};

class RandomMoves {
 public:
  explicit RandomMoves(std::uint32_t seed) : random_(seed) {}

  RandomProgram make() {
    RandomProgram p;
    p.limits.accel_x = one_of({8, 8, 0.1, 40, 2});
    p.limits.accel_y = one_of({8, 8, p.limits.accel_x, 0.1, 40});
    p.limits.mean = static_cast<int>(one_of({8, 8, 1, 64, 2, 20}));
    const double feed = one_of({0.3, 0.5, 1e-3, 1.2, 0.05, 0.3});
    style_ = static_cast<std::uint32_t>(random_() % 6);
    heading_ = between(0, 2 * kPi);
    ideal::Place at{0.25, 0.25};
    p.moves.start = at;
    for (int left = style_ < 2 ? 200 : 30; left > 0; --left) {
      ideal::Move m;
      m.from = at;
      m.feed = random_() % 4 == 0 ? feed * between(0.2, 1) : feed;
      m.exact = random_() % 20 == 0;
      m.stop = random_() % 40 == 0;
      m.dwell = m.stop ? one_of({0, 0.0021, 0.01}) : 0;
      if (style_ >= 3 && random_() % 2 == 0) {
        arc(m);
      } else {
        line(m);
      }
      at = m.to;
      p.moves.moves.push_back(m);
    }
    return p;
  }

 private:
  static constexpr double kPi = 3.14159265358979323846;

  double between(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }
  double one_of(std::initializer_list<double> all) {
    return *(all.begin() + random_() % all.size());
  }

  void line(ideal::Move& m) {
    double length = one_of({1e-5, 1e-4, 1e-3, 0.01, 0.05});
    double turn = one_of({0, 0, 0.05, 0.5, 1.57, 3.0, -1.57, -0.3});
    if (style_ < 2) turn = between(-0.2, 0.2);
    if (style_ == 0) length = 1e-5 * between(0.5, 3);
    if (style_ == 1) length = 5e-4;
    if (style_ == 2) {
      length = between(1e-5, 0.02);
      turn = between(-kPi, kPi);
    }
    if (style_ == 5 && random_() % 3 != 0) turn = 0;
    heading_ += turn;
    m.to = {m.from.x + length * std::cos(heading_), m.from.y + length * std::sin(heading_)};
  }

  // Mostly begun along the last heading.
  void arc(ideal::Move& m) {
    if (random_() % 3 == 0) heading_ += one_of({0.01, -0.2, 1.5, 3.1});
    double r = one_of({0.001, 0.005, 0.05, 0.02, 1e-4});
    const bool flat = random_() % 8 == 0;
    m.kind = ideal::Move::Kind::kArc;
    m.sweep = one_of({0.1, 1.57, 3.14, 2 * kPi, -1.57, -0.5, -2 * kPi, 0.01});
    if (flat) {  // up to 0.2 rad, or 0.1 m
      r = one_of({5.25, 6, 50, 9000});
      m.sweep = std::min(0.2, 0.1 * between(0.01, 1) / r) * one_of({-1, 1});
    }
    const double side = m.sweep > 0 ? 1 : -1;
    m.center = {m.from.x - side * std::sin(heading_) * r, m.from.y + side * std::cos(heading_) * r};
    const double angle = std::atan2(m.from.y - m.center.y, m.from.x - m.center.x) + m.sweep;
    m.to = {m.center.x + r * std::cos(angle), m.center.y + r * std::sin(angle)};
    if (std::abs(m.sweep) > 6.28) m.to = m.from;
    heading_ += m.sweep;
  }

  std::mt19937 random_;
  std::uint32_t style_ = 0;
  double heading_ = 0;
};

}  // namespace trammel::test
