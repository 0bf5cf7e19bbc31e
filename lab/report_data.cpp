// SPDX-License-Identifier: Apache-2.0
#include "lab/report_data.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "host/files.hpp"
#include "host/output_folder.hpp"
#include "host/parse.hpp"
#include "lab/machines.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;

void corrupt(const fs::path& file, const std::string& what) {
  throw host::ConfigError(fmt::format("{}: {}", file.string(), what));
}

void require_member(const fs::path& file, const Json& json, const std::string& path,
                    bool (Json::*is)() const noexcept) {
  const Json::json_pointer pointer(path);
  if (!json.contains(pointer)) corrupt(file, fmt::format("is corrupt: {} is missing", path));
  if (!(json.at(pointer).*is)()) {
    corrupt(file, fmt::format("is corrupt: {} has the wrong type", path));
  }
}

namespace {

void require_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored)) return;
  corrupt(file, "is missing: not a folder that `trammel run` wrote");
}

Json read_json(const fs::path& file) {
  require_file(file);
  return host::parse_object(host::read_text(file), file);
}

void check_metrics(const fs::path& file, const Json& m, const Page& page) {
  const auto each = [&](const std::vector<std::string>& paths, bool (Json::*is)() const noexcept) {
    for (const std::string& path : paths) require_member(file, m, path, is);
  };
  each({"/scenario", "/end", "/command", "/verdict", "/run/event_hash"}, &Json::is_string);
  each({"/run/samples"}, &Json::is_number_unsigned);
  each({"/run/simulated_s", "/run/clocks", "/run/clock_ps"}, &Json::is_number);
  each({"/options", "/versions"}, &Json::is_object);
  each({"/figures"}, &Json::is_array);
  for (const Json& one : m["figures"]) {
    const bool good = one.is_object() && one.contains("id") && one["id"].is_string() &&
                      one.contains("name") && one["name"].is_string() && one.contains("unit") &&
                      one["unit"].is_string() && one.contains("value") &&
                      one["value"].is_number();
    if (!good) corrupt(file, "is corrupt: /figures does not hold id, name, unit and value");
  }
  each(page.texts, &Json::is_string);
  each(page.counts, &Json::is_number_unsigned);
  each(page.numbers, &Json::is_number);
  each(page.objects, &Json::is_object);
  each(page.arrays, &Json::is_array);
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

// As many rows as it has.
std::size_t read_rows(const fs::path& file, const std::vector<Column>& named, RunFolder& run) {
  using Line = host::InputFile::Line;
  host::InputFile in(file.string(), host::kMostTrace);
  std::string line;
  in.line(line);
  std::string names;
  std::vector<Series*> columns;
  for (const Column& column : named) {
    names += (names.empty() ? "" : ",") + column.name;
    columns.push_back(&run.columns[column.name]);
  }
  if (line != names) {
    corrupt(file, fmt::format("is corrupt: line 1 does not name the columns of a {}",
                              file.stem().string()));
  }
  Line end = in.line(line);
  for (std::size_t number = 2; end != Line::kNone; ++number, end = in.line(line)) {
    // The last line ends with a newline too.
    if (end == Line::kUnended || !read_values(line, columns)) {
      corrupt(file, fmt::format("is corrupt: line {} does not hold {} numbers", number,
                                columns.size()));
    }
  }
  return columns.front()->size();
}

void check_rows(const fs::path& file, std::size_t rows, std::size_t recorded) {
  if (rows == recorded) return;
  corrupt(file, fmt::format("is corrupt: {} samples, but the run recorded {}", rows, recorded));
}

void read_trace(const fs::path& file, RunFolder& run) {
  run.rows = read_rows(file, run.machine->columns().columns, run);
  check_rows(file, run.rows, run.metrics["run"]["samples"].get<std::size_t>());
}

}  // namespace

void read_table(const std::string& name, const std::vector<Column>& columns, RunFolder& run) {
  const fs::path file = run.folder / name;
  require_file(file);
  host::reading([&] { check_rows(file, read_rows(file, columns, run), run.rows); });
}

