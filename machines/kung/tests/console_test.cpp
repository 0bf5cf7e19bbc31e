// SPDX-License-Identifier: Apache-2.0
//
// The console of the table's program: what it answers, and that it does nothing else.
#include "sw_nios/apps/kung/console.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "machines/kung/tests/fake_chip.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
using namespace trammel::test;

namespace {

struct Bench {
  FakeChip chip;
  sw::KungProgram program{sw::KungSetup{}};
  sw::Console console{program, chip};

  std::string printed() {
    std::string text;
    do {
      while (!console.ring().empty()) text += console.ring().take();
      console.pump();
    } while (!console.ring().empty());
    return text;
  }
  std::string say(const std::string& line) {
    for (const char c : line) console.take(c);
    console.take('\n');
    return printed();
  }
  std::size_t writes() const { return chip.writes().size(); }
};

}  // namespace

TEST_CASE("a command is answered by a line, and one that is none by a question mark") {
  Bench b;
  CHECK(b.say("status") == "off point 0 of 629 failure 0 fault 0\r\n");
  CHECK(b.say("") == "");
  CHECK(b.say("  status  ").substr(0, 3) == "off");
  for (const char* wrong :
       {"stat", "status now", "path", "path spiral", "path circle 0", "path circle 1001",
        "path circle x", "gain x kp 1", "gain z kp 1 0", "gain x kq 1 0", "gain x kp 2048 0",
        "gain x kp 1 16", "gain x kp 1 -17", "gain x kp -1 0", "gain x kp 1 0 0", "log 0",
        "log 257", "r", "r 1 2", "r 2", "r 1024", "r 0x400", "r -4", "r 0x", "r 0xg", "r 4x",
        "r 0x00000004g", "r 0x100000004",
        "log 1 2", "a b c d e f g", "start\t", "path circle 99999999999"}) {
    INFO(wrong);
    CHECK(b.say(wrong) == "?\r\n");
  }
  CHECK(b.say(std::string(sw::Console::kLine + 1, 'a')) == "?\r\n");
  CHECK(b.say("help").find("status") != std::string::npos);
  CHECK(b.writes() == 0);
}

TEST_CASE("CR and LF together end one line") {
  Bench b;
  for (const char c : std::string("help\r\n")) b.console.take(c);
  const std::string text = b.printed();
  CHECK(std::count(text.begin(), text.end(), '\n') == 1);
}

TEST_CASE("a path is chosen, started and stopped; drives that are on keep it") {
  Bench b;
  CHECK(b.say("path square 2") == "ok\r\n");
  CHECK(b.say("start") == "started\r\n");
  CHECK(b.program.app().points() == 3000);
  CHECK(b.program.started());
  CHECK(b.say("path circle") == "? drives are on\r\n");
  CHECK(b.say("start") == "? drives are on\r\n");
  CHECK(b.say("stop") == "stopped\r\n");
  CHECK(b.chip.registers[reg::kX + reg::kCtrl] == 0);
  CHECK(b.chip.registers[reg::kY + reg::kCtrl] == 0);
  CHECK(b.chip.registers[reg::kIrqEn] == 0);
  CHECK(b.say("path line") == "ok\r\n");
}

TEST_CASE("a gain is kept for the next start, and in effect at once while the drives are on") {
  Bench b;
  CHECK(b.say("gain y ki_cur 100 -3") == "ok\r\n");
  CHECK(b.writes() == 0);
  CHECK(b.say("gains").find("ki_cur 100 -3") != std::string::npos);
  b.say("start");
  CHECK(b.chip.registers[reg::kY + reg::kKiCur] == sw::gain_word({100, -3}));
  CHECK(b.say("gain x kp 2047 15") == "ok\r\n");
  CHECK(b.chip.registers[reg::kX + reg::kKp] == sw::gain_word({2047, 15}));
}

TEST_CASE("a gain typed while the drives are on goes to the register of its axis alone") {
  const std::pair<const char*, std::uint32_t> gains[] = {
      {"kp", reg::kKp}, {"ki", reg::kKi}, {"kv", reg::kKv},
      {"eta", reg::kEta}, {"kp_cur", reg::kKpCur}, {"ki_cur", reg::kKiCur}};
  for (const bool y : {false, true}) {
    for (const auto& [name, address] : gains) {
      CAPTURE(y, name);
      Bench b;
      b.say("start");
      const auto before = b.chip.registers;
      CHECK(b.say(std::string("gain ") + (y ? "y " : "x ") + name + " 1023 -5") == "ok\r\n");
      auto wanted = before;
      wanted[(y ? reg::kY : reg::kX) + address] = sw::gain_word({1023, -5});
      CHECK((b.chip.registers == wanted));
    }
  }
}

