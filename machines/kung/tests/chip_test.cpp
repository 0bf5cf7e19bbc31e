// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "machines/kung/chip.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;
using namespace trammel::kung;

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
