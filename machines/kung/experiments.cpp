// SPDX-License-Identifier: Apache-2.0
//
// Kung Table 2 and the step figures beside ours, from the eight experiments.
#include <fmt/format.h>

#include <algorithm>

#include "machines/kung/machine.hpp"
#include "machines/kung/paper.hpp"

namespace trammel::kung {
namespace {

const char* controller_text(Controller c) { return c == Controller::kFc ? "FC" : "AFC"; }

const lab::Record* find(const std::vector<const lab::Record*>& records, PathKind path,
                        Controller controller) {
  for (const lab::Record* record : records) {
    const Options& options = options_of(*record);
    if (options.path.kind == path && options.controller == controller) return record;
  }
  return nullptr;
}

// A figure of a run that is complete.
std::optional<lab::Figure> figure_of(const lab::Record* record, const std::string& id) {
  if (record == nullptr || record->result->end != cosim::EndReason::kDone) return {};
  for (const lab::Figure& f : record->figures) {
    if (f.id == id) return f;
  }
  return {};
}

std::string period(char axis, int k) {
  return fmt::format("{}.periods.{}.overshoot_percent", axis, k);
}

constexpr PathKind kPaths[] = {PathKind::kCircle, PathKind::kWindow, PathKind::kStar};
constexpr struct {
  const char* name;
  const char* id;
} kSpreads[] = {{"mean", "tracking.model.mean_mm"},
                {"variance", "tracking.model.variance_mm2"},
                {"std", "tracking.model.std_mm"}};

std::string ours_and_printed(const std::optional<lab::Figure>& f, int digits) {
  if (!f) return "not finished";
  return fmt::format("{} / {}", lab::figure_text(f->value, digits),
                     lab::figure_text(f->printed, digits));
}

}  // namespace

std::string experiments_text(const std::vector<const lab::Record*>& records) {
  std::string text = "Tracking error in mm (Kung Table 2), ours / paper\n\n";
  text += fmt::format("  {:<22}{:>16}{:>16}{:>16}\n", "", "circle", "window", "star");
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    for (const auto& [name, id] : kSpreads) {
      text += fmt::format("  {:<22}", fmt::format("{} {}", controller_text(controller), name));
      for (const PathKind path : kPaths) {
        text += fmt::format("{:>16}",
                            ours_and_printed(figure_of(find(records, path, controller), id), 2));
      }
      text += '\n';
    }
  }
  for (const auto& [name, id] : {kSpreads[0], kSpreads[1]}) {
    text += fmt::format("  {:<22}", std::string("AFC less ") + name);
    for (const PathKind path : kPaths) {
      const auto fc = figure_of(find(records, path, Controller::kFc), id);
      const auto afc = figure_of(find(records, path, Controller::kAfc), id);
      text += fmt::format("{:>16}", fc && afc && fc->printed && afc->printed
                                        ? fmt::format("{:.1f} / {:.1f} %",
                                                      100 * (1 - afc->value / fc->value),
                                                      100 * (1 - *afc->printed / *fc->printed))
                                        : "-");
    }
    text += '\n';
  }
  text += fmt::format("  {}\n  the paper's spread has a square root but is labelled variance\n",
                      kCircleNote);

  text += "\nStep of 10 mm with 11 kg (Kung Figs. 11, 12), ours / paper\n\n";
  text += fmt::format("  {:<22}{:>16}{:>16}\n", "overshoot (%)", "first period", "last period");
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    const lab::Record* const step = find(records, PathKind::kSquare, controller);
    const int last = step == nullptr ? 0 : options_of(*step).path.square_periods - 1;
    for (const char axis : {'x', 'y'}) {
      text +=
          fmt::format("  {:<22}{:>16}{:>16}\n",
                      fmt::format("{} {}", controller_text(controller), axis == 'x' ? 'X' : 'Y'),
                      ours_and_printed(figure_of(step, period(axis, 0)), 1),
                      ours_and_printed(figure_of(step, period(axis, last)), 1));
    }
  }
  text += "  the paper says of AFC only that it closely follows the model after 1 or 2 periods\n";
  const lab::Record* const adapted = find(records, PathKind::kSquare, Controller::kAfc);
  if (adapted == nullptr) return text;
  for (const char axis : {'x', 'y'}) {
    int k = 0;
    auto f = figure_of(adapted, period(axis, k));
    while (f && f->value >= 5) f = figure_of(adapted, period(axis, ++k));
    text += fmt::format("  ours, {}: {}\n", axis == 'x' ? 'X' : 'Y',
                        f ? fmt::format("below 5 % in period {}", k + 1) : "never below 5 %");
  }
  return text;
}

}  // namespace trammel::kung
