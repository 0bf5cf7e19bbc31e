// SPDX-License-Identifier: Apache-2.0
//
// Keys, figures and files of the machine an693, from results made by hand.

#include "machines/an693/machine.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lab/files.hpp"
#include "lab/layers.hpp"
#include "lab/report_data.hpp"
#include "lab/report_page.hpp"
#include "lab/scenarios.hpp"
#include "testbench/run.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/files.hpp"
#include "tests/support/lm628_words.hpp"
#include "tests/support/message.hpp"
#include "tests/support/told.hpp"

using namespace trammel;
using namespace trammel::lab;
using test::content;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string message_of(const std::string& toml) {
  return test::message_of<an693::Options>(toml);
}

// Off, then a step of 4 counts, overshoot by 1, an interrupt at the 5th sample.
an693::Result by_hand() {
  an693::Result result;
  result.end = cosim::EndReason::kDone;
  const int real[] = {0, 0, 1, 4, 5, 4, 4};
  for (int n = 0; n < 7; ++n) {
    an693::Sample s;
    s.edge = 12800 * (n + 1);
    s.words.status = n == 0 ? 0x80 : 0x00;
    s.words.position = std::int64_t{n == 0 ? 0 : 4} << 16;
    s.words.actual = real[n];
    s.words.error = n == 0 ? 0 : 4 - real[n];
    s.theta = real[n] * plant::MotorAxis::kTurn / 4000;
    s.host_irq = n >= 5;
    s.volt = n == 3 ? -3.5 : 1;
    s.omega = n == 3 ? -2.5 * plant::MotorAxis::kTurn : 1;
    s.i = n == 4 ? -0.75 : 0.5;
    result.samples.push_back(s);
  }
  result.desired = result.real = 4;
  result.clocks = 100000;
  result.evaluated = 1000;
  return result;
}

Record record_of(const Settings& settings, an693::Result result) {
  return judged(settings.clone(), std::make_unique<an693::Result>(std::move(result)));
}

}  // namespace

TEST_CASE("a shaft that is not at its target, or does not stand there, has missed it") {
  using Program = sw::An693Program;
  an693::Options options;
  options.program = Program::kAbsolute;
  options.position = 1000;
  // Moves to 1000 within 100 samples and stands for 200; where the shaft is then is the test's.
  const auto missed = [&options](auto real, int target = 1000) {
    an693::Result result;
    for (int n = 0; n < 300; ++n) {
      an693::Sample s;
      s.words.position = std::int64_t{std::min(n, 100) * target / 100} << 16;
      s.theta = real(n) * plant::MotorAxis::kTurn / options.plant.counts;
      result.samples.push_back(s);
    }
    return an693::what_missed(options, result);
  };
  const auto there = [](int n) { return n < 180 ? n * 5.0 : 1000.0; };
  CHECK(missed(there) == "");
  CHECK(missed([](int) { return 0.0; }) ==
        "the shaft is 1000 counts from the target of 1000");
  CHECK(missed([](int) { return 951.0; }) == "");
  CHECK(missed([](int) { return 949.0; }) ==
        "the shaft is 51 counts from the target of 1000");
  CHECK(missed([](int n) { return n % 2 == 0 ? 974.0 : 1026.0; }) ==
        "the shaft moves by 52 counts at the end");
  options.reached_counts = 60;
  CHECK(missed([](int n) { return n % 2 == 0 ? 974.0 : 1026.0; }) == "");
  options.position = 8;
  options.reached_counts = 0;
  CHECK(missed([](int) { return 5.0; }, 8) == "");
  CHECK(missed([](int) { return 4.0; }, 8) == "the shaft is 4 counts from the target of 8");
  CHECK(missed([](int) { return 9.0; }, 9) == "the trajectory ended at 9 counts, not at 8");
  // A held shaft gives way to a torque, but stands.
  options.program = Program::kHold;
  CHECK(missed([](int) { return 5000.0; }, 0) == "");
  CHECK(missed([](int n) { return n % 2 * 51.0; }, 0) ==
        "the shaft moves by 51 counts at the end");
}

