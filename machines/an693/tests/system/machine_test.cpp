// SPDX-License-Identifier: Apache-2.0
//
// The whole machine an693: firmware, port, verilated LM628, motor. Numbers are those of AN-693 and
// the data sheet.

#include <catch2/catch.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "machines/an693/machine_members.hpp"
#include "machines/an693/session.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/failed_assertion.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/slope.hpp"
#include "tests/support/wirings.hpp"

using namespace trammel;
using namespace trammel::an693;
using sw::An693Program;

namespace {

Options make_options(An693Program program) {
  Options options;
  options.run.platform = cosim::Platform::kDirect;
  options.program = program;
  options.filter.kp = 50;
  options.filter.kd = 1000;
  options.filter.interval = 4;
  return options;
}

// A step of 50 counts.
Options one_step() {
  Options options = make_options(An693Program::kTuning);
  options.acceleration = options.velocity = 0x3FFFFFFF;
  options.position = 50;
  options.steps = 1;
  return options;
}

Options breakpoints() {
  Options options = make_options(An693Program::kBreakpoints);
  options.acceleration = 0x11;
  options.velocity = 0x20C4A;
  return options;
}

}  // namespace

// 45 088 are those of E7 at V = 41894h, the speed of E8.
TEST_CASE("E6 and E7 an693 complete after 45 772 and 45 087 samples, at rest on their targets") {
  Options options = make_options(An693Program::kAbsolute);
  Result result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kDone);
  CHECK(result.desired == 8000);
  CHECK(std::abs(result.real - 8000) <= 2);
  CHECK(test::figure(options, result, "motion.samples") == 45772);

  options = make_options(An693Program::kRelative);
  options.acceleration = 0x11;
  options.velocity = 0x41893;
  options.position = 120000;
  result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kDone);
  CHECK(result.desired == 120000);
  CHECK(std::abs(result.real - 120000) <= 2);
  CHECK(test::figure(options, result, "motion.samples") == 45087);
}

TEST_CASE("L-06 an693 with the motor leaps over 20 s of breakpoints in less than 60 s") {
  Result result = simulate(breakpoints(), {});
  CHECK(result.end == cosim::EndReason::kDone);
  figures(breakpoints(), result);
  REQUIRE(result.interrupts.size() == 3);
  CHECK(std::abs(result.interrupts[0].sample - 43010) <= 60);
  CHECK(std::abs(result.real - 192338) <= 500);
  CHECK(result.wall_s < 60);
}

TEST_CASE("an693: the event hash is that of edges, reasons, codes, reads and positions") {
  Options options = breakpoints();
  options.run.engine = cosim::Engine::kTwin;
  options.run.max_s = 0.15;
  const auto run = test::record_run<Session, Result>(options);
  test::check_event_hash(run, [&run](std::size_t n) {
    const lm628::Words words = run.result.samples[n].words;
    return test::HashedWords{{"desired position", static_cast<std::uint64_t>(words.position)},
                             {"actual position", static_cast<std::uint32_t>(words.actual)}};
  });
}

TEST_CASE("an693: the shaft of the record is where the counts are, and its speed is its slope") {
  Options options = breakpoints();
  options.run.engine = cosim::Engine::kTwin;
  options.run.max_s = 1;
  const Result result = simulate(options, {});
  const double counts = options.plant.counts / plant::MotorAxis::kTurn;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const Sample sample = result.samples[k];
    CAPTURE(k, sample.theta * counts);
    // The count is that of the sample's begin, and of an edge that lies behind the place.
    REQUIRE(std::abs(sample.theta * counts - sample.words.actual) <= 2);
  }
  test::require_slope("shaft", result.samples.size(), options.sample_s(), [&](std::size_t k) {
    const Sample sample = result.samples[k];
    return test::Motion{sample.theta, sample.omega};
  });
}

TEST_CASE("an693 gives one record in every wiring, and watched in every way") {
  for (Options options : {one_step(), breakpoints()}) {
    options.filter = {100, 20, 3000, 500, 2};
    options.run.max_s = 0.1;
    const Result first = test::check_wirings(options);
    CHECK(first.samples.size() > 300);
    CHECK(first.evaluated * 5 < first.clocks);
  }
  Options options = one_step();
  options.wait_s = 0.005;  // 2503 clocks are no part of a sample or of a pulse
  test::check_watched(options, 97 * 20e-9, 2503 * 20e-9);
}

