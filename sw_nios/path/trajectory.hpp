// SPDX-License-Identifier: Apache-2.0
//
// One of the paths, chosen when the program starts. A plain value: a copy continues separately.
#pragma once

#include <cstdint>

#include "sw_nios/path/circle.hpp"
#include "sw_nios/path/feed_path.hpp"
#include "sw_nios/path/line.hpp"
#include "sw_nios/path/points.hpp"
#include "sw_nios/path/square.hpp"
#include "sw_nios/path/star.hpp"
#include "sw_nios/path/stepped_sine.hpp"
#include "sw_nios/path/window.hpp"

namespace trammel::sw {

enum class Path : std::uint8_t { kCircle, kWindow, kStar, kSquare, kLine, kPoints, kSweep, kFeed };

// Only the parameters of the chosen `path` matter.
struct PathSetup {
  Path path = Path::kCircle;
  Circle::Setup circle;
  Window::Setup window;
  Star::Setup star;
  Square::Setup square;
  Line::Setup line;
  SteppedSine::Setup sweep;
  const Point* points = nullptr;  // not owned: must outlive the trajectory
  std::uint32_t n_points = 0;
  FeedPath::Setup feed;    // lists not owned either, and planned (feed_plan.hpp)
  std::uint32_t repeats = 1;  // laps; passes of the line, periods of the square wave
};

class Trajectory {
  template <typename Self, typename Function>
  static constexpr auto visit(Self& self, Function&& function) {
    switch (self.path_) {
      case Path::kWindow: return function(self.window_);
      case Path::kStar: return function(self.star_);
      case Path::kSquare: return function(self.square_);
      case Path::kLine: return function(self.line_);
      case Path::kPoints: return function(self.points_);
      case Path::kSweep: return function(self.sweep_);
      case Path::kFeed: return function(self.feed_);
      case Path::kCircle: break;
    }
    return function(self.circle_);
  }

 public:
  [[gnu::cold]] constexpr explicit Trajectory(const PathSetup& s)
      : path_(s.path),
        circle_(s.circle, s.repeats),
        window_(s.window, s.repeats),
        star_(s.star, s.repeats),
        square_(s.square, s.repeats),
        line_(s.line, s.repeats),
        points_({s.points, s.n_points}, s.repeats),
        sweep_(s.sweep),
        feed_{FeedPath(s.feed, s.repeats)} {}

  // Number of points of the path; next() returns them in order.
  constexpr std::uint32_t size() const {
    return visit(*this, [](const auto& g) { return g.size(); });
  }
  // Where the table rests before point 0.
  constexpr Point start() const {
    return visit(*this, [](const auto& g) { return g.start(); });
  }
  constexpr Point next() {
    return visit(*this, [](auto& g) { return g.next(); });
  }
  // The next point in Q8; instead of next().
  constexpr Point next_q8() {
    if (path_ == Path::kFeed) return feed_.path.next();
    const Point point = next();
    return {point.x * 256, point.y * 256};
  }

 private:
  // Its points in whole counts.
  struct Feed {
    FeedPath path;

    static constexpr Point rounded(Point q8) { return {(q8.x + 128) >> 8, (q8.y + 128) >> 8}; }
    constexpr std::uint32_t size() const { return path.size(); }
    constexpr Point start() const { return rounded(path.start()); }
    constexpr Point next() { return rounded(path.next()); }
  };

  Path path_;
  Circle circle_;
  Window window_;
  Star star_;
  Square square_;
  Line line_;
  Points points_;
  SteppedSine sweep_;
  Feed feed_;
};

}  // namespace trammel::sw
