// SPDX-License-Identifier: Apache-2.0
//
// Firmware of the precision controller with a payload that the motor is too weak for: an axis
// that is heavy and late gets a K1 sixteen times lower, once (docs/precision.md, section 11).
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "machines/kung/tests/fake_chip.hpp"
#include "sw_nios/apps/kung/identification.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

constexpr std::uint32_t kAxes[] = {reg::kX, reg::kY};
constexpr std::int32_t kLate = 16 * 256 * 32;  // ERR_SUM of 16 counts
constexpr std::uint32_t kK1 = 11;              // word of the window

// Masses stay as they start; unlike on X and Y.
KungSetup setup_of(bool identify) {
  KungSetup s;
  s.precision.on = true;
  s.precision.identify = identify;
  s.precision.adapt = false;
  for (std::uint32_t a = 0; a < 2; ++a) {
    PrecisionAxisSetup& axis = s.precision.axis[a];
    axis.full[3] = {a == 0 ? 1475 : 1100, a == 0 ? -11 : -13};
    axis.estimator.mass = axis.heavy = a == 0 ? 1'000'000 : 1'500'000;
  }
  return s;
}

std::string k1_at(std::uint32_t interrupt, std::uint32_t word) {
  return "interrupt " + std::to_string(interrupt) + ": word " + std::to_string(word);
}
std::string k1_at(std::uint32_t interrupt, Gain gain) { return k1_at(interrupt, gain_word(gain)); }

// Words written at K1 in that many interrupts, with the time of each.
std::vector<std::string> slowed(Machine& m, std::uint32_t axis, std::uint32_t interrupts) {
  std::vector<std::string> words;
  for (std::uint32_t n = 0; n < interrupts; ++n) {
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    for (const auto& [at, word] : window(m.chip, kAxes[axis], before)) {
      if (at == kK1) words.push_back(k1_at(n, word));
    }
  }
  return words;
}

}  // namespace

TEST_CASE("a heavy axis that is late by more than 16 counts slows down, once, the other does not") {
  for (const std::uint32_t a : {0u, 1u}) {
    for (const std::int32_t error : {kLate, kLate + 1, -kLate, -kLate - 1, 100 * kLate}) {
      for (const std::int32_t lighter : {0, 1}) {
        CAPTURE(a, error, lighter);
        KungSetup setup = setup_of(false);
        setup.precision.axis[a].heavy += lighter;
        Machine m(setup), other(setup);
        for (Machine* each : {&m, &other}) {
          each->arm();
          each->chip.registers[kAxes[a] + reg::kErrSum] = static_cast<std::uint32_t>(error);
        }
        const bool late = error > kLate || error < -kLate;
        std::vector<std::string> wanted;
        if (late && lighter == 0) {
          wanted.push_back(k1_at(0, a == 0 ? Gain{1475, -15} : Gain{1100, -16}));
        }
        CHECK(slowed(m, a, 20) == wanted);
        CHECK(slowed(other, 1 - a, 20).empty());
      }
    }
  }
}

TEST_CASE("a heavy axis that is late in the move before the path slows down on the path") {
  KungSetup setup = setup_of(true);
  setup.precision.axis[1].heavy = 1;  // whatever the move tells
  Machine m(setup);
  m.arm();
  m.chip.registers[reg::kY + reg::kErrSum] = static_cast<std::uint32_t>(-2 * kLate);
  const auto words = slowed(m, 1, Identification::kPoints + 3);
  CHECK(words == std::vector<std::string>{k1_at(Identification::kFull, Gain{1100, -13}),
                                          k1_at(Identification::kPoints, Gain{1100, -16})});
}

TEST_CASE("words of the knot are at their places behind a slower K1") {
  Machine m(setup_of(false)), plain(setup_of(false));
  m.arm();
  plain.arm();
  m.chip.registers[reg::kX + reg::kErrSum] = kLate + 1;
  const std::size_t before = m.chip.log.size(), before_plain = plain.chip.log.size();
  m.interrupt();
  plain.interrupt();
  auto writes = m.chip.writes(before);
  const auto same = plain.chip.writes(before_plain);
  REQUIRE(writes.size() == same.size() + 2);
  writes.erase(writes.begin() + 1, writes.begin() + 3);  // behind IRQ_STAT
  for (std::size_t n = 0; n < same.size(); ++n) {
    CAPTURE(n, same[n].address);
    CHECK(writes[n].address == same[n].address);
    CHECK(writes[n].data == same[n].data);
  }
}
