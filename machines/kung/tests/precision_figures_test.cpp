// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/judge/comparison.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/precision/plan.hpp"
#include "machines/kung/run/make_plan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>


using namespace trammel;
using namespace trammel::kung;
using ideal::Move;
using ideal::Moves;

namespace {

constexpr double kPi = 3.14159265358979323846;

Move line(ideal::Place from, ideal::Place to) {
  Move m;
  m.from = from;
  m.to = to;
  return m;
}

Move arc(ideal::Place from, ideal::Place to, ideal::Place center, double sweep) {
  Move m = line(from, to);
  m.kind = Move::Kind::kArc;
  m.center = center;
  m.sweep = sweep;
  return m;
}

}  // namespace

TEST_CASE("the distance from a line is that from its nearest place") {
  const Moves moves{{0, 0}, 0, {line({0, 0}, {0.1, 0})}};
  CHECK(distance_to(moves, {0.05, 0.002}) == Approx(0.002));
  CHECK(distance_to(moves, {0.103, 0.004}) == Approx(0.005));
  CHECK(distance_to(moves, {-0.003, -0.004}) == Approx(0.005));
}

TEST_CASE("the distance from an arc counts its own turn, in each quadrant and either way") {
  constexpr double kRadius = 0.01;
  for (const double way : {1.0, -1.0}) {
    for (int begin = 0; begin < 8; ++begin) {
      for (const double sweep : {0.5, 2.0, 4.0, 6.0}) {
        const ideal::Place center{0.3, 0.2};
        const auto on = [&](double angle, double radius) {
          return ideal::Place{center.x + radius * std::cos(angle),
                              center.y + radius * std::sin(angle)};
        };
        const double first = begin * kPi / 4 + 0.1, last = first + way * sweep;
        const Move one = arc(on(first, kRadius), on(last, kRadius), center, way * sweep);
        // A line far away before it: the arc is the nearest, and looked at.
        const Moves moves{{0, 0}, 0, {line({0, 0}, {0.1, 0}), one}};
        for (const double off : {-0.002, 0.003}) {
          CAPTURE(way, begin, sweep, off);
          for (const double share : {0.01, 0.5, 0.99}) {
            CHECK(distance_to(moves, on(first + way * sweep * share, kRadius + off)) ==
                  Approx(std::abs(off)));
          }
          // In the middle of what is no arc both ends are as far away.
          const double gap = 2 * kPi - sweep, radius = kRadius + off;
          CHECK(distance_to(moves, on(first - way * gap / 2, radius)) ==
                Approx(std::sqrt(radius * radius + kRadius * kRadius -
                                 2 * radius * kRadius * std::cos(gap / 2))));
          // A hundredth of a turn before its begin, and behind its end.
          for (const double angle : {first - way * 0.01, last + way * 0.01}) {
            CHECK(distance_to(moves, on(angle, radius)) ==
                  Approx(std::sqrt(radius * radius + kRadius * kRadius -
                                   2 * radius * kRadius * std::cos(0.01))));
          }
        }
      }
    }
  }
}

TEST_CASE("a whole circle has no ends") {
  const Moves circle{{0.02, 0}, 0, {arc({0.02, 0}, {0.02, 0}, {0, 0}, -2 * kPi)}};
  for (const double angle : {0.0, 1.0, 3.0, 6.2}) {
    CHECK(distance_to(circle, {0.021 * std::cos(angle), 0.021 * std::sin(angle)}) ==
          Approx(0.001));
  }
}

