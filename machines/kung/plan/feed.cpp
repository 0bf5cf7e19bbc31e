// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/feed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {
namespace {

using ideal::Move;
using ideal::Moves;
using ideal::Place;

constexpr double kLeastFeed = 1e-4, kMostFeed = 1.2;  // [m/s]

double point_s(const Options& options) {
  return ticks_per_point(options) * options.chip.sample_s();
}

// Appends moves from where the last one ended.
class Pen {
 public:
  Pen(const PathOptions& p, const Place& start) {
    all_.start = next_.from = start;
    next_.feed = feed_m_s(p);
    next_.exact = p.corner != Corner::kPass;
  }

  void line(const Place& to) {
    next_.kind = Move::Kind::kLine;
    add(to);
  }
  void arc(const Place& center, double sweep, const Place& to) {
    next_.kind = Move::Kind::kArc;
    next_.center = center;
    next_.sweep = sweep;
    add(to);
  }
  void stop(double dwell_s) {
    all_.moves.back().stop = true;
    all_.moves.back().dwell = dwell_s;
  }
  const Moves& moves() const { return all_; }

 private:
  void add(const Place& to) {
    next_.to = to;
    all_.moves.push_back(next_);
    next_.from = to;
  }

  Moves all_;
  Move next_;
};

Moves circle(const PathOptions& p) {
  const Place center{p.circle_center_x_m, p.circle_center_y_m};
  const Place top{center.x, center.y + p.circle_radius_m};
  Pen pen(p, top);
  pen.arc(center, -2 * kPi, top);
  return pen.moves();
}

// Kung eq. 30 to 38: clockwise from the middle of the left side, the arcs themselves run left.
Moves window(const PathOptions& p) {
  const double half = p.window_side_m / 2, r = p.window_radius_m;
  in_range("path.window_radius_m", r, 1e-4, half - 1e-4, "the straight parts need some length");
  const Place c{p.window_center_x_m, p.window_center_y_m};
  const Place middle{c.x - half, c.y};
  Pen pen(p, middle);
  const auto corner = [&](double side_x, double side_y) {
    const Place at{c.x + side_x * half, c.y + side_y * half};
    // It is entered and left along the sides, the later one turned right.
    const Place level{at.x - side_x * r, at.y}, upright{at.x, at.y - side_y * r};
    const bool from_level = side_x == side_y;
    pen.line(from_level ? level : upright);
    pen.arc(at, kPi / 2, from_level ? upright : level);
  };
  corner(-1, 1);
  corner(1, 1);
  corner(1, -1);
  corner(-1, -1);
  pen.line(middle);
  return pen.moves();
}

// Kung eq. 39 to 43.
Moves star(const PathOptions& p) {
  const Place start{p.star_start_x_m, p.star_start_y_m};
  Pen pen(p, start);
  Place at = start;
  const sw::Star::Setup shape;
  const auto strokes = static_cast<int>(shape.strokes), turns = static_cast<int>(shape.turns);
  for (int k = 0; k < strokes; ++k) {
    const double angle = 2 * kPi * (k * turns % strokes) / strokes;
    at = k + 1 == strokes ? start
                          : Place{at.x + p.star_edge_m * std::cos(angle),
                                  at.y + p.star_edge_m * std::sin(angle)};
    pen.line(at);
  }
  return pen.moves();
}

Moves line(const PathOptions& p) {
  const Place from{p.line_start_x_m, p.line_start_y_m}, to{p.line_end_x_m, p.line_end_y_m};
  require(from.x != to.x || from.y != to.y, "path.line_end_x_m: the line has no length");
  Pen pen(p, from);
  for (int pass = 0; pass < p.repeats; ++pass) {
    pen.line(pass % 2 == 0 ? to : from);
    pen.stop(0);
  }
  return pen.moves();
}

// One period. A move begins every half of it and is over before the next.
Moves square(const Options& options) {
  const PathOptions& p = options.path;
  require_step(p);
  const Place low{p.square_low_m, p.square_low_m}, high{p.square_high_m, p.square_high_m};
  const int point = ticks_per_point(options);
  const int half = square_half_samples(options) / point;
  Pen pen(p, low);
  pen.line(high);
  const auto moving = static_cast<int>(
      ideal::FeedProfile(pen.moves(), feed_limits(options)).points() - ideal::FeedProfile::kRest);
  require(moving <= half,
          fmt::format("path.square_half_samples: value {} must be at least {}: the move of {:g} m "
                      "takes as long", p.square_half_samples, moving * point,
                      pen.moves().moves[0].length()));
  const double rest_s = (half - moving) * point_s(options);
  pen.stop(rest_s);
  pen.line(low);
  pen.stop(rest_s);
  return pen.moves();
}

}  // namespace

