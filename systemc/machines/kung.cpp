// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/kung.hpp"

#include "cosim/kung/session.hpp"
#include "systemc/chip_module.hpp"
#include "systemc/soft_processor.hpp"

namespace trammel::kung {

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

void run_systemc(Session& session) {
  Context context;
  systemc::ChipModule chip("chip", session.loop(), session.period_ps(), session.end(),
                           [&session] { return session.finished(); });
  systemc::SoftProcessor processor("processor", chip, session.firmware(), session.timing(),
                                   session.period_ps());
  sc_core::sc_start();
}

void wire(Session& session, const RunOptions& run) {
  if (run.platform == Platform::kSystemC && run.engine == Engine::kRtl) {
    run_systemc(session);
  } else {
    cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                      [&session] { return session.finished(); });
  }
}

// Progress of one of two runs: that of the search, or of the one that is dumped.
Hooks half(const Hooks& hooks, double from) {
  Hooks own = hooks;
  if (hooks.progress) {
    own.progress = [&hooks, from](double fraction) { hooks.progress(from + fraction / 2); };
  }
  return own;
}

}  // namespace

Result simulate(const Options& options, const Hooks& hooks) {
  const RunOptions& run = options.run;
  Waves waves;
  Hooks own = hooks;
  std::optional<cosim::Clk> trigger;
  const auto event = wave_trigger(run);
  if (event && event->when == Trigger::When::kAt) {
    trigger = event->edge;
  } else if (event) {
    TriggerSearch search(*event);
    Session session(options, half(hooks, 0), {&search, {}});
    wire(session, run);
    trigger = search.found();
    // Without the event there is nothing to dump, and this was the run.
    if (!trigger && (trigger_asked(run) || session.stopped())) return session.result();
    own = half(hooks, 0.5);
  }
  if (run.wave != WaveFormat::kNone) {
    waves.window = wave_window(run, trigger.value_or(wave_origin(run)));
  }
  Session session(options, own, waves);
  wire(session, run);
  Result result = session.result();
  result.wave_trigger = trigger;
  return result;
}

}  // namespace trammel::kung