TEST_CASE("each step there and back is judged, not the last alone") {
  an693::Options options;
  options.program = sw::An693Program::kTuning;
  options.position = 40;
  // Three steps of 100 samples; where trajectory and shaft are is the test's.
  const auto missed = [&options](auto desired, auto real) {
    an693::Result result;
    for (int n = 0; n < 300; ++n) {
      an693::Sample s;
      s.words.position = std::int64_t{desired(n)} << 16;
      s.theta = real(n) * plant::MotorAxis::kTurn / options.plant.counts;
      result.samples.push_back(s);
    }
    result.step_ends = {100, 200, 300};
    return an693::what_missed(options, result);
  };
  const auto asked = [](int n) { return n / 100 % 2 == 0 ? 40 : 0; };
  const auto there = [&asked](int n) { return n % 100 < 40 ? 20.0 : asked(n); };
  CHECK(missed(asked, there) == "");
  CHECK(missed([](int) { return 0; }, [](int) { return 0.0; }) ==
        "step 1 of 3: the trajectory ended at 0 counts, not at 40");
  CHECK(missed(asked, [&](int n) { return n < 100 ? 0.0 : there(n); }) ==
        "step 1 of 3: the shaft is 40 counts from the target of 40");
  CHECK(missed(asked, [&](int n) { return n / 100 == 1 ? 11.0 : there(n); }) ==
        "step 2 of 3: the shaft is 11 counts from the target of 0");
  CHECK(missed(asked, [&](int n) { return n / 100 == 1 ? n % 2 * 11.0 : there(n); }) ==
        "step 2 of 3: the shaft moves by 11 counts at the end");
}

TEST_CASE("an693 scenarios load, can run, and repeat from run.toml") {
  int own = 0;
  for (const auto& file : scenarios()) {
    if (&machine_of(file) != &an693::machine()) continue;
    ++own;
    INFO(file);
    CHECK(file.parent_path().parent_path().filename() == "an693");
    an693::Options options, again;
    apply_file(options, file);
    validate(options);
    apply_text(again, run_toml(options), "run.toml", ".");
    for (const auto& key : an693::keys()) {
      CHECK(value_text(key.get(again)) == value_text(key.get(options)));
    }
  }
  CHECK(own == 5);
}

TEST_CASE("keys of another machine, unknown keys and bad values are refused in one line") {
  CHECK(message_of("[gains]\nkp = 1\n") ==
        "some.toml:2: gains.kp: not a key of the machine an693");
  CHECK(message_of("[filter]\nkq = 1\n") ==
        "some.toml:2: filter.kq: unknown key; did you mean filter.kd?");
  CHECK_THAT(message_of("machine = 'another'\n"), Contains("is not one of an693"));
  CHECK_THAT(message_of("[filter]\nkp = 32768\n"), Contains("is out of range 0..32767"));
  CHECK_THAT(message_of("[motor]\nresistance_ohm = 900\n"), Contains("motor.inductance_H"));
  CHECK_THAT(message_of("[motor]\nconstant_N_m_A = 2\ninertia_kg_m2 = 1e-6\ninductance_H = 1e-4\n"
                        "coulomb_N_m = 0\nresistance_ohm = 1\n"),
             Contains("motor.constant_N_m_A / sqrt") && Contains("is above 1e5 1/s"));
  CHECK_THAT(message_of("[encoder]\ncounts = 4001\n"), Contains("is not a multiple of 4"));
}

TEST_CASE("an693 figures count samples from the first that moves") {
  an693::Result result = by_hand();
  const auto motion = [&](const std::string& name) {
    return test::figure(an693::Options{}, result, "motion." + name);
  };
  CHECK(motion("samples") == 1);
  CHECK(motion("overshoot_counts") == Approx(1));
  CHECK(motion("max_error_counts") == 4);
  CHECK(motion("max_voltage_V") == 3.5);
  CHECK(motion("max_speed_rev_s") == Approx(2.5));
  CHECK(motion("max_current_A") == 0.75);
  CHECK(motion("time_s") == Approx(256e-6));
  CHECK(motion("settled_s") == Approx(2 * 256e-6));
  CHECK(motion("interrupts") == 1);
  REQUIRE(result.interrupts.size() == 1);
  CHECK(result.interrupts[0].sample == 5);
  CHECK(result.interrupts[0].real == 4);
}

TEST_CASE("an693: each column of the trace shows what it is named after") {
  an693::Result result;
  an693::Sample s;
  s.edge = 150'000;
  s.words = test::numbered_words(100);
  s.host_irq = true;
  s.theta = plant::MotorAxis::kTurn / 4;
  s.omega = 121;
  s.i = 122;
  s.volt = 123;
  result.samples.push_back(s);
  std::map<std::string, double> expected = test::numbered_columns("", 100);
  expected.insert({{"t_s", 3e-3}, {"host_irq", 1}, {"theta_count", 1000}, {"omega_rad_s", 121},
                   {"i_A", 122}, {"u_V", 123}});
  test::check_row(test::row(an693::Options{}, result, 0), expected);
}

