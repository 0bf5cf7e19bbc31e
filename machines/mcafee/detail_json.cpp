// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lab/report_data.hpp"
#include "machines/mcafee/machine.hpp"

namespace trammel::mcafee {
namespace {

using lab::corrupt;
using lab::is_list;
using lab::Json;
using lab::require_member;
using lab::RunFolder;

constexpr std::size_t kMostContour = 6000;  // of the longest run's contour error

double rounded(double mm) { return std::round(mm * 1e5) / 1e5; }

// Corners of the rows as the parts are told them, in the table's coordinates.
Json rows_json(const Options& options, const Table& table) {
  const PointMm origin = Path(options.path).at(0);
  Json json{{"row_mm", table.row_mm}};
  for (const char* name : {"x_mm", "y_mm", "c", "cc", "vx", "vy"}) json[name] = Json::array();
  int x = 0, y = 0;
  const auto corner = [&] {
    json["x_mm"].push_back(rounded(origin.x + x * options.count_mm()));
    json["y_mm"].push_back(rounded(origin.y + y * options.count_mm()));
  };
  corner();
  for (const sw::McafeeRow& row : table.rows) {
    x += row.dx;
    y += row.dy;
    corner();
    json["c"].push_back(row.c);
    json["cc"].push_back(row.cc);
    json["vx"].push_back(row.vx);
    json["vy"].push_back(row.vy);
  }
  return json;
}

bool is_figure(const Json& json) { return json.is_number(); }

void check_detail(const std::filesystem::path& file, const Json& d) {
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

void complete(RunFolder& run) {
  run.first = std::min(run.rows, run.metrics["run"]["first_sample"].get<std::size_t>());
}

}  // namespace

Json tracking_json(const lab::Record& record) {
  const std::vector<const lab::Record*> runs = runs_of(record);
  std::size_t longest = 1;
  for (const lab::Record* run : runs) {
    const Result& result = result_of(*run);
    longest = std::max(longest, result.contour_mm.size() - result.first);
  }
  const std::size_t stride = (longest + kMostContour - 1) / kMostContour;
  Json contours = Json::array();
  for (const lab::Record* run : runs) {
    const Result& result = result_of(*run);
    const auto& all = result.contour_mm;
    Json values = Json::array();
    for (std::size_t k = result.first; k < all.size(); k += stride) {
      double worst = 0;
      for (std::size_t n = k; n < std::min(all.size(), k + stride); ++n) {
        worst = std::max(worst, all[n]);
      }
      values.push_back(rounded(worst));
    }
    contours.push_back({{"name", run->name}, {"mm", values}});
  }
  return {{"rows", rows_json(options_of(record), result_of(record).table)},
          {"contour_step_s", static_cast<double>(stride) * kSampleS},
          {"contours", contours}};
}

lab::Page page() {
  lab::Page page;
  page.texts = {"/options/program"};
  page.counts = {"/run/first_sample"};
  page.numbers = {"/motion/time_s", "/options/encoder.lines", "/options/stage.pitch_m"};
  page.arrays = {"/events", "/real_count"};
  page.has_detail = [](const Json& metrics) { return metrics["options"]["program"] == "track"; };
  page.check_detail = check_detail;
  page.complete = complete;
  return page;
}

}  // namespace trammel::mcafee
