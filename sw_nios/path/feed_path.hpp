// SPDX-License-Identifier: Apache-2.0
//
// Points of a planned path, one a call: the place of the path at the mean of N values of the path
// length S, at this and the N - 1 points before (docs/precision.md, "Feed profile"). The geometry
// is not filtered, so a point lies on the path. S(n) is evaluated where it enters the sum and again
// where it leaves it: no memory, no drift. A call takes no quotient of 64 bits.
#pragma once

#include <cstdint>

#include "sw_nios/path/feed_real.hpp"
#include "sw_nios/path/feed_segment.hpp"
#include "sw_nios/path/feed_sine.hpp"

namespace trammel::sw {

class FeedPath {
 public:
  static constexpr std::uint32_t kRest = 2;  // points behind the last: the set point is as late

  struct Setup {
    const FeedSegment* segments = nullptr;  // planned; not owned
    std::uint32_t n_segments = 0;
    const FeedPhase* phases = nullptr;      // not owned
    std::uint32_t n_phases = 0;
    Point start;                            // Q8
    std::uint32_t begin = 0;                // points of rest before the first chain
    std::uint32_t ticks = 0;                // points of a lap, `begin` not among them
    std::uint32_t mean = 8;                 // N
  };

  constexpr FeedPath(const Setup& setup, std::uint32_t laps) : s_(setup), laps_(laps) {}

  constexpr std::uint32_t size() const { return s_.begin + laps_ * s_.ticks + kRest; }
  constexpr Point start() const { return s_.start; }

  constexpr Point next() {
    if (wait_ < s_.begin || s_.n_segments == 0) {
      ++wait_;
      return s_.start;
    }
    if (ended_) begin_chain();
    const std::uint64_t in = path_length(lead_, tick_);
    const std::uint64_t out = tick_ < s_.mean ? 0 : path_length(trail_, tick_ - s_.mean);
    sum_ += in - out;
    ++tick_;
    const FeedPhase& phase = s_.phases[lead_];
    if (!phase.rest() || sum_ != in * s_.mean) return place(quotient(sum_) << kFiner);
    while (!s_.segments[segment_].stop) ++segment_;
    const FeedSegment& last = s_.segments[segment_];
    ended_ = tick_ >= whole(phase.begin) + s_.mean + last.dwell;
    return last.end;
  }

  // Points from the beginning of a chain until S rests; later by at most 1/1024 of a point.
  static constexpr std::uint32_t whole(std::uint64_t time) {
    constexpr std::uint64_t kLate = std::uint64_t{1} << 22;
    const std::uint64_t t = time > kLate ? time - kLate : 0;
    return static_cast<std::uint32_t>((t + 0xFFFFFFFFu) >> 32);
  }

 private:
  static constexpr int kFiner = 16;  // S is Q16, the path Q32

  // Behind the last chain of the last lap the table rests.
  constexpr void begin_chain() {
    const bool again = segment_ + 1 == s_.n_segments;
    if (again && ++lap_ >= laps_) {
      lap_ = laps_;
      return;
    }
    lead_ = again ? 0 : lead_ + 1;
    segment_ = again ? 0 : segment_ + 1;
    trail_ = lead_;
    tick_ = 0;
    sum_ = 0;
    path_ = 0;
    ended_ = false;
  }

  // Path that is behind, `tick` points after the chain began, Q16; `phase` is the last one that had
  // begun the time before.
  constexpr std::uint64_t path_length(std::uint32_t& phase, std::uint32_t tick) const {
    const std::uint64_t t = std::uint64_t{tick} << 32;
    while (!s_.phases[phase].rest() && s_.phases[phase + 1].begin <= t) ++phase;
    const FeedPhase& p = s_.phases[phase];
    std::uint64_t s = p.path;
    if (!p.rest()) {
      const std::uint64_t d = t - p.begin;
      const std::uint64_t half = mul_right(magnitude(p.accel), d, 33);
      s += mul_right(p.accel < 0 ? p.speed - half : p.speed + half, d, kFeedBits);
    }
    return (s + (1u << (kFiner - 1))) >> kFiner;
  }

