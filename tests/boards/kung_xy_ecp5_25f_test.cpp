// SPDX-License-Identifier: Apache-2.0
//
// kung_xy on an ECP5-25F: each input pin reaches its function and each output pin comes from its
// own signal. The twin stands beside the board; gates and interrupt are compared at every clock,
// and every read.

#include <Vkung_xy_ecp5_25f.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "models/exact/chips/kung_xy.hpp"
#include "tests/chips/kung_pair.hpp"
#include "tests/support/axi_lite.hpp"
#include "tests/support/kung_transfers.hpp"
#include "tests/support/rtl.hpp"

using namespace trammel;
namespace reg = kung_xy_regs;

namespace {

constexpr int kPeriod = 3125;  // [clk] of 16 kHz

// The board has no reset but that of its pin, active low.
struct Model : Vkung_xy_ecp5_25f {
  using Vkung_xy_ecp5_25f::Vkung_xy_ecp5_25f;
  std::uint8_t rst_i = 0;
};

class Board final : public test::KungPair<Model> {
 public:
  Board() {
    (*this)->rst_ni = 0;
    for (int i = 0; i < 4; ++i) rtl().tick();
    (*this)->rst_ni = 1;
    for (int i = 0; i < 2; ++i) rtl().tick();  // the synchroniser
    begin();
    clocks(200);  // encoder lines adopted, rule tables filled
  }
};

// Reads every register; the twin's is compared.
void read_all(Board& board) {
  for (const reg::Register& one : reg::kRegisters) board.read(one.address);
}

}  // namespace

TEST_CASE("kung_xy_ecp5_25f: encoders and index pulses of X and Y have each their own pin") {
  Board board;
  for (int n = 0; n < 7; ++n) board.count(0, 1);
  for (int n = 0; n < 3; ++n) board.count(1, -1);
  for (const int axis : {0, 1}) {
    board.lines ^= std::uint64_t{4} << 3 * axis;
    board.clocks(20);
    board.lines ^= std::uint64_t{4} << 3 * axis;
    board.clocks(20);
    board.count(axis, 1);
    INFO("index of axis " << axis);
    CHECK(board.read(reg::kX + reg::kIndexLatch) == 7);
    CHECK(board.read(reg::kY + reg::kIndexLatch) == (axis == 0 ? 0u : ~0u - 2));
  }
  board.clocks(25000);
  CHECK(board.read(reg::kX + reg::kPos) == 8);
  CHECK(board.read(reg::kY + reg::kPos) == ~0u - 1);
  CHECK(board.read(reg::kFault) == 0);
}

TEST_CASE("kung_xy_ecp5_25f: the trip pin trips and interrupts") {
  Board board;
  board.write(reg::kIrqStat, ~0u);
  board.write(reg::kIrqEn, reg::kIrqEnFault);
  CHECK(board->irq_o == 0);
  board.lines |= std::uint64_t{1} << xy::kTripPin;
  board.clocks(10);
  CHECK((board.read(reg::kFault) & reg::kFaultCodeMask) == reg::kFaultCodeExternalTrip);
  CHECK(board->irq_o == 1);
}

TEST_CASE("kung_xy_ecp5_25f: each of the four converters has its own pin") {
  // i_d = i_a, i_q = (i_a + 2 i_b) / sqrt 3 at angle 0.
  struct Case {
    std::size_t axis, phase;
    std::uint32_t i_d, i_q;
  };
  for (const Case& one : {Case{0, 0, 300, 173}, Case{0, 1, 0, 346}, Case{1, 0, 300, 173},
                          Case{1, 1, 0, 346}}) {
    Board board;
    board.clocks(1000);
    board.codes[one.axis][one.phase] += 300;
    board.write((one.axis == 0 ? reg::kX : reg::kY) + reg::kCtrl, reg::kCtrlEnable);
    board.clocks(kPeriod);
    CAPTURE(one.axis, one.phase);
    const std::uint32_t own = board.read((one.axis == 0 ? reg::kX : reg::kY) + reg::kIdIq);
    CHECK(std::abs(static_cast<int>(own & 0xFFFF) - static_cast<int>(one.i_d)) <= 1);
    CHECK(std::abs(static_cast<int>(own >> 16) - static_cast<int>(one.i_q)) <= 1);
    CHECK(board.read((one.axis == 0 ? reg::kY : reg::kX) + reg::kIdIq) == 0);
  }
}

