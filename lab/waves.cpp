// SPDX-License-Identifier: Apache-2.0
#include "lab/waves.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "host/child.hpp"
#include "host/files.hpp"
#include "host/text.hpp"
#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "lab/view.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

using cosim::RunResult;
using cosim::WaveFormat;

constexpr double kLongWindowS = 0.002;
constexpr std::size_t kListed = 100;  // windows in metrics.json
constexpr std::size_t kMarkers = 26;  // that a GTKWave view can name, A to Z

double seconds(const std::string& text, const std::string& where) {
  const auto value = cosim::parse_time(text);
  if (value) return *value;
  throw host::ConfigError(
      fmt::format("{}: value \"{}\" is not a time with s, ms, us or ns behind it", where, text));
}

std::string trigger_text(const Settings& settings) {
  const cosim::TriggerForms& forms = settings.machine().traces.triggers();
  return cosim::wave_trigger_text(settings.run, forms.start).value_or("");
}

const char* file_name(const cosim::RunOptions& run) {
  return run.wave == WaveFormat::kVcd ? "waves.vcd" : "waves.fst";
}

}  // namespace

void check_trigger(const Settings& settings, const std::string& text, const std::string& where) {
  const cosim::TriggerForms& forms = settings.machine().traces.triggers();
  try {
    cosim::parse_trigger(text, forms, settings.run.clock_ps);
  } catch (const cosim::UnknownName& error) {
    throw host::ConfigError(fmt::format("{}: {}{}", where, error.what(),
                                        hint(error.name, cosim::trigger_names(forms),
                                             "; `trammel list signals` names them all")));
  } catch (const std::invalid_argument& error) {
    throw host::ConfigError(fmt::format("{}: {}", where, error.what()));
  }
}

std::pair<double, double> parse_window(const std::string& text) {
  const auto colon = text.find(':');
  const auto begin =
      colon == std::string::npos ? std::nullopt : cosim::parse_time(text.substr(0, colon));
  const auto end =
      colon == std::string::npos ? std::nullopt : cosim::parse_time(text.substr(colon + 1));
  if (!begin || !end || *begin >= *end) {
    throw host::ConfigError(
        fmt::format("--wave-window: value \"{}\" is not a:b with a before b, each "
                    "with s, ms, us or ns behind it, for instance 0:5ms",
                    text));
  }
  return {*begin, *end};
}

void apply_waves(Settings& settings, const WaveArguments& arguments) {
  const auto set = [&settings](const char* key, const auto& value, const char* where) {
    apply_assignment(settings, fmt::format("{}={}", key, value), where);
  };
  if (!arguments.format.empty()) set("run.wave", arguments.format, "--wave");
  const std::pair<const char*, const std::string*> others[] = {
      {"--wave-window", &arguments.window},
      {"--wave-trigger", &arguments.trigger},
      {"--wave-pre", &arguments.pre},
      {"--wave-every", &arguments.every}};
  for (const auto& [name, value] : others) {
    if (!value->empty() && settings.run.wave == WaveFormat::kNone) {
      throw host::ConfigError(fmt::format("{}: needs --wave vcd or --wave fst", name));
    }
  }
  if (!arguments.window.empty()) {
    const auto [begin, end] = parse_window(arguments.window);
    set("run.wave_begin_s", begin, "--wave-window");
    set("run.wave_end_s", end, "--wave-window");
  }
  if (!arguments.trigger.empty()) {
    check_trigger(settings, arguments.trigger, "--wave-trigger");
    set("run.wave_trigger", arguments.trigger, "--wave-trigger");
  }
  if (!arguments.pre.empty()) {
    if (!arguments.window.empty() || !arguments.every.empty()) {
      throw host::ConfigError(
          "--wave-pre: is of the default window; with --wave-window or --wave-every "
          "write --wave-window -1ms:2ms");
    }
    set("run.wave_pre_s", seconds(arguments.pre, "--wave-pre"), "--wave-pre");
  }
  if (!arguments.every.empty()) {
    set("run.wave_every_s", seconds(arguments.every, "--wave-every"), "--wave-every");
  }
}

