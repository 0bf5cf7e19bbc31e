// SPDX-License-Identifier: Apache-2.0
//
// Keys, figures and files of the machine an693, from results made by hand.

#include "testbench/an693.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/part_json.hpp"
#include "testbench/report_data.hpp"
#include "testbench/report_page.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::testbench;
using test::content;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string message_of(const std::string& toml) {
  return test::message_of<lm628::Options>(toml);
}

// Off, then a step of 4 counts, overshoot by 1, an interrupt at the 5th sample.
lm628::Result by_hand() {
  lm628::Result result;
  result.end = cosim::EndReason::kDone;
  const int real[] = {0, 0, 1, 4, 5, 4, 4};
  for (int n = 0; n < 7; ++n) {
    lm628::Sample s;
    s.edge = 12800 * (n + 1);
    s.words.status = n == 0 ? 0x80 : 0x00;
    s.words.position = std::int64_t{n == 0 ? 0 : 4} << 16;
    s.words.actual = real[n];
    s.words.error = n == 0 ? 0 : 4 - real[n];
    s.theta = real[n] * plant::MotorAxis::kTurn / 4000;
    s.host_irq = n >= 5;
    s.volt = n == 3 ? -3.5 : 1;
    result.samples.push_back(s);
  }
  result.desired = result.real = 4;
  result.clocks = 100000;
  result.evaluated = 1000;
  return result;
}

}  // namespace

TEST_CASE("an693 scenarios load, can run, and repeat from run.toml") {
  const auto files = scenarios("an693");
  CHECK(files.size() == 5);
  for (const auto& file : files) {
    INFO(file);
    CHECK(machine_of(file) == "an693");
    lm628::Options options, again;
    apply_file(options, file);
    finish(options);
    apply_text(again, run_toml(options), "run.toml", ".");
    for (const auto& key : keys_of<lm628::Options>()) {
      CHECK(value_text(key.get(again)) == value_text(key.get(options)));
    }
  }
}

TEST_CASE("keys of another machine, unknown keys and bad values are refused in one line") {
  CHECK(message_of("[gains]\nkp = 1\n") ==
        "some.toml:2: gains.kp: is no key of the machine an693");
  CHECK(message_of("[filter]\nkq = 1\n") ==
        "some.toml:2: filter.kq: unknown key; did you mean filter.kd?");
  CHECK_THAT(message_of("machine = 'kung'\n"), Contains("is not one of an693"));
  CHECK_THAT(message_of("[filter]\nkp = 32768\n"), Contains("is out of range 0..32767"));
  CHECK_THAT(message_of("[motor]\nresistance_ohm = 900\n"), Contains("motor.inductance_H"));
  CHECK_THAT(message_of("[encoder]\ncounts = 4001\n"), Contains("no multiple of 4"));
  kung::Options options;
  CHECK_THROWS_WITH(apply_assignment(options, "filter.kp=1"),
                    Contains("filter.kp: is no key of the machine kung"));
}

TEST_CASE("a file says of which machine it is") {
  const fs::path file = "an693_test.toml";
  std::ofstream(file) << "[path]\nkind = 'circle'\n";
  CHECK(machine_of(file) == "kung");
  std::ofstream(file) << "machine = [\n";
  CHECK(machine_of(file) == "kung");  // who reads it tells what is wrong
  std::ofstream(file) << "\nmachine = 'an692'\n";
  CHECK_THROWS_WITH(machine_of(file),
                    Contains("an693_test.toml:2: machine: value \"an692\"") &&
                        Contains("did you mean an693?"));
  fs::remove(file);
}

TEST_CASE("an693 figures count samples from the first that moves") {
  const lm628::Options options;
  const An693Metrics m = evaluate(options, by_hand());
  CHECK(m.moving_samples == 1);
  CHECK(m.overshoot_counts == Approx(1));
  CHECK(m.max_error_counts == 4);
  CHECK(m.max_voltage_V == 3.5);
  CHECK(m.settled_s == Approx(2 * 256e-6));
  REQUIRE(m.interrupts.size() == 1);
  CHECK(m.interrupts[0].sample == 5);
  CHECK(m.interrupts[0].real == 4);
}

TEST_CASE("an693 interrupts before the desired position moves are told, as of sample 0") {
  lm628::Result result;
  for (int n = 0; n < 4; ++n) {
    lm628::Sample s;
    s.edge = 12800 * (n + 1);
    s.host_irq = n == 1 || n == 3;
    result.samples.push_back(s);
  }
  const An693Metrics m = evaluate(lm628::Options{}, result);
  REQUIRE(m.interrupts.size() == 2);
  CHECK(m.interrupts[0].sample == 0);
  CHECK(m.interrupts[1].time_s == Approx(4 * 256e-6));
}

