// SPDX-License-Identifier: Apache-2.0
#include "cosim/gcode_arc.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "cosim/gcode.hpp"

namespace {

using namespace trammel;
using ideal::Move;
using ideal::Place;

constexpr double kPi = 3.14159265358979323846;

std::vector<Move> read(const std::string& text) {
  cosim::GcodeTable table;
  table.start = {0.25, 0.25};
  return cosim::read_gcode(text, "p.ngc", table).moves.moves;
}

// The last move of it, which is one arc.
Move arc(const std::string& block) {
  const auto all = read("G0 X200 Y200 F600\n" + block);
  REQUIRE(all.size() == 2);
  REQUIRE(all[1].kind == Move::Kind::kArc);
  return all[1];
}

void check(const Move& move, double x_mm, double y_mm, double turn) {
  CHECK(move.center.x == Approx(1e-3 * x_mm).margin(1e-12));
  CHECK(move.center.y == Approx(1e-3 * y_mm).margin(1e-12));
  CHECK(move.sweep == Approx(turn * kPi));
}

Place at(const Move& move, double share) {
  const double angle = std::atan2(move.from.y - move.center.y, move.from.x - move.center.x) +
                       share * move.sweep;
  return {move.center.x + move.radius() * std::cos(angle),
          move.center.y + move.radius() * std::sin(angle)};
}

double apart(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

TEST_CASE("I and J lead from the start to the centre, G2 goes clockwise and G3 the other way") {
  check(arc("G2 X210 Y210 I10"), 210, 200, -0.5);
  check(arc("G3 X210 Y210 I10"), 210, 200, 1.5);
  check(arc("G2 X210 Y210 J10"), 200, 210, -1.5);
  check(arc("G3 X210 Y210 J10"), 200, 210, 0.5);
  check(arc("G2 X220 I10 J0"), 210, 200, -1);
  check(arc("G91 G3 X4 Y6 I-1 J5"), 199, 205, 0.5);
  check(arc("G20 G91 G3 X.1 Y.1 J.1"), 200, 202.54, 0.5);
}

TEST_CASE("without another end I and J make a full circle") {
  for (const std::string block : {"G2 I10", "G2 X200 Y200 I10", "G91 G2 X0 I10", "G2 X200 I10"}) {
    CAPTURE(block);
    check(arc(block), 210, 200, -2);
  }
  const Move left = arc("G3 J-5 I0");
  check(left, 200, 195, 2);
  CHECK(left.to.x == left.from.x);
  CHECK(left.length() == Approx(2 * kPi * 5e-3));
  // Where the same point is reached in steps of another kind.
  const auto all = read("G91 F600 G0 X.1 Y-.3\nX.2 Y.1\nG90 G2 X250.3 Y249.8 I5");
  CHECK(all.back().sweep == Approx(-2 * kPi));
}

TEST_CASE("R is the short way where it is above 0, the long way where it is below") {
  const double h = std::sqrt(75.0);  // of the centre from the chord of 10 with R10
  check(arc("G2 X210 R10"), 205, 200 - h, -1.0 / 3);
  check(arc("G3 X210 R10"), 205, 200 + h, 1.0 / 3);
  check(arc("G2 X210 R-10"), 205, 200 + h, -5.0 / 3);
  check(arc("G3 X210 R-10"), 205, 200 - h, 5.0 / 3);
  check(arc("G2 X210 R5"), 205, 200, -1);
  check(arc("G3 X210 R-5"), 205, 200, 1);
  check(arc("G2 X210.002 R5"), 205.001, 200, -1);  // digits are rounded
  check(arc("G2 X210.009 R5"), 205.0045, 200, -1);
}

TEST_CASE("an arc whose ends are rounded ends where it is said to, near the circle") {
  for (const bool left : {true, false}) {
    for (const double turn : {0.01, 0.2, 1.0, 2.9, 3.14159, 3.2, 5.0, 5.2, 5.3, 6.0, 6.28}) {
      CAPTURE(left, turn);
      const double radius = 0.02, error = 0.02e-3, angle = left ? turn : -turn;
      const Place from{0.3 + radius, 0.2}, center{0.3, 0.2};
      const Place to{center.x + (radius + error) * std::cos(angle),
                     center.y + (radius + error) * std::sin(angle)};
      const auto arcs = cosim::arc_around(from, to, center, left);
      CHECK(arcs.size() == (turn > 5.25 ? 2 : 1));
      double sweep = 0;
      for (const Move& one : arcs) {
        CHECK(apart(at(one, 0), one.from) < 1e-12);
        CHECK(apart(at(one, 1), one.to) < 1e-12);
        sweep += one.sweep;
        for (double share = 0; share <= 1; share += 0.05) {
          const double off = apart(at(one, share), center) - radius;
          CHECK(std::abs(off) < 2.1 * error);
        }
      }
      CHECK(apart(arcs.front().from, from) == 0);
      CHECK(apart(arcs.back().to, to) == 0);
      CHECK(apart(arcs.front().to, arcs.back().from) == (arcs.size() == 2 ? 0 : apart(from, to)));
      CHECK(sweep == Approx(angle).margin(0.12));
      if (arcs.size() == 2) {  // next to no corner where they meet
        const Place mid = arcs[0].to;
        const auto direction = [&](const Move& one) {
          return std::atan2(mid.y - one.center.y, mid.x - one.center.x);
        };
        CHECK(std::abs(direction(arcs[0]) - direction(arcs[1])) < 0.2 * kPi / 180);
      }
    }
  }
}

TEST_CASE("the extent of an arc holds it and is no larger") {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const Place center{uniform(0, 1), uniform(0, 1)};
    const double radius = uniform(0.01, 0.5), begin = uniform(0, 7), turn = uniform(0.01, 6.2);
    const auto on = [&](double angle) {
      return Place{center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
    };
    const bool left = k % 2 == 0;
    const auto arcs = cosim::arc_around(on(begin), on(begin + (left ? turn : -turn)), center, left);
    REQUIRE(arcs.size() == 1);
    const cosim::Extent extent = cosim::arc_extent(arcs[0]);
    cosim::Extent seen{at(arcs[0], 0), at(arcs[0], 0)};
    for (int n = 0; n <= 2000; ++n) {
      const Place p = at(arcs[0], n / 2000.0);
      seen = {{std::min(seen.low.x, p.x), std::min(seen.low.y, p.y)},
              {std::max(seen.high.x, p.x), std::max(seen.high.y, p.y)}};
    }
    const double step = radius * 6.3 / 2000;  // a sample lies within half of it
    for (const double d : {seen.low.x - extent.low.x, seen.low.y - extent.low.y,
                           extent.high.x - seen.high.x, extent.high.y - seen.high.y}) {
      CHECK(d > -1e-12);
      CHECK(d < step * step / radius);
    }
  }
}

TEST_CASE("an arc may touch the border of the stroke") {
  CHECK(read("G0 X0 Y300 F600\nG2 I300").size() == 2);
  CHECK(read("G0 X600 Y300 F600\nG3 X0 Y300 R300").size() == 2);
}
