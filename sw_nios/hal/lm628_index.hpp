// SPDX-License-Identifier: Apache-2.0
//
// Lost encoder counts, which a position loop follows without an error, show in the index: it comes
// once a turn, so that its positions are whole turns apart. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/hal/lm628.hpp"

namespace trammel::sw {

class Lm628Index {
 public:
  explicit Lm628Index(std::uint32_t counts) : counts_(counts) {}  // of a turn; 0: no check

  bool checks() const { return counts_ != 0; }

  // SIP: the part interrupts at the next index.
  void arm(Lm628Port& port) const {
    if (checks()) port.command(Lm628Command::kSip);
  }

  // At its interrupt. Returns whether counts were lost since the one before.
  bool lost_at_index(Lm628Port& port) {
    const std::int32_t at = port.ask_long(Lm628Command::kRdip);
    arm(port);
    const std::uint32_t way = distance(at, last_);
    const bool neighbour = way <= kTolerance || (way + kTolerance >= counts_ &&
                                                 way <= counts_ + kTolerance);
    const bool right = seen_ ? neighbour : way <= counts_ + kTolerance;
    last_ = at;
    seen_ = true;
    return !right;
  }

  // Where the shaft is at the end of a move. Returns whether an index is missing on its way there.
  bool lost_before(std::int32_t real) const {
    return checks() && distance(real, last_) > counts_ + kTolerance;
  }

 private:
  static constexpr std::uint32_t kTolerance = 2;  // [count] of noise at the index

  static std::uint32_t distance(std::int32_t a, std::int32_t b) {
    const auto d = static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b);
    return d > 0x80000000u ? 0u - d : d;
  }

  std::uint32_t counts_;
  std::int32_t last_ = 0;  // position of the last index; before the first one the start
  bool seen_ = false;
};

}  // namespace trammel::sw
