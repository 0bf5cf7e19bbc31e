// SPDX-License-Identifier: Apache-2.0
//
// The settings of one run, of any machine. Each machine derives its own plain data from Settings
// and declares every parameter once, as a Key: name with unit, range, help, and where it lives.
// Files, the environment, -s, run.toml, metrics.json and `trammel list keys` all read that table.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/fault.hpp"
#include "cosim/run.hpp"
#include "host/errors.hpp"

namespace trammel::lab {

struct Machine;

// What a description is made of while layers change what it describes.
struct Heading {
  std::string own;                                           // of the scenario
  std::vector<std::pair<std::string, std::string>> altered;  // keys, and the value it goes with
};

// Which layer has set a key last: 0 is the defaults, later layers have larger numbers.
struct SetBy {
  int layer = 0;
  std::string where;  // "file:line: " of a file, else ""
};

struct Settings {
  virtual ~Settings() = default;
  virtual const Machine& machine() const = 0;
  virtual std::unique_ptr<Settings> clone() const = 0;

  std::string scenario;     // names the run and its output folder
  std::string description;  // one line
  Heading heading;          // see lab/heading.hpp
  int layers = 0;           // files that were applied
  std::map<std::string, SetBy> set_by;  // keys that any layer has set
  std::string program;      // the file that was named in place of a scenario; "": none
  std::vector<std::string> notices;  // lines for people: former keys, and what to write now
  std::shared_ptr<const void> prepared;  // what the machine has made of them in validate()
  cosim::RunOptions run;
  cosim::ProcessorOptions processor;
  cosim::Fault fault;

 protected:
  Settings() = default;
  Settings(const Settings&) = default;
  Settings& operator=(const Settings&) = default;
};

// The base of a machine's own; kMachine is its description.
template <class Derived, const Machine& (*kMachine)()>
struct SettingsOf : Settings {
  const Machine& machine() const override { return kMachine(); }
  std::unique_ptr<Settings> clone() const override {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
};

using Value = std::variant<bool, std::int64_t, double, std::string>;

enum class Kind { kFlag, kInteger, kReal, kChoice, kText, kFile };

struct Key {
  std::string name;  // dotted: section.key or section.axis.key
  Kind kind = Kind::kReal;
  double min = 0;  // [same unit as the value]
  double max = 0;
  std::vector<std::string> choices;  // of Kind::kChoice
  std::string help;
  std::function<Value(const Settings&)> get;
  std::function<void(Settings&, const Value&)> set;  // takes a value that passed the checks
};

// A key of the version before: it is still read, and sets others.
struct FormerKey {
  Key key;  // its name, kind and range
  // key=value of the keys that have this value's effect; none where it has no effect.
  std::function<std::vector<std::string>(const Settings&, const Value&)> now;
};

// "plant.x.mass_kg" -> "plant.mass_kg"; other names stay.
std::string short_form(const std::string& name);

// The key of that name; `plant.mass_kg` gives the keys of both axes.
std::vector<const Key*> find_keys(const std::vector<Key>& keys, std::string_view name);

// Names a person may write, for suggestions: those of the keys and the two-axis short forms.
std::vector<std::string> key_names(const std::vector<Key>& keys);

std::string range_text(const Key& key);      // "0..5", "one of fc, afc", "true or false"
std::string value_text(const Value& value);  // as TOML writes it

// The nearest of `words` within a third of the length, or "".
std::string suggest(const std::string& word, const std::vector<std::string>& words);

// "; did you mean NEAR?", or `otherwise` where nothing is near.
std::string hint(const std::string& word, const std::vector<std::string>& words,
                 const std::string& otherwise = "");

}  // namespace trammel::lab
