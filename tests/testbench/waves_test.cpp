// SPDX-License-Identifier: Apache-2.0
#include "testbench/waves.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testbench/config.hpp"
#include "testbench/run.hpp"

using namespace trammel;
using namespace trammel::testbench;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

struct Scratch {
  fs::path path = fs::absolute("waves_test_out");
  Scratch() { fs::remove_all(path); }
  ~Scratch() { fs::remove_all(path); }
};

kung::Options taken(const WaveArguments& arguments) {
  kung::Options options;
  apply_waves(options, arguments);
  check_waves(options);
  return options;
}

std::string message_of(const WaveArguments& arguments) {
  try {
    taken(arguments);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

WaveArguments fst() { return {"fst", "", "", "", ""}; }

// A run that lasts 10 ms, whose trigger fired as given and whose waves are these.
Simulate ran(std::optional<cosim::Clk> trigger, std::vector<kung::WaveSpan> spans) {
  return [=](const kung::Options& options, const kung::Hooks&) {
    kung::Result result;
    result.clocks = 500000;
    result.end = kung::EndReason::kDone;
    result.wave_trigger = trigger;
    result.waves = spans;
    std::ofstream(options.run.wave_file) << "waves";
    return result;
  };
}

int run_to(const fs::path& out, const WaveArguments& waves, const Simulate& simulate) {
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "circle";
  arguments.out = out.string();
  arguments.waves = waves;
  arguments.json = true;
  return run(arguments, simulate, stop);
}

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("the command line of waves sets their keys") {
  WaveArguments arguments = fst();
  arguments.window = "-1ms:3ms";
  arguments.trigger = "x.e > 100";
  kung::Options options = taken(arguments);
  CHECK(options.run.wave_begin_s == Approx(-1e-3));
  CHECK(options.run.wave_end_s == Approx(3e-3));
  CHECK(options.run.wave_trigger == "x.e > 100");
  arguments = fst();
  arguments.pre = "0.5ms";
  CHECK(taken(arguments).run.wave_pre_s == Approx(0.5e-3));
  arguments = fst();
  arguments.every = "50ms";
  CHECK(taken(arguments).run.wave_every_s == Approx(0.05));
}

TEST_CASE("a window reads seconds, milliseconds, microseconds and nanoseconds") {
  CHECK(parse_window("0:5ms").second == Approx(5e-3));
  CHECK(parse_window("10us:0.5").first == Approx(1e-5));
  CHECK(parse_window("20ns:1us").first == Approx(2e-8));
  for (const char* text : {"5", "0:5min", "5ms:1ms", "1ms:1ms", ":", "a:b"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_window(text), Contains("--wave-window: value"));
  }
}

TEST_CASE("an unknown signal of a trigger is met with a suggestion") {
  WaveArguments arguments = fst();
  arguments.trigger = "x.STATSU == 3";
  CHECK(message_of(arguments) ==
        "--wave-trigger: x.STATSU: unknown signal; did you mean x.STATUS?");
  arguments.trigger = "fault.encodr";
  CHECK_THAT(message_of(arguments), Contains("did you mean fault.encoder?"));
  arguments.trigger = "qqqqqqqqqqqq > 1";
  CHECK_THAT(message_of(arguments), Contains("trammel list signals"));
  arguments.trigger = "x.e >";
  CHECK_THAT(message_of(arguments), Contains("--wave-trigger: \"x.e >\" is none of"));
}

TEST_CASE("waves that cannot be are refused before the run") {
  WaveArguments arguments;
  for (std::string WaveArguments::*member : {&WaveArguments::window, &WaveArguments::trigger,
                                             &WaveArguments::pre, &WaveArguments::every}) {
    arguments = {};
    arguments.*member = "1ms";
    CHECK_THAT(message_of(arguments), Contains("needs --wave vcd or --wave fst"));
  }
  arguments = fst();
  arguments.window = "-1ms:1ms";
  CHECK_THAT(message_of(arguments), Contains("only a window around run.wave_trigger"));
  arguments.window = "60s:61s";
  CHECK_THAT(message_of(arguments), Contains("value 60 is outside the run, 0..60 s"));
  arguments.window = "0:5ms";
  arguments.pre = "1ms";
  CHECK_THAT(message_of(arguments), Contains("--wave-pre: is of the default window"));
  arguments.pre = "";
  arguments.every = "4ms";
  CHECK_THAT(message_of(arguments), Contains("value 0.004 is shorter than its window of 0.005"));
  arguments.every = "5";
  CHECK(message_of(arguments).empty());
  arguments.window = "0:1ns";
  CHECK_THAT(message_of(arguments), Contains("a window of 1e-09 s holds no clock"));
  arguments.window = "9ns:11ns";  // around the border between edges 0 and 1
  arguments.every = "2ns";
  CHECK_THAT(message_of(arguments), Contains("value 2e-09 is shorter than its window of 2e-09"));
  arguments.window = "0:5ms";
  arguments.every = "5 ms";
  CHECK_THAT(message_of(arguments), Contains("--wave-every: value \"5 ms\" is not a time"));
  arguments = {"fsdb", "", "", "", ""};
  CHECK_THAT(message_of(arguments), Contains("--wave: run.wave: value \"fsdb\""));
}

TEST_CASE("a trigger that never fired is one failure, and the run's record is kept") {
  const Scratch scratch;
  WaveArguments arguments = fst();
  arguments.trigger = "fault";
  CHECK(run_to(scratch.path / "a", arguments, ran({}, {})) == 1);
  CHECK(fs::exists(scratch.path / "a" / "metrics.json"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "waves.fst"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "waves.gtkw"));
}

TEST_CASE("a window behind the end of the run is one failure, and the run's record is kept") {
  const Scratch scratch;
  WaveArguments arguments = fst();
  arguments.window = "2s:3s";
  CHECK(run_to(scratch.path / "a", arguments, ran({}, {})) == 1);
  CHECK(fs::exists(scratch.path / "a" / "metrics.json"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "waves.fst"));
}

TEST_CASE("a VCD that cannot be made leaves the FST and is told by the exit code") {
  const Scratch scratch;
  WaveArguments arguments = fst();
  arguments.format = "vcd";
  CHECK(run_to(scratch.path / "a", arguments, ran(100, {{90, 190}})) == 1);
  CHECK(fs::exists(scratch.path / "a" / "waves.fst"));
  CHECK_FALSE(fs::exists(scratch.path / "a" / "waves.vcd"));
}

TEST_CASE("waves stand with their view, their windows and the trigger's time in the record") {
  const Scratch scratch;
  WaveArguments arguments = fst();
  arguments.trigger = "x.e > 100";
  CHECK(run_to(scratch.path / "a", arguments, ran(50000, {{40000, 140000}})) == 0);
  CHECK(content(scratch.path / "a" / "waves.fst") == "waves");
  const auto json = nlohmann::json::parse(std::ifstream(scratch.path / "a" / "metrics.json"));
  CHECK(json["waves"]["file"] == "waves.fst");
  CHECK(json["waves"]["trigger"] == "x.e > 100");
  CHECK(json["waves"]["trigger_s"] == Approx(1e-3));
  CHECK(json["waves"]["windows"] == 1);
  CHECK(json["waves"]["windows_s"][0][1] == Approx(2.8e-3));
  const std::string view = content(scratch.path / "a" / "waves.gtkw");
  CHECK_THAT(view, Contains("[dumpfile] \"" + (scratch.path / "a" / "waves.fst").string() + '"'));
  CHECK_THAT(view, Contains("[timestart] 800000\n"));
  CHECK_THAT(view, Contains(" 1000000 -1 -1"));  // the trigger is the marker, in ns
  CHECK_THAT(view, Contains("-X current loop"));
}

TEST_CASE("a view names the windows by markers and keeps nothing of another file") {
  kung::Result result;
  result.waves = {{0, 10000}, {2500000, 2510000}};
  const std::string view = placed_view(
      "[dumpfile] \"old\"\n[savefile] \"old\"\n[timestart] 7\n*-3.0 5 5\n[size] 1 1\n@28\na.b\n",
      "/o/waves.vcd", result);
  CHECK_THAT(view, Contains("[dumpfile] \"/o/waves.vcd\"\n[savefile] \"/o/waves.gtkw\"\n"));
  CHECK_THAT(view, Contains(" -1 0 50000000 -1 -1"));
  CHECK_THAT(view, Contains("[size] 1 1\n@28\na.b\n"));
  CHECK_THAT(view, !Contains("old") && !Contains("*-3.0"));
}

TEST_CASE("a file that is not FST gives no VCD and stays") {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  const fs::path file = scratch.path / "it's.fst";
  std::ofstream(file) << "not waves";
  CHECK_FALSE(fst_to_vcd(file, scratch.path / "it's.vcd"));
  CHECK(fs::exists(file));
  CHECK_FALSE(fs::exists(scratch.path / "it's.vcd"));
}