void check_waves(const Settings& settings) {
  const cosim::RunOptions& run = settings.run;
  if (run.wave == WaveFormat::kNone) return;
  const auto refuse = [](const std::string& message) { throw host::ConfigError(message); };
  if (cosim::trigger_asked(run)) {
    check_trigger(settings, run.wave_trigger, "run.wave_trigger");
  }
  const bool own = run.wave_begin_s != 0 || run.wave_end_s != 0;
  if (own && run.wave_begin_s >= run.wave_end_s) {
    refuse(fmt::format("run.wave_end_s: value {:g} must be above run.wave_begin_s = {:g}",
                       run.wave_end_s, run.wave_begin_s));
  }
  if (!cosim::trigger_asked(run) && (run.wave_begin_s < 0 || run.wave_begin_s >= run.max_s)) {
    refuse(
        fmt::format("run.wave_begin_s: value {:g} is outside the run, 0..{:g} s (run.max_s); "
                    "only a window around run.wave_trigger may begin below 0",
                    run.wave_begin_s, run.max_s));
  }
  const double length = own ? run.wave_end_s - run.wave_begin_s : cosim::kEveryWindowS;
  const cosim::Clk clocks = own ? run.clocks(run.wave_end_s) - run.clocks(run.wave_begin_s)
                                : run.clocks(length);
  if (clocks < 1) {
    refuse(fmt::format("run.wave_end_s: a window of {:g} s holds no clock, they are {:g} ns apart",
                       length, 1e-3 * static_cast<double>(run.clock_ps)));
  }
  if (run.wave_every_s != 0 && run.clocks(run.wave_every_s) < clocks) {
    refuse(fmt::format("run.wave_every_s: value {:g} is shorter than its window of {:g} s",
                       run.wave_every_s, length));
  }
}

std::optional<std::string> waves_notice(const Settings& settings) {
  const cosim::RunOptions& run = settings.run;
  if (run.wave == WaveFormat::kNone) return {};
  const bool vcd = run.wave == WaveFormat::kVcd;
  if (vcd && host::find_program("fst2vcd").empty()) {
    throw host::ToolMissing("--wave vcd: fst2vcd is missing (see `trammel doctor`)");
  }
  const Machine& machine = settings.machine();
  const cosim::WaveWindow window = cosim::wave_window(run, 0);
  const double length = run.seconds(window.end - window.begin);
  const Tracing& traces = machine.traces;
  const double mega = length * (vcd ? traces.vcd_bytes_s : traces.fst_bytes_s) / 1e6;
  if (run.wave_every_s > 0) {
    return fmt::format("waves take about {:.2g} MB a second of the run", mega / run.wave_every_s);
  }
  if (length <= kLongWindowS * 1.001) return {};
  return fmt::format("waves of {} take about {:.2g} MB", host::time_text(length), mega);
}

bool fst_to_vcd(const fs::path& fst, const fs::path& vcd) {
  // What it writes itself it does not check.
  host::Child converter({host::find_program("fst2vcd").string(), "-f", fs::absolute(fst).string()},
                        host::Child::Pipe::kFromOutput);
  if (converter.pipe() == nullptr) return false;
  bool good = false;
  std::vector<char> block(1 << 16);
  host::write_lines(vcd, [&](const host::Put& put) {
    std::size_t size = 0;
    while ((size = std::fread(block.data(), 1, block.size(), converter.pipe())) > 0) {
      put({block.data(), size});
      good = true;
    }
  });
  good = converter.ended() && good;
  std::error_code ignored;
  fs::remove(good ? fst : vcd, ignored);
  return good;
}

std::string placed_view(const std::string& text, const fs::path& waves,
                        const RunResult& result) {
  const cosim::WaveSpan first = result.waves.front();
  const std::int64_t period = cosim::wave_scale(result.clock_ps).period;
  constexpr double kFrames = 1045.0 / 200;  // width of the view's waves; GTKWave counts 200 pixels
  std::string markers;
  for (std::size_t i = 0; i < kMarkers; ++i) {
    const bool used = result.waves.size() > 1 && i < result.waves.size();
    markers += fmt::format(" {}", used ? result.waves[i].begin * period : -1);
  }
  const double zoom =
      -std::log2(static_cast<double>((first.end - first.begin) * period) / kFrames);
  // One line a path: of a folder that no line can name, the view names the file alone.
  const std::string whole = waves.string();
  const bool can_name = host::printable(whole) == whole && whole.find('"') == std::string::npos;
  const fs::path named = can_name ? waves : waves.filename();
  std::string placed =
      fmt::format("[dumpfile] \"{0}\"\n[savefile] \"{1}\"\n[timestart] {2}\n", named.string(),
                  fs::path(named).replace_extension("gtkw").string(), first.begin * period);
  placed += fmt::format("*{:.6f} {}{}\n", zoom,
                        result.wave_trigger ? *result.wave_trigger * period : -1, markers);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool replaced = line.rfind("[dumpfile]", 0) == 0 || line.rfind("[savefile]", 0) == 0 ||
                          line.rfind("[timestart]", 0) == 0 || line.rfind('*', 0) == 0;
    if (!replaced) placed += line + '\n';
  }
  return placed;
}

