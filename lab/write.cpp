// SPDX-License-Identifier: Apache-2.0
#include "lab/write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string_view>

#include "host/child.hpp"
#include "host/files.hpp"
#include "host/text.hpp"
#include "lab/build_info.hpp"
#include "lab/inputs.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/report_page.hpp"
#include "lab/scenarios.hpp"
#include "lab/waves.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

Json activity_json(const cosim::RunResult& result) {
  Json clocks = Json::object();
  for (const auto& [domain, awake] : result.activity) clocks[domain] = awake;
  return clocks;
}

Json simulation_json(const cosim::RunResult& result) {
  const double simulated = result.seconds(result.clocks);
  const double wall = result.wall_s;
  return {{"samples", result.sample_count()},
          {"clock_ps", result.clock_ps},
          {"clocks", result.clocks},
          {"clocks_evaluated", result.evaluated},
          {"activity", activity_json(result)},
          {"simulated_s", simulated},
          {"wall_s", wall},
          {"clocks_per_s", wall > 0 ? static_cast<double>(result.clocks) / wall : 0},
          {"real_time_factor", wall > 0 ? simulated / wall : 0},
          {"event_hash", fmt::format("{:016x}", result.event_hash)}};
}

// The name that inject.fault has.
const std::string& fault_kind(const Settings& settings) {
  return cosim::fault_words()[static_cast<std::size_t>(settings.fault.kind)];
}

Json fault_json(const Settings& settings, const cosim::RunResult& result) {
  const cosim::FaultReport& report = result.fault_report;
  const auto after = [&](cosim::Clk edge) -> Json {
    return edge == cosim::kNever ? Json() : Json(result.seconds(edge - report.begin));
  };
  return {{"fault", fault_kind(settings)},
          {"begin_s", result.seconds(report.begin)},
          {"detected_by", report.by},
          {"detected_after_s", after(report.detected)},
          {"off_after_s", after(report.off)},
          {"stopping", report.stopping},
          {"peak_A", report.peak_A},
          {"at_stop", report.at_stop}};
}

void print_value(std::string& line, const Format& format, double value) {
  const auto out = std::back_inserter(line);
  switch (format.kind) {
    case Format::Kind::kWhole: fmt::format_to(out, "{}", std::llround(value)); break;
    case Format::Kind::kFixed: fmt::format_to(out, "{:.{}f}", value, format.digits); break;
    case Format::Kind::kGeneral: fmt::format_to(out, "{:.{}g}", value, format.digits); break;
  }
}

constexpr std::size_t kMostDrawn = 6000;  // samples: more make a heavy picture, not a better one

constexpr char kStyle[] =
    "set datafile separator ','\nset datafile columnheaders\n"
    "set grid lc rgb '#dddddd' lt 1\nset border lc rgb '#666666'\n"
    "set key outside top center horizontal samplen 2\n";

// A text for gnuplot, without what it takes for a quote or mark-up.
std::string quoted(const std::string& text) {
  std::string kept = "'";
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ' ') kept += c;
  }
  return kept + "'";
}

std::string assigned(const Key& key, const Settings& settings) {
  std::string name = key.name;
  std::replace(name.begin(), name.end(), '.', '_');
  const Value value = key.get(settings);
  if (const auto* flag = std::get_if<bool>(&value)) return fmt::format("{} = {:d}\n", name, *flag);
  const auto* const text = std::get_if<std::string>(&value);
  return fmt::format("{} = {}\n", name, text != nullptr ? quoted(*text) : value_text(value));
}

double time_of(const Record& record, std::size_t sample) {
  const ColumnTable& table = record.machine().columns();
  std::vector<double> values;
  table.read(*record.settings, *record.result, sample, values);
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (table.columns[n].name == "t_s") return values[n];
  }
  return 0;
}

