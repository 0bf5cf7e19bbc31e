// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine larson records, held against its two axes driven once more with the
// pins that the chip drove: whatever is of the other axis, of the other sense, or early differs.
#include <catch2/catch.hpp>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "lab/record.hpp"
#include "machines/larson/machine_members.hpp"
#include "machines/larson/session.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"
#include "tests/support/event_record.hpp"

using namespace trammel;
using namespace trammel::larson;

namespace {

constexpr std::array<const char*, 2> kName{"X", "Y"};

// A run by the twin with all of its events.
struct Scripted : ScriptedTwin {
  explicit Scripted(const std::string& script) : ScriptedTwin(script) { options.record_ms = 0.5; }
  test::Recorded<Result> run() const { return test::record_run<Session, Result>(options); }
};

const char* const kMoves =
    "CALTBL\nVELTBL 4000 500\nABSTBL 60 33\nWTTBL\nRELTBL -25 -10\nWTTBL\nRELTBL 0 7\nWTTBL\n"
    "WHRTBL\n";

// One axis, driven by what the events say of its pins.
class Replay {
 public:
  Replay(const Options& options, int axis) : axis_(axis), plant_(config(options, axis)) {}

  // Up to a clock before the next event.
  void to(cosim::Clk edge) {
    while (plant_.next() < edge) put(plant_.next());
  }
  // Up to the event at `edge`, after which `drive` stands.
  void to(cosim::Clk edge, cosim::Lines drive) {
    to(edge);
    const bool before = level(lines_, step(axis_));
    lines_ = drive;
    if (!before && level(lines_, step(axis_))) {
      ++pulses;
      asked += level(lines_, forward(axis_)) ? 1 : -1;
    }
    put(edge);
  }
  const plant::StepperAxis& plant() const { return plant_; }
  double at(cosim::Clk edge) const { return plant_.state(edge).at; }

  std::uint32_t pulses = 0;
  int asked = 0;  // by them, from where it stood

 private:
  static plant::StepperAxisConfig config(const Options& options, int axis) {
    plant::StepperAxisConfig c = options.axis;
    c.start = axis == 0 ? options.start_x : options.start_y;
    return c;
  }
  void put(cosim::Clk n) {
    plant_.drive(n, level(lines_, step(axis_)), level(lines_, forward(axis_)),
                 level(lines_, flush(axis_)));
  }

  int axis_;
  plant::StepperAxis plant_;
  cosim::Lines lines_ = 0;
};

}  // namespace

