// SPDX-License-Identifier: Apache-2.0
#include <Vcalibration.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/sense/calibration.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Calibration;
using trammel::exact::CalibrationStore;
using trammel::exact::crc16;
using trammel::exact::sealed;
using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vcalibration> rtl;
  CalibrationStore twin;
  CalibrationStore::In in;
  std::array<std::uint16_t, 64> store{};
  unsigned addr = 0;
  int stored = 0, refused = 0;

  Bench() {
    put();
    rtl.reset();
  }
  void put() {
    in.nv_data = store[twin.out().nv_addr];
    rtl->write_i = in.write;
    rtl->command_i = static_cast<std::uint8_t>(in.command);
    rtl->word_i = in.word;
    rtl->reads_i = in.reads;
    rtl->addr_i = static_cast<std::uint8_t>(addr);
    rtl->nv_ready_i = in.nv_ready;
    rtl->nv_data_i = in.nv_data;
    rtl.eval();
  }
  void tick() {
    put();
    const CalibrationStore::Out out = twin.out();
    REQUIRE(bool(rtl->nv_valid_o) == out.nv_valid);
    REQUIRE(bool(rtl->nv_write_o) == out.nv_write);
    REQUIRE(rtl->nv_addr_o == out.nv_addr);
    REQUIRE(rtl->nv_data_o == out.nv_data);
    REQUIRE(bool(rtl->valid_o) == twin.valid());
    REQUIRE(bool(rtl->busy_o) == twin.busy());
    REQUIRE(rtl->count_o == twin.count());
    REQUIRE(bool(rtl->stored_o) == twin.stored(in));
    REQUIRE(bool(rtl->refused_o) == twin.refused());
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (twin.valid() && addr < 63 && (in.reads || !twin.busy())) {
      REQUIRE(rtl->data_o == twin.data().words[addr]);
    }
    stored += twin.stored(in);
    refused += twin.refused();
    if (out.nv_valid && out.nv_write && in.nv_ready) store[out.nv_addr] = out.nv_data;
    twin.step(in);
    rtl.tick();
  }
  void ticks(int n) {
    while (n-- > 0) tick();
  }
  void command(std::uint32_t code, std::uint16_t word = 0) {
    in.write = true;
    in.command = code;
    in.word = word;
    tick();
    in.write = false;
    in.command = 0;
    ticks(2);
  }
  void load(const Calibration& calib, std::size_t words = 63) {
    command(1);
    for (std::size_t k = 0; k < words; ++k) command(2, calib.words[k]);
  }
  void reset() {
    rtl.reset();
    twin.reset();
  }
};

Calibration pattern(std::uint32_t seed) {
  Random random(seed);
  Calibration c;
  for (auto& word : c.words) word = static_cast<std::uint16_t>(random());
  return sealed(c);
}

bool holds(const Bench& bench, const Calibration& c) {
  return std::equal(c.words.begin(), c.words.end(), bench.store.begin()) &&
         bench.twin.data().words == c.words;
}

}  // namespace

TEST_CASE("calibration's checksum is CRC-16/CCITT-FALSE: 29B1 of the digits 1 to 9") {
  std::uint16_t check = 0xFFFF;
  for (const char digit : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    check = crc16(check, static_cast<std::uint8_t>(digit));
  }
  CHECK(check == 0x29B1);
}

TEST_CASE("calibration reads the memory after reset, 65 clocks where it is ready") {
  Bench bench;
  const Calibration c = pattern(1);
  std::copy(c.words.begin(), c.words.end(), bench.store.begin());
  int clocks = 0;
  for (; bench.twin.busy(); ++clocks) bench.tick();
  CHECK(clocks == 65);
  CHECK(bench.rtl->valid_o == 1);
  CHECK(holds(bench, c));
  for (bench.addr = 0; bench.addr < 63; ++bench.addr) bench.tick();
  CHECK(bench.refused + bench.stored == 0);
  bench.store[20] = static_cast<std::uint16_t>(bench.store[20] ^ 0x0400);
  bench.reset();
  bench.ticks(100);
  CHECK(bench.rtl->valid_o == 0);
  CHECK(bench.refused == 1);
}

