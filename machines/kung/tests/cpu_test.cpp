// SPDX-License-Identifier: Apache-2.0
//
// The program of a core: what run.cpu = "rtl" excludes, what it tells, and what a loader writes
// into its memory: every member of a set-up, and lists as long as there is room.
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

#include "machines/kung/chip/record.hpp"
#include "machines/kung/chip/soc.hpp"
#include "machines/kung/run/cpu.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "sw_nios/hal/soc_map.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Matchers::Contains;

namespace {

using Bytes = std::array<unsigned char, sizeof(sw::KungSetup)>;

Bytes bytes_of(const sw::KungSetup& setup) {
  Bytes bytes;
  std::memcpy(bytes.data(), &setup, bytes.size());
  return bytes;
}

}  // namespace

TEST_CASE("a serial port, faults of native firmware and a sweep of current are told apart") {
  Options o;
  CHECK_NOTHROW(check_cpu(o));
  o.uart = "pty";
  CHECK_THROWS_WITH(check_cpu(o), Contains("run.uart: native firmware has no serial port"));
  o.cpu = Cpu::kRtl;
  CHECK_NOTHROW(check_cpu(o));
  o.fault.kind = cosim::FaultKind::kProcessorSlow;
  CHECK_THROWS_WITH(check_cpu(o), Contains("inject.fault: faults of the processor are of native"));
  o.fault.kind = cosim::FaultKind::kEncoderStuck;
  CHECK_NOTHROW(check_cpu(o));
  o.path.kind = PathKind::kSweep;
  o.path.sweep_of = SweepOf::kCurrent;
  CHECK_THROWS_WITH(check_cpu(o), Contains("path.sweep_of: \"current\""));
}

TEST_CASE("a run tells the clocks of its routines beside those of native firmware") {
  Options o;
  Result result;
  CHECK(cpu_lines(o, result).empty());
  cosim::CoreTimes& core = result.core.emplace();
  for (const cosim::Clk clocks : {3000, 3500}) core.routine.add(clocks);
  for (int n = 0; n < 2; ++n) core.first.add(106);
  core.transfers.add(14);
  core.answer.add(2);
  const std::vector<std::string> lines = cpu_lines(o, result);
  REQUIRE(lines.size() == 4);
  CHECK_THAT(lines[1], Contains("106") && Contains("3500    3.50 %") && Contains("3250    3.25 %"));
  // Latency 100, and 14 transfers of 8 and 2 clocks.
  CHECK_THAT(lines[2], Contains("106") && Contains("3076    3.08 %"));
}

TEST_CASE("a loader writes set-up and points into the image, and says when there is no room") {
  if (core_image().empty()) return;  // built without the cross compiler
  namespace map = sw::soc_map;
  sw::KungSetup setup;
  std::vector<sw::Point> points{{1, -2}, {300, 400}};
  setup.path = sw::Path::kPoints;
  setup.points = points.data();
  setup.n_points = 2;
  const CoreMemory memory = core_memory(setup, true);
  const auto header = [&](std::uint32_t n) { return memory.at(map::kHeader / 4 + n); };
  CHECK(header(map::kIsProgram) == map::kMagic);
  const std::size_t at = header(map::kSetup) / 4, list = header(map::kFree) / 4;
  CHECK(memory.at(at) == (sw::SetupWords::kUsed | sw::SetupWords::kStart));
  CHECK(memory.at(at + 1) == header(map::kFree));
  CHECK(memory.at(list) == 1);
  CHECK(memory.at(list + 1) == static_cast<std::uint32_t>(-2));
  CHECK(memory.at(list + 3) == 400);
  CHECK(core_image().at(at) == 0);  // on a board it waits for commands

  sw::KungSetup feed;
  const std::vector<sw::FeedSegment> segments(3);
  std::vector<sw::FeedPhase> phases(5);
  phases[4].path = 1234567;
  feed.path = sw::Path::kFeed;
  feed.feed.segments = segments.data();
  feed.feed.n_segments = 3;
  feed.feed.phases = phases.data();
  feed.feed.n_phases = 5;
  const CoreMemory planned = core_memory(feed, true);
  const std::size_t of_phases = list + 3 * sizeof(sw::FeedSegment) / 4;
  CHECK(planned.at(of_phases + 4 * sizeof(sw::FeedPhase) / 4 + 2) == 1234567);
  feed.feed.n_phases = 2000;
  CHECK_THROWS_WITH(core_memory(feed, true), Contains("path.profile: 3 lines and arcs with 2000 "
                                                      "phases of motion need 64264 bytes"));

  points.resize(20'000);
  setup.points = points.data();
  setup.n_points = 20'000;
  CHECK_THROWS_WITH(core_memory(setup, true), Contains("20000 points are too many"));

  sw::KungSetup learning;
  learning.precision.on = learning.precision.learn = true;
  CHECK_THROWS_WITH(core_memory(learning, true),
                    Contains("precision.learn: its corrections need 16384 bytes"));
}

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