TEST_CASE("larson: each sample is of its own axis, as its pins move it") {
  const Scripted script(kMoves);
  const auto run = script.run();
  const Result& result = run.result;
  REQUIRE(result.end == cosim::EndReason::kDone);
  std::vector<Replay> axes{{script.options, 0}, {script.options, 1}};
  std::array<double, 2> travel{}, last{script.options.start_x, script.options.start_y};
  std::size_t sample = 0, call = 0;
  const auto check_calls = [&](cosim::Clk before) {
    for (; call < result.done.size() && result.done[call].edge < before; ++call) {
      for (std::size_t k = 0; k < 2; ++k) {
        axes[k].to(result.done[call].edge);
        const double at = axes[k].at(result.done[call].edge) - result.origin[k];
        INFO("where " << kName[k] << " is at the end of call " << call << ", "
                      << result.calls[call].text);
        CHECK(result.done[call].at[k] == Approx(at).margin(1e-6));
      }
    }
  };
  for (const test::Event& event : run.events) {
    check_calls(event.edge);
    for (Replay& axis : axes) axis.to(event.edge, event.drive);
    check_calls(event.edge + 1);
    unsigned now = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      now |= (axes[k].plant().at_low() ? 1u : 0u) << 2 * k |
             (axes[k].plant().at_high() ? 2u : 0u) << 2 * k;
    }
    if ((event.why & cosim::kSample) == 0) continue;
    REQUIRE(sample < result.samples.size());
    const Sample s = result.samples[sample];
    INFO("sample " << sample << ", clock " << event.edge);
    REQUIRE(s.edge == event.edge);
    REQUIRE(s.call == call);
    REQUIRE(s.switches == now);
    for (std::size_t k = 0; k < 2; ++k) {
      const plant::StepperAxis& p = axes[k].plant();
      const auto state = p.state(event.edge);
      INFO("axis " << kName[k] << ": step " << s.axis[k].step << ", at " << s.axis[k].at
                   << ", speed " << s.axis[k].speed << ", angle " << s.axis[k].angle
                   << ", rate " << s.axis[k].rate << ", waiting " << s.axis[k].waiting);
      REQUIRE(s.axis[k].step == p.translated());
      REQUIRE(s.axis[k].asked == std::lround(k == 0 ? script.options.start_x
                                                    : script.options.start_y) + axes[k].asked);
      REQUIRE(s.axis[k].waiting == p.waiting());
      REQUIRE(s.axis[k].at == Approx(state.at).margin(1e-6));
      REQUIRE(s.axis[k].speed == Approx(state.speed).margin(1e-3));
      const double behind = static_cast<double>(p.translated()) - state.at;
      REQUIRE(s.axis[k].angle == Approx(behind).margin(1e-6));
      REQUIRE(s.axis[k].rate == Approx(p.rate()).margin(1e-6));
      if ((event.edge + 1) % kLook != 0 || event.edge > result.looks.back().edge) continue;
      travel[k] += std::fabs(state.at - last[k]);
      last[k] = state.at;
    }
    ++sample;
  }
  CHECK(sample == result.samples.size());
  CHECK(call == result.calls.size());
  for (std::size_t k = 0; k < 2; ++k) {
    INFO("axis " << kName[k]);
    CHECK(result.pulses[k] == axes[k].pulses);
    CHECK(result.travel[k] == Approx(travel[k]));
    CHECK(result.end_at[k] == Approx(last[k]));
    CHECK(result.lost[k] == 0);
    // At rest the translator stands where the program has the table, from the origin.
    const int known = k == 0 ? result.known.x : result.known.y;
    CHECK(known == (k == 0 ? 35 : 30));
    CHECK(result.origin[k] == static_cast<double>(axes[k].plant().translated() - known));
  }
  CHECK(result.pulses[0] > result.pulses[1]);
  // Each change of a switch, at its own clock and place.
  std::array<std::size_t, 2> moved{};
  for (const Event& one : result.happened) {
    if (one.what.find("switch") == std::string::npos) continue;
    const auto k = static_cast<std::size_t>(one.axis);
    INFO(one.what << " of axis " << kName[k]);
    REQUIRE(moved[k] < axes[k].plant().moved().size());
    const plant::SwitchMoved is = axes[k].plant().moved()[moved[k]++];
    CHECK(one.edge == is.edge);
    CHECK(one.at == is.at);
    CHECK(one.what == (is.closed ? "low switch closed" : "low switch open"));
    CHECK((one.status & sw::larson_map::kLimit) == (is.closed ? sw::larson_map::kLimit : 0));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(moved[k] >= 2);
    CHECK(moved[k] == axes[k].plant().moved().size());
  }
}

TEST_CASE("larson: an interrupt is noted once, with the axis that has come to its end") {
  const Scripted script(kMoves);
  const auto run = script.run();
  std::array<int, 2> of{};
  std::size_t interrupts = 0;
  for (const Event& one : run.result.happened) {
    INFO(one.what << " at clock " << one.edge << ", axis " << one.axis << ", status "
                  << one.status);
    if (one.what != "interrupt") continue;
    ++interrupts;
    ++of[static_cast<std::size_t>(one.axis)];
    const std::uint32_t bits = sw::larson_map::kBusy | sw::larson_map::kEnable;
    CHECK((one.status & bits) == sw::larson_map::kEnable);
  }
  CHECK(interrupts == run.result.interrupts);
  CHECK(of[0] > 0);
  CHECK(of[1] > 0);
  CHECK(run.result.happened_count == run.result.happened.size());
}

TEST_CASE("larson: steps lost are counted and noted in the axis and sense that lost them") {
  bool behind = false, ahead = false;
  for (std::size_t lossy = 0; lossy < 2; ++lossy) {
    for (const bool forward : {true, false}) {
      const std::string rates = lossy == 0 ? "VELTBL 4000 100\n" : "VELTBL 100 4000\n";
      const std::string there = lossy == 0 ? "ABSTBL 400 3\n" : "ABSTBL 3 400\n";
      const std::string back = lossy == 0 ? "ABSTBL 0 2\n" : "ABSTBL 2 0\n";
      Scripted script("CALTBL\n" + (forward ? rates + there : "VELTBL 200 200\n" + there +
                                                                  "WTTBL\n" + rates + back) +
                      "WTTBL\n");
      script.options.axis.buffer.fitted = false;
      const auto run = script.run();
      CAPTURE(kName[lossy], forward, run.result.fault);
      CHECK(run.result.end == cosim::EndReason::kMissed);
      CHECK_THAT(run.result.fault, Catch::StartsWith(std::string(kName[lossy]) + " lost "));
      CHECK(run.result.lost[1 - lossy] == 0);
      int net = 0;
      for (const Event& one : run.result.happened) {
        if (one.what.find("steps lost") == std::string::npos) continue;
        CHECK(one.axis == static_cast<int>(lossy));
        net += std::stoi(one.what);
      }
      CHECK(run.result.lost[lossy] == std::abs(net));
      // A rotor that stalls is behind, one that overruns at the end is ahead.
      const Sample last = run.result.samples.back();
      CHECK(net ==  // in whole cycles of ten, and it may still swing
            Approx(last.axis[lossy].step - last.axis[lossy].at).margin(4));
      (net > 0 ? behind : ahead) = true;
    }
  }
  CHECK(behind);
  CHECK(ahead);
}