std::string placed_commands(const std::string& text, const RunResult& result) {
  const cosim::WaveScale scale = cosim::wave_scale(result.clock_ps);
  const auto time = [&scale](cosim::Clk edge) {
    return fmt::format("{}{}", edge * scale.period, scale.unit);
  };
  const cosim::WaveSpan first = result.waves.front();
  std::string placed = text + fmt::format("zoom_to {} {}\n", time(first.begin), time(first.end));
  if (result.wave_trigger) placed += fmt::format("cursor_set {}\n", time(*result.wave_trigger));
  return placed;
}

bool finish_waves(const Settings& settings, const RunResult& result, const fs::path& folder,
                  std::vector<std::string>& notes) {
  if (settings.run.wave == WaveFormat::kNone) return true;
  const auto missing = [&notes](const std::string& why) {
    notes.push_back(fmt::format("no waves: {}; the run's results are kept", why));
    return false;
  };
  const fs::path fst = settings.run.wave_file;
  if (const int error = cosim::take_wave_error(); error != 0) {
    throw std::system_error(error, std::generic_category(), fst.string() + ": cannot be written");
  }
  const double ran_s = result.seconds(result.clocks);
  if (result.waves.empty()) {
    std::error_code ignored;
    fs::remove(fst, ignored);
    if (result.end == cosim::EndReason::kStopped) return missing("the run was interrupted");
    if (cosim::trigger_asked(settings.run) && !result.wave_trigger) {
      return missing(fmt::format("the trigger \"{}\" never fired in {}", trigger_text(settings),
                                 host::time_text(ran_s)));
    }
    return missing(fmt::format("their window lies outside the run, 0..{}", host::time_text(ran_s)));
  }
  fs::path file = fst;
  bool good = true;
  if (settings.run.wave == WaveFormat::kVcd) {
    file.replace_extension("vcd");
    good = fst_to_vcd(fst, file);
    if (!good) {
      notes.emplace_back("fst2vcd failed; the waves are kept as waves.fst");
      file = fst;
    }
  }
  const std::string& name = settings.machine().name;
  fs::path source = machine_folder(name) / "view.toml";
  if (!fs::exists(source)) source = fs::path(kViewFolder) / (name + ".toml");
  Views views;
  try {
    views = make_views(settings, host::read_text(source), source.string(),
                       host::find_program("python3").string());
  } catch (const std::runtime_error& error) {
    notes.push_back(fmt::format("no view of the waves: {}", host::reason_of(error)));
    return good;
  }
  host::write_text(fst.parent_path() / "waves.gtkw",
                   placed_view(views.gtkwave, folder / file.filename(), result));
  host::write_text(fst.parent_path() / "waves.sucl", placed_commands(views.surfer, result));
  return good;
}

std::string waves_text(const Settings& settings, const RunResult& result,
                         const std::string& folder) {
  if (result.waves.empty()) return "";
  std::string text;
  if (result.wave_trigger) {
    const bool known = trigger_text(settings).find("at ") == 0;
    text += fmt::format("  trigger `{}` at {} (clock {}){}\n", trigger_text(settings),
                        host::time_text(result.seconds(*result.wave_trigger)), *result.wave_trigger,
                        known ? "" : ", found in an untraced run before this one");
  }
  const cosim::WaveSpan first = result.waves.front();
  text += fmt::format("  waves of {} to {}", host::time_text(result.seconds(first.begin)),
                      host::time_text(result.seconds(first.end)));
  if (result.waves.size() > 1) {
    text += fmt::format(" and {} more windows, the last from {}", result.waves.size() - 1,
                        host::time_text(result.seconds(result.waves.back().begin)));
  }
  return text + fmt::format("; to look at them: gtkwave {}/waves.gtkw\n", folder);
}

nlohmann::ordered_json waves_json(const Settings& settings, const RunResult& result) {
  nlohmann::ordered_json json{{"file", file_name(settings.run)}};
  if (result.wave_trigger) {
    json["trigger"] = trigger_text(settings);
    json["trigger_s"] = result.seconds(*result.wave_trigger);
  }
  json["windows"] = result.waves.size();
  for (std::size_t i = 0; i < std::min(result.waves.size(), kListed); ++i) {
    const cosim::WaveSpan& span = result.waves[i];
    json["windows_s"].push_back({result.seconds(span.begin), result.seconds(span.end)});
  }
  return json;
}

}  // namespace trammel::lab
