// SPDX-License-Identifier: Apache-2.0
//
// Every parameter of a run, declared once: name with unit, range, help, and where it lives. Files,
// the environment, -s, run.toml, metrics.json and `trammel list keys` all read this table.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cosim/kung/types.hpp"
#include "cosim/lm628/types.hpp"
#include "cosim/mcafee/types.hpp"

namespace trammel::testbench {

using Value = std::variant<bool, std::int64_t, double, std::string>;

enum class Kind { kFlag, kInteger, kReal, kChoice, kText };

struct KeyInfo {
  std::string name;                  // dotted: section.key or section.axis.key
  Kind kind = Kind::kReal;
  double min = 0;                    // [same unit as the value]
  double max = 0;
  std::vector<std::string> choices;  // of Kind::kChoice
  std::string help;
};

template <class Options>
struct KeyOf : KeyInfo {
  std::function<Value(const Options&)> get;
  std::function<void(Options&, const Value&)> set;  // takes a value that passed the checks
};
using Key = KeyOf<kung::Options>;

// The machine that these Options are of, as files name it.
template <class Options>
constexpr const char* machine_name();
template <>
constexpr const char* machine_name<kung::Options>() {
  return "kung";
}
template <>
constexpr const char* machine_name<lm628::Options>() {
  return "an693";
}
template <>
constexpr const char* machine_name<mcafee::Options>() {
  return "mcafee";
}
inline const std::vector<std::string>& machines() {
  static const std::vector<std::string> all{"kung", "an693", "mcafee"};
  return all;
}

// Keys that hold one value, axis keys once for x and once for y; order of run.toml.
template <class Options>
const std::vector<KeyOf<Options>>& keys_of();
template <>
const std::vector<Key>& keys_of<kung::Options>();
template <>
const std::vector<KeyOf<lm628::Options>>& keys_of<lm628::Options>();
template <>
const std::vector<KeyOf<mcafee::Options>>& keys_of<mcafee::Options>();
inline const std::vector<Key>& keys() { return keys_of<kung::Options>(); }

// "plant.x.mass_kg" -> "plant.mass_kg"; other names stay.
std::string short_form(const std::string& name);

// The key of that name; `plant.mass_kg` gives the keys of both axes, as do gains and chip.
template <class Options>
std::vector<const KeyOf<Options>*> find_keys_of(std::string_view name) {
  std::vector<const KeyOf<Options>*> found;
  for (const KeyOf<Options>& key : keys_of<Options>()) {
    if (key.name == name || short_form(key.name) == name) found.push_back(&key);
  }
  return found;
}

// Names a person may write, for suggestions: those of the keys and the two-axis short forms.
template <class Options>
const std::vector<std::string>& key_names_of() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
    for (const KeyInfo& key : keys_of<Options>()) {
      list.push_back(key.name);
      list.push_back(short_form(key.name));
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }();
  return all;
}

std::string range_text(const KeyInfo& key);    // "0..5", "one of fc, afc", "true or false"
std::string value_text(const Value& value);    // as TOML writes it

}  // namespace trammel::testbench
