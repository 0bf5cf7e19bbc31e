// SPDX-License-Identifier: Apache-2.0
#include "cosim/trigger_search.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "machines/an693/machine.hpp"
#include "parts/lm628/signals.hpp"

using namespace trammel;
using namespace trammel::cosim;
using Catch::Contains;
using When = Trigger::When;

namespace {

Trigger parsed(const std::string& text) { return parse_trigger(text, an693::triggers()); }

struct FakeChip final : MachineChip {
  Clk rise = kNever;
  Clk now() const override { return 0; }
  Stop run(Clk, const Plant&) override { return {}; }
  Lines drive() const override { return 0; }
  void sense(Lines) override {}
  bool irq() const override { return false; }
  void request(const BusOp&) override {}
  std::uint32_t rdata() const override { return 0; }
  Clk evaluated() const override { return 0; }
  Clk host_rise() const override { return rise; }
};

struct FakeWords final : SignalReader {
  lm628::Words words;
  std::int64_t read(std::size_t signal, int) const override { return lm628::word(words, signal); }
};

}  // namespace

TEST_CASE("a trigger is an event, with a delay if wanted, or a time") {
  for (const char* text : {"drive", " hi ", "irq after 2ms"}) {
    CHECK(parsed(text).when == When::kEvent);
    CHECK_FALSE(parsed(text).known());
  }
  CHECK(parsed("irq after 2ms").edge == 100000);
  CHECK(parsed("at 10us").known());
  CHECK(parsed("at 10us").edge == 500);
  CHECK(parsed("rise status.breakpoint").when == When::kRises);
  CHECK(parsed("e > -20").value == -20);
}

TEST_CASE("a trigger that is not an event is refused with a list of those that are") {
  for (const char* text : {"", "drive after", "e", "rise", "x.e > 3 and e > 3"}) {
    INFO(text);
    CHECK_THROWS_WITH(parsed(text), Contains("is none of: drive (a converter"));
  }
  for (const char* text : {"hit", "x.e > 3", "fall status.brk", "row == 1"}) {
    INFO(text);
    CHECK_THROWS_AS(parsed(text), UnknownName);
  }
  CHECK_THROWS_WITH(parsed("e > 40000"), "e: value 40000 is out of range -32768..32767");
  CHECK_THROWS_WITH(parsed("at 1ms after 2ms"), Contains("exclude each other"));
  CHECK_THROWS_WITH(parsed("at 2h"), Contains("0..3600 s"));
  CHECK_THROWS_WITH(parsed("hi after -1s"), Contains("0..3600 s"));
}

TEST_CASE("events are seen at their clock, words where a sample is published") {
  FakeChip chip;
  FakeWords words;
  const auto found = [&](const std::string& text, const std::vector<Stop>& stops) {
    TriggerSearch search(parsed(text));
    for (const Stop& stop : stops) {
      words.words.error = static_cast<std::int32_t>(stop.edge);
      words.words.status = stop.edge >= 30 ? 0x40 : 0;
      chip.rise = stop.edge >= 25 ? 25 : kNever;
      search.on(stop, chip, words);
    }
    return search.found().value_or(-1);
  };
  const std::vector<Stop> stops{{10, kSample}, {15, kDrive}, {20, kSample | kDrive}, {25, kBusDone},
                                {30, kSample}, {35, kIrq}};
  CHECK(found("drive", stops) == 15);
  CHECK(found("drive after 320ns", stops) == 20);
  CHECK(found("irq", stops) == 35);
  CHECK(found("hi", stops) == 25);
  CHECK(found("e > 14", stops) == 20);  // not at 15: no sample
  CHECK(found("e > 5", stops) == -1);   // was so from the first
  CHECK(found("rise status.breakpoint", stops) == 30);
  CHECK(found("status == 0x40", stops) == 30);
  CHECK(found("fall status.breakpoint", stops) == -1);
}

TEST_CASE("the words of a part are those of its samples") {
  FakeWords all;
  all.words = {-5 * 65536, 6, 7, -8, 9, -10, 11, -12, 0x84};
  const std::map<std::string, std::int64_t> wanted{
      {"desired_count", -5}, {"desired_speed", 6}, {"real_count", 7}, {"e", -8}, {"p", 9},
      {"i", -10}, {"d", 11}, {"output", -12}, {"status", 0x84}, {"status.motor_off", 1},
      {"status.complete", 1}};
  for (std::size_t n = 0; n < lm628::signals().size(); ++n) {
    const std::string name = lm628::signals()[n].name;
    INFO(name);
    const auto found = wanted.find(name);
    CHECK(all.read(n, 0) == (found == wanted.end() ? 0 : found->second));
  }
}

TEST_CASE("the default window is anchored to the first drive, the user's own is not") {
  RunBasics run;
  CHECK_FALSE(wave_event(run, an693::triggers()));
  run.wave = WaveFormat::kFst;
  REQUIRE(wave_event(run, an693::triggers()));
  CHECK(wave_event(run, an693::triggers())->when == When::kEvent);
  run.wave_end_s = 0.001;
  CHECK_FALSE(wave_event(run, an693::triggers()));
  run.wave_trigger = "e > 3";
  CHECK(wave_event(run, an693::triggers())->when == When::kHolds);
}
