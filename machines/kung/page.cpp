// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "machines/kung/figures.hpp"
#include "machines/kung/machine.hpp"

namespace trammel::kung {
namespace fs = std::filesystem;
namespace {

using lab::corrupt;
using lab::is_list;
using lab::Json;
using lab::require_member;
using lab::RunFolder;

bool is_whole(const Json& json) { return json.is_number_integer(); }
bool is_whole_or_null(const Json& json) { return json.is_number_integer() || json.is_null(); }

// Distance of the table to the commanded path [m]; 0 before the first sample of the path.
Series contour(const RunFolder& run) {
  Points table, path;
  for (std::size_t k = run.first; k < run.rows; ++k) {
    table.push_back({run.columns.at("x_position_m")[k], run.columns.at("y_position_m")[k]});
    path.push_back({run.columns.at("x_command_m")[k], run.columns.at("y_command_m")[k]});
  }
  Series all;
  for (std::size_t k = 0; k < run.first; ++k) all.push_back(0);
  for (const double error : contour_error(table, path, kContourReach)) all.push_back(error);
  return all;
}

void check_detail(const fs::path& file, const Json& d) {
  for (const std::string axis : {"x", "y"}) {
    for (const std::string when : {"first", "last"}) {
      const std::string path = "/rules/" + axis + '/' + when;
      require_member(file, d, path, &Json::is_array);
      if (!is_list(d.at(Json::json_pointer(path)), 49, is_whole)) {
        corrupt(file, fmt::format("is corrupt: {} does not hold 49 rules", path));
      }
    }
    if (d.contains("moment") && d["moment"].is_object()) {
      const std::string path = "/moment/" + axis + "/steps";
      require_member(file, d, path, &Json::is_array);
      const auto step = [](const Json& one) { return is_list(one, 2, is_whole_or_null); };
      if (!is_list(d.at(Json::json_pointer(path)), 35, step)) {
        corrupt(file, fmt::format("is corrupt: {} does not hold 35 steps", path));
      }
    }
  }
  if (d.contains("gates") && d["gates"].is_object()) {
    require_member(file, d, "/gates/begin", &Json::is_number_integer);
    require_member(file, d, "/gates/end", &Json::is_number_integer);
    require_member(file, d, "/gates/edges", &Json::is_array);
    require_member(file, d, "/gates/compare", &Json::is_array);
    const auto edge = [](const Json& one) { return is_list(one, 2, is_whole); };
    const auto axis = [](const Json& one) { return is_list(one, 3, is_whole); };
    const auto period = [&](const Json& one) { return is_list(one, 2, axis); };
    if (!is_list(d["gates"]["edges"], 0, edge) || d["gates"]["edges"].empty() ||
        !is_list(d["gates"]["compare"], 0, period)) {
      corrupt(file, "is corrupt: /gates does not hold gate edges and compare values");
    }
  }
}

void complete(RunFolder& run) {
  const auto& ticks = run.columns["tick"];
  const auto first = run.metrics["run"]["first_tick"].get<double>();
  const auto begin = std::lower_bound(ticks.begin(), ticks.end(), first);
  if (begin != ticks.end()) run.first = static_cast<std::size_t>(begin - ticks.begin());
  if (run.metrics["options"]["path.kind"] != "square") {  // a square wave has no contour
    run.columns["contour_m"] = contour(run);
  }
}

}  // namespace

lab::Page page() {
  lab::Page page;
  page.texts = {"/options/controller", "/options/path.kind"};
  page.counts = {"/run/first_tick", "/run/end_tick", "/run/points"};
  page.numbers = {"/tracking/model/mean_mm", "/tracking/model/samples", "/tracking/command/mean_mm",
                  "/options/path.square_half_samples", "/options/path.square_low_m",
                  "/options/path.square_high_m"};
  for (const std::string axis : {"x", "y"}) {
    for (const char* figure : {"peak_current_A", "max_speed_m_s"}) {
      page.numbers.push_back('/' + axis + '/' + figure);
    }
    for (const char* key : {"dc_link_V", "encoder_count_m", "current_full_scale_A"}) {
      page.numbers.push_back("/options/plant." + axis + '.' + key);
    }
    for (const char* key : {"shift_e", "shift_de"}) {
      page.numbers.push_back("/options/gains." + axis + '.' + key);
    }
    page.objects.push_back('/' + axis + "/error_to_model");
  }
  page.derived = {{"contour_m", "m", 1e-8, {}, "distance to the commanded path", true}};
  page.has_detail = [](const Json&) { return true; };
  page.check_detail = check_detail;
  page.complete = complete;
  page.title = [](const Json& metrics) {
    const std::string controller = metrics["options"]["controller"];
    return fmt::format("{}, {}", metrics["scenario"].get<std::string>(),
                       controller == "fc" ? "FC" : "AFC");
  };
  return page;
}

}  // namespace trammel::kung
