// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/report.hpp"
#include "testbench/run.hpp"

using namespace trammel;
using namespace trammel::testbench;
namespace fs = std::filesystem;

namespace {

// A folder of this test in the build folder, empty at the start and gone at the end.
struct Scratch {
  fs::path path = fs::absolute("run_test_out");
  Scratch() { fs::remove_all(path); }
  ~Scratch() { fs::remove_all(path); }
};

// A machine that stands still for 40 samples and ends as told.
Simulate standing(kung::EndReason end) {
  return [end](const kung::Options&, const kung::Hooks&) {
    kung::Result result;
    for (std::uint32_t k = 0; k < 40; ++k) {
      kung::Sample sample;
      sample.tick = k;
      sample.edge = 25000 * static_cast<cosim::Clk>(k);
      result.samples.push_back(sample);
    }
    result.end_tick = 40;
    result.points = 10;
    result.end = end;
    if (end == kung::EndReason::kFault) result.fault = {kung::FaultCode::kStroke, 1, 17};
    if (end == kung::EndReason::kPromise) {
      result.promise = {"no_shoot_through", "kung_xy.u_leg", "drive/gate_leg_props.sv:7", 617283};
    }
    return result;
  };
}

int run_to(const fs::path& out, kung::EndReason end, std::vector<std::string> set = {}) {
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "circle";
  arguments.out = out.string();
  arguments.assignments = std::move(set);
  arguments.json = true;
  return run(arguments, standing(end), stop);
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("a run leaves one folder with its record and nothing beside it") {
  const Scratch scratch;
  CHECK(run_to(scratch.path / "a", kung::EndReason::kDone) == 0);
  for (const char* file : {"metrics.json", "trace.csv", "run.toml"}) {
    CHECK(fs::file_size(scratch.path / "a" / file) > 0);
  }
  CHECK(entries(scratch.path) == 1);
}

TEST_CASE("a tripped run exits with 5, keeps its record and names the first fault") {
  const Scratch scratch;
  CHECK(run_to(scratch.path / "a", kung::EndReason::kFault) == 5);
  const auto json = nlohmann::json::parse(std::ifstream(scratch.path / "a" / "metrics.json"));
  CHECK(json["end"] == "tripped");
  CHECK(json["fault"]["cause"] == "stroke exceeded");
  CHECK(json["fault"]["axis"] == "y");
  CHECK(json["fault"]["tick"] == 17);
}

TEST_CASE("a broken promise of the RTL exits with 4, keeps the record and is named in it") {
  const Scratch scratch;
  CHECK(run_to(scratch.path / "a", kung::EndReason::kPromise) == 4);
  const auto json = nlohmann::json::parse(std::ifstream(scratch.path / "a" / "metrics.json"));
  CHECK(json["end"] == "promise broken");
  CHECK(json["promise"]["name"] == "no_shoot_through");
  CHECK(json["promise"]["clock"] == 617283);
  const std::string verdict = json["verdict"];
  CHECK_THAT(verdict, Catch::Contains("no_shoot_through of kung_xy.u_leg at 0.01234566 s"));
  CHECK(fs::exists(scratch.path / "a" / "trace.csv"));
}

TEST_CASE("diverged runs exit with 5 and interrupted ones with 130") {
  const Scratch scratch;
  CHECK(run_to(scratch.path / "a", kung::EndReason::kDiverged) == 5);
  CHECK(run_to(scratch.path / "a", kung::EndReason::kStopped) == 130);
  CHECK(fs::exists(scratch.path / "a" / "trace.csv"));
}

TEST_CASE("a second run replaces what the first wrote and leaves foreign files alone") {
  const Scratch scratch;
  const fs::path folder = scratch.path / "a";
  fs::create_directories(folder);
  std::ofstream(folder / "notes.txt") << "mine";
  std::ofstream(folder / "waves.fst") << "stale";
  CHECK(run_to(folder, kung::EndReason::kDone) == 0);
  CHECK(fs::exists(folder / "notes.txt"));
  CHECK_FALSE(fs::exists(folder / "waves.fst"));
  CHECK(fs::exists(folder / "metrics.json"));
}

TEST_CASE("a refused or failed run leaves nothing half written") {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  CHECK_THROWS_AS(run_to(scratch.path / "a", kung::EndReason::kDone, {"gains.kp=-1"}),
                  ConfigError);
  CHECK(entries(scratch.path) == 0);
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "circle";
  arguments.out = (scratch.path / "a").string();
  const Simulate broken = [](const kung::Options&, const kung::Hooks&) -> kung::Result {
    throw std::runtime_error("broken");
  };
  CHECK_THROWS_AS(run(arguments, broken, stop), std::runtime_error);
  CHECK(entries(scratch.path) == 0);
}

TEST_CASE("an output folder that cannot be one is refused before the run") {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  std::ofstream(scratch.path / "file") << "a file";
  CHECK_THROWS_AS(run_to(scratch.path / "file", kung::EndReason::kDone), ConfigError);
  CHECK_THROWS_AS(run_to(scratch.path / "file" / "below", kung::EndReason::kDone), ConfigError);
}

TEST_CASE("what was run is what run.toml repeats") {
  const Scratch scratch;
  REQUIRE(run_to(scratch.path / "a", kung::EndReason::kDone, {"plant.payload_kg=2.5"}) == 0);
  kung::Options again;
  apply_file(again, scratch.path / "a" / "run.toml");
  CHECK(again.scenario == "circle");
  CHECK(again.plant.axis[1].payload_kg == 2.5);
}

TEST_CASE("the errors of a file of points name its line and the key") {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  const fs::path file = scratch.path / "points.csv";
  const std::vector<std::string> set{"path.kind=points", "path.points_file=" + file.string()};
  std::ofstream(file) << "x_mm,y_mm\n100,200\n100.5,200\n";
  CHECK(run_to(scratch.path / "a", kung::EndReason::kDone, set) == 0);
  std::ofstream(file) << "100,200\n601,nan\n";
  CHECK_THROWS_WITH(run_to(scratch.path / "b", kung::EndReason::kDone, set),
                    Catch::Contains("path.points_file: ") && Catch::Contains("points.csv:2: "));
  CHECK_FALSE(fs::exists(scratch.path / "b"));
}

TEST_CASE("what only the machine can refuse is still the user's mistake") {
  const Scratch scratch;
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "circle";
  arguments.out = (scratch.path / "a").string();
  const Simulate refused = [](const kung::Options&, const kung::Hooks&) -> kung::Result {
    throw std::invalid_argument("plant.x.mass_kg: too small");
  };
  CHECK_THROWS_AS(run(arguments, refused, stop), ConfigError);
}

TEST_CASE("all experiments stopped before they ended are interrupted") {
  const Scratch scratch;
  std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.all = true;
  arguments.json = true;
  arguments.out = scratch.path.string();
  const Simulate stopped_behind = [&stop](const kung::Options& options, const kung::Hooks& hooks) {
    stop = true;
    return standing(kung::EndReason::kDone)(options, hooks);
  };
  CHECK(run(arguments, stopped_behind, stop) == 130);
  CHECK(entries(scratch.path) == 1);
}

TEST_CASE("a controller asked for beside all experiments is refused, whoever asks") {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.all = true;
  arguments.json = true;
  arguments.out = (scratch.path / "a").string();
  arguments.assignments = {"controller=fc"};
  CHECK_THROWS_WITH(run(arguments, standing(kung::EndReason::kDone), stop),
                    Catch::Contains("--all runs both controllers"));
  std::ofstream(scratch.path / "afc.toml") << "controller = 'afc'\n";
  arguments.assignments = {"plant.payload_kg=1"};
  CHECK(run(arguments, standing(kung::EndReason::kDone), stop) == 0);
  arguments.files = {(scratch.path / "afc.toml").string()};
  CHECK_THROWS_AS(run(arguments, standing(kung::EndReason::kDone), stop), ConfigError);
}

TEST_CASE("wide figures of a report do not run together") {
  kung::Result result;
  Metrics metrics;
  metrics.samples = 1;
  metrics.model_mm.mean = metrics.model_mm.std = metrics.model_mm.rms = 123456.789;
  metrics.model_mm.variance = metrics.model_mm.max = 1234567890.123;
  const std::string text = run_report(kung::Options{}, result, metrics, "out", "");
  CHECK_THAT(text, Catch::Contains(
                       " 123456.789 123456.789 1234567890.123 123456.789 1234567890.123\n"));
}

TEST_CASE("a stop without a fault of the chip is told apart from a trip") {
  CHECK(cause_text({kung::FaultCode::kStroke, 1, 17}) == "stroke exceeded on axis Y");
  CHECK_THAT(cause_text({}), Catch::Contains("processor"));
}
