// SPDX-License-Identifier: Apache-2.0
#include "machines/@name@/machine_members.hpp"

#include "machines/@name@/session.hpp"

namespace trammel::@name@ {
namespace {

// Words of the chip, by their numbers.
const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all{
      {{"enable", "", "pin of the chip", 1, false}, false},
      {{"duty", "clk", "of a period, the sign is the direction", 13, true}, false},
      {{"count", "count", "encoder counter", 16, true}, false}};
  return all;
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
  m.traces.triggers = triggers;
  m.columns = columns;
  m.figures = figures;
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::@name@
