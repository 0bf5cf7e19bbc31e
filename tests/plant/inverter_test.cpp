// SPDX-License-Identifier: Apache-2.0
#include "models/plant/inverter.hpp"

#include <catch2/catch.hpp>

using namespace trammel::plant;

namespace {

Legs resolve(const Inverter& inverter, unsigned gates, std::array<double, 3> i, unsigned zero = 0,
             std::array<double, 3> emf = {}) {
  // A balanced motor: the leg whose current stays zero sits at its back-EMF above the star point.
  return inverter.resolve(gates, i, zero, emf, [&](std::size_t k, const std::array<double, 3>& v) {
    const double others = v[0] + v[1] + v[2] - v[k];
    return 0.5 * (others + 3 * emf[k]);
  });
}

}  // namespace

TEST_CASE("a leg with one switch on is tied to its rail") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0b110'001, {1, -0.5, -0.5});
  CHECK(legs.volt == std::array<double, 3>{311, 0, 0});
  CHECK(legs.floating == 0);
  CHECK_FALSE(legs.open);
}

TEST_CASE("with both switches off the sign of the current picks the diode") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0, {1, -0.25, -0.75});
  CHECK(legs.volt == std::array<double, 3>{0, 311, 311});
  CHECK(legs.diode == std::array<int, 3>{1, -1, -1});
}

TEST_CASE("drops oppose the current in switches and diodes") {
  const Inverter inverter({311, 2, 1});
  CHECK(resolve(inverter, 0b110'001, {1, -0.5, -0.5}).volt == std::array<double, 3>{309, 2, 2});
  CHECK(resolve(inverter, 0b110'001, {-1, 0.5, 0.5}).volt == std::array<double, 3>{312, -1, -1});
  CHECK(resolve(inverter, 0, {1, -0.5, -0.5}).volt == std::array<double, 3>{-1, 312, 312});
}

TEST_CASE("a leg without current floats at the voltage that keeps it so") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0b010'001, {1, -1, 0}, 4, {0, 0, 10});
  CHECK(legs.floating == 4);
  CHECK(legs.volt[2] == Approx(0.5 * (311 + 30)));
  CHECK_FALSE(legs.open);
}

TEST_CASE("a floating leg that would leave the rails conducts through its diode") {
  const Inverter inverter({24, 0, 0.5});
  // A and B low, the back-EMF of C positive: its upper diode opens when 1.5 e > 24.5 V.
  CHECK(resolve(inverter, 0b011'000, {0, 0, 0}, 4, {-8, -8, 16}).floating == 4);
  const Legs up = resolve(inverter, 0b011'000, {0, 0, 0}, 4, {-9, -9, 18});
  CHECK(up.diode[2] == -1);
  CHECK(up.volt[2] == 24.5);
  const Legs down = resolve(inverter, 0b011'000, {0, 0, 0}, 4, {1, 1, -2});
  CHECK(down.diode[2] == 1);
  CHECK(down.volt[2] == -0.5);
}

TEST_CASE("with all gates off current flows only above the link voltage") {
  const Inverter inverter(InverterConfig{});
  CHECK(resolve(inverter, 0, {0, 0, 0}, 7, {150, -150, 0}).open);
  const Legs legs = resolve(inverter, 0, {0, 0, 0}, 7, {160, -160, 0});
  CHECK_FALSE(legs.open);
  CHECK(legs.diode == std::array<int, 3>{-1, 1, 0});
  CHECK(legs.floating == 4);
}

TEST_CASE("one switch on alone lets the back-EMF brake through the diodes of its rail") {
  const Inverter inverter(InverterConfig{});
  CHECK(resolve(inverter, 0b001'000, {0, 0, 0}, 7, {0, 0, 0}).open);
  const Legs legs = resolve(inverter, 0b001'000, {0, 0, 0}, 7, {5, -10, 5});
  CHECK_FALSE(legs.open);
  CHECK(legs.diode[1] == 1);
}

TEST_CASE("both switches of a leg on is shoot-through") {
  CHECK(shoot_through(0b001'001));
  CHECK(shoot_through(0b100'100));
  CHECK_FALSE(shoot_through(0b010'101));
  CHECK_FALSE(shoot_through(0));
}