TEST_CASE("a register of the IC is read, its address decimal or hexadecimal") {
  Bench b;
  b.chip.registers[0x000] = 0xFFFF'FFFF;
  b.chip.registers[0x0C8] = 0x0123'4567;
  b.chip.registers[0x3FC] = 0x89AB'CDEF;
  CHECK(b.say("r 0") == "0xffffffff\r\n");
  CHECK(b.say("r 200") == "0x01234567\r\n");
  CHECK(b.say("r 0xc8") == "0x01234567\r\n");
  CHECK(b.say("r 0X000000C8") == "0x01234567\r\n");
  CHECK(b.say("r 0x3fc") == "0x89abcdef\r\n");
  CHECK(b.say("r 1020") == "0x89abcdef\r\n");
  CHECK(b.writes() == 0);
}

TEST_CASE("the status tells of bytes that were lost on the line, if any") {
  Bench b;
  b.console.lost(0);
  CHECK(b.say("status").find("lost") == std::string::npos);
  b.console.lost(17);
  CHECK(b.say("status") == "off point 0 of 629 failure 0 fault 0 lost 17\r\n");
}

TEST_CASE("the log is printed line by line, oldest first, and only what was asked") {
  Bench b;
  b.say("start");
  for (int i = 0; i < 6; ++i) {
    b.chip.tick(4);
    b.program.app().isr(b.chip);
  }
  REQUIRE(b.program.app().log_size() >= 3);
  const std::string text = b.say("log 3");
  CHECK(std::count(text.begin(), text.end(), '\n') == 4);  // with the heading
  const sw::LogRecord& last = b.program.app().log(b.program.app().log_size() - 1);
  const std::string tail = text.substr(text.rfind('\n', text.size() - 2) + 1);
  CHECK(tail.find(std::to_string(last.tick) + " " + std::to_string(last.x_cmd)) == 0);
  const std::string now = " tick " + std::to_string(last.tick) + " x " +
                          std::to_string(last.x_pos) + " y " + std::to_string(last.y_pos);
  CHECK(b.say("status").find(now + "\r\n") != std::string::npos);
}

TEST_CASE("a million random bytes write no register and end in an answer") {
  Bench b;
  Random random{31};
  for (int i = 0; i < 1'000'000; ++i) {
    b.console.take(static_cast<char>(random() & 0xFF));
    if (i % 50 == 0) b.printed();
  }
  b.console.take('\n');
  b.printed();
  CHECK(b.say("status").substr(0, 3) == "off");
  CHECK(b.chip.log.empty());
}

TEST_CASE("answers that find no room are left out whole") {
  Bench b;
  for (int i = 0; i < 100; ++i) {
    for (const char c : std::string("help\n")) b.console.take(c);
  }
  std::string text;
  while (!b.console.ring().empty()) text += b.console.ring().take();
  CHECK(text.size() <= sw::TextRing::kSize);
  CHECK(text.substr(text.size() - 2) == "\r\n");
}

TEST_CASE("a line that just fits the ring is written, one byte more is left out whole") {
  for (const std::uint32_t left : {0u, 1u, 2u}) {
    sw::TextRing ring;
    sw::TextLine one, byte;
    one.text("0123456789abcdef");
    byte.text("x");
    ring.put_part(one);
    while (ring.room() > one.size() + left) ring.put_part(byte);
    CAPTURE(left);
    CHECK(ring.put(one) == (left == 2));  // with CR and LF
    CHECK(ring.room() == (left == 2 ? 0 : one.size() + left));
    CHECK(ring.take() == '0');
  }
}

TEST_CASE("a set-up survives as words; a number of either sign and size does") {
  sw::KungSetup setup;
  setup.path = sw::Path::kStar;
  setup.repeats = 7;
  setup.circle.center.x = -(std::int64_t{3} << 40) - 5;
  setup.square.low = {-1, -123456};
  setup.axis[1].stroke_min = -2000;
  setup.axis[1].kv = {17, -9};
  setup.axis[0].adapt = setup.axis[1].feedforward = true;
  setup.following_limit = 99;
  setup.feed.start = {-77, 1 << 24};
  setup.feed.ticks = 123456789;
  sw::SetupWords words;
  sw::pack(setup, words);
  CHECK(words.flags == sw::SetupWords::kUsed);
  sw::KungSetup back;
  sw::unpack(words, back);
  sw::SetupWords again;
  sw::pack(back, again);
  CHECK((again.members == words.members));
  CHECK(back.path == sw::Path::kStar);
  CHECK(back.circle.center.x == setup.circle.center.x);
  CHECK(back.square.low == setup.square.low);
  CHECK(back.axis[1].kv.exp == -9);
  CHECK(back.axis[1].stroke_min == -2000);
  CHECK(back.feed.start == setup.feed.start);
  CHECK(back.feed.ticks == 123456789);
  CHECK(back.axis[0].adapt);
  CHECK_FALSE(back.axis[0].feedforward);
  CHECK(back.axis[1].feedforward);
}
