// SPDX-License-Identifier: Apache-2.0
#include "testbench/an693.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/part_json.hpp"
#include "testbench/progress.hpp"
#include "testbench/report_page.hpp"

namespace trammel::testbench {
namespace {

constexpr double kSettledBand = 2.5;  // [count] that a step settles to

nlohmann::ordered_json interrupts_json(const std::vector<An693Metrics::Interrupt>& list) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& one : list) {
    all.push_back({{"sample", one.sample}, {"time_s", one.time_s}, {"desired_count", one.desired},
                   {"real_count", one.real}, {"status", one.status}});
  }
  return all;
}

void write_samples(const std::filesystem::path& file, const lm628::Options& options,
                   const lm628::Result& result) {
  write_lines(file, [&](fmt::ostream& out) {
    out.print("t_s,desired_count,desired_speed,real_count,theta_count,e,p,i,d,output,"
              "status,host_irq,omega_rad_s,i_A,u_V\n");
    for (const lm628::Sample& s : result.samples) {
      const lm628::Words& w = s.words;
      out.print("{:.8f},{:.5f},{:.5f},{},{:.4f},{},{},{},{},{},{},{},{:.7g},{:.7g},{:.6g}\n",
                seconds_at(options, s.edge), static_cast<double>(w.position) / kPerCount,
                static_cast<double>(w.speed) / kPerCount, w.actual, shaft_counts(options, s),
                w.error, w.proportional, w.integral, w.derivative, w.output, w.status,
                s.host_irq ? 1 : 0, s.omega, s.i, s.volt);
    }
  });
}

lm628::Result simulate_shown(const lm628::Options& options, const SimulateAn693& simulate,
                             const std::atomic<bool>& stop) {
  Progress progress(options.scenario);
  return simulate(options, shown_in(progress, stop));
}

}  // namespace

bool of_firmware(const KeyInfo& key) {
  return key.name == "program" || key.name == "run.platform" ||
         key.name == "run.diverged_counts" || key.name == "processor.interrupt_latency_clk" ||
         key.name.rfind("filter.", 0) == 0 || key.name.rfind("trajectory.", 0) == 0;
}

double shaft_counts(const lm628::Options& options, const lm628::Sample& s) {
  return s.theta / plant::MotorAxis::kTurn * options.plant.counts;
}

double seconds_at(const lm628::Options& options, cosim::Clk edge) {
  return cosim::seconds_of(edge, options.plant.clock_ps);
}

An693Metrics evaluate(const lm628::Options& options, const lm628::Result& result) {
  An693Metrics m;
  std::int64_t sample = 0, before = 0;
  int direction = 0;
  bool irq = false, first = true;
  for (const lm628::Sample& s : result.samples) {
    const lm628::Words& w = s.words;
    // The desired position follows the real one.
    const bool off = (w.status & sw::lm628_status::kMotorOff) != 0;
    const bool moves = !off && w.position != before;
    if (sample > 0 || moves) ++sample;
    if (moves) {
      first = first && (m.moving_samples == 0 || sample == m.moving_samples + 1);
      m.moving_samples = sample;
      direction = w.position > before ? 1 : -1;
    }
    before = w.position;
    const double beyond =
        (shaft_counts(options, s) - static_cast<double>(w.position) / kPerCount) * direction;
    // A step moves the desired position within one sample: what counts is where the shaft goes.
    if (sample > 0 && !off) m.overshoot_counts = std::max(m.overshoot_counts, beyond);
    if (first && std::fabs(beyond) > kSettledBand) {
      m.settled_s = static_cast<double>(sample) * lm628::kSampleS;
    }
    if (s.host_irq && !irq) {
      m.interrupts.push_back(
          {sample, seconds_at(options, s.edge), w.position >> 16, w.actual, w.status});
    }
    irq = s.host_irq;
    m.max_error_counts = std::max<std::int64_t>(m.max_error_counts, std::abs(w.error));
    m.max_speed_rev_s = std::max(m.max_speed_rev_s, std::fabs(s.omega) / plant::MotorAxis::kTurn);
    m.max_voltage_V = std::max(m.max_voltage_V, std::fabs(s.volt));
    m.max_current_A = std::max(m.max_current_A, std::fabs(s.i));
  }
  m.moving_s = static_cast<double>(m.moving_samples) * lm628::kSampleS;
  return m;
}

void check_motor(const plant::DcMotorConfig& c) {
  constexpr double kFastest = 1e5;  // [1/s], for steps of 16 us
  const double electrical = c.resistance / c.inductance;
  const double mechanical = (c.viscous + c.coulomb / c.friction_speed) / c.inertia;
  if (electrical > kFastest || mechanical > kFastest) {
    throw ConfigError(fmt::format(
        "{}: {:g} 1/s is above 1e5 1/s, the fastest that the motor's steps of 16 us can follow",
        electrical > kFastest ? "motor.resistance_ohm / motor.inductance_H"
                              : "motor friction / motor.inertia_kg_m2",
        std::max(electrical, mechanical)));
  }
}

// Rules that concern more than one key.
void finish(const lm628::Options& options) {
  check_engine(options.run);
  check_waves(options);
  check_motor(options.plant.motor);
  if (options.plant.counts % 4 != 0) {
    throw ConfigError(fmt::format("encoder.counts: value {} is no multiple of 4",
                                  options.plant.counts));
  }
}

