// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "lab/machine.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/comparison.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/page/page.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/trace.hpp"
#include "machines/kung/run/advice.hpp"
#include "machines/kung/run/columns.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"

namespace trammel::kung {
namespace {

std::vector<lab::Experiment> experiments() {
  std::vector<lab::Experiment> all;
  for (const std::string scenario : {"step", "circle", "window", "star"}) {
    for (const std::string controller : {"fc", "afc"}) {
      all.push_back({scenario + '-' + controller, scenario, {"controller=" + controller}});
    }
  }
  for (const std::string scenario : {"circle", "window", "star"}) {
    all.push_back({scenario + "-precision", scenario, {"controller=precision"}});
  }
  for (const std::string path : {"step", "circle", "window", "star"}) {
    for (const std::string controller : {"fc", "afc"}) {
      const std::string scenario = kFittedPrefix + path;
      all.push_back({scenario + '-' + controller, scenario, {"controller=" + controller},
                     "paper.html"});
    }
  }
  return all;
}

// Path, table, chip and gains are a scenario's, and so is that it runs at constant speed.
bool alters(const lab::Key& key, const lab::Value& value) {
  if (key.name == "controller") return std::get<std::string>(value) == "precision";
  if (key.name == "plant.seed") return false;
  const std::string section = key.name.substr(0, key.name.find('.'));
  return section == "path" || section == "plant" || section == "chip" || section == "gains";
}

// A description of a shape names its constant speed: under a feed profile that is the feed.
std::string reworded(const lab::Settings& settings, std::string description) {
  constexpr const char* kAt = " at ";
  const std::size_t end = description.find(" m/s");
  const std::size_t at = description.rfind(kAt, end);
  if (end == std::string::npos || at == std::string::npos) return description;
  const std::size_t begin = at + std::string(kAt).size();
  if (description.find_first_not_of("0123456789.", begin) != end) return description;
  const auto& options = static_cast<const Options&>(settings);
  const PathKind kind = options.path.kind;
  const bool shape =
      kind == PathKind::kCircle || kind == PathKind::kWindow || kind == PathKind::kStar;
  if (!shape || !feeds(options)) return description;
  return description.replace(begin, end - begin, fmt::format("{:g}", feed_m_s(options.path)));
}

lab::Machine describe() {
  lab::Machine m;
  m.name = "kung";
  m.title = "X-Y table with adaptive fuzzy control, current vector control and space-vector PWM";
  m.source = "Kung et al. 2012, DOI 10.5772/48457";
  m.order = 1;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.former_keys = former_keys();
  m.described.by = "path.kind";
  m.described.alters = alters;
  m.described.reworded = reworded;
  m.validate = validate;
  m.program = {{".ngc", ".nc", ".gcode"}, "path.gcode_file", {"path.kind=gcode"}};
  m.traces.triggers = triggers;
  m.traces.vcd_bytes_s = 1.2e10;
  m.traces.fst_bytes_s = 8e7;
  m.columns = columns;
  m.figures = figures;
  m.verdict = verdict;
  m.texts.remarks = remarks;
  m.texts.warnings = advice;
  m.compared.companions = precision_companions;
  m.compared.run_name = [](const lab::Settings& settings) {
    const auto controller = static_cast<const Options&>(settings).controller;
    return std::string(controller == Controller::kFc    ? "FC"
                       : controller == Controller::kAfc ? "AFC"
                                                        : "precision");
  };
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
  m.experiments.list = experiments();
  m.experiments.text = experiments_text;
  return m;
}

}  // namespace

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::kung
