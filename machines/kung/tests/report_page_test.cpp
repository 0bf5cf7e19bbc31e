// SPDX-License-Identifier: Apache-2.0
//
// What pages of the table hold besides what every page does (tests/lab).
#include <catch2/catch.hpp>
#include <limits>

#include "host/files.hpp"
#include "lab/report_data.hpp"
#include "lab/report_page.hpp"
#include "machines/kung/page/afc_steps.hpp"
#include "machines/kung/page/page.hpp"
#include "machines/kung/plan/axis.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::lab;
using test::content;
using test::run_kung;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  Scratch() : test::Scratch("kung_report_page_test_out") {}
};

// A machine that drifts for 60 samples; the path begins at the 11th.
kung::Result drifting() {
  kung::Result result;
  for (std::uint32_t k = 1; k <= 60; ++k) {
    kung::Sample sample;
    sample.tick = k;
    sample.edge = 25000 * static_cast<cosim::Clk>(k - 1);
    sample.axis[0].x_true_m = 0.25 + 1e-4 * k;
    sample.axis[1].force_N = -0.5 * k;
    result.samples.push_back(sample);
  }
  result.first_tick = 11;
  result.end_tick = 61;
  result.points = 10;
  return result;
}

void replace(const fs::path& file, const std::string& old, const std::string& text) {
  std::string all = content(file);
  const auto at = all.find(old);
  REQUIRE(at != std::string::npos);
  host::write_text(file, all.replace(at, old.size(), text));
}

}  // namespace

TEST_CASE("a page holds the samples from the first point on") {
  const Scratch scratch;
  REQUIRE(run_kung(scratch.path / "a", drifting()) == 0);
  const RunFolder run = read_run(scratch.path / "a");
  CHECK(run.rows == 60);
  CHECK(run.first == 10);
  const PageSeries all = page_series(run, false, 1000);
  CHECK(all.count == 50);
  // The columns of the trace, and the distance to the path.
  CHECK(all.channels.size() == run.machine->columns().columns.size() + 1);
  CHECK(all.channels.back()["name"] == "contour_m");
  // The command stays where it is while the table leaves it.
  const Series& contour = run.columns.at("contour_m");
  REQUIRE(contour.size() == 60);
  CHECK(contour[9] == 0);  // before the path
  for (const std::size_t k : {10u, 30u, 59u}) {
    CAPTURE(k, contour[k]);
    CHECK(contour[k] == Approx(run.columns.at("x_position_m")[k]));
  }
  const PageSeries few = page_series(run, true, 20);
  CHECK(few.stride == 3);
  CHECK(few.count == 17);
}

TEST_CASE("a run with a trip has a page too") {
  const Scratch scratch;
  kung::Result result = drifting();
  result.end = kung::EndReason::kFault;
  result.fault = {kung::FaultCode::kStroke, 1, 17};
  result.snapshot.gates = {1000, 7250, 4125, {{1000, 5}, {4125, 0}}, {}};
  CHECK(run_kung(scratch.path / "trip", std::move(result)) == 5);
  CHECK(fs::exists(scratch.path / "trip" / "report.html"));
}

TEST_CASE("a run is never lost because its trace holds what a page cannot show") {
  const Scratch scratch;
  kung::Result result = drifting();
  kung::Sample bad = result.samples.back();
  bad.axis[0].force_N = std::numeric_limits<double>::quiet_NaN();
  result.samples.push_back(bad);
  CHECK(run_kung(scratch.path / "a", std::move(result)) == 2);
  CHECK(fs::exists(scratch.path / "a" / "metrics.json"));
  CHECK(fs::exists(scratch.path / "a" / "trace.csv"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "report.html"));
}

TEST_CASE("corrupt figures, rules and gates are one line that names the file") {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a";
  REQUIRE(run_kung(folder, drifting()) == 0);
  const std::string page = content(folder / "report.html");
  const auto check = [&](const std::string& says) {
    try {
      write_page({folder}, folder / "report.html");
      FAIL("the page was written");
    } catch (const host::ConfigError& error) {
      const std::string line = error.what();
      CHECK_THAT(line, Catch::Contains(says));
      CHECK(line.find('\n') == std::string::npos);
    }
    CHECK(content(folder / "report.html") == page);
    CHECK_FALSE(fs::exists(folder / "report.html.new"));
  };
  const std::string metrics = content(folder / "metrics.json");
  const std::string detail = content(folder / "detail.json");

  replace(folder / "metrics.json", "\"mean_mm\"", "\"mean\"");
  check("metrics.json: is corrupt: /tracking/model/mean_mm is missing");
  host::write_text(folder / "metrics.json", metrics);
  replace(folder / "metrics.json", "\"samples\": 60", "\"samples\": \"many\"");
  check("metrics.json: is corrupt: /run/samples has the wrong type");
  host::write_text(folder / "metrics.json", metrics);

  replace(folder / "detail.json", "\"first\":[0,", "\"first\":[");
  check("detail.json: is corrupt: /rules/x/first does not hold 49 rules");
  host::write_text(folder / "detail.json", detail);
  replace(folder / "detail.json", "\"gates\":null",
          "\"gates\":{\"begin\":1,\"end\":2,\"edges\":[3],\"compare\":[]}");
  check("detail.json: is corrupt: /gates/edges does not hold gate edges");
  const auto response = [&](const std::string& holds, const std::string& says) {
    host::write_text(folder / "detail.json", detail);
    replace(folder / "detail.json", "\"gates\":null", "\"gates\":null,\"response\":" + holds);
    check("detail.json: is corrupt: /response" + says);
  };
  response("3", " has the wrong type");
  response("{\"~2\":{}}", " has a loop other than position, speed, current");
  response("{\"speed\":{\"x\":[]}}", "/speed/y is missing");
  response("{\"speed\":{\"x\":[[1,2,3,4]],\"y\":[]}}",
           "/speed/x does not hold rows of 5 numbers");
  host::write_text(folder / "detail.json", detail);
  replace(folder / "detail.json", "\"moment\":null", "\"moment\":{\"x\":{\"steps\":[[1,2]]}}");
  check("detail.json: is corrupt: /moment/x/steps does not hold 35 steps");
  fs::remove(folder / "detail.json");
  check("detail.json: is missing");
  host::write_text(folder / "detail.json", detail);
  write_page({folder}, folder / "report.html");
  CHECK(content(folder / "report.html") == page);
}

