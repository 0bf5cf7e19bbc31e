// SPDX-License-Identifier: Apache-2.0
//
// The feed profile: the firmware's points beside the formulas in double precision, and the promise
// about the acceleration of each axis.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "machines/kung/plan/feed.hpp"
#include "machines/kung/tests/random_moves.hpp"
#include "models/ideal/precision.hpp"
#include "sw_nios/path/feed_prefilter.hpp"

namespace {

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;
using ideal::FeedProfile;
using ideal::Place;

constexpr double kCountM = 5e-6;
constexpr double kLsbM = kCountM / 256;

Options shape(PathKind kind) {
  Options o;
  o.path.kind = kind;
  o.path.profile = Profile::kFeed;
  return o;
}

struct Planned {
  explicit Planned(const Options& options) : setup(plan_feed(options, program)) {}
  Planned(const ideal::Moves& moves, const FeedProfile::Limits& limits)
      : program(feed_program(moves, limits, kCountM)) {
    setup.path = sw::Path::kFeed;
    setup.feed = program.setup;
  }

  std::vector<sw::Point> points() const {
    sw::Trajectory path(setup);
    std::vector<sw::Point> all;
    for (std::uint32_t n = path.size(); n > 0; --n) all.push_back(path.next_q8());
    return all;
  }

  FeedProgram program;
  sw::PathSetup setup;
};

// In LSB of Q8, beside the double-precision command at the points.
double furthest(const std::vector<sw::Point>& points, const FeedProfile& command, double point_s) {
  double most = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Place p = command.at(static_cast<double>(k) * point_s).p;
    most = std::max({most, std::abs(points[k].x - p.x / kLsbM),
                     std::abs(points[k].y - p.y / kLsbM)});
  }
  return most;
}

// Largest second difference of the points of an axis, of its limit; what rounding to Q8 can add is
// taken off.
double acceleration(const std::vector<sw::Point>& points, const FeedProfile::Limits& limits) {
  const double scale = limits.period * limits.period / kLsbM;
  double most = 0;
  for (std::size_t k = 2; k < points.size(); ++k) {
    const auto second = [&](std::int32_t sw::Point::* axis) {
      return std::abs(points[k].*axis - 2.0 * points[k - 1].*axis + points[k - 2].*axis) - 2;
    };
    most = std::max({most, second(&sw::Point::x) / (limits.accel_x * scale),
                     second(&sw::Point::y) / (limits.accel_y * scale)});
  }
  return most;
}

void near(const sw::Point& point, std::int32_t x, std::int32_t y) {
  CHECK(std::abs(point.x - x) <= 1);
  CHECK(std::abs(point.y - y) <= 1);
}

}  // namespace

TEST_CASE("points of circle, window and star are those of the specification") {
  const std::vector<sw::Point> circle = Planned(shape(PathKind::kCircle)).points();
  REQUIRE(circle.size() == 683);
  near(circle[8], 12814623, 17919979);
  near(circle[100], 16259100, 16574789);
  near(circle[300], 14792912, 8083783);
  near(circle[671], 12779885, 17919960);
  const std::vector<sw::Point> window = Planned(shape(PathKind::kWindow)).points();
  REQUIRE(window.size() == 1380);
  near(window[100], 7680000, 15866560);
  near(window[500], 16465236, 17427091);
  const std::vector<sw::Point> star = Planned(shape(PathKind::kStar)).points();
  REQUIRE(star.size() == 1032);
  near(star[300], 13502191, 12282223);
  near(star[500], 11882023, 12666706);
  for (const auto& points : {circle, window, star}) {  // begin and end exactly, at rest
    for (std::size_t left = 1; left <= 3; ++left) {
      CHECK((points[points.size() - left] == points.front()));
    }
  }
  CHECK((circle.front() == sw::Point{50000 * 256, 70000 * 256}));
}

