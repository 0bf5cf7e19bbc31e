// SPDX-License-Identifier: Apache-2.0
#include "testbench/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/output.hpp"
#include "testbench/paper.hpp"

namespace trammel::testbench {
namespace {

using kung::Controller;
using kung::PathKind;

const char* controller_text(Controller c) { return c == Controller::kFc ? "FC" : "AFC"; }

std::string figure(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

// Share of the clocks evaluated, and what they were evaluated for.
std::string evaluated_text(const kung::Options& options, const kung::Result& result) {
  const auto evaluated = static_cast<double>(std::max<cosim::Clk>(1, result.evaluated));
  const auto clocks = static_cast<double>(std::max<cosim::Clk>(1, result.clocks));
  if (options.run.engine == kung::Engine::kTwin) {
    return fmt::format("  twin engine, no clocks: {:.1f} % of them hold an event\n",
                       100 * evaluated / clocks);
  }
  std::string text = fmt::format("  {:.1f} % of the clocks evaluated, the others leapt over",
                                 100 * evaluated / clocks);
  std::string causes;
  for (std::size_t n = 0; n < kung::kWakes; ++n) {
    const double share = 100 * static_cast<double>(result.wakes[n]) / evaluated;
    if (share < 0.05) continue;
    std::string name = kung::kWakeNames[n];
    std::replace(name.begin(), name.end(), '_', ' ');
    causes += fmt::format("{}{} {:.1f} %", causes.empty() ? "" : ", ", name, share);
  }
  if (!causes.empty()) text += "\n  of these: " + causes;
  return text + '\n';
}

std::string spread_line(const char* name, const Spread& s) {
  // A table thrown to its end stop has wide figures: a space stays between them.
  return fmt::format("  {:<25} {:>9.3f} {:>8.3f} {:>10.3f} {:>8.3f} {:>8.3f}\n", name, s.mean,
                     s.std, s.variance, s.rms, s.max);
}

std::string step_table(const Metrics& m) {
  std::string text = "  period            ";
  for (std::size_t p = 0; p < m.axis[0].periods.size(); ++p) text += fmt::format("{:>7}", p + 1);
  text += '\n';
  for (std::size_t a = 0; a < 2; ++a) {
    const char axis = a == 0 ? 'X' : 'Y';
    text += fmt::format("  overshoot {} (%)   ", axis);
    for (const HalfPeriod& p : m.axis[a].periods) {
      text += fmt::format(" {:>6.1f}", p.overshoot_percent);
    }
    text += fmt::format("\n  rms error {} (mm)  ", axis);
    for (const HalfPeriod& p : m.axis[a].periods) text += fmt::format(" {:>6.2f}", p.rms_mm);
    text += '\n';
  }
  return text;
}

std::string comparison_table(const std::vector<Comparison>& lines) {
  if (lines.empty()) return "";
  std::string text = fmt::format("\n  {:<28} {:>4} {:>8} {:>8} {:>9}\n", "", "", "ours", "paper",
                                 "expected");
  for (const Comparison& line : lines) {
    text += fmt::format("  {:<28} {:>4} {:>8.2f} {:>8} {:>9}{}\n", line.what, line.unit, line.ours,
                        figure(line.paper, 2), figure(line.expected, 2),
                        line.good() ? "" : "  outside its tolerance");
  }
  return text + "  paper: Kung et al. 2012; expected: bit-exact model, specification section 12\n";
}

const Finished* find(const std::vector<Finished>& runs, PathKind path, Controller controller) {
  for (const Finished& run : runs) {
    if (run.options.path.kind == path && run.options.controller == controller) return &run;
  }
  return nullptr;
}

std::optional<Comparison> line_of(const Finished* run, const std::string& what) {
  if (run == nullptr) return {};
  for (const Comparison& line : compare(run->options, run->metrics)) {
    if (line.what == what) return line;
  }
  return {};
}

}  // namespace

std::string verdict_text(const kung::Options& options, const kung::Result& result) {
  switch (result.end) {
    case kung::EndReason::kDone: return fmt::format("followed {} points", result.points);
    case kung::EndReason::kFault:
      if (result.fault.code == kung::FaultCode::kNone) {
        return fmt::format("TRIPPED: {}", cause_text(result.fault));
      }
      return fmt::format("TRIPPED: {} at 2 kHz tick {} ({:.4f} s)", cause_text(result.fault),
                         result.fault.tick, result.fault.tick * 0.5e-3);
    case kung::EndReason::kDiverged:
      return fmt::format("DIVERGED: error to the model above run.diverged_m = {:g}",
                         options.run.diverged_m);
    case kung::EndReason::kTimeout:
      return fmt::format("NOT FINISHED within run.max_s = {:g}", options.run.max_s);
    case kung::EndReason::kStopped: return "INTERRUPTED: results up to there";
    case kung::EndReason::kPromise:
      return "PROMISE BROKEN: " + promise_text(*result.promise, options.plant.clock_ps);
  }
  return "";
}

std::string run_report(const kung::Options& options, const kung::Result& result, const Metrics& m,
                       const std::string& folder, const std::string& page) {
  std::string text = fmt::format("{} ({}): {}\n", options.scenario,
                                 controller_text(options.controller),
                                 verdict_text(options, result));
  if (m.samples > 0) {
    text += fmt::format("\n  {:<25} {:>9} {:>8} {:>10} {:>8} {:>8}\n", "error (mm)", "mean", "std",
                        "var (mm2)", "rms", "max");
    text += spread_line("T(k) to reference model", m.model_mm);
    text += spread_line("T(k) to command", m.command_mm);
    if (m.contour_mm.n > 0) text += spread_line("contour", m.contour_mm);
    text += spread_line("X to reference model", m.axis[0].model_mm);
    text += spread_line("Y to reference model", m.axis[1].model_mm);
    text += fmt::format("\n  peak current X {:.2f} A, Y {:.2f} A; top speed X {:.3f} m/s, "
                        "Y {:.3f} m/s\n",
                        m.axis[0].peak_current_A, m.axis[1].peak_current_A,
                        m.axis[0].max_speed_m_s, m.axis[1].max_speed_m_s);
  }
  if (!m.axis[0].periods.empty()) text += '\n' + step_table(m);
  text += comparison_table(compare(options, m));
  if (options.path.kind == PathKind::kCircle && is_paper_experiment(options)) {
    text += fmt::format("  {}\n", kCircleNote);
  }
  text += fmt::format("\n  simulated {:.3f} s = {} clocks in {:.2f} s: {:.2f} million clocks/s, "
                      "real-time factor {:.3f}\n",
                      m.simulated_s, result.clocks, result.wall_s, m.clocks_per_s / 1e6,
                      m.real_time_factor);
  text += evaluated_text(options, result);
  text += fmt::format("  results in {}\n", folder);
  if (!page.empty()) text += fmt::format("  report: {}\n", page);
  return text;
}

std::string experiments_report(const std::vector<Finished>& runs) {
  std::string text = "Tracking error in mm (Kung Table 2), ours / paper\n\n";
  text += fmt::format("  {:<22}{:>16}{:>16}{:>16}\n", "", "circle", "window", "star");
  const PathKind paths[] = {PathKind::kCircle, PathKind::kWindow, PathKind::kStar};
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    for (const std::string what : {"mean", "variance", "standard deviation"}) {
      text += fmt::format("  {:<22}",
                          fmt::format("{} {}", controller_text(controller),
                                      what == "standard deviation" ? "std" : what));
      for (const PathKind path : paths) {
        const auto line = line_of(find(runs, path, controller), what);
        text += fmt::format("{:>16}", line ? fmt::format("{:.2f} / {}", line->ours,
                                                         figure(line->paper, 2))
                                           : "not finished");
      }
      text += '\n';
    }
  }
  for (const std::string what : {"mean", "variance"}) {
    text += fmt::format("  {:<22}", "AFC less " + what);
    for (const PathKind path : paths) {
      const auto fc = line_of(find(runs, path, Controller::kFc), what);
      const auto afc = line_of(find(runs, path, Controller::kAfc), what);
      text += fmt::format("{:>16}", fc && afc
                                        ? fmt::format("{:.1f} / {:.1f} %",
                                                      100 * (1 - afc->ours / fc->ours),
                                                      100 * (1 - *afc->paper / *fc->paper))
                                        : "-");
    }
    text += '\n';
  }
  text += fmt::format("  {}\n  the paper's spread has a square root but is labelled variance\n",
                      kCircleNote);

