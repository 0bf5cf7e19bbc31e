// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact, edge-exact twin of rtl/chips/kung_precision.sv: the law of both axes with its words,
// the times of the encoders' edges, and the requests of the bus. clock(n) is an edge at which
// anything may happen; due() is the next one that needs it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/chips/kung_time.hpp"
#include "models/exact/control/precision.hpp"
#include "models/exact/sense/edge_time.hpp"

namespace trammel::exact {

class KungPrecision {
 public:
  struct Axis {
    bool enable = false;      // CTRL.precision
    bool reset = false;       // CTRL.reset_model
    int filter = 3;           // of the decoder [clk]
    std::int32_t count = 0;   // of this tick
  };
  struct In {
    bool tick = false;        // of the carrier,
    bool position = false;    // and of the position
    bool commit = false;
    std::array<Axis, 2> axis;
  };
  struct Request {
    int axis = 0, word = 0;
    bool write = false;
    std::int32_t data = 0;
    bool counts = false;  // it is one of PREC_DATA
  };
  // What an edge did.
  struct Out {
    bool overrun = false;   // a tick was lost
    bool underrun = false;  // a knot came without a COMMIT
    bool done = false;      // i_q* of a position tick are there
    bool flags = false;     // STATUS takes saturated and clipped
    bool access = false;    // the request was done: answer()
  };

  // A reset: block memory keeps its words.
  void reset() {
    KungPrecision fresh;
    fresh.law_ = law_;
    fresh.window_ = window_;
    *this = fresh;
  }

  // The count of an axis whose controller is enabled changes at edge n.
  void moved(int axis, Clk phase, bool up) {
    EdgeTime::In in;
    in.edge = true;
    in.up = up;
    in.phase = static_cast<std::int32_t>(phase);
    edges_[static_cast<std::size_t>(axis)].clock(in);
  }

  void request(Clk n, const Request& request) {
    request_ = request;
    asked_at_ = n;
  }

  Out clock(Clk n, const In& in) {
    Out out;
    const bool busy = running(n);
    if (asked_at_ < n && !busy) {
      asked_at_ = kNever;
      access();
      out.access = true;
    }
    out.flags = n == start_ + length_ + 1;
    std::array<bool, 2> off{};
    bool any = false;
    for (std::size_t k = 0; k < 2; ++k) {
      off[k] = in.axis[k].reset || !in.axis[k].enable;
      any = any || in.axis[k].enable;
      asked_[k] = asked_[k] || off[k];
    }
    const bool both_off = off[0] && off[1];
    const bool starts = in.tick && any && !busy;
    out.overrun = in.tick && any && busy;
    if (in.tick) {
      for (std::size_t k = 0; k < 2; ++k) {
        EdgeTime::In tick;
        tick.tick = true;
        tick.filter = in.axis[k].filter;
        edges_[k].clock(tick);
      }
    }
    knots_.clock({starts, starts && in.position, false, both_off});
    if (starts) out.underrun = start(n, in, both_off);
    if (in.commit) knots_.clock({false, false, true, both_off});
    if (n == start_ + length_) {
      finish();
      out.done = position_;
    }
    at_ = n;
    return out;
  }

  Clk due() const {
    if (asked_at_ != kNever && !running(at_ + 1)) return at_ + 1;
    if (at_ < start_ + length_) return start_ + length_;
    return at_ == start_ + length_ ? at_ + 1 : kNever;
  }

  const Precision::Out& out(int axis) const { return out_[static_cast<std::size_t>(axis)]; }
  std::uint32_t answer() const { return answer_; }
  const Request& request() const { return request_; }
  // The set point [2^-8 count]; the word P15 of the store is bounded by the error's 20 bits.
  std::int32_t set_point(int axis) const {
    const std::int64_t p = law_[static_cast<std::size_t>(axis)].state().p;
    return static_cast<std::int32_t>(fixed::wrap(fixed::rs(p, 15), 32));
  }
  std::int32_t word(int axis, PrecisionStore::Word of) const {
    return law_[static_cast<std::size_t>(axis)].read(static_cast<int>(of));
  }
  const Precision::State& law(int axis) const {
    return law_[static_cast<std::size_t>(axis)].state();
  }

 private:
  // Before edge n.
  bool running(Clk n) const { return n > start_ && n <= start_ + length_; }

  bool start(Clk n, const In& in, bool both_off) {
    start_ = n;
    position_ = in.position;
    knot_ = both_off ? PrecisionKnots::Knot::kNone : knots_.knot();
    bool resets = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const EdgeTime::Out& edge = edges_[k].out();
      in_[k] = {in.axis[k].count, edge.ticks, edge.age, edge.up, knot_, asked_[k]};
      resets = resets || asked_[k];
      asked_[k] = false;
    }
    const bool knot = knot_ != PrecisionKnots::Knot::kNone;
    length_ = knot || resets ? Precision::kKnotClocks : Precision::kClocks;
    return knot && knots_.underrun();
  }

  void finish() {
    for (std::size_t k = 0; k < 2; ++k) {
      out_[k] = law_[k].step(in_[k], window_, static_cast<int>(k));
    }
  }

  void access() {
    const auto k = static_cast<std::size_t>(request_.axis);
    if (request_.write) {
      window_.write(request_.axis, request_.word, request_.data);
      return;
    }
    answer_ = static_cast<std::uint32_t>(PrecisionStore::writable(request_.word)
                                             ? window_.read(request_.axis, request_.word)
                                             : law_[k].read(request_.word));
  }

  std::array<EdgeTime, 2> edges_;
  std::array<Precision, 2> law_;
  std::array<Precision::In, 2> in_;
  std::array<Precision::Out, 2> out_;
  std::array<bool, 2> asked_{true, true};  // for a reset
  PrecisionStore window_;
  PrecisionKnots knots_;
  PrecisionKnots::Knot knot_ = PrecisionKnots::Knot::kNone;
  bool position_ = false;  // the run is of a position tick
  Clk at_ = -1, start_ = -kLongAgo, length_ = 0;
  Request request_;
  Clk asked_at_ = kNever;
  std::uint32_t answer_ = 0;
};

}  // namespace trammel::exact