TEST_CASE("points of the shapes are within one LSB of the formulas, whatever the keys") {
  for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kStar,
                              PathKind::kSquare, PathKind::kLine}) {
    for (int n = 0; n < 8; ++n) {
      Options o = shape(kind);
      o.path.repeats = n == 1 ? 3 : 1;
      o.path.square_periods = n == 1 ? 3 : 1;
      o.path.square_half_samples = 4001;
      if (n == 2) o.path.feed_m_s = 0.0123;
      if (n == 3) o.path.mean_points = 1;
      if (n == 4) o.path.mean_points = 64;
      if (n == 5) o.path.axis = {{{40}, {3}}};
      if (n == 6) o.path.axis = {{{0.1}, {0.7}}};
      if (n == 7) o.path.corner = Corner::kPass;
      if (kind == PathKind::kCircle) o.path.circle_radius_m = 0.0777;
      CAPTURE(n, static_cast<int>(kind));
      const Planned planned(o);
      const FeedProfile command = ideal_command(o, feed_moves(o));
      const std::vector<sw::Point> points = planned.points();
      INFO("points of the firmware's plan and of the formulas in double precision");
      REQUIRE(points.size() == command.points());
      CHECK(furthest(points, command, 2e-3) <= 1);
      CHECK(acceleration(points, feed_limits(o)) <= 1.01);
    }
  }
}

TEST_CASE("random programs keep the acceleration of each axis, and the points of the formulas") {
  double most = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    test::RandomProgram p = test::RandomMoves(seed).make();
    p.moves.start_dwell = seed % 3 * 0.05;
    const FeedProfile command(p.moves, p.limits);
    if (command.points() > 50000) continue;
    const std::vector<sw::Point> points = Planned(p.moves, p.limits).points();
    REQUIRE(points.size() == command.points());
    CHECK(furthest(points, command, p.limits.period) <= 1);
    const double share = acceleration(points, p.limits);
    CHECK(share <= 1.01);
    most = std::max(most, share);
  }
  CHECK(most > 0.99);
}

TEST_CASE("a program that turns back on its own line has the points of the formulas") {
  // Rounding decided whether the table stopped there: 2 ms between the points and the command.
  for (const double slow : {0.002, 0.0056, 0.05}) {
    for (const double off : {0.0, 1e-6, 1e-4, 1e-3, 0.1}) {  // [rad]
      for (const double heading : {0.0, 1.5707963267948966, 2.5}) {
        CAPTURE(slow, off, heading);
        ideal::Move there, back;
        there.from = {0.25, 0.25};
        there.to = {0.25 + 0.05 * std::cos(heading), 0.25 + 0.05 * std::sin(heading)};
        there.feed = 0.22;
        back.from = there.to;
        back.to = {there.to.x - 0.0115 * std::cos(heading + off),
                   there.to.y - 0.0115 * std::sin(heading + off)};
        back.feed = slow;
        const FeedProfile::Limits limits;
        const ideal::Moves moves{there.from, 0, {there, back}};
        const FeedProfile command(moves, limits);
        const std::vector<sw::Point> points = Planned(moves, limits).points();
        REQUIRE(points.size() == command.points());
        CHECK(furthest(points, command, limits.period) <= 1);
        CHECK(acceleration(points, limits) <= 1.01);
      }
    }
  }
}

TEST_CASE("between the chords of a curve the table speeds up and brakes gently") {
  // At 8 m/s^2 chords of 6 mm cost an empty table 3 um in the mean.
  for (const int chords : {52, 63}) {  // of 6 and 5 mm
    CAPTURE(chords);
    const FeedProfile::Limits limits;
    ideal::Moves moves;
    const auto corner = [chords](int k) {
      const double angle = 2 * 3.14159265358979 * k / chords;
      return Place{0.25 + 0.05 * std::cos(angle), 0.25 + 0.05 * std::sin(angle)};
    };
    moves.start = corner(0);
    for (int k = 0; k < chords; ++k) {
      ideal::Move chord;
      chord.from = corner(k);
      chord.to = corner(k + 1);
      chord.feed = 0.3;
      moves.moves.push_back(chord);
    }
    const FeedProfile command(moves, limits);
    CHECK(furthest(Planned(moves, limits).points(), command, limits.period) <= 1);
    double most = 0, slowest = 1, fastest = 0;
    for (double t = 0.15; t < command.seconds() - 0.15; t += 1e-3) {
      const FeedProfile::Command at = command.at(t);
      const double speed = std::hypot(at.v.x, at.v.y);
      most = std::max(most, std::abs(at.a.x * at.v.x + at.a.y * at.v.y) / speed);
      slowest = std::min(slowest, speed);
      fastest = std::max(fastest, speed);
    }
    CHECK(most <= 0.35 * limits.accel_x * 1.001);
    CHECK(fastest > 1.1 * slowest);  // and it does speed up
  }
}

