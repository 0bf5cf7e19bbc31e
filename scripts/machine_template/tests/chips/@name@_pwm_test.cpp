// SPDX-License-Identifier: Apache-2.0
//
// The motor chip counts what its encoder lines do; its pulses are as long as the duty word says.
#include <V@name@_pwm.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "cosim/verilated/clocked_model.hpp"
#include "tests/support/rtl.hpp"

namespace {

constexpr int kPeriod = 2500;

// A chip with the leap contract passes one clock at a time.
template <class Model>
void no_leap(Model& model) {
  if constexpr (trammel::cosim::kLeaps<Model>) model.leap_i = 0;
}

class Bench {
 public:
  Bench() {
    no_leap(**this);
    dut_->enable = 0;
    dut_->enc_a = dut_->enc_b = 0;
    set(0);
    for (int n = 0; n < 2; ++n) dut_.reset();  // the lines' flip-flops have none
  }

  V@name@_pwm& operator*() { return *dut_.operator->(); }

  void set(int duty) { dut_->duty = static_cast<std::uint16_t>(duty & 0x1FFF); }

  // Clocks of pulses in a period, from wherever it is.
  int pulse() {
    int high = 0;
    for (int i = 0; i < kPeriod; ++i) {
      dut_.tick();
      high += dut_->pwm;
    }
    return high;
  }

  // The encoder's lines, a quarter of a mark on.
  void turn(int quarters) {
    const int step = quarters < 0 ? -1 : 1;
    for (; quarters != 0; quarters -= step) {
      at_ += step;
      dut_->enc_a = ((at_ + 1) & 2) != 0;
      dut_->enc_b = (at_ & 2) != 0;
      for (int i = 0; i < 4; ++i) dut_.tick();
    }
  }
  int count() { return static_cast<std::int16_t>(dut_->count); }

 private:
  trammel::test::Rtl<V@name@_pwm> dut_;
  int at_ = 0;
};

}  // namespace

TEST_CASE("chips/@name@_pwm: a pulse is as long as the duty word, backward too") {
  Bench bench;
  (*bench).enable = 1;
  for (const int duty : {1, 100, -100, 2499, 2500, -2500, 4095, -4096, 0}) {
    bench.set(duty);
    bench.pulse();  // the word is taken in it
    const int wanted = duty < 0 ? -duty : duty;
    CHECK(bench.pulse() == (wanted < kPeriod ? wanted : kPeriod));
    CHECK(((*bench).direction != 0) == (duty < 0));
  }
}

TEST_CASE("chips/@name@_pwm: without enable there is no pulse") {
  Bench bench;
  bench.set(1000);
  bench.pulse();
  CHECK(bench.pulse() == 0);
  (*bench).enable = 1;
  CHECK(bench.pulse() == 1000);
}

TEST_CASE("chips/@name@_pwm: edges of the encoder are counted up and down") {
  Bench bench;
  bench.turn(1000);
  CHECK(bench.count() == 1000);
  bench.turn(-1003);
  CHECK(bench.count() == -3);
}
