// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/an693.hpp"

#include "cosim/lm628/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::lm628 {

Result simulate(const Options& options, const cosim::Hooks& hooks) {
  return systemc::simulate<Session>(options, hooks);
}

}  // namespace trammel::lm628
