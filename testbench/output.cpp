// SPDX-License-Identifier: Apache-2.0
#include "testbench/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "testbench/build_info.hpp"
#include "testbench/config.hpp"
#include "testbench/paper.hpp"
#include "testbench/report.hpp"
#include "testbench/report_page.hpp"
#include "testbench/waves.hpp"

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOwnFiles[] = {"metrics.json", "trace.csv",  "detail.json", "run.toml",
                                     "report.html",  "path.svg",   "error.svg",   "motion.svg",
                                     "waves.vcd",    "waves.fst",  "waves.gtkw",  "script.lm628",
                                     "table.csv",    "contour.svg"};

Json wakes_json(const kung::WakeCounts& wakes) {
  Json json;
  for (std::size_t n = 0; n < kung::kWakes; ++n) json[kung::kWakeNames[n]] = wakes[n];
  return json;
}

Json to_json(const Spread& s) {
  return {{"samples", s.n},      {"mean_mm", s.mean}, {"std_mm", s.std},
          {"variance_mm2", s.variance}, {"rms_mm", s.rms},   {"max_mm", s.max}};
}

Json to_json(const std::vector<HalfPeriod>& list) {
  Json all = Json::array();
  for (const HalfPeriod& one : list) {
    all.push_back({{"overshoot_percent", one.overshoot_percent}, {"rms_mm", one.rms_mm}});
  }
  return all;
}

Json to_json(const AxisMetrics& axis) {
  Json json{{"error_to_model", to_json(axis.model_mm)},
            {"peak_current_A", axis.peak_current_A},
            {"max_speed_m_s", axis.max_speed_m_s}};
  if (!axis.halves.empty()) {
    json["half_periods"] = to_json(axis.halves);
    json["periods"] = to_json(axis.periods);
  }
  return json;
}

}  // namespace

Json value_json(const Value& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json versions_json() {
  return {{"trammel", kVersion},   {"commit", kCommit},     {"verilator", kVerilator},
          {"systemc", kSystemC},   {"compiler", kCompiler}, {"build", kBuild}};
}

OutputFolder::OutputFolder(const fs::path& target) : target_(fs::absolute(target)) {
  if (!target_.has_filename()) target_ = target_.parent_path();  // "out/" is "out"
  std::error_code error;
  if (fs::exists(target_, error) && !fs::is_directory(target_, error)) {
    throw ConfigError(fmt::format("{}: --out: is not a folder", target_.string()));
  }
  if (fs::is_directory(target_, error) && access(target_.c_str(), W_OK | X_OK) != 0) {
    throw ConfigError(fmt::format("{}: --out: cannot be written: {}", target_.string(),
                                  std::strerror(errno)));
  }
  fs::create_directories(target_.parent_path(), error);
  std::string pattern =
      (target_.parent_path() / fmt::format(".{}.XXXXXX", target_.filename().string())).string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw ConfigError(fmt::format("{}: --out: cannot be written: {}",
                                  target_.parent_path().string(), std::strerror(errno)));
  }
  scratch_ = pattern;
  fs::permissions(scratch_, fs::perms::group_read | fs::perms::group_exec |
                                fs::perms::others_read | fs::perms::others_exec,
                  fs::perm_options::add, error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

void OutputFolder::publish() {
  std::error_code fresh;
  if (!fs::exists(target_)) {
    fs::rename(scratch_, target_, fresh);
    if (!fresh) return;
  }
  for (const char* name : kOwnFiles) {
    if (fs::exists(scratch_ / name)) {
      fs::rename(scratch_ / name, target_ / name);
    } else {
      fs::remove(target_ / name);
    }
  }
}

Json metrics_json(const kung::Options& options, const kung::Result& result, const Metrics& m) {
  Json json;
  json["machine"] = "kung";
  json["scenario"] = options.scenario;
  json["command"] = repeat_command(options);
  json["end"] = end_text(result.end);
  json["verdict"] = verdict_text(options, result);
  if (result.fault.code != kung::FaultCode::kNone) {
    json["fault"] = {{"cause", fault_text(result.fault.code)},
                     {"axis", result.fault.axis == 0 ? "x" : "y"},
                     {"processor", result.fault.processor},
                     {"tick", result.fault.tick}};
  }
  if (result.promise) json["promise"] = promise_json(*result.promise);
  json["tracking"] = {{"model", to_json(m.model_mm)}, {"command", to_json(m.command_mm)}};
  if (m.contour_mm.n > 0) json["contour"] = to_json(m.contour_mm);
  json["x"] = to_json(m.axis[0]);
  json["y"] = to_json(m.axis[1]);
  Json lines = Json::array();
  for (const Comparison& line : compare(options, m)) {
    Json one{{"what", line.what}, {"unit", line.unit}, {"ours", line.ours}};
    if (line.paper) one["paper"] = *line.paper;
    if (line.expected) {
      one["expected"] = *line.expected;
      one["tolerance"] = line.tolerance;
      one["within"] = line.good();
    }
    lines.push_back(one);
  }
  if (!lines.empty()) {
    json["comparison"] = lines;
    if (options.path.kind == kung::PathKind::kCircle) json["comparison_note"] = kCircleNote;
  }
  json["run"] = {{"points", result.points},
                 {"samples", result.samples.size()},
                 {"first_tick", result.first_tick},
                 {"end_tick", result.end_tick},
                 {"clock_ps", options.plant.clock_ps},
                 {"clocks", result.clocks},
                 {"clocks_evaluated", result.evaluated},
                 {"wakes", wakes_json(result.wakes)},
                 {"simulated_s", m.simulated_s},
                 {"wall_s", result.wall_s},
                 {"clocks_per_s", m.clocks_per_s},
                 {"real_time_factor", m.real_time_factor},
                 {"event_hash", fmt::format("{:016x}", result.event_hash)}};
  if (!result.waves.empty()) json["waves"] = waves_json(options, result);
  json["versions"] = versions_json();
  for (const Key& key : keys()) json["options"][key.name] = value_json(key.get(options));
  return json;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw ConfigError(fmt::format("{}: cannot be written", file.string()));
}

fs::path target_of(const std::string& out, const std::string& scenario) {
  return out.empty() ? fs::path("out") / scenario : fs::path(out);
}

int tell_end(const std::string& scenario, kung::EndReason end, const std::string& cause,
             const std::string& folder) {
  const int code = exit_code(end);
  if (code != 0) {
    fmt::print(stderr, "trammel: {}: {}{}; record kept in {}\n", scenario, end_text(end), cause,
               folder);
  }
  return code;
}

void write_lines(const fs::path& file, const std::function<void(fmt::ostream&)>& print) {
  try {
    auto out = fmt::output_file(file.string());
    print(out);
    out.close();
  } catch (const std::system_error&) {
    throw ConfigError(fmt::format("{}: cannot be written", file.string()));
  }
}

void write_trace(const fs::path& file, const kung::Options& options, const kung::Result& result) {
  write_lines(file, [&](fmt::ostream& out) {
    out.print("tick,t_s");
    for (const char a : {'x', 'y'}) {
      for (const char* column : {"command_m", "position_m", "model_m", "encoder_count"}) {
        out.print(",{}_{}", a, column);
      }
      for (const char* word :
           {"e", "de", "u", "v_star", "v", "i_q_ref", "i_d", "i_q", "v_d", "v_q"}) {
        out.print(",{}_{}", a, word);
      }
      out.print(",{0}_v_m_s,{0}_i_d_A,{0}_i_q_A,{0}_force_N", a);
    }
    out.print("\n");
    for (const kung::Sample& s : result.samples) {
      out.print("{},{:.8f}", s.tick, cosim::seconds_of(s.edge, options.plant.clock_ps));
      for (std::size_t a = 0; a < 2; ++a) {
        const kung::AxisSample& x = s.axis[a];
        const double count_m = options.plant.axis[a].encoder_count_m;
        out.print(",{:.6f},{:.9f},{:.9f},{}", command_m(x, count_m), x.x_true_m,
                  model_m(x, count_m), x.x_p);
        for (const std::int32_t word :
             {x.e, x.de, x.u, x.v_star, x.v, x.i_q_ref, x.i_d, x.i_q, x.v_d, x.v_q}) {
          out.print(",{}", word);
        }
        out.print(",{:.7g},{:.7g},{:.7g},{:.7g}", x.v_true_m_s, x.i_d_true_A, x.i_q_true_A,
                  x.force_N);
      }
      out.print("\n");
    }
  });
}

fs::path find_program(const std::string& name) {
  const char* const variable = std::getenv("PATH");
  std::string path = variable == nullptr ? "" : variable;
  path += ':';
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = path.find(':', begin);
    const fs::path file = fs::path(path.substr(begin, end - begin)) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return file;
    begin = end + 1;
  }
  return {};
}

std::string shell_word(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.string()) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  return text + "'";
}

