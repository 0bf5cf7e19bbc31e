// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/sense/qep.sv. It has no timer: step() is one clock edge, and while quiescent() holds
// an edge changes nothing. next() is the number of edges that only count equal samples.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/exact/math/timer.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Qep {
 public:
  struct In {
    bool a = false;
    bool b = false;
    bool z = false;
    std::uint8_t filter = 3;  // [clk] 1..15, 0 acts as 1
    bool preset = false;
    std::int32_t preset_value = 0;
    bool clear_error = false;
  };

  struct Out {
    std::int32_t count = 0;  // 24 bits
    bool dir = false;        // the last step was up
    std::int32_t index_latch = 0;
    bool index_seen = false;
    bool error = false;
  };

  // The synchroniser has no reset.
  void reset() {
    out_ = Out();
    start_ = 0;
    for (Line& line : lines_) line.same = 0;
  }

  Out step(const In& in) {
    const bool live = start_ == 3;
    const std::array<bool, 3> pins{in.a, in.b, in.z};
    if (live) decode(in);
    if (!live && in.preset) out_.count = in.preset_value;
    if (!live && in.clear_error) out_.index_seen = out_.error = false;
    const int filter = in.filter == 0 ? 1 : in.filter;
    for (std::size_t i = 0; i < lines_.size(); ++i) lines_[i].step(pins[i], live, filter);
    if (!live) ++start_;
    return out_;
  }

  const Out& out() const { return out_; }

  bool quiescent(const In& in) const {
    return start_ == 3 && lines_[0].quiescent(in.a) && lines_[1].quiescent(in.b) &&
           lines_[2].quiescent(in.z) && !in.preset &&
           !(in.clear_error && (out_.index_seen || out_.error));
  }

  Gap next(const In& in) const {
    if (start_ != 3 || in.preset || (in.clear_error && (out_.index_seen || out_.error))) return 0;
    const int filter = in.filter == 0 ? 1 : in.filter;
    return std::min({lines_[0].next(in.a, filter), lines_[1].next(in.b, filter),
                     lines_[2].next(in.z, filter)});
  }

  // n <= next(): the same inputs at all these edges.
  void advance(Gap n) {
    for (Line& line : lines_) {
      if (line.sync != line.line) line.same += static_cast<int>(n);
    }
  }

 private:
  struct Line {
    bool meta = false;
    bool sync = false;
    bool line = false;  // after the filter
    bool prev = false;
    int same = 0;       // samples so far that differ from `line`

    bool changed() const { return line != prev; }

    bool quiescent(bool pin) const {
      return pin == meta && meta == sync && sync == line && line == prev && same == 0;
    }

    Gap next(bool pin, int filter) const {
      if (pin != meta || meta != sync || line != prev) return 0;
      if (sync == line) return same == 0 ? kGapMax : 0;
      return same + 1 < filter ? static_cast<Gap>(filter - 1 - same) : 0;
    }

    void step(bool pin, bool live, int filter) {
      prev = live ? line : sync;
      if (!live || sync == line) {
        line = sync;
        same = 0;
      } else if (++same >= filter) {
        line = sync;
        same = 0;
      }
      sync = meta;
      meta = pin;
    }
  };

  void decode(const In& in) {
    const Line& a = lines_[0];
    const Line& b = lines_[1];
    const Line& z = lines_[2];
    if (in.clear_error) out_.index_seen = out_.error = false;
    if (a.changed() && b.changed()) out_.error = true;
    if (a.changed() != b.changed()) {
      out_.dir = a.line != b.prev;
      out_.count = static_cast<std::int32_t>(
          fixed::wrap(std::int64_t{out_.count} + (out_.dir ? 1 : -1), 24));
    }
    if (in.preset) out_.count = in.preset_value;
    if (z.line && z.changed()) {
      out_.index_latch = out_.count;
      out_.index_seen = true;
    }
  }

  std::array<Line, 3> lines_{};  // A, B, Z
  int start_ = 0;                // clocks since reset, up to 3
  Out out_;
};

}  // namespace trammel::exact
