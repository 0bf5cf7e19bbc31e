// SPDX-License-Identifier: Apache-2.0
//
// What a disturbed line does to a run of the machine gantry: what is no command is dropped and
// counted, and the next good frame acts.
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "lab/record.hpp"
#include "machines/gantry/machine.hpp"
#include "machines/gantry/tests/by_twin.hpp"

using namespace trammel;
using namespace trammel::gantry;

namespace {

Result after(const std::string& sends, Options options = by_twin(0.1)) {
  options.sends = sends;
  return lab::simulate(options);
}

std::int32_t goal_mm(const Result& result) { return result.samples.back().goal * 5 / 32; }

}  // namespace

TEST_CASE("gantry line: bytes that are no frame leave the goal, and the next frame is taken") {
  struct Case {
    const char* sends;
    int goal_mm;
    std::uint32_t malformed, refused, unknown;
  };
  for (const Case& one : {
           Case{"0.01:21=100 0.02:x81 0.05:21=50", 50, 1, 0, 0},      // a glitch on an idle line
           Case{"0.01:x8A 0.05:21=100", 100, 1, 0, 0},                // the rest is lost
           Case{"0.01:21=300 0.02:x82CC84 0.05:21=100", 100, 1, 0, 0},
           Case{"0.01:xFFFFFFFFFFFF 0.05:21=100", 100, 1, 0, 0},
           Case{"0.01:xFFFFFFFFFFFF 0.015:21=100", 0, 1, 0, 0},       // within the gap: one frame
           Case{"0.01:21=100 0.02:x818C55", 100, 0, 1, 0},            // 50 with a byte before it
           Case{"0.01:21=100 0.02:x8C8155", 100, 0, 1, 0},            // and in it
           Case{"0.01:21=100 0.02:x8C 0.025:21=50", 100, 0, 1, 0},    // its end lost in a hurry
           Case{"0.01:21=100 0.02:21=471 0.03:0=4294967295", 100, 0, 2, 0},
           Case{"0.01:21=100 0.02:x15 0.03:x55", 100, 0, 0, 2}}) {    // last bytes alone
    const Result result = after(one.sends);
    CAPTURE(one.sends);
    CHECK(goal_mm(result) == one.goal_mm);
    CHECK(result.malformed == one.malformed);
    CHECK(result.refused == one.refused);
    CHECK(result.unknown == one.unknown);
  }
}

TEST_CASE("gantry line: pauses within a frame may be as long as the gap, to a tenth of a ms") {
  struct Case {
    double gap_ms;
    const char* sends;
    int goal_mm;
  };
  // The first byte ends 87 us behind its time.
  for (const Case& one : {Case{10, "0.01:xCC 0.02:x35", 305}, Case{10, "0.01:xCC 0.0202:x35", 0},
                          Case{2, "0.01:xCC 0.01205:x35", 305}, Case{2, "0.01:xCC 0.0122:x35", 0},
                          Case{0, "0.01:xCC 0.09:x35", 305}}) {
    Options options = by_twin(0.1);
    options.gap_ms = one.gap_ms;
    CAPTURE(one.gap_ms, one.sends);
    CHECK(goal_mm(after(one.sends, options)) == one.goal_mm);
  }
}

TEST_CASE("gantry line: in the checked mode a frame that another byte has changed does nothing") {
  Options options = by_twin(0.1);
  options.firmware.checked = true;
  const Result result = after("0.01:21=100 0.03:x80A055 0.05:x7F 0.07:21=200", options);
  CHECK(goal_mm(result) == 200);
  CHECK(result.unchecked == 2);
  CHECK(result.heard == std::vector<unsigned char>{0x8A, 0x49, 0x8F, 0xA2, 0x1B});
  const Result plain = after("0.01:21=100 0.03:x80A055");
  CHECK(goal_mm(plain) == 130);  // which is 2 with a byte in it
}

TEST_CASE("gantry line: a baud rate 3 % off does, 8 % does not; a byte without stop bit is bad") {
  for (const double error : {-0.08, -0.03, 0.03, 0.08}) {
    Options options = by_twin(0.1);
    options.line.baud_error = error;
    CAPTURE(error);
    const Result result = after("0.02:21=305", options);
    CHECK((goal_mm(result) == 305) == (error * error < 0.002));
    CHECK((result.heard == std::vector<unsigned char>{0x8A, 0x49}) == (error * error < 0.002));
  }
  Options options = by_twin(0.1);
  options.line.framing_errors = 0.25;  // each fourth byte: the end of the second frame
  const Result result = after("0.01:21=100 0.02:21=200 0.04:21=300", options);
  CHECK(goal_mm(result) == 300);
  CHECK(result.malformed == 1);
}

TEST_CASE("gantry line: the whole answer of a poll is kept, once for each poll") {
  const Result result = after("0.01:31? 0.01:31? 0.01:31?");
  const auto& heard = result.heard;
  REQUIRE(heard.size() == 2 + 3 * 70);
  for (std::size_t k = 2; k < 72; ++k) {
    CHECK(heard[k] == heard[k + 70]);
    CHECK(heard[k] == heard[k + 140]);
  }
}
