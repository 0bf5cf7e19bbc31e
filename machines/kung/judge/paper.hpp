// SPDX-License-Identifier: Apache-2.0
//
// What Kung et al. 2012 (DOI 10.5772/48457) print and the specification expects of a run, and the
// table of all experiments.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

// What is taken for the values that the paper does not print: those of the defaults, and those of
// the scenarios paper-*, by which Table 2 fits (docs/table2.md).
enum class Reading { kAssumed, kFitted };
inline constexpr std::size_t kReadings = 2;
inline constexpr char kFittedPrefix[] = "paper-";

// By which reading the run is one of the paper's eight experiments, with nothing but seed,
// platform, name and waves changed; none: by neither.
std::optional<Reading> paper_experiment(const Options& options);

// Sets what is printed and expected in the figures of a complete run of such an experiment.
void compare(const Options& options, std::vector<lab::Figure>& figures);

// The controllers of the paper, in the order in which they are told.
inline constexpr std::pair<const char*, Controller> kFuzzy[]{{"AFC", Controller::kAfc},
                                                             {"FC", Controller::kFc}};

// Mean tracking error to the reference model that the paper prints (Kung Table 2) of this path, by
// controller; none of another path.
std::vector<std::pair<std::string, double>> paper_means_mm(const Options& options);

// What must be said wherever Table 2 is shown (specification section 14.14).
std::string circle_note(Reading reading);

std::vector<lab::Experiment> experiments();
std::string experiments_text(const std::vector<const lab::Record*>& records);

}  // namespace trammel::kung
