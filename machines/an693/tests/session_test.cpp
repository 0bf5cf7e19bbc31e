// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 records, held against its motor driven once more with the codes
// that the part drove, in either sense; and how its runs go on and end.
#include <catch2/catch.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "machines/an693/machine_members.hpp"
#include "machines/an693/session.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/message.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::an693;
using sw::An693Program;

namespace {

// By the twin, `counts` and back or forth in a tenth of a second.
Options quick(An693Program program, int counts) {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  options.run.platform = cosim::Platform::kDirect;
  options.program = program;
  options.position = counts;
  options.breakpoint = 1000;
  options.acceleration = 0x1000;
  options.velocity = 0x40000;
  options.wait_s = 0.05;
  options.run.max_s = 3;
  return options;
}

using Run = test::Recorded<Result>;

// Calls after(event, plant) behind each event of the run.
template <class After>
void replay(const Options& options, const Run& run, After after) {
  MotorPlant plant(options.plant, options.part);
  cosim::Lines drive = lm628::kZeroCode;
  for (const test::Event& event : run.events) {
    while (plant.next() < event.edge) plant.commit(plant.next(), drive);
    plant.commit(event.edge, drive = event.drive);
    after(event, plant);
  }
}

}  // namespace

TEST_CASE("an693: each sample is of the shaft, as the codes of the part turn it") {
  for (const int counts : {600, -600}) {
    CAPTURE(counts);
    const Options options = quick(An693Program::kAbsolute, counts);
    const Run run = test::record_run<Session, Result>(options);
    REQUIRE(run.result.samples.size() > 100);  // whether it then stands is not asked here
    CHECK(run.result.desired == counts);
    std::size_t sample = 0;
    double furthest = 0;
    replay(options, run, [&](const test::Event& event, MotorPlant& plant) {
      if ((event.why & cosim::kSample) == 0) return;
      REQUIRE(sample < run.result.samples.size());
      const Sample s = run.result.samples[sample++];
      const plant::DcMotorState state = plant.axis().state(event.edge);
      INFO("sample " << sample - 1 << ": theta " << s.theta << ", omega " << s.omega << ", i "
                     << s.i << ", volt " << s.volt << ", counts " << s.words.actual);
      REQUIRE(s.edge == event.edge);
      REQUIRE(s.theta == Approx(state.theta).margin(1e-9));
      REQUIRE(s.omega == Approx(state.omega).margin(1e-9));
      REQUIRE(s.i == Approx(state.i).margin(1e-9));
      REQUIRE(s.volt == Approx(plant.axis().voltage()).margin(1e-9));
      REQUIRE(s.words.actual ==
              Approx(s.theta / plant::MotorAxis::kTurn * options.plant.counts).margin(1.5));
      furthest = counts > 0 ? std::max(furthest, s.theta) : std::min(furthest, s.theta);
    });
    CHECK(sample == run.result.samples.size());
    CHECK(furthest * counts > 0);
  }
}

TEST_CASE("an693: what became of a fault is told from its clocks, currents and counts") {
  for (const int counts : {4000, -4000}) {
    CAPTURE(counts);
    Options options = quick(An693Program::kAbsolute, counts);
    options.error_limit = 300;
    options.fault.kind = cosim::FaultKind::kEncoderStuck;
    options.fault.begin_s = 0.09;
    const Run run = test::record_run<Session, Result>(options);
    const cosim::FaultReport& report = run.result.fault_report;
    CAPTURE(run.result.fault, report.by);
    REQUIRE(run.result.end == cosim::EndReason::kFault);
    CHECK(report.by == "the part reported a position error");
    CHECK(run.result.fault == report.by);
    CHECK(report.begin == 4'500'000);
    CHECK(report.unit == "counts");
    double peak_A = 0, off_at = 0, end_at = 0;
    cosim::Clk off = cosim::kNever;
    replay(options, run, [&](const test::Event& event, MotorPlant& plant) {
      if (event.edge < report.begin) return;
      const plant::DcMotorState state = plant.axis().state(event.edge);
      peak_A = std::max(peak_A, std::abs(state.i));
      end_at = state.theta / plant::MotorAxis::kTurn * options.plant.counts;
      if (off == cosim::kNever && event.edge >= report.detected &&
          event.drive == lm628::kZeroCode) {
        off = event.edge;
        off_at = end_at;
      }
    });
    CHECK(report.off == off);
    CHECK(report.peak_A == Approx(peak_A));
    CHECK(report.stopping == Approx(std::abs(end_at - off_at)).margin(1e-6));
    CHECK_FALSE(report.at_stop);
  }
}

TEST_CASE("an693: progress is the share of the time that the trajectory and the waits take") {
  for (const auto program : {An693Program::kHold, An693Program::kAbsolute, An693Program::kRelative,
                             An693Program::kBreakpoints, An693Program::kTuning}) {
    for (const int counts : {100, 3000, -3000}) {  // the first without a part of constant speed
      const Options options = quick(program, counts);
      std::vector<double> told;
      cosim::Hooks hooks;
      hooks.progress = [&told](double share) { told.push_back(share); };
      const Result result = simulate(options, hooks);
      CAPTURE(static_cast<int>(program), counts, result.seconds(result.clocks), told.size());
      REQUIRE(told.size() > 2);
      for (std::size_t k = 1; k < told.size(); ++k) CHECK(told[k] >= told[k - 1]);
      CHECK(told.front() < 0.5);
      CHECK(told.back() > 0.75);
      CHECK(*std::find_if(told.begin(), told.end(), [](double s) { return s > 0.74; }) <= 1);
      const auto full = std::count(told.begin(), told.end(), 1.0);
      CHECK(full <= 3);  // it does not stand at the end
    }
  }
}

