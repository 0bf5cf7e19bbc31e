// SPDX-License-Identifier: Apache-2.0
//
// The description of a machine: all that the library knows of it. machines/<name>/machine.cpp
// defines one; the build finds it by its folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cosim/session.hpp"
#include "lab/column.hpp"
#include "lab/figure.hpp"
#include "lab/record.hpp"
#include "lab/settings.hpp"

namespace trammel::lab {

struct RunFolder;

// What a machine's chip and its twin declare. A chip without a leap contract is evaluated clock by
// clock; one without a twin has its RTL alone.
struct Capabilities {
  bool leap = true;
  bool twin = true;
};

// One of a set of runs whose figures belong together, as those of a paper.
struct Experiment {
  std::string name;                      // of its folder
  std::string scenario;
  std::vector<std::string> assignments;  // key=value
  std::string page = "index.html";       // of all runs that name it, beside their folders
};

// A file in a language of its own that is run as a scenario is: `trammel run part.ngc`.
struct ProgramFile {
  std::vector<std::string> extensions;   // ".ngc", in small letters
  std::string key;                       // whose value the file is
  std::vector<std::string> assignments;  // key=value: what else differs from the defaults
};

// What a machine's report page needs besides its figures and columns.
struct Page {
  std::vector<std::string> texts, counts, numbers, objects, arrays;  // members of metrics.json
  std::vector<Column> derived;  // series made of others when a run is read back
  bool (*has_detail)(const nlohmann::ordered_json& metrics) = nullptr;  // detail.json is there
  void (*check_detail)(const std::filesystem::path& file,
                       const nlohmann::ordered_json& detail) = nullptr;
  void (*complete)(RunFolder& run) = nullptr;  // first row, derived series
  std::string (*title)(const nlohmann::ordered_json& metrics) = nullptr;  // none: the scenario
};

// The first line of a scenario's text, after settings were altered.
struct Described {
  std::string by;  // the key whose value a description tells, if any
  bool (*alters)(const Key& key, const Value& value) = nullptr;  // what else it may not go with
  // That description, without words that altered settings belie.
  std::string (*reworded)(const Settings& settings, std::string description) = nullptr;
};

// What triggers may be, and the order of magnitude of a trace.
struct Tracing {
  const cosim::TriggerForms& (*triggers)() = nullptr;
  double vcd_bytes_s = 1e10;
  double fst_bytes_s = 1e8;
};

// Lines for people.
struct Texts {
  std::vector<std::string> (*warnings)(const Settings& settings) = nullptr;  // before a run
  std::vector<std::string> (*remarks)(const Record& record) = nullptr;  // "" is a blank one
};

// Runs beside the first one, which it is compared with; they are made when it is done.
struct Comparison {
  std::vector<Companion> (*companions)(const Settings& settings) = nullptr;
  std::string (*run_name)(const Settings& settings) = nullptr;  // of the first among them
};

// Files of a run, or what is in them, besides what every machine has.
struct Files {
  void (*metrics)(const Record& record, nlohmann::ordered_json& json) = nullptr;
  nlohmann::ordered_json (*detail)(const Record& record) = nullptr;  // null: no detail.json
  void (*write)(const Record& record, const std::filesystem::path& folder) = nullptr;
  Range (*drawn)(const Record& record) = nullptr;  // samples in pictures/*.gp; none: all
};

// The runs of `trammel run --all`, and what is said of them together.
struct Experiments {
  std::vector<Experiment> list;
  std::string (*text)(const std::vector<const Record*>& records) = nullptr;
};

struct Machine {
  std::string name;    // its folder in machines/
  std::string title;   // one line
  std::string source;  // the document it follows
  int order = 100;     // in lists; a file without a machine belongs to the first
  Capabilities can;

  // Takes defaults and sessions from the types of a machine.
  template <class Options, class Session>
  void of_types() {
    defaults = []() -> std::unique_ptr<Settings> { return std::make_unique<Options>(); };
    session = [](const Settings& settings, const cosim::Hooks& hooks,
                 const cosim::Waves& waves) -> std::unique_ptr<cosim::Session> {
      return std::make_unique<Session>(static_cast<const Options&>(settings), hooks, waves);
    };
  }

  // Settings: their defaults, every key, and rules that concern more than one key. validate() may
  // leave in them what it computes of them, as Settings::prepared.
  std::unique_ptr<Settings> (*defaults)() = nullptr;
  const std::vector<Key>& (*keys)() = nullptr;
  std::vector<FormerKey> former_keys;  // neither listed nor written
  void (*validate)(Settings& settings) = nullptr;

  // A run, and what is recorded and made of it.
  std::unique_ptr<cosim::Session> (*session)(const Settings& settings, const cosim::Hooks& hooks,
                                             const cosim::Waves& waves) = nullptr;
  Tracing traces;
  const ColumnTable& (*columns)() = nullptr;
  std::vector<Figure> (*figures)(const Settings& settings, cosim::RunResult& result) = nullptr;
  // How it ended, in one line.
  std::string (*verdict)(const Settings& settings, const cosim::RunResult& result) = verdict_text;

  // What a machine may have besides.
  Described described;
  Texts texts;
  Comparison compared;
  Files files;
  Page page;
  Experiments experiments;
  ProgramFile program;            // no extension: there is none
  std::vector<std::string> live;  // as key=value: with these another program takes part
};

// All of them, in their order.
const std::vector<const Machine*>& machines();

inline std::vector<std::string> machine_names() {
  std::vector<std::string> names;
  for (const Machine* machine : machines()) names.push_back(machine->name);
  return names;
}

inline const Machine* find_machine(const std::string& name) {  // nullptr: there is none
  for (const Machine* machine : machines()) {
    if (machine->name == name) return machine;
  }
  return nullptr;
}

}  // namespace trammel::lab
