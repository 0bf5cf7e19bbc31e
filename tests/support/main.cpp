// SPDX-License-Identifier: Apache-2.0
//
// Catch2's main, alone: it takes long to compile, and unit tests with and without waves share it.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

namespace trammel::test {

extern const bool kFirstFailure;
extern const bool kListened;  // by first_failure.cpp, which a library holds back without this
const bool kListened = kFirstFailure;

}  // namespace trammel::test
