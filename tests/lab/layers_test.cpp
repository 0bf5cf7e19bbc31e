// SPDX-License-Identifier: Apache-2.0
//
// How settings are layered, by the same rules for every key of every machine.
#include "lab/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>

#include "lab/machine.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;

namespace {

bool is_number(const Key& key) { return key.kind == Kind::kReal || key.kind == Kind::kInteger; }

Value number(const Key& key, double value) {
  if (key.kind == Kind::kReal) return value;
  return static_cast<std::int64_t>(value);
}

// Another value that the key takes, wherever it can have two.
Value other(const Key& key, const Value& now) {
  switch (key.kind) {
    case Kind::kFlag: return !std::get<bool>(now);
    case Kind::kInteger:
    case Kind::kReal: return number(key, now == number(key, key.max) ? key.min : key.max);
    case Kind::kChoice:
      return key.choices.back() == std::get<std::string>(now) ? key.choices.front()
                                                              : key.choices.back();
    case Kind::kText: return std::string("a \"word\" and \\ and\ttabs");
    case Kind::kFile: return std::string("/some/where.csv");
  }
  return now;
}

// As -s takes it.
std::string plain(const Value& value) {
  const auto* const text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : value_text(value);
}

std::string upper(std::string text) {
  for (char& c : text) {
    c = c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

// Calls `check` with each key of each machine and with defaults of that machine.
template <class Check>
void each_key(Check check) {
  for (const Machine* const machine : machines()) {
    REQUIRE(machine->keys().size() > 10);
    for (const Key& key : machine->keys()) {
      CAPTURE(machine->name, key.name);
      const auto settings = machine->defaults();
      check(*machine, key, *settings);
    }
  }
}

// The message for text that is refused; "" when it is accepted.
std::string message_of(const Machine& machine, const std::string& toml) {
  const auto settings = machine.defaults();
  return test::refusal_of([&] {
    apply_text(*settings, toml, "some.toml", ".");
    validate(*settings);
  });
}

}  // namespace

TEST_CASE("every key of every machine has a default in its range, a help and its own name") {
  each_key([](const Machine& machine, const Key& key, const Settings& settings) {
    CHECK_FALSE(key.help.empty());
    CHECK(find_keys(machine.keys(), key.name) == std::vector<const Key*>{&key});
    const Value value = key.get(settings);
    if (is_number(key)) {
      CHECK(key.min <= key.max);  // equal: inject.axis of a machine with one axis
      const double x = key.kind == Kind::kReal ? std::get<double>(value)
                                               : static_cast<double>(std::get<std::int64_t>(value));
      CHECK(x >= key.min);
      CHECK(x <= key.max);
    } else if (key.kind == Kind::kChoice) {
      CHECK(std::count(key.choices.begin(), key.choices.end(), std::get<std::string>(value)) == 1);
    }
  });
}

TEST_CASE("every key of every machine accepts what it prints, its limits and each of its choices") {
  each_key([](const Machine&, const Key& key, Settings& settings) {
    std::vector<Value> values{key.get(settings), other(key, key.get(settings))};
    if (is_number(key)) {
      values.push_back(number(key, key.min));
      values.push_back(number(key, key.max));
    }
    for (const std::string& choice : key.choices) values.emplace_back(choice);
    for (const Value& value : values) {
      apply_assignment(settings, key.name + '=' + plain(value));
      CHECK(value_text(key.get(settings)) == value_text(value));
    }
  });
}

TEST_CASE("a number below or above its range is refused with its key and the range") {
  each_key([](const Machine&, const Key& key, Settings& settings) {
    if (!is_number(key)) return;
    const Value before = key.get(settings);
    for (const double limit : {key.min, key.max}) {
      const int by = limit == key.min ? -1 : 1;
      const Value value = key.kind == Kind::kReal ? Value{limit + by}
                                                  : Value{static_cast<std::int64_t>(limit) + by};
      const std::string what = fmt::format("{}: value {} is out of range {}", key.name,
                                           value_text(value), range_text(key));
      CHECK_THROWS_WITH(apply_assignment(settings, key.name + '=' + value_text(value)),
                        "-s: " + what);
      CHECK_THROWS_WITH(apply_text(settings, "\n" + key.name + " = " + value_text(value), "a.toml",
                                   "."),
                        "a.toml:2: " + what);
      CHECK_THROWS_WITH(
          apply_environment(settings, {{"TRAMMEL_" + upper(key.name), value_text(value)}}),
          fmt::format("environment TRAMMEL_{}: {}", upper(key.name), what));
    }
    CHECK(value_text(key.get(settings)) == value_text(before));
  });
}

TEST_CASE("a value of the wrong type is refused with its key and what it takes") {
  each_key([](const Machine&, const Key& key, Settings& settings) {
    const Value before = key.get(settings);
    const auto refused = [&](const std::string& value, const std::string& what) {
      CHECK_THROWS_WITH(apply_text(settings, key.name + " = " + value, "a.toml", "."),
                        fmt::format("a.toml:1: {}: {}", key.name, what));
    };
    refused("[1, 2]", "expects " + range_text(key));
    switch (key.kind) {
      case Kind::kFlag: refused("2", "value 2 is not true or false"); break;
      case Kind::kInteger:
        refused("1.5", "value 1.5 is not a whole number in " + range_text(key));
        refused("'1'", "value \"1\" is not a whole number in " + range_text(key));
        break;
      case Kind::kReal:
        refused("'1'", "value \"1\" is not a number in " + range_text(key));
        refused("true", "value true is not a number in " + range_text(key));
        refused("nan", "value nan is out of range " + range_text(key));
        break;
      case Kind::kChoice:
        refused("'none such'", "value \"none such\" is not " + range_text(key));
        refused("1", "value 1 is not " + range_text(key));
        break;
      case Kind::kText:
      case Kind::kFile: refused("1", "value 1 is not text"); break;
    }
    CHECK(value_text(key.get(settings)) == value_text(before));
  });
}

TEST_CASE("text that is not UTF-8 is refused: no file of a run could hold it") {
  each_key([](const Machine&, const Key& key, Settings& settings) {
    if (key.kind != Kind::kText) return;
    CHECK_THROWS_WITH(apply_assignment(settings, key.name + "=a\xff"), Contains("not UTF-8"));
    apply_assignment(settings, key.name + "=\xc3\xa9");
    CHECK(plain(key.get(settings)) == "\xc3\xa9");
  });
}

TEST_CASE("run.toml repeats every key of every machine") {
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    const auto settings = machine->defaults();
    for (const Key& key : machine->keys()) key.set(*settings, other(key, key.get(*settings)));
    const auto again = machine->defaults();
    apply_text(*again, run_toml(*settings), "run.toml", ".");
    for (const Key& key : machine->keys()) {
      CAPTURE(key.name);
      CHECK(value_text(key.get(*again)) == value_text(key.get(*settings)));
    }
  }
}

TEST_CASE("a clone copies every key's value and is independent") {
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    const auto settings = machine->defaults();
    const auto clone = settings->clone();
    CHECK(&clone->machine() == machine);
    for (const Key& key : machine->keys()) {
      CAPTURE(key.name);
      const Value before = key.get(*settings);
      CHECK(key.get(*clone) == before);
      const Value value = other(key, before);
      key.set(*clone, value);
      CHECK(key.get(*clone) == value);
      CHECK(key.get(*settings) == before);
    }
  }
}

