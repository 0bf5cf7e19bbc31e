// SPDX-License-Identifier: Apache-2.0
#include "lab/wiring.hpp"

#include <optional>

#include "systemc/platform.hpp"

namespace trammel::lab {
namespace {

// Progress of one of two runs: that of the search, or of the one that is dumped.
cosim::Hooks half_of_progress(const cosim::Hooks& hooks, double from) {
  cosim::Hooks own = hooks;
  if (hooks.progress) {
    own.progress = [&hooks, from](double fraction) { hooks.progress(from + fraction / 2); };
  }
  return own;
}

}  // namespace

void run_session(cosim::Session& session, const cosim::RunOptions& options) {
  if (cosim::Core* const core = session.core()) {
    cosim::CoreRun run(session.loop(), *core, session.end(),
                       [&session] { return session.finished(); },
                       [&session](const cosim::CoreTrap& trap) { session.trapped(trap); });
    run.run();
    session.core_ran(run.times());
  } else if (options.platform == cosim::Platform::kSystemC &&
             options.engine == cosim::Engine::kRtl) {
    systemc::run(session);
  } else {
    cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                      [&session] { return session.finished(); });
  }
}

std::unique_ptr<cosim::RunResult> simulate(const cosim::RunOptions& options,
                                           const cosim::TriggerForms& forms,
                                           const cosim::MakeSession& make,
                                           const cosim::Hooks& hooks) {
  cosim::Waves waves;
  cosim::Hooks own = hooks;
  std::optional<cosim::Clk> trigger;
  const auto event = cosim::wave_event(options, forms);
  if (event && event->known()) {
    trigger = event->edge;
  } else if (event) {
    cosim::TriggerSearch search(*event);
    const auto session = make(half_of_progress(hooks, 0), {&search, {}});
    run_session(*session, options);
    trigger = search.found();
    // Without the event there is nothing to dump, and this was the run.
    if (!trigger && (cosim::trigger_asked(options) || session->stopped())) return session->result();
    own = half_of_progress(hooks, 0.5);
  }
  if (options.wave != cosim::WaveFormat::kNone) {
    waves.window = cosim::wave_window(options, trigger.value_or(cosim::wave_origin(options)));
  }
  const auto session = make(own, waves);
  run_session(*session, options);
  auto result = session->result();
  result->wave_trigger = trigger;
  return result;
}

}  // namespace trammel::lab
