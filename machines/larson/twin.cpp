// SPDX-License-Identifier: Apache-2.0
//
// larson_xy of its bit-exact twin behind the Chip interface.
#include <cstddef>

#include "cosim/hosted_twin.hpp"
#include "machines/larson/board.hpp"
#include "models/exact/chips/larson_xy.hpp"

namespace trammel::larson {
namespace {

class TwinChip final : public cosim::HostedTwin<LarsonChip, Board, exact::LarsonXy> {
 public:
  explicit TwinChip(const ChipSetup& setup) : HostedTwin(exact::LarsonXy()) {
    state_.sample_clk = setup.sample_clk;
    reset();
    state_.lines = pins();
  }

  cosim::Lines drive() const override { return state_.lines; }
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

  void request(const cosim::BusOp& op) override {
    if (state_.request(op)) return;
    const cosim::BusOp placed = state_.placed();
    twin_.request(placed.addr, placed.data, placed.write, state_.bytes());
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

  bool bus_active() const override { return state_.platform_active || twin_.open(); }
  bool host_pin() const override { return twin_.irq(); }
  bool publishes() const override { return state_.samples(state_.now); }

  bool bus_edge(cosim::Clk edge) override {
    if (state_.platform_active) {
      state_.platform_edge(edge, host_pin());
      return true;
    }
    if (twin_.open()) return false;
    state_.answer(twin_.read_data());
    return true;
  }

  bool drive_changed() override { return state_.changed(pins()); }
};

}  // namespace

std::unique_ptr<LarsonChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(setup);
}

}  // namespace trammel::larson