  text += "\nStep of 10 mm with 11 kg (Kung Figs. 11, 12), ours / paper\n\n";
  text += fmt::format("  {:<22}{:>16}{:>16}\n", "overshoot (%)", "first period", "last period");
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    for (const std::string axis : {"X", "Y"}) {
      const Finished* run = find(runs, PathKind::kSquare, controller);
      const auto first = line_of(run, "overshoot " + axis + ", first period");
      const auto last = line_of(run, "overshoot " + axis + ", last period");
      text += fmt::format("  {:<22}", fmt::format("{} {}", controller_text(controller), axis));
      text += fmt::format("{:>16}", first ? fmt::format("{:.1f} / {}", first->ours,
                                                        figure(first->paper, 1))
                                          : "not finished");
      text += fmt::format("{:>16}\n", last ? fmt::format("{:.1f} / {}", last->ours,
                                                         figure(last->paper, 1))
                                           : "not finished");
    }
  }
  text += "  the paper says of AFC only that it closely follows the model after 1 or 2 periods\n";
  if (const Finished* run = find(runs, PathKind::kSquare, Controller::kAfc)) {
    for (std::size_t a = 0; a < 2; ++a) {
      const auto& all = run->metrics.axis[a].periods;
      std::size_t period = 0;
      while (period < all.size() && all[period].overshoot_percent >= 5) ++period;
      text += fmt::format("  ours, {}: {}\n", a == 0 ? 'X' : 'Y',
                          period < all.size() ? fmt::format("below 5 % in period {}", period + 1)
                                              : "never below 5 %");
    }
  }
  return text;
}

}  // namespace trammel::testbench