TEST_CASE("the environment sets every key by its upper-case name, as -s does, and nothing else") {
  each_key([](const Machine& machine, const Key& key, Settings& settings) {
    const Value value = other(key, key.get(settings));
    apply_environment(settings, {{"HOME", "/"},
                                 {"TRAMMEL_SOMETHING_ELSE", "1"},
                                 {"TRAMMEL_" + upper(key.name), plain(value)}});
    CHECK(value_text(key.get(settings)) == value_text(value));
    const auto assigned = machine.defaults();
    apply_assignment(*assigned, key.name + '=' + plain(value));
    CHECK(settings.set_by.at(key.name).layer == assigned->set_by.at(key.name).layer);
    if (key.name.find('.') == std::string::npos) return;
    const std::string wrong = "TRAMMEL_" + upper(key.name) + "Q";
    CHECK_THROWS_WITH(apply_environment(settings, {{wrong, plain(value)}}),
                      Contains("environment: " + wrong + ": unknown key; did you mean TRAMMEL_"));
  });
}

TEST_CASE("an unknown key is refused with a suggestion") {
  each_key([](const Machine&, const Key& key, Settings& settings) {
    const std::string wrong = key.name + 'q';
    const std::string what =
        fmt::format("{}: unknown key; did you mean {}?", wrong, key.name);
    CHECK_THROWS_WITH(apply_assignment(settings, wrong + "=1"), "-s: " + what);
    CHECK_THROWS_WITH(apply_text(settings, wrong + " = 1", "a.toml", "."), "a.toml:1: " + what);
  });
  for (const Machine* const machine : machines()) {
    CHECK_THROWS_WITH(
        apply_assignment(*machine->defaults(), "zzzzzzzzzzzz=1"),
        "-s: zzzzzzzzzzzz: unknown key; `trammel list keys` names them all");
  }
}

