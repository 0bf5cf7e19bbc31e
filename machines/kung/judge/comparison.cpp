// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/judge/comparison.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/run/make_plan.hpp"

namespace trammel::kung {

std::vector<lab::Companion> precision_companions(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  std::vector<lab::Companion> all;
  if (options.controller != Controller::kPrecision || !options.precision.compare) return all;
  for (const auto& [name, controller] : kFuzzy) {
    auto other = std::make_unique<Options>(options);
    other->path.profile = Profile::kFeed;
    other->controller = controller;
    other->run.engine = Engine::kTwin;
    other->run.platform = Platform::kDirect;
    other->run.wave = cosim::WaveFormat::kNone;  // waves are of the first
    other->run.assertions = other->run.audit = false;
    other->cpu = Cpu::kNative;
    other->uart.clear();
    other->precision.learn = false;
    other->diverged_m = other->reached_m = 1;  // however far they are behind
    other->prepared = lab::with_config_errors(
        [&] { return make_plan(*other, plan_of(options)->file); });
    all.push_back({name, std::move(other), false});  // comparison_lines() has their errors
  }
  return all;
}

std::vector<std::string> comparison_lines(const lab::Record& record) {
  if (record.companions.empty()) return {};
  static constexpr char kLine[] = "  {:<22}{:>12}{:>10}{:>12}{:>10}{:>12}";
  const auto line = [](const std::string& name, const lab::Record& of) {
    const auto value = [&of](const char* id, double per_mm) {
      const lab::Figure* const found = lab::find_figure(of.figures, id);
      return found != nullptr ? fmt::format("{:.4f}", found->value / per_mm) : "-";
    };
    return fmt::format(kLine, name, value("error_um.mean", 1000), value("error_um.max", 1000),
                       value("contour_um.mean", 1000), value("contour_um.max", 1000),
                       value("tracking.model.mean_mm", 1));
  };
  std::vector<std::string> lines{
      "",  // a blank line
      fmt::format("{:<24}{:>12}{:>10}{:>12}{:>10}{:>12}", "same feed profile (mm)", "error", "max",
                  "from path", "max", "from model"),
      line("precision", record)};
  for (const lab::Record& beside : record.companions) lines.push_back(line(beside.name, beside));
  for (const auto& [name, mean] : paper_means_mm(options_of(record))) {
    lines.push_back(fmt::format(kLine, name + " in the paper", "-", "-", "-", "-",
                                fmt::format("{:.2f}", mean)));
  }
  lines.emplace_back();
  return lines;
}

void add_precision(const Options& options, nlohmann::ordered_json& json) {
  if (feeds(options)) json["run"]["feed_m_s"] = highest_feed_m_s(plan_of(options)->moves());
  for (const auto& [name, mean] : paper_means_mm(options)) json["paper"][name]["mean_mm"] = mean;
}

std::string controller_name(const lab::Settings& settings) {
  const auto controller = static_cast<const Options&>(settings).controller;
  return std::string(controller == Controller::kFc    ? "FC"
                     : controller == Controller::kAfc ? "AFC"
                                                      : "precision");
}

}  // namespace trammel::kung
