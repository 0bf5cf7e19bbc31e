// SPDX-License-Identifier: Apache-2.0
//
// What became of an injected fault.
#pragma once

#include <string>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

struct FaultReport {
  Clk begin = kNever;                   // kNever: no fault was injected
  Clk detected = kNever, off = kNever;  // kNever: it was not
  std::string by;                       // what detected it
  double stopping = 0;                  // distance from where the drives went off
  std::string unit = "mm";              // of that
  double peak_A = 0;                    // since the fault
  bool at_stop = false;
};

}  // namespace trammel::cosim
