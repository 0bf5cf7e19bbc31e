// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/page/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "lab/report_data.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/page/afc_steps.hpp"
#include "machines/kung/plan/axis.hpp"
#include "machines/kung/precision/spectrum.hpp"
#include "machines/kung/precision/trace.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/response.hpp"

namespace trammel::kung {
namespace fs = std::filesystem;
namespace {

using lab::corrupt;
using lab::is_list;
using lab::Json;
using lab::require_member;
using lab::RunFolder;

constexpr const char* kAxes[] = {"x", "y"};

bool is_whole(const Json& json) { return json.is_number_integer(); }
bool is_whole_or_null(const Json& json) { return json.is_number_integer() || json.is_null(); }

// Distance of the table from the commanded path [m]; 0 before the first sample of the path.
Series contour(const RunFolder& run) {
  Points table, path;
  for (std::size_t k = run.first; k < run.rows; ++k) {
    table.push_back({run.columns.at("x_position_m")[k], run.columns.at("y_position_m")[k]});
    path.push_back({run.columns.at("x_command_m")[k], run.columns.at("y_command_m")[k]});
  }
  Series all;
  for (std::size_t k = 0; k < run.first; ++k) all.push_back(0);
  const Json& options = run.metrics["options"];
  double lag_s = 0;
  for (const std::string axis : kAxes) {
    const double zeta = options["gains." + axis + ".zeta"];
    lag_s = std::max(lag_s, 2 * zeta / options["gains." + axis + ".omega_n_rad_s"].get<double>());
  }
  const std::size_t reach =
      contour_reach(lag_s, 1 / options["chip.position_Hz"].get<double>());
  for (const double error : contour_error(table, path, reach)) all.push_back(error);
  return all;
}

Json moment_json(const Options& options, const Moment& moment) {
  // Commands on the serial port may have changed the gains.
  if (moment.tick == 0 || !options.uart.empty()) return nullptr;
  Json json{{"tick", moment.tick}, {"edge", moment.edge}};
  for (std::size_t a = 0; a < 2; ++a) {
    const AfcSteps steps = afc_steps(plan_axis(options, a), moment.start[a]);
    const AxisSample& chip = moment.end[a];
    if (steps[5].result != chip.x_m || steps[22].result != chip.u ||
        steps[26].result != chip.v_star || steps[29].result != chip.i_q_ref) {
      return nullptr;  // the chip had other registers than the plan
    }
    for (const AfcStep& step : steps) {
      json[kAxes[a]]["steps"].push_back({step.product ? Json(*step.product) : Json(nullptr),
                                         step.result ? Json(*step.result) : Json(nullptr)});
    }
  }
  return json;
}

void check_response(const fs::path& file, const Json& d) {
  if (!d.contains("response")) return;
  require_member(file, d, "/response", &Json::is_object);
  const auto number = [](const Json& one) { return one.is_number(); };
  const auto row = [&](const Json& one) { return is_list(one, 5, number); };
  for (const auto& [name, loop] : d["response"].items()) {
    if (name != "position" && name != "speed" && name != "current") {
      corrupt(file, "is corrupt: /response has a loop other than position, speed, current");
    }
    for (const std::string axis : kAxes) {
      const std::string path = fmt::format("/response/{}/{}", name, axis);
      require_member(file, d, path, &Json::is_array);
      if (!is_list(loop[axis], 0, row)) {
        corrupt(file, fmt::format("is corrupt: {} does not hold rows of 5 numbers", path));
      }
    }
  }
}

Json gates_json(const GateWindow& window) {
  if (window.end == 0) return nullptr;
  Json edges = Json::array();
  for (const GateEdge& edge : window.edges) edges.push_back({edge.edge, edge.gates});
  Json json{{"begin", window.begin}, {"end", window.end}, {"edges", edges}};
  if (window.trip != cosim::kNever) json["trip"] = window.trip;
  json["compare"] = window.compare;
  return json;
}

// Frequency, gain and phase of the closed loop, then gain and phase of the open one.
Json response_json(const lab::Response& closed) {
  const lab::Response open = lab::opened(closed);
  const std::vector<double> phases = lab::phases(closed), open_phases = lab::phases(open);
  Json rows = Json::array();
  for (std::size_t k = 0; k < closed.size(); ++k) {
    rows.push_back({closed[k].hz, lab::decibel(closed[k].gain), phases[k],
                    lab::decibel(open[k].gain), open_phases[k]});
  }
  return rows;
}

void check_detail(const fs::path& file, const Json& d) {
  const auto check = [&](const std::string& path, std::size_t size, auto each, const char* what) {
    require_member(file, d, path, &Json::is_array);
    if (!is_list(d.at(Json::json_pointer(path)), size, each)) {
      corrupt(file, fmt::format("is corrupt: {} does not hold {}", path, what));
    }
  };
  const auto step = [](const Json& one) { return is_list(one, 2, is_whole_or_null); };
  const auto edge = [](const Json& one) { return is_list(one, 2, is_whole); };
  const auto axis = [](const Json& one) { return is_list(one, 3, is_whole); };
  const auto period = [&](const Json& one) { return is_list(one, 2, axis); };
  const auto there = [&](const char* name) { return d.contains(name) && d[name].is_object(); };
  for (const std::string name : kAxes) {
    check("/rules/" + name + "/first", 49, is_whole, "49 rules");
    check("/rules/" + name + "/last", 49, is_whole, "49 rules");
    if (there("moment")) check("/moment/" + name + "/steps", 35, step, "35 steps");
  }
  check_response(file, d);
  if (!there("gates")) return;
  require_member(file, d, "/gates/begin", &Json::is_number_integer);
  require_member(file, d, "/gates/end", &Json::is_number_integer);
  check("/gates/edges", 0, edge, "gate edges");
  check("/gates/compare", 0, period, "compare values");
  if (d["gates"]["edges"].empty()) corrupt(file, "is corrupt: /gates/edges is empty");
}

// Amplitudes of the errors of the path [um], of four digits.
Json spectrum_json(const RunFolder& run, const std::string& axis) {
  const Series& counted = run.columns.at("counted");
  std::size_t begin = 0, end = run.rows;
  while (begin < end && counted[begin] == 0) ++begin;
  while (end > begin && counted[end - 1] == 0) --end;
  const Series& error = run.columns.at(axis + "_error_um");
  Json all = Json::array();
  for (const double one :
       spectrum(end - begin, [&](std::size_t k) { return error[begin + k]; })) {
    all.push_back(std::stod(fmt::format("{:.3e}", one)));
  }
  return all;
}

void complete_precision(RunFolder& run) {
  lab::read_table(kPrecisionTrace, precision_columns(), run);
  for (const std::string axis : kAxes) run.detail["spectrum"][axis] = spectrum_json(run, axis);
}

void complete(RunFolder& run) {
  const auto& ticks = run.columns["tick"];
  const auto first = run.metrics["run"]["first_tick"].get<double>();
  const auto begin = std::lower_bound(ticks.begin(), ticks.end(), first);
  if (begin != ticks.end()) run.first = static_cast<std::size_t>(begin - ticks.begin());
  const Json& kind = run.metrics["options"]["path.kind"];
  if (kind != "square" && kind != "sweep") {  // these have no contour
    run.columns["contour_m"] = contour(run);
  }
  if (run.metrics["options"]["controller"] == "precision") complete_precision(run);
}

}  // namespace

Json detail_json(const Options& options, const Result& result) {
  const Snapshot& snapshot = result.snapshot;
  Json json;
  for (std::size_t a = 0; a < 2; ++a) {
    json["rules"][kAxes[a]] = {{"first", snapshot.rules_first[a]},
                               {"last", snapshot.rules_last[a]}};
  }
  // With other registers than the firmware's plan the chip computed something else.
  // The steps are those of the fuzzy controllers.
  const bool planned = options.controller != Controller::kPrecision &&
                       !options.fault.of_processor() && result.end != EndReason::kFault &&
                       options.fault.kind != cosim::FaultKind::kRegisterFlip;
  json["moment"] = planned ? moment_json(options, snapshot.moment) : Json(nullptr);
  json["gates"] = gates_json(snapshot.gates);
  for (std::size_t a = 0; options.path.is_sweep() && a < 2; ++a) {
    for (const LoopResponse& loop : responses(*plan_of(options), result, a)) {
      json["response"][loop.loop][kAxes[a]] = response_json(loop.closed);
    }
  }
  return json;
}

lab::Page page() {
  lab::Page page;
  page.texts = {"/options/controller", "/options/path.kind"};
  page.counts = {"/run/first_tick", "/run/end_tick", "/run/points"};
  page.numbers = {"/tracking/model/mean_mm", "/tracking/model/samples",
                  "/options/path.square_half_samples", "/options/path.square_low_m",
                  "/options/path.square_high_m", "/options/chip.position_Hz"};
  for (const std::string axis : kAxes) {
    for (const char* figure : {"peak_current_A", "max_speed_m_s"}) {
      page.numbers.push_back('/' + axis + '/' + figure);
    }
    for (const char* key : {"dc_link_V", "encoder_count_m", "current_full_scale_A"}) {
      page.numbers.push_back("/options/plant." + axis + '.' + key);
    }
    for (const char* key : {"shift_e", "shift_de", "omega_n_rad_s", "zeta"}) {
      page.numbers.push_back("/options/gains." + axis + '.' + key);
    }
    page.objects.push_back('/' + axis + "/error_to_model");
  }
  page.derived = {{"contour_m", "m", 1e-8, {}, "distance to the commanded path", true}};
  for (const lab::Column& column : precision_columns()) page.derived.push_back(column);
  page.has_detail = [](const Json&) { return true; };
  page.check_detail = check_detail;
  page.complete = complete;
  page.title = [](const Json& metrics) {
    const std::string controller = metrics["options"]["controller"];
    return fmt::format("{}, {}", metrics["scenario"].get<std::string>(),
                       controller == "fc" ? "FC" : controller == "afc" ? "AFC" : controller);
  };
  return page;
}

}  // namespace trammel::kung
