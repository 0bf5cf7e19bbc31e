// SPDX-License-Identifier: Apache-2.0
//
// What the paper prints, and where it stands beside ours.
#include <catch2/catch.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/scenarios.hpp"
#include "machines/kung/figures.hpp"
#include "machines/kung/machine.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

struct Ours {
  std::string id;
  double value;
  std::optional<double> printed{};
};

lab::Record record_of(PathKind path, Controller controller, const std::vector<Ours>& list,
                      EndReason end = EndReason::kDone, const char* scenario = "circle") {
  lab::Record record;
  auto options = std::make_shared<Options>();
  options->scenario = scenario;
  options->path.kind = path;
  options->controller = controller;
  record.settings = std::move(options);
  record.result = std::make_unique<Result>();
  record.result->end = end;
  for (const Ours& one : list) {
    record.figures.push_back(lab::figure(one.id, "", "", one.value, ""));
    record.figures.back().printed = one.printed;
  }
  return record;
}

std::vector<Ours> tracking(double mean, double printed_mean, double variance,
                           double printed_variance, double std) {
  return {{"tracking.model.mean_mm", mean, printed_mean},
          {"tracking.model.variance_mm2", variance, printed_variance},
          {"tracking.model.std_mm", std}};
}

// Words with single blanks between, each line between bars.
std::string plain(const std::string& text) {
  std::string out = "|";
  for (const char c : text) {
    if (c == '\n') {
      while (out.back() == ' ') out.pop_back();
      out += '|';
    } else if (c != ' ' || (out.back() != ' ' && out.back() != '|')) {
      out += c;
    }
  }
  return out;
}

}  // namespace

// docs/figures.md has what is printed and expected in each scenario.
TEST_CASE("by another controller or with an own gain nothing is printed or expected") {
  for (const char* const scenario : {"circle", "window", "star", "step", "paper-circle"}) {
    for (const bool own : {false, true}) {
      const auto settings = lab::load_scenario(lab::find_scenario(scenario));
      auto options = static_cast<const Options&>(*settings);
      if (own) {
        options.gains[1].kp *= 2;
      } else {
        options.controller = Controller::kPrecision;
      }
      for (const char* const id : {"tracking.model.mean_mm", "tracking.model.variance_mm2",
                                   "tracking.model.std_mm", "x.periods.0.overshoot_percent",
                                   "x.periods.0.rms_mm", "peak_current_A"}) {
        std::vector<lab::Figure> figures{lab::figure(id, "", "", 0, "")};
        compare(options, figures);
        CAPTURE(scenario, own, id);
        CHECK_FALSE(figures[0].printed);
        CHECK_FALSE(figures[0].expected);
        CHECK(figures[0].source.empty());
      }
    }
  }
}

TEST_CASE("the table of the experiments holds each value in the cell of its path and controller") {
  std::vector<lab::Record> all;
  const auto add = [&](auto&&... of) { all.push_back(record_of(of...)); };
  using K = PathKind;
  using C = Controller;
  add(K::kCircle, C::kFc, tracking(4, 3, 0.5, 0.6, 0.71));
  add(K::kWindow, C::kFc, tracking(2, 1, 0.8, 0.9, 0.72));
  add(K::kStar, C::kFc, tracking(5, 8, 1.1, 1.2, 0.73));
  add(K::kCircle, C::kAfc, tracking(3, 2.1, 0.4, 0.3, 0.74));
  add(K::kWindow, C::kAfc, tracking(1.5, 0.9, 1.6, 1.8, 0.75));
  add(K::kStar, C::kAfc, tracking(4.5, 7, 1, 1, 0.76), EndReason::kFault);
  add(K::kSquare, C::kFc,
      std::vector<Ours>{{"x.periods.0.overshoot_percent", 12.1, 12.8},
                        {"y.periods.0.overshoot_percent", 23.2, 23.1},
                        {"x.periods.7.overshoot_percent", 11.3},
                        {"y.periods.7.overshoot_percent", 22.4}});
  add(K::kSquare, C::kAfc,
      std::vector<Ours>{{"x.periods.0.overshoot_percent", 5.0},
                        {"y.periods.0.overshoot_percent", 23.5},
                        {"x.periods.1.overshoot_percent", 4.9},
                        {"y.periods.1.overshoot_percent", 5.1},
                        {"x.periods.7.overshoot_percent", 1.2},
                        {"y.periods.7.overshoot_percent", 6.6}});
  const auto errors = [](double mean, double most) {
    return std::vector<Ours>{{"error_um.mean", mean}, {"error_um.max", most}};
  };
  add(K::kCircle, C::kPrecision, errors(2.04, 15.31));
  add(K::kWindow, C::kPrecision, errors(99.99, 101.26));
  all[8].companions.push_back(record_of(K::kCircle, C::kFc, errors(100.4, 2000.6)));
  all[8].companions.back().name = "FC";
  all[8].companions.push_back(
      record_of(K::kCircle, C::kAfc, errors(1, 2), EndReason::kDiverged));
  all[8].companions.back().name = "AFC";
  add(K::kCircle, C::kAfc, tracking(6, 2.1, 0.2, 0.3, 0.77), EndReason::kDone, "paper-circle-afc");
  add(K::kStar, C::kAfc, tracking(7.5, 7, 2, 1, 0.78), EndReason::kDone, "paper-star-afc");
  add(K::kSquare, C::kAfc, std::vector<Ours>{{"x.periods.0.overshoot_percent", 4.5}},
      EndReason::kDone, "paper-step-afc");
  std::vector<const lab::Record*> records;
  for (const lab::Record& record : all) records.push_back(&record);
  const std::string text = plain(experiments_text(records));
  for (const char* const line : {
           "|Tracking error in mm (Kung Table 2), defaults / paper-* / printed||circle window ",
           "|Step of 10 mm with 11 kg (Kung Figs. 11, 12), defaults / paper-* / printed||",
           "|FC mean 4.00 / - / 3.00 2.00 / - / 1.00 5.00 / - / 8.00|",
           "|FC variance 0.50 / - / 0.60 0.80 / - / 0.90 1.10 / - / 1.20|",
           "|FC std 0.71 / - / - 0.72 / - / - 0.73 / - / -|",
           "|AFC mean 3.00 / 6.00 / 2.10 1.50 / - / 0.90 - / 7.50 / 7.00|",
           "|AFC variance 0.40 / 0.20 / 0.30 1.60 / - / 1.80 - / 2.00 / 1.00|",
           "|AFC std 0.74 / 0.77 / - 0.75 / - / - - / 0.78 / -|",
           "|reduction of mean 25.0 / - / 30.0 % 25.0 / - / 10.0 % -|",
           "|reduction of variance 20.0 / - / 50.0 % -100.0 / - / -100.0 % -|",
           "|overshoot (%) first period last period|",
           "|FC X 12.1 / - / 12.8 11.3 / - / -|",
           "|FC Y 23.2 / - / 23.1 22.4 / - / -|",
           "|AFC X 5.0 / 4.5 / - 1.2 / - / -|",
           "|AFC Y 23.5 / - / - 6.6 / - / -|",
           "|defaults, X: below 5 % in period 2|",
           "|defaults, Y: never below 5 %|",
           "|paper-*, X: below 5 % in period 1|",
           "|paper-*, Y: never below 5 %|",
           "|FC 100 / 2001 not finished not finished|",
           "|AFC not finished not finished not finished|",
           "|precision 2.04 / 15.3 99.99 / 101.3 not finished|"}) {
    INFO("the line " << line << " of experiments_text in " << text);
    CHECK_THAT(text, Catch::Contains(line));
  }
}
