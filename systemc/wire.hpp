// SPDX-License-Identifier: Apache-2.0
//
// A session of any machine, wired by SystemC.
#pragma once

#include <memory>

#include "cosim/machine.hpp"
#include "systemc/chip_module.hpp"
#include "systemc/soft_processor.hpp"

namespace trammel::systemc {

// SystemC elaborates once per simulation context; a fresh one lets a process run many machines.
class Context {
 public:
  Context() {
    sc_core::sc_curr_simcontext = sc_core::sc_default_global_context = context_.get();
    sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
    sc_core::sc_set_stop_mode(sc_core::SC_STOP_IMMEDIATE);
  }
  ~Context() {
    context_.reset();
    sc_core::sc_curr_simcontext = sc_core::sc_default_global_context = nullptr;
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  std::unique_ptr<sc_core::sc_simcontext> context_ = std::make_unique<sc_core::sc_simcontext>();
};

template <class Session>
void run(Session& session) {
  Context context;
  ChipModule chip("chip", session.loop(), session.period_ps(), session.end(),
                  [&session] { return session.finished(); });
  SoftProcessor processor("processor", chip, session.firmware(), session.timing(),
                          session.period_ps());
  sc_core::sc_start();
  chip.rethrow();
}

template <class Session>
void run_direct(Session& session) {
  cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                    [&session] { return session.finished(); });
}

// The wiring that these options ask for.
template <class Session, class Options>
auto simulate(const Options& options, const cosim::Hooks& hooks) {
  Session session(options, hooks);
  if (options.run.platform == cosim::Platform::kSystemC) {
    run(session);
  } else {
    run_direct(session);
  }
  return session.result();
}

}  // namespace trammel::systemc
