// SPDX-License-Identifier: Apache-2.0
//
// What the thesis shows of an experiment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "machines/gantry/options.hpp"

namespace trammel::gantry {

struct ThesisFigure {
  int number = 0;
  std::string says;
};

// Of a built-in scenario, as it is or with the settings of another row of published_values.cpp.
// Keys of the run's length, of its record and of its step may differ.
std::optional<ThesisFigure> thesis_figure(const Options& options);

// Sets what is printed of the experiment of `options`; where nothing differs, what is expected too.
void set_published_values(const Options& options, bool whole, std::vector<lab::Figure>& figures);

}  // namespace trammel::gantry
