// SPDX-License-Identifier: Apache-2.0
#include "testbench/report_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "testbench/config.hpp"
#include "testbench/delta_code.hpp"
#include "testbench/keys.hpp"
#include "testbench/metrics.hpp"

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void corrupt(const fs::path& file, const std::string& what) {
  throw ConfigError(fmt::format("{}: {}", file.string(), what));
}

std::ifstream open_file(const fs::path& file) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file, ignored)) {
    corrupt(file, fs::exists(file, ignored) ? "cannot be read"
                                            : "is missing: not a folder that `trammel run` wrote");
  }
  return in;
}

std::string read_file(const fs::path& file) {
  const std::ifstream in = open_file(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

Json read_json(const fs::path& file) {
  try {
    Json json = Json::parse(read_file(file));
    if (json.is_object()) return json;
  } catch (const Json::parse_error& error) {
    corrupt(file, fmt::format("is corrupt: no JSON at byte {}", error.byte));
  }
  corrupt(file, "is corrupt: not a JSON object");
}

// The member that `path` names must be there and of that type.
void require(const fs::path& file, const Json& json, const std::string& path,
             bool (Json::*is)() const noexcept) {
  const Json::json_pointer pointer(path);
  if (!json.contains(pointer)) corrupt(file, fmt::format("is corrupt: {} is missing", path));
  if (!(json.at(pointer).*is)()) {
    corrupt(file, fmt::format("is corrupt: {} is of a wrong kind", path));
  }
}

void check_metrics(const fs::path& file, const Json& m, const PageOf& page) {
  const auto each = [&](const std::vector<std::string>& paths, bool (Json::*is)() const noexcept) {
    for (const std::string& path : paths) require(file, m, path, is);
  };
  each({"/scenario", "/end", "/command", "/verdict", "/run/event_hash"}, &Json::is_string);
  each({"/run/samples"}, &Json::is_number_unsigned);
  each({"/run/simulated_s", "/run/clocks", "/run/clock_ps"}, &Json::is_number);
  each({"/options", "/versions"}, &Json::is_object);
  each(page.texts, &Json::is_string);
  each(page.counts, &Json::is_number_unsigned);
  each(page.numbers, &Json::is_number);
  each(page.objects, &Json::is_object);
}

bool is_whole(const Json& json) { return json.is_number_integer(); }
bool is_whole_or_null(const Json& json) { return json.is_number_integer() || json.is_null(); }

// An array of `size` entries (0: any number) that all are what `each` says.
template <class Each>
bool is_list(const Json& json, std::size_t size, Each each) {
  return json.is_array() && (size == 0 || json.size() == size) &&
         std::all_of(json.begin(), json.end(), each);
}

void check_detail(const fs::path& file, const Json& d) {
  for (const std::string axis : {"x", "y"}) {
    for (const std::string when : {"first", "last"}) {
      const std::string path = "/rules/" + axis + '/' + when;
      require(file, d, path, &Json::is_array);
      if (!is_list(d.at(Json::json_pointer(path)), 49, is_whole)) {
        corrupt(file, fmt::format("is corrupt: {} does not hold 49 rules", path));
      }
    }
    if (d.contains("moment") && d["moment"].is_object()) {
      const std::string path = "/moment/" + axis + "/steps";
      require(file, d, path, &Json::is_array);
      const auto step = [](const Json& one) { return is_list(one, 2, is_whole_or_null); };
      if (!is_list(d.at(Json::json_pointer(path)), 35, step)) {
        corrupt(file, fmt::format("is corrupt: {} does not hold 35 steps", path));
      }
    }
  }
  if (d.contains("gates") && d["gates"].is_object()) {
    require(file, d, "/gates/begin", &Json::is_number_integer);
    require(file, d, "/gates/end", &Json::is_number_integer);
    require(file, d, "/gates/edges", &Json::is_array);
    require(file, d, "/gates/compare", &Json::is_array);
    const auto edge = [](const Json& one) { return is_list(one, 2, is_whole); };
    const auto axis = [](const Json& one) { return is_list(one, 3, is_whole); };
    const auto period = [&](const Json& one) { return is_list(one, 2, axis); };
    if (!is_list(d["gates"]["edges"], 0, edge) || d["gates"]["edges"].empty() ||
        !is_list(d["gates"]["compare"], 0, period)) {
      corrupt(file, "is corrupt: /gates does not hold gate edges and compare values");
    }
  }
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts;
  std::stringstream in(line);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

// One line of a trace; false when it does not hold a number for each column.
bool read_values(const std::string& line, const std::vector<Series*>& columns) {
  const char* begin = line.data();
  const char* const end = begin + line.size();
  for (Series* const column : columns) {
    double value = 0;
    const auto [stop, code] = std::from_chars(begin, end, value);
    const bool last = column == columns.back();
    if (code != std::errc{} || !std::isfinite(value) || (last ? stop != end : *stop != ',')) {
      return false;
    }
    column->push_back(value);
    begin = stop + 1;
  }
  return true;
}

void read_trace(const fs::path& file, RunRecord& run) {
  std::ifstream in = open_file(file);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = split(line);
  if (names != run.page->columns) {
    corrupt(file, "is corrupt: line 1 does not name the columns of a trace");
  }

  std::vector<Series*> columns;
  for (const std::string& name : names) columns.push_back(&run.columns[name]);
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    if (in.eof() || !read_values(line, columns)) {  // the last line ends with a newline too
      corrupt(file, fmt::format("is corrupt: line {} does not hold {} numbers", number,
                                columns.size()));
    }
  }
  run.rows = columns.front()->size();
  const auto samples = run.metrics["run"]["samples"].get<std::size_t>();
  if (run.rows != samples) {
    corrupt(file, fmt::format("is corrupt: {} samples, but the run recorded {}", run.rows,
                              samples));
  }
}

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

RunRecord read_run(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw ConfigError(fmt::format("{}: {}", folder.string(),
                                  fs::exists(folder, ignored) ? "is not a folder"
                                                              : "no such folder"));
  }
  RunRecord run;
  run.folder = folder;
  const fs::path metrics = folder / "metrics.json";
  run.metrics = read_json(metrics);
  if (!run.metrics.contains("machine")) {
    corrupt(metrics, "names no machine: written by an older trammel; run it again");
  }
  run.page = &page_of(run.metrics["machine"], metrics);
  check_metrics(metrics, run.metrics, *run.page);
  if (run.page->has_detail) {
    run.detail = read_json(folder / "detail.json");
    check_detail(folder / "detail.json", run.detail);
  }
  read_trace(folder / "trace.csv", run);
  if (!run.page->has_detail) return run;
  const auto& ticks = run.columns["tick"];
  const auto first = run.metrics["run"]["first_tick"].get<double>();
  const auto begin = std::lower_bound(ticks.begin(), ticks.end(), first);
  if (begin != ticks.end()) run.first = static_cast<std::size_t>(begin - ticks.begin());
  if (run.metrics["options"]["path.kind"] != "square") {  // a square wave has no contour
    run.columns["contour_m"] = contour(run);
  }
  return run;
}

PageSeries page_series(const RunRecord& run, const std::vector<std::string>& names,
                       std::size_t most) {
  PageSeries page;
  page.channels = Json::array();
  page.stride = std::max<std::size_t>(1, (run.rows - run.first + most - 1) / most);
  std::string bytes;
  for (const auto& [name, values] : run.columns) {
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    const double lsb = run.page->lsb(name);
    const auto& flags = run.page->flags;
    const bool bits = std::find(flags.begin(), flags.end(), name) != flags.end();
    std::vector<std::int64_t> whole;
    for (std::size_t k = run.first; k < values.size(); k += page.stride) {
      const double value = std::clamp(std::round(values[k] / lsb), -static_cast<double>(kMaxCoded),
                                      static_cast<double>(kMaxCoded));
      whole.push_back(static_cast<std::int64_t>(value));
      const std::size_t next = std::min(values.size(), k + page.stride);
      for (std::size_t n = k; bits && n < next; ++n) {
        whole.back() |= static_cast<std::int64_t>(values[n]);
      }
    }
    const Coded coded = delta_code(whole);
    page.channels.push_back({{"name", name}, {"lsb", lsb}, {"order", coded.order}});
    bytes += coded.bytes;
    page.count = whole.size();
  }
  page.data = base64(deflate(bytes));
  return page;
}

}  // namespace trammel::testbench