TEST_CASE("a key of another machine is refused with the name of this one") {
  std::size_t refused = 0;
  each_key([&refused](const Machine&, const Key& key, const Settings&) {
    for (const Machine* const other_machine : machines()) {
      if (!find_keys(other_machine->keys(), key.name).empty()) continue;
      CAPTURE(other_machine->name);
      const auto settings = other_machine->defaults();
      const std::string what =
          fmt::format("{}: not a key of the machine {}", key.name, other_machine->name);
      CHECK_THROWS_WITH(apply_assignment(*settings, key.name + "=1"), "-s: " + what);
      CHECK_THROWS_WITH(apply_text(*settings, key.name + " = 1", "a.toml", "."),
                        "a.toml:1: " + what);
      ++refused;
    }
  });
  CHECK(refused > 50);
}

TEST_CASE("a file of another machine is refused") {
  for (const Machine* const machine : machines()) {
    for (const Machine* const other_machine : machines()) {
      CAPTURE(machine->name, other_machine->name);
      const std::string message = message_of(*machine, "machine = '" + other_machine->name + "'\n");
      if (machine == other_machine) {
        CHECK(message.empty());
      } else {
        CHECK(message == fmt::format("some.toml:1: machine: value \"{}\" is not one of {}",
                                     other_machine->name, machine->name));
      }
    }
  }
}

TEST_CASE("a relative path starts at the file that names it, or at the working folder") {
  std::size_t files = 0;
  each_key([&files](const Machine&, const Key& key, Settings& settings) {
    if (key.kind != Kind::kFile) return;
    ++files;
    apply_text(settings, key.name + " = 'a.csv'", "some.toml", "/some/where");
    CHECK(plain(key.get(settings)) == "/some/where/a.csv");
    apply_assignment(settings, key.name + "=a.csv");
    CHECK(plain(key.get(settings)) == (std::filesystem::current_path() / "a.csv").string());
    apply_assignment(settings, key.name + '=');
    CHECK(plain(key.get(settings)).empty());
  });
  CHECK(files > 0);
}

