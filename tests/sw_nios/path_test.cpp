// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "models/ideal/paths.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace {

using namespace trammel;
using sw::Point;

std::vector<Point> walk(const sw::PathSetup& setup) {
  sw::Trajectory path(setup);
  std::vector<Point> points(path.size());
  for (Point& p : points) p = path.next();
  return points;
}

sw::PathSetup of(sw::Path path) {
  sw::PathSetup s;
  s.path = path;
  return s;
}

Point mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * 200)),
          static_cast<std::int32_t>(std::lround(y * 200))};
}

Point rounded(ideal::PointMm p) { return mm(p.x, p.y); }

int distance(Point a, Point b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

double step_length(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

}  // namespace

TEST_CASE("mul_q62 multiplies signed numbers exactly and rounds to nearest") {
  constexpr std::int64_t kOne = std::int64_t{1} << 62;
  CHECK(sw::mul_q62(kOne, kOne) == kOne);
  CHECK(sw::mul_q62(-kOne, 123456789) == -123456789);
  CHECK(sw::mul_q62(kOne / 2, 3) == 2);
  CHECK(sw::mul_q62(kOne / 4, 5) == 1);
  CHECK(sw::mul_q62(0x7FFFFFFFFFFFFFFF, kOne) == 0x7FFFFFFFFFFFFFFF);
  CHECK(sw::mul_q62(INT64_MIN, kOne / 2) == INT64_MIN / 2);
  const std::int64_t a = 0x0123456789ABCDEF;
  const std::int64_t b = 0x3EDCBA9876543210;
  const long double product = std::ldexp(static_cast<long double>(a), -62) * b;
  CHECK(std::abs(static_cast<long double>(sw::mul_q62(a, b)) - product) <= 1);
}

TEST_CASE("a rotation by the n-th part of a turn agrees with sine and cosine") {
  for (const std::uint32_t n : {4u, 5u, 20u, 268u, 628u, 12345u, 1000000u}) {
    const auto r = sw::Rotation::per_turn(n);
    const double angle = ideal::kTurn / n;
    // 1e-15 is a few roundings of the double-precision side.
    CHECK(std::ldexp(static_cast<double>(r.cos), -62) == Approx(std::cos(angle)).margin(1e-15));
    CHECK(std::ldexp(static_cast<double>(r.sin), -62) == Approx(std::sin(angle)).margin(1e-15));
  }
}

// Kung eq. 28, 29
TEST_CASE("the circle of section 10 has 629 points within 1 count of the formula, closed exactly") {
  const auto points = walk(of(sw::Path::kCircle));
  REQUIRE(points.size() == 629);
  int worst = 0;
  for (int k = 0; k <= 628; ++k) {
    const Point ideal = rounded(ideal::circle_point({250, 250}, 100, 628, k));
    worst = std::max(worst, distance(points[static_cast<std::size_t>(k)], ideal));
  }
  CHECK(worst <= 1);
  CHECK(points.front() == mm(250, 350));
  CHECK(points[157] == mm(350, 250));  // clockwise
  CHECK(points[314] == mm(250, 150));
  CHECK(points[471] == mm(150, 250));
  CHECK(points.back() == mm(250, 350));
}

TEST_CASE("the circle moves at constant speed: 0.5 m/s within the rounding to counts") {
  const auto points = walk(of(sw::Path::kCircle));
  const double chord = 2 * 20000 * std::sin(ideal::kTurn / 2 / 628);  // [count]
  CHECK(chord * 5e-6 / 2e-3 == Approx(0.5).epsilon(0.001));
  for (std::size_t k = 1; k < points.size(); ++k) {
    // Both ends are rounded by half a count at most in x and in y.
    REQUIRE(std::abs(step_length(points[k - 1], points[k]) - chord) <= std::sqrt(2.0) + 1e-6);
  }
}

TEST_CASE("a slow large circle of many laps does not drift") {
  auto setup = of(sw::Path::kCircle);
  setup.circle.center = {sw::from_counts(60000), sw::from_counts(60000)};
  setup.circle.radius = sw::from_counts(60000);
  setup.circle.ticks = 100000;
  setup.repeats = 2;
  sw::Trajectory path(setup);
  REQUIRE(path.size() == 200001);
  int worst = 0;
  for (int k = 0; k <= 200000; ++k) {
    const Point ideal = rounded(ideal::circle_point({300, 300}, 300, 100000, k));
    const Point p = path.next();
    worst = std::max(worst, distance(p, ideal));
    if (k % 25000 == 0) REQUIRE(p == ideal);
  }
  CHECK(worst <= 1);
}

// Kung eq. 30 to 38
TEST_CASE("the window of section 10 has 1069 points within 1 count, its eight corners exact") {
  const auto points = walk(of(sw::Path::kWindow));
  REQUIRE(points.size() == ideal::kWindowTicks + 1);
  int worst = 0;
  for (int k = 0; k <= ideal::kWindowTicks; ++k) {
    worst = std::max(worst, distance(points[static_cast<std::size_t>(k)],
                                     rounded(ideal::window_point(k))));
  }
  CHECK(worst <= 1);
  const struct {
    std::size_t tick;
    Point corner;
  } corners[] = {{0, mm(150, 250)},   {100, mm(150, 320)}, {167, mm(180, 350)}, {367, mm(320, 350)},
                 {434, mm(350, 320)}, {634, mm(350, 180)}, {701, mm(320, 150)}, {901, mm(180, 150)},
                 {968, mm(150, 180)}, {1068, mm(150, 250)}};
  for (const auto& c : corners) CHECK(points[c.tick] == c.corner);
}

TEST_CASE("the arcs of the window are centred on its corners and run at constant speed") {
  const auto points = walk(of(sw::Path::kWindow));
  const struct {
    std::size_t begin;
    Point center;
  } arcs[] = {{100, mm(150, 350)}, {367, mm(350, 350)}, {634, mm(350, 150)}, {901, mm(150, 150)}};
  const double chord = 2 * 6000 * std::sin(ideal::kTurn / 8 / 67);
  for (const auto& arc : arcs) {
    for (std::size_t k = arc.begin; k <= arc.begin + 67; ++k) {
      // A point is rounded by at most half a count in x and in y.
      REQUIRE(std::abs(step_length(arc.center, points[k]) - 6000) <= std::sqrt(0.5) + 1e-6);
      if (k > arc.begin) {
        REQUIRE(std::abs(step_length(points[k - 1], points[k]) - chord) <= std::sqrt(2.0) + 1e-6);
      }
    }
  }
  for (std::size_t k = 168; k <= 367; ++k) REQUIRE(points[k].x - points[k - 1].x == 140);
  for (std::size_t k = 435; k <= 634; ++k) REQUIRE(points[k].y - points[k - 1].y == -140);
}

// Kung eq. 39 to 43
TEST_CASE("the star of section 10 has 911 points within 1 count, its corners exact, and closes") {
  const auto points = walk(of(sw::Path::kStar));
  REQUIRE(points.size() == ideal::kStarTicks + 1);
  int worst = 0;
  for (int k = 0; k <= ideal::kStarTicks; ++k) {
    worst = std::max(worst,
                     distance(points[static_cast<std::size_t>(k)], rounded(ideal::star_point(k))));
  }
  CHECK(worst <= 1);
  for (int corner = 0; corner <= 5; ++corner) {
    CHECK(points[static_cast<std::size_t>(182 * corner)] ==
          rounded(ideal::star_point(182 * corner)));
  }
  CHECK(points.front() == mm(200, 266.25));
  CHECK(points[182] == mm(300, 266.25));
  CHECK(points.back() == points.front());
}

TEST_CASE("the star's strokes are straight, equally fast and turn by 144 degrees") {
  const auto points = walk(of(sw::Path::kStar));
  const double step = 20000.0 / 182;
  for (std::size_t k = 1; k < points.size(); ++k) {
    REQUIRE(std::abs(step_length(points[k - 1], points[k]) - step) <= std::sqrt(2.0) + 1e-6);
  }
  for (std::size_t c = 182; c < 910; c += 182) {
    const Point a = points[c - 182], b = points[c], d = points[c + 182];
    const double turn = std::atan2(d.y - b.y, d.x - b.x) - std::atan2(b.y - a.y, b.x - a.x);
    CHECK(std::abs(std::remainder(turn, ideal::kTurn)) ==
          Approx(ideal::kTurn * 144 / 360).margin(1e-3));
  }
}

TEST_CASE("a star of four strokes and one turn is a square, of three a triangle") {
  auto setup = of(sw::Path::kStar);
  setup.star = {{sw::from_counts(10000), sw::from_counts(10000)}, sw::from_counts(4000), 4, 1, 10};
  auto points = walk(setup);
  REQUIRE(points.size() == 41);
  CHECK(points[10] == Point{14000, 10000});
  CHECK(points[20] == Point{14000, 14000});
  CHECK(points[30] == Point{10000, 14000});
  CHECK(points[40] == Point{10000, 10000});
  setup.star.strokes = 3;
  points = walk(setup);
  CHECK(points[20] == Point{12000, 13464});  // 4000 sin 60 = 3464.1
  CHECK(points.back() == points.front());
}

TEST_CASE("a star whose strokes are too short to aim the next one has the same corners") {
  auto setup = of(sw::Path::kStar);
  setup.repeats = 2;
  const std::uint32_t many = setup.star.stroke_ticks;
  const auto points = walk(setup);
  for (const std::uint32_t few : {1u, 2u, 3u, 13u, 14u, 15u, 16u}) {
    setup.star.stroke_ticks = few;
    const auto short_points = walk(setup);
    REQUIRE(short_points.size() == 2 * setup.star.strokes * few + 1);
    for (std::uint32_t n = 0; n <= 2 * setup.star.strokes; ++n) {
      CAPTURE(few, n);
      CHECK(short_points[n * few] == points[n * many]);
    }
  }
}

TEST_CASE("the square wave has 750 points high and 750 low in each of 8 periods") {
  auto setup = of(sw::Path::kSquare);
  setup.repeats = 8;
  const auto points = walk(setup);
  REQUIRE(points.size() == 12000);
  CHECK(sw::Trajectory(setup).start() == Point{0, 0});
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::int32_t level = k % 1500 < 750 ? 2000 : 0;
    REQUIRE(points[k] == Point{level, level});
  }
}

