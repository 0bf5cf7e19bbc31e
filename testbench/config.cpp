// SPDX-License-Identifier: Apache-2.0
#include "testbench/config.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "testbench/build_info.hpp"

namespace trammel::testbench {
namespace fs = std::filesystem;
namespace {

std::string upper(std::string text) {
  for (char& c : text) {
    c = c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

template <class Options>
bool is_key_of(const std::string& name) {
  return !find_keys_of<Options>(name).empty();
}

template <class Options>
[[noreturn]] void unknown_key(const std::string& where, const std::string& name) {
  if (is_key_of<kung::Options>(name) || is_key_of<lm628::Options>(name) ||
      is_key_of<mcafee::Options>(name)) {
    throw ConfigError(fmt::format("{}: {}: is no key of the machine {}", where, name,
                                  machine_name<Options>()));
  }
  const std::string near = suggest(name, key_names_of<Options>());
  throw ConfigError(fmt::format("{}: {}: unknown key{}", where, name,
                                near.empty() ? "; `trammel list keys` names them all"
                                             : fmt::format("; did you mean {}?", near)));
}

// JSON and TOML hold nothing else.
bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

// Brings a value to the key's kind and checks its range.
Value checked(const KeyInfo& key, const Value& value, const std::string& where) {
  const auto fail = [&](const std::string& what) -> Value {
    throw ConfigError(fmt::format("{}: {}: value {} {}", where, key.name, value_text(value), what));
  };
  const auto in_range = [&](double x) { return x >= key.min && x <= key.max; };
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  switch (key.kind) {
    case Kind::kFlag:
      return std::holds_alternative<bool>(value) ? value : fail("is not true or false");
    case Kind::kText:
      if (!std::holds_alternative<std::string>(value)) return fail("is not text");
      return is_utf8(std::get<std::string>(value)) ? value : fail("is not UTF-8");
    case Kind::kChoice: {
      const auto* text = std::get_if<std::string>(&value);
      const bool known = text != nullptr && std::find(key.choices.begin(), key.choices.end(),
                                                      *text) != key.choices.end();
      return known ? value : fail("is not " + range_text(key));
    }
    case Kind::kInteger:
      if (whole == nullptr) return fail("is not a whole number " + range_text(key));
      if (!in_range(static_cast<double>(*whole))) return fail("is out of range " + range_text(key));
      return value;
    case Kind::kReal: break;
  }
  if (whole == nullptr && real == nullptr) return fail("is not a number " + range_text(key));
  const double x = whole != nullptr ? static_cast<double>(*whole) : *real;
  return in_range(x) ? Value{x} : fail("is out of range " + range_text(key));
}

// Text of the command line or environment, read as the key's kind wants it.
Value parsed(const KeyInfo& key, const std::string& text) {
  const char* const end = text.data() + text.size();
  char* stop = nullptr;
  if (key.kind == Kind::kFlag) {
    for (const char* yes : {"true", "on", "yes", "1"}) {
      if (text == yes) return true;
    }
    for (const char* no : {"false", "off", "no", "0"}) {
      if (text == no) return false;
    }
  } else if (key.kind == Kind::kInteger && !text.empty()) {
    errno = 0;
    const long long whole = std::strtoll(text.c_str(), &stop, 10);
    if (stop == end && errno == 0) return static_cast<std::int64_t>(whole);
  } else if (key.kind == Kind::kReal && !text.empty()) {
    const double real = std::strtod(text.c_str(), &stop);
    if (stop == end) return real;
  }
  return text;
}

template <class Options>
void set_keys(Options& options, const std::vector<const KeyOf<Options>*>& found, const Value& value,
              const std::string& where, const fs::path& folder) {
  for (const KeyOf<Options>* key : found) {
    Value good = checked(*key, value, where);
    if (key->name == "path.points_file") {
      const fs::path file = std::get<std::string>(good);
      if (!file.empty() && file.is_relative()) good = fs::absolute(folder / file).string();
    }
    key->set(options, good);
  }
}

template <class Options>
void set_text(Options& options, const std::string& name, const std::string& text,
              const std::string& where) {
  const auto found = find_keys_of<Options>(name);
  if (found.empty()) unknown_key<Options>(where, name);
  set_keys(options, found, parsed(*found.front(), text), where, fs::current_path());
}

struct Entry {
  std::string name;
  const toml::node* node;
};

void flatten(const toml::table& table, const std::string& prefix, std::vector<Entry>& entries) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const auto* inner = node.as_table()) {
      flatten(*inner, name + '.', entries);
    } else {
      entries.push_back({name, &node});
    }
  }
}

}  // namespace