TEST_CASE("an693: with the motor off a shaft pushed away is no motion, and no overshoot") {
  an693::Result result = by_hand();
  const int pushed[] = {10, 14};  // where the desired position follows the real one
  for (int n = 0; n < 2; ++n) {
    an693::Sample s = result.samples.back();
    s.edge += 12800;
    s.words.status = 0x80;
    s.words.position = std::int64_t{pushed[n]} << 16;
    s.words.actual = pushed[n] + n;
    s.theta = (pushed[n] + 3) * plant::MotorAxis::kTurn / 4000;
    s.host_irq = n == 1;
    result.samples.push_back(s);
  }
  CHECK(test::figure(an693::Options{}, result, "motion.samples") == 1);
  CHECK(test::figure(an693::Options{}, result, "motion.overshoot_counts") == Approx(1));
  REQUIRE(result.interrupts.size() == 2);
  CHECK(result.interrupts[1].desired == 14);
  CHECK(result.interrupts[1].real == 15);
}

TEST_CASE("an693 interrupts before the desired position moves are listed as of sample 0") {
  an693::Result result;
  for (int n = 0; n < 4; ++n) {
    an693::Sample s;
    s.edge = 12800 * (n + 1);
    s.host_irq = n == 1 || n == 3;
    result.samples.push_back(s);
  }
  an693::figures(an693::Options{}, result);
  REQUIRE(result.interrupts.size() == 2);
  CHECK(result.interrupts[0].sample == 0);
  CHECK(result.interrupts[1].time_s == Approx(4 * 256e-6));
}

TEST_CASE("an693 runs leave metrics.json, trace.csv and run.toml, and say how they ended") {
  const std::atomic<bool> stop{false};
  testbench::Arguments arguments;
  arguments.scenario = "an693-absolute";
  arguments.out = "an693_test_out";
  arguments.json = true;
  auto end = cosim::EndReason::kDone;
  std::string fault;
  const testbench::Simulate simulate = [&](const Settings& settings, const cosim::Hooks& hooks) {
    hooks.progress(0.5);
    an693::Result result = by_hand();
    result.end = end;
    result.fault = fault;
    return record_of(settings, std::move(result));
  };
  CHECK(testbench::run(arguments, stop, simulate) == 0);
  const auto json = nlohmann::json::parse(content("an693_test_out/metrics.json"));
  CHECK(json["machine"] == "an693");
  CHECK(json["motion"]["overshoot_counts"].get<double>() == Approx(1));
  CHECK(json["options"]["motor.resistance_ohm"] == 2.0);
  CHECK_THAT(content("an693_test_out/trace.csv"),
             Contains("0.00025600,0.00000,0.00000,0,0.0000,0"));
  CHECK_THAT(content("an693_test_out/run.toml"), Contains("machine = \"an693\""));
  CHECK(fs::exists("an693_test_out/motion.svg") == !find_program("gnuplot").empty());
  CHECK_THAT(content("an693_test_out/report.html"), Contains("\"machine\":\"an693\""));
  testbench::Arguments again;
  again.folders = {"an693_test_out"};
  CHECK(testbench::report(again) == 0);

  arguments.json = false;
  arguments.assignments = {"program=tuning", "description=a step"};
  CHECK(testbench::run(arguments, stop, simulate) == 0);
  end = cosim::EndReason::kFault;
  fault = "the busy bit did not clear";
  CHECK(testbench::run(arguments, stop, simulate) == 5);
  fs::remove_all("an693_test_out");
}

TEST_CASE("a status bit of one sample shows on a page that keeps every third sample") {
  const std::atomic<bool> stop{false};
  testbench::Arguments arguments;
  arguments.scenario = "an693-absolute";
  arguments.out = "an693_test_out";
  arguments.json = true;
  std::vector<std::string> series;
  for (const int sample : {-1, 4, 5}) {  // 5 is the last of its three
    const auto simulate = [sample](const Settings& settings, const cosim::Hooks&) {
      an693::Result result;
      for (int n = 0; n < 7; ++n) {
        an693::Sample s;
        s.words.status = n == sample ? 0x40 : 0;
        result.samples.push_back(s);
      }
      return record_of(settings, std::move(result));
    };
    testbench::run(arguments, stop, simulate);
    const RunFolder run = read_run("an693_test_out");
    CHECK(run.first == 0);
    CHECK(page_series(run, false, 3).stride == 3);
    series.push_back(page_series(run, false, 3).channels.dump());
    CHECK(page_series(run, false, 100).channels.size() == 15);
  }
  INFO("page_series: series of a page without the bit, with it in sample 4, in sample 5");
  CHECK(series[0] != series[1]);
  CHECK(series[2] == series[1]);
  fs::remove_all("an693_test_out");
}

