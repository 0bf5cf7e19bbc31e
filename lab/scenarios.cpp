// SPDX-License-Identifier: Apache-2.0
#include "lab/scenarios.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>

#include "host/files.hpp"
#include "host/parse.hpp"
#include "host/text.hpp"
#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/machines.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;

namespace {

// Beside a program that is installed, ../share/trammel; else in the repository.
fs::path first_data_folder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path().parent_path() / "share/trammel/machines";
  return fs::is_directory(installed, none) ? installed : fs::path(kMachineFolder);
}

fs::path& data_folder() {
  static fs::path folder = first_data_folder();
  return folder;
}

// What the text of a scenario names; the first machine where it is no TOML, which is told later.
const Machine& machine_named(const std::string& text, const fs::path& file) {
  host::check_depth(text, file.string());
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error&) {
    return first_machine();
  }
  const auto* const key = table.get("machine");
  if (key == nullptr || !key->is_string()) return first_machine();
  const std::string name = key->as_string()->get();
  if (const Machine* const found = find_machine(name)) return *found;
  const bool is_folder = !name.empty() && name.find('/') == std::string::npos && name[0] != '.' &&
                         fs::is_directory(machine_folder(name));
  need_all_machines(is_folder ? name : "");
  throw host::ConfigError(
      fmt::format("{}:{}: machine: value \"{}\" is not one of {}{}", file.string(),
                  key->source().begin.line, host::shown(name), fmt::join(machine_names(), ", "),
                  hint(name, machine_names())));
}

// Defaults of the machine with a program in place of a scenario.
std::unique_ptr<Settings> of_program(const Machine& machine, const fs::path& file) {
  auto settings = machine.defaults();
  settings->scenario = file.stem().string();
  for (const std::string& text : machine.program.assignments) {
    apply_assignment(*settings, text, file.string());
  }
  apply_assignment(*settings, machine.program.key + '=' + file.string(), file.string());
  const Key* const key = find_keys(machine.keys(), machine.program.key).front();
  settings->program = std::get<std::string>(key->get(*settings));
  return settings;
}

}  // namespace

namespace {

// Folders of machines: all in the data folder, and in examples/ beside it those with machine.cpp.
std::vector<fs::path> machine_folders() {
  std::vector<fs::path> all;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(data_folder(), ignored)) all.push_back(entry);
  const fs::path examples = data_folder().parent_path() / "examples";
  for (const auto& entry : fs::recursive_directory_iterator(examples, ignored)) {
    if (entry.path().filename() == "machine.cpp") all.push_back(entry.path().parent_path());
  }
  return all;
}

}  // namespace

fs::path machine_folder(const std::string& machine) {
  if (machine.empty()) return data_folder();
  for (const fs::path& folder : machine_folders()) {
    if (folder.filename() == machine) return folder;
  }
  return data_folder() / machine;
}

void take_data_from(const std::string& folder) { data_folder() = folder; }

const Machine* machine_of_program(const fs::path& file) {
  std::string extension = file.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Machine* machine : machines()) {
    const auto& all = machine->program.extensions;
    if (std::find(all.begin(), all.end(), extension) != all.end()) return machine;
  }
  return nullptr;
}

std::vector<std::string> program_extensions() {
  std::vector<std::string> all;
  for (const Machine* machine : machines()) {
    all.insert(all.end(), machine->program.extensions.begin(), machine->program.extensions.end());
  }
  return all;
}

const Machine& machine_of(const fs::path& file) {
  if (const Machine* const machine = machine_of_program(file)) return *machine;
  return machine_named(host::read_text(file, host::kMostWritten), file);
}

std::vector<fs::path> built_in(const std::string& extension) {
  std::vector<fs::path> all;
  std::error_code ignored;
  for (const fs::path& machine : machine_folders()) {
    for (const auto& entry : fs::directory_iterator(machine / "scenarios", ignored)) {
      if (entry.path().extension() == extension) all.push_back(entry.path());
    }
  }
  std::sort(all.begin(), all.end(), [](const fs::path& a, const fs::path& b) {
    return a.filename() < b.filename();
  });
  return all;
}

std::vector<fs::path> scenarios() { return built_in(".toml"); }

fs::path find_built_in(const std::string& name, const std::string& extension,
                       const std::string& kind) {
  std::vector<std::string> names;
  for (const fs::path& file : built_in(extension)) {
    if (file.stem() == name) return file;
    names.push_back(file.stem().string());
  }
  const fs::path file = name;
  if (file.extension() == extension || file.has_parent_path()) return file;
  const std::string near = suggest(name, names);
  throw host::ConfigError(
      fmt::format("{}: no such {}{}; built in: {}; or give a {} file", host::shown(name), kind,
                  near.empty() ? "" : fmt::format(", did you mean {}?", near),
                  fmt::join(names, ", "), extension));
}

fs::path find_scenario(const std::string& name) {
  if (machine_of_program(name) != nullptr) return name;
  return find_built_in(name, ".toml", "scenario");
}

std::unique_ptr<Settings> load_scenario(const fs::path& file) {
  if (const Machine* const machine = machine_of_program(file)) return of_program(*machine, file);
  const std::string text = host::read_text(file, host::kMostWritten);
  auto settings = machine_named(text, file).defaults();
  settings->scenario = file.stem().string();
  apply_text(*settings, text, file.string(), fs::absolute(file).parent_path());
  return settings;
}

namespace {

// `./trammel run NAME` with what differs from `reference`; "" where that is too much for a line.
std::string command_of(const Settings& settings, const std::string& name,
                       const Settings& reference) {
  constexpr std::size_t kMostShown = 8;
  std::string command = "./trammel run " + host::shell_argument(name);
  std::size_t shown = 0;
  for (const Key& key : settings.machine().keys()) {
    const Value value = key.get(settings);
    if (key.name == "name" || key.name == "description" || value == key.get(reference)) continue;
    const auto* const word = std::get_if<std::string>(&value);
    command += " -s " + host::shell_argument(key.name + '=' +
                                             (word != nullptr ? *word : value_text(value)));
    ++shown;
  }
  return shown <= kMostShown ? command : "";
}

}  // namespace

std::string repeat_command(const Settings& settings, const fs::path& folder) {
  const std::vector<fs::path> all = scenarios();
  const auto file = std::find_if(all.begin(), all.end(), [&](const fs::path& one) {
    return (one.stem() == settings.scenario ||
            settings.scenario.rfind(one.stem().string() + '-', 0) == 0) &&  // of run --all
           &machine_of(one) == &settings.machine();
  });
  std::string command;
  if (file != all.end()) command = command_of(settings, file->stem(), *load_scenario(*file));
  if (command.empty() && folder.empty() && !settings.program.empty()) {
    command = command_of(settings, settings.program, *load_scenario(settings.program));
  }
  if (!command.empty()) return command;
  const fs::path here = folder.empty() ? fs::path() : fs::proximate(folder);
  return "./trammel run " + host::shell_argument((here / "run.toml").string());
}

}  // namespace trammel::lab
