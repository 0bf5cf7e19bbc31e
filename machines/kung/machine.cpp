// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "lab/machine.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/comparison.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/page/page.hpp"
#include "machines/kung/plan/described.hpp"
#include "machines/kung/precision/trace.hpp"
#include "machines/kung/run/columns.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "machines/kung/run/warnings.hpp"

namespace trammel::kung {
namespace {

lab::Machine describe() {
  lab::Machine m;
  m.name = "kung";
  m.title = "X-Y table with adaptive fuzzy control, current vector control and space-vector PWM";
  m.source = "Kung et al. 2012, DOI 10.5772/48457";
  m.order = 1;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.former_keys = former_keys();
  m.described = {"path.kind", alters, reworded};
  m.validate = validate;
  m.program = {{".ngc", ".nc", ".gcode"}, "path.gcode_file", {"path.kind=gcode"}};
  m.traces = {triggers, 1.2e10, 8e7};
  m.columns = columns;
  m.figures = figures;
  m.verdict = verdict;
  m.texts.remarks = remarks;
  m.texts.warnings = warnings;
  m.compared = {precision_companions, controller_name};
  m.files.metrics = add_metrics;
  m.files.detail = [](const lab::Record& record) {
    return detail_json(options_of(record), result_of(record));
  };
  m.files.write = [](const lab::Record& record, const std::filesystem::path& folder) {
    const std::string& uart = result_of(record).uart;
    if (!uart.empty()) host::write_text(folder / "uart.txt", uart);
    if (options_of(record).controller == Controller::kPrecision) {
      write_precision(folder / kPrecisionTrace, *plan_of(options_of(record)), result_of(record));
    }
  };
  m.files.drawn = [](const lab::Record& record) { return counted(result_of(record)); };
  m.page = page();
  m.experiments = {experiments(), experiments_text};
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::kung
