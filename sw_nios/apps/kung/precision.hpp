// SPDX-License-Identifier: Apache-2.0
//
// The firmware's part of the precision controller (docs/precision.md): at each interrupt it reads
// the sums of the last knot, estimates, and writes the words of the next knot with its COMMIT. It
// looks one point ahead, so that the pre-filter knows the next point, and computes points behind
// the COMMIT. Points are 2^-8 count; before those of the path come those of the identification.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/apps/kung/estimator.hpp"
#include "sw_nios/apps/kung/learning.hpp"
#include "sw_nios/apps/kung/precision_setup.hpp"
#include "sw_nios/apps/kung/precision_values.hpp"
#include "sw_nios/hal/bus.hpp"
#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class PrecisionControl {
 public:
  // From rest at `start` [count] by the ways of the identification move [2^-8 count], then on a
  // path of `size` points, which are alike after every `lap` of them.
  [[gnu::cold]] PrecisionControl(const PrecisionSetup& setup, Point start, Point move,
                                 std::uint32_t size, std::uint32_t lap);

  // Points are given twice before start() and once behind each serve(): one of the path where
  // needs_point(), else any.
  bool needs_point() const { return given_ >= before_path_; }
  void give(Point point);

  [[gnu::cold]] void start(Bus& bus);  // all words, in reset
  void serve(Bus& bus);  // up to COMMIT

  // What serve() writes next, or has just written before give().
  bool on_path() const { return given_ - 2 >= before_path_; }
  Point point() const { return {axes_[0].points[1], axes_[1].points[1]}; }

  const Estimator& estimator(std::uint32_t axis) const { return axes_[axis].estimator; }

 private:
  struct Axis {
    Estimator estimator;
    Learning learning;
    std::int32_t control = 0;             // point that the next knot takes
    Estimator::Theta fed;                 // estimates that the words have, behind the newest
    KnotWords words;                      // as written last
    std::array<std::int32_t, 3> points;     // the next, this one, the one before
    std::array<std::int32_t, 3> corrected;  // the same with what was learned
    bool late = false;                      // a payload beyond the motor
  };

  void write_gains(Bus& bus, std::uint32_t axis, const LawGains& gains) const;
  void write_knot(Bus& bus, std::uint32_t axis, std::int32_t c, std::int32_t iff,
                  std::int32_t ratio) const;
  void estimate(Bus& bus, std::uint32_t axis);
  void command(Bus& bus, std::uint32_t axis);
  void slow_down(Bus& bus, std::uint32_t axis);

  PrecisionSetup setup_;
  Point start_, move_;
  std::uint32_t before_path_, size_;  // points
  std::uint32_t given_ = 0;
  std::array<Axis, 2> axes_;
};

}  // namespace trammel::sw
