// SPDX-License-Identifier: Apache-2.0
//
// What a translator asks of its step and direction inputs, and the step that a breach of it costs.
#include "models/plant/step_input.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/plant/stepper_axis.hpp"

using trammel::plant::StepBreach;
using trammel::plant::StepInput;
using trammel::plant::StepInputConfig;
using trammel::plant::StepperAxis;
using trammel::plant::StepperAxisConfig;
using Kind = StepBreach::Kind;

namespace {

constexpr std::int64_t kClockPs = 20'000;

// Steps in the end, and the breach, of a pulse of so many clocks: direction turns forward so many
// clocks before its edge, and back so many behind it.
struct Outcome {
  int steps = 0;
  Kind kind = Kind::kNone;
};
Outcome outcome(const StepInputConfig& config, int width, int setup, int hold) {
  StepInput input(config, kClockPs);
  Outcome sum;
  const auto pins = [&](std::int64_t n, bool step, bool forward) {
    const StepInput::Seen seen = input.at(n, step, forward);
    sum.steps += seen.pulse - seen.taken;
    if (seen.breach.kind != Kind::kNone) sum.kind = seen.breach.kind;
  };
  pins(0, false, false);
  pins(10'000 - setup, setup == 0, true);
  if (setup != 0) pins(10'000, true, true);
  if (width < hold) {
    pins(10'000 + width, false, true);
    pins(10'000 + hold, false, false);
  } else {
    pins(10'000 + hold, true, false);
    pins(10'000 + width, false, false);
  }
  return sum;
}

}  // namespace

TEST_CASE("step_input: each time is kept to the clock, and a breach of it costs its step") {
  const StepInputConfig config{3e-6, 2e-6, 5e-6};  // 150, 100 and 250 clocks
  const struct {
    int width, setup, hold;
    Kind kind;
  } cases[] = {{150, 100, 250, Kind::kNone},  {149, 100, 250, Kind::kWidth},
               {150, 99, 250, Kind::kSetup},  {150, 100, 249, Kind::kHold},
               {400, 100, 300, Kind::kNone},  {400, 100, 249, Kind::kHold},
               {150, 0, 250, Kind::kSetup}};
  for (const auto& one : cases) {
    CAPTURE(one.width, one.setup, one.hold);
    const Outcome is = outcome(config, one.width, one.setup, one.hold);
    CHECK(is.kind == one.kind);
    CHECK(is.steps == (one.kind == Kind::kNone ? 1 : 0));
  }
  CHECK(outcome({0, 0, 0}, 1, 0, 2).steps == 1);  // of nothing nothing is a breach
}

TEST_CASE("step_input: a direction that turns between pulses costs nothing, near one its step") {
  // Two pulses forward, 250 us apart, and there and back between them, so far behind the first.
  for (const bool fitted : {true, false}) {
    for (const int behind : {20, 49, 50, 5'000, 12'300, 12'460, 12'499}) {
      StepperAxisConfig config;
      config.buffer.fitted = fitted;
      StepperAxis axis(config);
      bool last = false;
      const auto pins = [&](std::int64_t n, bool step, bool forward) {
        while (axis.next() < n) axis.drive(axis.next(), last, true, false);
        axis.drive(n, step, forward, false);
        last = step;
      };
      pins(1000, true, true);
      if (behind < 104) {  // in the pulse
        pins(1000 + behind, true, false);
        pins(1000 + behind + 1, true, true);
      }
      pins(1104, false, true);
      if (behind >= 104) {
        pins(1000 + behind, false, false);
        pins(1000 + behind + 1, false, true);
      }
      pins(13'500, true, true);
      pins(13'604, false, true);
      pins(30'000'000, false, true);
      const int breaches = behind < 50 || behind > 12'450 ? 1 : 0;
      CAPTURE(fitted, behind);
      CHECK(axis.breaches().size() == static_cast<std::size_t>(breaches));
      CHECK(axis.translated() == 402 - breaches);
      CHECK(axis.waiting() == 0);
    }
  }
}

TEST_CASE("step_input: four turns within 0.6 us cost the step whose hold or set-up they meet") {
  // The first pulse is 104 clocks wide; direction is looked at 50 clocks on either side of an edge.
  for (const int first : {15, 49, 50, 90, 3'065, 12'419, 12'420, 12'421, 12'465}) {
    StepInput input({}, kClockPs);
    int steps = 0, breaches = 0;
    const auto pins = [&](std::int64_t n, bool step, bool forward) {
      const StepInput::Seen seen = input.at(n, step, forward);
      steps += seen.pulse - seen.taken;
      breaches += seen.breach.kind != Kind::kNone ? 1 : 0;
    };
    constexpr std::int64_t kPulse = 1000, kNext = kPulse + 12'500, kWidth = 104;
    const auto high = [](std::int64_t n) {
      return (n >= kPulse && n < kPulse + kWidth) || n >= kNext;
    };
    pins(0, false, true);
    for (std::int64_t n = kPulse; n <= kNext; ++n) {
      const std::int64_t since = n - kPulse - first;
      pins(n, high(n), since < 0 || since >= 30 || since / 10 % 2 == 1);
    }
    const int lost = first < 50 || first + 30 > 12'450 ? 1 : 0;
    CAPTURE(first);
    CHECK(breaches == lost);
    CHECK(steps == 2 - lost);
  }
}

TEST_CASE("step_input: a buffer that has lost its only pulse stands, and takes the next one") {
  StepperAxisConfig config;
  config.input.width_s = 3e-6;
  StepperAxis axis(config);
  axis.drive(1000, true, true, false);
  CHECK(axis.waiting() == 1);
  axis.drive(1104, false, true, false);
  CHECK(axis.waiting() == 0);
  CHECK(axis.next() == 1105);  // it is no longer busy
  axis.drive(1105, false, true, false);
  CHECK(axis.next() == StepperAxis::kNever);
  axis.drive(5000, true, true, false);
  axis.drive(5200, false, true, false);
  CHECK(axis.waiting() == 1);
}
