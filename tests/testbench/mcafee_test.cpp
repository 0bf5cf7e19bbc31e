// SPDX-License-Identifier: Apache-2.0
//
// Keys and figures of the machine mcafee, from results made by hand.

#include "testbench/mcafee.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "testbench/config.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::testbench;
using Catch::Matchers::Contains;

namespace {

std::string message_of(const std::string& toml) {
  return test::message_of<mcafee::Options>(toml);
}

// Along the first side of the square, 0.25 mm beside it in the third sample.
mcafee::Result tracked() {
  mcafee::Result result;
  result.end = cosim::EndReason::kDone;
  result.table.row_mm = 0.5;
  const double beside[] = {0, 0, 0, 0.25, -0.1};
  for (int n = 0; n < 5; ++n) {
    mcafee::Sample s;
    s.edge = 17'067 * (n + 1);
    s.row = n < 2 ? 0 : static_cast<std::uint32_t>(n - 1);
    s.v = 254;
    s.axis[0].words.position = std::int64_t{n < 2 ? 0 : 100 * (n - 1)} << 16;
    s.axis[0].words.speed = n == 3 ? 4 << 16 : 0;
    s.axis[0].x_mm = n < 2 ? 0 : 0.5 * (n - 1);
    s.axis[1].x_mm = beside[n];
    s.axis[1].words.error = n == 4 ? -7 : 0;
    s.axis[0].i = n == 2 ? -2.5 : 1;
    result.samples.push_back(s);
  }
  return result;
}

}  // namespace

TEST_CASE("mcafee: a path or motor that cannot be is refused with key, row and range") {
  CHECK(message_of("") == "");
  CHECK_THAT(message_of("[path]\nrow_mm = 0.7"), Contains("row 0: increments 139, 0"));
  CHECK_THAT(message_of("[path]\nradius_mm = 31"), Contains("out of range 0..30"));
  CHECK_THAT(message_of("[path]\nkind = \"points\""), Contains("path.points_file: is needed"));
  CHECK_THAT(message_of("[path]\nkind = \"points\"\npoints_file = \"none.csv\""),
             Contains("none.csv: cannot be read"));
  CHECK_THAT(message_of("[path]\nkind = \"spiral\""), Contains("square, circle, star"));
  CHECK_THAT(message_of("[track]\nspeed = 256"), Contains("out of range 0..255"));
  CHECK_THAT(message_of("[motor]\nresistance_ohm = 500"), Contains("is above 1e5 1/s"));
  CHECK_THAT(message_of("[gains]\nkp = 1"), Contains("is no key of the machine mcafee"));
}

TEST_CASE("mcafee: figures count from the first row, contour errors from the path") {
  const McafeeMetrics m = evaluate(mcafee::Options{}, tracked());
  CHECK(m.first == 2);
  CHECK(m.moving_s == Approx(2 * 2048 / 6e6));
  REQUIRE(m.contour_mm.size() == 5);
  CHECK(m.contour_max_mm == Approx(0.25));
  CHECK(m.contour_end_mm == Approx(0.1));
  CHECK(m.contour_rms_mm == Approx(std::sqrt((0.0625 + 0.01) / 3)));
  CHECK(m.max_error_counts == 7);
  CHECK(m.max_current_A == 2.5);
  CHECK(m.max_speed_mm_s == Approx(4 * 4.0132 / 800 / (2048 / 6e6)));
}

TEST_CASE("mcafee: run.toml repeats the options") {
  mcafee::Options options, again;
  options.path.kind = mcafee::PathKind::kStar;
  options.run.engine = mcafee::Engine::kTwin;
  options.stage_axis.motor.current_limit = 2.25;
  apply_text(again, run_toml(options), "run.toml", ".");
  CHECK(run_toml(again) == run_toml(options));
  CHECK(again.stage_axis.motor.current_limit == 2.25);
}
