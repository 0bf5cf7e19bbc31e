// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/bus/frame_fifo.sv, and the frames of Serial2002.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace trammel::exact {

struct Frame {
  enum Kind : std::uint32_t { kClearBit, kSetBit, kPollBit, kPollChannel, kValue };
  std::uint32_t kind = 0;     // 3 bits
  std::uint32_t channel = 0;  // 5 bits
  std::uint32_t value = 0;
};
inline bool operator==(const Frame& a, const Frame& b) {
  return a.kind == b.kind && a.channel == b.channel && a.value == b.value;
}

class FrameFifo {
 public:
  struct In {
    bool push = false;
    Frame frame;
    bool pop = false;
  };

  explicit FrameFifo(std::size_t depth = 8) : depth_(depth) {}

  void reset() { *this = FrameFifo(depth_); }

  bool waits() const { return !frames_.empty(); }
  Frame frame() const { return waits() ? frames_.front() : Frame{}; }
  std::uint32_t room() const { return static_cast<std::uint32_t>(depth_ - frames_.size()); }
  std::uint32_t lost() const { return lost_; }

  void step(const In& in) {
    const bool full = frames_.size() == depth_;
    if (in.pop && waits()) frames_.pop_front();
    if (!in.push) return;
    if (!full) {
      frames_.push_back(in.frame);
    } else {
      lost_ = std::min<std::uint32_t>(lost_ + 1, 0xFFFF);
    }
  }

  bool quiescent(const In& in) const { return !in.push && !in.pop; }

 private:
  std::size_t depth_;
  std::deque<Frame> frames_;
  std::uint32_t lost_ = 0;
};

}  // namespace trammel::exact
