// SPDX-License-Identifier: Apache-2.0
//
// What motor and supply cannot give is told before a run, and nothing where they can.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "machines/kung/machine.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

TEST_CASE("the paper's table has nothing to be told, on any of its paths") {
  for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kStar,
                              PathKind::kSquare, PathKind::kLine}) {
    Options o;
    o.path.kind = kind;
    CHECK(advice(o).empty());
  }
}

TEST_CASE("a supply below the back-EMF at the path's speed is told with both voltages") {
  Options o;
  o.plant.axis[1].dc_link_v = 40;
  o.plant.axis[1].viscous_n_s_m = o.plant.axis[1].coulomb_n = 0;
  const std::vector<std::string> lines = advice(o);
  REQUIRE(lines.size() == 1);
  // 2/3 79.9 N/A 0.5 m/s = 26.6 V; 40 V / sqrt 3 = 23.1 V
  CHECK_THAT(lines[0], Contains("y: back-EMF and drop of 26.6") && Contains("at 0.5 m/s") &&
                           Contains("above the 23.09 V") && Contains("plant.y.dc_link_V = 40"));
  o.path.kind = PathKind::kSquare;  // 10 mm 30 rad/s / e = 0.11 m/s
  CHECK(advice(o).empty());
  o.path.square_high_m = 0.1;
  CHECK_THAT(advice(o).at(0), Contains("at 1.1 m/s"));
}

TEST_CASE("a load above the thrust of the largest i_q* is told") {
  Options o;
  o.plant.axis[0].external_force_n = -500;
  CHECK_THAT(advice(o).at(0), Contains("x: friction and load of 513 N at 0.5 m/s take 6.42 A; "
                                       "plant.x.current_full_scale_A = 9.6 allows an i_q* of "
                                       "4.8 A"));
}

TEST_CASE("an offset of a sensor that is not measured is told") {
  Options o;
  o.plant.axis[0].current_offset_b_a = -0.05;
  CHECK_THAT(advice(o).at(0), Contains("x: an offset of 0.05 A of a current sensor is not "
                                       "measured: chip.offset_samples = 0"));
  o.chip.offset_samples = 8;
  CHECK(advice(o).empty());
}

TEST_CASE("a load that ends before it begins and a stroke the wrong way round are refused") {
  Options o;
  o.plant.axis[1].load_begin_s = 0.2;
  o.plant.axis[1].load_end_s = 0.1;
  CHECK_THROWS_WITH(advice(o), Contains("plant.y.load_end_s: value 0.1 must be 0 or above "
                                        "plant.y.load_begin_s = 0.2"));
  o = {};
  o.chip.axis[0].stroke_max_m = -0.1;
  CHECK_THROWS_WITH(advice(o), Contains("chip.x.stroke_min_m: value 0 must be below "
                                        "chip.x.stroke_max_m = -0.1"));
}
