// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/machine_members.hpp"

#include "machines/gantry/session.hpp"

namespace trammel::gantry {
namespace {

lab::Machine describe() {
  lab::Machine m;
  m.name = "gantry";
  m.title = "gantry track of 2006: two motors on a belt, stripe sensor, Serial2002";
  m.source = "Brochier 2006";
  m.order = 5;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.validate = validate;
  m.texts.warnings = warnings;
  m.traces = {triggers, 5e9, 2e7};
  m.live = {"host.serial=true", "run.time_s=3600", "run.max_s=3600", "record.every_ms=10"};
  m.columns = columns;
  m.figures = figures;
  m.verdict = verdict;
  m.texts.remarks = remarks;
  m.files.metrics = add_metrics;
  m.page.arrays = {"/calibration"};
  m.page.objects = {"/published", "/identified"};
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::gantry
