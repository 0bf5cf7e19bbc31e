// SPDX-License-Identifier: Apache-2.0
//
// larson_xy of its bit-exact twin behind the Chip interface.
#include <cstddef>

#include "cosim/bus_twin.hpp"
#include "machines/larson/surroundings.hpp"
#include "models/exact/chips/larson_xy.hpp"

namespace trammel::larson {
namespace {

class TwinChip final : public cosim::BusTwin<LarsonChip, Surroundings, Pins, exact::LarsonXy> {
 public:
  using BusTwin::BusTwin;

  std::uint32_t words(int axis) const override {
    return twin_.table().words(static_cast<std::size_t>(axis));
  }
  std::uint32_t err_byte() const override { return twin_.table().err_byte(); }
  unsigned requests() const override {
    return (twin_.table().axis(0).irq ? 1u : 0u) | (twin_.table().axis(1).irq ? 2u : 0u);
  }

 private:
  void put(const cosim::BusOp& op) override {
    twin_.request(op.addr, op.data, op.write, state_.bytes());
  }
};

}  // namespace

std::unique_ptr<LarsonChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(exact::LarsonXy(), Surroundings(setup));
}

}  // namespace trammel::larson
