// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <zlib.h>

#include <random>

#include "lab/delta_code.hpp"

using namespace trammel::lab;

namespace {

void check_round_trip(const std::vector<std::int64_t>& values) {
  const Coded coded = delta_code(values);
  CHECK(delta_decode(coded.bytes, coded.order, values.size()) == values);
}

}  // namespace

TEST_CASE("a series comes back as it was") {
  check_round_trip({});
  check_round_trip({0});
  check_round_trip({1, -1, 63, -64, 64, -65, 8191, -8192, 8192, 8192, 8192});
}

TEST_CASE("the largest values come back, in every order of signs") {
  const std::int64_t top = kMaxCoded;
  check_round_trip({top, -top, top, top, -top, -top, 0, top, 0, -top, 1});
  CHECK_THROWS_AS(delta_code({0, top + 1}), std::range_error);
  CHECK_THROWS_AS(delta_code({-top - 1}), std::range_error);
  CHECK_THROWS_AS(delta_code({INT64_MIN}), std::range_error);
  CHECK_THROWS_AS(delta_code({INT64_MAX}), std::range_error);
}

TEST_CASE("random series of every size of step come back") {
  std::mt19937 random(1);  // its seed; the same series in every run
  for (int bits = 1; bits <= 50; ++bits) {
    std::uniform_int_distribution<std::int64_t> any(-(std::int64_t{1} << bits),
                                                    std::int64_t{1} << bits);
    std::vector<std::int64_t> values(200);
    for (auto& value : values) value = any(random);
    CAPTURE(bits);
    check_round_trip(values);
  }
}

TEST_CASE("an even ramp needs one byte a value, in the second order") {
  std::vector<std::int64_t> ramp;
  for (int k = 0; k < 1000; ++k) ramp.push_back(5'000'000 + 50'000 * k);
  const Coded coded = delta_code(ramp);
  CHECK(coded.order == 2);
  CHECK(coded.bytes.size() < 1010);
}

TEST_CASE("a series that is cut off is refused") {
  const Coded coded = delta_code({1000, 2000, 4000});
  CHECK_THROWS_AS(delta_decode(coded.bytes.substr(0, coded.bytes.size() - 1), coded.order, 3),
                  std::range_error);
}

TEST_CASE("deflated bytes are a zlib stream, and base64 is that of RFC 4648") {
  const std::string text(100'000, 'x');
  const std::string small = deflate(text);
  CHECK(small.size() < 1000);
  std::string back(text.size(), '\0');
  uLongf size = back.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                     reinterpret_cast<const Bytef*>(small.data()), small.size()) == Z_OK);
  CHECK(back == text);
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}
