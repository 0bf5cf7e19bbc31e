// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <stdexcept>

#include "machines/kung/plan.hpp"
#include "machines/kung/afc_steps.hpp"
#include "machines/kung/machine.hpp"

namespace trammel::kung {
namespace {

using lab::Json;

constexpr const char* kAxis[] = {"x", "y"};

Json moment_json(const Options& options, const Moment& moment) {
  if (moment.tick == 0) return nullptr;
  Json json{{"tick", moment.tick}, {"edge", moment.edge}};
  for (std::size_t a = 0; a < 2; ++a) {
    const AfcTrace trace = trace_afc(plan_axis(options, a), moment.start[a]);
    const AxisSample& chip = moment.end[a];
    if (trace.end.x_m != chip.x_m || trace.end.u != chip.u || trace.end.v_star != chip.v_star ||
        trace.end.i_q_ref != chip.i_q_ref) {
      throw std::logic_error(fmt::format("steps of tick {}, axis {}, end with i_q* = {}, the chip "
                                         "with {}",
                                         moment.tick, kAxis[a], trace.end.i_q_ref, chip.i_q_ref));
    }
    Json steps = Json::array();
    for (const AfcStep& step : trace.steps) {
      steps.push_back({step.product ? Json(*step.product) : Json(nullptr),
                       step.result ? Json(*step.result) : Json(nullptr)});
    }
    json[kAxis[a]] = {{"steps", steps},
                      {"fired", trace.fired},
                      {"section_e", trace.section_e},
                      {"section_de", trace.section_de}};
  }
  return json;
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

}  // namespace

lab::Json detail_json(const Options& options, const Result& result) {
  const Detail& detail = result.detail;
  Json json;
  for (std::size_t a = 0; a < 2; ++a) {
    json["rules"][kAxis[a]] = {{"first", detail.rules_first[a]}, {"last", detail.rules_last[a]}};
  }
  json["moment"] = moment_json(options, detail.moment);
  json["gates"] = gates_json(detail.gates);
  return json;
}

}  // namespace trammel::kung
