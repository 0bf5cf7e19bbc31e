// SPDX-License-Identifier: Apache-2.0
#include "systemc/platform.hpp"

#include <memory>

#include "systemc/chip_module.hpp"
#include "systemc/soft_processor.hpp"

namespace trammel::systemc {
namespace {

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

}  // namespace

void run(cosim::Session& session) {
  Context context;
  ChipModule chip("chip", session.loop(), session.period_ps(), session.end(),
                  [&session] { return session.finished(); });
  SoftProcessor processor("processor", chip, session.firmware(), session.timing(),
                          session.period_ps());
  sc_core::sc_start();
  chip.rethrow();
}

}  // namespace trammel::systemc
