// SPDX-License-Identifier: Apache-2.0
//
// A failed assertion of a block's _props.sv, reported by a model that carries them. Verilator would
// end the program there; here the run ends with its record.
#pragma once

#include <optional>
#include <string>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

struct FailedAssertion {
  std::string name;      // of the assertion: no_shoot_through
  std::string instance;  // that made it: kung_xy.gen_axis[0].u_axis...
  std::string place;     // file:line of it
  Clk edge = 0;          // clock edge at which it was checked
};

// The first that failed in this thread since the last call, without its edge.
std::optional<FailedAssertion> take_failed_assertion();

}  // namespace trammel::cosim
