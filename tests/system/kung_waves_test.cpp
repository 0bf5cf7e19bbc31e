// SPDX-License-Identifier: Apache-2.0
//
// Triggers on the full machine: the events they name are where other evidence says they are, the
// signals they read are what the bus reads, and looking changes nothing.
#include <catch2/catch.hpp>
#include <filesystem>

#include "cosim/direct.hpp"
#include "cosim/kung/plan.hpp"
#include "cosim/kung/session.hpp"
#include "systemc/machines/kung.hpp"

using namespace trammel;
using namespace trammel::kung;
namespace reg = trammel::sw::kung_xy_regs;

namespace {

constexpr cosim::Clk kTickClk = 25000;  // 2 kHz

// A short line: start-up and 20 points, 45 ms.
Options piece() {
  Options options;
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
  options.run.wave_file = "kung_waves_test.fst";
  options.run.wave_trigger = trigger;
  Result result = simulate(options, {});
  std::filesystem::remove(options.run.wave_file);
  return result;
}

// Keeps the chip's reader between two edges.
struct Reader final : Watcher {
  void after(cosim::Clk, const SignalReader& reader) override { chip = &reader; }
  std::int64_t read(const std::string& name, int axis) const {
    const auto& all = signals();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].name == name) return chip->read(i, axis);
    }
    throw std::logic_error("no signal " + name);
  }
  const SignalReader* chip = nullptr;
};

std::int32_t half(std::uint32_t word, int high) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(word >> (high != 0 ? 16 : 0)));
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

  // A word becomes so in the steps of the sample in whose record it first is.
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
  options.inject.trip_s = 0.02;
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

TEST_CASE("a trigger that never fires leaves the run whole and no waves") {
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
  options.inject.processor_s = 0.001;  // before its first interrupt
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
  options.run.wave_file = "kung_waves_test.fst";
  options.run.wave_begin_s = 0;
  options.run.wave_end_s = 97 * 20e-9;
  options.run.wave_every_s = 2503 * 20e-9;
  const auto check = [&base](const Options& shown) {
    const Result result = simulate(shown, {});
    std::filesystem::remove(shown.run.wave_file);
    CHECK_FALSE(result.promise);
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

TEST_CASE("a run with waves that looks at promises has the same events") {
  Options options = piece();
  options.path.line_end_x_m = 0.101;
  options.path.line_end_y_m = 0.1005;
  options.path.line_ticks = 10;
  const Result base = simulate(options, {});
  options.run.assertions = true;
  options.run.wave_every_s = 0.005;
  options.run.wave_begin_s = 0.0010002;
  options.run.wave_end_s = 0.0012;
  options.run.wave = WaveFormat::kFst;
  options.run.wave_file = "kung_waves_test.fst";
  Result result = simulate(options, {});
  std::filesystem::remove(options.run.wave_file);
  CHECK(result.end == EndReason::kDone);
  CHECK_FALSE(result.promise);
  CHECK(result.waves.size() > 5);
  CHECK(result.evaluated == result.clocks);
  CHECK(result.event_hash == base.event_hash);
}

TEST_CASE("a stop request ends the search and the run") {
  Options options = piece();
  options.run.wave = WaveFormat::kFst;
  options.run.wave_file = "kung_waves_test.fst";
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

TEST_CASE("the signals of triggers are what the registers read") {
  Options options = piece();
  for (AxisGains& gains : options.gains) {  // too high: the sticky bits of STATUS are set
    gains.kp = gains.kv = 30;
    gains.current_kp_V_A = 900;
  }
  std::vector<sw::Point> points;
  sw::KungApp app(plan_firmware(options, points));
  plant::XyTableConfig table = options.plant;
  table.axis[0].start_m = app.start_point().x * 5e-6;
  table.axis[1].start_m = app.start_point().y * 5e-6;
  TablePlant plant(table, cosim::kNever, cosim::kNever);
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

  CHECK(signal.read("TICK", 0) == bus.read(reg::kTick));
  CHECK(signal.read("FAULT", 0) == bus.read(reg::kFault));
  CHECK(signal.read("LOCK", 0) == 1);
  CHECK((bus.read(reg::kLock) & 1u) == 1);
  const std::pair<const char*, std::uint32_t> words[] = {
      {"POS_CMD", reg::kPosCmd}, {"POS", reg::kPos},       {"POS_MODEL", reg::kPosModel},
      {"ERR", reg::kErr},        {"DERR", reg::kDerr},     {"U", reg::kU},
      {"VSTAR", reg::kVstar},    {"IQ_CMD", reg::kIqCmd},  {"SPEED", reg::kSpeed},
      {"CTRL", reg::kCtrl},      {"STATUS", reg::kStatus}, {"INDEX_LATCH", reg::kIndexLatch}};
  int moved = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const std::uint32_t base = axis == 0 ? reg::kX : reg::kY;
    for (const auto& [name, offset] : words) {
      INFO(name << " of axis " << axis);
      const auto read = static_cast<std::int32_t>(bus.read(base + offset));
      CHECK(signal.read(name, axis) == read);
      moved += read != 0 ? 1 : 0;
    }
    const std::uint32_t currents = bus.read(base + reg::kIdIq);
    CHECK(signal.read("ID_IQ.i_d", axis) == half(currents, 0));
    CHECK(signal.read("ID_IQ.i_q", axis) == half(currents, 1));
    const std::uint32_t voltages = bus.read(base + reg::kVdVq);
    CHECK(signal.read("VD_VQ.v_d", axis) == half(voltages, 0));
    CHECK(signal.read("VD_VQ.v_q", axis) == half(voltages, 1));
    CHECK(signal.read("STATUS.step", axis) == signal.read("STATUS", axis) >> 8);
    CHECK(signal.read("CTRL.enable", axis) == 1);
  }
  CHECK(moved > 15);  // zeros alone would prove little
}
