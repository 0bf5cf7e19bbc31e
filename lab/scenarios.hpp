// SPDX-License-Identifier: Apache-2.0
//
// What comes with the machines: scenarios in machines/<name>/scenarios/, and other files there.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lab/machine.hpp"

namespace trammel::lab {

// Where they are: share/trammel/machines beside the program's folder, or machines/ of the
// repository this was built from, unless another folder with the same subfolders is named, before
// the first run; examples/ beside that folder has machines too. "" is the folder of all others.
std::filesystem::path machine_folder(const std::string& machine);
void take_data_from(const std::string& folder);

// Files of that extension that are built in; one of them by its name, or a path. `kind` is what
// messages call it.
std::vector<std::filesystem::path> built_in(const std::string& extension);
std::filesystem::path find_built_in(const std::string& name, const std::string& extension,
                                    const std::string& kind);

// The machine that runs a file of this name as a program; nullptr: none does.
const Machine* machine_of_program(const std::filesystem::path& file);
std::vector<std::string> program_extensions();  // of all machines

// A built-in scenario's name or a path to a .toml file or to a program of a machine.
std::filesystem::path find_scenario(const std::string& name);
std::vector<std::filesystem::path> scenarios();

// The machine that the key `machine` of a file names; the first one where it says nothing or the
// file cannot be parsed, which reading it as a scenario will report.
const Machine& machine_of(const std::filesystem::path& file);

// A scenario as its file has it: defaults of its machine, then the file. Of a program the defaults
// with that program; reading it is left to lab::validate.
std::unique_ptr<Settings> load_scenario(const std::filesystem::path& file);

// The command that repeats a run from the current folder: a built-in scenario with what differs
// from it, or run.toml in the folder of the run; where it has none, the program that was named.
std::string repeat_command(const Settings& settings, const std::filesystem::path& folder = {});

}  // namespace trammel::lab
