// SPDX-License-Identifier: Apache-2.0
#include <Vfeed_rate.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "models/exact/control/feed_rate.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::FeedRate;

namespace {

constexpr int kLatency = 25;

int run(test::Rtl<Vfeed_rate>& rtl, int c, int cc) {
  rtl->c_i = static_cast<std::uint8_t>(c);
  rtl->cc_i = static_cast<std::uint8_t>(cc);
  REQUIRE(test::run_flow(rtl) == kLatency);
  return rtl->v_o;
}

// CRC-32 of Ethernet and zlib.
std::uint32_t crc32(const std::vector<std::uint8_t>& bytes) {
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

// The same rules in real numbers: memberships without clipping of halves, nothing truncated.
double ideal(double c, double cc) {
  struct {
    double s, m, l;
  } a{}, b{};
  const auto set = [](auto& mu, double x) {
    const double rise = std::min(1.0, 2 * (x <= 128 ? x : x - 128) / 255);
    if (x <= 128) {
      mu = {1 - rise, rise, 0};
    } else {
      mu = {0, 1 - rise, rise};
    }
  };
  set(a, c);
  set(b, cc);
  const double small = std::max({a.l, std::min(b.l, a.m), std::min(b.l, a.s)});
  const double middle = std::max({std::min(b.s, a.m), std::min(b.m, a.m), std::min(b.m, a.s)});
  const double large = std::min(b.s, a.s);
  return (128 * middle + 255 * large) / (small + middle + large);
}

}  // namespace

TEST_CASE("F-01 F-02 feed_rate gives the speeds of the listing") {
  struct Row {
    int c, cc, v;
  };
  const Row rows[] = {{0x00, 0x00, 254}, {0x80, 0x00, 127}, {0x00, 0x80, 127}, {0x80, 0x80, 127},
                      {0xff, 0x00, 0},   {0x40, 0x00, 190}, {0x40, 0x40, 190}, {0x20, 0x10, 222},
                      {0x60, 0xa0, 95},  {0xc0, 0x20, 63},  {0x81, 0x81, 126}, {220, 64, 35},
                      {64, 220, 45},     {62, 225, 40},     {225, 62, 30}};
  test::Rtl<Vfeed_rate> rtl;
  test::begin(rtl);
  for (const Row& row : rows) {
    CAPTURE(row.c, row.cc);
    CHECK(FeedRate().step({row.c, row.cc}).v == row.v);
    CHECK(run(rtl, row.c, row.cc) == row.v);
  }
}

TEST_CASE("F-03 feed_rate, its twin and the emulated listing agree at all 65536 inputs") {
  test::Rtl<Vfeed_rate> rtl;
  test::begin(rtl);
  std::vector<std::uint8_t> surface;
  for (int c = 0; c < 256; ++c) {
    for (int cc = 0; cc < 256; ++cc) {
      const std::int32_t v = FeedRate().step({c, cc}).v;
      CAPTURE(c, cc);
      REQUIRE(run(rtl, c, cc) == v);
      surface.push_back(static_cast<std::uint8_t>(v));
    }
  }
  // Of an emulation of the listing's machine code, byte 256 c + cc.
  CHECK(crc32(surface) == 0xacba616fu);
  CHECK(std::accumulate(surface.begin(), surface.end(), 0) == 5564268);
}

TEST_CASE("feed_rate is at most 4 units below the same rules in real numbers") {
  // Two products are cut by less than 1 each, of which the quotient makes 256 / SU, SU >= 128, and
  // it is cut itself. Hence less than 5; the worst is 3.74, at c = 125, cc = 63.
  for (int c = 0; c < 256; ++c) {
    for (int cc = 0; cc < 256; ++cc) {
      CAPTURE(c, cc);
      const double lost = ideal(c, cc) - FeedRate().step({c, cc}).v;
      REQUIRE(lost < 4);
      REQUIRE(lost > -1e-9);
    }
  }
}

TEST_CASE("feed_rate has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vfeed_rate> rtl;
  test::Words words(1);
  const auto drive = [&] {
    rtl->c_i = static_cast<std::uint8_t>(words.below(256));
    rtl->cc_i = static_cast<std::uint8_t>(words.below(256));
  };
  test::require_flow_shape(rtl, kLatency, {0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->v_o};
  });
}