bool run_gnuplot(const fs::path& folder, const std::string& script) {
  std::signal(SIGPIPE, SIG_IGN);  // a gnuplot that dies is a return value, not the end of us
  host::Child gnuplot({fs::absolute(host::find_program("gnuplot")).string(), "-"},
                      host::Child::Pipe::kToInput, folder);
  if (gnuplot.pipe() == nullptr) return false;
  const bool sent = std::fwrite(script.data(), 1, script.size(), gnuplot.pipe()) == script.size();
  return gnuplot.ended() && sent;
}

// gnuplot does not say so when the disk is full.
void check_picture(const fs::path& file) {
  const std::string text = host::read_text(file);
  const std::size_t end = text.find_last_not_of(" \n\r");
  constexpr std::string_view kEnd = "</svg>";
  if (end != std::string::npos && end + 1 >= kEnd.size() &&
      text.compare(end + 1 - kEnd.size(), kEnd.size(), kEnd) == 0) {
    return;
  }
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  const int error = descriptor < 0 ? errno : posix_fallocate(descriptor, 0, 1 << 20);
  if (descriptor >= 0) close(descriptor);
  throw host::ConfigError(
      fmt::format("{}: cannot be written: {}", file.string(),
                  error != 0 ? std::strerror(error) : "gnuplot left it incomplete"));
}

// Runs the gnuplot scripts machines/<name>/pictures/*.gp in the folder of a run, whose files they
// read. Their variables: every setting (path.kind is path_kind), the title, and the samples worth
// drawing, `first` to `last` at the times `from` and `to` [s], every `step`-th of them. Why there
// are none; "" where they are.
std::string draw_pictures(const Record& record, const fs::path& folder) {
  const Machine& machine = record.machine();
  std::vector<fs::path> scripts;
  std::error_code none;
  for (const auto& entry :
       fs::directory_iterator(machine_folder(machine.name) / "pictures", none)) {
    if (entry.path().extension() == ".gp") scripts.push_back(entry.path());
  }
  if (scripts.empty()) return "";
  Range drawn{0, record.result->sample_count()};
  if (machine.files.drawn != nullptr) drawn = machine.files.drawn(record);
  if (host::find_program("gnuplot").empty()) return "gnuplot is missing (see `trammel doctor`)";
  if (drawn.last < drawn.first + 2) return "there is nothing to draw";
  std::string variables = kStyle;
  for (const Key& key : machine.keys()) variables += assigned(key, *record.settings);
  variables += fmt::format(
      "title = {}\nfirst = {}\nlast = {}\nstep = {}\nfrom = {}\nto = {}\n",
      quoted(record.settings->scenario + (record.name.empty() ? "" : " " + record.name)),
      drawn.first, drawn.last - 1, (drawn.last - drawn.first) / kMostDrawn + 1,
      time_of(record, drawn.first), time_of(record, drawn.last - 1));
  const bool drawn_all = std::all_of(scripts.begin(), scripts.end(), [&](const fs::path& script) {
    return run_gnuplot(folder, variables + host::read_text(script) + "unset output\n");
  });
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".svg") check_picture(entry.path());
  }
  return drawn_all ? "" : "gnuplot failed";
}

// Share of the clocks that were evaluated, or of those that hold an event.
std::string evaluated_text(const Settings& settings, const cosim::RunResult& result) {
  const double share = 100 * static_cast<double>(result.evaluated) /
                       static_cast<double>(std::max<cosim::Clk>(1, result.clocks));
  if (settings.run.engine == cosim::Engine::kTwin) {
    return fmt::format("twin engine: {:.1f} % of the clocks hold an event", share);
  }
  if (!settings.machine().can.leap) {
    std::string text = "every clock evaluated: the chip declares no leap contract (docs/leap.md)";
    if (result.events > 0) {
      const double clocks = static_cast<double>(result.clocks);
      const double events = static_cast<double>(result.events);
      text += fmt::format("\n  with one, clocks that only count are leapt over: {:.3g} % hold an "
                          "event here, so at most {:.0f} times fewer",
                          100 * events / clocks, std::floor(clocks / events));
    }
    return text;
  }
  return fmt::format("{:.1f} % of the clocks evaluated, the others leapt over", share);
}

