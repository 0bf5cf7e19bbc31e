// SPDX-License-Identifier: Apache-2.0
//
// Triggers on the full machine: the events they name are where other evidence says they are, the
// signals they read are what the bus reads, and observing changes nothing.
#include <catch2/catch.hpp>
#include <filesystem>

#include "cosim/direct.hpp"
#include "lab/wiring.hpp"
#include "lab/machine.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
namespace reg = trammel::kung_xy_regs;

namespace {

constexpr cosim::Clk kTickClk = 25000;  // 2 kHz

// A short line: start-up and 20 points, 45 ms.
Options piece() {
  Options options;
  options.reached_m = 1;  // it ends while the table is still under way
  options.run.platform = Platform::kDirect;
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.11;
  options.path.line_end_y_m = 0.105;
  options.path.line_ticks = 20;
  return options;
}

Result traced(const Options& base, const std::string& trigger) {
  Options options = base;
  options.run.wave = WaveFormat::kFst;
  options.run.wave_file = test::own_file("kung_waves_test.fst");
  options.run.wave_trigger = trigger;
  Result result = simulate(options, {});
  std::filesystem::remove(options.run.wave_file);
  return result;
}

// Keeps the chip's reader between two edges.
struct Reader final : cosim::Watcher {
  void after(cosim::Clk, const SignalReader& reader) override { chip = &reader; }
  static bool knows(const std::string& name) {
    return std::any_of(signals().begin(), signals().end(),
                       [&](const Signal& signal) { return signal.name == name; });
  }
  std::int64_t read(const std::string& name, int axis) const {
    const auto& all = signals();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].name == name) return chip->read(i, axis);
    }
    throw std::logic_error("no signal " + name);
  }
  const SignalReader* chip = nullptr;
};

// The number in a field of a word that the bus read.
std::int64_t number(std::uint32_t word, const reg::Field& field) {
  const int above = 32 - field.width;
  const std::uint32_t bits = word >> field.shift << above;
  return field.is_signed ? std::int64_t{static_cast<std::int32_t>(bits) >> above}
                         : std::int64_t{bits >> above};
}

}  // namespace

TEST_CASE("a search finds each event where the record or the bus says it is") {
  const Options options = piece();
  const Result base = simulate(options, {});
  REQUIRE(base.end == EndReason::kDone);

  // Samples begin at 2 kHz ticks, the first at clock 0.
  const Result afc = traced(options, "afc.x after 10ms");
  REQUIRE(afc.wave_trigger);
  CHECK(*afc.wave_trigger / kTickClk >= 20);
  CHECK(*afc.wave_trigger % kTickClk == 0);

  // The processor enables at its first interrupt, 2 ms after the start.
  const Result drives = traced(options, "");
  REQUIRE(drives.wave_trigger);
  CHECK(*drives.wave_trigger > 4 * kTickClk);
  CHECK(*drives.wave_trigger < 4 * kTickClk + 1000);
  REQUIRE(drives.waves.size() == 1);
  CHECK(drives.waves[0].end - drives.waves[0].begin == 100000);
  CHECK(drives.waves[0].begin < *drives.wave_trigger);

  // A word takes its value in the steps of the sample in whose record it first appears.
  const Result word = traced(options, "x.e > 10");
  REQUIRE(word.wave_trigger);
  const auto found = std::find_if(base.samples.begin(), base.samples.end(),
                                  [](const Sample& s) { return s.axis[0].e > 10; });
  REQUIRE(found != base.samples.end());
  CHECK(*word.wave_trigger > (*found).edge);
  CHECK(*word.wave_trigger < (*found).edge + 71);

  CHECK(*traced(options, "at 20ms").wave_trigger == 1000000);

  for (const Result* result : {&afc, &drives, &word}) {
    CHECK(result->event_hash == base.event_hash);
    CHECK(result->samples.size() == base.samples.size());
  }
}

