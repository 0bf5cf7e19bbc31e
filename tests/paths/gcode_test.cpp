// SPDX-License-Identifier: Apache-2.0
//
// Programs in G-code: words, moves and arcs.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "paths/gcode.hpp"
#include "paths/gcode_arc.hpp"

namespace {

using namespace trammel;
using ideal::Move;
using ideal::Place;

paths::GcodeProgram program(const std::string& text, bool exact = false) {
  paths::GcodeTable table;
  table.start = {0.25, 0.25};
  table.home = {0.1, 0.2};
  table.exact = exact;
  return paths::read_gcode(text, "p.ngc", table);
}

std::vector<Move> read(const std::string& text) { return program(text).moves.moves; }

void check_end(const Move& move, double x_mm, double y_mm) {
  CHECK(move.to.x == Approx(1e-3 * x_mm).margin(1e-15));
  CHECK(move.to.y == Approx(1e-3 * y_mm).margin(1e-15));
}

constexpr double kPi = 3.14159265358979323846;

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

TEST_CASE("lines and rapid moves go from where the table is to the point of X and Y") {
  const auto all = program("G0 X200\nG1 Y300 F6000\nX210 Y310\nG0 X250 Y250\n").moves;
  CHECK(all.start.x == 0.25);
  CHECK(all.start_dwell == 0);
  REQUIRE(all.moves.size() == 4);
  const std::vector<Move>& m = all.moves;
  CHECK(m[0].kind == Move::Kind::kLine);
  CHECK(m[0].from.x == 0.25);
  check_end(m[0], 200, 250);
  check_end(m[1], 200, 300);
  check_end(m[2], 210, 310);
  CHECK(m[0].feed == 0.5);
  CHECK(m[0].stop);  // G0 stops at its end
  CHECK(m[1].feed == Approx(0.1));
  CHECK_FALSE(m[1].stop);
  CHECK_FALSE(m[2].stop);
  CHECK(m[3].stop);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(m[k].line == static_cast<int>(k) + 1);
    CHECK_FALSE(m[k].exact);
    if (k > 0) CHECK(m[k].from.x == m[k - 1].to.x);
  }
}

TEST_CASE("case and blanks are free, in numbers, too") {
  const auto all = read("g 0x+1 9\t9.\n  N 1 0 g01 Y.5 f6 0 0\r\n\tX+0200.250Y 0");
  REQUIRE(all.size() == 3);
  check_end(all[0], 199, 250);
  check_end(all[1], 199, 0.5);
  CHECK(all[1].feed == Approx(0.01));
  check_end(all[2], 200.25, 0);
  check_end(read("g0x +0. 12 34y 7")[0], 0.1234, 7);  // the example of RS274/NGC
}

TEST_CASE("the motion and F hold until others are given") {
  const auto all = read("F600\nG1\nX200\n(between) Y200\nG3 X210 R5\nF1200 X220 R5\nG1 X200");
  REQUIRE(all.size() == 5);
  CHECK(all[1].kind == Move::Kind::kLine);
  CHECK(all[2].kind == Move::Kind::kArc);
  CHECK(all[3].kind == Move::Kind::kArc);
  CHECK(all[2].feed == Approx(0.01));
  CHECK(all[3].feed == Approx(0.02));
  CHECK(all[4].feed == Approx(0.02));
}

TEST_CASE("G91 counts from the point before, without a sum of errors") {
  std::string text = "G91 G1 F6000\n";
  for (int k = 0; k < 300; ++k) text += "X.1 Y-.1\n";
  const auto all = read(text + "G90 Y0\nG91 Y1 X-1");
  REQUIRE(all.size() == 302);
  CHECK(all[299].to.x == 0.28);
  CHECK(all[299].to.y == 0.22);
  check_end(all[300], 280, 0);
  check_end(all[301], 279, 1);
}

