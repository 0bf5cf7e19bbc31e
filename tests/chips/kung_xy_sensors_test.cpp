// SPDX-License-Identifier: Apache-2.0
//
// Registers that fit an axis to its sensors and its model act on that axis, each field where it
// belongs.
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/chips/kung_bench.hpp"
#include "tests/support/checked.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::test::kFewer;
using trammel::test::KungBench;

namespace {

constexpr std::array<std::uint32_t, 2> kBases{reg::kX, reg::kY};

// What both halves of the register read after a whole frame and its current loop.
struct Pair {
  int low, high;
};

Pair after_a_frame(KungBench& chip, std::uint32_t address) {
  chip.leap_to_tick();
  chip.edges(200);
  const std::uint32_t word = chip.read(address);
  return {static_cast<std::int16_t>(word & 0xFFFF), static_cast<std::int16_t>(word >> 16)};
}

}  // namespace

TEST_CASE("ADC_FRAME moves the code in the frames of its own axis alone") {
  for (std::size_t k = 0; k < 2; ++k) {
    CAPTURE(k);
    KungBench chip;
    chip.write(kBases[k] + reg::kAdcFrame, 2);
    chip.codes[k] = {(2048u + 300) << 2, (2048u - 70) << 2};
    chip.codes[1 - k] = {2048 + 5, 2048 + 9};
    const Pair own = after_a_frame(chip, kBases[k] + reg::kPhaseCurrents);
    CHECK(own.low == 300);
    CHECK(own.high == -70);
    const Pair other = after_a_frame(chip, kBases[1 - k] + reg::kPhaseCurrents);
    CHECK(other.low == 5);
    CHECK(other.high == 9);
  }
}

TEST_CASE("CURRENT_OFFSET is taken from the codes of its own axis, each field from its phase") {
  for (std::size_t k = 0; k < 2; ++k) {
    CAPTURE(k);
    KungBench chip;
    chip.write(kBases[k] + reg::kCurrentOffset,
               100u << reg::kCurrentOffsetAShift | 0xFCEu << reg::kCurrentOffsetBShift);  // -50
    const Pair own = after_a_frame(chip, kBases[k] + reg::kPhaseCurrents);
    CHECK(own.low == -100);
    CHECK(own.high == 50);
    const Pair other = after_a_frame(chip, kBases[1 - k] + reg::kPhaseCurrents);
    CHECK(other.low == 0);
    CHECK(other.high == 0);
  }
}

TEST_CASE("ANGLE_STEP turns the currents of its own axis by its angle for each count") {
  constexpr int kRounding = 2;  // of Clarke's and Park's products
  for (std::size_t k = 0; k < 2; ++k) {
    CAPTURE(k);
    KungBench chip;
    for (const std::uint32_t base : kBases) chip.write(base + reg::kPosPreset, 1);
    chip.write(kBases[k] + reg::kAngleStep, 0x40000000);  // a quarter of a revolution
    for (KungBench::Codes& codes : chip.codes) codes.a += 300;  // i_alpha = 300, i_beta = 173
    const Pair own = after_a_frame(chip, kBases[k] + reg::kIdIq);
    CHECK(own.low == Approx(173).margin(kRounding));
    CHECK(own.high == Approx(-300).margin(kRounding));
    const Pair other = after_a_frame(chip, kBases[1 - k] + reg::kIdIq);
    CHECK(other.low == Approx(300).margin(kRounding));
    CHECK(other.high == Approx(173).margin(kRounding));
  }
}

TEST_CASE("A0 of each scale is that of its own axis: 160,000 of 2^-32 are 10,000 of 2^-28") {
  KungBench chip;
  chip.write(reg::kX + reg::kA0, 160000);
  chip.write(reg::kY + reg::kA0, 10000 | 1u << reg::kA0ScaleShift);
  for (const std::uint32_t base : kBases) chip.write(base + reg::kPosCmd, 4000000);
  chip.write(reg::kCommit, reg::kCommitTake);
  for (int n = 0; n < 10; ++n) chip.leap_to_sample();
  const std::uint32_t x = chip.read(reg::kX + reg::kPosModel);
  CHECK(x > 100);
  CHECK(x == chip.read(reg::kY + reg::kPosModel));
}

// At count 1 the angle is ANGLE_STEP + THETA_OFS, which wraps to 0 only by a carry through each bit
// from the lowest set one on; without one of them it is 0.35 degrees or more less. The axes have
// different bits, so that a word of the other one does not make it wrap.
TEST_CASE("each bit of ANGLE_STEP and THETA_OFS is in the angle of its own axis") {
  KungBench chip;
  for (const std::uint32_t base : kBases) chip.write(base + reg::kPosPreset, 1);
  for (KungBench::Codes& codes : chip.codes) codes.a += 1800;  // i_alpha = 1800, i_beta = 1039
  const auto currents = [&chip] {
    chip.leap_to_tick();  // which the frame of this one follows
    const Pair x = after_a_frame(chip, reg::kX + reg::kIdIq);
    const auto y = static_cast<std::int16_t>(chip.read(reg::kY + reg::kIdIq) >> 16);
    return std::array<int, 2>{x.high, y};
  };
  for (int bit = 0; bit < 32; bit += kFewer) {
    const std::array<std::uint32_t, 2> one{1u << bit, 1u << (31 - bit)};
    for (std::size_t k = 0; k < 2; ++k) {
      chip.write(kBases[k] + reg::kAngleStep, one[k]);
      chip.write(kBases[k] + reg::kThetaOfs, 0u - one[k]);
    }
    const std::array<int, 2> all = currents();
    for (std::size_t k = 0; k < 2; ++k) {
      chip.write(kBases[k] + reg::kThetaOfs, (0u - one[k]) & ~one[k]);
    }
    const std::array<int, 2> without = currents();
    for (std::size_t k = 0; k < 2; ++k) {
      CAPTURE(k, bit);
      CHECK(all[k] == Approx(1039).margin(3));
      CHECK(without[k] != Approx(1039).margin(6));
    }
  }
}