TEST_CASE("a fault is found at the clock that latched it") {
  Options options = piece();
  options.fault = {cosim::FaultKind::kTripPin, 0.02};
  const Result result = traced(options, "fault.trip");
  REQUIRE(result.wave_trigger);
  CHECK(result.end == EndReason::kFault);
  CHECK(*result.wave_trigger == 1000000 + 2);  // two flip-flops behind the pin, then the latch
  CHECK(result.waves.size() == 1);
  // The pin itself, and the same search in the other wiring.
  CHECK(*traced(options, "rise trip").wave_trigger == 1000000);
  options.run.platform = Platform::kSystemC;
  CHECK(*traced(options, "fault").wave_trigger == *result.wave_trigger);
  options.run.leap = false;
  CHECK(*traced(options, "fault").wave_trigger == *result.wave_trigger);
}

TEST_CASE("a trigger that never fires leaves a complete run and no waves") {
  const Options options = piece();
  const Result base = simulate(options, {});
  const Result result = traced(options, "fault");
  CHECK_FALSE(result.wave_trigger);
  CHECK(result.waves.empty());
  CHECK(result.end == EndReason::kDone);
  CHECK(result.event_hash == base.event_hash);
  CHECK(result.samples.size() == base.samples.size());
}

TEST_CASE("where the drives never start the default window begins with the run") {
  Options options = piece();
  options.fault = {cosim::FaultKind::kProcessorHung, 0.001};  // before its first interrupt
  options.run.max_s = 0.01;
  const Result result = traced(options, "");
  CHECK_FALSE(result.wave_trigger);
  REQUIRE(result.waves.size() == 1);
  CHECK(result.waves[0].begin == 0);
  CHECK(result.waves[0].end == 100000);
}

TEST_CASE("a window in every period is dumped, and the clocks between are leapt over") {
  Options options = piece();
  const Result base = simulate(options, {});
  options.run.wave_every_s = 0.01;
  const Result result = traced(options, "");
  REQUIRE(result.waves.size() == 5);
  CHECK(result.waves[3].begin == 1500000);
  CHECK(result.waves[3].end == 1510000);
  CHECK(result.event_hash == base.event_hash);
  CHECK(result.evaluated > base.evaluated + 40000);
  CHECK(result.evaluated < base.evaluated + 50000);
}

TEST_CASE("windows that begin at any clock show the run exactly") {
  // At the end of each the registers of both chips are compared. 2503 clocks are no part of any
  // period of the chip, so that the 900 windows begin in all its states.
  Options options = piece();
  const Result base = simulate(options, {});
  options.run.wave = WaveFormat::kFst;
  options.run.wave_file = test::own_file("kung_waves_test.fst");
  options.run.wave_begin_s = 0;
  options.run.wave_end_s = 97 * 20e-9;
  options.run.wave_every_s = 2503 * 20e-9;
  const auto check = [&base](const Options& shown) {
    const Result result = simulate(shown, {});
    std::filesystem::remove(shown.run.wave_file);
    CHECK_FALSE(result.assertion);
    CHECK(result.end == EndReason::kDone);
    CHECK(result.waves.size() > 800);
    CHECK(result.event_hash == base.event_hash);
    const auto inside = static_cast<std::int64_t>(97 * result.waves.size());
    CHECK(result.evaluated > base.evaluated + inside * 3 / 4);
    CHECK(result.evaluated <= base.evaluated + inside + inside / 97);
    std::int64_t causes = 0;
    for (const auto count : result.wakes) causes += count;
    CHECK(causes == result.evaluated);
  };
  check(options);
  options.run.platform = Platform::kSystemC;
  check(options);
}

TEST_CASE("a stop request ends the search and the run") {
  Options options = piece();
  options.run.wave = WaveFormat::kFst;
  options.run.wave_file = test::own_file("kung_waves_test.fst");
  options.run.wave_trigger = "fault";
  std::atomic<bool> stop{false};
  Hooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&stop](double fraction) { stop = fraction > 0.2; };
  const Result result = simulate(options, hooks);
  CHECK(result.end == EndReason::kStopped);
  CHECK(result.samples.size() > 20);
  CHECK(result.waves.empty());
}

