// SPDX-License-Identifier: Apache-2.0
//
// Rules that concern more than one key.
#include <fmt/format.h>

#include "machines/mcafee/machine_members.hpp"
#include "parts/lm628/motor.hpp"

namespace trammel::mcafee {

Table table_of(const Options& options) {
  try {
    return make_table(options.path, options.count_mm(), options.travel_mm());
  } catch (const cosim::OptionsError& error) {
    throw host::ConfigError(error.what());
  } catch (const std::invalid_argument& error) {  // the file of points
    throw host::ConfigError(fmt::format("path.points_file: {}", error.what()));
  }
}

void validate(lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  lm628::check_clock(options.clock_MHz);
  lm628::check_motor(options.stage_axis.motor);
  if (options.tracks()) table_of(options);
}

std::vector<std::string> warnings(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  return options.tracks() ? table_of(options).warnings : std::vector<std::string>{};
}

}  // namespace trammel::mcafee
