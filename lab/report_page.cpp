// SPDX-License-Identifier: Apache-2.0
#include "lab/report_page.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <set>
#include <string_view>

#include "host/files.hpp"
#include "host/output_folder.hpp"
#include "host/text.hpp"
#include "lab/report_data.hpp"
#include "lab/write.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostValues = 16000;   // a series of one run's page
constexpr std::size_t kMostCompared = 6000;  // a series of one of several runs
constexpr char kTitleEnd[] = " - Trammel";
constexpr std::size_t kMostRuns = 12;        // lines that can be told apart, see theme.js

Json run_json(const RunFolder& run, bool compared) {
  PageSeries series = page_series(run, compared, compared ? kMostCompared : kMostValues);
  return {{"metrics", run.metrics}, {"channels", series.channels}, {"count", series.count},
          {"stride", series.stride}};
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

std::string replaced(std::string text, const std::string& old, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size()) {
    text.replace(at, old.size(), by);
  }
  return text;
}

std::string page(const std::string& title, const Json& data) {
  const std::string safe_title = replaced(
      replaced(replaced(host::printable(title), "&", "&amp;"), "<", "&lt;"), "@", "&#64;");
  // Nothing inside a script element may end it.
  const std::string json =
      replaced(data.dump(-1, ' ', true, Json::error_handler_t::replace), "<", "\\u003c");
  // The data last: whatever they hold is not looked through.
  return replaced(replaced(std::string(kPage), "@TITLE@", safe_title), "@DATA@", json);
}

std::string title_of(const RunFolder& run) {
  const auto own = run.machine->page.title;
  return own != nullptr ? own(run.metrics) : run.metrics["scenario"].get<std::string>();
}

// A path as a reference in a page (RFC 3986, section 3.3).
std::string reference(const fs::path& path) {
  std::string text;
  for (const char c : path.generic_string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
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

}  // namespace

void write_page(const std::vector<fs::path>& folders, const fs::path& file) {
  const bool compared = folders.size() > 1;
  if (folders.size() > kMostRuns) {
    throw host::ConfigError(
        fmt::format("report: {} runs: a page compares at most {}", folders.size(), kMostRuns));
  }
  std::error_code ignored;
  host::check_result_file(file);
  const std::vector<std::string> labels = labels_of(folders);
  std::string title = fmt::format("{} runs", folders.size());
  const Machine* machine = nullptr;
  Json runs = Json::array();
  for (std::size_t k = 0; k < folders.size(); ++k) {
    const RunFolder run = read_run(folders[k]);
    if (machine == nullptr) machine = run.machine;
    if (run.machine != machine) {
      throw host::ConfigError(
          fmt::format("report: {} is a run of machine {} and {} one of {}: only runs of one "
                      "machine can be compared", folders.front().string(), machine->name,
                      folders[k].string(), run.machine->name));
    }
    Json json = run_json(run, compared);
    if (!compared) title = title_of(run);
    json["label"] = compared ? labels[k] : title;
    if (!compared) json["detail"] = run.detail;
    if (compared && fs::exists(folders[k] / "report.html", ignored)) {
      json["page"] = reference(fs::proximate(folders[k] / "report.html",
                                             fs::absolute(file).parent_path()));
    }
    runs.push_back(std::move(json));
  }
  host::write_result_file(file, page(title + kTitleEnd, {{"machine", machine->name},
                                                         {"keys", keys_json(*machine)},
                                                         {"runs", runs}}));
}

bool is_page(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return false;
  std::string begin(8192, '\0');
  std::ifstream(file).read(begin.data(), std::streamsize(begin.size()));
  return begin.find(std::string(kTitleEnd) + "</title>") != std::string::npos;
}

fs::path latest_run(const fs::path& base) {
  fs::path latest;
  fs::file_time_type when;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(base, ignored)) {
    const fs::path metrics = entry.path() / "metrics.json";
    if (entry.path().filename().string().front() == '.' || entry.is_symlink(ignored) ||
        !fs::exists(metrics, ignored)) {
      continue;
    }
    const auto written = fs::last_write_time(metrics, ignored);
    if (latest.empty() || written > when) {
      latest = entry.path();
      when = written;
    }
  }
  if (!latest.empty()) return latest;
  throw host::ConfigError(
      fmt::format("report: no run in {}/; name the folder of a run", base.string()));
}

}  // namespace trammel::lab
