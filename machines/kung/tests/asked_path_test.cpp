// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/asked_path.hpp"

#include <catch2/catch.hpp>

#include "machines/kung/plan.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

AskedPath line(std::vector<sw::Point>& points) {
  Options options;
  options.path.kind = PathKind::kLine;
  options.path.line_start_x_m = options.path.line_start_y_m = 0.1;
  options.path.line_end_x_m = 0.2;
  options.path.line_end_y_m = 0.1;
  options.path.line_ticks = 100;
  return {sw::Trajectory(plan_firmware(options, points)), 4, 5e-6, 500};
}

}  // namespace

TEST_CASE("distance from the path asked is that from the line through its last points") {
  std::vector<sw::Point> points;
  AskedPath path = line(points);
  // Point n comes at sample 4 n, 1 mm further; the table lags by 40 samples and is 3 mm beside.
  for (int k = 0; k < 400; ++k) {
    const double x_m = 0.1 + 0.001 * std::max(0, k / 4 - 10);
    CHECK(path.distance_m({x_m, 0.103}, 0) == Approx(0.003));
  }
}

TEST_CASE("a table that stands still is left behind by the path asked") {
  std::vector<sw::Point> points;
  AskedPath path = line(points);
  double last = 0;
  for (int k = 0; k < 2000; ++k) {
    const double distance = path.distance_m({0.1, 0.1}, 0);
    CHECK(distance >= last);
    last = distance;
  }
  CHECK(last == Approx(0.1).margin(0.0011));  // the end, once the way there is 250 ms old
}

TEST_CASE("what was asked some samples ago is known, as far as is searched") {
  std::vector<sw::Point> points;
  AskedPath path = line(points);
  for (int k = 0; k < 200; ++k) path.distance_m({0.1, 0.1}, 0);  // point n comes at sample 4 n
  CHECK(path.asked().x_m == Approx(0.149));
  CHECK(path.asked(3).x_m == Approx(0.149));
  CHECK(path.asked(4).x_m == Approx(0.148));
  CHECK(path.asked(133).x_m == Approx(0.116));
  CHECK(path.asked(5000).x_m == Approx(0.1));
}

TEST_CASE("a search for the nearest point ends where enough is known") {
  std::vector<sw::Point> points;
  AskedPath path = line(points);
  for (int k = 0; k < 100; ++k) path.distance_m({0.1, 0.1}, 0);
  const double some = path.distance_m({0.1, 0.102}, 0.05);
  CHECK(some < 0.05);
  CHECK(some >= 0.002);
}
