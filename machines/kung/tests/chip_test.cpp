// SPDX-License-Identifier: Apache-2.0
//
// The chip of the table: the ranges of its signals, the events that a trigger may name, and its
// pins beside those of the plant.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/pins.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;
using namespace trammel::kung;
using cosim::Trigger;
using cosim::TriggerSearch;

namespace {

struct RangeWatch final : cosim::Watcher {
  int edges = 0;
  std::string outside;

  void after(cosim::Clk, const SignalReader& chip) override {
    ++edges;
    for (std::size_t s = 0; s < signals().size(); ++s) {
      const Signal& signal = signals()[s];
      const std::int64_t span = std::int64_t{1} << signal.bits;
      const std::int64_t low = signal.is_signed ? -span / 2 : 0;
      for (int axis = 0; axis < (signal.of_axis ? 2 : 1); ++axis) {
        const std::int64_t value = chip.read(s, axis);
        if (value < low || value >= low + span) outside = signal.name;
      }
    }
  }
};

Trigger parse_trigger(const std::string& text) {
  return cosim::parse_trigger(text, triggers(), 20'000);
}

// A chip of which only the named signals move.
struct FakeChip final : SignalReader {
  std::map<std::string, std::int64_t> values;  // "x.e", "TICK"
  std::int64_t read(std::size_t signal, int axis) const override {
    const Signal& s = signals()[signal];
    const auto found =
        values.find((s.of_axis ? (axis == 0 ? "x." : "y.") : "") + std::string(s.name));
    return found == values.end() ? 0 : found->second;
  }
};

// Edge at which `text` fires when `name` takes these values at edges 0, 1, 2, ...; -1 = never.
cosim::Clk fires(const std::string& text, const std::string& name,
                 const std::vector<std::int64_t>& values) {
  TriggerSearch search(parse_trigger(text));
  FakeChip chip;
  cosim::Clk edge = 0;
  for (const std::int64_t value : values) {
    chip.values[name] = value;
    search.after(edge++, chip);
  }
  return search.found().value_or(-1);
}

}  // namespace

TEST_CASE("every signal that a trigger may name is within its range from the reset on") {
  RangeWatch watch;
  const auto chip = make_watched_chip(watch, false);
  const test::NoPlant plant;
  while (chip->now() < 2000) chip->run(2000, plant);
  CHECK(watch.edges > 1900);
  CHECK(watch.outside.empty());
}

TEST_CASE("of two chips either may be destroyed first, whichever was evaluated last") {
  RangeWatch watch;
  const test::NoPlant plant;
  auto first = make_watched_chip(watch, false);
  auto second = make_watched_chip(watch, false);
  second->run(2, plant);
  second.reset();
  first.reset();
  first = make_watched_chip(watch, false);
  second = make_watched_chip(watch, false);
  first->run(2, plant);
  first.reset();
  second->run(2, plant);
  CHECK(second->now() > 0);
}

TEST_CASE("events are changes of the signals behind them") {
  CHECK(fires("drives", "y.CTRL.enable", {0, 1}) == 1);
  CHECK(fires("afc.x", "x.afc", {0, 0, 1, 1}) == 2);
  CHECK(fires("afc.x", "y.afc", {0, 0, 1, 1}) == -1);
  CHECK(fires("fault", "FAULT.code", {0, 3}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 4}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 3}) == -1);
  for (const char* text : {"fault.encodr", "afc.z", "drive", "faults"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_trigger(text), cosim::UnknownName);
  }
}