TEST_CASE("the square wave's polarity follows its levels, and it may swing about zero") {
  auto setup = of(sw::Path::kSquare);
  setup.square.low = {2000, 2000};
  setup.square.high = {0, 0};
  CHECK(sw::Trajectory(setup).start() == Point{2000, 2000});
  CHECK(walk(setup).front() == Point{0, 0});
  setup.square.low = {-2000, -2000};
  setup.square.high = {2000, 2000};
  CHECK(sw::Trajectory(setup).start() == Point{-2000, -2000});
  CHECK(walk(setup).front() == Point{2000, 2000});
  CHECK(walk(setup).back() == Point{-2000, -2000});
}

TEST_CASE("a line is followed in equal steps there and back, exact at both ends") {
  auto setup = of(sw::Path::kLine);
  setup.line = {{sw::from_counts(100), sw::from_counts(7000)},
                {sw::from_counts(10101), sw::from_counts(-3000)},
                999};
  setup.repeats = 2;
  const auto points = walk(setup);
  REQUIRE(points.size() == 1999);
  for (int k = 0; k <= 1998; ++k) {
    const double part = (k <= 999 ? k : 1998 - k) / 999.0;
    const Point ideal = mm((100 + 10001 * part) / 200, (7000 - 10000 * part) / 200);
    REQUIRE(distance(points[static_cast<std::size_t>(k)], ideal) <= 1);
  }
  CHECK(points[0] == Point{100, 7000});
  CHECK(points[999] == Point{10101, -3000});
  CHECK(points[1998] == Point{100, 7000});
}

