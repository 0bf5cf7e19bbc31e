// SPDX-License-Identifier: Apache-2.0
#include "models/exact/control/command.hpp"

#include <Vcommand.h>

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "tests/support/rtl.hpp"

using trammel::exact::Command;
using trammel::test::as_signed;

namespace {

template <class Port>
void set(Port& port, std::int64_t value, int bits) {
  port = static_cast<Port>(trammel::test::as_bits(value, bits));
}

struct Bench {
  trammel::test::Rtl<Vcommand> rtl;
  Command twin;
  Command::In in;

  Bench() {
    drive();
    rtl.reset();
  }

  void drive() {
    rtl->tick_pos_i = in.tick_pos;
    rtl->commit_i = in.commit;
    rtl->interpolate_i = in.interpolate;
    rtl->preset_i = in.preset;
    set(rtl->preset_value_i, in.preset_value, 24);
    set(rtl->pos_cmd_i, in.pos_cmd, 24);
  }

  std::int64_t clock() {
    drive();
    rtl.eval();
    REQUIRE(static_cast<bool>(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    twin.clock(in);
    REQUIRE(as_signed(rtl->r_o, 24) == twin.r());
    in.tick_pos = in.commit = in.preset = false;
    return twin.r();
  }

  std::int64_t commit(std::int32_t value) {
    in.commit = true;
    in.pos_cmd = value;
    return clock();
  }

  std::int64_t tick() {
    in.tick_pos = true;
    return clock();
  }
};

}  // namespace

TEST_CASE("A committed command is taken at the next tick, later writes are not") {
  Bench bench;
  REQUIRE(bench.commit(2000) == 0);
  bench.in.pos_cmd = 3000;
  REQUIRE(bench.clock() == 0);
  REQUIRE(bench.tick() == 2000);
  REQUIRE(bench.tick() == 2000);
}

TEST_CASE("A tick in the clock of the commit does not take it") {
  Bench bench;
  bench.in.tick_pos = true;
  REQUIRE(bench.commit(2000) == 0);
  REQUIRE(bench.tick() == 2000);
}

TEST_CASE("Interpolation reaches the command in four equal parts, exactly") {
  Bench bench;
  bench.in.interpolate = true;
  bench.commit(-101);
  std::vector<std::int64_t> r;
  for (int n = 0; n < 6; ++n) r.push_back(bench.tick());
  REQUIRE(r == std::vector<std::int64_t>{-25, -50, -76, -101, -101, -101});
  bench.commit(8388607);
  for (int n = 0; n < 4; ++n) bench.tick();
  REQUIRE(bench.twin.r() == 8388607);
  bench.commit(-8388608);
  for (int n = 0; n < 4; ++n) bench.tick();
  REQUIRE(bench.twin.r() == -8388608);
}

TEST_CASE("Interpolated commands of a constant feed advance equally at every tick") {
  Bench bench;
  bench.in.interpolate = true;
  std::int64_t before = 0;
  for (int point = 1; point <= 5; ++point) {
    bench.commit(40 * point);
    for (int n = 0; n < 4; ++n) {
      const std::int64_t r = bench.tick();
      REQUIRE(r - before == 10);
      before = r;
    }
  }
}

TEST_CASE("A preset moves the command at once and drops the pending one") {
  Bench bench;
  bench.commit(500);
  bench.in.preset = true;
  bench.in.preset_value = 77;
  REQUIRE(bench.clock() == 77);
  REQUIRE(bench.tick() == 77);
}

TEST_CASE("Command agrees with its twin in every clock") {
  Bench bench;
  std::mt19937 random(3);
  for (int n = 0; n < 20000; ++n) {
    bench.in.tick_pos = random() % 3 == 0;
    bench.in.commit = random() % 9 == 0;
    bench.in.preset = random() % 97 == 0;
    if (random() % 50 == 0) bench.in.interpolate = !bench.in.interpolate;
    bench.in.pos_cmd = static_cast<std::int32_t>(random() & 0xffffff) - 0x800000;
    bench.in.preset_value = static_cast<std::int32_t>(random() & 0xffffff) - 0x800000;
    if (random() % 200 == 0) {
      bench.drive();
      bench.rtl.reset();
      bench.twin = Command();
    }
    bench.clock();
  }
}
