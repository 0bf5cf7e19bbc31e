// SPDX-License-Identifier: Apache-2.0
//
// From files, environment and command line to Options. Later layers win:
// defaults < scenario < file (-c) < environment TRAMMEL_<KEY> < -s key=value.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/kung/types.hpp"
#include "testbench/keys.hpp"

namespace trammel::testbench {

// The user's mistake; the text names file, line, key and permitted range. Exit code 2.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A program that is needed is not installed. Exit code 3.
struct ToolMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Applies a TOML file; relative paths in it are meant from its own folder. All of these are there
// for the Options of every machine.
template <class Options>
void apply_file(Options& options, const std::filesystem::path& file);
template <class Options>
void apply_text(Options& options, const std::string& toml, const std::string& source,
                const std::filesystem::path& folder);
// "plant.x.mass_kg=3"; a relative path is meant from the working folder.
// `where` is what the user wrote, for messages.
template <class Options>
void apply_assignment(Options& options, const std::string& assignment,
                      const std::string& where = "-s");
// Pairs of variable and value; TRAMMEL_PLANT_X_MASS_KG is plant.x.mass_kg.
template <class Options>
void apply_environment(Options& options,
                       const std::vector<std::pair<std::string, std::string>>& variables);
std::vector<std::pair<std::string, std::string>> environment();

// Reads the file of points and checks what concerns more than one key, up to the words that the
// firmware writes. Throws ConfigError.
void finish(kung::Options& options);
void finish(const lm628::Options& options);
void finish(const mcafee::Options& options);

// How chips are looked at: some ways exclude others, and a twin offers few. Throws ConfigError.
void check_engine(const cosim::RunBasics& run);

// What the steps of plant::DcMotor can follow.
void check_motor(const plant::DcMotorConfig& motor);

// Everything needed to repeat the run by `command`, as TOML, but the keys that `left_out` names.
template <class Options>
std::string run_toml(const Options& options, const std::string& command = "trammel run run.toml",
                     bool (*left_out)(const KeyInfo&) = nullptr);

// All of a file; one that cannot be read is a ConfigError.
std::string read_text(const std::filesystem::path& file);

// Files of that extension that are built in; one of them by its name, or a path.
std::vector<std::filesystem::path> built_in(const std::string& extension);
std::filesystem::path find_built_in(const std::string& name, const std::string& extension,
                                    const std::string& kind);

// A built-in scenario's name or a path to a .toml file.
std::filesystem::path find_scenario(const std::string& name);
std::vector<std::filesystem::path> scenarios(const std::string& machine = "");  // "" = of all

// What the key `machine` of a file says; kung where it says nothing or is no TOML, which who reads
// it whole will tell.
std::string machine_of(const std::filesystem::path& file);

// The nearest of `words` within a third of the length, or "".
std::string suggest(const std::string& word, const std::vector<std::string>& words);

}  // namespace trammel::testbench
