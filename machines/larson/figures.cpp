// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine larson is judged by, and the columns of its trace.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machines/larson/machine_members.hpp"

namespace trammel::larson {
namespace {

using sw::LarsonOp;

// WTTBL and WHRTBL of a run.
struct Returns {
  std::size_t normal = 0, error = 0, refused = 0, places = 0;
  // [step] Most distance of the rotors from where WHRTBL had them at rest, and in motion; and that
  // of the platform at rest.
  double off = 0, ahead = 0, platform = 0;
};

double farthest(const std::array<double, 2>& at, const sw::StepPoint& from) {
  return std::max(std::fabs(at[0] - from.x), std::fabs(at[1] - from.y));
}

Returns returns_of(const Result& result) {
  Returns r;
  for (std::size_t k = 0; k < result.done.size(); ++k) {
    const sw::LarsonAnswer& answer = result.answers[k];
    switch (result.calls[k].call.op) {
      case LarsonOp::kWttbl: ++(answer.value == 1 ? r.normal : r.error); break;
      case LarsonOp::kAbstbl:
      case LarsonOp::kReltbl: r.refused += answer.value < 0 ? 1 : 0; break;
      case LarsonOp::kWhrtbl:
        if (const CallDone& done = result.done[k]; done.moving[0] || done.moving[1]) {
          r.ahead = std::max(r.ahead, farthest(done.at, answer.at));
        } else {
          ++r.places;
          r.off = std::max(r.off, farthest(done.at, answer.at));
          r.platform = std::max(r.platform, farthest(done.platform, answer.at));
        }
        break;
      default: break;
    }
  }
  return r;
}

std::string answer_text(const Result& result, std::size_t k) {
  const sw::LarsonAnswer& answer = result.answers[k];
  switch (result.calls[k].call.op) {
    case LarsonOp::kWttbl: return answer.value == 1 ? "normal" : "error";
    case LarsonOp::kWhrtbl: {
      const auto& moving = result.done[k].moving;
      return fmt::format("{} {}{}{}", answer.at.x, answer.at.y,
                         moving[0] || moving[1] ? ", in motion" : "",
                         answer.value == 0 ? "" : ", not calibrated");
    }
    case LarsonOp::kAbstbl:
    case LarsonOp::kReltbl:
      return answer.value == 0 ? "" : answer.value == -2 ? "moving" : "not calibrated";
    default: return "";
  }
}

constexpr std::size_t kMostCallsShown = 2000;  // in metrics.json

}  // namespace

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  const Returns returns = returns_of(result);
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile = "") {
    f.tile = tile;
    list.push_back(std::move(f));
  };
  using lab::count;
  using lab::figure;
  const double end_s = result.done.empty() ? 0 : result.seconds(result.done.back().edge);
  add(figure("script.time_s", "script", "until its last call", end_s, "s"), "Script");
  add(count("script.calls", "script", "calls", static_cast<double>(result.done.size())));
  add(count("script.normal", "WTTBL", "normal", static_cast<double>(returns.normal)));
  add(count("script.error", "WTTBL", "error", static_cast<double>(returns.error)),
      "Error returns");
  add(count("script.refused", "moves refused", "", static_cast<double>(returns.refused)));
  add(figure("script.off_step", "WHRTBL against the rotors", "at rest", returns.off, "step", 2),
      returns.places > 0 ? "Off at WHRTBL" : "");
  add(figure("script.ahead_step", "WHRTBL against the rotors", "in motion", returns.ahead, "step",
             2));
  add(figure("script.platform_off_step", "WHRTBL against the platform", "at rest", returns.platform,
             "step", 2));
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string axis = k == 0 ? "X" : "Y", id = k == 0 ? "x." : "y.";
    const bool tile = k == 0;
    const plant::StepperPeaks& peaks = result.peaks[k];
    add(count(id + "pulses", "pulses", axis, result.pulses[k]));
    add(count(id + "lost_step", "steps lost", axis, result.lost[k], "steps"),
        tile ? "Lost by X" : "Lost by Y");
    add(count(id + "slips", "slips", axis, static_cast<double>(result.slips[k].size())));
    add(count(id + "breaches", "pulses without a step", axis,
              static_cast<double>(result.breaches[k].size())));
    add(figure(id + "max_torque_N_m", "largest torque", axis, peaks.torque, "N m", 3));
    add(figure(id + "mean_current_A", "mean current of all phases", axis,
               result.mean_current[k], "A", 2));
    add(figure(id + "max_power_W", "largest power at the shaft", axis, peaks.power, "W", 2));
    add(figure(id + "max_angle_step", "load angle", axis, peaks.angle, "step", 2),
        tile ? "Load angle of X" : "");
    add(figure(id + "max_rate", "largest rate", axis, peaks.speed, "step/s", 0));
    add(count(id + "max_waiting", "pulses that wait", axis, peaks.waiting));
    add(figure(id + "travel_step", "travel", axis, result.travel[k], "step", 0));
    add(figure(id + "end_step", "end", axis, result.end_at[k], "step", 2));
  }
  add(count("interrupts", "interrupts of the chip", "", result.interrupts), "Interrupts");
  add(count("err_byte", "byte writes", "", result.err_byte));
  for (lab::Figure& one : published_figures(options, result)) add(std::move(one));
  return list;
}

