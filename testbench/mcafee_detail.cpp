// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "testbench/mcafee.hpp"

namespace trammel::testbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostContour = 6000;  // of the longest run's contour error

double rounded(double mm) { return std::round(mm * 1e5) / 1e5; }

// Corners of the rows as the parts are told them, in the table's coordinates.
Json rows_json(const mcafee::Options& options, const mcafee::Table& table) {
  const mcafee::PointMm origin = mcafee::Path(options.path).at(0);
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

}  // namespace

nlohmann::ordered_json tracking_json(const mcafee::Options& options,
                                     const std::vector<McafeeRun>& runs) {
  std::size_t longest = 1;
  for (const McafeeRun& run : runs) {
    longest = std::max(longest, run.metrics.contour_mm.size() - run.metrics.first);
  }
  const std::size_t stride = (longest + kMostContour - 1) / kMostContour;
  Json contours = Json::array();
  for (const McafeeRun& run : runs) {
    const Series& all = run.metrics.contour_mm;
    Json values = Json::array();
    for (std::size_t k = run.metrics.first; k < all.size(); k += stride) {
      double worst = 0;
      for (std::size_t n = k; n < std::min(all.size(), k + stride); ++n) {
        worst = std::max(worst, all[n]);
      }
      values.push_back(rounded(worst));
    }
    contours.push_back({{"name", run.name}, {"mm", values}});
  }
  return {{"rows", rows_json(options, runs.front().result.table)},
          {"contour_step_s", static_cast<double>(stride) * mcafee::kSampleS},
          {"contours", contours}};
}

}  // namespace trammel::testbench
