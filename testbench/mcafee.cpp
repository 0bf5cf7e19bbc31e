// SPDX-License-Identifier: Apache-2.0
#include "testbench/mcafee.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/part_json.hpp"
#include "testbench/progress.hpp"
#include "testbench/report_page.hpp"

namespace trammel::testbench {
namespace {

using sw::McafeeStage;

constexpr std::size_t kShownWarnings = 5;
constexpr int kMostFeed = 254;  // what the feed rate gives at most

bool same_target(const mcafee::Sample& a, const mcafee::Sample& b) {
  return a.axis[0].words.position == b.axis[0].words.position &&
         a.axis[1].words.position == b.axis[1].words.position;
}

constexpr const char* kSwitches[] = {"low switch", "high switch"};

nlohmann::ordered_json figures_json(const mcafee::Result& result, const McafeeMetrics& m) {
  nlohmann::ordered_json json{{"time_s", m.moving_s}};
  if (!m.contour_mm.empty()) {
    json["rows"] = result.samples.empty() ? 0 : result.samples.back().row;
    json["contour_max_mm"] = m.contour_max_mm;
    json["contour_max_s"] = m.contour_max_s;
    json["contour_rms_mm"] = m.contour_rms_mm;
    json["contour_end_mm"] = m.contour_end_mm;
  }
  json["max_error_counts"] = m.max_error_counts;
  json["max_speed_mm_s"] = m.max_speed_mm_s;
  json["max_desired_mm_s"] = m.max_desired_mm_s;
  json["max_current_A"] = m.max_current_A;
  return json;
}

nlohmann::ordered_json events_json(const std::vector<McafeeMetrics::Event>& events) {
  auto all = nlohmann::ordered_json::array();
  for (const McafeeMetrics::Event& one : events) {
    all.push_back({{"sample", one.sample}, {"time_s", one.time_s},
                   {"axis", one.axis == 0 ? "x" : "y"}, {"what", one.what},
                   {"desired_count", one.desired}, {"real_count", one.real},
                   {"status", one.status}});
  }
  return all;
}

nlohmann::ordered_json run_json(const mcafee::Options& options,
                                const std::vector<McafeeRun>& runs) {
  const mcafee::Result& result = runs.front().result;
  const McafeeMetrics& m = runs.front().metrics;
  nlohmann::ordered_json json = head_json(options, result, repeat_command(options));
  json["motion"] = figures_json(result, m);
  json["real_count"] = result.real;
  if (options.stage == McafeeStage::kRead) json["readings"] = result.readings;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    json["compared"][runs[k].name] = figures_json(runs[k].result, runs[k].metrics);
    json["compared"][runs[k].name]["end"] = end_text(runs[k].result.end);
  }
  json["events"] = events_json(m.events);
  json["run"] = simulation_json(result, options.stage_axis.clock_ps);
  json["run"]["first_sample"] = options.stage == McafeeStage::kTrack ? m.first : 0;
  if (!result.waves.empty()) json["waves"] = waves_json(options, result);
  json["versions"] = versions_json();
  for (const auto& key : keys_of<mcafee::Options>()) {
    json["options"][key.name] = value_json(key.get(options));
  }
  return json;
}

void write_tracked(const std::filesystem::path& file, const mcafee::Options& options,
                   const McafeeRun& run) {
  write_lines(file, [&](fmt::ostream& out) {
    out.print("t_s,row,v,limits,contour_mm");
    for (const char axis : {'x', 'y'}) {
      out.print(",{0}_desired_count,{0}_desired_speed,{0}_real_count,{0}_mm,{0}_mm_s,{0}_e,{0}_p,"
                "{0}_i,{0}_d,{0}_output,{0}_status,{0}_host_irq,{0}_i_A,{0}_u_V", axis);
    }
    out.print("\n");
    for (std::size_t k = 0; k < run.result.samples.size(); ++k) {
      const mcafee::Sample s = run.result.samples[k];
      const double contour = run.metrics.contour_mm.empty() ? 0 : run.metrics.contour_mm[k];
      out.print("{:.8f},{},{},{},{:.5f}", cosim::seconds_of(s.edge, options.stage_axis.clock_ps),
                s.row, s.v, s.limits, contour);
      for (const mcafee::AxisSample& a : s.axis) {
        const lm628::Words& w = a.words;
        out.print(",{:.5f},{:.5f},{},{:.5f},{:.4f},{},{},{},{},{},{},{},{:.5g},{:.5g}",
                  static_cast<double>(w.position) / kPerCount,
                  static_cast<double>(w.speed) / kPerCount, w.actual, a.x_mm, a.mm_s, w.error,
                  w.proportional, w.integral, w.derivative, w.output, w.status,
                  a.host_irq ? 1 : 0, a.i, a.volt);
      }
      out.print("\n");
    }
  });
}

std::string figures_line(const McafeeRun& run) {
  const McafeeMetrics& m = run.metrics;
  std::string text = fmt::format("  {:<22}{:.3f} s", run.name, m.moving_s);
  if (!m.contour_mm.empty()) {
    text += fmt::format(", contour error {:.4f} mm at most, {:.4f} mm rms", m.contour_max_mm,
                        m.contour_rms_mm);
  }
  return text + '\n';
}

std::string text_report(const mcafee::Options& options, const std::vector<McafeeRun>& runs,
                        const std::string& folder, bool pictures, const std::string& page) {
  const mcafee::Result& result = runs.front().result;
  const McafeeMetrics& m = runs.front().metrics;
  std::string text = fmt::format("{}: {}{}\n", options.scenario, end_text(result.end),
                                 result.fault.empty() ? "" : ": " + result.fault);
  if (!options.description.empty()) text += fmt::format("  {}\n", options.description);
  for (const McafeeRun& run : runs) text += figures_line(run);
  if (options.stage == McafeeStage::kRead) {
    text += fmt::format("  {:<22}{} of X, {} counts at the end\n", "readings", result.readings,
                        result.real[0]);
  } else {
    text += fmt::format("  {:<22}{}, {} counts\n", "real position", result.real[0], result.real[1]);
  }
  text += fmt::format("  {:<22}{} counts\n", "largest error", m.max_error_counts);
  text += fmt::format("  {:<22}{:.2f} mm/s, desired {:.2f}; current {:.2f} A\n", "largest speed",
                      m.max_speed_mm_s, m.max_desired_mm_s, m.max_current_A);
  text += fmt::format("  {}/metrics.json, trace.csv, run.toml{}{}\n", folder,
                      options.stage == McafeeStage::kTrack ? ", table.csv, detail.json" : "",
                      pictures ? ", path.svg, contour.svg" : "");
  if (!page.empty()) text += fmt::format("  report: {}\n", page);
  return text;
}

void warn(const std::string& scenario, const std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < std::min(warnings.size(), kShownWarnings); ++k) {
    fmt::print(stderr, "trammel: {}: {}\n", scenario, warnings[k]);
  }
  if (warnings.size() > kShownWarnings) {
    fmt::print(stderr, "trammel: {}: and {} more such rows\n", scenario,
               warnings.size() - kShownWarnings);
  }
}

