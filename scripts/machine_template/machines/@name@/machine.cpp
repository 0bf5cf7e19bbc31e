// SPDX-License-Identifier: Apache-2.0
#include "machines/@name@/machine.hpp"

#include <fmt/format.h>

#include "machines/@name@/session.hpp"

namespace trammel::@name@ {
namespace {

std::string verdict(const lab::Settings& settings, const cosim::RunResult& result) {
  switch (result.end) {
    case cosim::EndReason::kFault: return "tripped: " + result.fault_text();
    case cosim::EndReason::kTimeout:
      return fmt::format("not finished within run.max_s = {:g}", settings.run.max_s);
    case cosim::EndReason::kPromise:
      return "assertion failed: " + lab::promise_text(*result.promise);
    default: return lab::end_text(result.end);
  }
}

const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms{
      signals(),
      {"drive", "irq"},
      "drive (pwm or direction changes), irq (the timer interrupts), at 10ms, change count, "
      "duty > 100, each with `after TIME` behind it if wanted",
      "drive",
      [](cosim::Trigger& trigger, const std::string& word) {
        return word != "hi" && cosim::name_stop_event(trigger, word);
      }};
  return forms;
}

lab::Machine describe() {
  lab::Machine m;
  m.name = "@name@";
  m.title = "DC motor with a PWM chip, its speed controlled by firmware";
  m.source = "scripts/new_machine.py";
  m.can.leap = @leap@;  // whether the chip has the ports of docs/leap.md
  m.can.twin = false;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.triggers = triggers;
  m.columns = columns;
  m.figures = figures;
  m.verdict = verdict;
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::@name@
