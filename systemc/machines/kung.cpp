// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/kung.hpp"

#include "cosim/kung/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::kung {

Result simulate(const Options& options, const Hooks& hooks) {
  const bool twin = options.run.engine == Engine::kTwin;
  return systemc::simulate<Session>(options, hooks,
                                    twin ? Platform::kDirect : options.run.platform);
}

}  // namespace trammel::kung