nlohmann::ordered_json table_json(const mcafee::Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const sw::McafeeRow& row : table.rows) {
    rows.push_back({{"c", row.c}, {"cc", row.cc}, {"vx", row.vx}, {"vy", row.vy},
                    {"dx", row.dx}, {"dy", row.dy}});
  }
  return {{"row_mm", table.row_mm}, {"rows", rows}};
}

mcafee::Table table_of(const mcafee::Options& options) {
  try {
    return make_table(mcafee::Path(options.path), options.path, options.count_mm(),
                      options.travel_mm());
  } catch (const cosim::OptionsError& error) {
    throw ConfigError(error.what());
  } catch (const std::invalid_argument& error) {  // the file of points
    throw ConfigError(fmt::format("path.points_file: {}", error.what()));
  }
}

McafeeRun simulated(const std::string& name, const mcafee::Options& options,
                    const SimulateMcafee& simulate, const std::atomic<bool>& stop) {
  Progress progress(fmt::format("{}, {}", options.scenario, name));
  McafeeRun run{name, simulate(options, shown_in(progress, stop)), {}};
  run.metrics = evaluate(options, run.result);
  return run;
}

// What began with sample k.
void add_events(std::vector<McafeeMetrics::Event>& events, const mcafee::Sample& before,
                const mcafee::Sample& s, std::size_t k, std::int64_t clock_ps) {
  for (std::size_t a = 0; a < 2; ++a) {
    const lm628::Words& w = s.axis[a].words;
    const auto add = [&](const std::string& what) {
      events.push_back({k, cosim::seconds_of(s.edge, clock_ps), static_cast<int>(a), what,
                        w.position >> 16, w.actual, w.status});
    };
    if (s.axis[a].host_irq && !before.axis[a].host_irq) add("interrupt");
    const unsigned begun = w.status & ~before.axis[a].words.status;
    if ((begun & sw::lm628_status::kMotorOff) != 0) add("motor off");
    for (std::size_t end = 0; end < 2; ++end) {
      const unsigned open = s.limits >> (2 * a + end) & 1;
      if (open == (before.limits >> (2 * a + end) & 1)) continue;
      add(std::string(kSwitches[end]) + (open != 0 ? " open" : " closed"));
    }
  }
}