TEST_CASE("flat arcs as long as the table are within one LSB, and in whole counts the nearest") {
  for (const double radius : {5.25, 6.0, 50.0}) {
    for (const double sign : {-1.0, 1.0}) {
      CAPTURE(radius, sign);
      ideal::Move m;
      m.kind = ideal::Move::Kind::kArc;
      m.sweep = sign * 0.55 / radius;
      m.center = {0.02, 0.1 + sign * radius};
      m.from = {0.02, 0.1};
      m.to = {0.02 + radius * std::sin(std::abs(m.sweep)),
              m.center.y - sign * radius * std::cos(m.sweep)};
      m.feed = 0.5;
      m.stop = true;
      const FeedProfile::Limits limits;
      const ideal::Moves moves{m.from, 0, {m}};
      const Planned planned(moves, limits);
      const std::vector<sw::Point> points = planned.points();
      CHECK(furthest(points, FeedProfile(moves, limits), limits.period) <= 1);
      sw::Trajectory counts(planned.setup);
      const auto nearest = [](std::int32_t q8) { return (q8 + 128) >> 8; };
      for (std::size_t n = 0; n < points.size(); ++n) {
        CAPTURE(n);
        const sw::Point at = counts.next();
        if (at.x != nearest(points[n].x)) CHECK(at.x == nearest(points[n].x));
        if (at.y != nearest(points[n].y)) CHECK(at.y == nearest(points[n].y));
      }
    }
  }
}

TEST_CASE("with any encoder, rates and limits a shape is refused in a line or within one LSB") {
  int driven = 0;
  for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kSquare}) {
    for (const double count_m : {1e-7, 1e-6, 2e-5, 1e-3}) {
      for (const int period : {1, 4, 255}) {
        for (const int rate : {1000, 4000}) {
          for (const double accel : {0.1, 40.0}) {
            for (const int mean : {1, 64}) {
              Options o = shape(kind);
              for (plant::AxisConfig& axis : o.plant.axis) axis.encoder_count_m = count_m;
              o.chip.irq_period_ticks = period;
              o.chip.position_Hz = rate;
              o.path.axis = {{{accel}, {40}}};
              o.path.mean_points = mean;
              o.path.square_half_samples = 100000;
              o.path.square_high_m = 0.001;
              o.path.square_periods = 1;
              o.path.circle_radius_m = 0.005;
              o.path.window_side_m = 0.01;
              o.path.window_radius_m = 0.002;
              o.path.feed_m_s = 0.11;
              CAPTURE(static_cast<int>(kind), count_m, period, rate, accel, mean);
              FeedProgram program;
              try {
                const sw::PathSetup setup = plan_feed(o, program);
                sw::Trajectory path(setup);
                const FeedProfile command = ideal_command(o, feed_moves(o));
                REQUIRE(path.size() == command.points());
                const double point_s = 1.0 * period / rate, lsb_m = count_m / 256;
                double most = 0;
                for (std::uint32_t k = 0; k < path.size(); ++k) {
                  const sw::Point q = path.next_q8();
                  if (k % 13 != 0) continue;
                  const Place p = command.at(k * point_s).p;
                  most = std::max({most, std::abs(q.x - p.x / lsb_m), std::abs(q.y - p.y / lsb_m)});
                }
                CHECK(most <= 1);
                ++driven;
              } catch (const std::invalid_argument& error) {
                CHECK_THAT(error.what(), Contains("path"));
                CHECK_THAT(error.what(), !Contains("\n"));
              }
            }
          }
        }
      }
    }
  }
  CHECK(driven > 100);
}

TEST_CASE("speed and acceleration of the command are the slopes of its place") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const test::RandomProgram p = test::RandomMoves(seed).make();
    const FeedProfile command(p.moves, p.limits);
    std::mt19937 random(seed);
    const double end = static_cast<double>(std::min<std::size_t>(command.points(), 5000)) *
                       p.limits.period, step = 1e-6;
    for (int n = 0; n < 200; ++n) {
      const double t = std::uniform_real_distribution<double>(0, end)(random);
      const FeedProfile::Command a = command.at(t), b = command.at(t + step);
      // Over a step the speed changes by the acceleration, at a sharp corner by more.
      const double turn = 4 * std::hypot(a.v.x, a.v.y) * (std::hypot(b.v.x - a.v.x, b.v.y - a.v.y) >
                                                          1e-4 ? 1 : 0);
      // What a double leaves of a place 9 km from its arc's centre is 1e-12 m.
      CHECK((b.p.x - a.p.x) / step == Approx((a.v.x + b.v.x) / 2).margin(1e-5 + turn));
      CHECK((b.p.y - a.p.y) / step == Approx((a.v.y + b.v.y) / 2).margin(1e-5 + turn));
    }
  }
}

