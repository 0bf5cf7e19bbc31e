// SPDX-License-Identifier: Apache-2.0
//
// The runs that a run is compared with: made after one that ended well, and after no other.
#include <catch2/catch.hpp>
#include <string>

#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using cosim::EndReason;

namespace {

// take(settings, what they are compared with) of scenarios that are compared, until it is false.
template <class Take>
void each_compared(const Take& take) {
  std::size_t compared = 0;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const lab::Machine& machine = settings->machine();
    if (machine.companions == nullptr) continue;
    const auto wanted = machine.companions(*settings);
    if (wanted.empty()) continue;
    INFO("scenario " << settings->scenario);
    ++compared;
    if (!take(*settings, wanted)) break;
  }
  CHECK(compared > 0);
}

// The run and those beside it, the first with one end and the others with another.
lab::Record short_record(const lab::Settings& settings, EndReason first, EndReason others,
                         std::size_t& runs) {
  return lab::run_by(
      [&](const lab::Settings& one, const cosim::Hooks&) {
        return test::short_result(one, ++runs == 1 ? first : others);
      },
      settings);
}

}  // namespace

TEST_CASE("a comparison that is stopped ends the run as interrupted, and is not kept") {
  each_compared([](const lab::Settings& settings, const auto&) {
    std::size_t runs = 0;
    const lab::Record record =
        short_record(settings, EndReason::kDone, EndReason::kStopped, runs);
    CHECK(runs == 2);
    CHECK(record.result->end == EndReason::kStopped);
    CHECK(record.verdict == settings.machine().verdict(settings, *record.result));
    CHECK(record.companions.empty());
    return false;
  });
}

TEST_CASE("figures of a companion are printed unless its machine compares them by itself") {
  CHECK(lab::Companion{"other", nullptr}.printed);
  each_compared([](const lab::Settings& settings, const auto&) {
    std::size_t runs = 0;
    const lab::Record record = short_record(settings, EndReason::kDone, EndReason::kDone, runs);
    REQUIRE_FALSE(record.companions.empty());
    const std::string text = lab::report_text(record, "", false);
    for (const lab::Record& beside : record.companions) {
      const bool told = text.find("\n  " + beside.name + ": ") != std::string::npos;
      CHECK(told == beside.printed);
      CHECK(lab::metrics_json(record)["compared"].contains(beside.name));
    }
    return true;
  });
}

TEST_CASE("a broken assertion is told with its instance, or else as of the chip") {
  cosim::BrokenPromise promise{"no_shoot_through", "chip.u_leg", "leg.sv:7", 50000};
  CHECK(lab::promise_text(promise) ==
        "no_shoot_through of chip.u_leg at 0.00100000 s, clock 50000 (leg.sv:7)");
  promise.instance.clear();
  CHECK(lab::promise_text(promise) ==
        "no_shoot_through of the chip at 0.00100000 s, clock 50000 (leg.sv:7)");
}

TEST_CASE("what ended a run is told by its fault, or its promise before that") {
  struct Result final : cosim::RunResult {
    std::string fault;
    std::string fault_text() const override { return fault; }
  } result;
  result.end = EndReason::kFault;
  CHECK(lab::cause_text(result) == "");
  result.fault = "a limit";
  CHECK(lab::cause_text(result) == " by a limit");
  result.end = EndReason::kMissed;
  CHECK(lab::cause_text(result) == ": a limit");
  result.promise = {"no_shoot_through", "", "leg.sv:7", 50000};
  CHECK(lab::cause_text(result) == ": " + lab::promise_text(*result.promise));
}

TEST_CASE("each end of a run has its own word and the exit code of its kind") {
  const struct {
    EndReason end;
    const char* text;
    int code;
  } ends[] = {{EndReason::kDone, "done", 0},
              {EndReason::kFault, "tripped", 5},
              {EndReason::kDiverged, "diverged", 5},
              {EndReason::kMissed, "missed", 5},
              {EndReason::kTimeout, "timeout", 5},
              {EndReason::kStopped, "interrupted", 130},
              {EndReason::kPromise, "assertion failed", 4}};
  for (const auto& one : ends) {
    INFO("the end that is called " << one.text);
    CHECK(std::string(lab::end_text(one.end)) == one.text);
    CHECK(lab::exit_code(one.end) == one.code);
  }
}

TEST_CASE("a run that did not end well is compared with nothing") {
  std::size_t compared = 0;
  each_compared([&](const lab::Settings& settings, const auto& wanted) {
    for (const EndReason end : {EndReason::kDone, EndReason::kFault, EndReason::kDiverged,
                                EndReason::kMissed, EndReason::kTimeout, EndReason::kStopped,
                                EndReason::kPromise}) {
      INFO("a run that ended as " << lab::end_text(end));
      std::size_t runs = 0;
      const lab::Record record = short_record(settings, end, EndReason::kDone, runs);
      const bool compares = end == EndReason::kDone;
      CHECK(runs == (compares ? 1 + wanted.size() : 1));
      CHECK(record.result->end == end);
      REQUIRE(record.companions.size() == (compares ? wanted.size() : 0));
      for (std::size_t k = 0; k < record.companions.size(); ++k) {
        CHECK(record.companions[k].name == wanted[k].name);
      }
    }
    return ++compared < 3;
  });
}
