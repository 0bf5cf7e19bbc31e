// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact, clock-exact twin of rtl/control/precision_knots.sv.
#pragma once

namespace trammel::exact {

// Which ticks are knots: the first 2 kHz tick after the first COMMIT, then every 32nd tick. One
// without a COMMIT since the last goes on at constant speed, twice in a row, then stops.
class PrecisionKnots {
 public:
  enum class Knot { kNone, kCommit, kCoast, kHold };  // with a COMMIT; without: goes on, stops

  static constexpr int kTicks = 32;

  struct In {
    bool tick = false;      // one that the law takes
    bool tick_pos = false;  // it is one of 2 kHz
    bool commit = false;
    bool off = false;       // the controller is in reset
  };

  // One clock edge.
  void clock(const In& in) {
    if (in.off) {
      *this = PrecisionKnots();
      return;
    }
    if (in.tick) tick(in.tick_pos);
    if (in.commit) pending_ = true;
  }

  Knot knot() const { return knot_; }  // of the last tick
  bool underrun() const {
    return knot_ == Knot::kCoast || knot_ == Knot::kHold;
  }

 private:
  void tick(bool tick_pos) {
    knot_ = Knot::kNone;
    if (active_ ? ++tick_ % kTicks != 0 : !(pending_ && tick_pos)) return;
    active_ = true;
    tick_ = 0;
    knot_ = pending_      ? Knot::kCommit
            : missed_ < 2 ? Knot::kCoast
                          : Knot::kHold;
    missed_ = pending_ ? 0 : missed_ < 2 ? missed_ + 1 : 2;
    pending_ = false;
  }

  bool active_ = false, pending_ = false;
  int tick_ = 0, missed_ = 0;
  Knot knot_ = Knot::kNone;
};

}  // namespace trammel::exact