TEST_CASE("an693 waves begin where the converter, HI or the interrupt first moves") {
  Options options = one_step();
  options.wait_s = 0.005;
  options.run.wave = cosim::WaveFormat::kFst;
  options.run.wave_file = test::own_file("an693_machine_test.fst");
  const auto traced = [&options](const std::string& trigger) {
    options.run.wave_trigger = trigger;
    Result result = simulate(options, {});
    std::filesystem::remove(options.run.wave_file);
    return result;
  };
  const Result hi = traced("hi");
  REQUIRE(hi.wave_trigger);
  const auto first = std::find_if(hi.samples.begin(), hi.samples.end(),
                                  [](const Sample& s) { return s.host_irq; });
  REQUIRE(first != hi.samples.end());
  CHECK(*hi.wave_trigger <= (*first).edge);
  CHECK(*hi.wave_trigger > (*first).edge - 12800);
  const Result drive = traced("");
  REQUIRE(drive.wave_trigger);
  CHECK(*drive.wave_trigger > *hi.wave_trigger);  // the strobes follow the results
  CHECK(drive.waves[0].end - drive.waves[0].begin == 100000);
  CHECK(*traced("irq").wave_trigger <= *hi.wave_trigger);
  CHECK(*traced("irq after 3ms").wave_trigger >= 150000);
  CHECK(*traced("at 4ms").wave_trigger == 200000);
  const Result never = traced("hi after 1s");
  CHECK_FALSE(never.wave_trigger);
  CHECK(never.waves.empty());
  CHECK(never.event_hash == hi.event_hash);
}

TEST_CASE("an693 ends at the sample after a failed assertion, and keeps its record") {
  Options options = one_step();
  options.run.assertions = true;
  cosim::Hooks hooks;
  hooks.progress = [](double) {
    test::fail_assertion("lm628.u_port.u_lm628_port_props.busy_ends");
  };
  const Result result = simulate(options, hooks);
  CHECK(result.end == cosim::EndReason::kAssertion);
  REQUIRE(result.assertion);
  CHECK(result.assertion->name == "busy_ends");
  CHECK(result.assertion->instance == "lm628.u_port");
  REQUIRE(result.samples.size() == 65);
  const Sample last = result.samples.back();
  CHECK(result.assertion->edge < last.edge);
  CHECK(result.assertion->edge > last.edge - 12800);
}

TEST_CASE("an693 reports its progress up to the end, and can be stopped") {
  Options options = breakpoints();
  options.breakpoint = 1000;
  options.acceleration = 0x1100;
  double last = 0;
  std::atomic<bool> stop{false};
  cosim::Hooks hooks;
  hooks.progress = [&last](double fraction) {
    CHECK(fraction >= last);
    last = fraction;
  };
  hooks.stop = &stop;
  CHECK(simulate(options, hooks).end == cosim::EndReason::kDone);
  CHECK(last > 0.9);
  hooks.progress = [&stop](double fraction) { stop = fraction > 0.1; };
  CHECK(simulate(options, hooks).end == cosim::EndReason::kStopped);
}

TEST_CASE("an693 holds the shaft against a torque with kp times the error") {
  Options options = make_options(An693Program::kHold);
  options.filter = {};
  options.wait_s = 2;
  options.plant.motor.external_torque = 0.01;
  const Result result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kDone);
  // 0.4 V for 0.2 A are 34 codes of 24 V / 2048, and a count is 10 / 16 of a code.
  CHECK(std::abs(result.desired - result.real - 54.6) <= 2);
}

// L-16, with the real port and converter around it.
TEST_CASE("an693 steps there and back, with 2 and 14 % of overshoot at kp 50 and 100") {
  Options options = one_step();
  options.steps = 4;
  for (const auto& [kp, percent] : {std::pair{50u, 2.0}, {100u, 14.3}}) {
    options.filter.kp = kp;
    Result result = simulate(options, {});
    CHECK(result.end == cosim::EndReason::kDone);
    CHECK(result.desired == 0);
    CHECK(std::abs(result.real) <= 2);
    const double settled_s = test::figure(options, result, "motion.settled_s");
    const double overshoot = test::figure(options, result, "motion.overshoot_counts") / 50 * 100;
    CAPTURE(kp, settled_s);
    CHECK(std::abs(overshoot - percent) <= 3);
    CHECK(result.interrupts.size() == 4);
    if (kp == 50) CHECK(settled_s < 0.060);
  }
}

TEST_CASE("an693: steps that the motor does not make are missed, by the first of them") {
  Options options = one_step();
  options.run.engine = cosim::Engine::kTwin;
  options.steps = 2;
  SECTION("no speed") { options.velocity = 0; }
  SECTION("no acceleration") { options.acceleration = 0; }
  SECTION("no force") { options.filter.kp = options.filter.kd = 0; }
  const Result result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kMissed);
  CHECK(result.step_ends.size() == 2);
  CHECK_THAT(result.fault, Catch::StartsWith("step 1 of 2: "));
}

// The part interrupts in the clock that publishes the sample.
TEST_CASE("an693: a run that ends as the part interrupts ends at that clock on both platforms") {
  Options options = one_step();
  options.diverged_counts = 10;
  const Result direct = simulate(options, {});
  REQUIRE(direct.end == cosim::EndReason::kDiverged);
  REQUIRE(direct.samples.back().host_irq);
  CHECK(direct.clocks == direct.samples.back().edge + 1);
  options.run.platform = cosim::Platform::kSystemC;
  CHECK(simulate(options, {}).clocks == direct.clocks);
}

TEST_CASE("an693 ends a program whose motor cannot follow, as diverged") {
  Options options = make_options(An693Program::kRelative);
  options.acceleration = 0x1000;
  options.velocity = 0xA00000;  // 97 rev/s, where 24 V give 76
  options.position = 3000000;
  const Result result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kDiverged);
}
