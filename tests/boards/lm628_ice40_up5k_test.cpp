// SPDX-License-Identifier: Apache-2.0
//
// The LM628 of 8 MHz in a fabric of 20 MHz, as on an iCE40 UP5K: every pin beside the twin's.

#include <Vlm628_ice40_up5k.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/chips/lm628_bench.hpp"
#include "tests/chips/lm628_transfers.hpp"

using trammel::exact::Lm628;
using trammel::exact::Lm628Clock;
using trammel::exact::Opcode;
using trammel::test::Lm628Bench;
using trammel::test::Lm628Twin;
using trammel::test::run_random;

namespace {

// The board has no reset but that of the pin.
struct Model : Vlm628_ice40_up5k {
  using Vlm628_ice40_up5k::Vlm628_ice40_up5k;
  std::uint8_t rst_i = 0;
};

class Board : public Lm628Twin {
 public:
  Board() : Lm628Twin(Lm628Clock::k8MHzOf20) {
    in.reset_n = false;
    for (int i = 0; i < 4; ++i) edge();
  }

  std::int64_t run(std::int64_t) {
    edge();
    const Lm628::Out out = twin_.out();
    ++clock_;
    trammel::test::same("d_io", rtl_->d_io, out.d_oe ? out.d : 0, clock_);
    same_pins(rtl_, out, clock_);
    return 1;
  }

 private:
  // Verilator shows a bus that nobody drives as 0, and takes what is there before the edge.
  void edge() {
    set_pins(rtl_, in);
    if (twin_.out().d_oe) in.host.d = twin_.out().d;
    rtl_->d_io = in.host.d;
    rtl_.tick();
    twin_.step(in);
  }

  trammel::test::Rtl<Model> rtl_;
  std::int64_t clock_ = 0;
};

using Bench = Lm628Bench<Board>;

// Clocks until a pin of the twin meets a condition.
template <class Until>
std::int64_t clocks_until(Bench& bench, Until until) {
  const std::int64_t begin = bench.now();
  while (!until(bench.chip.twin())) bench.clocks(1);
  return bench.now() - begin;
}

}  // namespace

// 2.5 clocks a tick: 8000 are 20 000, 2048 are 5120, 400 are 1000, 160 are 400.
TEST_CASE("lm628_ice40_up5k resets for 1 ms, samples every 256 us, is busy for 20 us at 20 MHz") {
  Bench bench;
  bench.hardware_reset(20);
  bench.clocks(19980);
  REQUIRE(bench.status() == 0);
  bench.clocks(30);
  REQUIRE(bench.status() == 0x84);
  const auto commits = [](const Lm628& part) { return part.commits(); };
  clocks_until(bench, commits);
  bench.clocks(1);
  REQUIRE(clocks_until(bench, commits) == 5119);
  bench.write(false, Bench::code(Opcode::kUdf));
  const std::int64_t begin = bench.now() - 7 + 3;  // the strobe's end is seen
  bench.ready();
  REQUIRE(bench.now() - begin >= 400);
  REQUIRE(bench.now() - begin < 520);  // a poll
}

TEST_CASE("lm628_ice40_up5k puts out 12 bits with strobes of 1 us, pulses of 4 m of 512 ticks") {
  Bench bench;
  bench.start();
  bench.command(Opcode::kPort12);
  bench.command(Opcode::kLfil, {0x0008, 10});
  bench.command(Opcode::kUdf);
  bench.command(Opcode::kStt);
  bench.sample(3);
  bench.move_to(-500);  // an error of 500: u is 5000, m is 19
  bench.sample(2);
  const auto strobe = [](const Lm628& part) { return !part.out().drive.dac_wr_n; };
  const auto none = [](const Lm628& part) { return part.out().drive.dac_wr_n; };
  clocks_until(bench, strobe);
  REQUIRE(clocks_until(bench, none) == 20);
  REQUIRE(clocks_until(bench, strobe) == 20);
  const auto high = [](const Lm628& part) { return part.out().drive.pwm_mag; };
  const auto low = [](const Lm628& part) { return !part.out().drive.pwm_mag; };
  clocks_until(bench, low);
  clocks_until(bench, high);
  REQUIRE(clocks_until(bench, low) == 10 * 19);
  REQUIRE(clocks_until(bench, high) == 1280 - 10 * 19);
}

TEST_CASE("lm628_ice40_up5k saturates the products of its filter, as the part does") {
  for (const std::int64_t way : {-1, 1}) {
    CAPTURE(way);
    Bench bench;
    bench.start();
    bench.command(Opcode::kLfil, {0x0008, 0x7FFF});
    bench.command(Opcode::kUdf);
    bench.command(Opcode::kStt);
    bench.sample(3);
    bench.move_to(-2 * way);  // 2 times 7FFFh is FFFEh: -2, if it wraps
    bench.sample(2);
    REQUIRE(bench.engine().error() == 2 * way);
    CHECK(bench.engine().output() == 32767 * way);
    CHECK(bench.out().drive.dac == (way > 0 ? 0xFF : 0x00));
    CHECK(bench.out().drive.pwm_sign == (way < 0));
  }
}

// SNVS781C p.4 in clocks of 50 ns, the shortest times: WR low for 100 ns, data held for 120, 180
// from RD to the data.
TEST_CASE("lm628_ice40_up5k takes and gives bytes at the data sheet's shortest times") {
  Bench bench;
  bench.start();
  auto& host = bench.chip.in.host;
  for (const unsigned byte : {0x1Cu, 0x00u, 0x2Au}) {  // MSKI and its word
    bench.ready();
    host = {};
    host.cs_n = host.wr_n = false;
    host.ps = byte != 0x1C;
    host.d = static_cast<std::uint8_t>(byte);
    bench.clocks(2);
    host.wr_n = true;
    bench.clocks(2);
    host = {};
    bench.clocks(2);
  }
  bench.ready();
  REQUIRE((bench.status() & 2) == 0);
  host.cs_n = host.rd_n = false;
  bench.clocks(3);
  REQUIRE(bench.out().d_oe);
  REQUIRE(bench.out().d == 0x84);
  host = {};
  bench.clocks(3);
  REQUIRE_FALSE(bench.out().d_oe);
}

// What each line of the encoder is for, from the part's answers: A leads B forward, and the index
// counts where all three are low.
TEST_CASE("lm628_ice40_up5k counts A before B upward, and takes the index from its own pin") {
  Bench bench;
  bench.start();
  bench.clear_status();
  for (const std::int64_t position : {7, -6}) {
    bench.move_to(position, 8);
    bench.sample(2);
    REQUIRE(bench.ask(Opcode::kRdrp) == position);
  }
  bench.command(Opcode::kSip);
  bench.move_to(6, 8);  // no index on the way
  bench.sample(2);
  REQUIRE((bench.status() & 0x08) == 0);
  bench.set_index(12);
  bench.move_to(20, 8);
  bench.sample(2);
  REQUIRE(bench.ask(Opcode::kRdip) == 12);
  REQUIRE((bench.status() & 0x08) != 0);
}

TEST_CASE("lm628_ice40_up5k has the pins of the twin over 400 random transfers") {
  Bench bench;
  run_random(bench, {400, 63});
  CHECK(bench.samples() > 300);
}
