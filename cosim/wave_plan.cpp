// SPDX-License-Identifier: Apache-2.0
#include "cosim/wave_plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace trammel::cosim {

namespace {

constexpr double kLongestS = 3600;  // as run.max_s

bool default_window(const RunOptions& run) { return run.wave_begin_s == 0 && run.wave_end_s == 0; }

}  // namespace

std::optional<double> parse_time(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !std::isfinite(value)) return {};
  const std::string unit = end;
  if (unit.empty() || unit == "s") return value;
  if (unit == "ms") return value * 1e-3;
  if (unit == "us") return value * 1e-6;
  if (unit == "ns") return value * 1e-9;
  return {};
}

Clk parse_edge(const std::string& text, std::int64_t clock_ps) {
  const auto seconds = parse_time(text);
  if (!seconds || !(*seconds >= 0 && *seconds <= kLongestS)) {
    throw std::invalid_argument(fmt::format(
        "value {} is not a time 0..{:g} s with s, ms, us or ns behind it", text, kLongestS));
  }
  return clocks_of(*seconds, clock_ps);
}

std::optional<std::string> wave_trigger_text(const RunOptions& run, const char* start) {
  if (run.wave == WaveFormat::kNone) return {};
  if (trigger_asked(run)) return run.wave_trigger;
  if (default_window(run) && run.wave_every_s == 0) return start;
  return {};
}

// The default window then begins with the run.
Clk wave_origin(const RunOptions& run) {
  return default_window(run) && run.wave_every_s == 0 ? run.clocks(run.wave_pre_s) : 0;
}

WaveWindow wave_window(const RunOptions& run, Clk origin) {
  double begin_s = run.wave_begin_s;
  double end_s = run.wave_end_s;
  if (default_window(run)) {
    const bool every = run.wave_every_s > 0;
    begin_s = every ? 0 : -run.wave_pre_s;
    end_s = every ? kEveryWindowS : kAfterTriggerS;
  }
  WaveWindow window{origin + run.clocks(begin_s), origin + run.clocks(end_s), kNever};
  if (run.wave_every_s > 0) window.period = run.clocks(run.wave_every_s);
  while (window.end <= 0 && window.period != kNever) window.next();
  return window;
}

}  // namespace trammel::cosim
