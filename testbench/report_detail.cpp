// SPDX-License-Identifier: Apache-2.0
#include "testbench/report_detail.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

bool is_whole(const Json& json) { return json.is_number_integer(); }
bool is_whole_or_null(const Json& json) { return json.is_number_integer() || json.is_null(); }

// An array of `size` entries (0: any number) that all are what `each` says.
template <class Each>
bool is_list(const Json& json, std::size_t size, Each each) {
  return json.is_array() && (size == 0 || json.size() == size) &&
         std::all_of(json.begin(), json.end(), each);
}

bool is_figure(const Json& json) { return json.is_number(); }

// Distance of the table to the commanded path [m]; 0 before the first sample of the path.
Series contour(const RunRecord& run) {
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

}  // namespace

void check_kung_detail(const fs::path& file, const Json& d) {
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

void complete_kung(RunRecord& run) {
  const auto& ticks = run.columns["tick"];
  const auto first = run.metrics["run"]["first_tick"].get<double>();
  const auto begin = std::lower_bound(ticks.begin(), ticks.end(), first);
  if (begin != ticks.end()) run.first = static_cast<std::size_t>(begin - ticks.begin());
  if (run.metrics["options"]["path.kind"] != "square") {  // a square wave has no contour
    run.columns["contour_m"] = contour(run);
  }
}

void check_mcafee_detail(const fs::path& file, const Json& d) {
  require_member(file, d, "/rows/c", &Json::is_array);
  require_member(file, d, "/contour_step_s", &Json::is_number);
  require_member(file, d, "/contours", &Json::is_array);
  const std::size_t rows = d["rows"]["c"].size();
  for (const char* name : {"c", "cc", "vx", "vy", "x_mm", "y_mm"}) {
    const std::size_t values = rows + (std::string(name).find("_mm") == std::string::npos ? 0 : 1);
    const std::string path = std::string("/rows/") + name;
    require_member(file, d, path, &Json::is_array);
    if (rows == 0 || !is_list(d.at(Json::json_pointer(path)), values, is_figure)) {
      corrupt(file, fmt::format("is corrupt: {} does not hold {} numbers", path, values));
    }
  }
  const auto run = [](const Json& one) {
    return one.is_object() && one.contains("name") && one["name"].is_string() &&
           one.contains("mm") && is_list(one["mm"], 0, is_figure);
  };
  if (d["contours"].empty() || !is_list(d["contours"], 0, run)) {
    corrupt(file, "is corrupt: /contours does not hold names and contour errors");
  }
}

void complete_mcafee(RunRecord& run) {
  run.first = std::min(run.rows, run.metrics["run"]["first_sample"].get<std::size_t>());
}

}  // namespace trammel::testbench
