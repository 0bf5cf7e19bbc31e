// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/motion/step_table.sv.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/motion/step_channel.hpp"

namespace trammel::exact {

class StepTable {
 public:
  static constexpr std::uint32_t kVectorX = 0340;
  static constexpr std::uint32_t kVectorY = 0344;

  struct In {
    std::array<StepChannel::Pins, 2> pins;
    bool write = false, y = false, grant = false;
    unsigned bytes = 0;      // of the count the lower two, of the status word the upper two
    std::uint32_t data = 0;
  };

  explicit StepTable(std::uint32_t inc = 3, std::uint32_t mod = 625, bool buffered = true)
      : clock_(inc, mod), channels_{StepChannel(buffered), StepChannel(buffered)} {}

  void reset() {
    clock_.reset();
    for (StepChannel& channel : channels_) channel.reset();
    err_byte_ = 0;
  }

  StepChannel::Out axis(std::size_t k) const { return channels_[k].out(); }
  std::uint32_t words(std::size_t k) const {
    return std::uint32_t{axis(k).status} << 16 | axis(k).count;
  }
  std::uint32_t err_byte() const { return err_byte_; }
  bool irq() const { return vector() != 0; }
  std::uint32_t vector() const {
    return axis(0).irq ? kVectorX : axis(1).irq ? kVectorY : 0;
  }

  void step(const In& in) {
    const StepClock::Out now = clock_.out();
    const std::array<StepChannel::In, 2> inputs{channel_in(in, 0), channel_in(in, 1)};
    for (std::size_t k = 0; k < 2; ++k) channels_[k].step(inputs[k], now);
    clock_.step();
    const bool broken = (in.bytes & 3) % 3 != 0 || (in.bytes >> 2) % 3 != 0;
    if (in.write && broken) err_byte_ = std::min(err_byte_ + 1, 0xFFFFu);
  }

  bool quiescent(const In& in) const {
    return !in.write && channels_[0].quiescent(channel_in(in, 0)) &&
           channels_[1].quiescent(channel_in(in, 1));
  }

  // Of next_o: to be used where quiescent() holds.
  Gap next() const { return std::min(channels_[0].next(clock_), channels_[1].next(clock_)); }

  void advance(Gap n) {
    const Gap ticks = clock_.ticks(n);
    for (StepChannel& channel : channels_) channel.advance(ticks);
    clock_.advance(n);
  }

 private:
  StepChannel::In channel_in(const In& in, std::size_t k) const {
    StepChannel::In channel;
    channel.pins = in.pins[k];
    channel.grant = in.grant && vector() == (k == 0 ? kVectorX : kVectorY);
    if (!in.write || in.y != (k == 1)) return channel;
    if ((in.bytes & 3) == 3) channel.count = static_cast<std::uint16_t>(in.data);
    if (in.bytes >> 2 == 3) channel.status = static_cast<std::uint16_t>(in.data >> 16);
    return channel;
  }

  StepClock clock_;
  std::array<StepChannel, 2> channels_;
  std::uint32_t err_byte_ = 0;
};

}  // namespace trammel::exact
