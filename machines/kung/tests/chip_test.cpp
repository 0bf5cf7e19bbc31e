// SPDX-License-Identifier: Apache-2.0
//
// The chip of the table: the ranges of its signals, and its pins beside those of the plant.
#include <catch2/catch.hpp>

#include "machines/kung/chip.hpp"
#include "machines/kung/lines.hpp"
#include "models/plant/xy_lines.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;
using namespace trammel::kung;
namespace table = plant::xy;

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

TEST_CASE("the pins of the table are where the chip's side expects them") {
  REQUIRE(table::kAxes == kung::kAxes);
  for (int k = 0; k < table::kAxes; ++k) {
    CHECK(table::encoder_a(k) == kung::encoder_a(k));
    CHECK(table::encoder_b(k) == kung::encoder_b(k));
    CHECK(table::encoder_z(k) == kung::encoder_z(k));
    for (int phase = 0; phase < 3; ++phase) {
      CHECK(table::gate_hi(k, phase) == kung::gate_hi(k, phase));
      CHECK(table::gate_lo(k, phase) == kung::gate_lo(k, phase));
      CHECK(table::adc_channel(k, phase) == kung::adc_channel(k, phase));
    }
  }
}
