// SPDX-License-Identifier: Apache-2.0
#include "lab/layers.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <functional>
#include <map>

#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "host/parse.hpp"
#include "host/text.hpp"
#include "lab/heading.hpp"
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

[[noreturn]] void unknown_key(const Settings& settings, const std::string& where,
                              const std::string& name) {
  for (const Machine* other : machines()) {
    if (find_keys(other->keys(), name).empty()) continue;
    throw host::ConfigError(
        fmt::format("{}: {}: not a key of the machine {}", where, host::shown(name),
                    settings.machine().name));
  }
  throw host::ConfigError(fmt::format("{}: {}: unknown key{}", where, host::shown(name),
                                      hint(name, key_names(settings.machine().keys()),
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
  const auto fail = [&](const std::string& what) {
    throw host::ConfigError(fmt::format("{}: {}: value {} {}", where, key.name,
                                        host::shown(value_text(value)), what));
  };
  const auto* const text = std::get_if<std::string>(&value);
  const auto* const whole = std::get_if<std::int64_t>(&value);
  const auto* const real = std::get_if<double>(&value);
  switch (key.kind) {
    case Kind::kFlag:
      if (!std::holds_alternative<bool>(value)) fail("is not true or false");
      return value;
    case Kind::kText:
    case Kind::kFile:
      if (text == nullptr) fail("is not text");
      if (!is_utf8(*text)) fail("is not UTF-8");
      return value;
    case Kind::kChoice: {
      const auto& all = key.choices;
      const bool known = text != nullptr && std::find(all.begin(), all.end(), *text) != all.end();
      if (!known) fail("is not " + range_text(key));
      return value;
    }
    case Kind::kInteger:
      if (whole == nullptr) fail("is not a whole number in " + range_text(key));
      // Compared as integers: a double does not hold every one of them.
      if (*whole < static_cast<std::int64_t>(key.min) ||
          *whole > static_cast<std::int64_t>(key.max)) {
        fail("is out of range " + range_text(key));
      }
      return value;
    case Kind::kReal: break;
  }
  if (whole == nullptr && real == nullptr) fail("is not a number in " + range_text(key));
  const double x = whole != nullptr ? static_cast<double>(*whole) : *real;
  if (!(x >= key.min && x <= key.max)) fail("is out of range " + range_text(key));
  return x;
}

// Text of the command line or environment, read as the key's kind wants it.
Value parsed(const Key& key, const std::string& text) {
  static const std::map<std::string, bool> kFlags{
      {"true", true},   {"on", true},   {"yes", true}, {"1", true},
      {"false", false}, {"off", false}, {"no", false}, {"0", false}};
  const char* const end = text.data() + text.size();
  char* stop = nullptr;
  if (key.kind == Kind::kFlag) {
    if (const auto flag = kFlags.find(text); flag != kFlags.end()) return flag->second;
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

struct Entry {
  std::string name;
  std::string where;                       // begins messages
  std::function<Value(const Key&)> value;  // as that key wants it
  std::vector<const Key*> keys{};          // of that name
};

const FormerKey* former_key(const Settings& settings, const std::string& name) {
  const auto& all = settings.machine().former_keys;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const FormerKey& one) { return one.key.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Entry text_entry(const std::string& name, const std::string& text, const std::string& where) {
  return {name, where, [text](const Key& key) { return parsed(key, text); }};
}

constexpr int kAssigned = 1'000'000;  // the layer of -s and of the environment
constexpr const char* kWritten = "# Written by trammel;";  // line 1 of run.toml

void apply(Settings& settings, std::vector<Entry> entries, const fs::path& folder, int layer);

// Behind the keys of its layer: a run.toml of the version before has them all.
void apply_former(Settings& settings, const FormerKey& former, const Entry& entry,
                  const fs::path& folder, int layer) {
  const Value value = checked(former.key, entry.value(former.key), entry.where);
  std::vector<Entry> entries;
  std::string now;
  for (const std::string& text : former.now(settings, value)) {
    const auto at = text.find('=');
    entries.push_back(text_entry(text.substr(0, at), text.substr(at + 1), entry.where));
    now += " -s " + text;
  }
  if (entries.empty()) return;
  apply(settings, entries, folder, layer);
  settings.notices.push_back(
      fmt::format("{}: {}: the next version does not have this key; use{}", entry.where,
                  former.key.name, now));
}

void apply(Settings& settings, std::vector<Entry> entries, const fs::path& folder, int layer) {
  for (Entry& entry : entries) entry.keys = find_keys(settings.machine().keys(), entry.name);
  // Short forms (both axes) first, so that [plant.x] refines [plant] wherever it stands.
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.keys.size() > b.keys.size();
  });
  for (const Entry& entry : entries) {
    if (entry.keys.empty()) {
      const FormerKey* const former = former_key(settings, entry.name);
      if (former == nullptr) unknown_key(settings, entry.where, entry.name);
      apply_former(settings, *former, entry, folder, layer);
    }
    for (const Key* key : entry.keys) {
      Value value = checked(*key, entry.value(*key), entry.where);
      if (key->kind == Kind::kFile) {
        const fs::path file = std::get<std::string>(value);
        if (!file.empty() && file.is_relative()) value = fs::absolute(folder / file).string();
        checked(*key, value, entry.where);  // the folder may have any name
      }
      const Value before = key->get(settings);
      key->set(settings, value);
      settings.set_by[key->name] = {layer, layer == kAssigned ? "" : entry.where + ": "};
      if (value != before) note_change(settings, *key, before);
    }
  }
  for (const Entry& entry : entries) {  // it describes what its own layer has
    if (entry.name != "description") continue;
    const Key& key = *entry.keys.front();
    key.set(settings, checked(key, entry.value(key), entry.where));
    settings.heading = {};
  }
}

// By -s or by the environment.
void assign(Settings& settings, const std::vector<Entry>& entries) {
  apply(settings, entries, fs::current_path(), kAssigned);
}

Entry node_entry(const std::string& name, const toml::node& node, const std::string& source) {
  const std::string where = fmt::format("{}:{}", source, node.source().begin.line);
  return {name, where, [&node, name, where](const Key& key) -> Value {
            if (const auto* flag = node.as_boolean()) return flag->get();
            if (const auto* whole = node.as_integer()) return whole->get();
            if (const auto* real = node.as_floating_point()) return real->get();
            if (const auto* text = node.as_string()) return text->get();
            throw host::ConfigError(
                fmt::format("{}: {}: expects {}", where, name, range_text(key)));
          }};
}

void flatten(const toml::table& table, const std::string& prefix, const std::string& source,
             std::vector<Entry>& entries) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const auto* inner = node.as_table()) {
      flatten(*inner, name + '.', source, entries);
    } else {
      entries.push_back(node_entry(name, node, source));
    }
  }
}

}  // namespace