// An injected fault and what noticed it.
std::string injected_text(const Settings& settings, const cosim::RunResult& result) {
  const cosim::FaultReport& report = result.fault_report;
  if (report.begin == cosim::kNever) return "";
  std::string text = fmt::format("  injected {} at {:g} s: ", fault_kind(settings),
                                 result.seconds(report.begin));
  if (report.begin >= result.clocks) return text + "the run had ended by then\n";
  if (report.detected == cosim::kNever) return text + "not noticed\n";
  const double detected_s = result.seconds(report.detected - report.begin);
  text += fmt::format("noticed {} later: {}", host::time_text(detected_s, 3), report.by);
  if (report.off == cosim::kNever) return text + "; outputs not off\n";
  return text + fmt::format("; outputs off {} later, at rest after {:.4g} {}\n",
                            host::time_text(result.seconds(report.off - report.detected), 3),
                            report.stopping, report.unit);
}

}  // namespace

Json versions_json() {
  return {{"trammel", kVersion},   {"commit", kCommit},     {"verilator", kVerilator},
          {"systemc", kSystemC},   {"compiler", kCompiler}, {"build", kBuild}};
}

Json value_json(const Value& value) {
  return std::visit([](const auto& v) -> Json { return v; }, value);
}

Json metrics_json(const Record& record, const Origin& origin) {
  const Settings& settings = *record.settings;
  const Machine& machine = record.machine();
  const cosim::RunResult& result = *record.result;
  Json json;
  json["machine"] = machine.name;
  json["scenario"] = settings.scenario;
  json["command"] =
      origin.command.empty() ? repeat_command(settings, origin.folder) : origin.command;
  json["end"] = end_text(result.end);
  json["verdict"] = record.verdict;
  if (const std::string fault = result.fault_text(); !fault.empty()) json["fault"] = fault;
  if (result.assertion) {
    json["promise"] = {{"name", result.assertion->name},
                       {"instance", result.assertion->instance},
                       {"place", result.assertion->place},
                       {"clock", result.assertion->edge}};
  }
  put_figures(json, record.figures);
  for (const Record& companion : record.companions) {
    Json beside;
    put_figures(beside, companion.figures);
    beside["end"] = end_text(companion.result->end);
    json["compared"][companion.name] = beside;
  }
  json["run"] = simulation_json(result);
  if (result.fault_report.begin != cosim::kNever) {
    json["injected"] = fault_json(*record.settings, result);
  }
  if (machine.files.metrics != nullptr) machine.files.metrics(record, json);
  if (origin.more.is_object()) json.update(origin.more);
  if (!result.waves.empty()) json["waves"] = waves_json(settings, result);
  json["versions"] = versions_json();
  for (const Key& key : machine.keys()) {
    if (origin.left_out != nullptr && origin.left_out(key)) continue;
    json["options"][key.name] = value_json(key.get(settings));
  }
  return json;
}

void write_table(const fs::path& file, const std::vector<Column>& columns, std::size_t rows,
                 const std::function<void(std::size_t, std::vector<double>&)>& read) {
  host::write_lines(file, [&](const host::Put& put) {
    std::string line;
    for (const Column& column : columns) line += (line.empty() ? "" : ",") + column.name;
    put(line + '\n');
    std::vector<double> values;
    for (std::size_t k = 0; k < rows; ++k) {
      read(k, values);
      line.clear();
      for (std::size_t n = 0; n < values.size(); ++n) {
        if (n > 0) line += ',';
        print_value(line, columns[n].format, values[n]);
      }
      put(line += '\n');
    }
  });
}

