// SPDX-License-Identifier: Apache-2.0
//
// Figures of a path under the feed profile against its command in double precision, not against
// what the firmware wrote (specification of the precision controller, section 11): at each position
// sample from point 0 to the last one, by the plant's true position.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/plan/plan.hpp"
#include "models/ideal/feed_profile.hpp"

namespace trammel::kung {

inline constexpr double kUm = 1e6;  // in a metre

// From the knot that takes a point until it is the set point.
inline constexpr double kSetPointDelayS = 62.0 / 16000;

// One sample of the path.
struct CommandSample {
  std::size_t at = 0;                       // its number in the record
  double t_s = 0;                           // since point 0 was the command
  ideal::FeedProfile::Command command;      // [m], [m/s], [m/s^2]
  std::array<double, 2> error_m{};          // command - true position
  std::array<double, 2> set_point_m{};      // of the chip - command; precision controller only
};

// When a sample is, since point 0 was the command [s]; `begin`: the edge of the path's first one.
double command_time_s(const Options& options, cosim::Clk begin, const Sample& sample);

// Calls take() for each sample of the path, in order; for none where the feed profile does not
// drive it.
void each_command_sample(const Plan& plan, const Result& result,
                         const std::function<void(const CommandSample&)>& take);

// The largest error to the command of a run of the precision controller: to that in double
// precision, or to the chip's set points where the feed profile does not drive the path.
double largest_error_m(const Plan& plan, const Result& result);

// Distance of a place from the lines and arcs of a program [m].
double distance_to(const ideal::Moves& moves, const ideal::Place& place);

// Error, contour, set point and estimates; nothing where the feed profile does not drive the path.
void add_command_figures(std::vector<lab::Figure>& list, const Plan& plan, const Result& result);

// A line for each range of the controller that the run came to the end of.
std::vector<std::string> range_lines(const Options& options, const Result& result);

}  // namespace trammel::kung
