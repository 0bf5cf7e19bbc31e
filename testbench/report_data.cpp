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

void corrupt(const fs::path& file, const std::string& what) {
  throw ConfigError(fmt::format("{}: {}", file.string(), what));
}

void require_member(const fs::path& file, const Json& json, const std::string& path,
                    bool (Json::*is)() const noexcept) {
  const Json::json_pointer pointer(path);
  if (!json.contains(pointer)) corrupt(file, fmt::format("is corrupt: {} is missing", path));
  if (!(json.at(pointer).*is)()) {
    corrupt(file, fmt::format("is corrupt: {} is of a wrong kind", path));
  }
}

namespace {

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

void check_metrics(const fs::path& file, const Json& m, const PageOf& page) {
  const auto each = [&](const std::vector<std::string>& paths, bool (Json::*is)() const noexcept) {
    for (const std::string& path : paths) require_member(file, m, path, is);
  };
  each({"/scenario", "/end", "/command", "/verdict", "/run/event_hash"}, &Json::is_string);
  each({"/run/samples"}, &Json::is_number_unsigned);
  each({"/run/simulated_s", "/run/clocks", "/run/clock_ps"}, &Json::is_number);
  each({"/options", "/versions"}, &Json::is_object);
  each(page.texts, &Json::is_string);
  each(page.counts, &Json::is_number_unsigned);
  each(page.numbers, &Json::is_number);
  each(page.objects, &Json::is_object);
  each(page.arrays, &Json::is_array);
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
  if (run.page->has_detail != nullptr && run.page->has_detail(run.metrics)) {
    run.detail = read_json(folder / "detail.json");
    run.page->check_detail(folder / "detail.json", run.detail);
  }
  read_trace(folder / "trace.csv", run);
  if (run.page->complete != nullptr) run.page->complete(run);
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