void apply_text(Settings& settings, const std::string& toml, const std::string& source,
                const fs::path& folder) {
  host::check_depth(toml, source);
  toml::table table;
  try {
    table = toml::parse(toml, source);
  } catch (const toml::parse_error& error) {
    throw host::ConfigError(fmt::format("{}:{}: {}", source, error.source().begin.line,
                                        std::string(error.description())));
  }
  std::vector<Entry> entries;
  flatten(table, "", source, entries);
  apply(settings, entries, folder, ++settings.layers);
  // A record repeats its run, which run.max_s may have cut.
  if (toml.rfind(kWritten, 0) == 0) settings.set_by["run.max_s"].layer = ++settings.layers;
}

void apply_file(Settings& settings, const fs::path& file) {
  apply_text(settings, host::read_text(file, host::kMostWritten), file.string(),
             fs::absolute(file).parent_path());
}

void apply_assignment(Settings& settings, const std::string& assignment, const std::string& where) {
  const auto at = assignment.find('=');
  if (at == std::string::npos || at == 0) {
    throw host::ConfigError(
        fmt::format("{} {}: expects key=value", where, host::shown(assignment)));
  }
  assign(settings, {text_entry(assignment.substr(0, at), assignment.substr(at + 1), where)});
}

void apply_environment(Settings& settings,
                       const std::vector<std::pair<std::string, std::string>>& variables) {
  const std::string prefix = "TRAMMEL_";
  std::vector<std::string> all = key_names(settings.machine().keys());
  for (const FormerKey& former : settings.machine().former_keys) all.push_back(former.key.name);
  std::vector<Entry> entries;
  for (const auto& [variable, value] : variables) {
    if (variable.rfind(prefix, 0) != 0) continue;
    const std::string rest = variable.substr(prefix.size());
    const auto key = std::find_if(all.begin(), all.end(),
                                  [&](const std::string& name) { return upper(name) == rest; });
    if (key != all.end()) {
      entries.push_back(text_entry(*key, value, "environment " + variable));
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
    throw host::ConfigError(fmt::format("environment: {}: unknown key{}", host::shown(variable),
                                        hint(variable, names)));
  }
  assign(settings, entries);
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
  std::string text =
      fmt::format("{} `{}` repeats this run.\n", kWritten, host::printable(command));
  std::string section;
  for (const Key& key : settings.machine().keys()) {
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

namespace {

// The name of a run is that of its folder.
void check_name(const std::string& name) {
  constexpr std::size_t kLongest = 200;  // bytes; a file system takes 255 with what is added
  const bool bad = name.empty() || name.front() == '.' || name.size() > kLongest ||
                   name.find('/') != std::string::npos || host::printable(name) != name;
  if (!bad) return;
  throw host::ConfigError(
      fmt::format("name: {} cannot name an output folder: 1 to {} bytes of UTF-8, no slash or "
                  "control character, no dot at the start", host::shown(value_text(name)),
                  kLongest));
}

// Ways to run a chip that exclude each other, and what a machine does not offer.
void check_engine(const Settings& settings) {
  const cosim::RunOptions& run = settings.run;
  const Capabilities& can = settings.machine().can;
  const bool waves = run.wave != cosim::WaveFormat::kNone || !run.wave_trigger.empty();
  const bool twin = run.engine == cosim::Engine::kTwin;
  const std::string lacking = fmt::format("the machine {} declares no", settings.machine().name);
  const std::pair<bool, std::string> rules[] = {
      {run.audit && !can.leap,
       fmt::format("run.audit: {} leap contract, so that no clock is leapt over and there is "
                   "nothing to compare", lacking)},
      {twin && !can.twin, fmt::format("run.engine: {} bit-exact twin of its chip", lacking)},
      {run.audit && (!run.leap || run.assertions || waves),
       "run.audit: compares a leaping chip with a plain one; not with --no-leap, --assert or "
       "waves"},
      {twin && waves,
       "run.engine: the twin has no signals to trace; waves and triggers need the RTL (--engine "
       "rtl)"},
      {twin && run.assertions,
       "run.engine: the twin has no assertions; --assert needs the RTL (--engine rtl)"},
      {twin && !run.domains,
       "run.domains: the twin has no clock domains; the RTL has (--engine rtl)"},
      {twin && (!run.leap || run.audit),
       "run.engine: the twin has no clocks to evaluate; --no-leap and --audit need the RTL "
       "(--engine rtl)"}};
  for (const auto& [broken, message] : rules) {
    if (broken) throw host::ConfigError(message);
  }
}

// Who names a program in place of a scenario wants it run, and no other path.
void check_program(const Settings& settings) {
  if (settings.program.empty()) return;
  const Machine& machine = settings.machine();
  const auto asked = machine.defaults();
  std::vector<std::string> names{machine.program.key};
  for (const std::string& text : machine.program.assignments) {
    apply_assignment(*asked, text);
    names.push_back(text.substr(0, text.find('=')));
  }
  find_keys(machine.keys(), names.front()).front()->set(*asked, settings.program);
  for (const std::string& name : names) {
    for (const Key* const key : find_keys(machine.keys(), name)) {
      const Value value = key->get(settings), wanted = key->get(*asked);
      if (value == wanted) continue;
      throw host::ConfigError(
          fmt::format("{}: {}: value {} must be {}: else this program is not run",
                      host::shown(settings.program), key->name, host::shown(value_text(value)),
                      host::shown(value_text(wanted))));
    }
  }
}

}  // namespace

void validate(Settings& settings) {
  check_name(settings.scenario);
  check_program(settings);
  check_engine(settings);
  check_waves(settings);
  if (settings.machine().validate != nullptr) settings.machine().validate(settings);
}

}  // namespace trammel::lab
