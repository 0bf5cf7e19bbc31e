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
#include <string>

#include "cosim/verilated/axi_lite.hpp"
#include "models/exact/chips/kung_xy.hpp"
#include "tests/support/axi_lite.hpp"
#include "tests/support/kung_transfers.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using namespace trammel;
namespace reg = kung_xy_regs;
using test::same;

namespace {

constexpr int kPeriod = 3125;  // [clk] of 16 kHz

// The board has no reset but that of its pin, active low.
struct Model : Vkung_xy_ecp5_25f {
  using Vkung_xy_ecp5_25f::Vkung_xy_ecp5_25f;
  std::uint8_t rst_i = 0;
};

class Board final : public exact::KungXy::Converters {
 public:
  // Codes of phases a and b, X and Y; to be changed while no conversion runs.
  std::array<std::array<std::int32_t, 2>, 2> codes{{{2048, 2048}, {2048, 2048}}};
  // A, B, index of X, then of Y; above them the trip pin.
  std::uint64_t lines = 0;

  Board() {
    bus_.reset(model());
    apply();
    rtl_->rst_ni = 0;
    for (int i = 0; i < 4; ++i) rtl_.tick();
    rtl_->rst_ni = 1;
    for (int i = 0; i < 2; ++i) rtl_.tick();  // the synchroniser
    clocks(200);  // encoder lines adopted, rule tables filled
  }

  test::Rtl<Model>& rtl() { return rtl_; }
  std::int64_t now() const { return twin_.now(); }
  std::int64_t gates_on() const { return gates_on_; }  // clocks with any gate on

  std::array<std::int32_t, 2> hold(int axis, exact::Clk) const override {
    return codes[static_cast<std::size_t>(axis)];
  }

  void clocks(std::int64_t n) {
    for (; n > 0; --n) edge();
  }

  std::uint32_t read(std::uint32_t address) {
    transfer({address, 0, false});
    const std::string name = test::register_name(reg::kRegisters, address);
    if (bus_.rdata() != twin_.read_data()) {
      same(name.c_str(), bus_.rdata(), twin_.read_data(), now());
    }
    return bus_.rdata();
  }
  void write(std::uint32_t address, std::uint32_t data) { transfer({address, data, true}); }

  void transfer(const cosim::BusOp& op) {
    bus_.request(model(), op);
    twin_.request({op.addr, op.data, op.write});
    while (bus_.active()) edge();
  }

  // Quadrature lines of an axis: one count up or down, with time for the filter.
  void count(int axis, int way) {
    auto& phase = phases_[static_cast<std::size_t>(axis)];
    phase = (phase + way) & 3;
    const std::uint64_t ab = (phase == 1 || phase == 2) | (phase >= 2) << 1;
    lines = (lines & ~(std::uint64_t{3} << 3 * axis)) | ab << 3 * axis;
    clocks(12);
  }

 private:
  Model& model() { return *rtl_.operator->(); }

  void apply() {
    const auto pair = [this](int line) {
      return static_cast<std::uint8_t>((lines >> line & 1) | (lines >> (line + 3) & 1) << 1);
    };
    rtl_->enc_a_i = pair(0);
    rtl_->enc_b_i = pair(1);
    rtl_->enc_z_i = pair(2);
    rtl_->trip_i = lines >> exact::KungXy::kTripPin & 1;
    rtl_->adc_sdata_a_i = rtl_->adc_sdata_b_i = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Frame& frame = frames_[axis];
      rtl_->adc_sdata_a_i |= static_cast<std::uint8_t>((frame.codes[0] >> frame.bit & 1) << axis);
      rtl_->adc_sdata_b_i |= static_cast<std::uint8_t>((frame.codes[1] >> frame.bit & 1) << axis);
    }
    rtl_.eval();
  }

  void edge() {
    apply();
    twin_.pins(lines);
    const bool transfer = bus_.active();
    if (transfer) bus_.before_edge(model());
    const unsigned cs = rtl_->adc_cs_n_o, sclk = rtl_->adc_sclk_o;
    rtl_.tick();
    if (transfer) bus_.after_edge(model());
    rtl_.eval();
    twin_.run(twin_.now() + 1, *this);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Frame& frame = frames_[axis];
      const auto fell = [axis](unsigned before, unsigned after) {
        return (before >> axis & 1) != 0 && (after >> axis & 1) == 0;
      };
      if (fell(cs, rtl_->adc_cs_n_o)) frame = {codes[axis], 15};
      if (fell(sclk, rtl_->adc_sclk_o) && frame.bit > 0) --frame.bit;
    }
    const std::uint64_t gates = twin_.gates();
    same("gate_hi_o", rtl_->gate_hi_o, (gates & 7) | (gates >> 6 & 7) << 3, now());
    same("gate_lo_o", rtl_->gate_lo_o, (gates >> 3 & 7) | (gates >> 9 & 7) << 3, now());
    same("irq_o", rtl_->irq_o, twin_.irq(), now());
    gates_on_ += gates != 0;
  }

  struct Frame {
    std::array<std::int32_t, 2> codes{};
    int bit = 15;
  };

  test::Rtl<Model> rtl_;
  cosim::AxiLiteMaster bus_;
  exact::KungXy twin_;
  std::array<Frame, 2> frames_{};
  std::array<int, 2> phases_{};
  std::int64_t gates_on_ = 0;
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
  CHECK(board.rtl()->irq_o == 0);
  board.lines |= std::uint64_t{1} << exact::KungXy::kTripPin;
  board.clocks(10);
  CHECK((board.read(reg::kFault) & reg::kFaultCodeMask) == reg::kFaultCodeExternalTrip);
  CHECK(board.rtl()->irq_o == 1);
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
      on[leg][0] += board.rtl()->gate_hi_o >> leg & 1;
      on[leg][1] += board.rtl()->gate_lo_o >> leg & 1;
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
  CHECK(wrong_register(traffic, test::kept_registers(reg::kRegisters), 60, 112) == "");
}

TEST_CASE("kung_xy_ecp5_25f: the reset pin turns the gates off and resets the registers") {
  Board board;
  board.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  board.write(reg::kWatchdog, 77);
  board.clocks(2 * kPeriod);
  REQUIRE(board.gates_on() > kPeriod / 2);
  board.rtl()->rst_ni = 0;
  for (int n = 0; n < 3; ++n) board.rtl().tick();
  CHECK(board.rtl()->gate_hi_o + board.rtl()->gate_lo_o == 0);
  board.rtl()->rst_ni = 1;
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
