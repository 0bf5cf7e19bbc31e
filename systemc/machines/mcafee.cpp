// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/mcafee.hpp"

#include "cosim/mcafee/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::mcafee {

Result simulate(const Options& options, const cosim::Hooks& hooks) {
  return systemc::simulate<Session>(options, hooks);
}

}  // namespace trammel::mcafee