TEST_CASE("an693 says how a run ended") {
  const an693::Options options;
  an693::Result result;
  const auto verdict = [&] { return an693::machine().verdict(options, result); };
  result.end = cosim::EndReason::kTimeout;
  CHECK(verdict() == "not finished within run.max_s = 120");
  result.end = cosim::EndReason::kDiverged;
  CHECK(verdict() == "diverged: error above run.diverged_counts = 30000");
  result.fault = "test:1: wait hi: not within 1 s";
  result.end = cosim::EndReason::kTimeout;
  CHECK(verdict() == result.fault);
  result.end = cosim::EndReason::kFault;
  CHECK(verdict() == "tripped: " + result.fault);
  result.end = cosim::EndReason::kStopped;
  CHECK(verdict() == "interrupted");
  result.end = cosim::EndReason::kPromise;
  result.promise = {"busy_ends", "lm628.u_port", "bus/lm628_port_props.sv:7", 50000};
  CHECK(verdict() ==
        "assertion failed: busy_ends of lm628.u_port at 0.00100000 s, clock 50000 "
        "(bus/lm628_port_props.sv:7)");
}

TEST_CASE("run chooses the machine by the scenario, and refuses what that machine lacks") {
  const std::atomic<bool> stop{false};
  testbench::Arguments arguments;
  arguments.scenario = "an693-hold";
  arguments.out = "an693_test_out";
  arguments.keys = {{"--platform", "run.platform=direct"}};
  arguments.report = false;
  bool ran = false;
  const testbench::Simulate simulate = [&](const Settings& settings, const cosim::Hooks&) {
    REQUIRE(&settings.machine() == &an693::machine());
    const auto& options = static_cast<const an693::Options&>(settings);
    ran = options.program == sw::An693Program::kHold &&
          options.run.platform == cosim::Platform::kDirect;
    return record_of(settings, by_hand());
  };
  CHECK(testbench::run(arguments, stop, simulate) == 0);
  CHECK(ran);
  const testbench::Simulate breaks = [](const Settings& settings, const cosim::Hooks&) {
    an693::Result result = by_hand();
    result.end = cosim::EndReason::kPromise;
    result.promise = {"busy_ends", "lm628.u_port", "bus/lm628_port_props.sv:7", 50000};
    return record_of(settings, std::move(result));
  };
  CHECK(testbench::run(arguments, stop, breaks) == 4);
  CHECK_THAT(content(fs::path(arguments.out) / "metrics.json"), Contains("\"clock\": 50000"));
  arguments.keys = {{"--audit", "run.audit=true"}, {"--no-leap", "run.leap=false"}};
  CHECK_THROWS_WITH(testbench::run(arguments, stop, simulate), Contains("not with --no-leap"));
  arguments.keys.clear();
  arguments.check = true;
  CHECK(test::told([&] { CHECK(testbench::run(arguments, stop, simulate) == 2); }) ==
        "trammel: an693-hold: --check: no figure of this scenario has an expected value with "
        "these settings\n");
  arguments.check = false;
  arguments.waves.format = "fst";
  arguments.waves.trigger = "x.e > 3";
  CHECK_THROWS_WITH(testbench::run(arguments, stop, simulate), Contains("x.e: unknown signal"));
  arguments.waves.trigger = "";
  const testbench::Simulate traced = [](const Settings& settings, const cosim::Hooks&) {
    an693::Result result = by_hand();
    result.waves = {{90000, 95000}};
    result.wave_trigger = 91000;
    std::ofstream(settings.run.wave_file) << "waves";
    return record_of(settings, std::move(result));
  };
  CHECK(testbench::run(arguments, stop, traced) == 0);
  const fs::path out = arguments.out;
  CHECK_THAT(content(out / "metrics.json"), Contains("\"trigger\": \"drive\""));
  CHECK_THAT(content(out / "waves.gtkw"), Contains(" 1820000 -1") && Contains("-Host port"));
  fs::remove_all("an693_test_out");
}

TEST_CASE("an693: the first step takes until it stays in the band, however many samples it moves") {
  const an693::Options options;
  for (const int moving : {1, 2, 10, 30}) {
    CAPTURE(moving);
    an693::Result result;
    for (int n = 0; n < 100; ++n) {  // back to 0 from sample 60 on, where the shaft does not follow
      const int desired = n < 60 ? std::min(n, moving) * 60 / moving : 0;
      const int shaft = n < 60 ? desired - (n > 0 && n <= 20 ? 3 : 0) : 60;
      an693::Sample s;
      s.words.position = std::int64_t{desired} << 16;
      s.theta = shaft * plant::MotorAxis::kTurn / options.plant.counts;
      result.samples.push_back(s);
    }
    CHECK(test::figure(options, result, "motion.settled_s") == Approx(20 * options.sample_s()));
  }
}