void write_trace(const fs::path& file, const Record& record) {
  const ColumnTable& table = record.machine().columns();
  write_table(file, table.columns, record.result->sample_count(),
              [&](std::size_t k, std::vector<double>& values) {
                table.read(*record.settings, *record.result, k, values);
              });
}

Written write_record(const Record& record, const host::OutputFolder& folder, const Json& metrics,
                     const Origin& origin, bool page) {
  const Machine& machine = record.machine();
  const fs::path& scratch = folder.scratch();
  Written written;
  if (!finish_waves(*record.settings, *record.result, folder.target(), written.notes)) {
    written.code = 1;
  }
  host::write_text(scratch / "metrics.json", metrics.dump(2) + '\n');
  copy_inputs(*record.settings, scratch);
  const auto repeats = with_copies(*record.settings, scratch);
  host::write_text(scratch / "run.toml", origin.command.empty()
                                       ? run_toml(*repeats)
                                       : run_toml(*repeats, origin.command, origin.left_out));
  for (const auto& [name, content] : origin.files) host::write_text(scratch / name, content);
  write_trace(scratch / "trace.csv", record);
  if (machine.files.write != nullptr) machine.files.write(record, scratch);
  if (const std::string why = draw_pictures(record, scratch); !why.empty()) {
    written.notes.push_back("no pictures: " + why);
  }
  const Json detail = machine.files.detail == nullptr ? Json() : machine.files.detail(record);
  if (!detail.is_null()) host::write_text(scratch / "detail.json", detail.dump() + '\n');
  try {
    if (page) write_page({scratch}, scratch / "report.html");
    written.page = page;
  } catch (const std::exception& error) {  // a run is never lost because its page failed
    written.notes.push_back(
        fmt::format("no report: {}; the results are kept", host::reason_of(error)));
    written.code = 2;
  }
  return written;
}

std::string activity_text(const cosim::RunResult& result) {
  if (result.activity.empty()) {
    return "  clock domains: only the leaping RTL with run.domains tells\n";
  }
  const double clocks = static_cast<double>(std::max<cosim::Clk>(1, result.clocks));
  std::string text = "  clock domains, share of the clocks at which each was awake:\n";
  for (const auto& [domain, awake] : result.activity) {
    text += fmt::format("    {:<12} {:8.4f} %\n", domain,
                        100 * static_cast<double>(awake) / clocks);
  }
  return text;
}

std::string report_text(const Record& record, const std::string& folder, bool page) {
  const Settings& settings = *record.settings;
  const cosim::RunResult& result = *record.result;
  std::string text = fmt::format("{}{}: {}\n", settings.scenario,
                                 record.name.empty() ? "" : fmt::format(" ({})", record.name),
                                 record.verdict);
  if (!settings.description.empty()) text += fmt::format("  {}\n", settings.description);
  text += figures_text(record.figures);
  for (const Record& companion : record.companions) {
    if (!companion.printed) continue;
    text += fmt::format("\n  {}: {}\n{}", companion.name, companion.verdict,
                        figures_text(companion.figures));
  }
  text += injected_text(settings, result);
  if (record.machine().texts.remarks != nullptr) {
    for (const std::string& remark : record.machine().texts.remarks(record)) {
      text += remark.empty() ? "\n" : fmt::format("  {}\n", remark);
    }
  }
  const double simulated = result.seconds(result.clocks);
  text += fmt::format("\n  simulated {:.3f} s = {} clocks in {:.2f} s: real-time factor {:.3f}\n",
                      simulated, result.clocks, result.wall_s,
                      result.wall_s > 0 ? simulated / result.wall_s : 0);
  text += fmt::format("  {}\n", evaluated_text(settings, result));
  text += fmt::format("  results in {}\n", folder);
  if (page) text += fmt::format("  report: {}\n", (fs::path(folder) / "report.html").string());
  return text + waves_text(settings, result, folder);
}

}  // namespace trammel::lab
