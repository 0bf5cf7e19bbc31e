// SPDX-License-Identifier: Apache-2.0
#include "lab/heading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "host/text.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {
namespace {

using Altered = std::vector<std::pair<std::string, std::string>>;

std::string without_parentheses(const std::string& text) {
  const auto begin = text.rfind(" (");
  return text.back() == ')' && begin != std::string::npos ? text.substr(0, begin) : text;
}

Altered::iterator find(Altered& altered, const std::string& name) {
  return std::find_if(altered.begin(), altered.end(),
                      [&](const auto& one) { return one.first == name; });
}

std::string shown_value(const Settings& settings, const Key& key) {
  const Value value = key.get(settings);
  const auto* const real = std::get_if<double>(&value);
  return real != nullptr ? fmt::format("{}", *real) : host::shown(value_text(value));
}

// The short form where both axes have this value.
std::string shown_name(Settings& settings, const Key& key) {
  const std::string both = short_form(key.name);
  const std::vector<const Key*> keys = find_keys(settings.machine().keys(), both);
  const bool same = std::all_of(keys.begin(), keys.end(), [&](const Key* one) {
    return find(settings.heading.altered, one->name) != settings.heading.altered.end() &&
           one->get(settings) == key.get(settings);
  });
  return same ? both : key.name;
}

std::string altered_text(Settings& settings) {
  constexpr std::size_t kMostShown = 3;
  std::vector<std::string> told;
  for (const auto& one : settings.heading.altered) {
    const Key& key = *find_keys(settings.machine().keys(), one.first).front();
    const std::string text =
        fmt::format("{} = {}", shown_name(settings, key), shown_value(settings, key));
    if (std::find(told.begin(), told.end(), text) == told.end()) told.push_back(text);
  }
  const std::size_t more = told.size() - std::min(told.size(), kMostShown);
  told.resize(told.size() - more);
  return fmt::format("{}{}", fmt::join(told, ", "),
                     more == 0 ? "" : fmt::format(" and {} more", more));
}

}  // namespace

void note_change(Settings& settings, const Key& key, const Value& before) {
  if (settings.description.empty()) return;
  const Described& described = settings.machine().described;
  Heading& heading = settings.heading;
  if (heading.altered.empty()) heading.own = settings.description;
  if (key.name == described.by) {
    heading.own = fmt::format("{} = {} in place of the scenario's {}", key.name,
                              shown_value(settings, key), host::shown(value_text(before)));
  } else if (described.alters != nullptr) {
    const auto at = find(heading.altered, key.name);
    const Value now = key.get(settings);
    const std::string original = at == heading.altered.end() ? value_text(before) : at->second;
    const bool alters = described.alters(key, now) && value_text(now) != original;
    if (!alters && at != heading.altered.end()) heading.altered.erase(at);
    if (alters && at == heading.altered.end()) heading.altered.emplace_back(key.name, original);
  }
  settings.description = heading.own;
  if (heading.altered.empty()) return;
  std::string own = without_parentheses(heading.own);
  if (described.reworded != nullptr) own = described.reworded(settings, std::move(own));
  settings.description = fmt::format("{}; here {}", own, altered_text(settings));
}

}  // namespace trammel::lab
