// SPDX-License-Identifier: Apache-2.0
//
// The other end of the line of the gantry track: what host.sends may say, bytes of values, and what
// a disturbed line does to a run.
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "lab/record.hpp"
#include "machines/gantry/host.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::gantry;
using Bytes = std::vector<unsigned char>;

namespace {

Result after(const std::string& sends, Options options = by_twin(0.1)) {
  options.sends = sends;
  return lab::simulate(options);
}

std::int32_t goal_mm(const Result& result) { return result.samples.back().goal * 5 / 32; }

}  // namespace

TEST_CASE("gantry host: a value has the bytes of the protocol, two at least and six at most") {
  CHECK(frame_of(9, 42) == Bytes{0x8A, 0x49});
  CHECK(frame_of(21, 305) == Bytes{0xCC, 0x35});
  CHECK(frame_of(22, 170'000) == Bytes{0x82, 0xCC, 0x84, 0x16});
  for (const auto& [value, length] :
       {std::pair{0u, 2u}, {511u, 2u}, {512u, 3u}, {65'535u, 3u}, {65'536u, 4u}, {8'388'607u, 4u},
        {8'388'608u, 5u}, {1'073'741'823u, 5u}, {1'073'741'824u, 6u}, {0xFFFFFFFFu, 6u}}) {
    CHECK(frame_of(31, value).size() == length);
  }
}

TEST_CASE("gantry host: what is sent is read with its time, in each of its forms") {
  const std::vector<Sent> all = read_sends("0:21=305 0.5:31? 0.5:d1?  2:x8A49");
  REQUIRE(all.size() == 4);
  CHECK(all[0].at_s == 0);
  CHECK(all[0].bytes == Bytes{0xCC, 0x35});
  CHECK(all[1].at_s == 0.5);
  CHECK(all[1].bytes == Bytes{0x7F});
  CHECK(all[2].bytes == Bytes{0x41});
  CHECK(all[3].bytes == Bytes{0x8A, 0x49});
  CHECK(read_sends("").empty());
  CHECK(read_sends("3600:0=4294967295").front().bytes.size() == 6);
}

TEST_CASE("gantry host: what cannot be sent is refused in a line with the word and what is wrong") {
  const std::pair<const char*, const char*> wrong[] = {
      {"21=305", "there is no \":\""},     {"x:21=305", "its time is not 0 to 3600 s"},
      {"-1:21=305", "its time"},           {"3601:21=305", "its time"},
      {"nan:0?", "its time"},              {"1e:0?", "its time"},
      {"1:21", "neither sets nor polls"},  {"1:", "neither sets nor polls"},
      {"1:32=1", "32 is above 31"},        {"1:32?", "32 is above 31"},
      {"1:d?", "\"\" is no number"},       {"1:?", "\"\" is no number"},
      {"1:-1=1", "is no number"},          {"1:1=-1", "is no number"},
      {"1:1=4294967296", "above 4294967295"}, {"1:1=9z", "\"9z\" is no number"},
      {"1:x8", "two digits each"},         {"1:x", "two digits each"},
      {"1:xGG", "\"GG\" is no number"},    {"2:0? 1:0?", "earlier than the one before"},
      {"1:0? 3:0? 2:0?", "earlier than the one before"}};
  for (const auto& [text, why] : wrong) {
    const char* const words = text;
    const std::string told = test::refusal_of([&] { read_sends(words); });
    CAPTURE(text, told);
    const std::string all = text;
    const std::string word = all.substr(all.rfind(' ') + 1);
    CHECK_THAT(told, Catch::StartsWith("host.sends: \"" + word + "\": "));
    CHECK_THAT(told, Catch::Contains(why));
    CHECK_THAT(told, Catch::Contains("permitted: "));
    CHECK_THAT(told, !Catch::Contains("\n"));
  }
}

TEST_CASE("gantry host: a port has bytes only when some came, and leaves no file open") {
  namespace fs = std::filesystem;
  const auto open = [] {
    const fs::directory_iterator files("/proc/self/fd");
    return std::distance(begin(files), end(files));
  };
  const auto before = open();
  {
    PseudoTerminal port(20'000);
    CHECK(open() == before + 1);
    CHECK_FALSE(port.next(0));
    port.take(0x31);  // which nobody reads
    CHECK_FALSE(port.next(1));
  }
  CHECK(open() == before);
}

TEST_CASE("gantry host: bytes of a line are read from its edges, and none without a stop bit") {
  constexpr cosim::Clk kBit = 434;
  LineReader reader(kBit);
  Bytes came;
  cosim::Clk now = 1000;
  const auto level = [&](bool high, int bits) {
    reader.see(now, high, [&came](unsigned char byte) { came.push_back(byte); });
    now += bits * kBit;
  };
  const auto frame = [&](unsigned byte, bool stop) {
    level(false, 1);
    for (int k = 0; k < 8; ++k) level((byte >> k & 1u) != 0, 1);
    level(stop, 1);
  };
  level(true, 3);
  for (unsigned byte = 0; byte < 256; ++byte) frame(byte, true);
  level(true, 2);
  REQUIRE(came.size() == 256);
  for (unsigned byte = 0; byte < 256; ++byte) CHECK(came[byte] == byte);
  frame(0x55, false);
  level(true, 20);
  frame(0x31, true);
  level(true, 2);
  level(true, 2);
  REQUIRE(came.size() == 257);
  CHECK(came.back() == 0x31);
}

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