TEST_CASE("a short form sets the keys of both axes, and their own names refine it") {
  std::size_t both = 0;
  each_key([&both](const Machine& machine, const Key& key, Settings& settings) {
    const std::string name = short_form(key.name);
    if (name == key.name || !is_number(key)) return;
    ++both;
    const auto keys = find_keys(machine.keys(), name);
    REQUIRE(keys.size() == 2);
    apply_text(settings,
               fmt::format("{} = {}\n{} = {}\n", key.name, value_text(number(key, key.max)), name,
                           value_text(number(key, key.min))),
               "some.toml", ".");
    const auto other_settings = machine.defaults();
    apply_environment(*other_settings,
                      {{"TRAMMEL_" + upper(key.name), value_text(number(key, key.max))},
                       {"TRAMMEL_" + upper(name), value_text(number(key, key.min))}});
    for (const Key* const one : keys) {
      const Value value = number(key, one == &key ? key.max : key.min);
      CHECK(one->get(settings) == value);
      CHECK(one->get(*other_settings) == value);
    }
  });
  CHECK(both > 0);
}

TEST_CASE("a scenario's description goes with the path that it describes") {
  int tried = 0;
  for (const Machine* const machine : machines()) {
    if (machine->described.by.empty()) continue;
    const std::string& name = machine->described.by;
    INFO(machine->name << ", " << name);
    const auto settings = machine->defaults();
    const Key& key = *find_keys(machine->keys(), name).at(0);
    const std::vector<std::string> words =
        key.choices.empty() ? std::vector<std::string>{"/one", "/two"} : key.choices;
    const std::string first = words.at(0), second = words.at(1);
    const auto layer = [&](const std::string& description, const std::string& value) {
      const std::string path = fmt::format("{} = \"{}\"\n", name, value);
      apply_text(*settings, description + '\n' + path, "a.toml", "/");
    };
    layer("description = \"mine\"", first);
    CHECK(settings->description == "mine");
    apply_assignment(*settings, name + '=' + first);
    CHECK(settings->description == "mine");
    apply_assignment(*settings, name + '=' + second);
    CHECK(settings->description ==
          fmt::format("{} = \"{}\" in place of the scenario's \"{}\"", name, second, first));
    layer("", first);
    CHECK_THAT(settings->description, Contains(first + "\" in place of"));
    layer("description = \"another\"", second);
    CHECK(settings->description == "another");
    ++tried;
  }
  CHECK(tried >= 2);
}

TEST_CASE("an assignment is key=value, and nothing may follow a number") {
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    const auto settings = machine->defaults();
    CHECK_THROWS_WITH(apply_assignment(*settings, "run.max_s"), "-s run.max_s: expects key=value");
    CHECK_THROWS_WITH(apply_assignment(*settings, "=1"), "-s =1: expects key=value");
    CHECK_THROWS_WITH(apply_assignment(*settings, "run.max_s=1x"), Contains("is not a number"));
    CHECK_THROWS_WITH(apply_assignment(*settings, "run.max_s="), Contains("is not a number"));
    CHECK_THROWS_WITH(apply_assignment(*settings, "run.window_clk=1.5"),
                      Contains("is not a whole number"));
    apply_assignment(*settings, "run.max_s=1e0");
    CHECK(settings->run.max_s == 1);
    for (const auto& [text, value] : {std::pair{"010", 10}, {"+8", 8}, {"08", 8}, {"7", 7}}) {
      CAPTURE(text);
      apply_assignment(*settings, std::string("run.window_clk=") + text);  // never octal
      CHECK(settings->run.window_clk == value);
    }
    for (const auto& [text, value] : {std::pair{"true", true}, {"on", true}, {"yes", true},
                                      {"1", true}, {"false", false}, {"off", false},
                                      {"no", false}, {"0", false}}) {
      CAPTURE(text);
      apply_assignment(*settings, std::string("run.leap=") + text);
      CHECK(settings->run.leap == value);
    }
    for (const char* text : {"0x10", "1e3", "1_000", "99999999999999999999"}) {
      CAPTURE(text);
      CHECK_THROWS_WITH(apply_assignment(*settings, std::string("run.window_clk=") + text),
                        Contains("run.window_clk: value "));
    }
  }
}

TEST_CASE("broken TOML names the line") {
  for (const Machine* const machine : machines()) {
    CHECK_THAT(message_of(*machine, "name = 'a'\nb = = 2\n"), Contains("some.toml:2: "));
  }
}
