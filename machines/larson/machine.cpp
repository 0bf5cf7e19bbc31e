// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/machine_members.hpp"

#include "machines/larson/session.hpp"

namespace trammel::larson {
namespace {

lab::Machine describe() {
  lab::Machine m;
  m.name = "larson";
  m.title = "X-Y stepper table of 1974: four words, pulse buffers, steppers that can lose steps";
  m.source = "Larson 1974";
  m.order = 4;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.described.by = "script";
  m.validate = validate;
  m.traces = {triggers, 5e9, 1e7};
  m.columns = columns;
  m.figures = figures;
  m.texts.remarks = remarks;
  m.files.metrics = add_metrics;
  m.page.arrays = {"/events", "/calls"};
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::larson
