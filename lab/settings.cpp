// SPDX-License-Identifier: Apache-2.0
#include "lab/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace trammel::lab {

std::string short_form(const std::string& name) {
  for (const char* axis : {".x.", ".y."}) {
    const auto at = name.find(axis);
    if (at != std::string::npos) return name.substr(0, at) + name.substr(at + 2);
  }
  return name;
}

std::vector<const Key*> find_keys(const std::vector<Key>& keys, std::string_view name) {
  std::vector<const Key*> found;
  for (const Key& key : keys) {
    const bool shorter = key.name.size() == name.size() + 2;  // by the axis: cheaper than its form
    if (key.name == name || (shorter && short_form(key.name) == name)) found.push_back(&key);
  }
  return found;
}

std::vector<std::string> key_names(const std::vector<Key>& keys) {
  std::vector<std::string> list;
  for (const Key& key : keys) {
    list.push_back(key.name);
    list.push_back(short_form(key.name));
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::string range_text(const Key& key) {
  switch (key.kind) {
    case Kind::kFlag: return "true or false";
    case Kind::kText: return "text";
    case Kind::kFile: return "path of a file";
    case Kind::kChoice: return fmt::format("one of {}", fmt::join(key.choices, ", "));
    case Kind::kInteger: return fmt::format("{:.0f}..{:.0f}", key.min, key.max);
    case Kind::kReal: break;
  }
  return fmt::format("{:g}..{:g}", key.min, key.max);
}

std::string value_text(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) {
    // Shortest text that reads back as the same number; TOML wants a point or an exponent.
    std::string text = fmt::format("{}", *real);
    if (std::isfinite(*real) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
  }
  std::string text = "\"";
  for (const char c : std::get<std::string>(value)) {
    if (c == '"' || c == '\\') text += '\\';
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) {
      text += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string suggest(const std::string& word, const std::vector<std::string>& words) {
  // The last part is what people mistype most: `coulomb` alone still finds `plant.coulomb_N`.
  std::string best;
  // Half of a short word is another one.
  const std::size_t most = word.size() < 5 ? 1 : std::max<std::size_t>(2, word.size() / 3);
  std::size_t best_distance = most + 1;
  for (const std::string& other : words) {
    if (word.size() > other.size() + most) continue;  // as many letters would have to go
    std::vector<std::size_t> row(other.size() + 1);
    for (std::size_t j = 0; j <= other.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t corner = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= other.size(); ++j) {
        const bool same = std::tolower(static_cast<unsigned char>(word[i - 1])) ==
                          std::tolower(static_cast<unsigned char>(other[j - 1]));
        const std::size_t replaced = corner + (same ? 0 : 1);
        corner = row[j];
        row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
      }
    }
    const bool begun = word.size() >= 2 && other.rfind(word, 0) == 0;  // no more was typed
    if (begun) row.back() = 1;
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = other;
    }
  }
  return best;
}

std::string hint(const std::string& word, const std::vector<std::string>& words,
                 const std::string& otherwise) {
  const std::string near = suggest(word, words);
  return near.empty() ? otherwise : fmt::format("; did you mean {}?", near);
}

}  // namespace trammel::lab
