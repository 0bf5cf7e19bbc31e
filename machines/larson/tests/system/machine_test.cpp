// SPDX-License-Identifier: Apache-2.0
//
// The machine larson: acceptance tests M-11 to M-13, equal events in every wiring, lost steps, and
// a scan whose every place is read back.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <string>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/larson/machine_members.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/wirings.hpp"

using namespace trammel;
using larson::Options;
using larson::Result;
using Scripted = larson::ScriptRun;

namespace {

const sw::LarsonAnswer& answer(const Result& result, std::size_t from_last) {
  REQUIRE(result.done.size() == result.calls.size());
  return result.answers[result.answers.size() - 1 - from_last];
}

Options built_in(const std::string& scenario) {
  auto settings = lab::load_scenario(lab::find_scenario(scenario));
  auto options = static_cast<const Options&>(*settings);
  options.run.platform = cosim::Platform::kDirect;
  return options;
}

// From (20, 20), by the twin; a switch may be held open or closed.
struct Switches : Scripted {
  explicit Switches(const std::string& text) : Scripted(text) {
    options.start_x = options.start_y = 20;
    options.run.engine = cosim::Engine::kTwin;
    options.fault.kind = cosim::FaultKind::kEncoderStuck;
  }
};

}  // namespace

TEST_CASE("M-11 CALTBL and ABSTBL 1000 2000: WTTBL 1, WHRTBL the same, rotors within 2 steps") {
  const Scripted script("CALTBL\nABSTBL 1000 2000\nWTTBL\nWHRTBL\n");  // at 4000 PPS
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(answer(result, 1).value == 1);
  CHECK(answer(result, 0).at.x == 1000);
  CHECK(answer(result, 0).at.y == 2000);
  const larson::CallDone& waited = result.done[result.done.size() - 2];
  CHECK(std::fabs(waited.at[0] - 1000) <= 2);
  CHECK(std::fabs(waited.at[1] - 2000) <= 2);
  CHECK(std::fabs(result.end_at[0] - result.origin[0] - 1000) < 0.1);
  CHECK(std::fabs(result.end_at[1] - result.origin[1] - 2000) < 0.1);
}

TEST_CASE("M-11 rotors are within 2 steps at WTTBL, one short move after the other in any sense") {
  // Back to back without a wait the swing of one move adds to that of the next; nothing is lost.
  std::string text = "CALTBL\nABSTBL 500 500\nWTTBL\n";
  for (int k = 0; k < 300; ++k) {
    if (k % 6 == 0) {
      const int rates[] = {59, 100, 200, 400, 600, 1000, 1300, 2000, 4000};
      text += "VELTBL " + std::to_string(rates[k / 6 % 9]) + ' ' +
              std::to_string(rates[(k / 6 + 5) % 9]) + '\n';
    }
    const int x = 1 + k * 7 % 13, y = k * 5 % 9;
    text += "RELTBL " + std::to_string(k % 3 == 1 ? -x : k % 2 == 0 ? x : -x) + ' ' +
            std::to_string(k % 2 == 0 ? y : -y) + "\nWTTBL\nWHRTBL\n";
  }
  Scripted script(text);
  script.options.run.engine = cosim::Engine::kTwin;
  script.options.start_x = script.options.start_y = 20;
  const auto most = [](const Result& result) {
    REQUIRE(result.end != cosim::EndReason::kTimeout);
    double off = 0;
    for (std::size_t k = 1; k < result.done.size(); ++k) {
      if (result.calls[k].call.op != sw::LarsonOp::kWhrtbl) continue;
      off = std::fmax(off, std::fabs(result.done[k - 1].at[0] - result.answers[k].at.x));
      off = std::fmax(off, std::fabs(result.done[k - 1].at[1] - result.answers[k].at.y));
    }
    return off;
  };
  const Result settled = script.run();
  CHECK(most(settled) <= 2);
  CHECK(settled.lost[0] + settled.lost[1] == 0);
  script.options.wttbl_ms = 0;  // as busy falls, behind the last pulse of the buffer
  CHECK(most(script.run()) <= 2);
  script.options.axis.buffer.busy_above = 2;  // two pulses wait, and the rotor is behind them
  CHECK(most(script.run()) > 2.5);
}

TEST_CASE("M-12 RELTBL 100 -50, three times from (1000, 1000), ends at (1300, 850)") {
  const Scripted script(
      "CALTBL\nVELTBL 1000 1000\nABSTBL 1000 1000\nWTTBL\n"
      "REPEAT 3\nRELTBL 100 -50\nWTTBL\nEND\nWHRTBL\n");
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(answer(result, 0).at.x == 1300);
  CHECK(answer(result, 0).at.y == 850);
  CHECK(answer(result, 1).value == 1);
}

