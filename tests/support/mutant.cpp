// SPDX-License-Identifier: Apache-2.0
//
// Which mutant of a block a unit test sees: the number in TRAMMEL_MUTANT, 0 is the block itself.
// Compiled by trammel verify only.
#include <cstdlib>

extern "C" int trammel_mutant() {
  const char* number = std::getenv("TRAMMEL_MUTANT");
  return number != nullptr ? std::atoi(number) : 0;
}
