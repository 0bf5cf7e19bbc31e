// SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

#include "testbench/config.hpp"
#include "testbench/output.hpp"
#include "testbench/page_parts.hpp"
#include "testbench/report_data.hpp"

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostValues = 16000;     // a series of one run's page
constexpr std::size_t kMostCompared = 6000;    // a series of one of several runs
constexpr std::size_t kMostRuns = 8;           // colours that can be told apart

Json run_json(const RunRecord& run, const std::string& label,
              const std::vector<std::string>& names, std::size_t most) {
  const PageSeries series = page_series(run, names, most);
  return {{"label", label},           {"metrics", run.metrics}, {"detail", run.detail},
          {"channels", series.channels}, {"count", series.count},  {"stride", series.stride},
          {"data", series.data}};
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

// Whole or not at all, even when the disk is full.
void replace_file(const fs::path& file, const std::string& text) {
  const fs::path scratch = fs::path(file).concat(".new");
  try {
    write_text(scratch, text);
    fs::rename(scratch, file);
  } catch (const fs::filesystem_error& error) {
    fs::remove(scratch);
    throw ConfigError(fmt::format("{}: cannot be written: {}", file.string(),
                                  error.code().message()));
  } catch (...) {
    std::error_code ignored;
    fs::remove(scratch, ignored);
    throw;
  }
}

void write_page_of(const RunRecord& run, const fs::path& file) {
  const std::string title = run.page->title(run.metrics);
  const Json data{{"kind", "run"}, {"machine", run.metrics["machine"]},
                  {"keys", run.page->keys()},
                  {"runs", {run_json(run, title, {}, kMostValues)}}};
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

// Quoted only where the shell would see more than a word.
std::string shell_argument(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("._-+=/,:", c) != nullptr;
  });
  return plain ? text : shell_word(text);
}

fs::path latest_run() {
  fs::path latest;
  fs::file_time_type when;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("out", ignored)) {
    const fs::path metrics = entry.path() / "metrics.json";
    if (name_of(entry.path()).front() == '.' || !fs::exists(metrics, ignored)) continue;
    const auto written = fs::last_write_time(metrics, ignored);
    if (latest.empty() || written > when) {
      latest = entry.path();
      when = written;
    }
  }
  if (latest.empty()) throw ConfigError("report: no run in out/; name the folder of a run");
  return latest;
}

void check_target(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw ConfigError(fmt::format("{}: --out: is a folder; name a file", file.string()));
  }
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
}

}  // namespace

void write_run_page(const fs::path& folder) {
  write_page_of(read_run(folder), folder / "report.html");
}

bool guarded(const std::function<void()>& write) {
  try {
    write();
    return true;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trammel: no report: {}; the results are kept\n", error.what());
    return false;
  }
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
    const RunRecord run = read_run(folders[k]);
    const std::string other = run.metrics["machine"];
    if (machine.empty()) {
      machine = other;
      keys = run.page->keys();
    }
    if (other != machine) {
      throw ConfigError(fmt::format("report: {} is a run of machine {} and {} one of {}: only runs "
                                    "of one machine can be compared",
                                    folders.front().string(), machine, folders[k].string(), other));
    }
    Json json = run_json(run, labels[k], run.page->compared, kMostCompared);
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

int report(const ReportArguments& arguments) {
  std::vector<fs::path> folders(arguments.folders.begin(), arguments.folders.end());
  if (folders.empty()) folders.push_back(latest_run());
  fs::path file = arguments.out;
  if (file.empty()) {
    file = folders.size() == 1 ? folders.front() / "report.html" : fs::path("out/compare.html");
  }
  if (folders.size() == 1) {
    const RunRecord run = read_run(folders.front());
    check_target(file);
    write_page_of(run, file);
  } else {
    check_target(file);
    write_comparison_page(folders, file);
  }
  if (arguments.json) {
    fmt::print("{}\n", Json{{"page", file.string()}, {"bytes", fs::file_size(file)}}.dump(2));
  } else {
    fmt::print("{}\n", file.string());
  }
  return 0;
}

template <class Options>
std::string repeat_command(const Options& options) {
  constexpr std::size_t kMostShown = 8;
  const std::vector<fs::path> all = scenarios(machine_name<Options>());
  const auto file = std::find_if(all.begin(), all.end(), [&](const fs::path& one) {
    return one.stem() == options.scenario ||
           options.scenario.rfind(one.stem().string() + '-', 0) == 0;  // of run --all
  });
  if (file != all.end()) {
    Options reference;
    apply_file(reference, *file);
    std::string command = "./trammel run " + file->stem().string();
    std::size_t shown = 0;
    for (const auto& key : keys_of<Options>()) {
      if (key.name == "name" || key.name == "description" ||
          key.get(options) == key.get(reference)) {
        continue;
      }
      const Value value = key.get(options);
      const auto* const word = std::get_if<std::string>(&value);
      command += " -s " + shell_argument(key.name + '=' +
                                         (word != nullptr ? *word : value_text(value)));
      ++shown;
    }
    if (shown <= kMostShown) return command;
  }
  return "./trammel run run.toml";
}

template std::string repeat_command(const kung::Options&);
template std::string repeat_command(const lm628::Options&);
template std::string repeat_command(const mcafee::Options&);

}  // namespace trammel::testbench