std::string suggest(const std::string& word, const std::vector<std::string>& words) {
  // The last part is what people mistype most: `coulomb` alone still finds `plant.coulomb_N`.
  std::string best;
  // Half of a short word is another one.
  const std::size_t most = word.size() < 5 ? 1 : std::max<std::size_t>(2, word.size() / 3);
  std::size_t best_distance = most + 1;
  for (const std::string& other : words) {
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

template <class Options>
void apply_text(Options& options, const std::string& toml, const std::string& source,
                const fs::path& folder) {
  toml::table table;
  try {
    table = toml::parse(toml, source);
  } catch (const toml::parse_error& error) {
    throw ConfigError(fmt::format("{}:{}: {}", source, error.source().begin.line,
                                  std::string(error.description())));
  }
  std::vector<Entry> entries;
  flatten(table, "", entries);
  // Short forms (both axes) first, so that [plant.x] refines [plant] wherever it stands.
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return find_keys_of<Options>(a.name).size() > find_keys_of<Options>(b.name).size();
  });
  for (const Entry& entry : entries) {
    const std::string where = fmt::format("{}:{}", source, entry.node->source().begin.line);
    const auto found = find_keys_of<Options>(entry.name);
    if (found.empty()) unknown_key<Options>(where, entry.name);
    Value value;
    if (const auto* flag = entry.node->as_boolean()) {
      value = flag->get();
    } else if (const auto* whole = entry.node->as_integer()) {
      value = whole->get();
    } else if (const auto* real = entry.node->as_floating_point()) {
      value = real->get();
    } else if (const auto* text = entry.node->as_string()) {
      value = text->get();
    } else {
      throw ConfigError(fmt::format("{}: {}: expects {}", where, entry.name,
                                    range_text(*found.front())));
    }
    set_keys(options, found, value, where, folder);
  }
}

std::string read_text(const fs::path& file) {
  std::error_code ignored;
  std::ifstream in(file);
  if (!in || fs::is_directory(file, ignored)) {
    throw ConfigError(fmt::format("{}: cannot be read: {}", file.string(),
                                  in ? "it is a folder" : std::strerror(errno)));
  }
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

template <class Options>
void apply_file(Options& options, const fs::path& file) {
  apply_text(options, read_text(file), file.string(), fs::absolute(file).parent_path());
}

template <class Options>
void apply_assignment(Options& options, const std::string& assignment, const std::string& where) {
  const auto at = assignment.find('=');
  if (at == std::string::npos || at == 0) {
    throw ConfigError(fmt::format("{} {}: expects key=value", where, assignment));
  }
  set_text(options, assignment.substr(0, at), assignment.substr(at + 1), where);
}

template <class Options>
void apply_environment(Options& options,
                       const std::vector<std::pair<std::string, std::string>>& variables) {
  const std::string prefix = "TRAMMEL_";
  std::vector<std::pair<std::string, std::string>> found;  // key and value
  for (const auto& [variable, value] : variables) {
    if (variable.rfind(prefix, 0) != 0) continue;
    const std::string rest = variable.substr(prefix.size());
    const auto& all = key_names_of<Options>();
    const auto key = std::find_if(all.begin(), all.end(),
                                  [&](const std::string& name) { return upper(name) == rest; });
    if (key != all.end()) {
      found.emplace_back(*key, value);
      continue;
    }
    // Other programs may own TRAMMEL_ variables; inside a section it can only be a mistake.
    const bool in_section = std::any_of(all.begin(), all.end(), [&](const std::string& name) {
      const auto dot = name.find('.');
      return dot != std::string::npos && rest.rfind(upper(name.substr(0, dot + 1)), 0) == 0;
    });
    if (!in_section) continue;
    std::vector<std::string> names;
    for (const std::string& name : all) names.push_back(prefix + upper(name));
    const std::string near = suggest(variable, names);
    throw ConfigError(fmt::format("environment: {}: unknown key{}", variable,
                                  near.empty() ? "" : fmt::format("; did you mean {}?", near)));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return find_keys_of<Options>(a.first).size() > find_keys_of<Options>(b.first).size();
  });
  for (const auto& [key, value] : found) {
    set_text(options, key, value, "environment " + prefix + upper(key));
  }
}

