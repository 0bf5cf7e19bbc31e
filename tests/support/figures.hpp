// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <algorithm>
#include <string>

#include "lab/machine.hpp"

namespace trammel::test {

// A figure of a result, by its id.
template <class Options>
double figure(const Options& options, cosim::RunResult& result, const std::string& id) {
  const auto list = options.machine().figures(options, result);
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const lab::Figure& f) { return f.id == id; });
  INFO(id);
  REQUIRE(found != list.end());
  return found->value;
}

}  // namespace trammel::test
