// SPDX-License-Identifier: Apache-2.0
//
// A session's run in SystemC: the module of its chip, the processor that runs its firmware, and the
// wires between them.
#pragma once

#include "cosim/session.hpp"

namespace trammel::systemc {

// One at a time in a process. Throws what chip, plant or firmware throw.
void run(cosim::Session& session);

}  // namespace trammel::systemc
