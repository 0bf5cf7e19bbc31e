// SPDX-License-Identifier: Apache-2.0
//
// Every parameter of a run, declared once: name with unit, range, help, and where it lives. Files,
// the environment, -s, run.toml, metrics.json and `trammel list keys` all read this table.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cosim/kung/types.hpp"

namespace trammel::testbench {

using Value = std::variant<bool, std::int64_t, double, std::string>;

enum class Kind { kFlag, kInteger, kReal, kChoice, kText };

struct Key {
  std::string name;                  // dotted: section.key or section.axis.key
  Kind kind = Kind::kReal;
  double min = 0;                    // [same unit as the value]
  double max = 0;
  std::vector<std::string> choices;  // of Kind::kChoice
  std::string help;
  std::function<Value(const kung::Options&)> get;
  std::function<void(kung::Options&, const Value&)> set;  // takes a value that passed the checks
};

// Keys that hold one value, axis keys once for x and once for y; order of run.toml.
const std::vector<Key>& keys();

// The key of that name; `plant.mass_kg` gives the keys of both axes, as do gains and chip.
std::vector<const Key*> find_keys(std::string_view name);

// Names a person may write, for suggestions: those of keys() and the two-axis short forms.
const std::vector<std::string>& key_names();

std::string range_text(const Key& key);        // "0..5", "one of fc, afc", "true or false"
std::string value_text(const Value& value);    // as TOML writes it

}  // namespace trammel::testbench
