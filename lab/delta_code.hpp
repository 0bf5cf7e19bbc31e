// SPDX-License-Identifier: Apache-2.0
//
// How series travel inside a report page: integers, each as the difference to what a line through
// the ones before it predicts, zigzag, seven bits a byte; all series behind each other through
// zlib; base64. The page undoes it in lab/page/decode.js.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trammel::lab {

// Doubles hold these exactly, and so do their second differences.
inline constexpr std::int64_t kMaxCoded = std::int64_t{1} << 50;

struct Coded {
  int order = 1;      // 1: difference to the last value; 2: to the line through the last two
  std::string bytes;  // of the order that needs fewer
};

// Throws std::range_error for a value beyond +-kMaxCoded.
Coded delta_code(const std::vector<std::int64_t>& values);

// The inverse, from `count` values at the begin of `bytes`; throws std::range_error when they end
// early.
std::vector<std::int64_t> delta_decode(const std::string& bytes, int order, std::size_t count);

std::string deflate(const std::string& bytes);  // zlib format
std::string base64(const std::string& bytes);

}  // namespace trammel::lab
