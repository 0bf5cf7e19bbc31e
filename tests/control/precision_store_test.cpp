// SPDX-License-Identifier: Apache-2.0

#include "models/exact/control/precision_store.hpp"

#include <Vprecision_store.h>

#include <catch2/catch.hpp>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::PrecisionStore;
using trammel::test::as_signed;
using trammel::test::Random;

namespace {

constexpr std::uint64_t kMask = (std::uint64_t{1} << 48) - 1;

struct Bench {
  trammel::test::Rtl<Vprecision_store> rtl;
  PrecisionStore twin;

  Bench() {
    rtl->hold_i = rtl->read_i = rtl->write_i = rtl->request_i = 0;
    rtl->read_addr_i = rtl->write_addr_i = rtl->request_addr_i = 0;
    rtl->request_we_i = 0;
    rtl->request_data_i = 0;
    rtl->write_data_i = 0;
    rtl.reset();
  }

  static std::uint8_t address(int axis, int word) {
    return static_cast<std::uint8_t>(PrecisionStore::kWords * axis + word);
  }

  void request(int axis, int word, bool we, std::int32_t value = 0) {
    rtl->request_i = 1;
    rtl->request_we_i = we;
    rtl->request_addr_i = address(axis, word);
    rtl->request_data_i = static_cast<std::uint32_t>(value);
    rtl.tick();
    rtl->request_i = 0;
    rtl.eval();
  }

  std::int32_t read(int axis, int word) {
    request(axis, word, false);
    rtl.tick();
    REQUIRE(rtl->ack_o);
    return static_cast<std::int32_t>(rtl->rdata_o);
  }

  void write(int axis, int word, std::int32_t value) {
    request(axis, word, true, value);
    rtl.tick();
    REQUIRE(rtl->ack_o);
    twin.write(axis, word, value);
  }

  void law(int axis, int word, std::int64_t value) {
    rtl->hold_i = rtl->write_i = 1;
    rtl->write_addr_i = address(axis, word);
    rtl->write_data_i = static_cast<std::uint64_t>(value) & kMask;
    rtl.tick();
    rtl->hold_i = rtl->write_i = 0;
    rtl.eval();
    twin.put(axis, word, value);
  }

  std::int64_t law_read(int axis, int word) {
    rtl->hold_i = rtl->read_i = 1;
    rtl->read_addr_i = address(axis, word);
    rtl.tick();
    rtl->hold_i = rtl->read_i = 0;
    rtl.eval();
    return as_signed(rtl->word_o, 48);
  }
};

}  // namespace

TEST_CASE("precision_store agrees with its twin on random accesses of law and bus") {
  Bench bench;
  Random random(1);
  for (int n = 0; n < 20000; ++n) {
    const int axis = static_cast<int>(random() % 2), word = static_cast<int>(random() % 64);
    const auto value =
        as_signed(static_cast<std::uint64_t>(random()) << 32 | random(), 48) >> (random() % 48);
    switch (random() % 4) {
      case 0: bench.law(axis, word, value); break;
      case 1: bench.write(axis, word, static_cast<std::int32_t>(as_signed(random(), 32))); break;
      case 2: REQUIRE(bench.law_read(axis, word) == bench.twin.get(axis, word)); break;
      default: REQUIRE(bench.read(axis, word) == bench.twin.read(axis, word)); break;
    }
  }
  for (int axis = 0; axis < 2; ++axis) {
    for (int word = 0; word < 64; ++word) {
      CAPTURE(axis, word);
      REQUIRE(bench.law_read(axis, word) == bench.twin.get(axis, word));
    }
  }
}

TEST_CASE("The bus writes the 13 words that knots and ticks take, and no other") {
  Bench bench;
  for (int axis = 0; axis < 2; ++axis) {
    for (int word = 0; word < 64; ++word) bench.write(axis, word, -1 - word);
  }
  for (int axis = 0; axis < 2; ++axis) {
    for (int word = 0; word < 64; ++word) {
      CAPTURE(axis, word);
      const bool has = word <= 6 || (word >= 8 && word <= 13);
      REQUIRE(PrecisionStore::writable(word) == has);
      REQUIRE(bench.read(axis, word) == (has ? -1 - word : 0));
      REQUIRE(bench.law_read(axis, word) == (has ? -1 - word : 0));
    }
  }
}

TEST_CASE("A request waits while the law runs and is acknowledged once") {
  Bench bench;
  bench.write(0, 0, 5);
  REQUIRE(bench.read(0, 0) == 5);
  bench.write(1, 2, 77);
  bench.rtl->hold_i = 1;
  bench.request(1, 2, false);
  for (int n = 0; n < 300; ++n) {
    REQUIRE_FALSE(bench.rtl->ack_o);
    REQUIRE_FALSE(bench.rtl->quiescent_o);
    bench.rtl.tick();
  }
  bench.rtl->hold_i = 0;
  bench.rtl.tick();
  REQUIRE(bench.rtl->ack_o);
  REQUIRE(bench.rtl->rdata_o == 77);
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.rtl.tick();
  REQUIRE_FALSE(bench.rtl->ack_o);
  REQUIRE(bench.rtl->quiescent_o);
  REQUIRE(bench.rtl->rdata_o == 77);
  bench.law(1, 2, 99);  // what was read stays, whoever writes
  bench.rtl.tick();
  REQUIRE(bench.rtl->rdata_o == 77);
  bench.write(0, 0, 6);
  REQUIRE(bench.rtl->rdata_o == 77);
}

TEST_CASE("precision_store is quiescent only while nothing is asked, read or written") {
  Bench bench;
  REQUIRE(bench.rtl->quiescent_o);
  bench.rtl->request_i = 1;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.rtl->request_i = 0;
  bench.rtl->read_i = 1;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.rtl->read_i = 0;
  bench.rtl->write_i = 1;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
}
