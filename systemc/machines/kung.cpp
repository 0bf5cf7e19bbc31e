// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/kung.hpp"

#include "cosim/kung/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::kung {

Result simulate(const Options& options, const Hooks& hooks) {
  return systemc::simulate<Session>(options, hooks);
}

}  // namespace trammel::kung
