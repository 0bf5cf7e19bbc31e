// SPDX-License-Identifier: Apache-2.0
//
// With sanitizers tests run 10 to 30 times slower. They look at each line there, not for the rare
// value: a tenth of what is tried at random is enough.
#pragma once

#include <algorithm>

namespace trammel::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr int kFewer = 10;
#else
inline constexpr int kFewer = 1;
#endif

constexpr int trials(int count) { return std::max(1, count / kFewer); }

}  // namespace trammel::test