TEST_CASE("ends on the edge between two counts are rounded as their nominal value, lap after lap") {
  constexpr sw::Q32 kHalf = sw::Q32{1} << 31;
  auto line = of(sw::Path::kLine);
  line.line = {{0, 0}, {sw::from_counts(10000) + kHalf, sw::from_counts(-10000) + kHalf}, 999};
  line.repeats = 4;
  const auto there = walk(line);
  CHECK(there[999] == Point{10001, -9999});
  CHECK(there[1998] == Point{0, 0});
  CHECK(there[2997] == there[999]);

  auto circle = of(sw::Path::kCircle);
  circle.circle.center.x += kHalf;
  circle.circle.center.y += kHalf;
  circle.circle.ticks = 629;
  circle.repeats = 5;
  const auto laps = walk(circle);
  for (std::size_t lap = 0; lap <= 5; ++lap) CHECK(laps[629 * lap] == Point{50001, 70001});
}

TEST_CASE("listed points come in order; a second lap omits the closing point") {
  const Point list[] = {{1, 2}, {3, 4}, {5, 6}, {1, 2}};
  auto setup = of(sw::Path::kPoints);
  setup.points = list;
  setup.n_points = 4;
  setup.repeats = 2;
  const auto points = walk(setup);
  REQUIRE(points.size() == 7);
  const Point expected[] = {{1, 2}, {3, 4}, {5, 6}, {1, 2}, {3, 4}, {5, 6}, {1, 2}};
  for (std::size_t k = 0; k < 7; ++k) {
    CAPTURE(k);
    CHECK(points[k] == expected[k]);
  }
  setup.n_points = 1;
  CHECK(walk(setup).size() == 1);
  setup.n_points = 2;  // of which one is passed again and again
  CHECK(walk(setup) == std::vector<Point>{{1, 2}, {3, 4}, {3, 4}});
  setup.n_points = 0;
  setup.points = nullptr;
  CHECK(walk(setup).empty());
  CHECK(sw::Trajectory(setup).start() == Point{});
}

