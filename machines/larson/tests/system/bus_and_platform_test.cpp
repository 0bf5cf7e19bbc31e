// SPDX-License-Identifier: Apache-2.0
//
// The machine larson: errors of its platform as the source gives them, and what its words do to
// bytes, bits and a program that asks for busy.
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/larson/machine_members.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using larson::Options;
using larson::Result;
using Scripted = larson::ScriptRun;

TEST_CASE("with the source's errors the platform is off by their sum at most, the rotors are not") {
  const auto settings = lab::load_scenario(lab::find_scenario("larson-accuracy"));
  auto options = static_cast<const Options&>(*settings);
  options.run.platform = cosim::Platform::kDirect;
  options.run.engine = cosim::Engine::kTwin;
  options.record_ms = 50;
  const lab::Record record = lab::run(options);
  REQUIRE(record.result->end == cosim::EndReason::kDone);
  CHECK(test::figure(record, "script.off_step") < 0.05);
  // 0.4 and half of 0.15 step, and 15 seconds of arc over 4470 steps.
  const double lean = 4470 * 15 / 3600.0 * 3.14159265 / 180;
  CHECK(test::figure(record, "script.platform_off_step") < 0.4 + 0.075 + lean + 0.05);
  CHECK(test::figure(record, "script.platform_off_step") > 0.6);
  const auto& result = static_cast<const Result&>(*record.result);
  double apart = 0;  // from its two sides
  for (std::size_t k = 5; k < result.done.size(); ++k) {
    if (result.calls[k].call.op != sw::LarsonOp::kWhrtbl ||
        result.calls[k - 5].call.op != sw::LarsonOp::kWhrtbl ||
        result.answers[k].at.x != result.answers[k - 5].at.x) {
      continue;
    }
    const auto off = [&result](std::size_t n) {  // from the rotor, which may still swing
      return result.done[n].platform[0] - result.done[n].at[0];
    };
    apart = std::fmax(apart, off(k) - off(k - 5));
  }
  CHECK(apart == Approx(0.15).margin(0.02));
}

TEST_CASE("a byte move changes no word and is counted, and busy can be polled, by RTL and twin") {
  Scripted script(
      "CALTBL\nMOV XCOUNT 177754\nMOVB XCOUNT 0\nMOVB XSTATUS+1 77\nMOV XSTATUS 035000\n"
      "POLL XSTATUS 010000\nBIC XSTATUS 020000\nWAIT 50\nWAIT 1\n");
  script.options.start_x = script.options.start_y = 20;
  std::uint64_t hash = 0;
  for (const cosim::Engine engine : {cosim::Engine::kRtl, cosim::Engine::kTwin}) {
    script.options.run.engine = engine;
    const Result result = script.run();
    CHECK(result.err_byte == 2);
    CHECK(result.end_at[0] - result.origin[0] == Approx(19).margin(0.1));
    const double polled = cosim::seconds_of(result.done[5].edge - result.done[4].edge, 20'000);
    CHECK(polled == Approx(19 / 156.25).margin(0.05));  // 5000 octal, and the buffer
    CHECK((result.samples.back().axis[0].words >> 16) == 05000);
    CHECK((hash == 0 || hash == result.event_hash));
    hash = result.event_hash;
  }
}
