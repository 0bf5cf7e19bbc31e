// SPDX-License-Identifier: Apache-2.0
#include "cosim/kung/trigger.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <regex>

#include "cosim/wave_plan.hpp"

namespace trammel::kung {
namespace {

using When = Trigger::When;
using Relation = Trigger::Relation;

constexpr struct {
  const char* text;
  Relation relation;
} kRelations[] = {{"==", Relation::kEqual},     {"!=", Relation::kNotEqual},
                  {"<=", Relation::kLessEqual}, {">=", Relation::kGreaterEqual},
                  {"<", Relation::kLess},       {">", Relation::kGreater}};

constexpr struct {
  const char* text;
  FaultCode code;
} kCauses[] = {{"trip", FaultCode::kTrip},
               {"over_current", FaultCode::kOverCurrent},
               {"watchdog", FaultCode::kWatchdog},
               {"encoder", FaultCode::kEncoder},
               {"stroke", FaultCode::kStroke}};

// Events that are a change of one signal, of either axis or of one.
constexpr struct {
  const char* text;
  const char* signal;
} kEvents[] = {{"drives", "CTRL.enable"}, {"afc", "afc"}};

std::optional<std::size_t> find_signal(const std::string& name) {
  const auto& all = signals();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (name == all[i].name) return i;
  }
  return {};
}

// "x.e" is signal e of axis 0.
void name_signal(Trigger& trigger, const std::string& name) {
  const bool of_axis = name.rfind("x.", 0) == 0 || name.rfind("y.", 0) == 0;
  const auto signal = find_signal(of_axis ? name.substr(2) : name);
  if (!signal || (of_axis && !signals()[*signal].of_axis)) throw UnknownName(name);
  trigger.signal = *signal;
  trigger.either = !of_axis && signals()[*signal].of_axis;
  trigger.axis = name[0] == 'y' && of_axis ? 1 : 0;
}

// "fault.encoder", "afc.x", "drives"; false when it is no such word.
bool name_event(Trigger& trigger, const std::string& text) {
  const auto dot = text.find('.');
  const std::string event = text.substr(0, dot);
  const std::string part = dot == std::string::npos ? "" : text.substr(dot + 1);
  if (event == "fault") {
    name_signal(trigger, "FAULT.code");
    trigger.when = When::kHolds;
    trigger.relation = Relation::kNotEqual;
    if (part.empty()) return true;
    trigger.relation = Relation::kEqual;
    for (const auto& cause : kCauses) {
      trigger.value = static_cast<std::int64_t>(cause.code);
      if (part == cause.text) return true;
    }
    throw UnknownName(text);
  }
  for (const auto& known : kEvents) {
    if (event != known.text) continue;
    if (!part.empty() && part != "x" && part != "y") throw UnknownName(text);
    name_signal(trigger, (part.empty() ? "" : part + '.') + known.signal);
    trigger.when = When::kRises;
    return true;
  }
  return false;
}

void compare(Trigger& trigger, const std::string& name, const std::string& op,
             const std::string& number) {
  name_signal(trigger, name);
  trigger.when = When::kHolds;
  for (const auto& known : kRelations) {
    if (op == known.text) trigger.relation = known.relation;
  }
  const bool hexadecimal = number.find('x') != std::string::npos;
  errno = 0;
  trigger.value = std::strtoll(number.c_str(), nullptr, hexadecimal ? 16 : 10);
  const Signal& signal = signals()[trigger.signal];
  const std::int64_t span = std::int64_t{1} << signal.bits;
  const std::int64_t low = signal.is_signed ? -span / 2 : 0;
  if (errno != 0 || trigger.value < low || trigger.value >= low + span) {
    throw std::invalid_argument(
        fmt::format("{}: value {} is out of range {}..{}", name, number, low, low + span - 1));
  }
}

}  // namespace

Trigger parse_trigger(const std::string& text) {
  static const std::regex form(
      R"(\s*(?:at\s+(\S+)|(rise|fall|change)\s+([\w.]+)|([\w.]+)\s*([=!<>]=|[<>])\s*)"
      R"((-?(?:0x[0-9a-fA-F]+|[0-9]+))|([\w.]+))(?:\s+after\s+(\S+))?\s*)");
  std::smatch part;
  if (!std::regex_match(text, part, form)) {
    throw std::invalid_argument(fmt::format("\"{}\" is none of: {}", text, kTriggerForms));
  }
  Trigger trigger;
  if (part[8].matched) trigger.edge = cosim::parse_edge(part[8]);
  if (part[1].matched) {
    if (part[8].matched) throw std::invalid_argument("`at` and `after` exclude each other");
    trigger.edge = cosim::parse_edge(part[1]);
  } else if (part[2].matched) {
    name_signal(trigger, part[3]);
    trigger.when = part[2] == "rise"   ? When::kRises
                   : part[2] == "fall" ? When::kFalls
                                       : When::kChanges;
  } else if (part[4].matched) {
    compare(trigger, part[4], part[5], part[6]);
  } else if (!name_event(trigger, part[7])) {
    const std::regex words("at|rise|fall|change|after");
    if (!std::regex_match(part[7].str(), words)) name_signal(trigger, part[7]);  // known at all?
    throw std::invalid_argument(fmt::format("\"{}\" is none of: {}", text, kTriggerForms));
  }
  return trigger;
}

std::vector<std::string> trigger_names() {
  std::vector<std::string> names{"fault"};
  for (const auto& cause : kCauses) names.push_back(std::string("fault.") + cause.text);
  const auto add = [&names](const std::string& name) { names.push_back(name); };
  for (const auto& event : kEvents) {
    for (const char* axis : {"", ".x", ".y"}) add(std::string(event.text) + axis);
  }
  for (const Signal& signal : signals()) {
    add(signal.name);
    if (!signal.of_axis) continue;
    add(std::string("x.") + signal.name);
    add(std::string("y.") + signal.name);
  }
  return names;
}

bool TriggerSearch::holds(std::int64_t value) const {
  switch (trigger_.relation) {
    case Relation::kEqual:
      return value == trigger_.value;
    case Relation::kNotEqual:
      return value != trigger_.value;
    case Relation::kLess:
      return value < trigger_.value;
    case Relation::kLessEqual:
      return value <= trigger_.value;
    case Relation::kGreater:
      return value > trigger_.value;
    case Relation::kGreaterEqual:
      return value >= trigger_.value;
  }
  return false;
}

bool TriggerSearch::fires(std::int64_t before, std::int64_t now) const {
  switch (trigger_.when) {
    case When::kAt:
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

void TriggerSearch::after(cosim::Clk edge, const SignalReader& chip) {
  if (found_) return;
  const int last = trigger_.either ? 1 : trigger_.axis;
  for (int axis = trigger_.either ? 0 : trigger_.axis; axis <= last; ++axis) {
    const std::int64_t now = chip.read(trigger_.signal, axis);
    if (known_ && edge >= trigger_.edge && fires(before_[axis], now)) found_ = edge;
    before_[axis] = now;
  }
  known_ = edge >= 0;  // the chip is in reset before
}

}  // namespace trammel::kung
