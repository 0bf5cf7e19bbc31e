// SPDX-License-Identifier: Apache-2.0
//
// What a run is judged by, as one list: metrics.json, the text at the end, the tiles of the page,
// --check and comparisons are made from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace trammel::lab {

struct Figure {
  std::string id;      // its place in metrics.json, dots between: "tracking.model.mean_mm"
  std::string row;     // for people: what it is of
  std::string column;  // which of that row, or ""
  double value = 0;
  std::string unit;
  int digits = 3;      // shown behind the point; kWhole: a whole number

  std::optional<double> printed;   // what the source itself prints
  std::optional<double> expected;  // what this machine must show
  double tolerance = 0;            // [unit] of `expected`
  std::string source;              // of both
  std::string tile;                // its name among the tiles that open the page, or ""
  bool shown = true;               // in the text at the end and on the page

  static constexpr int kWhole = -1;

  std::string name() const;
  bool good() const;  // within tolerance, or nothing is expected
};

// A figure for people and machines; more can be set behind it.
Figure figure(std::string id, std::string row, std::string column, double value, std::string unit,
              int digits = 3);
Figure count(std::string id, std::string row, std::string column, double value,
             std::string unit = "");

// That with this id; nullptr where there is none.
const Figure* find_figure(const std::vector<Figure>& figures, std::string_view id);

// Puts every value at its place in `json`, and the list itself under "figures".
void put_figures(nlohmann::ordered_json& json, const std::vector<Figure>& figures);

// "12.34", "17", or "-" where there is no value.
std::string figure_text(const std::optional<double>& value, int digits);

// Tables and lines of all that are shown; then ours beside the source's, where there are such.
std::string figures_text(const std::vector<Figure>& figures);

// One line for each that lies outside its tolerance.
std::vector<std::string> outside(const std::vector<Figure>& figures);

// Whether any of them has an expected value.
bool any_expected(const std::vector<Figure>& figures);

}  // namespace trammel::lab
