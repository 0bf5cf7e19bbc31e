// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact, clock-exact twin of rtl/control/command.sv.
#pragma once

#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Command {
 public:
  struct In {
    bool tick_pos = false;
    bool commit = false;
    bool interpolate = false;
    bool preset = false;
    std::int32_t pos_cmd = 0;       // [counts]
    std::int32_t preset_value = 0;  // [counts]
  };

  // One clock edge.
  void clock(const In& in) {
    if (in.tick_pos) {
      if (pending_) {
        take(in.interpolate);
      } else if (left_ > 0) {
        quarters_ += stride_;
        --left_;
      }
    }
    if (in.commit) {
      pending_ = true;
      next_ = in.pos_cmd;
    }
    if (in.preset) {
      pending_ = false;
      left_ = 0;
      quarters_ = 4 * std::int64_t{in.preset_value};
    }
  }

  std::int32_t r() const { return static_cast<std::int32_t>(fixed::rs(quarters_, 2)); }

  // Would the next clock edge with these inputs change nothing?
  bool quiescent(const In& in) const {
    return !in.commit && !in.preset && !(in.tick_pos && (pending_ || left_ > 0));
  }

 private:
  void take(bool interpolate) {
    const std::int64_t from = r();
    pending_ = false;
    stride_ = interpolate ? next_ - from : 0;
    quarters_ = interpolate ? 4 * from + stride_ : 4 * std::int64_t{next_};
    left_ = interpolate ? 3 : 0;
  }

  bool pending_ = false;
  std::int32_t next_ = 0;      // committed, waiting for the tick [counts]
  std::int64_t quarters_ = 0;  // present command [1/4 count]
  std::int64_t stride_ = 0;    // [1/4 count per tick]
  int left_ = 0;               // ticks still to move
};

}  // namespace trammel::exact
