// SPDX-License-Identifier: Apache-2.0
//
// Reproducible 32-bit random numbers; std::mt19937 returns a wider type than it fills.
#pragma once

#include <cstdint>
#include <random>

namespace trammel::test {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t operator()() { return static_cast<std::uint32_t>(engine_()); }

 private:
  std::mt19937 engine_;
};

}  // namespace trammel::test
