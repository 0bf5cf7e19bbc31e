// SPDX-License-Identifier: Apache-2.0
//
// The runs that a run is compared with: made after one that ended well, and after no other.
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using cosim::EndReason;

TEST_CASE("a comparison that is stopped ends the run as interrupted, and is not kept") {
  bool compared = false;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const lab::Machine& machine = settings->machine();
    if (machine.companions == nullptr || machine.companions(*settings).empty()) continue;
    INFO("scenario " << settings->scenario);
    std::size_t runs = 0;
    const lab::Record record = lab::run_by(
        [&](const lab::Settings& one, const cosim::Hooks&) {
          return test::short_result(one, ++runs == 1 ? EndReason::kDone : EndReason::kStopped);
        },
        *settings);
    CHECK(runs == 2);
    CHECK(record.result->end == EndReason::kStopped);
    CHECK(record.verdict == machine.verdict(*settings, *record.result));
    CHECK(record.companions.empty());
    compared = true;
    break;
  }
  CHECK(compared);
}

TEST_CASE("figures of a companion are printed unless its machine compares them by itself") {
  bool compared = false;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const lab::Machine& machine = settings->machine();
    if (machine.companions == nullptr || machine.companions(*settings).empty()) continue;
    INFO("scenario " << settings->scenario);
    const lab::Record record = lab::run_by(
        [&](const lab::Settings& one, const cosim::Hooks&) {
          return test::short_result(one, EndReason::kDone);
        },
        *settings);
    REQUIRE_FALSE(record.companions.empty());
    const std::string text = lab::report_text(record, "", false);
    for (const lab::Record& beside : record.companions) {
      const bool told = text.find("\n  " + beside.name + ": ") != std::string::npos;
      CHECK(told == beside.printed);
      CHECK(lab::metrics_json(record)["compared"].contains(beside.name));
    }
    compared = true;
  }
  CHECK(compared);
}

TEST_CASE("a broken assertion is told with its instance, or else as of the chip") {
  cosim::BrokenPromise promise{"no_shoot_through", "chip.u_leg", "leg.sv:7", 50000};
  CHECK(lab::promise_text(promise) ==
        "no_shoot_through of chip.u_leg at 0.00100000 s, clock 50000 (leg.sv:7)");
  promise.instance.clear();
  CHECK(lab::promise_text(promise) ==
        "no_shoot_through of the chip at 0.00100000 s, clock 50000 (leg.sv:7)");
}

TEST_CASE("a run that did not end well is compared with nothing") {
  std::size_t compared = 0;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const lab::Machine& machine = settings->machine();
    if (machine.companions == nullptr) continue;
    const auto wanted = machine.companions(*settings);
    if (wanted.empty()) continue;
    INFO("scenario " << settings->scenario);
    for (const EndReason end : {EndReason::kDone, EndReason::kFault, EndReason::kDiverged,
                                EndReason::kMissed, EndReason::kTimeout, EndReason::kStopped,
                                EndReason::kPromise}) {
      INFO("a run that ended as " << lab::end_text(end));
      std::size_t runs = 0;
      const lab::Record record = lab::run_by(
          [&](const lab::Settings& one, const cosim::Hooks&) {
            return test::short_result(one, ++runs == 1 ? end : EndReason::kDone);
          },
          *settings);
      const bool compares = end == EndReason::kDone;
      CHECK(runs == (compares ? 1 + wanted.size() : 1));
      CHECK(record.result->end == end);
      REQUIRE(record.companions.size() == (compares ? wanted.size() : 0));
      for (std::size_t k = 0; k < record.companions.size(); ++k) {
        CHECK(record.companions[k].name == wanted[k].name);
      }
    }
    if (++compared == 3) break;
  }
  CHECK(compared > 0);
}