TEST_CASE("G20 is in inches, and a feed keeps its speed where the unit changes") {
  const auto all = read("F600\nG20 G1 X10\nY1\nF10 Y2\nG21 X100");
  REQUIRE(all.size() == 4);
  CHECK(all[0].to.x == 0.254);
  CHECK(all[0].feed == Approx(0.01));
  CHECK(all[1].to.y == 0.0254);
  CHECK(all[2].feed == Approx(0.254 / 60));
  check_end(all[3], 100, 50.8);
  CHECK(read("G21 F600 G1 X1")[0].feed == Approx(0.01));  // the unit it has
}

TEST_CASE("G17 is no unit, beside G20 or behind it") {
  for (const char* text : {"G20 G17\nG1 F60 G91 X1", "G20\nG17\nG1 F60 G91 X1",
                           "G17 G20\nG1 F60 G91 X1"}) {
    CAPTURE(text);
    const std::vector<Move> all = read(text);
    REQUIRE(all.size() == 1);
    CHECK(all[0].to.x - all[0].from.x == Approx(0.0254));
    CHECK(all[0].feed == Approx(0.0254));
  }
}

TEST_CASE("G61 stops at corners, G64 passes them, whichever was first") {
  const auto all = read("G1 F600 X1\nG61 X2\nX3\nG64 P.05 X4\nG64 X5");
  REQUIRE(all.size() == 5);
  const bool exact[] = {false, true, true, false, false};
  for (std::size_t k = 0; k < 5; ++k) CHECK(all[k].exact == exact[k]);
  const auto stops = program("G1 F600 X1\nG64 X2", true).moves.moves;
  CHECK(stops[0].exact);
  CHECK_FALSE(stops[1].exact);
}

TEST_CASE("G4 rests where the table is, for the sum of the seconds") {
  const auto all = program("G4 P1\ng4p.5\nG1 F600 X1\nG4 P0.25\nG4 P1 F900\nX2\nG4 P0").moves;
  CHECK(all.start_dwell == 1.5);
  REQUIRE(all.moves.size() == 2);
  CHECK(all.moves[0].dwell == 1.25);
  CHECK(all.moves[0].stop);
  CHECK(all.moves[1].feed == Approx(0.015));
  CHECK(all.moves[1].dwell == 0);
  CHECK(all.moves[1].stop);
}

TEST_CASE("G28 goes home with stops, by way of X and Y in either distance mode") {
  auto all = read("G1 F600 X200\nG28\nX201");
  REQUIRE(all.size() == 3);
  check_end(all[1], 100, 200);
  CHECK(all[1].feed == 0.5);
  CHECK(all[1].stop);
  CHECK(all[2].kind == Move::Kind::kLine);
  CHECK(all[2].feed == Approx(0.01));  // still G1
  all = read("G91 G28 X-10 Y20");
  REQUIRE(all.size() == 2);
  check_end(all[0], 240, 270);
  CHECK(all[0].stop);
  check_end(all[1], 100, 200);
  CHECK(read("G28 X0 Y0\nG28").size() == 2);  // it is there
}

TEST_CASE("a line to where the table is already is none") {
  const auto all = read("G1 F600 X250 Y250\nX200\nG0 X200\nG1 X300");
  REQUIRE(all.size() == 2);
  CHECK_FALSE(all[0].stop);
}

TEST_CASE("what is shorter than the shortest line is none by itself, and is not lost") {
  auto all = read("G1 F600 X250.00005\nX250.0002 Y250");
  REQUIRE(all.size() == 1);
  CHECK(all[0].from.x == 0.25);
  CHECK(all[0].to.x == 0.2500002);
  std::string steps = "G91 G1 F600\n";
  for (int k = 0; k < 1000; ++k) steps += "X.00001\n";
  all = read(steps);
  REQUIRE(all.size() == 100);
  CHECK(all[99].to.x == 0.25001);
  all = read("G1 F600 X250.00005\nG2 I5\nG3 X260 R5");
  REQUIRE(all.size() == 2);
  CHECK(all[0].from.x == 0.25);
  CHECK(all[0].to.x == 0.25);
  CHECK(all[1].from.x == 0.25);
}