TEST_CASE("calibration takes and stores data with the right checksum, and refuses any other") {
  Bench bench;
  const Calibration first = pattern(2), second = pattern(3);
  bench.ticks(100);
  REQUIRE(bench.refused == 1);  // an empty memory
  bench.load(first);
  CHECK(bench.rtl->valid_o == 0);  // not before it was checked
  bench.command(7);
  bench.ticks(200);
  CHECK(bench.stored == 1);
  CHECK(holds(bench, first));
  // One wrong bit anywhere, checksum included; a word too few; the words without a start.
  for (std::size_t k = 0; k < 63; ++k) {
    Calibration wrong = second;
    wrong.words[k] = static_cast<std::uint16_t>(wrong.words[k] ^ 1u << k % 16);
    bench.load(wrong);
    bench.command(7);
    bench.ticks(5);
  }
  bench.load(second, 62);
  bench.command(7);
  bench.ticks(5);
  CHECK(bench.refused == 65);
  std::uint16_t check = 0xFFFF;  // fewer words, and their own checksum behind them
  bench.command(1);
  for (std::size_t k = 0; k < 40; ++k) {
    bench.command(2, second.words[k]);
    for (const int shift : {0, 8}) {
      check = crc16(check, static_cast<std::uint8_t>(second.words[k] >> shift));
    }
  }
  bench.command(2, check);
  bench.command(7);
  bench.ticks(5);
  CHECK(bench.refused == 66);
  CHECK(holds(bench, first));
  bench.load(second);
  bench.command(2, 0x1234);  // one too many does nothing
  CHECK(holds(bench, first));
  bench.command(7);
  bench.ticks(200);
  CHECK(bench.stored == 2);
  CHECK(holds(bench, second));
  bench.command(7);  // nothing new
  bench.ticks(5);
  CHECK(bench.refused == 67);
  CHECK(holds(bench, second));
}

TEST_CASE("calibration needs no start where data were taken: it begins anew by itself") {
  Bench bench;
  const Calibration first = pattern(7), second = pattern(8), third = pattern(9);
  std::copy(first.words.begin(), first.words.end(), bench.store.begin());
  bench.ticks(100);
  REQUIRE(holds(bench, first));
  for (const Calibration& next : {second, third}) {
    for (const std::uint16_t word : next.words) bench.command(2, word);
    bench.command(7);
    bench.ticks(200);
    CHECK(holds(bench, next));
  }
  CHECK(bench.stored == 2);
  CHECK(bench.refused == 0);
}

TEST_CASE("calibration waits for a slow memory, and for its reader") {
  Bench bench;
  const Calibration c = pattern(4);
  bench.in.nv_ready = false;
  bench.ticks(50);
  CHECK(bench.rtl->count_o == 0);
  bench.in.nv_ready = true;
  bench.ticks(100);
  bench.load(c);
  bench.in.reads = true;
  bench.command(7);
  bench.ticks(50);
  CHECK(bench.rtl->valid_o == 0);
  bench.in.reads = false;
  bench.tick();
  bench.tick();
  CHECK(bench.rtl->valid_o == 1);
  Random random(5);
  while (bench.twin.busy()) {
    bench.in.reads = random() % 2 != 0;
    bench.in.nv_ready = random() % 3 == 0;
    bench.addr = random() % 63;
    bench.tick();
  }
  CHECK(holds(bench, c));
}

TEST_CASE("calibration agrees with its twin for any input") {
  Bench bench;
  Random random(6);
  for (int round = 0; round < 60; ++round) {
    const Calibration c = pattern(random());
    if (random() % 2 == 0) bench.load(c, random() % 8 == 0 ? random() % 63 : 63);
    for (int k = 0; k < 400; ++k) {
      bench.in.write = random() % 8 == 0;
      bench.in.command = random() % 4 == 0 ? 7 : random() % 8;
      bench.in.word = random() % 16 == 0 ? c.words[62] : static_cast<std::uint16_t>(random());
      bench.in.reads = random() % 4 == 0;
      bench.in.nv_ready = random() % 4 != 0;
      bench.addr = random() % 63;
      bench.tick();
    }
    bench.in.write = false;
    if (random() % 4 == 0) bench.reset();
  }
}
