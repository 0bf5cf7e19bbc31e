// SPDX-License-Identifier: Apache-2.0
//
// Triggers of the X-Y table: cosim/trigger.hpp with the signals of its chip, and these words.
//
//   EVENT := drives[.AXIS] | afc[.AXIS] | fault[.CAUSE]
//   CAUSE := trip | over_current | watchdog | encoder | stroke
#include "machines/kung/chip/chip.hpp"

namespace trammel::kung {
namespace {

using cosim::Trigger;
using cosim::UnknownName;
using When = Trigger::When;
using Relation = Trigger::Relation;

constexpr char kForms[] =
    "drives, afc, fault, fault.encoder, at 10ms, rise|fall|change x.CTRL.enable, x.e > 100, each "
    "with `after TIME` behind it if wanted";

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

const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = [] {
    std::vector<std::string> events{"fault"};
    for (const auto& cause : kCauses) events.push_back(std::string("fault.") + cause.text);
    for (const auto& event : kEvents) {
      for (const char* axis : {"", ".x", ".y"}) events.push_back(std::string(event.text) + axis);
    }
    return cosim::TriggerForms{signals(), std::move(events), kForms, "drives", name_event};
  }();
  return forms;
}

}  // namespace trammel::kung