const char* fault_text(kung::FaultCode code) {
  switch (code) {
    case kung::FaultCode::kNone: return "none";
    case kung::FaultCode::kTrip: return "external trip";
    case kung::FaultCode::kOverCurrent: return "over-current";
    case kung::FaultCode::kWatchdog: return "watchdog";
    case kung::FaultCode::kEncoder: return "encoder fault";
    case kung::FaultCode::kStroke: return "stroke exceeded";
  }
  return "unknown";
}

std::string cause_text(const kung::Fault& fault) {
  if (fault.code == kung::FaultCode::kNone) return "the processor's check: " + fault.processor;
  if (fault.code == kung::FaultCode::kTrip || fault.code == kung::FaultCode::kWatchdog) {
    return fault_text(fault.code);  // of no axis
  }
  return fmt::format("{} on axis {}", fault_text(fault.code), fault.axis == 0 ? 'X' : 'Y');
}

std::string promise_text(const cosim::BrokenPromise& promise, std::int64_t clock_ps) {
  return fmt::format("{} of {} at {:.8f} s, clock {} ({})", promise.name,
                     promise.instance.empty() ? "the chip" : promise.instance,
                     cosim::seconds_of(promise.edge, clock_ps), promise.edge, promise.place);
}

nlohmann::ordered_json promise_json(const cosim::BrokenPromise& promise) {
  return {{"name", promise.name},
          {"instance", promise.instance},
          {"place", promise.place},
          {"clock", promise.edge}};
}

const char* end_text(kung::EndReason end) {
  switch (end) {
    case kung::EndReason::kDone: return "done";
    case kung::EndReason::kFault: return "tripped";
    case kung::EndReason::kDiverged: return "diverged";
    case kung::EndReason::kTimeout: return "timeout";
    case kung::EndReason::kStopped: return "interrupted";
    case kung::EndReason::kPromise: return "promise broken";
  }
  return "unknown";
}

int exit_code(kung::EndReason end) {
  switch (end) {
    case kung::EndReason::kDone: return 0;
    case kung::EndReason::kStopped: return 130;
    case kung::EndReason::kPromise: return 4;
    default: return 5;
  }
}

}  // namespace trammel::testbench
