// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/an693.hpp"

#include "cosim/lm628/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::lm628 {

Result simulate(const Options& options, const cosim::Hooks& hooks) {
  Session session(options, hooks);
  if (options.run.platform == cosim::Platform::kSystemC) {
    systemc::run(session);
  } else {
    systemc::run_direct(session);
  }
  return session.result();
}

}  // namespace trammel::lm628