TEST_CASE("the set point of the spline stays near the command, with stops and at passed corners") {
  for (const bool pass : {false, true}) {
    for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kStar}) {
      Options o = shape(kind);
      o.path.corner = pass ? Corner::kPass : Corner::kStop;
      const std::vector<sw::Point> points = Planned(o).points();
      const FeedProfile command = ideal_command(o, feed_moves(o));
      std::vector<double> words[2];
      sw::Prefilter filter(points.front());
      for (std::size_t k = 1; k <= points.size(); ++k) {
        const sw::Point c = filter.step(points[std::min(k, points.size() - 1)]);
        words[0].push_back(c.x / 256.0);
        words[1].push_back(c.y / 256.0);
      }
      double most = 0, sum = 0;
      int samples = 0;
      for (int t = 62; t < 32 * static_cast<int>(points.size()); t += 9) {
        const Place p = command.at((t - 62) / 32.0 * 2e-3).p;
        const double x = ideal::Precision::set_point(words[0], t).p - p.x / kCountM;
        const double y = ideal::Precision::set_point(words[1], t).p - p.y / kCountM;
        const double um = std::hypot(x, y) * kCountM * 1e6;
        most = std::max(most, um);
        sum += um;
        ++samples;
      }
      CAPTURE(pass, static_cast<int>(kind), most, sum / samples);
      CHECK(sum / samples < (pass ? 0.1 : 0.03));
      CHECK(most < (pass ? 4 : 1));
    }
  }
}

TEST_CASE("a plan that has no room for its pieces or phases says so, and writes no more of them") {
  Options o = shape(PathKind::kStar);
  o.path.corner = Corner::kPass;
  for (const bool phases : {false, true}) {
    CAPTURE(phases);
    auto segments = feed_segments(feed_moves(o), {kCountM, 2e-3});
    std::vector<sw::FeedPiece> pieces(phases ? 100 : 2);
    std::vector<sw::FeedPhase> room(phases ? 2 : 100);
    sw::FeedPlanner planner({segments.data(), static_cast<std::uint32_t>(segments.size()),
                             room.data(), static_cast<std::uint32_t>(room.size()), pieces.data(),
                             static_cast<std::uint32_t>(pieces.size())},
                            feed_limits(feed_limits(o), {kCountM, 2e-3}));
    while (planner.step() == sw::FeedPlanner::State::kBusy) {
    }
    CHECK(planner.state() == sw::FeedPlanner::State::kNoRoom);
    CHECK(planner.phases() <= room.size());
    CHECK(planner.pieces() <= pieces.size());
  }
}

TEST_CASE("a command lasts from the rest ahead of its first move to that behind its last lap") {
  const FeedProfile::Limits limits;
  const auto command = [&limits](double before_s, double behind_s, int laps) {
    ideal::Move there, back;
    there.to = back.from = {0.1, 0};
    there.feed = back.feed = 0.3;
    there.stop = back.stop = true;
    back.dwell = behind_s;
    return FeedProfile({{0, 0}, before_s, {there, back}}, limits, laps);
  };
  const double lap_s = command(0, 0, 1).seconds();
  for (const double before_s : {0.0, 0.3}) {
    for (const double behind_s : {0.0, 0.5}) {
      for (const int laps : {1, 3}) {
        CAPTURE(before_s, behind_s, laps);
        const FeedProfile all = command(before_s, behind_s, laps);
        const double end_s = before_s + laps * (lap_s + behind_s);
        CHECK(all.seconds() == Approx(end_s));
        CHECK(static_cast<double>(all.points() - FeedProfile::kRest) * limits.period ==
              Approx(end_s));
        CHECK(all.at(before_s).v.x == 0);
        CHECK(all.at(before_s + 0.05).v.x > 0);
        CHECK(all.at(end_s - behind_s - 0.05).v.x < 0);
        CHECK(all.at(end_s - behind_s).v.x == Approx(0).margin(1e-9));
      }
    }
  }
}
