// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <vector>

#include "lab/build_info.hpp"
#include "lab/files.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostDrawn = 6000;  // samples: more make a heavy picture, not a better one

constexpr char kStyle[] =
    "set datafile separator ','\nset datafile columnheaders\n"
    "set grid lc rgb '#dddddd' lt 1\nset border lc rgb '#666666'\n"
    "set key outside top center horizontal samplen 2\n";

// What of a text gnuplot takes as such: a quote or mark-up in it is left out.
std::string quoted(const std::string& text) {
  std::string kept = "'";
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ' ') kept += c;
  }
  return kept + "'";
}

std::string assigned(const Key& key, const Settings& settings) {
  std::string name = key.name;
  std::replace(name.begin(), name.end(), '.', '_');
  const Value value = key.get(settings);
  if (const auto* flag = std::get_if<bool>(&value)) return fmt::format("{} = {:d}\n", name, *flag);
  const auto* const text = std::get_if<std::string>(&value);
  return fmt::format("{} = {}\n", name, text != nullptr ? quoted(*text) : value_text(value));
}

double time_of(const Record& record, std::size_t sample) {
  const ColumnTable& table = record.machine().columns();
  std::vector<double> values;
  table.read(*record.settings, *record.result, sample, values);
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (table.columns[n].name == "t_s") return values[n];
  }
  return 0;
}

bool run_gnuplot(const fs::path& folder, const std::string& script) {
  std::signal(SIGPIPE, SIG_IGN);  // a gnuplot that dies is a return value, not the end of us
  const std::string command = fmt::format("cd {} && exec {} - > /dev/null 2>&1",
                                          shell_word(folder), shell_word(find_program("gnuplot")));
  std::FILE* const pipe = popen(command.c_str(), "w");
  if (pipe == nullptr) return false;
  const bool sent = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  return pclose(pipe) == 0 && sent;
}

}  // namespace

bool draw_pictures(const Record& record, const fs::path& folder) {
  const Machine& machine = record.machine();
  std::vector<fs::path> scripts;
  std::error_code none;
  for (const auto& entry :
       fs::directory_iterator(fs::path(kMachineFolder) / machine.name / "pictures", none)) {
    if (entry.path().extension() == ".gp") scripts.push_back(entry.path());
  }
  if (scripts.empty()) return true;
  Range drawn{0, record.result->sample_count()};
  if (machine.drawn != nullptr) drawn = machine.drawn(record);
  if (find_program("gnuplot").empty() || drawn.last < drawn.first + 2) return false;
  std::string variables = kStyle;
  for (const Key& key : machine.keys()) variables += assigned(key, *record.settings);
  variables += fmt::format(
      "title = {}\nfirst = {}\nlast = {}\nstep = {}\nfrom = {}\nto = {}\n",
      quoted(record.settings->scenario + (record.name.empty() ? "" : " " + record.name)),
      drawn.first, drawn.last - 1, (drawn.last - drawn.first) / kMostDrawn + 1,
      time_of(record, drawn.first), time_of(record, drawn.last - 1));
  return std::all_of(scripts.begin(), scripts.end(), [&](const fs::path& script) {
    return run_gnuplot(folder, variables + read_text(script) + "unset output\n");
  });
}

}  // namespace trammel::lab
