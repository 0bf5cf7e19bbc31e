// SPDX-License-Identifier: Apache-2.0
//
// A sweep: how the tracking error grows with the payload, under both controllers.
#include <cstdio>
#include <exception>
#include <string>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"

using namespace trammel;

namespace {

double mean_error_mm(const std::string& controller, double payload_kg) {
  const auto settings = lab::load_scenario(lab::find_scenario("circle"));
  lab::apply_assignment(*settings, "run.engine=twin");
  lab::apply_assignment(*settings, "controller=" + controller);
  lab::apply_assignment(*settings, "plant.payload_kg=" + std::to_string(payload_kg));
  lab::validate(*settings);
  const lab::Record record = lab::run(*settings);
  for (const lab::Figure& figure : record.figures) {
    if (figure.id == "tracking.model.mean_mm") return figure.value;
  }
  return 0;
}

}  // namespace

int main() try {
  lab::take_machines(linked_machines);
  std::printf("payload (kg)   FC (mm)  AFC (mm)\n");
  for (const double payload_kg : {0.0, 11.0, 22.0}) {
    std::printf("%12.0f %9.3f %9.3f\n", payload_kg, mean_error_mm("fc", payload_kg),
                mean_error_mm("afc", payload_kg));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
