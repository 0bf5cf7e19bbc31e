// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/machine_members.hpp"

#include "machines/mcafee/session.hpp"
#include "parts/lm628/columns.hpp"

namespace trammel::mcafee {
namespace {

lab::Machine describe() {
  lab::Machine m;
  m.name = "mcafee";
  m.title = "two LM628 and a fuzzy feed rate with a leadscrew stage: self-paced tracking";
  m.source = "McAfee 1994";
  m.order = 3;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.described.by = "path.kind";
  m.validate = validate;
  m.texts.warnings = warnings;
  m.traces = {triggers, 1.7e10, 4e8};
  m.columns = columns;
  m.figures = figures;
  m.verdict = lm628::verdict<Options, Result>;
  m.compared = {companions, run_name};
  m.files.metrics = add_metrics;
  m.files.detail = tracking_json;
  m.files.write = write_tables;
  m.files.drawn = [](const lab::Record& record) {
    const Result& result = result_of(record);
    return lab::Range{result.first, result.samples.size()};
  };
  m.page = page();
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::mcafee
