// SPDX-License-Identifier: Apache-2.0
//
// How much random traffic a test makes, and which: TRAMMEL_TEST_TRANSFERS and TRAMMEL_TEST_SEED
// replace what the test has of its own (docs/verification.md).
#pragma once

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace trammel::test {

struct Traffic {
  std::int64_t transfers;
  std::uint32_t seed;

  // What repeats it up to this transfer.
  std::string until(std::int64_t transfer) const {
    return "TRAMMEL_TEST_SEED=" + std::to_string(seed) +
           " TRAMMEL_TEST_TRANSFERS=" + std::to_string(transfer + 1) + " repeats it";
  }
};

inline std::int64_t number_of_environment(const char* name, std::int64_t otherwise) {
  const char* const text = std::getenv(name);
  if (text == nullptr) return otherwise;
  char* end = nullptr;
  const std::int64_t value = std::strtoll(text, &end, 10);
  if (end == text || *end != 0 || value < 0) {
    throw std::invalid_argument(std::string(name) + " is no number: " + text);
  }
  return value;
}

inline Traffic traffic(std::int64_t transfers, std::uint32_t seed) {
  return {number_of_environment("TRAMMEL_TEST_TRANSFERS", transfers),
          static_cast<std::uint32_t>(number_of_environment("TRAMMEL_TEST_SEED", seed))};
}

// Whether the numbers are the test's own: only then is known what the traffic reaches.
inline bool own_traffic() {
  return std::getenv("TRAMMEL_TEST_TRANSFERS") == nullptr &&
         std::getenv("TRAMMEL_TEST_SEED") == nullptr;
}

}  // namespace trammel::test
