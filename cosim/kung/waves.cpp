// SPDX-License-Identifier: Apache-2.0
#include "cosim/kung/waves.hpp"

#include <algorithm>

#include "cosim/kung/words.hpp"

namespace trammel::kung {

namespace {
bool default_window(const RunOptions& run) { return run.wave_begin_s == 0 && run.wave_end_s == 0; }
}  // namespace

std::optional<Trigger> wave_trigger(const RunOptions& run) {
  if (run.wave == WaveFormat::kNone) return {};
  if (trigger_asked(run)) return parse_trigger(run.wave_trigger);
  if (default_window(run) && run.wave_every_s == 0) return parse_trigger("drives");
  return {};
}

// The default window then begins with the run.
cosim::Clk wave_origin(const RunOptions& run) {
  return default_window(run) && run.wave_every_s == 0 ? edge_at(run.wave_pre_s) : 0;
}

WaveWindow wave_window(const RunOptions& run, cosim::Clk origin) {
  double begin_s = run.wave_begin_s;
  double end_s = run.wave_end_s;
  if (default_window(run)) {
    const bool every = run.wave_every_s > 0;
    begin_s = every ? 0 : -run.wave_pre_s;
    end_s = every ? kEveryWindowS : kAfterTriggerS;
  }
  WaveWindow window{origin + edge_at(begin_s), origin + edge_at(end_s), cosim::kNever};
  if (run.wave_every_s > 0) window.period = edge_at(run.wave_every_s);
  while (window.end <= 0 && window.period != cosim::kNever) window.next();
  return window;
}

}  // namespace trammel::kung
