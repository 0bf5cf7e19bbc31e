// SPDX-License-Identifier: Apache-2.0
//
// Runs of the table with results made by hand.
#pragma once

#include <memory>
#include <utility>

#include "machines/kung/chip/record.hpp"
#include "tests/support/short_run.hpp"

namespace trammel::test {

inline int run_kung(const std::filesystem::path& out, kung::Result result,
                    std::vector<std::string> set = {}) {
  const testbench::Simulate simulate = [&](const lab::Settings& settings, const cosim::Hooks&) {
    return lab::judged(settings.clone(), std::make_unique<kung::Result>(std::move(result)));
  };
  return run(arguments_for("circle", out, std::move(set)), simulate);
}

}  // namespace trammel::test
