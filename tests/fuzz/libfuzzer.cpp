// SPDX-License-Identifier: Apache-2.0
//
// The entry of libFuzzer. TRAMMEL_FUZZ_TARGET names the input, TRAMMEL_FUZZ_RUNS the folder with a
// run of each machine; scripts/tool fuzz sets both.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/fuzz/inputs.hpp"

namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static trammel::fuzz::Inputs inputs(variable("TRAMMEL_FUZZ_RUNS"));
  static const std::string target = variable("TRAMMEL_FUZZ_TARGET");
  inputs.try_one(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