TEST_CASE("the distance from a path is the least of those from its moves and from its start") {
  CHECK(distance_to(Moves{{0.3, 0.1}, 0, {}}, {0.31, 0.124}) == Approx(0.026));
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int k = 0; k < 300; ++k) {
    Moves all;
    all.start = {uniform(0, 0.6), uniform(0, 0.6)};
    ideal::Place at = all.start;
    for (int n = 0; n < 6; ++n) {
      ideal::Place to{uniform(0, 0.6), uniform(0, 0.6)};
      if (random() % 2 == 0) {
        all.moves.push_back(line(at, to));
      } else {
        const ideal::Place center = to;
        const double sweep = uniform(-6, 6), dx = at.x - center.x, dy = at.y - center.y;
        to = {center.x + dx * std::cos(sweep) - dy * std::sin(sweep),
              center.y + dx * std::sin(sweep) + dy * std::cos(sweep)};
        all.moves.push_back(arc(at, to, center, sweep));
      }
      at = to;
    }
    const Move& one = all.moves[random() % 6];
    const ideal::Place place{one.to.x + uniform(-0.05, 0.05), one.to.y + uniform(-0.05, 0.05)};
    double least = 1e9;
    for (const Move& move : all.moves) {
      least = std::min(least, distance_to(Moves{move.from, 0, {move}}, place));
    }
    CAPTURE(k, place.x, place.y);
    CHECK(distance_to(all, place) == Approx(least));
  }
}

TEST_CASE("the terminal has this run, its companions and what the paper prints, in mm") {
  lab::Record record;
  auto options = std::make_shared<Options>();
  options->controller = Controller::kPrecision;
  record.settings = options;
  CHECK(comparison_lines(record).empty());  // alone

  const auto figures = [](double step) {
    return std::vector<lab::Figure>{lab::figure("error_um.mean", "", "", 1000 * step, "um", 2),
                                    lab::figure("error_um.max", "", "", 2000 * step, "um", 2),
                                    lab::figure("contour_um.mean", "", "", 3000 * step, "um", 2),
                                    lab::figure("contour_um.max", "", "", 4000 * step, "um", 2),
                                    lab::figure("tracking.model.mean_mm", "", "", 5 * step, "mm",
                                                2)};
  };
  record.figures = figures(0.001);
  record.companions.resize(1);
  record.companions[0].name = "AFC";
  record.companions[0].figures = figures(10);
  const auto words = [&](std::size_t n) {
    std::istringstream line(comparison_lines(record).at(n));
    return std::vector<std::string>{std::istream_iterator<std::string>(line), {}};
  };
  using Words = std::vector<std::string>;
  CHECK(words(1) == Words{"same", "feed", "profile", "(mm)", "error", "max", "from", "path", "max",
                          "from", "model"});
  CHECK(words(2) == Words{"precision", "0.0010", "0.0020", "0.0030", "0.0040", "0.0050"});
  CHECK(words(3) == Words{"AFC", "10.0000", "20.0000", "30.0000", "40.0000", "50.0000"});
  CHECK(words(4) == Words{"AFC", "in", "the", "paper", "-", "-", "-", "-", "2.05"});
  CHECK(words(5) == Words{"FC", "in", "the", "paper", "-", "-", "-", "-", "3.51"});

  record.companions[0].figures.pop_back();  // a companion that did not get to its end
  CHECK(words(3).back() == "-");
  options->path.circle_radius_m = 0.09;  // another path than the paper's
  CHECK(comparison_lines(record).size() == 5);
}

TEST_CASE("a mass at the end of its range for 0.2 s and an error beyond its word are told") {
  Options options;
  Result result;
  CHECK(range_lines(options, result).empty());
  result.estimates = {AxisEstimate{32, 1, 1}, AxisEstimate{40, 1, 1}};
  result.mass_limited = {399, 400};  // 0.2 s of 2 kHz
  options.plant.axis[1].payload_kg = 50;
  REQUIRE(range_lines(options, result).size() == 1);
  CHECK(range_lines(options, result)[0] ==
        "warning: the estimated mass of Y was at the end of its range for 0.2 s; it is 40 kg, that "
        "of the plant 58 kg; precision.y.mass_kg moves the range");
  result.error_limited[0] = 20;
  CHECK(range_lines(options, result)[0] ==
        "warning: the error of X was above the 10.24 mm that the controller tells for 0.01 s");
}