TEST_CASE("M-13 ABSTBL -5 100 from (50, 50): X stops at 0 off its switch, WTTBL 0, then (0, 100)") {
  const Scripted script(
      "CALTBL\nVELTBL 1000 1000\nABSTBL 50 50\nWTTBL\nABSTBL -5 100\nWTTBL\nWHRTBL\n");
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(answer(result, 1).value == 0);
  CHECK(answer(result, 0).at.x == 0);
  CHECK(answer(result, 0).at.y == 100);
  CHECK(result.calibrated);
  for (const larson::Event& one : result.happened) {
    const bool behind = one.edge > result.done.front().edge;
    CHECK_FALSE((behind && one.what.find("switch") != std::string::npos));
  }
}

TEST_CASE("a move beyond the far soft end stops there, and the next one is normal") {
  Scripted script(
      "CALTBL\nVELTBL 4000 4000\nABSTBL 9000 0\nWTTBL\nWHRTBL\nRELTBL -100 0\nWTTBL\n");
  script.options.axis.switch_high = 517.5;
  script.options.table.soft_end = 500;
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(answer(result, 3).value == 0);
  CHECK(answer(result, 2).at.x == 500);
  CHECK(answer(result, 0).value == 1);
}

TEST_CASE("a list of moves beyond the soft range stops at its ends, and meets no switch") {
  Scripted script("-5,300,0\n600,300,1\n250,700,1\n");
  const std::filesystem::path list = script.scratch.path / "moves.csv";
  std::filesystem::rename(script.options.script, list);
  script.options.script = list.string();
  script.options.run.engine = cosim::Engine::kTwin;
  script.options.axis.switch_high = 517.5;
  script.options.table.soft_end = 500;
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(result.known.x == 250);
  CHECK(result.known.y == 500);
  CHECK(result.calibrated);
  CHECK(answer(result, 0).value == 0);
  for (const larson::Event& one : result.happened) {
    CHECK_FALSE((one.edge > result.done.front().edge && one.what.find("switch") == 0));
    CHECK_THAT(one.what, !Catch::Contains("high"));
  }
}

TEST_CASE("a move while the table moves, or before CALTBL, is refused and changes nothing") {
  const Scripted script(
      "ABSTBL 10 10\nCALTBL\nVELTBL 400 400\nABSTBL 100 100\nABSTBL 5 5\nWTTBL\nWHRTBL\n");
  const Result result = script.run();
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(result.answers[0].value == static_cast<int>(sw::StepAnswer::kNotCalibrated));
  CHECK(answer(result, 2).value == static_cast<int>(sw::StepAnswer::kMoving));
  CHECK(answer(result, 1).value == 1);
  CHECK(answer(result, 0).at.x == 100);
}

TEST_CASE("an interrupt is that of the axis whose move ends, also where both ask at once") {
  Scripted script(
      "CALTBL\nVELTBL 400 400\nABSTBL 5 20\nWTTBL\nABSTBL 25 25\nWTTBL\n"
      "ABSTBL 30 30\nWTTBL\n");
  script.options.start_x = 20;
  script.options.start_y = 30;
  script.options.axis.buffer.fitted = false;
  for (const cosim::Engine engine : {cosim::Engine::kRtl, cosim::Engine::kTwin}) {
    script.options.run.engine = engine;
    const Result result = script.run();
    REQUIRE(result.end == cosim::EndReason::kDone);
    std::string axes;
    for (const larson::Event& one : result.happened) {
      if (one.edge <= result.done.front().edge || one.what != "interrupt") continue;
      axes += one.axis == 0 ? 'X' : 'Y';
      CHECK(one.count == 0177777);
    }
    CHECK(axes == "XYYXXY");  // 5 and 20 steps, 20 and 5, 5 and 5
  }
}

TEST_CASE("every wiring gives the record of the leaping RTL, and --audit finds no difference") {
  Scripted script("CALTBL\nVELTBL 4000 500\nABSTBL 60 30\nWTTBL\nWAIT 5\nWHRTBL\n");
  script.options.start_x = 20;
  script.options.start_y = 30;
  script.options.settle_s = 0.02;
  const Result first = test::check_wirings(script.options);
  REQUIRE(first.end == cosim::EndReason::kDone);
  CHECK(first.evaluated < first.clocks / 1000);
}

