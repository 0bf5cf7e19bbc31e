// SPDX-License-Identifier: Apache-2.0
//
// Keys and figures of the machine mcafee, from results made by hand.

#include "machines/mcafee/machine_members.hpp"

#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "host/files.hpp"
#include "lab/layers.hpp"
#include "lab/report_data.hpp"
#include "lab/report_page.hpp"
#include "testbench/run.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/files.hpp"
#include "tests/support/lm628_words.hpp"

using namespace trammel;
using namespace trammel::lab;
using test::content;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

// Along the first side of the square, 0.25 mm beside it in the third sample.
mcafee::Result tracked(int samples = 5) {
  mcafee::Result result;
  result.end = cosim::EndReason::kDone;
  result.table.row_mm = 0.5;
  const double beside[] = {0, 0, 0, 0.25, -0.1};
  for (int n = 0; n < samples; ++n) {
    mcafee::Sample s;
    s.edge = 17'067 * (n + 1);
    s.row = n < 2 ? 0 : static_cast<std::uint32_t>(n - 1);
    s.v = 254;
    s.axis[0].words.position = std::int64_t{n < 2 ? 0 : 100 * (n - 1)} << 16;
    s.axis[0].words.speed = n == 3 ? 4 << 16 : 0;
    s.axis[0].x_mm = n < 2 ? 0 : 0.5 * (n - 1);
    s.axis[1].x_mm = beside[n];
    s.axis[1].words.error = n == 4 ? -7 : 0;
    s.axis[1].mm_s = n == 4 ? -12.5 : 1;
    s.axis[0].i = n == 2 ? -2.5 : 1;
    result.samples.push_back(s);
  }
  return result;
}

// Runs with the result of `tracked`, in their own folder; the slow one ends as `slow_end`.
struct Runs {
  const fs::path folder = fs::absolute("mcafee_test_out");
  testbench::Arguments arguments;
  cosim::EndReason slow_end = cosim::EndReason::kDone;
  int slow_lacks = 0;  // samples of the slow run beside the others

  Runs() {
    fs::remove_all(folder);
    arguments.scenario = "mcafee-stage3";  // which compares
    arguments.out = folder.string();
  }
  ~Runs() { fs::remove_all(folder); }

  int run() {
    const std::atomic<bool> stop{false};
    const Simulate simulate = [this](const Settings& settings, const cosim::Hooks&) {
      const auto& o = static_cast<const mcafee::Options&>(settings);
      const bool slow = o.speed == o.least_speed;
      auto result = std::make_unique<mcafee::Result>(tracked(slow ? 5 - slow_lacks : 5));
      result->table = make_table(o.path, o.count_mm());
      if (slow) result->end = slow_end;
      return result;
    };
    return testbench::run(arguments, stop, [&](const Settings& settings, const cosim::Hooks& h) {
      return run_by(simulate, settings, h);
    });
  }
  nlohmann::json metrics() const { return nlohmann::json::parse(content(folder / "metrics.json")); }
};

}  // namespace

TEST_CASE("mcafee: figures count from the first row, contour errors from the path") {
  mcafee::Result result = tracked();
  const auto motion = [&](const std::string& name) {
    return test::figure(mcafee::Options{}, result, "motion." + name);
  };
  CHECK(motion("time_s") == Approx(2 * 2048 / 6e6));
  CHECK(result.first == 2);
  REQUIRE(result.contour_mm.size() == 5);
  CHECK(motion("contour_max_mm") == Approx(0.25));
  CHECK(motion("contour_max_s") == Approx(2048 / 6e6));
  CHECK(motion("contour_end_mm") == Approx(0.1));
  CHECK(motion("contour_rms_mm") == Approx(std::sqrt((0.0625 + 0.01) / 3)));
  CHECK(motion("max_error_counts") == 7);
  CHECK(motion("max_current_A") == 2.5);
  CHECK(motion("max_desired_mm_s") == Approx(4 * 4.0132 / 800 / (2048 / 6e6)));
  CHECK(motion("max_speed_mm_s") == 12.5);
}

TEST_CASE("mcafee: each column of the trace shows what it is named after") {
  mcafee::Result result;
  mcafee::Sample s;
  s.edge = 150'000;
  s.row = 3;
  s.v = 40;
  s.limits = 0b0110;
  std::map<std::string, double> expected{
      {"t_s", 3e-3}, {"row", 3}, {"v", 40}, {"limits", 6}, {"contour_mm", 0.25}};
  for (int a = 0; a < 2; ++a) {
    const int first = a == 0 ? 100 : 200;
    const std::string axis = a == 0 ? "x_" : "y_";
    s.axis[static_cast<std::size_t>(a)] = {test::numbered_words(first), a == 1, first + 21.0,
                                           first + 22.0, first + 23.0, first + 24.0};
    expected.merge(test::numbered_columns(axis, first));
    expected[axis + "host_irq"] = a;
    expected[axis + "mm"] = first + 21;
    expected[axis + "mm_s"] = first + 22;
    expected[axis + "i_A"] = first + 23;
    expected[axis + "u_V"] = first + 24;
  }
  result.samples.push_back(s);
  result.contour_mm = {0.25};
  test::check_row(test::row(mcafee::Options{}, result, 0), expected);
}