// Of a window that is anchored to the start of the drives, too: what ran until then was the run.
TEST_CASE("a stop request during the search begins no second run, whatever is searched for") {
  for (const char* trigger : {"", "fault", "x.e > 100"}) {
    Options options = piece();
    options.run.wave = WaveFormat::kFst;
    options.run.wave_file = test::own_file("kung_waves_test.fst");
    options.run.wave_trigger = trigger;
    const std::atomic<bool> stop{true};
    Hooks hooks;
    hooks.stop = &stop;
    int runs = 0;
    const auto make = [&](const Hooks& own, const cosim::Waves& waves) {
      ++runs;
      return machine().session(options, own, waves);
    };
    const auto result = lab::simulate(options.run, triggers(), make, hooks);
    CAPTURE(trigger);
    CHECK(runs == 1);
    CHECK(result->end == EndReason::kStopped);
    CHECK(result->waves.empty());
    CHECK_FALSE(std::filesystem::exists(options.run.wave_file));
  }
}

TEST_CASE("the signals of triggers are what the registers read") {
  Options options = piece();
  for (AxisGains& gains : options.gains) {  // too high: the sticky bits of STATUS are set
    gains.kp = gains.kv = 30;
    gains.current_kp_V_A = 900;
  }
  const auto plan = make_plan(options);
  const sw::KungSetup& setup = plan->setup;
  sw::KungApp app(setup);
  const sw::Point start = sw::Trajectory(setup).start();
  plant::XyTableConfig table = options.plant;
  table.axis[0].start_m = start.x * 5e-6;
  table.axis[1].start_m = start.y * 5e-6;
  TablePlant plant(table);
  Reader signal;
  const auto chip = make_watched_chip(signal, true);
  struct Nothing final : cosim::Observer {
    void on(const cosim::Stop&, const cosim::Chip&, const cosim::Plant&) override {}
  } nothing;
  cosim::Loop loop(*chip, plant, nothing);
  cosim::run_direct(loop, app, {8, 100}, 1000000, [] { return false; });
  // Between two runs of the current loop nothing the registers show moves; the last ones before a
  // sample are those in which the encoder is far from what was latched.
  loop.advance(cosim::kNever, cosim::kSample);
  cosim::DirectBus bus(loop, {8, 100});
  bus.wait_until(chip->now() + 7 * 3125 + 200);
  for (int axis = 0; axis < 2; ++axis) {
    REQUIRE(signal.read("count", axis) != signal.read("x_p", axis));
    REQUIRE(signal.read("STATUS.saturated", axis) == 1);
    REQUIRE(signal.read("STATUS.limited", axis) == 1);
  }

  std::vector<reg::Field> fields(reg::kFields.begin(), reg::kFields.end());
  fields.insert(fields.end(), reg::kWords.begin(), reg::kWords.end());
  int moved = 0;
  const auto compare = [&](const std::string& of) {  // fields whose names begin like this
    for (const reg::Field& field : fields) {
      if (!Reader::knows(field.name) || std::string(field.name).rfind(of, 0) != 0) continue;
      for (int axis = 0; axis < (field.of_axis ? 2 : 1); ++axis) {
        INFO(field.name << " of axis " << axis);
        const std::uint32_t base = !field.of_axis ? 0 : axis == 0 ? reg::kX : reg::kY;
        const std::int64_t read = number(bus.read(base + field.address), field);
        CHECK(signal.read(field.name, axis) == read);
        moved += read != 0 ? 1 : 0;
      }
    }
  };
  compare("");
  CHECK(signal.read("LOCK", 0) == 1);
  CHECK(signal.read("CTRL.enable", 1) == 1);
  CHECK(moved > 70);  // zeros alone would prove little

  // A fault of each axis, with a code whose lowest bit is not the axis in X: it leaves its stroke.
  for (const std::uint32_t base : {reg::kX, reg::kY}) bus.write(base + reg::kCtrl, 0);
  bus.write(reg::kLock, reg::kKeyUnlock);
  for (const int axis : {0, 1}) {
    const std::uint32_t base = axis == 0 ? reg::kX : reg::kY;
    CAPTURE(axis);
    bus.write(base + reg::kStrokeMin, 0x7FFFFF);
    bus.write(base + reg::kStrokeEn, 1);
    bus.wait_until(chip->now() + 10);
    CHECK(signal.read("FAULT.code", 0) == reg::kFaultCodeStroke);
    CHECK(signal.read("FAULT.axis", 0) == axis);
    compare("FAULT");
    compare("IRQ_STAT");
    bus.write(base + reg::kStrokeEn, 0);
    bus.write(reg::kFaultClear, reg::kKeyFaultClear);
    CHECK(signal.read("FAULT.code", 0) == 0);
  }
}
