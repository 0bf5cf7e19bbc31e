// SPDX-License-Identifier: Apache-2.0
//
// Waves of the table besides what holds for those of every machine (tests/lab).
#include <catch2/catch.hpp>
#include <fstream>

#include "lab/waves.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;

namespace {

std::string message_of(const std::string& trigger) {
  kung::Options options;
  return test::refusal_of([&] {
    apply_waves(options, {"fst", "", trigger, "", ""});
    check_waves(options);
  });
}

}  // namespace

TEST_CASE("an unknown signal in a trigger gives a suggestion") {
  CHECK(message_of("x.e > 100").empty());
  CHECK(message_of("x.STATSU == 3") ==
        "--wave-trigger: x.STATSU: unknown signal; did you mean x.STATUS?");
  CHECK_THAT(message_of("fault.encodr"), Contains("did you mean fault.encoder?"));
  CHECK_THAT(message_of("x.e >"), Contains("--wave-trigger: \"x.e >\" is none of"));
}

TEST_CASE("the record names the waves, the view of the table and the trigger") {
  const test::Scratch scratch("kung_wave_files_test_out");
  auto arguments = test::arguments_for("circle", scratch.path / "a");
  arguments.waves = {"fst", "", "x.e > 100", "", ""};
  const testbench::Simulate ran = [](const Settings& settings, const cosim::Hooks&) {
    auto result = std::make_unique<kung::Result>();
    result->clocks = 500000;
    result->wave_trigger = 50000;
    result->waves = {{40000, 140000}};
    std::ofstream(settings.run.wave_file) << "waves";
    return judged(settings.clone(), std::move(result));
  };
  CHECK(test::run(arguments, ran) == 0);
  CHECK_THAT(test::content(scratch.path / "a" / "metrics.json"),
             Contains("\"trigger\": \"x.e > 100\""));
  CHECK_THAT(test::content(scratch.path / "a" / "waves.gtkw"), Contains("-X current loop"));
}
