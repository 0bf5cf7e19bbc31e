// SPDX-License-Identifier: Apache-2.0
#include "cosim/kung/trigger.hpp"

namespace trammel::kung {
namespace {

using When = Trigger::When;
using Relation = Trigger::Relation;

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

// "fault.encoder", "afc.x", "drives"; false when it is no such word.
bool name_event(Trigger& trigger, const std::string& text) {
  const auto dot = text.find('.');
  const std::string event = text.substr(0, dot);
  const std::string part = dot == std::string::npos ? "" : text.substr(dot + 1);
  if (event == "fault") {
    name_signal(trigger, "FAULT.code", signals());
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
    name_signal(trigger, (part.empty() ? "" : part + '.') + known.signal, signals());
    trigger.when = When::kRises;
    return true;
  }
  return false;
}

}  // namespace

Trigger parse_trigger(const std::string& text) {
  return cosim::parse_trigger(text, {signals(), kTriggerForms, name_event});
}

std::vector<std::string> trigger_names() {
  std::vector<std::string> names{"fault"};
  for (const auto& cause : kCauses) names.push_back(std::string("fault.") + cause.text);
  const auto add = [&names](const std::string& name) { names.push_back(name); };
  for (const auto& event : kEvents) {
    for (const char* axis : {"", ".x", ".y"}) add(std::string(event.text) + axis);
  }
  for (const std::string& name : cosim::signal_names(signals())) add(name);
  return names;
}

}  // namespace trammel::kung
