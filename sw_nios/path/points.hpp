// SPDX-License-Identifier: Apache-2.0
//
// Points given as a list, one per interrupt. A further lap begins at the first point without
// writing it twice, so the list of a repeated path must be closed (last point = first point).
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class Points {
 public:
  struct Setup {
    const Point* points = nullptr;  // not owned
    std::uint32_t count = 0;
  };

  constexpr Points(const Setup& setup, std::uint32_t laps) : setup_(setup), laps_(laps) {}

  constexpr std::uint32_t size() const {
    return setup_.count < 2 ? setup_.count : laps_ * (setup_.count - 1) + 1;
  }
  constexpr Point start() const { return setup_.count == 0 ? Point{} : setup_.points[0]; }

  constexpr Point next() {
    if (setup_.count == 0) return {};
    const Point point = setup_.points[index_];
    index_ = index_ + 1 < setup_.count ? index_ + 1 : setup_.count < 2 ? 0 : 1;
    return point;
  }

 private:
  Setup setup_;
  std::uint32_t laps_;
  std::uint32_t index_ = 0;
};

}  // namespace trammel::sw
