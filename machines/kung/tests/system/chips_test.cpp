// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip and its twin on one bench: the same random bus transfers, encoder edges, trips
// and currents, and the same answer at every edge at which either shows anything.
#include <algorithm>
#include <catch2/catch.hpp>

#include "cosim/direct.hpp"
#include "machines/kung/tests/chips.hpp"
#include "machines/kung/tests/stop_values.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "tests/support/kung_transfers.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
namespace reg = kung_xy_regs;

namespace {

using test::below;
using test::Random;

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

  std::vector<test::StopValues> stops;  // since they were last compared

 private:
  std::unique_ptr<kung::KungChip> chip_;
  RandomPlant plant_;
  cosim::Loop loop_;
};

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

void count(const test::StopValues& stop, std::int64_t& fault, Reached& reached) {
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
      script = test::recovery(random);
      std::reverse(script.begin(), script.end());
    }
    cosim::BusOp op = test::random_transfer(random);
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