std::vector<std::pair<std::string, std::string>> environment() {
  std::vector<std::pair<std::string, std::string>> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const auto at = text.find('=');
    if (at != std::string::npos) all.emplace_back(text.substr(0, at), text.substr(at + 1));
  }
  return all;
}

template <class Options>
std::string run_toml(const Options& options, const std::string& command,
                     bool (*left_out)(const KeyInfo&)) {
  std::string text = fmt::format("# Written by trammel; `{}` repeats this run.\n", command);
  std::string section;
  for (const KeyOf<Options>& key : keys_of<Options>()) {
    if (left_out != nullptr && left_out(key)) continue;
    const auto dot = key.name.rfind('.');
    const std::string here = dot == std::string::npos ? "" : key.name.substr(0, dot);
    if (here != section) text += fmt::format("\n[{}]\n", here);
    section = here;
    text += fmt::format("{} = {}\n", dot == std::string::npos ? key.name : key.name.substr(dot + 1),
                        value_text(key.get(options)));
  }
  return text;
}

// The Options of every machine.
#define TRAMMEL_INSTANTIATE(Options)                                                              \
  template void apply_file(Options&, const fs::path&);                                            \
  template void apply_text(Options&, const std::string&, const std::string&, const fs::path&);    \
  template void apply_assignment(Options&, const std::string&, const std::string&);               \
  template void apply_environment(Options&,                                                       \
                                  const std::vector<std::pair<std::string, std::string>>&);       \
  template std::string run_toml(const Options&, const std::string&, bool (*)(const KeyInfo&))
TRAMMEL_INSTANTIATE(kung::Options);
TRAMMEL_INSTANTIATE(lm628::Options);
TRAMMEL_INSTANTIATE(mcafee::Options);
#undef TRAMMEL_INSTANTIATE

std::string machine_of(const fs::path& file) {
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error&) {
    return machines().front();
  }
  const auto* const key = table.get("machine");
  if (key == nullptr || !key->is_string()) return machines().front();
  const std::string name = key->as_string()->get();
  if (std::find(machines().begin(), machines().end(), name) != machines().end()) return name;
  const std::string near = suggest(name, machines());
  throw ConfigError(fmt::format("{}:{}: machine: value \"{}\" is not one of {}{}", file.string(),
                                key->source().begin.line, name, fmt::join(machines(), ", "),
                                near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

std::vector<fs::path> built_in(const std::string& extension) {
  std::vector<fs::path> all;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(kScenarioFolder, ignored)) {
    if (entry.path().extension() == extension) all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<fs::path> scenarios(const std::string& machine) {
  std::vector<fs::path> all = built_in(".toml");
  const auto other = [&machine](const fs::path& file) {
    return !machine.empty() && machine_of(file) != machine;
  };
  all.erase(std::remove_if(all.begin(), all.end(), other), all.end());
  return all;
}

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
  throw ConfigError(fmt::format("{}: no such {}{}; built in: {}; or give a {} file", name, kind,
                                near.empty() ? "" : fmt::format(", did you mean {}?", near),
                                fmt::join(names, ", "), extension));
}

fs::path find_scenario(const std::string& name) { return find_built_in(name, ".toml", "scenario"); }

}  // namespace trammel::testbench
