// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/chip/soc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "machines/kung/options.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "sw_nios/hal/soc_map.hpp"

namespace trammel::kung {

namespace map = sw::soc_map;

const CoreMemory& core_image() {
  static const CoreMemory image{
#ifdef TRAMMEL_CORE
#include <kung_image.inc>
#endif
  };
  return image;
}

CoreMemory core_memory(const sw::KungSetup& setup, bool start) {
  CoreMemory memory = core_image();
  const auto header = [&memory](std::uint32_t n) { return memory.at(map::kHeader / 4 + n); };
  const std::uint32_t at = header(map::kSetup), free = header(map::kFree);
  std::uint32_t limit = header(map::kLimit);
  sw::SetupWords words;
  if (setup.precision.on && setup.precision.learn) {
    const auto needed = static_cast<std::uint32_t>(sizeof(sw::Corrections));
    if (needed > limit - free) {
      throw OptionsError(fmt::format("precision.learn: its corrections need {} bytes, too many for "
                                     "run.cpu = \"rtl\": its memory has room for {}",
                                     needed, limit - free));
    }
    limit -= needed;
    words.corrections = limit;
  }
  const std::uint32_t room = (limit - free) / static_cast<std::uint32_t>(sizeof(sw::Point));
  if (setup.path == sw::Path::kPoints && setup.n_points > room) {
    throw OptionsError(fmt::format("path.points_file: {} points are too many for run.cpu = "
                                   "\"rtl\": its memory has room for {}",
                                   setup.n_points, room));
  }
  const bool feed = setup.path == sw::Path::kFeed;
  const std::size_t needed = setup.feed.n_segments * sizeof(sw::FeedSegment) +
                             setup.feed.n_phases * sizeof(sw::FeedPhase);
  if (feed && needed > limit - free) {
    throw OptionsError(fmt::format("path.profile: {} lines and arcs with {} phases of motion need "
                                   "{} bytes, too many for run.cpu = \"rtl\": its memory has room "
                                   "for {}", setup.feed.n_segments, setup.feed.n_phases, needed,
                                   limit - free));
  }
  sw::pack(setup, words);
  words.flags |= start ? sw::SetupWords::kStart : 0;
  words.points = free;
  memory.resize(header(map::kLimit) / 4);
  std::uint32_t n = at / 4;
  memory[n++] = words.flags;
  memory[n++] = words.points;
  memory[n++] = words.corrections;
  std::copy(words.members.begin(), words.members.end(), memory.begin() + n);
  n = free / 4;
  for (std::uint32_t k = 0; setup.path == sw::Path::kPoints && k < setup.n_points; ++k) {
    memory[n++] = static_cast<std::uint32_t>(setup.points[k].x);
    memory[n++] = static_cast<std::uint32_t>(setup.points[k].y);
  }
  if (feed) {
    const std::size_t segments = setup.feed.n_segments * sizeof(sw::FeedSegment);
    std::memcpy(&memory[free / 4], setup.feed.segments, segments);
    std::memcpy(&memory[(free + segments) / 4], setup.feed.phases, needed - segments);
  }
  return memory;
}

}  // namespace trammel::kung