TEST_CASE("larson: a run ends when its settling is over and no axis moves any more") {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Scripted script(axis == 0 ? "VELTBL 250 250\nCALTBL\nVELTBL 100 4000\nABSTBL 20 3\n"
                                    : "VELTBL 250 250\nCALTBL\nVELTBL 4000 100\nABSTBL 3 20\n");
    const auto run = script.run();
    CAPTURE(kName[axis]);
    REQUIRE(run.result.end == cosim::EndReason::kDone);
    const Sample last = run.result.samples.back();
    CHECK((last.axis[axis].words >> 16 & sw::larson_map::kBusy) == 0);
    CHECK(last.axis[axis].waiting == 0);
    const double longest =
        script.options.run.seconds(last.edge - run.result.done.back().edge);
    CHECK(longest >= script.options.settle_s);
    CHECK(longest > 0.17);   // 20 steps at 100 PPS
    CHECK(longest < 0.3);
  }
}

TEST_CASE("larson: a table at rest is recorded for its settling, and no longer") {
  for (const double settle_s : {0.05, 0.2}) {
    Scripted script("VELTBL 500 500\nCALTBL\nRELTBL 5 4\nWTTBL\nWHRTBL\n");
    script.options.settle_s = settle_s;
    const auto run = script.run();
    REQUIRE(run.result.end == cosim::EndReason::kDone);
    const cosim::Clk more = run.result.samples.back().edge - run.result.done.back().edge;
    CHECK(script.options.run.seconds(more) ==
          Approx(settle_s + 0.5e-3).margin(0.6e-3));
  }
}

TEST_CASE("larson: the origin counts the pulses that wait when CALTBL ends") {
  Scripted script("CALTBL\n");
  script.options.wttbl_ms = 0;
  const auto run = script.run();
  REQUIRE(run.result.end == cosim::EndReason::kDone);
  const Sample last = run.result.samples.back();
  for (std::size_t k = 0; k < 2; ++k) {
    CAPTURE(kName[k]);
    CHECK(run.result.origin[k] == last.axis[k].step);
  }
  CHECK(run.result.done[0].at[1] < -0.5);  // Y, which ends it, has not arrived
}

TEST_CASE("larson: a fault that drives the table into its stop is reported as that") {
  for (const double overtravel : {20.0, 500.0}) {
    Scripted script("CALTBL\n");
    script.options.axis.overtravel = overtravel;
    script.options.run.max_s = 0.3;
    script.options.fault.kind = cosim::FaultKind::kEncoderStuck;
    script.options.fault.axis = 1;
    script.options.fault.value = -1;  // never closed
    const auto run = script.run();
    CAPTURE(overtravel);
    CHECK(run.result.fault_report.at_stop == (overtravel < 100));
  }
}

TEST_CASE("larson: an error return notices a fault that came before it, not a later one") {
  for (const double begin_s : {0.01, 0.9}) {
    Scripted script("VELTBL 400 400\nCALTBL\nABSTBL -5 20\nWTTBL\nABSTBL 20 0\nWTTBL\n");
    script.options.fault.kind = cosim::FaultKind::kIndexLost;  // harms nothing at this rate
    script.options.fault.begin_s = begin_s;
    script.options.settle_s = 0.7;
    const auto run = script.run();
    REQUIRE(run.result.answers[3].value == 0);
    const double told = script.options.run.seconds(run.result.done[3].edge);
    CAPTURE(begin_s, told);
    REQUIRE(told < 0.9);
    CHECK(run.result.fault_report.begin != cosim::kNever);
    CHECK(run.result.fault_report.by == (begin_s < told ? "WTTBL" : ""));
  }
}

TEST_CASE("larson: a run whose table moves on for minutes ends five seconds behind its program") {
  // Forward by 65,535 steps at 59 PPS, of which the program does not know.
  const Scripted script("CALTBL\nMOV XCOUNT 0\nMOV XSTATUS 030000\n");
  const auto run = script.run();
  CHECK(run.result.end == cosim::EndReason::kMissed);
  const cosim::Clk more = run.result.samples.back().edge - run.result.done.back().edge;
  CHECK(script.options.run.seconds(more) == Approx(5).margin(1e-2));
  CHECK_THAT(run.result.fault, Catch::StartsWith("X is 29"));
}

