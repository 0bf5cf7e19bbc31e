// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/inputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "host/files.hpp"
#include "host/parse.hpp"
#include "host/text.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/report_data.hpp"
#include "lab/report_page.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "paths/gcode.hpp"
#include "paths/points.hpp"
#include "tests/support/moves_check.hpp"

namespace trammel::fuzz {

void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

void check_message(const std::exception& error) {
  const std::string line = host::one_line(error.what());
  if (line.size() > 8100 || host::printable(line) != line || line.empty()) {
    finding("not a line: " + line);
  }
}

namespace {

namespace fs = std::filesystem;
using host::ConfigError;

template <class Act>
bool taken(Act act) {
  try {
    act();
    return true;
  } catch (const ConfigError& error) {
    check_message(error);
    return false;
  }
}

// What run.toml and metrics.json say of settings that can run gives these settings again.
void check_repeats(const lab::Settings& settings) {
  const std::string text = lab::run_toml(settings);
  const auto again = settings.machine().defaults();
  try {
    lab::apply_text(*again, text, "run.toml", "/");
  } catch (const ConfigError& error) {
    finding(fmt::format("run.toml is refused: {}\n{}", error.what(), text));
  }
  if (lab::run_toml(*again) != text) finding("run.toml does not repeat:\n" + text);
  lab::Json options;
  for (const lab::Key& key : settings.machine().keys()) {
    options[key.name] = lab::value_json(key.get(settings));
  }
  options.dump();  // throws what ends the process where a text is not UTF-8
}

// One input in so many: what takes a hundred times as long as all else.
bool is_one_in(unsigned many, const std::string& bytes) {
  unsigned sum = 0;
  for (const char c : bytes) sum = 31 * sum + static_cast<unsigned char>(c);
  return sum % many == 0;
}

void finish(lab::Settings& settings, const std::string& bytes) {
  if (is_one_in(128, bytes) && !taken([&] { lab::validate(settings); })) return;
  if (is_one_in(8, bytes)) check_repeats(settings);
}

void points(const std::string& bytes) {
  std::istringstream text(bytes);
  try {
    paths::read_points_csv(text, "points.csv", {-600, 600});
  } catch (const std::invalid_argument& error) {
    check_message(error);
  }
}

void gcode(const std::string& bytes) {
  paths::GcodeTable table;
  table.start = table.home = {0.25, 0.25};
  try {
    const paths::GcodeProgram program = paths::read_gcode(bytes, "part.ngc", table);
    const std::string problem = test::moves_problem(program.moves, table.low, table.high);
    if (!problem.empty()) finding("moves that do not hold together: " + problem);
    for (const std::string& warning : program.warnings) {
      check_message(std::runtime_error(warning));
    }
  } catch (const std::invalid_argument& error) {
    check_message(error);
  }
}

void put(const fs::path& file, const std::string& bytes) {
  std::FILE* const out = std::fopen(file.c_str(), "wb");
  if (out == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), out) != bytes.size() ||
      std::fclose(out) != 0) {
    finding("the scratch folder takes no more");
  }
}

}  // namespace

Inputs::Inputs(const fs::path& runs) : scratch_(fmt::format("scratch-{}", getpid())) {
  fs::create_directories(scratch_);
  for (const lab::Machine* const machine : lab::machines()) {
    if (runs.empty()) break;
    runs_.push_back(scratch_ / machine->name);
    fs::copy(runs / machine->name, runs_.back());
    fs::remove(runs_.back() / "run.json");  // else every change would be found by its checksum
  }
}

Inputs::~Inputs() {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

// The first byte chooses the machine; lines of key=value, or of variable=value behind a '$'.
void Inputs::keys(const std::string& bytes) {
  if (bytes.empty()) return;
  const auto& machines = lab::machines();
  const std::size_t choice = static_cast<unsigned char>(bytes[0]) % machines.size();
  const auto settings = machines[choice]->defaults();
  std::istringstream lines(bytes.substr(1));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find('=');
    const bool good = taken([&] {
      if (line.empty() || line[0] != '$' || at == std::string::npos) {
        lab::apply_assignment(*settings, line);
      } else {
        lab::apply_environment(*settings, {{line.substr(1, at - 1), line.substr(at + 1)}});
      }
    });
    if (!good) return;
  }
  finish(*settings, bytes);
}

void Inputs::scenario(const std::string& bytes) {
  const fs::path file = scratch_ / "scenario.toml";
  put(file, bytes);
  std::unique_ptr<lab::Settings> settings;
  if (taken([&] { settings = lab::load_scenario(file); })) finish(*settings, bytes);
}

// The first byte chooses the run and the file of it that has these bytes.
void Inputs::folder(const std::string& bytes) {
  if (bytes.empty() || runs_.empty()) return;
  static const char* const kFiles[] = {"metrics.json", "detail.json", "trace.csv", "run.json"};
  const auto choice = static_cast<unsigned char>(bytes[0]);
  const fs::path& run = runs_[choice % runs_.size()];
  const fs::path file = run / kFiles[choice / 16 % 4];
  const fs::path aside = scratch_ / "aside";
  const bool there = fs::exists(file);
  if (there) fs::rename(file, aside);
  put(file, bytes.substr(1));
  taken([&] { lab::write_page({run}, scratch_ / "page.html"); });
  fs::remove(file);
  if (there) fs::rename(aside, file);
}

void Inputs::try_one(const std::string& target, const std::string& bytes) {
  if (target == "keys") return keys(bytes);
  if (target == "scenario") return scenario(bytes);
  if (target == "points") return points(bytes);
  if (target == "gcode") return gcode(bytes);
  if (target == "folder") return folder(bytes);
  for (const Target& own : machine_targets()) {
    if (own.name == target) return own.run(bytes);
  }
  finding("no such target: " + target);
}

}  // namespace trammel::fuzz
