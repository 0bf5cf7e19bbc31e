// SPDX-License-Identifier: Apache-2.0
#include "systemc/machines/kung.hpp"

#include "cosim/kung/session.hpp"
#include "systemc/wire.hpp"

namespace trammel::kung {

namespace {

void wire(Session& session, const RunOptions& run) {
  if (run.platform == Platform::kSystemC && run.engine == Engine::kRtl) {
    systemc::run(session);
  } else {
    systemc::run_direct(session);
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