nlohmann::ordered_json an693_json(const lm628::Options& options, const lm628::Result& result,
                                  const An693Metrics& m, const std::string& command,
                                  const An693Script* script) {
  nlohmann::ordered_json json = head_json(options, result, command);
  json["motion"] = {{"samples", m.moving_samples},
                    {"time_s", m.moving_s},
                    {"desired_count", result.desired},
                    {"real_count", result.real},
                    {"max_error_counts", m.max_error_counts},
                    {"overshoot_counts", m.overshoot_counts},
                    {"settled_s", m.settled_s},
                    {"max_speed_rev_s", m.max_speed_rev_s},
                    {"max_voltage_V", m.max_voltage_V},
                    {"max_current_A", m.max_current_A}};
  json["interrupts"] = interrupts_json(m.interrupts);
  json["run"] = simulation_json(result, options.plant.clock_ps);
  if (!result.waves.empty()) json["waves"] = waves_json(options, result);
  if (script != nullptr) json["script"] = script->answers;
  json["versions"] = versions_json();
  for (const auto& key : keys_of<lm628::Options>()) {
    if (script != nullptr && of_firmware(key)) continue;
    json["options"][key.name] = value_json(key.get(options));
  }
  return json;
}

std::string an693_report(const lm628::Options& options, const lm628::Result& result,
                         const An693Metrics& m, const std::string& folder,
                         const std::string& page) {
  std::string text = fmt::format("{}: {}{}\n", options.scenario, end_text(result.end),
                                 result.fault.empty() ? "" : ": " + result.fault);
  if (!options.description.empty()) text += fmt::format("  {}\n", options.description);
  const auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("  {:<22}{}\n", name, value);
  };
  line("motion", fmt::format("{} samples, {:.4f} s", m.moving_samples, m.moving_s));
  if (result.end == cosim::EndReason::kDone) {
    line("end position", fmt::format("desired {}, real {} counts", result.desired, result.real));
  }
  for (const auto& one : m.interrupts) {
    const auto when = one.sample == 0 ? "before the motion" : fmt::format("sample {}", one.sample);
    line("host interrupt", fmt::format("{}, {:.4f} s, desired {}, real {} counts", when,
                                       one.time_s, one.desired, one.real));
    if (&one - m.interrupts.data() == 9 && m.interrupts.size() > 10) {
      line("", fmt::format("and {} more", m.interrupts.size() - 10));
      break;
    }
  }
  line("overshoot", fmt::format("{:.2f} counts", m.overshoot_counts));
  if (options.program == sw::An693Program::kTuning) {
    line("first step settled", fmt::format("{:.1f} ms", 1e3 * m.settled_s));
  }
  line("largest error", fmt::format("{} counts", m.max_error_counts));
  line("largest speed", fmt::format("{:.3f} rev/s", m.max_speed_rev_s));
  line("largest voltage", fmt::format("{:.2f} V, current {:.3f} A", m.max_voltage_V,
                                      m.max_current_A));
  const double simulated = seconds_at(options, result.clocks);
  line("simulated", fmt::format("{:.3f} s in {:.2f} s, {:.1f} % of the clocks evaluated", simulated,
                                result.wall_s,
                                100 * static_cast<double>(result.evaluated) /
                                    static_cast<double>(std::max<cosim::Clk>(1, result.clocks))));
  text += fmt::format("  results in {}\n", folder);
  if (!page.empty()) text += fmt::format("  report: {}\n", page);
  return text + waves_report(options, result, folder);
}

bool write_an693_files(const std::filesystem::path& folder, const lm628::Options& options,
                       const lm628::Result& result, const nlohmann::ordered_json& metrics,
                       const An693Script* script, bool report) {
  write_text(folder / "metrics.json", metrics.dump(2) + '\n');
  if (script == nullptr) {
    write_text(folder / "run.toml", run_toml(options));
  } else {
    write_text(folder / "script.lm628", script->text);
    write_text(folder / "run.toml", run_toml(options, metrics["command"], of_firmware));
  }
  write_samples(folder / "trace.csv", options, result);
  if (!write_motion_picture(folder, options, result)) {
    fmt::print(stderr, "trammel: no picture: {}\n",
               find_program("gnuplot").empty() ? "gnuplot is missing (see `trammel doctor`)"
                                               : "there is nothing to draw");
  }
  return report && guarded([&] { write_run_page(folder); });
}

int run_an693(lm628::Options options, const RunArguments& arguments,
              const SimulateAn693& simulate, const std::atomic<bool>& stop) {
  namespace fs = std::filesystem;
  announce_waves(options);
  OutputFolder folder(target_of(arguments.out, options.scenario));
  options.run.wave_file = wave_file(folder.scratch());
  const lm628::Result result = simulate_shown(options, simulate, stop);
  const int waves_code = finish_waves(options, result, folder.target());
  const An693Metrics metrics = evaluate(options, result);
  const nlohmann::ordered_json json =
      an693_json(options, result, metrics, repeat_command(options), nullptr);
  const bool page =
      write_an693_files(folder.scratch(), options, result, json, nullptr, arguments.report);
  folder.publish();

  const fs::path shown = fs::proximate(folder.target());
  fmt::print("{}", arguments.json
                       ? json.dump(2) + '\n'
                       : an693_report(options, result, metrics, shown.string(),
                                      page ? (shown / "report.html").string() : ""));
  const int code = tell_end(options.scenario, result.end,
                            end_cause(result, options.plant.clock_ps), shown.string());
  return code != 0 ? code : waves_code;
}

}  // namespace trammel::testbench
