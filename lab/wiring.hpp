// SPDX-License-Identifier: Apache-2.0
//
// A session of any machine, wired by SystemC or directly.
#pragma once

#include <memory>

#include "cosim/session.hpp"

namespace trammel::lab {

// By SystemC, or directly; a twin always directly. Runs one at a time in a process.
void run_session(cosim::Session& session, const cosim::RunOptions& options);

// A whole run. Where its waves are anchored to an event, it is made twice: first until the event
// is there.
std::unique_ptr<cosim::RunResult> simulate(const cosim::RunOptions& options,
                                           const cosim::TriggerForms& forms,
                                           const cosim::MakeSession& make,
                                           const cosim::Hooks& hooks);

}  // namespace trammel::lab
