// SPDX-License-Identifier: Apache-2.0
//
// What a loader gives to the program of a core: every member of a set-up, and the room in the
// core's memory.
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

#include "machines/kung/soc.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "sw_nios/hal/soc_map.hpp"

using namespace trammel;
using Catch::Matchers::Contains;

namespace {

using Bytes = std::array<unsigned char, sizeof(sw::KungSetup)>;

Bytes bytes_of(const sw::KungSetup& setup) {
  Bytes bytes;
  std::memcpy(bytes.data(), &setup, bytes.size());
  return bytes;
}

}  // namespace

TEST_CASE("every member of a set-up goes to the core and comes back, alone") {
  static const sw::KungSetup plain;
  std::size_t lost = 0;
  for (std::size_t at = 0; at < sizeof plain; ++at) {
    Bytes changed = bytes_of(plain);
    changed[at] ^= 1;
    sw::KungSetup given, back;
    std::memcpy(&given, changed.data(), changed.size());
    std::memcpy(&back, &plain, sizeof plain);
    sw::SetupWords words;
    sw::pack(given, words);
    sw::unpack(words, back);
    if (bytes_of(back) == changed) continue;
    CAPTURE(at);
    CHECK(bytes_of(back) == bytes_of(plain));
    ++lost;
  }
  // Addresses of lists, and gaps: a new member belongs into `each_member`.
  if (sizeof(void*) == 8) CHECK(lost == 70);
}

TEST_CASE("lists have the room from the program's data to the stack, which is 2 KiB at the end") {
  if (kung::core_image().empty()) return;  // built without the cross compiler
  namespace map = sw::soc_map;
  constexpr std::uint32_t kMemory = 4 * 16384, kStack = 2048;  // [byte], Words of kung_soc.sv
  sw::KungSetup setup;
  const kung::CoreMemory memory = kung::core_memory(setup, true);
  const std::uint32_t free = memory.at(map::kHeader / 4 + map::kFree);
  CHECK(memory.at(map::kHeader / 4 + map::kLimit) == kMemory - kStack);
  const std::uint32_t room = (kMemory - kStack - free) / 8;
  std::vector<sw::Point> points(room + 1);
  setup.path = sw::Path::kPoints;
  setup.points = points.data();
  setup.n_points = room;
  CHECK_NOTHROW(kung::core_memory(setup, true));
  setup.n_points = room + 1;
  CHECK_THROWS_WITH(kung::core_memory(setup, true),
                    Contains("its memory has room for " + std::to_string(room)));
}
