// SPDX-License-Identifier: Apache-2.0
//
// What the precision controller of the table needs to know (docs/precision.md): words that the
// program computes from poles, encoder, motor and sensors. The defaults are those of the default
// table.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/apps/kung/estimator.hpp"
#include "sw_nios/apps/kung/gain.hpp"

namespace trammel::sw {

// L1 L2 L3 of the observer, K1 K2 of the feedback.
using LawGains = std::array<Gain, 5>;

struct PrecisionAxisSetup {
  LawGains full{{{1673, -1}, {1882, -4}, {1267, -9}, {1475, -11}, {1720, -5}}};
  LawGains soft{{{1401, -2}, {1050, -6}, {0, 0}, {1887, -14}, {1376, -6}}};  // to identify with
  std::uint32_t misc = 0x11AF46;  // LEAD 6, KNEE 4, SUB_TICKS 15, HYST 26, REST
  std::int32_t wave = 40960;      // of the identification move, from end to end [2^-8 count]
  std::int32_t heavy = 1749814;   // estimated mass from which on the motor may be too weak
  EstimatorSetup estimator;
};

// Learned corrections of both axes, point by point of a lap [2^-8 count].
struct Corrections {
  static constexpr std::uint32_t kPoints = 4096;
  std::array<std::array<std::int16_t, kPoints>, 2> of{};
};

struct PrecisionSetup {
  bool on = false;
  bool identify = true;  // a small move of both axes before the path
  bool adapt = true;     // the estimates go on changing on the path
  bool learn = false;    // corrections, from lap to lap
  std::uint32_t learn_gain = 52429;  // [2^-16]
  std::array<PrecisionAxisSetup, 2> axis;
  Corrections* corrections = nullptr;  // not owned; nothing is learned without
};

}  // namespace trammel::sw
