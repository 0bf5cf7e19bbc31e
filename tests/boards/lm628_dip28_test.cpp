// SPDX-License-Identifier: Apache-2.0
//
// The part in its package: every pin beside the twin's, and a host behind a transceiver.

#include <Vlm628_dip28.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/chips/lm628_bench.hpp"
#include "tests/chips/lm628_transfers.hpp"

using trammel::exact::Lm628;
using trammel::exact::Opcode;
using trammel::test::Lm628Bench;
using trammel::test::Lm628Twin;
using trammel::test::run_random;
using trammel::test::same;

namespace {

// The board has no reset but that of the pin.
struct Model : Vlm628_dip28 {
  using Vlm628_dip28::Vlm628_dip28;
  std::uint8_t rst_i = 0;
};

class Package : public Lm628Twin {
 public:
  bool twelve = false;  // the part has 12 bits: pins 24 and 25 are those of their strobes

  Package() {
    in.reset_n = false;
    for (int i = 0; i < 8; ++i) edge();
  }

  std::int64_t run(std::int64_t) {
    const Lm628::Out was = twin_.out();
    edge();
    const Lm628::Out out = twin_.out();
    ++clock_;
    same("d_o", rtl_->d_o, out.d, clock_);
    same("hi_o", rtl_->hi_o, out.hi, clock_);
    if (rtl_->d_oe_o) same("direction_o", rtl_->direction_o, true, clock_);
    same("d_oe_o", rtl_->d_oe_o, was.d_oe && direction_, clock_);
    direction_ = rtl_->direction_o != 0;
    if (twelve || !was.drive.dac_wr_n || !was.drive.dac_hi_lo) {
      const int strobes = was.drive.dac_hi_lo * 2 + was.drive.dac_wr_n;
      same("out_o", rtl_->out_o, (was.drive.dac & 0xFC) | strobes, clock_);
    } else if ((was.drive.dac & 3) != 0) {  // only a byte has these bits
      byte_ = rtl_->out_o == was.drive.dac;
      late_ = byte_ ? 0 : late_ + 1;
      REQUIRE(late_ <= 1);  // the clock after the sample that brought it
    } else {
      same("upper bits of out_o", rtl_->out_o & 0xFC, was.drive.dac, clock_);
    }
    return 1;
  }

  std::uint8_t port() { return rtl_->out_o; }

  // What a host sees through the transceiver.
  bool drives() const { return direction_; }

 private:
  void edge() {
    set_pins_of_host();
    rtl_.tick();
    twin_.step(in);
  }
  void set_pins_of_host() {
    rtl_->reset_n_i = in.reset_n;
    rtl_->cs_n_i = in.host.cs_n;
    rtl_->rd_n_i = in.host.rd_n;
    rtl_->wr_n_i = in.host.wr_n;
    rtl_->ps_i = in.host.ps;
    rtl_->d_i = in.host.d;
    rtl_->enc_a_i = in.a;
    rtl_->enc_b_i = in.b;
    rtl_->enc_idx_n_i = in.index_n;
  }

  trammel::test::Rtl<Model> rtl_;
  std::int64_t clock_ = 0;
  bool direction_ = false, byte_ = false;
  int late_ = 0;
};

using Bench = Lm628Bench<Package>;

}  // namespace

TEST_CASE("lm628_dip28 has the pins of the twin over 150 random transfers") {
  Bench bench;
  run_random(bench, {150, 64});
  CHECK(bench.samples() > 50);
}

// An edge on pin 25 that the part does not give would be one more strobe.
TEST_CASE("lm628_dip28 leaves pins 24 and 25 high between the strobes of 12 bits") {
  Bench bench;
  bench.start();
  bench.command(Opcode::kPort12);
  bench.sample(2);
  bench.chip.twelve = true;
  bench.sample(4);
}

// Of 12 bits the reset would leave pins 24 and 25 high, where 8 bits of zero have them low.
TEST_CASE("lm628_dip28 has a port of 8 bits after a reset, whatever it had before") {
  constexpr std::int64_t kStrobes = 4 * 50, kHold = 127;  // [clk] lm628_output, lm628_pins
  Bench bench;
  bench.start();
  bench.command(Opcode::kPort12);
  bench.sample(3);
  bench.clocks(kStrobes);
  bench.hardware_reset(60);
  bench.clocks(kStrobes + kHold + 8);
  same("out_o", bench.chip.port(), 0x80, bench.now());
}

// SNVS781C p.4: 180 ns from RD to the data, and as much until the bus is free.
TEST_CASE("lm628_dip28 drives the bus 6 clocks after RD at the latest, and is off it 6 after") {
  Bench bench;
  bench.start();
  auto& host = bench.chip.in.host;
  host = {};
  host.cs_n = host.rd_n = false;
  int on = 0, off = 0;
  while (!bench.chip.drives()) {
    bench.clocks(1);
    ++on;
  }
  bench.clocks(1);
  host.rd_n = true;
  while (bench.chip.drives()) {
    bench.clocks(1);
    ++off;
  }
  CHECK(on + 1 <= 6);  // a clock after the transceiver the part drives
  CHECK(off <= 6);
}
