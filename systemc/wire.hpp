// SPDX-License-Identifier: Apache-2.0
//
// A session of any machine, wired by SystemC.
#pragma once

#include <memory>
#include <optional>

#include "cosim/wave_plan.hpp"
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

// As asked; a twin without SystemC.
template <class Session>
void run(Session& session, const cosim::RunBasics& basics) {
  if (basics.platform == cosim::Platform::kSystemC && basics.engine == cosim::Engine::kRtl) {
    run(session);
  } else {
    run_direct(session);
  }
}

// Progress of one of two runs: that of the search, or of the one that is dumped.
inline cosim::Hooks half(const cosim::Hooks& hooks, double from) {
  cosim::Hooks own = hooks;
  if (hooks.progress) {
    own.progress = [&hooks, from](double fraction) { hooks.progress(from + fraction / 2); };
  }
  return own;
}

// In the wiring that these options ask for. Where waves hang at an event, the run is made twice:
// first until it is there.
template <class Session, class Options>
auto simulate(const Options& options, const cosim::Hooks& hooks) {
  using Search = typename Session::Waves::Search;
  const cosim::RunBasics& basics = options.run;
  typename Session::Waves waves;
  cosim::Hooks own = hooks;
  std::optional<cosim::Clk> trigger;
  const auto event = Search::event(basics);
  if (event && event->known()) {
    trigger = event->edge;
  } else if (event) {
    Search search(*event);
    Session session(options, half(hooks, 0), {&search, {}});
    run(session, basics);
    trigger = search.found();
    // Without the event there is nothing to dump, and this was the run.
    if (!trigger && (cosim::trigger_asked(basics) || session.stopped())) return session.result();
    own = half(hooks, 0.5);
  }
  if (basics.wave != cosim::WaveFormat::kNone) {
    waves.window = cosim::wave_window(basics, trigger.value_or(cosim::wave_origin(basics)));
  }
  Session session(options, own, waves);
  run(session, basics);
  auto result = session.result();
  result.wave_trigger = trigger;
  return result;
}

}  // namespace trammel::systemc