  // By N, in digits of 26 bits: three quotients of 32 bits.
  constexpr std::uint64_t quotient(std::uint64_t a) const {
    constexpr std::uint32_t kDigit = (1u << 26) - 1;
    std::uint64_t q = 0;
    std::uint32_t rest = 0;
    for (int shift = 52; shift >= 0; shift -= 26) {
      const std::uint32_t part = rest << 26 | (static_cast<std::uint32_t>(a >> shift) & kDigit);
      q = q << 26 | part / s_.mean;
      rest = part % s_.mean;
    }
    return q;
  }

  // Q8; `path` is Q32.
  constexpr Point place(std::uint64_t path) {
    while (path >= path_ + s_.segments[segment_].length && !s_.segments[segment_].stop) {
      path_ += s_.segments[segment_].length;
      ++segment_;
    }
    const FeedSegment& g = s_.segments[segment_];
    const std::uint64_t along = path - path_;
    Vec at = g.origin;
    if (g.radius == 0) {
      at = add(at, q13(along), g.dx, g.dy);
    } else if (g.radius > kFlatRadius) {
      at = add(add(at, q13(along - mul_right(along, shorter(g, along), 32)), g.dx, g.dy),
               q13(mul_right(along, aside(g, along), 32)), g.left ? -g.dy : g.dy,
               g.left ? g.dx : -g.dx);
    } else {
      const auto turn = static_cast<std::uint32_t>(mul_high(along, g.rate));
      const CosSin n = cos_sin(g.left ? g.angle + turn : g.angle - turn);
      const auto r = static_cast<std::int64_t>(g.radius >> 20);  // Q12
      at.x += (r * n.cos) >> 10;
      at.y += (r * n.sin) >> 10;
    }
    return {q8(at.x), q8(at.y)};
  }
  static constexpr std::int64_t q13(std::uint64_t q32) {
    return static_cast<std::int64_t>((q32 + (1u << 18)) >> 19);
  }
  static constexpr Vec add(Vec at, std::int64_t s, std::int32_t x, std::int32_t y) {
    return {at.x + ((s * x) >> 11), at.y + ((s * y) >> 11)};
  }
  // Of a flat arc after `along`, by the series of its angle, which is below 1/4: what it lacks in
  // its first direction, and how far it is beside that, as shares of the path, Q32.
  static constexpr std::uint64_t shorter(const FeedSegment& g, std::uint64_t along) {
    const std::uint64_t angle = mul_high(along, g.rate), square = angle * angle >> 32;
    return square * (feed_sine::part(6) - (square * feed_sine::part(120) >> 32)) >> 32;
  }
  static constexpr std::uint64_t aside(const FeedSegment& g, std::uint64_t along) {
    const std::uint64_t angle = mul_high(along, g.rate), square = angle * angle >> 32;
    const std::uint64_t fourth = square * feed_sine::part(720) >> 32;
    const std::uint64_t less = square * (feed_sine::part(24) - fourth) >> 32;
    return angle * (feed_sine::part(2) - less) >> 32;
  }
  static constexpr std::int32_t q8(Q32 a) {
    return static_cast<std::int32_t>((a + (1 << 23)) >> 24);
  }

  Setup s_;
  std::uint32_t laps_;
  std::uint32_t wait_ = 0;              // points of rest so far, before the first chain
  std::uint32_t lap_ = 0;
  std::uint32_t tick_ = 0;              // points since this chain began
  std::uint32_t lead_ = 0, trail_ = 0;  // phases of S(n) and of S(n - N)
  std::uint32_t segment_ = 0;           // in which the last point lies
  std::uint64_t path_ = 0;              // of the chain until that segment, Q32
  std::uint64_t sum_ = 0;               // of N path lengths, Q16
  bool ended_ = false;                  // the next point is the first of another chain
};

}  // namespace trammel::sw
