// SPDX-License-Identifier: Apache-2.0
//
// What plain controllers of the trade make of the same path, as a measure for FC and AFC: a cascade
// with speed feed-forward and a PID, in double precision, on the plant's motor, carriage and
// friction. They follow the same reference model, sample at the same rate, read whole counts and
// are held to the same current. Left out: words, inverter, dead time, current loop (an ideal source
// of the q current), stops and brake. Their gains follow from the mass alone; none is fitted.
#pragma once

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/plan.hpp"

namespace trammel::kung {

enum class Law { kCascade, kPid };

// Poles of the speed loop and of the PID [rad/s]: the speed gain of X is then that of the fixed
// rules or a little less (6.3 and 5.6 of 6.9 A/(m/s)).
inline constexpr double kCascadePole = 100;
inline constexpr double kPidPole = 60;

struct Tracks {
  Points table, model, command;
};

// From the first point of the path to the last sample that counts.
Tracks baseline_tracks(const Plan& plan, Law law);

// Adds the figures of both, in rows with the columns of a lap, behind a complete run of the paper's
// path; nothing behind another.
void add_baselines(const Options& options, std::vector<lab::Figure>& list);

// Mean and variance of the tracking error and mean contour error: a row of three columns.
void add_tracking(std::vector<lab::Figure>& list, const std::string& id, const std::string& row,
                  const Series& to_model_mm, const Series& contour_mm);

}  // namespace trammel::kung
