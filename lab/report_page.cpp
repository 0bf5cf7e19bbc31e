// SPDX-License-Identifier: Apache-2.0
#include "lab/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

#include "lab/errors.hpp"
#include "lab/files.hpp"
#include "lab/page_parts.hpp"
#include "lab/report_data.hpp"
#include "lab/write.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostValues = 16000;     // a series of one run's page
constexpr std::size_t kMostCompared = 6000;    // a series of one of several runs
constexpr std::size_t kMostRuns = 8;           // colours that can be told apart

Json run_json(const RunFolder& run, const std::string& label, bool compared, std::size_t most) {
  const PageSeries series = page_series(run, compared, most);
  return {{"label", label},           {"metrics", run.metrics}, {"detail", run.detail},
          {"channels", series.channels}, {"count", series.count},  {"stride", series.stride},
          {"data", series.data}};
}

// Default and meaning of each key.
Json keys_json(const Machine& machine) {
  const auto defaults = machine.defaults();
  Json all = Json::object();
  for (const Key& key : machine.keys()) {
    all[key.name] = {{"default", value_json(key.get(*defaults))}, {"help", key.help}};
  }
  return all;
}

std::string title_of(const RunFolder& run) {
  const auto own = run.machine->page.title;
  return own != nullptr ? own(run.metrics) : run.metrics["scenario"].get<std::string>();
}

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

// JSON inside a script element: nothing in it may end the element.
std::string script_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string page(const std::string& title, const Json& data) {
  std::string_view rest = kPageHtml;
  std::string text;
  const std::string json = script_text(data);
  const std::string safe_title = html_text(title);
  const std::pair<std::string_view, std::string_view> parts[] = {{"@TITLE@", safe_title},
                                                                 {"@STYLE@", kPageStyle},
                                                                 {"@DATA@", json},
                                                                 {"@SCRIPT@", kPageScript}};
  for (const auto& [mark, part] : parts) {
    const std::size_t at = rest.find(mark);
    text += rest.substr(0, at);
    text += part;
    rest = rest.substr(at + mark.size());
  }
  text += rest;
  return text;
}

void write_page_of(const RunFolder& run, const fs::path& file) {
  const std::string title = title_of(run);
  const Json data{{"kind", "run"}, {"machine", run.metrics["machine"]},
                  {"keys", keys_json(*run.machine)},
                  {"runs", {run_json(run, title, false, kMostValues)}}};
  replace_file(file, page(title + " - Trammel", data));
}

// The folders' names; with more of the path in front where two have the same.
std::vector<std::string> labels_of(const std::vector<fs::path>& folders) {
  std::vector<fs::path> full;
  for (const fs::path& folder : folders) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    full.push_back(path.has_filename() ? path : path.parent_path());
  }
  std::vector<std::string> labels;
  std::set<std::string> seen;
  for (const fs::path& path : full) labels.push_back(path.filename().string());
  if (std::set<std::string>(labels.begin(), labels.end()).size() == labels.size()) return labels;
  for (std::size_t k = 0; k < full.size(); ++k) {
    labels[k] = (full[k].parent_path().filename() / full[k].filename()).string();
    if (!seen.insert(labels[k]).second) labels[k] = full[k].string();
  }
  return labels;
}

std::string name_of(const fs::path& folder) {
  return folder.has_filename() ? folder.filename().string() : folder.string();
}

}  // namespace

void write_run_page(const fs::path& folder) {
  write_page_of(read_run(folder), folder / "report.html");
}

void write_comparison_page(const std::vector<fs::path>& folders, const fs::path& file) {
  if (folders.size() > kMostRuns) {
    throw ConfigError(fmt::format("report: {} runs: a page compares at most {}", folders.size(),
                                  kMostRuns));
  }
  const std::vector<std::string> labels = labels_of(folders);
  Json runs = Json::array();
  std::string machine;
  Json keys;
  for (std::size_t k = 0; k < folders.size(); ++k) {
    const RunFolder run = read_run(folders[k]);
    const std::string other = run.metrics["machine"];
    if (machine.empty()) {
      machine = other;
      keys = keys_json(*run.machine);
    }
    if (other != machine) {
      throw ConfigError(fmt::format("report: {} is a run of machine {} and {} one of {}: only runs "
                                    "of one machine can be compared",
                                    folders.front().string(), machine, folders[k].string(), other));
    }
    Json json = run_json(run, labels[k], true, kMostCompared);
    json.erase("detail");
    std::error_code ignored;
    if (fs::exists(folders[k] / "report.html", ignored)) {
      json["page"] = fs::proximate(folders[k] / "report.html",
                                   fs::absolute(file).parent_path()).generic_string();
    }
    runs.push_back(json);
  }
  replace_file(file, page(fmt::format("{} runs - Trammel", folders.size()),
                          {{"kind", "comparison"}, {"machine", machine}, {"keys", keys},
                           {"runs", runs}}));
}

fs::path latest_run(const fs::path& base) {
  fs::path latest;
  fs::file_time_type when;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(base, ignored)) {
    const fs::path metrics = entry.path() / "metrics.json";
    if (name_of(entry.path()).front() == '.' || !fs::exists(metrics, ignored)) continue;
    const auto written = fs::last_write_time(metrics, ignored);
    if (latest.empty() || written > when) {
      latest = entry.path();
      when = written;
    }
  }
  if (latest.empty())
    throw ConfigError(
        fmt::format("report: no run in {}/; name the folder of a run", base.string()));
  return latest;
}

void check_page_target(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw ConfigError(fmt::format("{}: --out: is a folder; name a file", file.string()));
  }
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
}

void write_page(const std::vector<fs::path>& folders, const fs::path& file) {
  if (folders.size() > 1) {
    check_page_target(file);
    return write_comparison_page(folders, file);
  }
  const RunFolder run = read_run(folders.front());
  check_page_target(file);
  write_page_of(run, file);
}

}  // namespace trammel::lab