TEST_CASE("the raster reads back 2500 places without a lost step, as the twin does") {
  Options rtl = built_in("larson-raster");
  rtl.record_ms = 50;
  Options twin = rtl;
  twin.run.engine = cosim::Engine::kTwin;
  const Result result = lab::simulate(rtl);
  REQUIRE(result.end == cosim::EndReason::kDone);
  int places = 0;
  for (std::size_t k = 0; k < result.done.size(); ++k) {
    if (result.calls[k].call.op != sw::LarsonOp::kWhrtbl) continue;
    const int row = places / 50, in_row = places % 50;
    const int column = row % 2 == 0 ? in_row : 49 - in_row;
    CHECK(result.answers[k].at.x == 100 + 20 * column);
    CHECK(result.answers[k].at.y == 100 + 20 * row);
    ++places;
  }
  CHECK(places == 2500);
  CHECK(result.lost[0] == 0);
  CHECK(result.lost[1] == 0);
  CHECK(lab::simulate(twin).event_hash == result.event_hash);
}

TEST_CASE("without its buffer X loses steps at 4000 PPS, which the run names with its place") {
  const lab::Record record = lab::run(built_in("larson-overload"));
  CHECK(record.result->end == cosim::EndReason::kMissed);
  CHECK(static_cast<const Result&>(*record.result).lost[0] % 10 == 0);
  CHECK_THAT(record.verdict, Catch::StartsWith("missed: X lost"));
  CHECK_THAT(record.verdict, Catch::Contains("the first at step"));
}

TEST_CASE("by hand into the far switch: the interrupt, the latch, the hazard, and out again") {
  const Result result = lab::simulate(built_in("larson-limit"));
  REQUIRE(result.end == cosim::EndReason::kDone);
  std::vector<std::string> high;
  const larson::Event* trip = nullptr;
  for (const larson::Event& one : result.happened) {
    if (one.what.find("high switch") == 0) high.push_back(one.what);
    if (one.what == "interrupt" && (one.status & 0x6000) == 0x6000) trip = &one;
  }
  CHECK(high == std::vector<std::string>{"high switch closed", "high switch open"});
  REQUIRE(trip != nullptr);  // M-05: bits 14 and 13, the count kept, not busy
  CHECK(trip->axis == 0);
  CHECK((trip->status & 0x1000) == 0);
  CHECK(trip->count > 0xFFFF - 200);
  CHECK(trip->count < 0xFFFF);
  // Where X is when calls end: M-06, a start that the latch refuses; M-07, one after the hazard.
  const auto x_after = [&](std::size_t line) {
    for (std::size_t k = 0; k < result.calls.size(); ++k) {
      if (result.calls[k].line == line) return result.done[k + 1].at[0];
    }
    return 0.0;
  };
  CHECK(x_after(10) > 5980);
  CHECK(std::fabs(x_after(14) - x_after(10)) < 0.01);
  CHECK(std::fabs(x_after(17) - x_after(10)) < 0.01);
  CHECK(std::fabs(x_after(20) - x_after(10)) > 90);
}

TEST_CASE("figures, columns and the verdict are those of their axis, with its sign") {
  Scripted script("CALTBL\nVELTBL 400 800\nABSTBL 20 60\nWTTBL\nABSTBL 50 10\nWTTBL\n");
  script.options.start_x = 20;
  script.options.start_y = 30;
  const lab::Record record = lab::run(script.options);
  const auto& result = static_cast<const Result&>(*record.result);
  REQUIRE(result.end == cosim::EndReason::kDone);
  const auto value = [&](const std::string& id) { return test::figure(record, id); };
  // Back to the switch, 10 more of Y, and off it; then 20 and 30 steps of X, 60 and 50 of Y.
  CHECK(value("y.pulses") - value("x.pulses") == Approx(10 + 60).margin(4));
  CHECK(value("x.end_step") - result.origin[0] == Approx(50).margin(0.1));
  CHECK(value("y.end_step") - result.origin[1] == Approx(10).margin(0.1));
  CHECK(value("y.travel_step") - value("x.travel_step") == Approx(10 + 60).margin(15));
  CHECK(value("y.max_rate") > value("x.max_rate"));
  CHECK(value("script.normal") == 2);
  CHECK(value("script.calls") == 6);
  CHECK(value("interrupts") == 2 * 2 + 2 * 2);  // of each axis: switch, margin, two moves
  const larson::Sample& last = result.samples.back();
  CHECK(last.axis[0].at == Approx(value("x.end_step")));
  CHECK(last.axis[1].at == Approx(value("y.end_step")));
  CHECK(last.axis[1].step == Approx(last.axis[1].at).margin(0.1));
  for (const larson::Sample& one : result.samples) {
    for (const larson::AxisSample& axis : one.axis) {
      CHECK(axis.angle == Approx(axis.step - axis.at).margin(1e-6));
    }
  }
}

