// SPDX-License-Identifier: Apache-2.0

#include <Vqep.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "models/exact/sense/qep.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Qep;
using trammel::test::as_bits;
using trammel::test::as_signed;
using trammel::test::Random;
using Rtl = trammel::test::Rtl<Vqep>;

namespace {

void apply(Rtl& rtl, const Qep::In& in) {
  rtl->enc_a_i = in.a;
  rtl->enc_b_i = in.b;
  rtl->enc_z_i = in.z;
  rtl->filter_i = in.filter;
  rtl->preset_i = in.preset;
  rtl->preset_value_i = as_bits(in.preset_value, 24);
  rtl->clear_error_i = in.clear_error;
  rtl.eval();
}

void run(Rtl& rtl, const Qep::In& in, int clocks) {
  apply(rtl, in);
  for (int i = 0; i < clocks; ++i) rtl.tick();
}

// A leads B when the position counts up.
Qep::In at(std::int64_t position, int filter = 3) {
  const auto phase = static_cast<int>(position & 3);
  Qep::In in;
  in.a = phase == 1 || phase == 2;
  in.b = phase == 2 || phase == 3;
  in.filter = static_cast<std::uint8_t>(filter);
  return in;
}

std::int64_t count(Rtl& rtl) { return as_signed(rtl->count_o, 24); }

void start(Rtl& rtl, const Qep::In& in) {
  apply(rtl, in);
  rtl.reset();
  run(rtl, in, 30);
}

}  // namespace

