// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip and its twin on one bench: the same random bus transfers, encoder edges, trips
// and currents, and the same answer at every edge at which either shows anything.
#include <algorithm>
#include <catch2/catch.hpp>

#include "cosim/direct.hpp"
#include "machines/kung/tests/chip_words.hpp"
#include "machines/kung/tests/chips.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
namespace reg = kung_xy_regs;

namespace {

using test::Random;

std::uint32_t below(Random& random, std::uint32_t n) { return random() % n; }

// Encoder lines that walk, with an illegal jump now and then, a trip pin, and currents from a hash.
class RandomPlant final : public cosim::Plant {
 public:
  RandomPlant(std::uint32_t seed, std::uint32_t pace) : random_(seed), pace_(pace) {}

  cosim::Lines sense() const override { return lines_; }
  cosim::Clk next() const override { return next_; }
  void commit(cosim::Clk n, cosim::Lines) override {
    if (n < next_) return;
    const std::uint32_t what = below(random_, 400);
    const int axis = static_cast<int>(below(random_, 2));
    if (what == 0) {
      lines_ ^= cosim::Lines{3} << kung::encoder_a(axis);
    } else if (what == 1 || (lines_ >> kung::kTripPin & 1u) != 0) {
      lines_ ^= cosim::Lines{1} << kung::kTripPin;
    } else if (what < 20) {
      lines_ ^= cosim::Lines{1} << kung::encoder_z(axis);
    } else {
      lines_ ^= cosim::Lines{1} << (kung::encoder_a(axis) + below(random_, 2));
    }
    next_ = n + 1 + below(random_, pace_);
  }
  int sample(int channel, cosim::Clk n) const override {
    const std::uint64_t h = plant::hash(static_cast<std::uint64_t>(n * 4 + channel));
    const int wide = h % 61 == 0 ? 2047 : 500;
    return 2048 + static_cast<int>(h >> 40) % (2 * wide + 1) - wide;
  }

 private:
  Random random_;
  std::uint32_t pace_;
  cosim::Lines lines_ = 0;
  cosim::Clk next_ = 5;
};

class Bench final : public cosim::Observer {
 public:
  Bench(std::unique_ptr<kung::KungChip> chip, std::uint32_t seed, std::uint32_t pace)
      : chip_(std::move(chip)), plant_(seed, pace), loop_(*chip_, plant_, *this) {}

  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    stops.push_back(test::look(stop, *chip_));
  }
  cosim::Loop& loop() { return loop_; }

  std::vector<test::StopWords> stops;  // since they were last compared

 private:
  std::unique_ptr<kung::KungChip> chip_;
  RandomPlant plant_;
  cosim::Loop loop_;
};

// A transfer as a program might make it: mostly the registers that matter while the drives run.
cosim::BusOp random_transfer(Random& random) {
  const std::uint32_t base = below(random, 2) == 0 ? reg::kX : reg::kY;
  const std::uint32_t any = random();
  if (below(random, 5) < 2) {  // read anything, the empty places too
    const bool axis = below(random, 4) != 0;
    return {(axis ? base : 0x200u) + 4 * below(random, axis ? 0x28u : 0x10u), 0, false};
  }
  switch (below(random, 26)) {
    case 0:
    case 1:
    case 2: return {base + reg::kCtrl, below(random, 4) == 0 ? any : (any & 0xCFu) | 3u, true};
    case 3: return {base + reg::kCtrl, any & 0xFEu, true};
    case 4:
    case 5: return {reg::kCommit, any, true};
    case 6:
    case 7: return {base + reg::kPosCmd, any & 0x3FFFu, true};
    case 8: return {base + reg::kPosPreset, any & 0x3FFFu, true};
    case 9: return {reg::kIrqStat, any & 3u, true};
    case 10: return {reg::kIrqEn, any, true};
    case 11: return {base + reg::kStatus, any, true};
    case 12: return {reg::kFaultClear, reg::kKeyFaultClear, true};
    case 13: return {reg::kLock, below(random, 3) == 0 ? reg::kKeyLock : reg::kKeyUnlock, true};
    case 14: return {base + reg::kTabAddr, any, true};
    case 15: return {base + reg::kTabData, any, true};
    case 16: return {reg::kCurrentLimit, below(random, 4) == 0 ? any & 0x7FFu : 2000u, true};
    case 17: return {reg::kWatchdog, any & 7u, true};
    case 18: return {reg::kIrqPeriod, any & 3u, true};
    case 19: return {base + reg::kDeadtime, (any & 0xF00FFu) | (any >> 30 << 8), true};
    case 20: return {reg::kDeadtimeMin, any & 0x7Fu, true};
    case 21: return {base + reg::kStrokeEn, below(random, 4) == 0 ? 1u : 0u, true};
    case 22: return {base + reg::kStrokeMin + 4 * below(random, 2), any & 0x3FFFu, true};
    case 23: return {base + reg::kIqManual, any, true};
    default: return {base + reg::kKp + 4 * below(random, 12), any, true};
  }
}