TEST_CASE("a table that is not where its program has it is missed, on either axis") {
  for (const int axis : {0, 1}) {
    Scripted script("CALTBL\nVELTBL 400 400\nABSTBL 100 100\nWTTBL\n");
    script.options.start_x = script.options.start_y = 20;
    script.options.fault.kind = cosim::FaultKind::kOutputStuck;
    script.options.fault.axis = axis;
    script.options.fault.begin_s = 0.35;
    script.options.fault.for_s = 0.05;
    const lab::Record record = lab::run(script.options);
    CHECK(record.result->end == cosim::EndReason::kMissed);
    const std::string begin = axis == 0 ? "missed: X is -" : "missed: Y is -";
    CHECK_THAT(record.verdict, Catch::StartsWith(begin));
    CHECK_THAT(record.verdict, Catch::Contains("from 100, where"));
  }
}

TEST_CASE("a switch that never closes ends CALTBL, one that closes too early a move, missed") {
  Switches script("CALTBL\nVELTBL 400 400\nABSTBL 100 100\nWTTBL\nABSTBL 5 5\nWHRTBL\n");
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    script.options.fault.axis = axis;
    script.options.fault.line = 0;    // the lower one,
    script.options.fault.value = -1;  // open
    script.options.fault.begin_s = 0;
    const lab::Record open = lab::run(script.options);
    CHECK(open.result->end == cosim::EndReason::kFault);
    CHECK(open.verdict == "tripped: CALTBL found no switch, or could not leave it");
    script.options.fault.line = 1;   // the upper one,
    script.options.fault.value = 1;  // closed
    script.options.fault.begin_s = 0.4;
    const Result closed = script.run();
    CHECK(answer(closed, 2).value == 0);
    CHECK(answer(closed, 1).value == static_cast<int>(sw::StepAnswer::kNotCalibrated));
    CHECK_FALSE(closed.calibrated);
    CHECK(closed.end == cosim::EndReason::kMissed);
    CHECK_THAT(closed.fault, Catch::StartsWith(std::string("a switch stopped ") +
                                               (axis == 0 ? "X," : "Y,")));
    const std::string where = larson::remarks(lab::run(script.options)).back();
    CHECK_THAT(where, Catch::EndsWith(", not calibrated"));
  }
}

TEST_CASE("a table that a switch has stopped is calibrated again, by either axis") {
  Switches script(
      "CALTBL\nVELTBL 400 400\nABSTBL 100 100\nWTTBL\nCALTBL\nABSTBL 5 7\nWTTBL\nWHRTBL\n");
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    script.options.fault.axis = axis;
    script.options.fault.line = 1;  // the upper one, closed for a while
    script.options.fault.value = 1;
    script.options.fault.begin_s = 0.4;
    script.options.fault.for_s = 0.1;
    const Result result = script.run();
    CHECK(result.end == cosim::EndReason::kDone);
    CHECK(result.calibrated);
    CHECK(answer(result, 4).value == 0);
    CHECK(answer(result, 0).at.x == 5);
    CHECK(answer(result, 0).at.y == 7);
  }
}

TEST_CASE("interrupts that come late make a script longer, and leave each place as it is") {
  Scripted script("CALTBL\nVELTBL 1000 1000\nREPEAT 5\nRELTBL 30 20\nWTTBL\nEND\nWHRTBL\n");
  script.options.start_x = script.options.start_y = 20;
  script.options.run.engine = cosim::Engine::kTwin;
  const Result prompt = script.run();
  script.options.processor.interrupt_latency_clk = 90'000;  // 1.8 ms
  const Result late = script.run();
  for (const Result* one : {&prompt, &late}) {
    REQUIRE(one->end == cosim::EndReason::kDone);
    CHECK(answer(*one, 0).at.x == 150);
    CHECK(answer(*one, 0).at.y == 100);
    CHECK(one->lost[0] + one->lost[1] == 0);
    CHECK(std::fabs(one->end_at[0] - one->origin[0] - 150) < 0.1);
  }
  CHECK(late.done.back().edge - prompt.done.back().edge > 5 * 90'000);
}
