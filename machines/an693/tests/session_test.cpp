// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 records, held against its motor driven once more with the codes
// that the part drove, in either sense; and how its runs go on and end.
#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "machines/an693/machine.hpp"
#include "machines/an693/session.hpp"
#include "tests/support/event_record.hpp"

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
      CAPTURE(static_cast<int>(program), counts, lab::seconds_of(result.clocks), told.size());
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
