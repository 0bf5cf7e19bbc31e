// SPDX-License-Identifier: Apache-2.0
//
// larson_xy of its bit-exact twin behind the Chip interface.
#include <cstddef>

#include "cosim/bus_twin.hpp"
#include "machines/larson/board.hpp"
#include "models/exact/chips/larson_xy.hpp"

namespace trammel::larson {
namespace {

class TwinChip final : public cosim::BusTwin<LarsonChip, Board, exact::LarsonXy> {
 public:
  explicit TwinChip(const ChipSetup& setup) : BusTwin(exact::LarsonXy()) {
    state_ = Board(setup);
    reset();
    state_.lines = pins();
  }

  std::uint32_t words(int axis) const override {
    return twin_.table().words(static_cast<std::size_t>(axis));
  }
  std::uint32_t err_byte() const override { return twin_.table().err_byte(); }
  unsigned requests() const override {
    return (twin_.table().axis(0).irq ? 1u : 0u) | (twin_.table().axis(1).irq ? 2u : 0u);
  }

  void sense(cosim::Lines lines) override {
    for (int axis = 0; axis < kAxes; ++axis) {
      in_.pins[static_cast<std::size_t>(axis)] = {level(lines, limit_low(axis)),
                                                  level(lines, limit_high(axis)),
                                                  level(lines, buf_busy(axis))};
    }
  }

 private:
  cosim::Lines pins() const {
    cosim::Lines lines = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
      const exact::StepChannel::Out out = twin_.table().axis(static_cast<std::size_t>(axis));
      lines |= cosim::Lines{out.step} << step(axis) | cosim::Lines{out.forward} << forward(axis) |
               cosim::Lines{out.flush} << flush(axis);
    }
    return lines;
  }

  void put(const cosim::BusOp& op) override {
    twin_.request(op.addr, op.data, op.write, state_.bytes());
  }

  bool drive_changed() override { return state_.changed(pins()); }
};

}  // namespace

std::unique_ptr<LarsonChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(setup);
}

}  // namespace trammel::larson