TEST_CASE("kung_xy_ecp5_25f: the six legs switch as those of the twin, each with its own times") {
  Board board;
  board.write(reg::kX + reg::kIqManual, 80);
  board.write(reg::kY + reg::kIqManual, 0x1000 - 50);
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    board.write(base + reg::kThetaOfs, base == reg::kX ? 0x07000000 : 0x25000000);
    board.write(base + reg::kCtrl, reg::kCtrlEnable | reg::kCtrlCurrentLoop);
  }
  std::array<std::array<int, 2>, 6> on{};  // [clk] of high and low
  board.clocks(3 * kPeriod);
  for (int n = 0; n < kPeriod; ++n) {
    board.clocks(1);
    for (std::size_t leg = 0; leg < 6; ++leg) {
      on[leg][0] += board->gate_hi_o >> leg & 1;
      on[leg][1] += board->gate_lo_o >> leg & 1;
    }
  }
  // Were two the same, their pins could be swapped.
  for (std::size_t leg = 0; leg < 6; ++leg) {
    for (std::size_t other = 0; other < leg; ++other) {
      CAPTURE(leg, other);
      CHECK(on[leg] != on[other]);
    }
    CHECK(on[leg][0] > 0);
    CHECK(on[leg][1] > 0);
  }
}

TEST_CASE("kung_xy_ecp5_25f: every line of the bus is its own") {
  Board board;
  const auto clock = [&] { board.rtl().tick(); };
  test::AxiLiteTraffic<test::Rtl<Model>, decltype(clock)> traffic(board.rtl(), clock, 111);
  const auto registers = test::kept_registers(reg::kRegisters, {reg::kRates});
  CHECK(wrong_register(traffic, registers, 60, 112) == "");
}

TEST_CASE("kung_xy_ecp5_25f: the reset pin turns the gates off and resets the registers") {
  Board board;
  board.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  board.write(reg::kWatchdog, 77);
  board.clocks(2 * kPeriod);
  REQUIRE(board.gates_on() > kPeriod / 2);
  board->rst_ni = 0;
  for (int n = 0; n < 3; ++n) board.rtl().tick();
  CHECK(board->gate_hi_o + board->gate_lo_o == 0);
  board->rst_ni = 1;
  for (int n = 0; n < 3; ++n) board.rtl().tick();
  const auto clock = [&] { board.rtl().tick(); };
  test::AxiLiteTraffic<test::Rtl<Model>, decltype(clock)> traffic(board.rtl(), clock, 113);
  CHECK(traffic.read({reg::kX + reg::kCtrl, reg::kWatchdog, reg::kId}) ==
        std::vector<std::uint32_t>{0, 0, reg::kIdValue});
}

TEST_CASE("kung_xy_ecp5_25f has the gates, interrupts and registers of the twin at random") {
  Board board;
  test::Random random(114);
  for (int n = 0; n < 400; ++n) {
    cosim::BusOp op = test::random_transfer(random);
    CAPTURE(n);
    if (op.write) {
      board.transfer(op);
    } else {
      board.read(op.addr);
    }
    if (n % 100 == 99) {
      for (const cosim::BusOp& one : test::recovery(random)) board.transfer(one);
      read_all(board);
    }
    if (random() % 4 == 0) board.count(random() % 2, random() % 2 == 0 ? 1 : -1);
    if (random() % 16 == 0) board.lines ^= std::uint64_t{4} << 3 * (random() % 2);
    if (n % 40 == 0) {
      board.clocks((kPeriod + 1000 - board.now() % kPeriod) % kPeriod);
      for (auto& axis : board.codes) {
        for (auto& code : axis) code = 2048 + static_cast<std::int32_t>(random() % 801) - 400;
      }
    }
    board.clocks(random() % 200);
  }
  CHECK(board.gates_on() > 10000);
}
