// SPDX-License-Identifier: Apache-2.0
#include "lab/delta_code.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <stdexcept>

namespace trammel::lab {
namespace {

constexpr unsigned kBits = 7;  // of a value in one byte; the eighth says that more follow

std::int64_t predicted(int order, std::int64_t last, std::int64_t before) {
  return order == 1 ? last : 2 * last - before;
}

std::string coded(const std::vector<std::int64_t>& values, int order) {
  std::string bytes;
  std::int64_t last = 0;
  std::int64_t before = 0;
  for (const std::int64_t value : values) {
    const std::int64_t difference = value - predicted(order, last, before);
    auto rest = (static_cast<std::uint64_t>(difference) << 1) ^
                static_cast<std::uint64_t>(difference >> 63);  // zigzag: small either way
    for (; rest >= 1u << kBits; rest >>= kBits) bytes += static_cast<char>((rest & 127u) | 128u);
    bytes += static_cast<char>(rest);
    before = last;
    last = value;
  }
  return bytes;
}

}  // namespace

Coded delta_code(const std::vector<std::int64_t>& values) {
  for (const std::int64_t value : values) {
    if (value > kMaxCoded || value < -kMaxCoded) {
      throw std::range_error(fmt::format("value {} is beyond +-{}", value, kMaxCoded));
    }
  }
  Coded one{1, coded(values, 1)};
  Coded two{2, coded(values, 2)};
  return two.bytes.size() < one.bytes.size() ? two : one;
}

std::vector<std::int64_t> delta_decode(const std::string& bytes, int order, std::size_t count) {
  std::vector<std::int64_t> values;
  std::size_t at = 0;
  std::int64_t last = 0;
  std::int64_t before = 0;
  while (values.size() < count) {
    std::uint64_t rest = 0;
    unsigned shift = 0;
    unsigned char byte = 128;
    for (; byte >= 128; shift += kBits) {
      if (at == bytes.size()) throw std::range_error("the series ends early");
      byte = static_cast<unsigned char>(bytes[at++]);
      rest |= (std::uint64_t{byte} & 127u) << shift;
    }
    const auto difference = static_cast<std::int64_t>((rest >> 1) ^ (~(rest & 1) + 1));
    const std::int64_t value = predicted(order, last, before) + difference;
    values.push_back(value);
    before = last;
    last = value;
  }
  return values;
}

std::string deflate(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                             Z_BEST_COMPRESSION);
  if (code != Z_OK) throw std::runtime_error(fmt::format("zlib failed with {}", code));
  out.resize(size);
  return out;
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = at + k > bytes.size();
      text += padding ? '=' : kDigits[(group >> (18 - 6 * k)) & 63u];
    }
  }
  return text;
}

}  // namespace trammel::lab
