// SPDX-License-Identifier: Apache-2.0
//
// Random traffic on every pin of the chip beside its twin, with the assertions of all blocks
// checked at each evaluated clock; after every second reset the clocks of resting domains are
// gated. For more of it, or other: TRAMMEL_TEST_TRANSFERS, TRAMMEL_TEST_SEED.
#include <Vkung_xy.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>

#include "tests/chips/kung_pair.hpp"
#include "tests/support/kung_transfers.hpp"
#include "tests/support/traffic.hpp"

using namespace trammel;
namespace reg = trammel::kung_xy_regs;
using test::AxiPace;
using test::Random;
using Pair = test::KungPair<Vkung_xy>;

namespace {

constexpr std::int64_t kCarrier = 3125;  // [clk] of 16 kHz

void reset(Pair& pair) {
  pair.rest();
  for (int n = 0; n < 6; ++n) pair.rtl().tick();  // the synchronisers have no reset
  pair.rtl().reset();
  pair.begin();
  pair.clocks(200);  // encoder lines adopted, rule tables filled
}

// A transfer that a program makes, or any.
cosim::BusOp any_transfer(Random& random) {
  if (random() % 8 != 0) return test::random_transfer(random);
  const std::uint32_t address = random() % 0x400 & ~3u;
  // Of what is written at random little keeps the drives running.
  if (random() % 4 != 0) return {address, 0, false};
  return {address, random() % 2 == 0 ? random() : 0, true};
}

void turn_lines(Pair& pair, Random& random) {
  const int axis = static_cast<int>(random() % 2);
  switch (random() % 64) {
    case 0:  // both lines at once
      pair.lines ^= std::uint64_t{3} << 3 * axis;
      break;
    case 1:
      pair.lines ^= std::uint64_t{1} << xy::kTripPin;
      pair.clocks(1 + random() % 8);
      pair.lines ^= std::uint64_t{1} << xy::kTripPin;
      break;
    case 2:
    case 3:
      pair.lines ^= std::uint64_t{4} << 3 * axis;
      break;
    case 4:  // shorter than the filter, or not
      pair.lines ^= std::uint64_t{1} << 3 * axis;
      pair.clocks(1 + random() % 4);
      pair.lines ^= std::uint64_t{1} << 3 * axis;
      break;
    default:
      pair.count(axis, random() % 2 == 0 ? 1 : -1);
  }
}

}  // namespace

TEST_CASE("kung_xy keeps its promises and is as its twin under random traffic") {
  const test::Traffic traffic = test::traffic(6000, 121);
  Random random(traffic.seed);
  Pair pair;
  pair.rtl().reset();  // of what it starts with
  reset(pair);
  int resets = 0;
  for (std::int64_t n = 0; n < traffic.transfers; ++n) {
    const cosim::BusOp op = any_transfer(random);
    const AxiPace pace = AxiPace::random(random, random() % 4 != 0 || !op.write);
    INFO("transfer " << n << ": " << test::register_name(reg::kRegisters, op.addr)
                     << (op.write ? " written, " + test::number(op.data, 8) : " read")
                     << ", strobes " << pace.strobes << "; " << traffic.until(n));
    if (random() % 500 == 0) {
      pair.cut(op, pace, static_cast<int>(random() % 6));
      pair.gated = false;
      reset(pair);
      pair.gated = resets % 2 == 0;
      ++resets;
      continue;
    }
    if (op.write) {
      pair.transfer(op, pace);
    } else {
      pair.read(op.addr, pace);
    }
    if (n % 25 == 0) {
      for (const cosim::BusOp& one : test::recovery(random)) pair.transfer(one);
    }
    if (random() % 2 == 0) turn_lines(pair, random);
    if (random() % 20 == 0) {  // no conversion runs then
      pair.clocks((kCarrier + 1000 - pair.now() % kCarrier) % kCarrier);
      const bool large = random() % 4 == 0;
      for (auto& axis : pair.codes) {
        for (auto& code : axis) {
          code = 2048 + static_cast<std::int32_t>(random() % (large ? 4001 : 401)) -
                 (large ? 2000 : 200);
        }
      }
    }
    const bool pause = random() % 32 == 0;
    pair.clocks(random() % (pause ? 40000 : 60));
  }
  if (!test::own_traffic()) return;
  CHECK(resets > 5);
  CHECK(pair.gates_on() > 10000);
}