TEST_CASE("M2, M30 or a second percent end the program, what follows is not read") {
  for (const std::string end : {"M2", "m30", "X2 M02", "%"}) {
    CAPTURE(end);
    const auto all = read("%\nG0 X1\n" + end + "\nhello\nG1 X300\n");
    CHECK(all.size() == (end == "X2 M02" ? 2 : 1));
  }
  CHECK(read(" \n(a)\n\t% \nG0 X1\n%\n%\n").size() == 1);
  CHECK(read("%\nG0 X1").size() == 1);
}

TEST_CASE("comments, line numbers, empty lines and a mark of the encoding say nothing") {
  const auto all = read(
      "\xEF\xBB\xBF(G1 X1) N1 G0 (a;b) X20 ; (not closed\r\n\r\n;G1\nN1(N)\n N0005");
  REQUIRE(all.size() == 1);
  check_end(all[0], 20, 250);
  CHECK(read(std::string("(\0\x1b\xff)G0X1", 9)).size() == 1);
}

TEST_CASE("a block behind a slash is skipped, which is told once") {
  const auto all = program("/G0 X1 (open\n / hello\nG0 X2");
  REQUIRE(all.moves.moves.size() == 1);
  check_end(all.moves.moves[0], 2, 250);
  CHECK(all.warnings == std::vector<std::string>{"p.ngc:1: blocks that begin with '/' are skipped, "
                                                 "this one and all others"});
}

TEST_CASE("words that mean nothing here are named once each") {
  const auto all = program("T1 M6\nG0 Z5\nM03 S8000\nG1 Z-1 X1 F600 H1\nM3 Z5\nM9");
  CHECK(all.moves.moves.size() == 1);
  CHECK(all.warnings ==
        std::vector<std::string>{"p.ngc: ignored: M6 (line 1), T (line 1), Z (line 2), M3 (line "
                                 "3), S (line 3), H (line 4), M9 (line 6)"});
}

TEST_CASE("a feed above the largest one is lowered with one warning") {
  const auto all = program("G1 F60000 X1\nF72000 X2\nF90000 X3\nF600 X4");
  const std::vector<Move>& m = all.moves.moves;
  REQUIRE(m.size() == 4);
  CHECK(m[0].feed == Approx(1));
  CHECK(m[1].feed == 1);
  CHECK(m[2].feed == 1);
  CHECK(m[3].feed == Approx(0.01));
  CHECK(all.warnings == std::vector<std::string>{"p.ngc:2: F = 72000 is lowered to 60000 mm/min, "
                                                 "the largest feed; so is any other above it"});
  CHECK(read("G1 F6 X1")[0].feed == Approx(1e-4));
}

TEST_CASE("a feed at a limit is taken as it is rounded in another unit, one beyond it is not") {
  // 1 m/s is 2362.2047244094... inch/min, 0.1 mm/s 0.23622047244094...
  const struct {
    const char* feed;
    bool lowered;
  } cases[] = {{"2362.2047244", false}, {"2362.2047245", false}, {"2362.21", true},
               {"0.2362204724", false}};
  for (const auto& one : cases) {
    CAPTURE(one.feed);
    const auto all = program("G20\nG91 G1 X.1 F" + std::string(one.feed));
    CHECK(all.warnings.size() == (one.lowered ? 1 : 0));
    CHECK(all.moves.moves.at(0).feed <= 1);
    CHECK(all.moves.moves.at(0).feed == Approx(std::stod(one.feed) * 0.0254 / 60).epsilon(1e-5));
  }
  CHECK_THROWS_WITH(program("G20\nG91 G1 X.1 F.236"),
                    "p.ngc:2: F = 0.236 is out of range 0.23622..2362.2 inch/min");
}

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
      const auto arcs = paths::arc_around(from, to, center, left);
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
    const auto arcs = paths::arc_around(on(begin), on(begin + (left ? turn : -turn)), center, left);
    REQUIRE(arcs.size() == 1);
    const paths::Extent extent = paths::arc_extent(arcs[0]);
    paths::Extent seen{at(arcs[0], 0), at(arcs[0], 0)};
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