// What a program does to restart after a trip.
std::vector<cosim::BusOp> recovery(Random& random) {
  const auto mode = [&random] { return (random() & 0xCEu) | 1u; };
  return {{reg::kX + reg::kCtrl, 0, true},
          {reg::kY + reg::kCtrl, 0, true},
          {reg::kLock, reg::kKeyUnlock, true},
          {reg::kX + reg::kStatus, ~0u, true},
          {reg::kY + reg::kStatus, ~0u, true},
          {reg::kX + reg::kStrokeEn, 0, true},
          {reg::kY + reg::kStrokeEn, 0, true},
          {reg::kCurrentLimit, 0, true},
          {reg::kWatchdog, below(random, 2) * 40, true},
          {reg::kFaultClear, reg::kKeyFaultClear, true},
          {reg::kX + reg::kCtrl, mode(), true},
          {reg::kY + reg::kCtrl, mode(), true}};
}

void step(Bench& bench, cosim::Clk wait, const cosim::BusOp& op) {
  cosim::Loop& loop = bench.loop();
  loop.advance(loop.chip().now() + wait, 0);
  loop.chip().request(op);
  loop.advance(cosim::kNever, cosim::kBusDone);
}

// What the random traffic reached.
struct Reached {
  int gates = 0, irqs = 0, samples = 0, trips = 0, clears = 0;
};

void count(const test::StopWords& stop, std::int64_t& fault, Reached& reached) {
  reached.gates += (stop.stop.why & cosim::kDrive) != 0;
  reached.irqs += (stop.stop.why & cosim::kIrq) != 0;
  reached.samples += (stop.stop.why & cosim::kSample) != 0;
  reached.trips += fault == 0 && stop.words[2] != 0;
  reached.clears += fault != 0 && stop.words[2] == 0;
  fault = stop.words[2];
}

void compare(std::uint32_t seed, std::uint32_t pace, std::uint32_t gap, int transfers,
             Reached& reached) {
  Bench rtl(kung::make_verilated_chip(true), seed, pace);
  Bench twin(kung::make_twin_chip(), seed, pace);
  Random random(seed + 1000);
  // The table of rules is filled first; before that TAB_DATA has no value.
  for (Bench* bench : {&rtl, &twin}) bench->loop().advance(60, 0);
  std::vector<cosim::BusOp> script;
  std::int64_t fault = 0;
  for (int n = 0; n < transfers; ++n) {
    if (script.empty() && below(random, 20) == 0) {
      script = recovery(random);
      std::reverse(script.begin(), script.end());
    }
    cosim::BusOp op = random_transfer(random);
    if (!script.empty()) {
      op = script.back();
      script.pop_back();
    }
    const bool long_wait = script.empty() && below(random, 8) == 0;
    const cosim::Clk wait = below(random, long_wait ? 40000 : gap);
    step(rtl, wait, op);
    step(twin, wait, op);
    INFO("seed " << seed << ", transfer " << n << ": "
                 << test::register_name(reg::kRegisters, op.addr)
                 << (op.write ? " written, " + test::number(op.data, 8) : std::string(" read")));
    const std::size_t stops = std::min(rtl.stops.size(), twin.stops.size());
    for (std::size_t k = 0; k < stops; ++k) {
      const std::string differences = test::differences(rtl.stops[k], twin.stops[k]);
      if (!differences.empty()) FAIL(differences);
      count(rtl.stops[k], fault, reached);
    }
    REQUIRE(twin.stops.size() == rtl.stops.size());
    rtl.stops.clear();
    twin.stops.clear();
  }
}

}  // namespace

TEST_CASE("under random traffic the twin answers as the RTL does at every edge") {
  const int scale = GENERATE(0, 1, 2, 3);
  CAPTURE(scale);
  constexpr std::uint32_t kPaces[] = {400, 60, 2000, 12};
  constexpr std::uint32_t kGaps[] = {40, 8, 3000, 200};
  Reached reached;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    compare(10 * static_cast<std::uint32_t>(scale) + seed, kPaces[scale], kGaps[scale], 800,
            reached);
  }
  CAPTURE(reached.gates, reached.irqs, reached.samples, reached.trips, reached.clears);
  CHECK(reached.gates > 100);
  CHECK(reached.irqs > 5);
  CHECK(reached.samples > 100);
  CHECK(reached.trips > 20);
  CHECK(reached.clears > 20);
}