TEST_CASE("qep agrees with its twin on random lines, filters, presets, clears and resets") {
  Rtl rtl;
  Qep twin;
  apply(rtl, Qep::In());
  rtl.reset();
  twin.reset();
  Random random(5);
  Qep::In in;
  for (int i = 0; i < 200000; ++i) {
    const unsigned calm = i % 20000 < 10000 ? 3 : 30;
    if (random() % calm == 0) in.a = !in.a;
    if (random() % calm == 0) in.b = !in.b;
    if (random() % (4 * calm) == 0) in.z = !in.z;
    if (random() % 500 == 0) in.filter = static_cast<std::uint8_t>(random() % 16);
    in.preset = random() % 300 == 0;
    const std::uint32_t end = random() % 2 == 0 ? 0x7FFFFE : 0x800001;  // near the wrap
    in.preset_value = static_cast<std::int32_t>(as_signed(end, 24));
    in.clear_error = random() % 100 == 0;
    apply(rtl, in);
    if (random() % 2000 == 0) {
      rtl.reset();  // two clocks; the synchronisers go on
      twin.step(in);
      twin.step(in);
      twin.reset();
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    const Qep::Out out = twin.step(in);
    REQUIRE(count(rtl) == out.count);
    REQUIRE(bool(rtl->dir_o) == out.dir);
    REQUIRE(as_signed(rtl->index_latch_o, 24) == out.index_latch);
    REQUIRE(bool(rtl->index_seen_o) == out.index_seen);
    REQUIRE(bool(rtl->error_o) == out.error);
  }
}

TEST_CASE("qep loses no count at 4 and 5 m/s, up and down") {
  for (const int clocks : {62, 50}) {
    Rtl rtl;
    start(rtl, at(0));
    std::int64_t position = 0;
    for (int i = 0; i < 3000; ++i) run(rtl, at(++position), clocks);
    run(rtl, at(position), 6);
    REQUIRE(count(rtl) == 3000);
    REQUIRE(rtl->dir_o);
    for (int i = 0; i < 5000; ++i) run(rtl, at(--position), clocks);
    run(rtl, at(position), 6);
    REQUIRE(count(rtl) == -2000);
    REQUIRE_FALSE(rtl->dir_o);
    REQUIRE_FALSE(rtl->error_o);
  }
}

TEST_CASE("qep counts a reversal at any position without loss") {
  Rtl rtl;
  start(rtl, at(0));
  Random random(6);
  std::int64_t position = 0;
  for (int i = 0; i < 2000; ++i) {
    position += random() % 2 == 0 ? 1 : -1;
    run(rtl, at(position), 6);
    REQUIRE(count(rtl) == position);
  }
  REQUIRE_FALSE(rtl->error_o);
}

TEST_CASE("qep counts 2 + filter + 1 edges after the pin") {
  for (int filter = 0; filter < 16; ++filter) {
    Rtl rtl;
    start(rtl, at(0, filter));
    const int latency = 2 + (filter == 0 ? 1 : filter) + 1;
    run(rtl, at(1, filter), latency - 1);
    REQUIRE(count(rtl) == 0);
    run(rtl, at(1, filter), 1);
    REQUIRE(count(rtl) == 1);
  }
}

TEST_CASE("qep ignores a pulse shorter than the filter and passes one as long as it") {
  for (int filter = 1; filter < 16; ++filter) {
    for (int width = 1; width <= filter; ++width) {
      Rtl rtl;
      start(rtl, at(0, filter));
      bool moved = false;
      apply(rtl, at(1, filter));
      for (int i = 0; i < 60; ++i) {
        if (i == width) apply(rtl, at(0, filter));
        rtl.tick();
        moved = moved || count(rtl) != 0;
      }
      REQUIRE(moved == (width == filter));
      REQUIRE(count(rtl) == 0);
      REQUIRE_FALSE(rtl->error_o);
    }
  }
}

TEST_CASE("qep reports a double transition, counts nothing, and keeps the error until cleared") {
  Rtl rtl;
  start(rtl, at(0));
  run(rtl, at(2), 10);
  REQUIRE(rtl->error_o);
  REQUIRE(count(rtl) == 0);
  run(rtl, at(3), 10);
  REQUIRE(rtl->error_o);
  REQUIRE(count(rtl) == 1);
  Qep::In clear = at(3);
  clear.clear_error = true;
  run(rtl, clear, 1);
  REQUIRE_FALSE(rtl->error_o);
}

TEST_CASE("qep latches the count at the rising index, the step of that clock included") {
  Rtl rtl;
  start(rtl, at(0));
  for (int i = 1; i <= 41; ++i) run(rtl, at(i), 20);
  REQUIRE_FALSE(rtl->index_seen_o);
  Qep::In in = at(42);
  in.z = true;
  run(rtl, in, 20);
  REQUIRE(rtl->index_seen_o);
  REQUIRE(rtl->index_latch_o == 42);
  for (int i = 43; i < 50; ++i) run(rtl, at(i), 20);
  REQUIRE(rtl->index_latch_o == 42);
  in = at(49);
  in.clear_error = true;
  run(rtl, in, 1);
  REQUIRE_FALSE(rtl->index_seen_o);
}

TEST_CASE("qep starts without count or error whatever level the lines have") {
  for (int position = 0; position < 4; ++position) {
    Rtl rtl;
    Qep::In high_index = at(position);
    high_index.z = true;
    start(rtl, high_index);
    REQUIRE_FALSE(rtl->index_seen_o);
    start(rtl, at(position));
    REQUIRE(count(rtl) == 0);
    REQUIRE_FALSE(rtl->error_o);
    REQUIRE(rtl->quiescent_o);
    run(rtl, at(position + 1), 10);
    REQUIRE(count(rtl) == 1);
  }
}

TEST_CASE("qep is quiescent only when the next edge changes nothing") {
  Rtl rtl;
  start(rtl, at(0));
  apply(rtl, at(1));
  REQUIRE_FALSE(rtl->quiescent_o);
  int busy = 0;
  while (!rtl->quiescent_o) {
    rtl.tick();
    ++busy;
  }
  REQUIRE(busy == 6);
  REQUIRE(count(rtl) == 1);
}

TEST_CASE("qep loads a preset") {
  Rtl rtl;
  start(rtl, at(0));
  Qep::In in = at(0);
  in.preset = true;
  in.preset_value = -12345;
  run(rtl, in, 1);
  REQUIRE(count(rtl) == -12345);
  run(rtl, at(1), 10);
  REQUIRE(count(rtl) == -12344);
}

TEST_CASE("qep's twin skips edges that only count equal samples") {
  Qep plain, skipping;
  Random random(6);
  Qep::In in;
  for (int change = 0; change < 3000; ++change) {
    const auto bits = random();
    in.a = (bits & 1u) != 0;
    in.b = (bits & 2u) != 0;
    in.z = (bits & 4u) != 0;
    in.filter = static_cast<std::uint8_t>((bits >> 8) % 16);
    int left = static_cast<int>((bits >> 16) % 30) + 1;
    for (int n = 0; n < left; ++n) plain.step(in);
    while (left > 0) {
      const int gap = std::min(static_cast<int>(skipping.next(in)), left);
      skipping.advance(static_cast<trammel::exact::Gap>(gap));
      left -= gap;
      if (left-- > 0) skipping.step(in);
    }
    CAPTURE(change);
    REQUIRE(plain.out().count == skipping.out().count);
    REQUIRE(plain.out().error == skipping.out().error);
    REQUIRE(plain.out().index_latch == skipping.out().index_latch);
    REQUIRE(plain.quiescent(in) == skipping.quiescent(in));
  }
}