TEST_CASE("the page of a precision run has its errors, and is made again from precision.csv") {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a", table = folder / "precision.csv";
  REQUIRE(run_kung(folder, drifting(), {"controller=precision"}) == 0);
  const std::string page = content(folder / "report.html"), rows = content(table);
  const RunFolder run = read_run(folder);
  CHECK(run.columns.at("x_error_um").size() == 60);
  CHECK(run.detail["spectrum"]["x"].size() == 1025);
  write_page({folder}, folder / "report.html");
  CHECK(content(folder / "report.html") == page);
  const auto refused = [&](const std::string& says) {
    CHECK_THROWS_WITH(write_page({folder}, folder / "report.html"), Catch::Contains(says));
  };
  fs::remove(folder / "run.json");  // which knows the file's checksum
  replace(table, "x_error_um", "x_error_mm");
  refused("precision.csv: is corrupt: line 1 does not name the columns of a precision");
  host::write_text(table, rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1));
  refused("precision.csv: is corrupt: 59 samples, but the run recorded 60");
  fs::remove(table);
  refused("precision.csv: is missing");
  REQUIRE(run_kung(scratch.path / "b", drifting()) == 0);
  CHECK_FALSE(fs::exists(scratch.path / "b" / "precision.csv"));
}

TEST_CASE("the steps of the moment are those of each axis, if they end with the chip's words") {
  kung::Options o;
  o.gains[1].zeta = 2;
  kung::Result result;
  kung::Moment& moment = result.snapshot.moment;
  moment.tick = 7;
  moment.edge = 150'000;
  std::array<kung::AfcSteps, 2> steps;
  for (std::size_t a = 0; a < 2; ++a) {
    kung::AfcStart& start = moment.start[a];
    start.r = a == 0 ? 51'000 : 70'000;
    start.r_1 = start.r - 40;
    start.x_p = start.r - 300;
    start.x_p_prev = start.x_p - 5;
    for (std::size_t n = 0; n < 49; ++n) start.rules[n] = static_cast<std::int32_t>(20 * n) - 480;
    steps[a] = kung::afc_steps(kung::plan_axis(o, a), start);
    moment.end[a].x_m = static_cast<std::int32_t>(*steps[a][5].result);
    moment.end[a].u = static_cast<std::int32_t>(*steps[a][22].result);
    moment.end[a].v_star = static_cast<std::int32_t>(*steps[a][26].result);
    moment.end[a].i_q_ref = static_cast<std::int32_t>(*steps[a][29].result);
  }
  const Json json = kung::detail_json(o, result)["moment"];
  CHECK(json["tick"] == 7);
  CHECK(json["edge"] == 150'000);
  for (std::size_t a = 0; a < 2; ++a) {
    const Json& shown = json[a == 0 ? "x" : "y"]["steps"];
    REQUIRE(shown.size() == steps[a].size());
    for (std::size_t k = 0; k < shown.size(); ++k) {
      CAPTURE(a, k);
      const kung::AfcStep& step = steps[a][k];
      CHECK(shown[k][0] == (step.product ? Json(*step.product) : Json(nullptr)));
      CHECK(shown[k][1] == (step.result ? Json(*step.result) : Json(nullptr)));
    }
    using Sample = kung::AxisSample;
    for (const auto word : {&Sample::x_m, &Sample::u, &Sample::v_star, &Sample::i_q_ref}) {
      const auto before = moment.end[a].*word;
      moment.end[a].*word += 1;
      CAPTURE(a, before);
      CHECK(kung::detail_json(o, result)["moment"].is_null());
      moment.end[a].*word = before;
    }
  }
  moment.tick = 0;
  CHECK(kung::detail_json(o, result)["moment"].is_null());
  moment.tick = 7;
  o.uart = "?";  // commands may have changed the gains
  CHECK(kung::detail_json(o, result)["moment"].is_null());
}