std::vector<std::string> remarks(const lab::Record& record) {
  const Result& result = result_of(record);
  std::vector<std::string> lines;
  constexpr std::size_t kLines = 12;
  for (std::size_t k = 0; k < result.done.size(); ++k) {
    const std::string answer = answer_text(result, k);
    if (answer.empty()) continue;
    if (lines.size() == kLines) {
      lines.push_back("... all answers are in metrics.json and on the page");
      break;
    }
    lines.push_back(fmt::format("{:10.4f} s  {}: {}",
                                result.seconds(result.done[k].edge), result.calls[k].text, answer));
  }
  return lines;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  const Result& result = result_of(record);
  const auto seconds = [&](cosim::Clk edge) {
    return result.seconds(edge);
  };
  auto& events = json["events"] = nlohmann::ordered_json::array();
  for (const Event& one : result.happened) {
    events.push_back({{"time_s", seconds(one.edge)}, {"axis", one.axis == 0 ? "x" : "y"},
                      {"what", one.what}, {"at_step", one.at}, {"count", one.count},
                      {"status", one.status}});
  }
  json["event_count"] = result.happened_count;
  auto& calls = json["calls"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < std::min(result.done.size(), kMostCallsShown); ++k) {
    const CallDone& done = result.done[k];
    calls.push_back({{"time_s", seconds(done.edge)}, {"line", result.calls[k].line},
                     {"call", result.calls[k].text}, {"answer", answer_text(result, k)},
                     {"x_step", done.at[0]}, {"y_step", done.at[1]}});
  }
}

const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    using Table = lab::Columns<Options, Result>;
    using At = Table::At;
    using lab::fixed;
    Table t;
    t.add({"t_s", "s", 1e-8, fixed(8), "time from the start of the run"},
          [](const At& at) { return at.result.seconds(at.sample.edge); });
    t.add({"call", "", 1, {}, "calls of the script that have ended", true},
          [](const At& at) { return static_cast<double>(at.sample.call); });
    t.add({"switches", "", 1, {}, "closed: bits X low, X high, Y low, Y high", false, true},
          [](const At& at) { return static_cast<double>(at.sample.switches); });
    t.add({"irq", "", 1, {}, "the chip or the timer interrupts", false, true},
          [](const At& at) { return at.sample.irq ? 1.0 : 0.0; });
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string axis = k == 0 ? "x_" : "y_";
      const auto add = [&](const char* name, lab::Column column, auto get) {
        column.name = axis + name;
        t.add(column, [k, get](const At& at) {
          return static_cast<double>(std::invoke(get, at.sample.axis[k]));
        });
      };
      add("asked_step", {"", "step", 1, {}, "where the pulses of the interface have it", true},
          &AxisSample::asked);
      add("step", {"", "step", 1, {}, "where the translator is", true}, &AxisSample::step);
      add("at_step", {"", "step", 1e-3, fixed(4), "where the rotor is", true}, &AxisSample::at);
      add("speed_step_s", {"", "step/s", 1e-1, fixed(2), "speed of the rotor", true},
          &AxisSample::speed);
      add("angle_step", {"", "step", 1e-3, fixed(4), "load angle: how far the rotor is behind",
                         true},
          &AxisSample::angle);
      add("rate_step_s", {"", "step/s", 1e-1, fixed(2), "rate of the translator"},
          &AxisSample::rate);
      add("platform_step", {"", "step", 1e-3, fixed(4), "where the platform is"},
          &AxisSample::platform);
      add("torque_N_m", {"", "N m", 1e-4, fixed(5), "torque of the motor's currents"},
          &AxisSample::torque);
      add("current_A", {"", "A", 1e-2, fixed(2), "current of all phases"}, &AxisSample::current);
      add("power_W", {"", "W", 1e-3, fixed(3), "power at the shaft"}, &AxisSample::power);
      add("waiting", {"", "", 1, {}, "pulses in the buffer"}, &AxisSample::waiting);
      add("count", {"", "", 1, {}, "count register"},
          [](const AxisSample& a) { return a.words & 0xFFFF; });
      add("status", {"", "", 1, {}, "rate and status word", false, true},
          [](const AxisSample& a) { return a.words >> 16; });
    }
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::larson
