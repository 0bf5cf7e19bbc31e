// SPDX-License-Identifier: Apache-2.0
//
// Random transfers of mcafee_xy, of a program that moves both axes and of none.
#pragma once

#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "sw_nios/hal/lm628.hpp"
#include "tests/support/paced_master.hpp"
#include "tests/support/random.hpp"
#include "tests/support/traffic.hpp"

namespace trammel::test {

namespace reg = mcafee_xy_regs;

// Transfers as they should be, of the kind that makes moves, interrupts and readings.
inline void ordered(sw::Lm628Port& part, Random& random) {
  const auto some = static_cast<std::int32_t>(random() % 2000);
  switch (random() % 7) {
    case 0:
      part.command(sw::Lm628Command::kLtrj, 0x2A | random() % 2);
      part.long_word(some * 40);
      part.long_word(some * 400);
      part.long_word(some % 200 - 100);
      break;
    case 1:
      part.command(sw::Lm628Command::kLfil, 0x0F | random() % 4 << 8);
      for (int n = 0; n < 4; ++n) part.word(static_cast<std::uint32_t>(some / (n + 1)));
      part.command(sw::Lm628Command::kUdf);
      break;
    case 2:
      part.command(random() % 2 == 0 ? sw::Lm628Command::kMski : sw::Lm628Command::kRsti,
                   random() % 128);
      break;
    case 3:
      part.ask_long(random() % 2 == 0 ? sw::Lm628Command::kRddp : sw::Lm628Command::kRdrp);
      break;
    case 4:
      part.command(sw::Lm628Command::kRdsigs);
      part.read_word();
      break;
    default:
      part.command(sw::Lm628Command::kStt);
  }
}

// Any access of any register: bytes of it, and channels of the bus that come late.
template <class Bench>
void access(Bench& bench, Random& random) {
  const std::uint32_t address = random() % 16 * 4;
  AxiPace pace = AxiPace::random(random, random() % 4 != 0);
  // FEED_IN starts by its c: a cc that comes alone is taken or not, as the time is.
  if (address == reg::kFeedIn && (pace.strobes & 2) != 0) pace.strobes |= 1;
  if (random() % 3 == 0) {
    bench.transfer({address, 0, false}, pace);
  } else if (address != reg::kReset || random() % 64 == 0) {
    const std::uint32_t data = random() % 2 == 0 ? random() : random() % 32;
    bench.transfer({address, data, true}, pace);
  }
}

// At any time.
template <class Bench>
void wild(Bench& bench, Random& random) {
  access(bench, random);
  if (random() % 2 == 0) bench.clocks(random() % 600);
}

// The reset of the chip, in the middle of a transfer and of what the parts do.
template <class Bench>
void cut(Bench& bench, Random& random) {
  for (unsigned times = 1 + random() % 12; times > 0; --times) {
    bench.chip.request({random() % 10 * 4, random(), random() % 2 == 0},
                       AxiPace::random(random, true));
    bench.clocks(1 + random() % 8);
    bench.chip.reset();
    for (unsigned k = random() % 4; k > 0; --k) access(bench, random);
  }
  bench.clocks(random() % 2 == 0 ? 66800 : random() % 2000);
}

template <class Bench>
void run_random(Bench& bench, const Traffic& traffic) {
  Random random(traffic.seed);
  bench.start();
  for (std::int64_t n = 0; n < traffic.transfers; ++n) {
    INFO("transfer " << n << "; " << traffic.until(n));
    if (random() % 8 == 0) {
      for (unsigned k = random() % 8; k > 0; --k) wild(bench, random);
      for (unsigned k = random() % 100; k > 0; --k) access(bench, random);
      bench.write(reg::kPortB, 0);
      bench.clocks(600);
    } else {
      ordered(random() % 2 == 0 ? bench.x : bench.y, random);
    }
    if (random() % 4 == 0) bench.clocks(random() % 20000);
    if (random() % 8 == 0) bench.chip.in.limit_i = random() & 15;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::int64_t desired = bench.part(axis).engine().desired().position >> 16;
      if (std::abs(desired) < 3000) bench.move_to(axis, desired / 2);
      set_bit(bench.chip.in.enc_idx_n_i, axis, random() % 4 != 0);
    }
    if (random() % 30 == 0) cut(bench, random);
  }
}

}  // namespace trammel::test
