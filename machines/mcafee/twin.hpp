// SPDX-License-Identifier: Apache-2.0
//
// mcafee_xy of its bit-exact twin behind the Chip interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "cosim/bus_twin.hpp"
#include "parts/lm628/twin_words.hpp"
#include "machines/mcafee/board.hpp"
#include "machines/mcafee/chip.hpp"
#include "models/exact/chips/mcafee_xy.hpp"

namespace trammel::mcafee {

class TwinChip : public cosim::BusTwin<McafeeChip, Board, exact::McafeeXy> {
 public:
  explicit TwinChip(int clock_MHz = kClockMHz)
      : BusTwin(exact::McafeeXy(lm628::clock_of(clock_MHz))) {
    reset();
  }

  const exact::Lm628& part(int axis) const { return twin_.part(static_cast<std::size_t>(axis)); }

  lm628::Words words(int axis) const override { return lm628::words_of(part(axis)); }
  bool host_irq(int axis) const override { return part(axis).out().hi; }

  void sense(cosim::Lines lines) override {
    const auto bit = [lines](int n) { return (lines >> n & 1) != 0; };
    in_.limits = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      in_.a[k] = bit(encoder_a(axis));
      in_.b[k] = bit(encoder_b(axis));
      in_.index_n[k] = !bit(marker(axis));
      in_.limits = static_cast<std::uint8_t>(in_.limits |
                                             (bit(limit_low(axis)) ? 1u : 0u) << 2 * axis |
                                             (bit(limit_high(axis)) ? 2u : 0u) << 2 * axis);
    }
  }

 private:
  void put(const cosim::BusOp& op) override { twin_.request(op.addr, op.data, op.write); }
  bool publishes() const override { return part(0).commits(); }

  bool drive_changed() override { return state_.convert(twin_.dac(0), twin_.dac(1)); }
};

std::unique_ptr<McafeeChip> make_twin_chip(int clock_MHz = kClockMHz);

}  // namespace trammel::mcafee
