// SPDX-License-Identifier: Apache-2.0
#include "lab/layers.hpp"

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

#include "lab/files.hpp"
#include "lab/machine.hpp"
#include "lab/waves.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

std::string upper(std::string text) {
  for (char& c : text) {
    c = c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

const std::vector<Key>& keys_of(const Settings& settings) { return settings.machine().keys(); }

[[noreturn]] void unknown_key(const Settings& settings, const std::string& where,
                              const std::string& name) {
  for (const Machine* other : machines()) {
    if (find_keys(other->keys(), name).empty()) continue;
    throw ConfigError(fmt::format("{}: {}: is no key of the machine {}", where, name,
                                  settings.machine().name));
  }
  throw ConfigError(fmt::format("{}: {}: unknown key{}", where, name,
                                hint(name, key_names(keys_of(settings)),
                                     "; `trammel list keys` names them all")));
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
Value checked(const Key& key, const Value& value, const std::string& where) {
  const auto fail = [&](const std::string& what) -> Value {
    throw ConfigError(fmt::format("{}: {}: value {} {}", where, key.name, value_text(value), what));
  };
  const auto in_range = [&](double x) { return x >= key.min && x <= key.max; };
  const auto whole_in_range = [&](std::int64_t x) {  // a double does not hold every one of them
    return x >= static_cast<std::int64_t>(key.min) && x <= static_cast<std::int64_t>(key.max);
  };
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  switch (key.kind) {
    case Kind::kFlag:
      return std::holds_alternative<bool>(value) ? value : fail("is not true or false");
    case Kind::kText:
    case Kind::kFile:
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
      if (!whole_in_range(*whole)) return fail("is out of range " + range_text(key));
      return value;
    case Kind::kReal: break;
  }
  if (whole == nullptr && real == nullptr) return fail("is not a number " + range_text(key));
  const double x = whole != nullptr ? static_cast<double>(*whole) : *real;
  return in_range(x) ? Value{x} : fail("is out of range " + range_text(key));
}

// Text of the command line or environment, read as the key's kind wants it.
Value parsed(const Key& key, const std::string& text) {
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

void set_keys(Settings& settings, const std::vector<const Key*>& found, const Value& value,
              const std::string& where, const fs::path& folder) {
  for (const Key* key : found) {
    Value good = checked(*key, value, where);
    if (key->kind == Kind::kFile) {
      const fs::path file = std::get<std::string>(good);
      if (!file.empty() && file.is_relative()) good = fs::absolute(folder / file).string();
    }
    key->set(settings, good);
  }
}

void set_text(Settings& settings, const std::string& name, const std::string& text,
              const std::string& where) {
  const auto found = find_keys(keys_of(settings), name);
  if (found.empty()) unknown_key(settings, where, name);
  set_keys(settings, found, parsed(*found.front(), text), where, fs::current_path());
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

void apply_text(Settings& settings, const std::string& toml, const std::string& source,
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
  std::stable_sort(entries.begin(), entries.end(), [&settings](const Entry& a, const Entry& b) {
    return find_keys(keys_of(settings), a.name).size() >
           find_keys(keys_of(settings), b.name).size();
  });
  for (const Entry& entry : entries) {
    const std::string where = fmt::format("{}:{}", source, entry.node->source().begin.line);
    const auto found = find_keys(keys_of(settings), entry.name);
    if (found.empty()) unknown_key(settings, where, entry.name);
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
    set_keys(settings, found, value, where, folder);
  }
}

void apply_file(Settings& settings, const fs::path& file) {
  apply_text(settings, read_text(file), file.string(), fs::absolute(file).parent_path());
}

void apply_assignment(Settings& settings, const std::string& assignment, const std::string& where) {
  const auto at = assignment.find('=');
  if (at == std::string::npos || at == 0) {
    throw ConfigError(fmt::format("{} {}: expects key=value", where, assignment));
  }
  set_text(settings, assignment.substr(0, at), assignment.substr(at + 1), where);
}

void apply_environment(Settings& settings,
                       const std::vector<std::pair<std::string, std::string>>& variables) {
  const std::string prefix = "TRAMMEL_";
  const std::vector<std::string> all = key_names(keys_of(settings));
  std::vector<std::pair<std::string, std::string>> found;  // key and value
  for (const auto& [variable, value] : variables) {
    if (variable.rfind(prefix, 0) != 0) continue;
    const std::string rest = variable.substr(prefix.size());
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
    throw ConfigError(
        fmt::format("environment: {}: unknown key{}", variable, hint(variable, names)));
  }
  std::stable_sort(found.begin(), found.end(), [&settings](const auto& a, const auto& b) {
    return find_keys(keys_of(settings), a.first).size() >
           find_keys(keys_of(settings), b.first).size();
  });
  for (const auto& [key, value] : found) {
    set_text(settings, key, value, "environment " + prefix + upper(key));
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

std::string run_toml(const Settings& settings, const std::string& command,
                     bool (*left_out)(const Key&)) {
  std::string text = fmt::format("# Written by trammel; `{}` repeats this run.\n", command);
  std::string section;
  for (const Key& key : keys_of(settings)) {
    if (left_out != nullptr && left_out(key)) continue;
    const auto dot = key.name.rfind('.');
    const std::string here = dot == std::string::npos ? "" : key.name.substr(0, dot);
    if (here != section) text += fmt::format("\n[{}]\n", here);
    section = here;
    text += fmt::format("{} = {}\n", dot == std::string::npos ? key.name : key.name.substr(dot + 1),
                        value_text(key.get(settings)));
  }
  return text;
}

void check_name(const std::string& name, const std::string& what) {
  constexpr std::size_t kLongest = 200;  // bytes; a file system takes 255 with what is added
  const bool bad = name.empty() || name.front() == '.' || name.size() > kLongest ||
                   name.find('/') != std::string::npos ||
                   std::any_of(name.begin(), name.end(),
                               [](unsigned char c) { return std::iscntrl(c) != 0; });
  if (!bad) return;
  throw ConfigError(fmt::format("{}: {} cannot name an output folder: 1 to {} bytes, no slash "
                                "or control character, no dot at the start",
                                what, value_text(name), kLongest));
}

namespace {

// Ways to look at a chip that exclude each other, and what a machine does not offer.
void check_engine(const Settings& settings) {
  const cosim::RunBasics& run = settings.run;
  const auto refuse_if = [](bool bad, const std::string& message) {
    if (bad) throw ConfigError(message);
  };
  const bool waves = run.wave != cosim::WaveFormat::kNone || !run.wave_trigger.empty();
  const std::string lacking = fmt::format("the machine {} declares no", settings.machine().name);
  const Capabilities& can = settings.machine().can;
  refuse_if(run.audit && !can.leap,
            fmt::format("run.audit: {} leap contract, so that no clock is leapt over and there is "
                        "nothing to compare", lacking));
  refuse_if(run.engine == cosim::Engine::kTwin && !can.twin,
            fmt::format("run.engine: {} bit-exact twin of its chip", lacking));
  refuse_if(run.audit && (!run.leap || run.assertions || waves),
            "run.audit: compares a leaping chip with a plain one; not with --no-leap, --assert or "
            "waves");
  if (run.engine == cosim::Engine::kRtl) return;
  refuse_if(waves,
            "run.engine: the twin has no signals to trace; waves and triggers need the RTL "
            "(--engine rtl)");
  refuse_if(run.assertions,
            "run.engine: the twin has no assertions; --assert needs the RTL (--engine rtl)");
  refuse_if(!run.leap || run.audit,
            "run.engine: the twin has no clocks to evaluate; --no-leap and --audit need the RTL "
            "(--engine rtl)");
}

}  // namespace

void validate(Settings& settings) {
  check_name(settings.scenario, "name");
  check_engine(settings);
  check_waves(settings);
  if (settings.machine().validate != nullptr) settings.machine().validate(settings);
}

}  // namespace trammel::lab
