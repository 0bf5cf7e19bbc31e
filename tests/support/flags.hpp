// SPDX-License-Identifier: Apache-2.0
//
// A bit that an event sets and an access clears, with the access at each clock around the event. It
// must clear what a read in its place would have shown: then no event is lost unseen.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

namespace trammel::test {

// shows(n): a read that begins n clocks behind the cause of the event shows the bit; not at n =
// `before`, but at `after`. keeps(n): an access that clears the bit begins there instead, and the
// bit is set at the end.
template <class Shows, class Keeps>
void clears_what_it_shows(std::int64_t before, std::int64_t after, Shows shows, Keeps keeps) {
  const std::int64_t first = before;
  REQUIRE_FALSE(shows(before));
  REQUIRE(shows(after));
  while (after - before > 1) {
    const std::int64_t middle = (before + after) / 2;
    (shows(middle) ? after : before) = middle;
  }
  // At `before` the access comes in the very clock of the event.
  for (std::int64_t n = std::max(first, before - 2); n <= after + 2; ++n) {
    CAPTURE(before, n);
    CHECK(keeps(n) == (n <= before));
  }
}

// The same of a bench that begins anew for each n: `begin` goes n clocks behind the cause, `told`
// reads the bit, `clear` is the access that clears it. By `after` the next event has not been.
template <class Bench, class Begin, class Told, class Clear>
void clears_what_a_new_bench_shows(std::int64_t before, std::int64_t after, Begin begin, Told told,
                                   Clear clear) {
  clears_what_it_shows(
      before, after,
      [&](std::int64_t n) {
        Bench bench;
        begin(bench, n);
        return told(bench);
      },
      [&](std::int64_t n) {
        Bench bench;
        begin(bench, n);
        clear(bench);
        bench.clocks(after - n);
        return told(bench);
      });
}

}  // namespace trammel::test
