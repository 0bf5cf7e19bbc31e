// SPDX-License-Identifier: Apache-2.0
//
// Bits of STATUS of gantry_tau that events set and a write of 1 clears.
#include <catch2/catch.hpp>

#include <cstdint>

#include "tests/chips/gantry_tau_bench.hpp"
#include "tests/support/flags.hpp"
#include "tests/support/stripe_sensor.hpp"

using trammel::test::clears_what_a_new_bench_shows;
using trammel::test::GantryBench;
using namespace trammel::gantry_tau_regs;

TEST_CASE("gantry_tau: an event in the very clock of the write that clears its bit is kept") {
  struct Case {
    const char* name;
    std::uint32_t bit;
    std::int64_t after;  // [clk] behind the cause: the event has been, the next one has not
    void (*cause)(GantryBench&);
  };
  const Case cases[] = {
      {"pass", kStatusPass, 700, [](GantryBench& bench) { bench.put(kPassPeriod, 500); }},
      {"overrun", kStatusOverrun, 700,
       [](GantryBench& bench) {
         bench.put(kPassPeriod, 500);
         bench.clocks(600);  // the first pass is not cleared
       }},
      {"sample", kStatusSample, 12'000,  // a tick is 10842 clocks
       [](GantryBench& bench) { bench.put(kRequest, kRequestCurrent); }},
      {"refused", kStatusRefused, 300, [](GantryBench&) {}},  // what an empty store holds
      {"stored", kStatusStored, 600, [](GantryBench& bench) {
         bench.clocks(100);  // the store is read
         bench.put(kCalibrate, 1u << 16);
         for (const std::uint16_t word : trammel::test::ideal_calibration().words) {
           bench.put(kCalibrate, 2u << 16 | word);
         }
         bench.put(kCalibrate, 7u << 16);
       }}};
  for (const Case& one : cases) {
    CAPTURE(one.name);
    clears_what_a_new_bench_shows<GantryBench>(
        0, one.after,
        [&one](GantryBench& bench, std::int64_t n) {
          one.cause(bench);
          bench.clocks(n);
        },
        [&one](GantryBench& bench) { return (bench.get(kStatus) & one.bit) != 0; },
        [&one](GantryBench& bench) { bench.put(kStatus, one.bit); });
  }
}