double feed_m_s(const PathOptions& p) {
  if (p.feed_m_s != 0) return p.feed_m_s;
  switch (p.kind) {
    case PathKind::kCircle: return 0.5;
    case PathKind::kWindow: return 0.35;
    case PathKind::kStar: return 0.275;
    default: return 0.3;
  }
}

double highest_feed_m_s(const Moves& moves) {
  double highest = 0;
  for (const Move& move : moves.moves) highest = std::max(highest, move.feed);
  return highest;
}

bool feeds(const Options& options) {
  const PathOptions& path = options.path;
  const bool of_lines = path.kind == PathKind::kFeed ||
                        (path.kind == PathKind::kPoints && path.points_mode == PointsMode::kPath);
  const bool feed = path.profile == Profile::kAuto
                        ? of_lines || options.controller == Controller::kPrecision
                        : path.profile == Profile::kFeed;
  if (!feed || path.is_sweep()) return false;
  return path.kind != PathKind::kPoints || path.points_mode == PointsMode::kPath;
}

int ticks_per_point(const Options& options) {
  const bool steps = options.path.kind == PathKind::kSquare && !feeds(options);
  return steps || options.path.is_sweep() ? 1 : options.chip.irq_period_ticks;
}

ideal::FeedProfile::Limits feed_limits(const Options& options) {
  const PathOptions& p = options.path;
  return {p.axis[0].accel_m_s2, p.axis[1].accel_m_s2, p.mean_points, point_s(options)};
}

int square_half_samples(const Options& options) {
  const int point = ticks_per_point(options);
  return (options.path.square_half_samples + point - 1) / point * point;
}

Moves feed_moves(const Options& options, const Moves& read) {
  const PathOptions& p = options.path;
  switch (p.kind) {
    case PathKind::kCircle: return circle(p);
    case PathKind::kWindow: return window(p);
    case PathKind::kStar: return star(p);
    case PathKind::kSquare: return square(options);
    case PathKind::kLine: return line(p);
    default: return read;
  }
}

namespace {

// Passes of feed_moves().
int passes(const PathOptions& p) {
  return p.kind == PathKind::kSquare ? p.square_periods : p.kind == PathKind::kLine ? 1 : p.repeats;
}

}  // namespace

ideal::FeedProfile ideal_command(const Options& options, const Moves& moves) {
  return ideal::FeedProfile(moves, feed_limits(options), passes(options.path));
}

sw::PathSetup plan_feed(const Options& options, FeedProgram& program, const Moves& read) {
  const PathOptions& p = options.path;
  const double count_m = options.plant.axis[0].encoder_count_m;
  const double feed_max = Encoder{count_m, options.chip.sample_s()}.max_feed_m_s();
  in_range("path.feed_m_s", feed_m_s(p), kLeastFeed, std::min(kMostFeed, p.feed_max_m_s),
           "path.feed_max_m_s");
  const Moves moves = feed_moves(options, read);
  for (const Move& m : moves.moves) {
    require(m.feed <= feed_max,
            fmt::format("path.feed_m_s: value {:g} must be at most {:g} at plant.encoder_count_m = "
                        "{:g}", m.feed, feed_max, count_m));
  }
  program = feed_program(moves, feed_limits(options), count_m);
  sw::PathSetup s;
  s.path = sw::Path::kFeed;
  s.feed = program.setup;
  const int laps = passes(p);
  const Place end = moves.moves.back().to;
  if (laps > 1) {
    require(end.x == moves.start.x && end.y == moves.start.y,
            fmt::format("path.repeats: value {} must be 1: the path does not end where it begins",
                        laps));
  }
  in_range(p.kind == PathKind::kSquare ? "path.square_periods" : "path.repeats", laps, 1,
           std::max(1.0, std::floor(kMaxPoints / (program.setup.ticks + sw::FeedPath::kRest +
                                                   program.setup.begin))));
  s.repeats = word(laps);
  return s;
}

}  // namespace trammel::kung
