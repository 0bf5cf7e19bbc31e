// SPDX-License-Identifier: Apache-2.0
//
// Trajectories in double precision, written from the table of specification section 10: positions
// in millimetres, point k of one pass. The firmware's integer generators are compared with these.
#pragma once

#include <cmath>

namespace trammel::ideal {

struct PointMm {
  double x = 0;  // [mm]
  double y = 0;  // [mm]
};

inline constexpr double kTurn = 6.28318530717958647693;

// Section 10: x = cx + r sin(theta), y = cy + r cos(theta).
inline PointMm circle_point(PointMm center, double radius, int ticks, int k) {
  const double theta = kTurn * k / ticks;
  // Kung eq. 28, 29
  return {center.x + radius * std::sin(theta), center.y + radius * std::cos(theta)};
}

inline constexpr int kWindowTicks = 1068;

// Kung eq. 30 to 38: the nine parts a..i of the default window, numbers of the specification.
inline PointMm window_point(int k) {
  constexpr double kStep = 0.7;
  constexpr double kRadius = 30;
  struct Part {
    int ticks;
    PointMm from;    // stroke: where it begins; arc: its centre
    double angle;    // arc: where it begins [quarter turns]
    PointMm motion;  // stroke: direction
  };
  constexpr Part kParts[] = {
      {100, {150, 250}, 0, {0, 1}},  {67, {150, 350}, 3, {}}, {200, {180, 350}, 0, {1, 0}},
      {67, {350, 350}, 2, {}},       {200, {350, 320}, 0, {0, -1}}, {67, {350, 150}, 1, {}},
      {200, {320, 150}, 0, {-1, 0}}, {67, {150, 150}, 0, {}}, {100, {150, 180}, 0, {0, 1}}};
  for (const Part& part : kParts) {
    if (k > part.ticks) {
      k -= part.ticks;
      continue;
    }
    if (part.motion.x != 0 || part.motion.y != 0) {
      return {part.from.x + part.motion.x * kStep * k, part.from.y + part.motion.y * kStep * k};
    }
    const double theta = kTurn / 4 * (part.angle + static_cast<double>(k) / part.ticks);
    return {part.from.x + kRadius * std::cos(theta), part.from.y + kRadius * std::sin(theta)};
  }
  return {150, 250};
}

inline constexpr int kStarTicks = 910;

// Kung eq. 39 to 43: the five strokes of the default star, by their increments per tick.
inline PointMm star_point(int k) {
  constexpr int kStroke = 182;
  constexpr double kStep = 100.0 / kStroke;
  const auto sine = [](double degrees) { return std::sin(kTurn * degrees / 360); };
  const PointMm steps[] = {{kStep, 0},
                           {-kStep * sine(54), -kStep * sine(36)},
                           {kStep * sine(18), kStep * sine(72)},
                           {kStep * sine(18), -kStep * sine(72)},
                           {-kStep * sine(54), kStep * sine(36)}};
  PointMm at{200, 266.25};
  for (const PointMm& step : steps) {
    const int n = k < kStroke ? k : kStroke;
    at = {at.x + n * step.x, at.y + n * step.y};
    k -= n;
  }
  return at;
}

}  // namespace trammel::ideal
