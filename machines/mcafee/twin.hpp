// SPDX-License-Identifier: Apache-2.0
//
// mcafee_xy of its bit-exact twin behind the Chip interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "cosim/bus_twin.hpp"
#include "parts/lm628/twin_words.hpp"
#include "machines/mcafee/chip.hpp"
#include "models/exact/chips/mcafee_xy.hpp"

namespace trammel::mcafee {

class TwinChip : public cosim::BusTwin<McafeeChip, cosim::ProcessorBus, Pins, exact::McafeeXy> {
 public:
  explicit TwinChip(int clock_MHz = kClockMHz)
      : BusTwin(exact::McafeeXy(lm628::clock_of(clock_MHz))) {}

  const exact::Lm628& part(int axis) const { return twin_.part(static_cast<std::size_t>(axis)); }

  lm628::Words words(int axis) const override { return lm628::words_of(part(axis)); }
  bool host_irq(int axis) const override { return part(axis).out().hi; }

 private:
  bool publishes() const override { return part(0).commits(); }
};

std::unique_ptr<McafeeChip> make_twin_chip(int clock_MHz = kClockMHz);

}  // namespace trammel::mcafee