RunFolder read_run(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw host::ConfigError(fmt::format("{}: {}", folder.string(),
                                        fs::exists(folder, ignored) ? "is not a folder"
                                                              : "no such folder"));
  }
  RunFolder run;
  run.folder = folder;
  const fs::path metrics = folder / "metrics.json";
  run.metrics = read_json(metrics);
  if (!run.metrics.contains("machine")) {
    corrupt(metrics, "names no machine: written by an older trammel; run it again");
  }
  const Json& name = run.metrics["machine"];
  run.machine = name.is_string() ? find_machine(name.get<std::string>()) : nullptr;
  if (run.machine == nullptr) {
    need_all_machines();
    corrupt(metrics,
            fmt::format("is of the machine {}, which this trammel does not have; it has {}",
                        name.dump(), fmt::join(machine_names(), ", ")));
  }
  const Page& page = run.machine->page;
  check_metrics(metrics, run.metrics, page);
  if (page.has_detail != nullptr && page.has_detail(run.metrics)) {
    run.detail = read_json(folder / "detail.json");
    page.check_detail(folder / "detail.json", run.detail);
  }
  require_file(folder / "trace.csv");
  host::reading([&] { read_trace(folder / "trace.csv", run); });
  host::check_whole(folder);
  if (page.complete != nullptr) page.complete(run);
  return run;
}

namespace {

// zlib's format as base64.
std::string packed(const std::string& text) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  uLongf size = compressBound(text.size());
  std::vector<Bytef> bytes(size + 2);  // zeros behind them fill the last group
  const int code = compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()),
                             text.size(), Z_BEST_COMPRESSION);
  if (code != Z_OK) throw std::runtime_error(fmt::format("zlib failed with {}", code));
  std::string digits;
  for (std::size_t at = 0; at < size; at += 3) {
    const auto group = static_cast<unsigned>(bytes[at] << 16 | bytes[at + 1] << 8 | bytes[at + 2]);
    for (const unsigned shift : {18u, 12u, 6u, 0u}) digits += kDigits[group >> shift & 63u];
  }
  for (std::size_t k = 0; k < (3 - size % 3) % 3; ++k) digits[digits.size() - 1 - k] = '=';
  return digits;
}

// Values of a column in whole steps of its resolution, one in `stride` rows.
std::vector<std::int64_t> steps_of(const Column& column, const Series& values, std::size_t first,
                                   std::size_t stride) {
  constexpr double kMost = 1LL << 50;  // doubles hold these exactly, and so do their differences
  std::vector<std::int64_t> steps;
  for (std::size_t k = first; k < values.size(); k += stride) {
    const double value = std::round(values[k] / column.resolution);
    steps.push_back(static_cast<std::int64_t>(std::clamp(value, -kMost, kMost)));
    const std::size_t next = std::min(values.size(), k + stride);
    for (std::size_t n = k; column.bits && n < next; ++n) {
      steps.back() |= static_cast<std::int64_t>(values[n]);
    }
  }
  return steps;
}

}  // namespace

PageSeries page_series(const RunFolder& run, bool compared, std::size_t most) {
  PageSeries page;
  page.stride = std::max<std::size_t>(1, (run.rows - run.first + most - 1) / most);
  std::vector<Column> columns = run.machine->columns().columns;
  const auto& derived = run.machine->page.derived;
  columns.insert(columns.end(), derived.begin(), derived.end());
  for (const Column& column : columns) {
    const auto found = run.columns.find(column.name);
    if (found == run.columns.end() || (compared && !column.compared)) continue;
    std::vector<std::int64_t> steps = steps_of(column, found->second, run.first, page.stride);
    page.count = steps.size();
    std::adjacent_difference(steps.begin(), steps.end(), steps.begin());
    page.channels.push_back({{"name", column.name}, {"unit", column.unit}, {"help", column.help},
                             {"lsb", column.resolution}, {"data", packed(Json(steps).dump())}});
  }
  return page;
}

}  // namespace trammel::lab
