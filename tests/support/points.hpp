// SPDX-License-Identifier: Apache-2.0
//
// How Catch2 shows the points of a path.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "sw_nios/path/q32.hpp"

namespace Catch {

template <>
struct StringMaker<trammel::sw::Point> {
  static std::string convert(const trammel::sw::Point& p) {
    return '(' + std::to_string(p.x) + ", " + std::to_string(p.y) + ')';
  }
};

}  // namespace Catch
