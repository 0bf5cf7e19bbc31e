// SPDX-License-Identifier: Apache-2.0
//
// What the page of a run that tracks needs beyond its trace: detail.json, with the rows of its
// table and the contour errors of all runs; and the same as CSV, for the pictures.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/files.hpp"
#include "lab/report_data.hpp"
#include "machines/mcafee/machine_members.hpp"

namespace trammel::mcafee {
namespace {

using lab::Json;

constexpr std::size_t kMostContour = 6000;  // of the longest run's contour error

// The largest of each `stride` contour errors from the first row on, to 1e-5 mm.
Json contour_json(const Result& result, std::size_t stride) {
  Json values = Json::array();
  const auto& all = result.contour_mm;
  for (std::size_t k = result.first; k < all.size(); k += stride) {
    double worst = 0;
    for (std::size_t n = k; n < std::min(all.size(), k + stride); ++n) {
      worst = std::max(worst, all[n]);
    }
    values.push_back(std::round(worst * 1e5) / 1e5);
  }
  return values;
}

bool is_number(const Json& json) { return json.is_number(); }

void check_detail(const std::filesystem::path& file, const Json& d) {
  lab::require_member(file, d, "/contour_step_s", &Json::is_number);
  lab::require_member(file, d, "/row_mm", &Json::is_number);
  const auto check = [&](const char* name, std::size_t size, const char* what, auto each) {
    lab::require_member(file, d, std::string("/") + name, &Json::is_array);
    if (!d[name].empty() && lab::is_list(d[name], size, each)) return;
    lab::corrupt(file, fmt::format("is corrupt: /{} does not hold {}", name, what));
  };
  check("origin_mm", 2, "two numbers", is_number);
  check("rows", 0, "rows of six numbers",
        [](const Json& row) { return lab::is_list(row, 6, is_number); });
  check("contours", 0, "names and contour errors", [](const Json& one) {
    return one.is_object() && one.contains("name") && one["name"].is_string() &&
           one.contains("mm") && lab::is_list(one["mm"], 0, is_number);
  });
}

}  // namespace

Json tracking_json(const lab::Record& record) {
  if (!options_of(record).tracks()) return {};
  const Table& table = result_of(record).table;
  const PointMm origin = Path(options_of(record).path).at(0);
  Json rows = Json::array();
  for (const sw::McafeeRow& r : table.rows) rows.push_back({r.c, r.cc, r.vx, r.vy, r.dx, r.dy});
  std::vector<const lab::Record*> runs{&record};
  for (const lab::Record& beside : record.companions) runs.push_back(&beside);
  std::size_t longest = 1;
  for (const lab::Record* run : runs) {
    longest = std::max(longest, result_of(*run).contour_mm.size() - result_of(*run).first);
  }
  const std::size_t stride = (longest + kMostContour - 1) / kMostContour;
  Json contours = Json::array();
  for (const lab::Record* run : runs) {
    contours.push_back({{"name", run->name}, {"mm", contour_json(result_of(*run), stride)}});
  }
  return {{"row_mm", table.row_mm}, {"origin_mm", {origin.real(), origin.imag()}}, {"rows", rows},
          {"contour_step_s", static_cast<double>(stride) * options_of(record).sample_s()},
          {"contours", contours}};
}

// table.csv, the rows of the path; contours.csv, the contour errors of all runs over time.
void write_tables(const lab::Record& record, const std::filesystem::path& folder) {
  const Json detail = tracking_json(record);
  if (detail.is_null()) return;
  host::write_text(folder / "table.csv", table_csv(result_of(record).table));
  const Json& runs = detail["contours"];
  const double step_s = detail["contour_step_s"];
  std::string text = "t_s";
  std::size_t longest = 0;
  for (const Json& run : runs) {
    text += ',' + run["name"].get<std::string>();
    longest = std::max(longest, run["mm"].size());
  }
  for (std::size_t k = 0; k < longest; ++k) {
    text += fmt::format("\n{:.5f}", static_cast<double>(k) * step_s);
    for (const Json& run : runs) {
      text += k < run["mm"].size() ? fmt::format(",{}", run["mm"][k].get<double>()) : ",";
    }
  }
  host::write_text(folder / "contours.csv", text + '\n');
}

lab::Page page() {
  lab::Page page;
  page.texts = {"/options/program"};
  page.counts = {"/run/first_sample"};
  page.numbers = {"/motion/time_s", "/options/encoder.lines", "/options/stage.pitch_m"};
  page.arrays = {"/events", "/real_count"};
  page.has_detail = [](const Json& metrics) { return metrics["options"]["program"] == "track"; };
  page.check_detail = check_detail;
  page.complete = [](lab::RunFolder& run) {
    run.first = std::min(run.rows, run.metrics["run"]["first_sample"].get<std::size_t>());
  };
  return page;
}

}  // namespace trammel::mcafee
