// SPDX-License-Identifier: Apache-2.0
//
// Random transfers at the host port of an LM628 that follows its moves more or less.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/support/lm628_commands.hpp"
#include "tests/support/random.hpp"
#include "tests/support/traffic.hpp"

namespace trammel::test {

// A transfer as it should be, of the kind that makes moves, stops and interrupts.
template <class Bench>
void ordered(Bench& bench, Random& random) {
  static constexpr std::array<Opcode, 9> kPlain{Opcode::kStt,   Opcode::kDfh,    Opcode::kSip,
                                                Opcode::kUdf,   Opcode::kPort8,  Opcode::kPort12,
                                                Opcode::kRdsum, Opcode::kRdsigs, Opcode::kRdrv};
  static constexpr std::array<Opcode, 4> kLong{Opcode::kRddv, Opcode::kRddp, Opcode::kRdip,
                                               Opcode::kRdrp};
  const unsigned some = random() % 2000;
  switch (random() % 10) {
    case 0:
    case 1: {
      const unsigned control = random() % 8 == 0 ? 0x100u << random() % 3 : random() % 2 << 11;
      const std::int64_t way = static_cast<std::int64_t>(random() % 200) - 100;
      const unsigned bits = control | random() % 2 << 12;
      if (random() % 3 == 0) {  // added to what is there
        bench.trajectory(bits | 0x1C, {static_cast<std::int64_t>(random() % 20000) - 10000});
      } else if (random() % 4 == 0) {
        bench.trajectory(bits | 0x02 | random() % 2, {way});
      } else {
        bench.trajectory(bits | 0x2A | random() % 2, {random() % 90000, random() % 900000, way});
      }
      break;
    }
    case 2:
      bench.command(Opcode::kLfil, {0x000Fu | random() % 4 << 8, some, some / 50, some, some});
      break;
    case 3:
      bench.command(random() % 2 == 0 ? Opcode::kMski : Opcode::kRsti, {random() % 128});
      break;
    case 4:
      bench.command(random() % 3 == 0 ? Opcode::kLpes : Opcode::kLpei, {100 + some});
      break;
    case 5:
      bench.command(random() % 2 == 0 ? Opcode::kSbpr : Opcode::kSbpa, {0, random() % 100});
      break;
    case 6:
      bench.ask(kLong[random() % kLong.size()]);
      break;
    case 7:
      bench.command(Opcode::kStt);
      break;
    default: {
      const Opcode op = kPlain[random() % kPlain.size()];
      bench.command(op);
      if (exact::words_replied(Bench::code(op)) != 0) bench.read_word();
    }
  }
}

// Any access at any time.
template <class Bench>
void wild(Bench& bench, Random& random) {
  switch (random() % 4) {
    case 0:
      bench.write(false, static_cast<std::uint8_t>(1 + random() % 0x23));
      break;
    case 1:
      bench.read(true);
      break;
    case 2:
      bench.status();
      break;
    default:
      bench.write(true, static_cast<std::uint8_t>(random() % 4));
  }
  bench.clocks(random() % 2 == 0 ? 1100 : random() % 1100);
}

// A strobe of any length, and RST in the middle of it, shorter than the data sheet's or not.
template <class Bench>
void cut(Bench& bench, Random& random) {
  auto& host = bench.chip.in.host;
  host.ps = random() % 2 == 0;
  host.d = static_cast<std::uint8_t>(random());
  host.cs_n = random() % 4 == 0;
  (random() % 2 == 0 ? host.wr_n : host.rd_n) = false;
  bench.clocks(1 + random() % 8);
  bench.hardware_reset(1 + static_cast<int>(random() % 70));
  host = {};
  bench.clocks(6);
  if (random() % 2 == 0) bench.clocks(50'010);  // else it is spoken to in its reset routine
}

template <class Bench>
void run_random(Bench& bench, const Traffic& traffic) {
  Random random(traffic.seed);
  bench.start();
  for (std::int64_t n = 0; n < traffic.transfers; ++n) {
    INFO("transfer " << n << "; " << traffic.until(n));
    if (n > 0 && n % 500 == 0) {  // not while a sample is computed
      bench.sample();
      bench.chip.in.wrap = !bench.chip.in.wrap;
    }
    if (random() % 10 == 0) {
      wild(bench, random);
    } else {
      bench.ready();
      ordered(bench, random);
    }
    if (random() % 4 == 0) bench.clocks(random() % 20000);
    const std::int64_t error = bench.engine().desired().position / 65536 - bench.position();
    bench.set_index(bench.position() / 64 * 64);
    if (std::abs(error) < 3000) bench.move_to(bench.position() + error / 4);
    if (random() % 500 == 0) {
      if (random() % 2 == 0) {
        bench.start();
      } else {
        bench.command(Opcode::kReset);  // in the middle of whatever it does
      }
    }
    if (random() % 250 == 0) cut(bench, random);
  }
}

}  // namespace trammel::test
