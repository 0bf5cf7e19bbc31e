// SPDX-License-Identifier: Apache-2.0
#include "cosim/trigger.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <regex>

#include "cosim/wave_plan.hpp"

namespace trammel::cosim {
namespace {

using When = Trigger::When;
using Relation = Trigger::Relation;

constexpr struct {
  const char* text;
  Relation relation;
} kRelations[] = {{"==", Relation::kEqual},     {"!=", Relation::kNotEqual},
                  {"<=", Relation::kLessEqual}, {">=", Relation::kGreaterEqual},
                  {"<", Relation::kLess},       {">", Relation::kGreater}};

void compare(Trigger& trigger, const std::string& name, const std::string& op,
             const std::string& number, const std::vector<Signal>& signals) {
  name_signal(trigger, name, signals);
  trigger.when = When::kHolds;
  for (const auto& known : kRelations) {
    if (op == known.text) trigger.relation = known.relation;
  }
  const bool hexadecimal = number.find('x') != std::string::npos;
  errno = 0;
  trigger.value = std::strtoll(number.c_str(), nullptr, hexadecimal ? 16 : 10);
  const Signal& signal = signals[trigger.signal];
  const std::int64_t span = std::int64_t{1} << signal.bits;
  const std::int64_t low = signal.is_signed ? -span / 2 : 0;
  if (errno != 0 || trigger.value < low || trigger.value >= low + span) {
    throw std::invalid_argument(
        fmt::format("{}: value {} is out of range {}..{}", name, number, low, low + span - 1));
  }
}

}  // namespace

std::string described(const Word& word) {
  return *word.unit == 0 ? word.help : fmt::format("{} [{}]", word.help, word.unit);
}

void name_signal(Trigger& trigger, const std::string& name, const std::vector<Signal>& signals) {
  const bool of_axis = name.rfind("x.", 0) == 0 || name.rfind("y.", 0) == 0;
  const std::string bare = of_axis ? name.substr(2) : name;
  std::size_t n = 0;
  while (n < signals.size() && bare != signals[n].name) ++n;
  if (n == signals.size() || (of_axis && !signals[n].of_axis)) throw UnknownName(name);
  trigger.signal = n;
  trigger.either = !of_axis && signals[n].of_axis;
  trigger.axis = name[0] == 'y' && of_axis ? 1 : 0;
}

Trigger parse_trigger(const std::string& text, const TriggerForms& forms, std::int64_t clock_ps) {
  static const std::regex form(
      R"(\s*(?:at\s+(\S+)|(rise|fall|change)\s+([\w.]+)|([\w.]+)\s*([=!<>]=|[<>])\s*)"
      R"((-?(?:0x[0-9a-fA-F]+|[0-9]+))|([\w.]+))(?:\s+after\s+(\S+))?\s*)");
  std::smatch part;
  if (!std::regex_match(text, part, form)) {
    throw std::invalid_argument(fmt::format("\"{}\" is none of: {}", text, forms.help));
  }
  Trigger trigger;
  if (part[8].matched) trigger.edge = parse_edge(part[8], clock_ps);
  if (part[1].matched) {
    if (part[8].matched) throw std::invalid_argument("`at` and `after` exclude each other");
    trigger.edge = parse_edge(part[1], clock_ps);
  } else if (part[2].matched) {
    name_signal(trigger, part[3], forms.signals);
    trigger.when = part[2] == "rise"   ? When::kRises
                   : part[2] == "fall" ? When::kFalls
                                       : When::kChanges;
  } else if (part[4].matched) {
    compare(trigger, part[4], part[5], part[6], forms.signals);
  } else if (!forms.event(trigger, part[7])) {
    const std::regex words("at|rise|fall|change|after");
    if (!std::regex_match(part[7].str(), words)) {
      name_signal(trigger, part[7], forms.signals);  // known at all?
    }
    throw std::invalid_argument(fmt::format("\"{}\" is none of: {}", text, forms.help));
  }
  return trigger;
}

std::vector<std::string> trigger_names(const TriggerForms& forms) {
  std::vector<std::string> names = forms.events;
  for (const Signal& signal : forms.signals) {
    names.emplace_back(signal.name);
    if (!signal.of_axis) continue;
    names.push_back(std::string("x.") + signal.name);
    names.push_back(std::string("y.") + signal.name);
  }
  return names;
}

bool Trigger::holds(std::int64_t now) const {
  switch (relation) {
    case Relation::kEqual:
      return now == value;
    case Relation::kNotEqual:
      return now != value;
    case Relation::kLess:
      return now < value;
    case Relation::kLessEqual:
      return now <= value;
    case Relation::kGreater:
      return now > value;
    case Relation::kGreaterEqual:
      return now >= value;
  }
  return false;
}

bool Trigger::fires(std::int64_t before, std::int64_t now) const {
  switch (when) {
    case When::kAt:
    case When::kEvent:
      return false;
    case When::kHolds:
      return holds(now) && !holds(before);
    case When::kRises:
      return now > before;
    case When::kFalls:
      return now < before;
    case When::kChanges:
      return now != before;
  }
  return false;
}

void SignalSearch::after(Clk edge, const SignalReader& chip) {
  if (found_) return;
  const int last = trigger_.either ? 1 : trigger_.axis;
  for (int axis = trigger_.either ? 0 : trigger_.axis; axis <= last; ++axis) {
    const std::int64_t now = chip.read(trigger_.signal, axis);
    if (known_ && edge >= trigger_.edge && trigger_.fires(before_[axis], now)) found_ = edge;
    before_[axis] = now;
  }
  known_ = edge >= 0;  // the chip is in reset before
}

}  // namespace trammel::cosim
