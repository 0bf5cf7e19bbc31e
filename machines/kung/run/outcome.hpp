// SPDX-License-Identifier: Apache-2.0
//
// Whether the table did what the path asks, by its true position: it kept beside the path, covered
// its extent, and is at the last point when the run ends.
#pragma once

#include <cstdint>
#include <string>

#include "machines/kung/plan/plan.hpp"

namespace trammel::kung {

// Upright rectangle around points.
struct Box {
  PointM low, high;

  explicit Box(const PointM& point) : low(point), high(point) {}
  void add(const PointM& point);
  double width_m() const { return high.x_m - low.x_m; }
  double height_m() const { return high.y_m - low.y_m; }
  double diagonal_m() const;
};

// Below a millimetre in um, with the same digits as above.
std::string length_text(double metres);

class Outcome {
 public:
  explicit Outcome(const Plan& plan);

  // Largest error [m] of a table that follows: run.reached_m, or a twentieth of the path's
  // diagonal, of a square wave a quarter, at least 3 counts and at most run.diverged_m.
  double limit_m() const { return limit_m_; }

  // Largest error to the command [m] that the precision controller promises: run.reached_m, or
  // 15 um, at least 3 counts and at most run.diverged_m. 0: another controller, or points whose
  // steps no axis can follow, of which it promises nothing.
  double promised_m() const { return promised_m_; }

  // The same at the end of a run in which the model lags by `lag_m`: without run.reached_m a
  // quarter more than that is within the limit too, if not more than half the diagonal.
  double limit_at_end_m(double lag_m) const;

  // A sample, with the distance from the path asked; that may be a bound while below limit_m().
  void add(const PointM& table, double beside_m);

  // What the table missed, or "". `points` of `size` were handed over; the path ends at `last`, and
  // was at `lagging` when the model's lag began; `error_m` is the largest one to the command, where
  // the precision controller promises one.
  std::string missed(std::uint32_t points, std::uint32_t size, const PointM& last,
                     const PointM& lagging, double error_m = 0) const;
  double from_m(const PointM& last) const;  // of the table

 private:
  double count_m_;  // of the encoders
  Box path_, covered_;
  double asked_m_;  // run.reached_m
  double limit_m_;
  double promised_m_;
  double beside_m_ = 0;
  bool begun_ = false;
  PointM table_;
};

// Samples by which the table may lag behind a ramp: as the reference model of the slower axis, or
// as the set point of the precision controller.
std::uint32_t model_lag(const Options& options);

}  // namespace trammel::kung
