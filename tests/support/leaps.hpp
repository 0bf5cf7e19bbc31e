// SPDX-License-Identifier: Apache-2.0
//
// Leaps of a block with timers, made beside its twin at random.
#pragma once

#include <algorithm>

#include "models/exact/math/timer.hpp"
#include "tests/support/random.hpp"

namespace trammel::test {

// One clock of both or, one time in `often`, a leap of at most `gap` clocks; 0 = none may be made.
template <class AnyRtl, class Twin, class... In>
void leap_or_step(AnyRtl& rtl, Twin& twin, exact::Gap gap, Random& random, unsigned often,
                  const In&... in) {
  if (gap > 0 && random() % often == 0) {
    const exact::Gap n = 1 + random() % std::min<exact::Gap>(gap, 4095);
    rtl->leap_i = (n - 1) & 0xFFF;
    twin.advance(n);
  } else {
    twin.step(in...);
  }
  rtl.tick();
  rtl->leap_i = 0;
  rtl.eval();
}

}  // namespace trammel::test
