// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/report_data.hpp"
#include "testbench/report_page.hpp"
#include "testbench/run.hpp"
#include "tests/support/files.hpp"

using namespace trammel;
using namespace trammel::testbench;
using test::content;
namespace fs = std::filesystem;

namespace {

struct Scratch {
  fs::path path = fs::absolute("report_page_test_out");
  Scratch() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Scratch() { fs::remove_all(path); }
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

int run_to(const fs::path& out, kung::Result result, std::vector<std::string> set = {}) {
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "circle";
  arguments.out = out.string();
  arguments.assignments = std::move(set);
  arguments.json = true;
  const auto simulate = [&](const kung::Options&, const kung::Hooks&) {
    return std::move(result);
  };
  return run(arguments, simulate, stop);
}

void replace(const fs::path& file, const std::string& old, const std::string& text) {
  std::string all = content(file);
  const auto at = all.find(old);
  REQUIRE(at != std::string::npos);
  write_text(file, all.replace(at, old.size(), text));
}

}  // namespace

TEST_CASE("a report made again from its folder is the same, byte by byte") {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a";
  REQUIRE(run_to(folder, drifting()) == 0);
  const std::string first = content(folder / "report.html");
  CHECK(first.size() > 50'000);
  fs::remove(folder / "report.html");
  write_run_page(folder);
  CHECK(content(folder / "report.html") == first);
}

TEST_CASE("a page holds the samples from the first point on") {
  const Scratch scratch;
  REQUIRE(run_to(scratch.path / "a", drifting()) == 0);
  const RunRecord run = read_run(scratch.path / "a");
  CHECK(run.rows == 60);
  CHECK(run.first == 10);
  CHECK(page_series(run, {}, 1000).count == 50);
  CHECK(page_series(run, {}, 1000).channels.size() == run.page->columns.size() + 1);
  const PageSeries few = page_series(run, {"t_s"}, 20);
  CHECK(few.stride == 3);
  CHECK(few.count == 17);
}

TEST_CASE("nothing a run is called ends the script that carries it") {
  const Scratch scratch;
  REQUIRE(run_to(scratch.path / "a", drifting(), {"description=</script><b> &"}) == 0);
  const std::string page = content(scratch.path / "a" / "report.html");
  CHECK(page.find("</script><b>") == std::string::npos);
  CHECK(page.find("\\u003c/script>\\u003cb>") != std::string::npos);
}

TEST_CASE("a page holds no address to load from") {
  const Scratch scratch;
  REQUIRE(run_to(scratch.path / "a", drifting()) == 0);
  const std::string page = content(scratch.path / "a" / "report.html");
  for (const char* loads : {"src=\"", "@import", "url(http", "fetch(", "<link rel=\"stylesheet"}) {
    CAPTURE(loads);
    CHECK(page.find(loads) == std::string::npos);
  }
}

TEST_CASE("runs without samples, without motion and with a trip have pages too") {
  const Scratch scratch;
  kung::Result result;
  result.end = kung::EndReason::kStopped;
  CHECK(run_to(scratch.path / "none", std::move(result)) == 130);
  CHECK(fs::exists(scratch.path / "none" / "report.html"));
  result = drifting();
  result.end = kung::EndReason::kFault;
  result.fault = {kung::FaultCode::kStroke, 1, 17};
  result.detail.gates = {1000, 7250, 4125, {{1000, 5}, {4125, 0}}, {}};
  CHECK(run_to(scratch.path / "trip", std::move(result)) == 5);
  CHECK(fs::exists(scratch.path / "trip" / "report.html"));
}

TEST_CASE("a run is never lost because its report failed") {
  const Scratch scratch;
  kung::Result result = drifting();
  kung::Sample bad = result.samples.back();
  bad.axis[0].force_N = std::numeric_limits<double>::quiet_NaN();
  result.samples.push_back(bad);
  CHECK(run_to(scratch.path / "a", std::move(result)) == 0);
  CHECK(fs::exists(scratch.path / "a" / "metrics.json"));
  CHECK(fs::exists(scratch.path / "a" / "trace.csv"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "report.html"));
}

TEST_CASE("a corrupt folder is one line that names the file, and the old page stays") {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a";
  REQUIRE(run_to(folder, drifting()) == 0);
  const std::string page = content(folder / "report.html");
  const auto check = [&](const std::string& says) {
    try {
      write_run_page(folder);
      FAIL("the page was written");
    } catch (const ConfigError& error) {
      const std::string line = error.what();
      CHECK_THAT(line, Catch::Contains(says));
      CHECK(line.find('\n') == std::string::npos);
    }
    CHECK(content(folder / "report.html") == page);
    CHECK_FALSE(fs::exists(folder / "report.html.new"));
  };
  const std::string trace = content(folder / "trace.csv");
  const std::string metrics = content(folder / "metrics.json");
  const std::string detail = content(folder / "detail.json");

  write_text(folder / "trace.csv", trace.substr(0, trace.size() / 2));
  check("trace.csv: is corrupt: line ");
  write_text(folder / "trace.csv", trace.substr(0, trace.rfind('\n', trace.size() - 2) + 1));
  check("trace.csv: is corrupt: 59 samples, but the run recorded 60");
  replace(folder / "trace.csv", "x_model_m", "x_medal_m");
  check("trace.csv: is corrupt: line 1 ");
  write_text(folder / "trace.csv", "");
  check("trace.csv: is corrupt: line 1 ");
  fs::remove(folder / "trace.csv");
  check("trace.csv: is missing");
  write_text(folder / "trace.csv", trace);

  write_text(folder / "metrics.json", metrics.substr(0, metrics.size() / 2));
  check("metrics.json: is corrupt: no JSON at byte ");
  write_text(folder / "metrics.json", "[]");
  check("metrics.json: is corrupt: not a JSON object");
  write_text(folder / "metrics.json", metrics);
  replace(folder / "metrics.json", "\"mean_mm\"", "\"mean\"");
  check("metrics.json: is corrupt: /tracking/model/mean_mm is missing");
  write_text(folder / "metrics.json", metrics);
  replace(folder / "metrics.json", "\"samples\": 60", "\"samples\": \"many\"");
  check("metrics.json: is corrupt: /run/samples is of a wrong kind");
  write_text(folder / "metrics.json", metrics);

  replace(folder / "detail.json", "\"first\":[0,", "\"first\":[");
  check("detail.json: is corrupt: /rules/x/first does not hold 49 rules");
  write_text(folder / "detail.json", detail);
  replace(folder / "detail.json", "\"gates\":null",
          "\"gates\":{\"begin\":1,\"end\":2,\"edges\":[3],\"compare\":[]}");
  check("detail.json: is corrupt: /gates does not hold gate edges");
  fs::remove(folder / "detail.json");
  check("detail.json: is missing");
  write_text(folder / "detail.json", detail);
  write_run_page(folder);
  CHECK_THROWS_WITH(write_run_page(scratch.path / "b"), Catch::Contains("no such folder"));
  CHECK_THROWS_WITH(write_run_page(folder / "trace.csv"), Catch::Contains("is not a folder"));
}

TEST_CASE("runs are compared on one page; other machines and too many runs are refused") {
  const Scratch scratch;
  const fs::path a = scratch.path / "one" / "a";
  const fs::path b = scratch.path / "two" / "a";
  REQUIRE(run_to(a, drifting()) == 0);
  REQUIRE(run_to(b, drifting(), {"controller=fc"}) == 0);
  const fs::path file = scratch.path / "compare.html";
  write_comparison_page({a, b}, file);
  const std::string page = content(file);
  CHECK(page.find("\"label\":\"one/a\"") != std::string::npos);
  CHECK(page.find("\"label\":\"two/a\"") != std::string::npos);
  CHECK(page.find("\"page\":\"two/a/report.html\"") != std::string::npos);

  replace(b / "metrics.json", "\"machine\": \"kung\"", "\"machine\": \"other\"");
  CHECK_THROWS_WITH(write_comparison_page({a, b}, file),
                    Catch::Contains("\"other\", which has no report page"));
  CHECK_THROWS_WITH(write_comparison_page(std::vector<fs::path>(9, a), file),
                    Catch::Contains("at most 8"));
  CHECK(content(file) == page);
}

TEST_CASE("the command that repeats a run names what differs from its scenario") {
  kung::Options options;
  apply_file(options, find_scenario("circle"));
  CHECK(repeat_command(options) == "./trammel run circle");
  apply_assignment(options, "controller=fc");
  apply_assignment(options, "plant.x.payload_kg=2.5");
  CHECK(repeat_command(options) ==
        "./trammel run circle -s controller=fc -s plant.x.payload_kg=2.5");
  options.scenario = "circle-fc";
  CHECK(repeat_command(options) ==
        "./trammel run circle -s controller=fc -s plant.x.payload_kg=2.5");
  options.scenario = "mine";
  CHECK(repeat_command(options) == "./trammel run run.toml");
}