TEST_CASE("larson: a table that leaves its switches is looked at every table.poll_ms") {
  for (const double poll_ms : {2.0, 5.0}) {
    Scripted script("CALTBL\n");
    script.options.poll_ms = poll_ms;
    const auto run = script.run();
    REQUIRE(run.result.end == cosim::EndReason::kDone);
    const auto clocks = static_cast<cosim::Clk>(poll_ms * 50'000);
    cosim::Clk before = 0;
    int polls = 0;
    for (const test::Event& event : run.events) {
      if ((event.why & cosim::kIrq) == 0) continue;
      // And the latency and accesses of the routine, until it starts the timer anew.
      if (event.edge - before >= clocks && event.edge - before < clocks + 1000) ++polls;
      before = event.edge;
    }
    CAPTURE(poll_ms);
    CHECK(polls >= 5);
  }
}

TEST_CASE("larson: progress is the share of the calls that have ended") {
  const Scripted script(kMoves);
  std::vector<double> told;
  cosim::Hooks hooks;
  hooks.progress = [&told](double share) { told.push_back(share); };
  lab::simulate(script.options, hooks);
  REQUIRE(told.size() > 5);
  CHECK(told.front() == 0);
  for (std::size_t k = 1; k < told.size(); ++k) {
    CAPTURE(k);
    CHECK(told[k] >= told[k - 1]);
    CHECK(std::fabs(9 * told[k] - std::round(9 * told[k])) < 1e-9);  // of nine
  }
  CHECK(told.back() == 1);
}

TEST_CASE("larson: calls end at the same clocks and places, whatever the look-ahead or wiring") {
  Scripted script(kMoves);
  const Result first = script.run().result;
  Scripted steps(kMoves), systemc(kMoves);
  steps.options.run.window_clk = 313;
  systemc.options.run.platform = cosim::Platform::kSystemC;
  for (const Options& options : {steps.options, systemc.options}) {
    const Result other = lab::simulate(options);
    REQUIRE(other.event_hash == first.event_hash);
    REQUIRE(other.done.size() == first.done.size());
    for (std::size_t k = 0; k < first.done.size(); ++k) {
      INFO(first.calls[k].text << ", window " << options.run.window_clk);
      CHECK(other.done[k].edge == first.done[k].edge);
      CHECK(other.done[k].at[0] == first.done[k].at[0]);
      CHECK(other.done[k].at[1] == first.done[k].at[1]);
    }
    REQUIRE(other.samples.size() == first.samples.size());
    for (std::size_t k = 0; k < first.samples.size(); ++k) {
      CAPTURE(k);
      const Sample ours = first.samples[k], theirs = other.samples[k];
      REQUIRE(theirs.call == ours.call);
    }
  }
}

TEST_CASE("larson: a move turned by hand into its switch is missed until the next CALTBL") {
  for (const std::string axis : kName) {
    const std::string turned = "CALTBL\nVELTBL 400 400\nABSTBL 60 70\nBIC " + axis +
                               "STATUS 020000\nWAIT 400\n";
    CAPTURE(axis);
    const Result lost = Scripted(turned + "WHRTBL\n").run().result;
    CHECK(lost.end == cosim::EndReason::kMissed);
    CHECK_THAT(lost.fault, Catch::StartsWith("a switch stopped " + axis + ","));
    CHECK(Scripted(turned + "CALTBL\nWHRTBL\n").run().result.end == cosim::EndReason::kDone);
  }
}

TEST_CASE("larson: without its buffer a motor takes at 1150 PPS each move, at 1600 no short one") {
  const auto slips = [](const std::string& moves) {
    Scripted script("CALTBL\nVELTBL 400 400\nABSTBL 50 0\nWTTBL\nWAIT 300\n" + moves);
    script.options.axis.buffer.fitted = false;
    script.options.axis.motor.friction = 0.0565;  // [N m] 0.5 lb-in
    script.options.run.max_s = 100;
    return script.run().result.slips[0].size();
  };
  std::string each = "VELTBL 1150 400\n";  // from two phases, and from three
  for (int move = 1; move <= 49; ++move) {
    each += "RELTBL " + std::to_string(move <= 24 ? move : move == 25 ? 1 : move - 25) +
            " 0\nWTTBL\nWAIT 300\n";
  }
  CHECK(slips(each) == 0);
  CHECK(slips("VELTBL 1600 400\nRELTBL 200 0\nWTTBL\nRELTBL 201 0\nWTTBL\n") == 0);
  CHECK(slips("VELTBL 1600 400\nRELTBL 15 0\nWTTBL\n") == 1);
}
