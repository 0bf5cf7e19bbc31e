// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/lines.hpp"

#include <catch2/catch.hpp>

#include "models/plant/xy_lines.hpp"

using namespace trammel;
namespace table = plant::xy;

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