TEST_CASE("an693 runs leave metrics.json, trace.csv and run.toml, and say how they ended") {
  const std::atomic<bool> stop{false};
  lm628::Options options;
  RunArguments arguments;
  arguments.out = "an693_test_out";
  arguments.json = true;
  auto end = cosim::EndReason::kDone;
  std::string fault;
  const SimulateAn693 simulate = [&](const lm628::Options&, const cosim::Hooks& hooks) {
    hooks.progress(0.5);
    lm628::Result result = by_hand();
    result.end = end;
    result.fault = fault;
    return result;
  };
  CHECK(run_an693(options, arguments, simulate, stop) == 0);
  const auto json = nlohmann::json::parse(content("an693_test_out/metrics.json"));
  CHECK(json["machine"] == "an693");
  CHECK(json["motion"]["overshoot_counts"].get<double>() == Approx(1));
  CHECK(json["options"]["motor.resistance_ohm"] == 2.0);
  CHECK_THAT(content("an693_test_out/trace.csv"),
             Contains("0.00025600,0.00000,0.00000,0,0.0000,0"));
  CHECK_THAT(content("an693_test_out/run.toml"), Contains("machine = \"an693\""));
  CHECK(fs::exists("an693_test_out/motion.svg") == !find_program("gnuplot").empty());
  CHECK_THAT(content("an693_test_out/report.html"), Contains("\"machine\":\"an693\""));
  CHECK(report({{"an693_test_out"}, {}, false}) == 0);

  arguments.json = false;
  options.program = sw::An693Program::kTuning;
  options.description = "a step";
  CHECK(run_an693(options, arguments, simulate, stop) == 0);
  end = cosim::EndReason::kFault;
  fault = "the busy bit did not clear";
  CHECK(run_an693(options, arguments, simulate, stop) == 5);
  fs::remove_all("an693_test_out");
}

TEST_CASE("a bit of one sample is on a page that shows one of three") {
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.out = "an693_test_out";
  arguments.json = true;
  std::vector<std::string> series;
  for (const int sample : {-1, 4}) {
    const auto simulate = [sample](const lm628::Options&, const cosim::Hooks&) {
      lm628::Result result;
      for (int n = 0; n < 7; ++n) {
        lm628::Sample s;
        s.words.status = n == sample ? 0x40 : 0;
        result.samples.push_back(s);
      }
      return result;
    };
    run_an693({}, arguments, simulate, stop);
    const RunRecord run = read_run("an693_test_out");
    CHECK(run.first == 0);
    CHECK(page_series(run, {"status"}, 3).stride == 3);
    series.push_back(page_series(run, {"status"}, 3).data);
    CHECK(page_series(run, {}, 100).channels.size() == 15);
  }
  CHECK(series[0] != series[1]);
  fs::remove_all("an693_test_out");
}

TEST_CASE("an693 says how a run ended") {
  lm628::Options options;
  lm628::Result result;
  result.end = cosim::EndReason::kTimeout;
  CHECK(part_verdict(options, result) == "not finished within run.max_s = 120");
  result.end = cosim::EndReason::kDiverged;
  CHECK(part_verdict(options, result) == "diverged: error above run.diverged_counts = 30000");
  result.fault = "test:1: wait hi: not within 1 s";
  result.end = cosim::EndReason::kTimeout;
  CHECK(part_verdict(options, result) == result.fault);
  result.end = cosim::EndReason::kFault;
  CHECK(part_verdict(options, result) == "tripped: " + result.fault);
  result.end = cosim::EndReason::kStopped;
  CHECK(part_verdict(options, result) == "interrupted");
  result.end = cosim::EndReason::kPromise;
  result.promise = {"busy_ends", "lm628.u_port", "bus/lm628_port_props.sv:7", 50000};
  CHECK(part_verdict(options, result) ==
        "promise broken: busy_ends of lm628.u_port at 0.00100000 s, clock 50000 "
        "(bus/lm628_port_props.sv:7)");
}

TEST_CASE("run chooses the machine by the scenario, and refuses what this one has not") {
  const std::atomic<bool> stop{false};
  RunArguments arguments;
  arguments.scenario = "an693-hold";
  arguments.out = "an693_test_out";
  arguments.platform = "direct";
  arguments.report = false;
  bool ran = false;
  const SimulateAn693 simulate = [&](const lm628::Options& options, const cosim::Hooks&) {
    ran = options.program == sw::An693Program::kHold &&
          options.run.platform == cosim::Platform::kDirect;
    return by_hand();
  };
  CHECK(run(arguments, {}, stop, simulate) == 0);
  CHECK(ran);
  const SimulateAn693 breaks = [](const lm628::Options&, const cosim::Hooks&) {
    lm628::Result result = by_hand();
    result.end = cosim::EndReason::kPromise;
    result.promise = {"busy_ends", "lm628.u_port", "bus/lm628_port_props.sv:7", 50000};
    return result;
  };
  CHECK(run(arguments, {}, stop, breaks) == 4);
  CHECK_THAT(content(fs::path(arguments.out) / "metrics.json"), Contains("\"clock\": 50000"));
  arguments.audit = arguments.plain = true;
  CHECK_THROWS_WITH(run(arguments, {}, stop, simulate), Contains("not with --no-leap"));
  arguments.audit = arguments.plain = false;
  arguments.check = true;
  CHECK_THROWS_WITH(run(arguments, {}, stop, simulate), Contains("--check: is not offered"));
  arguments.check = false;
  arguments.waves.format = "fst";
  arguments.waves.trigger = "x.e > 3";
  CHECK_THROWS_WITH(run(arguments, {}, stop, simulate), Contains("x.e: unknown signal"));
  arguments.waves.trigger = "";
  const SimulateAn693 traced = [](const lm628::Options& options, const cosim::Hooks&) {
    lm628::Result result = by_hand();
    result.waves = {{90000, 95000}};
    result.wave_trigger = 91000;
    std::ofstream(options.run.wave_file) << "waves";
    return result;
  };
  CHECK(run(arguments, {}, stop, traced) == 0);
  const fs::path out = arguments.out;
  CHECK_THAT(content(out / "metrics.json"), Contains("\"trigger\": \"drive\""));
  CHECK_THAT(content(out / "waves.gtkw"), Contains(" 1820000 -1") && Contains("-Host port"));
  fs::remove_all("an693_test_out");
}
