// SPDX-License-Identifier: Apache-2.0
#include "host/disk_vector.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdint>

namespace trammel::host {
namespace {

using Numbers = DiskVector<std::int64_t>;

TEST_CASE("a disk vector holds what a vector would, before, at and behind a full block") {
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, Numbers::kBlock - 1,
                                 Numbers::kBlock, Numbers::kBlock + 1, 3 * Numbers::kBlock + 7}) {
    CAPTURE(size);
    Numbers all;
    std::vector<std::int64_t> same;
    for (std::size_t n = 0; n < size; ++n) {
      const auto value = static_cast<std::int64_t>(n * n) - 1000;
      all.push_back(value);
      same.push_back(value);
      REQUIRE(all.back() == value);  // reading in between moves nothing
      REQUIRE(all[n / 2] == same[n / 2]);
    }
    CHECK(all.size() == size);
    CHECK(all.empty() == (size == 0));
    CHECK(std::equal(same.begin(), same.end(), all.begin()));
    CHECK(static_cast<std::size_t>(all.end() - all.begin()) == size);
    for (std::size_t n = size; n > 0; n -= std::min<std::size_t>(n, 97)) {
      REQUIRE(all[n - 1] == same[n - 1]);
    }
    const Numbers moved = std::move(all);
    CHECK(moved.size() == size);
    CHECK(std::equal(same.begin(), same.end(), moved.begin()));
  }
}

TEST_CASE("a disk vector is searched like a vector") {
  DiskVector<double> all{1, 2, 4};
  for (int n = 5; n < 20000; ++n) all.push_back(n);
  CHECK(std::lower_bound(all.begin(), all.end(), 3.5) - all.begin() == 2);
  CHECK(std::lower_bound(all.begin(), all.end(), 12345.0) - all.begin() == 12343);
  CHECK(std::lower_bound(all.begin(), all.end(), 1e9) == all.end());
  CHECK(all.front() == 1);
}

TEST_CASE("a full disk is an error, not a record with a hole") {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit least = before;
  least.rlim_cur = 20000;
  setrlimit(RLIMIT_FSIZE, &least);
  Numbers all;
  const auto fill = [&all] {
    for (int n = 0; n < 100000; ++n) all.push_back(n);
  };
  CHECK_THROWS_AS(fill(), std::system_error);
  setrlimit(RLIMIT_FSIZE, &before);
}

}  // namespace
}  // namespace trammel::host