TEST_CASE("mcafee: interrupts, motors turned off and switches are events, once each") {
  mcafee::Result result;
  for (int n = 0; n < 6; ++n) {
    mcafee::Sample s;
    s.edge = 50'000 * n;
    s.axis[0].words.status = n == 0 || n >= 4 ? 0x80 : 0;  // off from the start, and at the end
    s.axis[1].host_irq = n == 2 || n == 3;
    s.axis[1].words.status = n == 2 ? 0x20 : 0;
    s.axis[1].words.actual = 7;
    s.limits = n == 3 ? 0b0110 : 0;
    result.samples.push_back(s);
  }
  mcafee::Options options;
  options.stage = sw::McafeeStage::kMove;
  mcafee::figures(options, result);
  std::string seen;
  for (const mcafee::Event& one : result.events) {
    seen += std::to_string(one.sample) + (one.axis == 0 ? " x " : " y ") + one.what + "; ";
    if (one.what == "interrupt") {
      CHECK(one.time_s == Approx(2e-3));
      CHECK(one.status == 0x20);
      CHECK(one.real == 7);
    }
  }
  CHECK(seen == "2 y interrupt; 3 x high switch open; 3 y low switch open; 4 x motor off; "
                "4 x high switch closed; 4 y low switch closed; ");
}

TEST_CASE_METHOD(Runs,
                 "mcafee: runs leave their files and a page that can be made again byte for byte") {
  arguments.json = true;
  REQUIRE(run() == 0);
  const auto metrics = this->metrics();
  CHECK(metrics["verdict"] == "done");
  CHECK(metrics["command"] == "./trammel run mcafee-stage3");
  CHECK(metrics["run"]["first_sample"] == 2);
  CHECK(metrics["compared"]["v = 40"]["motion"]["contour_max_mm"].get<double>() == Approx(0.25));
  const auto detail = nlohmann::json::parse(content(folder / "detail.json"));
  CHECK(detail["contours"].size() == 3);
  CHECK_THAT(content(folder / "contours.csv"), Contains("\n0.00000,0,0,0\n0.00034,0.25,"));
  const std::string contours = content(folder / "contours.csv");
  CHECK(std::count(contours.begin(), contours.end(), '\n') == 1 + 3);
  CHECK(detail["contours"][1]["mm"] == nlohmann::json({0.0, 0.25, 0.1}));
  CHECK(detail["rows"].size() == 463);
  CHECK(detail["rows"][0] == nlohmann::json({0, 0, 255, 0, 100, 0}));
  CHECK(detail["origin_mm"] == nlohmann::json({0.0, -30.0}));

  const std::string page = content(folder / "report.html");
  CHECK_THAT(page, Contains("\"machine\":\"mcafee\""));
  fs::remove(folder / "report.html");
  write_page({folder}, folder / "report.html");
  CHECK(content(folder / "report.html") == page);
  CHECK(read_run(folder).first == 2);

  const auto refused = [&](const std::string& changed) {
    host::write_text(folder / "detail.json", changed);
    CHECK_THROWS_WITH(write_page({folder}, folder / "report.html"),
                      Contains("detail.json: is corrupt: /"));
    CHECK(content(folder / "report.html") == page);
  };
  auto other = detail;
  other["rows"][3].erase(0);
  refused(other.dump());
  other = detail;
  other["contours"][2].erase("mm");
  refused(other.dump());
  for (const auto& wrong : {nlohmann::json({{"name", "a"}, {"mm", {"far"}}}),
                            nlohmann::json({{"name", "a"}, {"mm", 1}}),
                            nlohmann::json({{"name", 1}, {"mm", {0.5}}}),
                            nlohmann::json({{"mm", {0.5}}}), nlohmann::json({0.5}),
                            nlohmann::json(0.5)}) {
    CAPTURE(wrong.dump());
    other = detail;
    other["contours"][2] = wrong;
    refused(other.dump());
  }
  other = detail;
  other.erase("contour_step_s");
  refused(other.dump());

  arguments.report = arguments.json = false;
  arguments.scenario = "mcafee-stage2";
  CHECK(run() == 0);
  CHECK_FALSE(fs::exists(folder / "report.html"));
  CHECK_FALSE(fs::exists(folder / "detail.json"));
  write_page({folder}, folder / "report.html");
  CHECK(fs::exists(folder / "report.html"));
}

TEST_CASE_METHOD(Runs,
                 "mcafee: a stopped comparison ends the run; one that fails is listed by its end") {
  arguments.report = false;
  slow_end = cosim::EndReason::kStopped;
  CHECK(run() == exit_code(slow_end));
  CHECK(metrics()["end"] == end_text(slow_end));
  CHECK(metrics()["verdict"] == end_text(slow_end));
  CHECK(metrics()["compared"].size() == 1);
  slow_end = cosim::EndReason::kDiverged;
  CHECK(run() == exit_code(slow_end));
  CHECK(metrics()["end"] == "done");
  CHECK(metrics()["compared"]["v = 40"]["end"] == end_text(slow_end));
}

TEST_CASE_METHOD(Runs, "mcafee: a run that ends first leaves its place among the errors empty") {
  arguments.report = false;
  slow_lacks = 1;
  REQUIRE(run() == 0);
  std::istringstream contours(content(folder / "contours.csv"));
  std::string head, line;
  REQUIRE(std::getline(contours, head));
  const auto at = std::count(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(
                                                              head.find("v = 40")), ',');
  int row = 0;
  for (; std::getline(contours, line); ++row) {
    CAPTURE(line);
    REQUIRE(std::count(line.begin(), line.end(), ',') == 3);
    std::size_t begin = 0;
    for (auto n = at; n > 0; --n) begin = line.find(',', begin) + 1;
    const std::string value = line.substr(begin, line.find(',', begin) - begin);
    CHECK(value == (row == 0 ? "0" : row == 1 ? "0.25" : ""));
  }
  CHECK(row == 3);
}
