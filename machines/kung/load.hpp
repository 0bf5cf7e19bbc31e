// SPDX-License-Identifier: Apache-2.0
//
// What the motors and their drives had to give in a run, and where they had no more.
#pragma once

#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

struct AxisSample;

// Of one axis, over the samples of a path.
struct AxisLoad {
  void add(const AxisSample& sample, const plant::AxisConfig& plant);

  double rms_current_A() const;  // of a phase
  double rms_force_N() const;
  double copper_loss_W(double resistance_ohm) const;  // of the three phases, mean
  // Why an axis could not do what was asked, or "": "i_q* at its limit 40 %, voltage at the
  // supply's 12 % of the samples".
  std::string limits() const;

  double peak_current_A = 0;  // of the current vector, as i_q
  double least_link_V = 0, most_link_V = 0;  // of the DC link
  std::size_t samples = 0, at_current = 0, at_voltage = 0, at_stop = 0;
  double squares_A2 = 0, squares_N2 = 0;
};

// rms current, rms thrust and copper loss of each axis.
void add_load(std::vector<lab::Figure>& list, const Options& options, const Result& result);

// A line for each rating of a motor that the run exceeds.
std::vector<std::string> overloads(const Options& options, const Result& result);

}  // namespace trammel::kung
