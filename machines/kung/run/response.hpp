// SPDX-License-Identifier: Apache-2.0
//
// Frequency responses of the loops of one axis, measured by a sweep. Of position: the position loop
// from the reference model to the encoder, and the speed loop from v* to v. Of current: the current
// loop from i_q* to the measured i_q, with open position loops.
#pragma once

#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "lab/response.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/plan/plan.hpp"

namespace trammel::kung {

struct LoopResponse {
  std::string loop;  // position, speed, current
  lab::Response closed;
};

// By rising frequency, of the tones that the run completed and that both words show with at least
// one step; no loops if it was no sweep.
std::vector<LoopResponse> responses(const Plan& plan, const Result& result, std::size_t axis);

// The loop of which no tone could be measured, or "".
std::string unmeasured(const Plan& plan, const Result& result);

// What a complete sweep gave, in a line.
std::string sweep_text(const Plan& plan, const Result& result);

// Bandwidth, peak and margins of every loop.
void add_responses(std::vector<lab::Figure>& list, const Plan& plan, const Result& result);

}  // namespace trammel::kung
