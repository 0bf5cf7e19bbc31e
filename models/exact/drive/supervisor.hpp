// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/drive/supervisor.sv. It has no timer.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::exact {

class Supervisor {
 public:
  enum class Fault : std::uint8_t {
    kNone = 0,
    kExternal = 1,
    kOverCurrent = 2,
    kWatchdog = 3,
    kEncoder = 4,
    kStroke = 5
  };

  struct In {
    std::uint32_t tick_count = 0;
    std::array<bool, 2> enabled{};
    bool clear = false;
    bool trip_pin = false;
    std::array<bool, 2> over_current{};
    bool watchdog = false;
    std::array<bool, 2> encoder{};
    std::array<bool, 2> stroke{};
  };

  struct Out {
    bool trip = false;
    Fault code = Fault::kNone;
    bool axis = false;
    std::uint32_t tick = 0;
  };

  void reset() { *this = Supervisor(); }

  Out step(const In& in) {
    if (sets(in)) {
      const Cause c = cause(in);
      out_ = {true, c.code, c.axis, in.tick_count};
    } else if (clears(in)) {
      out_ = Out();
    }
    pin_ = meta_;
    meta_ = in.trip_pin;
    return out_;
  }

  const Out& out() const { return out_; }

  bool quiescent(const In& in) const {
    return in.trip_pin == meta_ && meta_ == pin_ && !sets(in) && !clears(in);
  }

 private:
  struct Cause {
    Fault code;
    bool axis;
  };

  static bool any(const std::array<bool, 2>& of) { return of[0] || of[1]; }

  // The lowest code wins, then axis X.
  Cause cause(const In& in) const {
    if (pin_) return {Fault::kExternal, false};
    if (any(in.over_current)) return {Fault::kOverCurrent, !in.over_current[0]};
    if (in.watchdog) return {Fault::kWatchdog, false};
    if (any(in.encoder)) return {Fault::kEncoder, !in.encoder[0]};
    if (any(in.stroke)) return {Fault::kStroke, !in.stroke[0]};
    return {Fault::kNone, false};
  }

  bool sets(const In& in) const { return !out_.trip && cause(in).code != Fault::kNone; }

  bool clears(const In& in) const {
    return out_.trip && in.clear && !any(in.enabled) && cause(in).code == Fault::kNone;
  }

  bool meta_ = false;
  bool pin_ = false;
  Out out_;
};

}  // namespace trammel::exact
