// SPDX-License-Identifier: Apache-2.0
//
// The verilated LM628 and its twin behind the same port: the same random commands, bytes and
// encoder edges, and the same stops, outputs and words of every sample.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>

#include "parts/lm628/chip.hpp"
#include "sw_nios/hal/lm628.hpp"
#include "tests/chips/lm628_transfers.hpp"
#include "tests/support/lm628_words.hpp"
#include "tests/support/no_plant.hpp"
#include "tests/support/same.hpp"

using namespace trammel;
using test::Random;

namespace {

class ChipsBench final : public test::Lm628Commands<ChipsBench> {
 public:
  explicit ChipsBench(const lm628::PartOptions& part = {})
      : rtl_(lm628::make_verilated_chip({}, {}, part)), twin_(lm628::make_twin_chip(part)) {
    set_lines();
  }

  void clocks(std::int64_t n) {
    const cosim::Clk end = rtl_->now() + n;
    while (rtl_->now() < end) run(end);
  }
  void write(bool ps, std::uint8_t value) { transfer({address(ps), value, true}); }
  std::uint8_t read(bool ps) {
    transfer({address(ps), 0, false});
    return static_cast<std::uint8_t>(rtl_->rdata());
  }
  void start() {
    transfer({sw::lm628_map::kReset, 1, true});
    clocks(70'000);  // 8000 ticks of 6 MHz are 66 667
  }

  // The encoder goes part of the way to its desired position, one count every few clocks.
  void follow() {
    const std::int64_t wanted = twin_->words().position >> 16;
    const std::int64_t goal = position_ + (wanted - position_) / 4;
    if (std::abs(goal - position_) > 3000) return;
    while (position_ != goal) {
      position_ += goal > position_ ? 1 : -1;
      set_lines();
      clocks(3);
    }
  }

  int samples() const { return samples_; }

 private:
  static std::uint32_t address(bool ps) {
    return ps ? sw::lm628_map::kData : sw::lm628_map::kCommand;
  }

  void transfer(const cosim::BusOp& op) {
    rtl_->request(op);
    twin_->request(op);
    while ((run(rtl_->now() + 1000) & cosim::kBusDone) == 0) {}
    if (!op.write) {
      const char* const name = op.addr == sw::lm628_map::kData ? "byte read" : "status byte read";
      test::same(name, rtl_->rdata(), twin_->rdata(), rtl_->now());
    }
  }

  unsigned run(cosim::Clk end) {
    const test::NoPlant plant;
    const cosim::Stop stop = rtl_->run(end, plant), same = twin_->run(end, plant);
    test::same("edge of the stop", stop.edge, same.edge, stop.edge);
    test::same("reason of the stop", stop.why, same.why, stop.edge);
    test::same("word of the converter", rtl_->drive(), twin_->drive(), stop.edge);
    test::same("interrupt", rtl_->irq(), twin_->irq(), stop.edge);
    test::same("edge at which HI rose", rtl_->host_rise(), twin_->host_rise(), stop.edge);
    if ((stop.why & cosim::kSample) != 0) {
      ++samples_;
      CAPTURE(stop.edge);
      test::require_same(twin_->words(), rtl_->words());
    }
    return stop.why;
  }

  void set_lines() {
    const auto phase = static_cast<unsigned>(position_ & 3);
    const cosim::Lines lines = cosim::Lines{phase == 1 || phase == 2} << lm628::kEncoderA |
                               cosim::Lines{phase >= 2} << lm628::kEncoderB |
                               cosim::Lines{position_ % 64 == 0} << lm628::kIndex;
    rtl_->sense(lines);
    twin_->sense(lines);
  }

  std::unique_ptr<lm628::Lm628Chip> rtl_, twin_;
  std::int64_t position_ = 0;
  int samples_ = 0;
};

void run_random(ChipsBench& bench, int commands) {
  Random random(71);
  bench.start();
  for (int n = 0; n < commands; ++n) {
    CAPTURE(n);
    if (random() % 10 == 0) {
      test::wild(bench, random);
    } else {
      bench.ready();
      test::ordered(bench, random);
    }
    if (random() % 4 == 0) bench.clocks(random() % 20'000);
    bench.follow();
    if (random() % 500 == 0) {
      if (random() % 2 == 0) {
        bench.start();
      } else {
        bench.command(exact::Opcode::kReset);
      }
    }
  }
}

}  // namespace

TEST_CASE("L-15 lm628 and its twin have the same words at every sample of 10,000 commands") {
  ChipsBench bench;
  run_random(bench, 10'000);
  CHECK(bench.samples() > 4000);
}

TEST_CASE("an LM629 of 6 MHz that wraps and its twin have the same words and pulses") {
  lm628::PartOptions part;
  part.variant = lm628::Variant::kLm629;
  part.clock_MHz = 6;
  part.wrap = true;
  ChipsBench bench(part);
  run_random(bench, 1500);
  CHECK(bench.samples() > 500);
}
