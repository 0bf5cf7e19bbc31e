// SPDX-License-Identifier: Apache-2.0
//
// Waves of the table besides what holds for those of every machine (tests/lab): triggers and
// windows.
#include <catch2/catch.hpp>
#include <fstream>

#include "cosim/wave_plan.hpp"
#include "lab/waves.hpp"
#include "machines/kung/chip.hpp"
#include "machines/kung/machine.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::lab;
using namespace trammel::kung;
using Catch::Contains;
using cosim::wave_origin;
using cosim::wave_window;
using cosim::WaveWindow;

namespace {

std::string message_of(const std::string& trigger) {
  kung::Options options;
  return test::refusal_of([&] {
    apply_waves(options, {"fst", "", trigger, "", ""});
    check_waves(options);
  });
}

cosim::RunBasics traced() {
  cosim::RunBasics run;
  run.wave = WaveFormat::kFst;
  return run;
}

std::optional<cosim::Trigger> event(const cosim::RunBasics& run) {
  return cosim::wave_event(run, triggers());
}

constexpr cosim::Clk kMs = 50000;  // clocks

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

TEST_CASE("without a given window a run is dumped around its trigger, 2 ms in all") {
  cosim::RunBasics run = traced();
  CHECK(wave_window(run, 100 * kMs).begin == 100 * kMs - kMs / 5);
  CHECK(wave_window(run, 100 * kMs).end == 102 * kMs - kMs / 5);
  run.wave_pre_s = 0.001;
  CHECK(wave_window(run, 100 * kMs).begin == 99 * kMs);
  CHECK(wave_window(run, 100 * kMs).period == cosim::kNever);
}

TEST_CASE("the trigger is the drives' start unless a window, a period or a trigger is given") {
  cosim::RunBasics run = traced();
  REQUIRE(event(run));
  CHECK(std::string(signals()[event(run)->signal].name) == "CTRL.enable");
  // Where the drives never start, the default window begins with the run.
  CHECK(wave_window(run, wave_origin(run)).begin == 0);
  CHECK(wave_window(run, wave_origin(run)).end == 2 * kMs);
  run.wave_end_s = 0.005;
  CHECK_FALSE(event(run));
  run = traced();
  run.wave_every_s = 0.05;
  CHECK_FALSE(event(run));
  run.wave_trigger = "fault";
  CHECK(std::string(signals()[event(run)->signal].name) == "FAULT.code");
  run.wave = WaveFormat::kNone;
  CHECK_FALSE(event(run));
}

TEST_CASE("a window counts from its trigger, or from the start of the run") {
  cosim::RunBasics run = traced();
  run.wave_begin_s = -0.001;
  run.wave_end_s = 0.003;
  CHECK(wave_window(run, 10 * kMs).begin == 9 * kMs);
  CHECK(wave_window(run, 10 * kMs).end == 13 * kMs);
  run.wave_begin_s = 0.001;
  CHECK(wave_origin(run) == 0);
  CHECK(wave_window(run, 0).begin == kMs);
}

TEST_CASE("only what the run reached counts as dumped") {
  const auto spans = [](const WaveWindow& window, cosim::Clk clocks) {
    std::vector<std::pair<cosim::Clk, cosim::Clk>> list;
    for (const WaveSpan& span : wave_spans(window, clocks)) list.emplace_back(span.begin, span.end);
    return list;
  };
  using List = std::vector<std::pair<cosim::Clk, cosim::Clk>>;
  CHECK(spans({10, 20, cosim::kNever}, 100) == List{{10, 20}});
  CHECK(spans({-10, 20, cosim::kNever}, 100) == List{{0, 20}});
  CHECK(spans({90, 120, cosim::kNever}, 100) == List{{90, 100}});
  CHECK(spans({100, 120, cosim::kNever}, 100).empty());
  CHECK(spans({-20, -10, cosim::kNever}, 100).empty());
  CHECK(spans({10, 20, 40}, 100) == List{{10, 20}, {50, 60}, {90, 100}});
  CHECK(spans({95, 110, 40}, 100) == List{{95, 100}});
}

TEST_CASE("a periodic window before the run begins with the first that ends inside it") {
  cosim::RunBasics run = traced();
  run.wave_begin_s = -0.001;
  run.wave_end_s = -0.0005;
  run.wave_every_s = 0.01;
  const WaveWindow window = wave_window(run, 0);
  CHECK(window.begin == 9 * kMs);
  CHECK(window.period == 10 * kMs);
}