TEST_CASE("the time that a precision run had no more current to give is told") {
  Options options;
  Result result;
  result.load[1].at_current = 40;  // of 2 kHz
  CHECK(range_lines(options, result).empty());  // the verdicts of fc and afc say it
  options.controller = Controller::kPrecision;
  REQUIRE(range_lines(options, result).size() == 1);
  CHECK(range_lines(options, result)[0] ==
        "warning: i_q* of Y was at its limit for 0.02 s: the path asks for more than the motor "
        "has");
}

TEST_CASE("an estimate at an end of its range is known as such") {
  Options options;
  options.controller = Controller::kPrecision;
  const sw::EstimatorSetup words = make_plan(options)->setup.precision.axis[0].estimator;
  sw::Estimator::Theta theta{words.mass, words.viscous, words.coulomb, 0, 0, 0};
  const AxisEstimate free = estimate_of(options, 0, theta);
  CHECK_FALSE((free.mass_limited || free.viscous_limited || free.coulomb_limited));
  CHECK_FALSE(free.cogging_limited);
  theta = {words.mass_min, 0, 4 * words.coulomb, 0, -4 * words.coulomb, 0};
  const AxisEstimate ends = estimate_of(options, 0, theta);
  CHECK((ends.mass_limited && ends.viscous_limited && ends.coulomb_limited));
  CHECK(ends.cogging_limited);
}

TEST_CASE("the estimates of the start are the values of the keys, each in its unit") {
  Options options;
  options.controller = Controller::kPrecision;
  options.plant.axis[1].force_constant_n_a = 60;
  for (std::size_t a = 0; a < 2; ++a) {
    AxisPrecision& own = options.precision.axis[a];
    own.mass_kg = 7 + static_cast<double>(a);
    own.viscous_n_s_m = 21;
    own.coulomb_n = 3.5;
    const sw::EstimatorSetup words = make_plan(options)->setup.precision.axis[a].estimator;
    const std::int32_t c = words.coulomb;
    const AxisEstimate e =
        estimate_of(options, a, {words.mass, words.viscous, c, c / 2, -c, 2 * c});
    CAPTURE(a);
    CHECK(e.mass_kg == Approx(own.mass_kg).epsilon(1e-4));
    CHECK(e.viscous_N_s_m == Approx(21).epsilon(1e-4));
    CHECK(e.coulomb_N == Approx(3.5).epsilon(1e-4));
    CHECK(e.cogging_sine_N == Approx(1.75).epsilon(1e-4));
    CHECK(e.cogging_cosine_N == Approx(-3.5).epsilon(1e-4));
    CHECK(e.force_N == Approx(7).epsilon(1e-4));
  }
}

TEST_CASE("of each estimate it is told on its own where it is at an end of its range") {
  constexpr bool AxisEstimate::*kEnds[] = {
      &AxisEstimate::mass_limited, &AxisEstimate::coulomb_limited, &AxisEstimate::viscous_limited,
      &AxisEstimate::cogging_limited};
  constexpr const char* kNames[] = {"mass_kg", "friction_N", "viscous_N_s_m", "cogging_N"};
  Options options;
  options.controller = Controller::kPrecision;
  const auto plan = make_plan(options);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t limited = 0; limited < 4; ++limited) {
      Result result;
      result.points = 1;
      for (const cosim::Clk edge : {0, 1'000'000}) {  // 20 ms apart
        Sample sample;
        sample.edge = edge;
        result.samples.push_back(sample);
      }
      result.estimates.emplace();
      (*result.estimates)[axis].*kEnds[limited] = true;
      std::vector<lab::Figure> list;
      add_command_figures(list, *plan, result);
      std::size_t seen = 0;
      for (const lab::Figure& f : list) {
        for (std::size_t a = 0; a < 2; ++a) {
          for (std::size_t k = 0; k < 4; ++k) {
            if (f.id != std::string(a == 0 ? "x" : "y") + ".estimate." + kNames[k]) continue;
            CAPTURE(f.id, kNames[limited]);
            CHECK(f.column == (a == axis && k == limited ? "at its limit," : "estimate"));
            ++seen;
          }
        }
      }
      CHECK(seen == 8);
    }
  }
}