TEST_CASE("an693: progress ends near its end, too, where ramps take all of the time") {
  for (const auto program : {An693Program::kAbsolute, An693Program::kBreakpoints}) {
    Options options = quick(program, 3000);
    options.acceleration = 0x80;
    options.velocity = program == An693Program::kAbsolute ? 0x3FFFFFFF : 0x20000;
    options.breakpoint = 4000;
    options.wait_s = 1e-3;
    double told = 0;
    int full = 0;
    cosim::Hooks hooks;
    hooks.progress = [&](double share) {
      told = share;
      full += share == 1 ? 1 : 0;
    };
    const Result result = simulate(options, hooks);
    CAPTURE(static_cast<int>(program), result.seconds(result.clocks), result.fault);
    REQUIRE(result.samples.size() > 2000);
    CHECK(told > 0.97);  // told each 64 samples
    CHECK(full <= 2);  // reset and commands are no part of it
  }
}

TEST_CASE("an693: a shaft too far from its trajectory ends the run as diverged, in either sense") {
  for (const int counts : {30000, -30000}) {
    CAPTURE(counts);
    Options options = quick(An693Program::kAbsolute, counts);
    options.diverged_counts = 200;
    options.filter.kp = 1;
    options.filter.ki = options.filter.kd = 0;
    const Result result = simulate(options, {});
    CHECK(result.end == cosim::EndReason::kDiverged);
    const Sample last = result.samples.back();
    CHECK(std::abs(last.words.error) > 200);
    CHECK(result.real == last.words.actual);
    CHECK(result.desired == last.words.position >> 16);
    CHECK(result.desired * static_cast<double>(counts) > 0);
  }
}

TEST_CASE("an693: a session tells its clock, its processor, its end and its place") {
  Options options = quick(An693Program::kAbsolute, 100);
  test::set_timing(options);
  options.run.clock_ps = 25'000;
  const std::unique_ptr<cosim::Session> session = machine().session(options, {}, {});
  test::check_timing(*session, 25'000);
}

TEST_CASE("an693: the place of a running session is its shaft's, in counts and in its sense") {
  for (const int counts : {600, -600}) {
    const Options options = quick(An693Program::kAbsolute, counts);
    Session session(options, {});
    test::run_through(session);
    const auto places = session.places();
    REQUIRE(places.size() == 1);
    CHECK(places[0].axis.empty());
    CHECK(places[0].unit == "count");
    const auto result = session.result();
    const auto& samples = static_cast<const Result&>(*result).samples;
    CHECK(places[0].value == Approx(shaft_counts(options, samples.back().theta)).margin(1));
    CHECK(std::abs(places[0].value) > 300);
  }
}

TEST_CASE("an693: a run can be stopped, ends at its time or where its trigger is found") {
  Options options = quick(An693Program::kAbsolute, 600);
  std::atomic<bool> stop{false};
  cosim::Hooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&stop](double) { stop = true; };  // told after 64 samples
  const Result stopped = simulate(options, hooks);
  CHECK(stopped.end == cosim::EndReason::kStopped);
  CHECK(stopped.samples.size() == 65);
  cosim::TriggerSearch search(cosim::parse_trigger("real_count > 100", triggers(), 20'000));
  const Result found = test::run_to<Session, Result>(options, &search);
  REQUIRE(search.found());
  const auto& samples = found.samples;
  CHECK(samples.back().edge == *search.found());
  CHECK(samples.back().words.actual > 100);
  CHECK(samples[samples.size() - 2].words.actual <= 100);
}

TEST_CASE("an693: the ends of the steps there and back are those of its program") {
  Options options = quick(An693Program::kTuning, 40);
  options.steps = 3;
  const Result result = simulate(options, {});
  CAPTURE(result.fault, result.samples.size());
  REQUIRE(result.step_ends.size() == 3);
  CHECK(result.step_ends.back() == result.samples.size());
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t end = result.step_ends[n];
    CAPTURE(n, end);
    const Sample last = result.samples[end - 1];
    CHECK(last.words.position >> 16 == (n % 2 == 0 ? 40 : 0));
    if (n < 2) CHECK(result.samples[end + 20].words.position != last.words.position);
  }
}

TEST_CASE("an693: a fault is on the encoder or any bit of the converter, or a line of the bridge") {
  const auto told = [](lm628::Variant variant, cosim::FaultKind kind, int line) {
    Options options = quick(An693Program::kHold, 100);
    options.run.max_s = 1e-3;
    options.part.variant = variant;
    options.fault.kind = kind;
    options.fault.line = line;
    return test::refusal_of<std::exception>([&] { simulate(options, {}); });
  };
  using Kind = cosim::FaultKind;
  using lm628::Variant;
  CHECK(told(Variant::kLm628, Kind::kEncoderStuck, 1) == "");
  CHECK(told(Variant::kLm628, Kind::kIndexLost, 0) == "");
  CHECK(told(Variant::kLm628, Kind::kOutputStuck, 11) == "");
  CHECK_THAT(told(Variant::kLm628, Kind::kOutputStuck, 12), Catch::Contains("inject.line"));
  CHECK(told(Variant::kLm629, Kind::kOutputStuck, lm628::kBridgeLines - 1) == "");
  CHECK_THAT(told(Variant::kLm629, Kind::kOutputStuck, lm628::kBridgeLines),
             Catch::Contains("inject.line"));
}