TEST_CASE("a sweep plays its tones in whole periods, each settling as long as it is measured") {
  auto setup = of(sw::Path::kSweep);
  setup.sweep = {{50000, 40000}, {sw::from_counts(1000), sw::from_counts(-300)}, 100,
                 std::uint32_t{1} << 31, 4, 30};
  const auto points = walk(setup);
  std::size_t k = 0;
  for (const std::size_t period : {100u, 50u, 25u, 13u}) {  // 12.5 is rounded up
    const std::size_t turns = (30 + period - 1) / period;
    for (std::size_t n = 0; n < 2 * turns * period; ++n, ++k) {
      REQUIRE(k < points.size());
      const double sine = std::sin(2 * 3.14159265358979 * static_cast<double>(n % period) /
                                   static_cast<double>(period));
      REQUIRE(std::abs(points[k].x - 50000 - 1000 * sine) <= 0.501);  // rounded to a count
      REQUIRE(std::abs(points[k].y - 40000 + 300 * sine) <= 0.501);
    }
  }
  REQUIRE(points.size() == k + 1);
  CHECK(points.back() == Point{50000, 40000});
  CHECK(sw::Trajectory(setup).start() == Point{50000, 40000});
}

TEST_CASE("tones of a sweep that round to the same period are played once, and none is below 4") {
  auto setup = of(sw::Path::kSweep);
  setup.sweep = {{0, 0}, {0, 0}, 6, 3865470566, 20, 1};  // by 0.9: 6, 5.4, 4.9, 4.4, 3.9, ...
  std::vector<std::uint32_t> periods;
  for (sw::SteppedSine::Tones tones(setup.sweep); !tones.ended(); tones.next()) {
    periods.push_back(tones.tone().period);
  }
  CHECK(periods == std::vector<std::uint32_t>{6, 5, 4});
  CHECK(walk(setup).size() == 2 * (6 + 5 + 4) + 1);
}

TEST_CASE("a path that is elsewhere, not as far in X as in Y, is the same path there") {
  for (const auto kind : {sw::Path::kCircle, sw::Path::kWindow, sw::Path::kStar}) {
    auto there = of(kind);
    for (sw::Vec* place : {&there.circle.center, &there.window.center, &there.star.start}) {
      *place = *place + sw::Vec{sw::from_counts(1234), sw::from_counts(-777)};
    }
    const auto points = walk(of(kind)), moved = walk(there);
    REQUIRE(moved.size() == points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      CAPTURE(static_cast<int>(kind), k);
      const Point wanted{points[k].x + 1234, points[k].y - 777};
      if (!(moved[k] == wanted)) REQUIRE(moved[k] == wanted);
    }
  }
}

TEST_CASE("every closed path repeats itself lap by lap") {
  for (const auto kind : {sw::Path::kCircle, sw::Path::kWindow, sw::Path::kStar}) {
    auto setup = of(kind);
    const auto lap = walk(setup);
    setup.repeats = 3;
    const auto points = walk(setup);
    const std::size_t ticks = lap.size() - 1;
    REQUIRE(points.size() == 3 * ticks + 1);
    bool equal = true;
    for (std::size_t k = 0; k < points.size(); ++k) equal = equal && points[k] == lap[k % ticks];
    CHECK(equal);
  }
}

TEST_CASE("the paths of a board, which has no other set-up, are the defaults of the keys") {
  struct Default {
    sw::Path path;
    std::size_t points;
    Point start, low, high;  // [count] where it begins, and the box around it
  };
  for (const Default& d :
       {Default{sw::Path::kCircle, 629, {50000, 70000}, {30000, 30000}, {70000, 70000}},
        Default{sw::Path::kWindow, 1069, {30000, 50000}, {30000, 30000}, {70000, 70000}},
        Default{sw::Path::kStar, 911, {40000, 53250}, {40000, 41494}, {60000, 60515}},
        Default{sw::Path::kSquare, 1500, {0, 0}, {0, 0}, {2000, 2000}},
        Default{sw::Path::kLine, 501, {20000, 20000}, {20000, 20000}, {80000, 80000}}}) {
    const sw::PathSetup setup = of(d.path);
    Point low = sw::Trajectory(setup).start(), high = low;
    const std::vector<Point> points = walk(setup);
    for (const Point& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    CAPTURE(static_cast<int>(d.path));
    CHECK(points.size() == d.points);
    CHECK(sw::Trajectory(setup).start() == d.start);
    CHECK(low == d.low);
    CHECK(high == d.high);
  }
}