std::vector<McafeeRun> all_runs(const mcafee::Options& options, const SimulateMcafee& simulate,
                                const std::atomic<bool>& stop) {
  const bool tracks = options.stage == McafeeStage::kTrack;
  std::vector<McafeeRun> runs;
  const std::string pace = options.speed == 0 ? "self-paced" : fmt::format("v = {}", options.speed);
  runs.push_back(simulated(tracks ? pace : "motion", options, simulate, stop));
  if (!tracks || !options.compare || runs.front().result.end != cosim::EndReason::kDone) {
    return runs;
  }
  for (const int speed : {kMostFeed, options.least_speed}) {
    mcafee::Options other = options;
    other.speed = speed;
    other.run.wave = cosim::WaveFormat::kNone;  // they are of the first
    McafeeRun run = simulated(fmt::format("v = {}", speed), other, simulate, stop);
    if (run.result.end == cosim::EndReason::kStopped) {  // a part of it is nothing to compare with
      runs.front().result.end = cosim::EndReason::kStopped;
      break;
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

McafeeMetrics evaluate(const mcafee::Options& options, const mcafee::Result& result) {
  McafeeMetrics m;
  const bool tracks = options.stage == McafeeStage::kTrack;
  std::optional<mcafee::Path> path;
  if (tracks) path.emplace(options.path);
  const mcafee::PointMm origin = tracks ? path->at(0) : mcafee::PointMm{};
  constexpr double kReachMm = 10;  // a path may cross itself
  double squares = 0;
  std::size_t last = 0;
  bool begun = false;
  mcafee::Sample before;
  const double count_mm = options.count_mm();
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const mcafee::Sample s = result.samples[k];
    const bool moves = k > 0 && !same_target(s, before);
    if (k > 0) add_events(m.events, before, s, k, options.stage_axis.clock_ps);
    before = s;
    if (!begun && (tracks ? s.row > 0 : moves)) {
      begun = true;
      m.first = k;
    }
    if (begun && moves) last = k;
    if (tracks) {
      const mcafee::PointMm at{origin.x + s.axis[0].x_mm, origin.y + s.axis[1].x_mm};
      const double way = result.table.row_mm * s.row;
      m.contour_mm.push_back(path->distance(at, way, kReachMm));
      m.contour_end_mm = m.contour_mm.back();
      if (m.contour_end_mm > m.contour_max_mm) {
        m.contour_max_mm = m.contour_end_mm;
        m.contour_max_s = begun ? static_cast<double>(k - m.first) * mcafee::kSampleS : 0;
      }
      if (begun) squares += m.contour_end_mm * m.contour_end_mm;
    }
    for (const mcafee::AxisSample& a : s.axis) {
      m.max_error_counts = std::max<std::int64_t>(m.max_error_counts, std::abs(a.words.error));
      const double speed = std::fabs(static_cast<double>(a.words.speed)) / kPerCount * count_mm;
      m.max_desired_mm_s = std::max(m.max_desired_mm_s, speed / mcafee::kSampleS);
      m.max_speed_mm_s = std::max(m.max_speed_mm_s, std::fabs(a.mm_s));
      m.max_current_A = std::max(m.max_current_A, std::fabs(a.i));
    }
  }
  const auto moving = result.samples.size() - m.first;
  if (tracks && moving > 0) m.contour_rms_mm = std::sqrt(squares / static_cast<double>(moving));
  if (last > m.first) m.moving_s = static_cast<double>(last - m.first) * mcafee::kSampleS;
  return m;
}

void finish(const mcafee::Options& options) {
  check_engine(options.run);
  check_waves(options);
  check_motor(options.stage_axis.motor);
  if (options.stage == McafeeStage::kTrack) table_of(options);
}

int run_mcafee(mcafee::Options options, const RunArguments& arguments,
               const SimulateMcafee& simulate, const std::atomic<bool>& stop) {
  namespace fs = std::filesystem;
  announce_waves(options);
  if (options.stage == McafeeStage::kTrack) warn(options.scenario, table_of(options).warnings);
  OutputFolder folder(target_of(arguments.out, options.scenario));
  options.run.wave_file = wave_file(folder.scratch());
  const std::vector<McafeeRun> runs = all_runs(options, simulate, stop);
  const McafeeRun& run = runs.front();
  const int waves_code = finish_waves(options, run.result, folder.target());
  const nlohmann::ordered_json json = run_json(options, runs);
  write_text(folder.scratch() / "metrics.json", json.dump(2) + '\n');
  write_text(folder.scratch() / "run.toml", run_toml(options));
  write_tracked(folder.scratch() / "trace.csv", options, run);
  bool pictures = false;
  if (options.stage == McafeeStage::kTrack) {
    write_text(folder.scratch() / "table.csv", table_csv(run.result.table));
    write_text(folder.scratch() / "detail.json", tracking_json(options, runs).dump() + '\n');
    pictures = write_tracking_pictures(folder.scratch(), options, runs);
    if (!pictures) fmt::print(stderr, "trammel: no pictures: gnuplot is missing or failed\n");
  }
  const bool page = arguments.report && guarded([&] { write_run_page(folder.scratch()); });
  folder.publish();

  const fs::path target = fs::proximate(folder.target());
  const std::string shown = target.string();
  fmt::print("{}", arguments.json
                       ? json.dump(2) + '\n'
                       : text_report(options, runs, shown, pictures,
                                     page ? (target / "report.html").string() : "") +
                             waves_report(options, run.result, shown));
  int code = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::string name = k == 0 ? options.scenario : options.scenario + ", " + runs[k].name;
    const int its = tell_end(name, runs[k].result.end,
                             end_cause(runs[k].result, options.stage_axis.clock_ps), shown);
    if (code == 0) code = its;
  }
  return code != 0 ? code : waves_code;
}

int track(const RunArguments& arguments) {
  const mcafee::Options options = layered_machine<mcafee::Options>(
      find_scenario(arguments.scenario.empty() ? "mcafee-stage3" : arguments.scenario), arguments);
  const mcafee::Table table = table_of(options);
  warn("track", table.warnings);
  if (arguments.listing && arguments.json) throw ConfigError("track: --listing: not with --json");
  const std::string text = arguments.listing ? listing_text(table) : table_csv(table);
  if (!arguments.out.empty()) write_text(arguments.out, text);
  if (arguments.json) {
    fmt::print("{}\n", table_json(table).dump(2));
  } else if (arguments.out.empty()) {
    fmt::print("{}", text);
  } else {
    fmt::print("{}: {} rows of {:.5f} mm\n", arguments.out, table.rows.size(), table.row_mm);
  }
  return 0;
}

}  // namespace trammel::testbench
