// SPDX-License-Identifier: Apache-2.0
#include "cosim/wave_event.hpp"

#include <catch2/catch.hpp>

using namespace trammel::cosim;
using Catch::Contains;
using What = WaveEvent::What;

TEST_CASE("an event of waves is a word, with a time if wanted, or a time") {
  CHECK(parse_wave_event("drive").what == What::kDrive);
  CHECK(parse_wave_event(" hi ").what == What::kHost);
  CHECK(parse_wave_event("irq after 2ms").what == What::kIrq);
  CHECK(parse_wave_event("irq after 2ms").edge == 100000);
  CHECK_FALSE(parse_wave_event("hi").known());
  CHECK(parse_wave_event("at 10us").known());
  CHECK(parse_wave_event("at 10us").edge == 500);
}

TEST_CASE("what is no event is refused with those that are") {
  for (const char* text : {"", "hit", "x.e > 3", "drive after", "at 1ms after 2ms"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_wave_event(text), Contains("is none of: drive (a converter"));
  }
  CHECK_THROWS_WITH(parse_wave_event("at 2h"), Contains("0..3600 s"));
  CHECK_THROWS_WITH(parse_wave_event("hi after -1s"), Contains("0..3600 s"));
}

TEST_CASE("the default window hangs at the first drive, one of the user's own at nothing") {
  RunBasics run;
  CHECK_FALSE(EventSearch::event(run));
  run.wave = WaveFormat::kFst;
  REQUIRE(EventSearch::event(run));
  CHECK(EventSearch::event(run)->what == What::kDrive);
  run.wave_end_s = 0.001;
  CHECK_FALSE(EventSearch::event(run));
  run.wave_trigger = "hi";
  CHECK(EventSearch::event(run)->what == What::kHost);
}
