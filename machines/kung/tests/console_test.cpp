// SPDX-License-Identifier: Apache-2.0
//
// The console of the table's program: what it answers, and that it does nothing else.
#include "sw_nios/apps/kung/console.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

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
  // The lines of an answer, without their ends; in front of it is what was printed before.
  std::vector<std::string> lines(const std::string& line, const std::string& before = "") {
    std::vector<std::string> all;
    const std::string text = before + say(line);
    std::size_t at = 0;
    for (std::size_t end; (end = text.find("\r\n", at)) != std::string::npos; at = end + 2) {
      all.push_back(text.substr(at, end - at));
    }
    return all;
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
        "log 129", "log 257", "r", "r 1 2", "r 2", "r 1024", "r 0x400", "r -4", "r 0x", "r 0xg",
        "r 4x", "r 0x00000004g", "r 0x100000004",
        "log 1 2", "a b c d e f g", "start\t", "path circle 99999999999",
        "path circle 0000000001", "path circle 4294967297", "path circl", "path circles"}) {
    INFO(wrong);
    CHECK(b.say(wrong) == "?\r\n");
  }
  CHECK(b.say("status" + std::string(48 - 6, ' ')).substr(0, 4) == "off ");
  CHECK(b.say("status" + std::string(49 - 6, ' ')) == "?\r\n");
  CHECK_THAT(b.say("help"), Catch::Contains("status"));
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

TEST_CASE("each name chooses its path, and numbers are taken to the ends of their ranges") {
  const std::pair<const char*, sw::Path> paths[] = {{"circle", sw::Path::kCircle},
                                                    {"window", sw::Path::kWindow},
                                                    {"star", sw::Path::kStar},
                                                    {"square", sw::Path::kSquare},
                                                    {"line", sw::Path::kLine}};
  Bench b;
  for (const auto& [name, path] : paths) {
    for (const std::uint32_t passes : {1u, 7u, 1000u}) {
      CAPTURE(name, passes);
      CHECK(b.say(std::string("path ") + name + " " + std::to_string(passes)) == "ok\r\n");
      CHECK(b.program.setup().path == path);
      CHECK(b.program.setup().repeats == passes);
    }
    CHECK(b.say(std::string("path ") + name) == "ok\r\n");
    CHECK(b.program.setup().repeats == 1);
  }
  for (const char* ends : {"gain x kp 0 -16", "gain y kp 2047 15"}) {
    INFO(ends);
    CHECK(b.say(ends) == "ok\r\n");
  }
  for (const char* count : {"log 1", "log 128", "log 000000001"}) {
    INFO(count);
    CHECK(b.say(count).substr(0, 10) == "tick x_cmd");
  }
}

TEST_CASE("the gains of both axes are printed, each its own") {
  Bench b;
  const char* names[] = {"kp", "ki", "kv", "eta", "kp_cur", "ki_cur"};
  std::string wanted;
  int number = 0;
  for (const char* axis : {"x", "y"}) {
    wanted += axis;
    for (const char* name : names) {
      const std::string gain =
          std::string(name) + " " + std::to_string(901 + number) + " " + std::to_string(number - 6);
      ++number;
      CHECK(b.say(std::string("gain ") + axis + " " + gain) == "ok\r\n");
      wanted += " " + gain;
    }
    wanted += "\r\n";
  }
  CHECK(b.say("gains") == wanted);
}

TEST_CASE("the status is off, on or failed, with point, failure and fault") {
  Bench b;
  b.say("start");
  b.chip.tick(4);
  b.program.app().isr(b.chip);
  CHECK(b.say("status") == "on point 0 of 629 failure 0 fault 0\r\n");
  b.chip.registers[reg::kFault] = 5;
  b.chip.registers[reg::kIrqStat] |= reg::kIrqStatFault;
  b.program.app().isr(b.chip);
  const auto fault = std::to_string(static_cast<std::uint32_t>(sw::Failure::kFault));
  CHECK(b.say("status") == "failed point 0 of 629 failure " + fault + " fault 5\r\n");
  b.say("stop");
  CHECK(b.say("status").substr(0, 4) == "off ");
}

TEST_CASE("a gain is kept for the next start") {
  Bench b;
  CHECK(b.say("gain y ki_cur 100 -3") == "ok\r\n");
  CHECK(b.writes() == 0);
  CHECK_THAT(b.say("gains"), Catch::Contains("ki_cur 100 -3"));
  b.say("start");
  CHECK(b.chip.registers[reg::kY + reg::kKiCur] == sw::gain_word({100, -3}));
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
      CHECK(b.chip.registers.size() == wanted.size());
      for (const auto& [at, value] : wanted) {
        INFO("register at " << at);
        CHECK(b.chip.registers[at] == value);
      }
    }
  }
}

TEST_CASE("a register of the IC is read, its address decimal or hexadecimal") {
  Bench b;
  b.chip.registers[0x000] = 0xFFFF'FFFF;
  b.chip.registers[0x0C8] = 0x0123'4567;
  b.chip.registers[0x094] = 0x55AA'33CC;
  b.chip.registers[0x3FC] = 0x89AB'CDEF;
  CHECK(b.say("r 0") == "0xffffffff\r\n");
  CHECK(b.say("r 200") == "0x01234567\r\n");
  CHECK(b.say("r 0x94") == "0x55aa33cc\r\n");
  CHECK(b.say("r 0xc8") == "0x01234567\r\n");
  CHECK(b.say("r 0X000000C8") == "0x01234567\r\n");
  CHECK(b.say("r 0x3fc") == "0x89abcdef\r\n");
  CHECK(b.say("r 1020") == "0x89abcdef\r\n");
  CHECK(b.writes() == 0);
}

TEST_CASE("the status tells of bytes that were lost on the line, if any") {
  Bench b;
  b.console.lost(0);
  CHECK_THAT(b.say("status"), !Catch::Contains("lost"));
  b.console.lost(17);
  CHECK(b.say("status") == "off point 0 of 629 failure 0 fault 0 lost 17\r\n");
}

TEST_CASE("the status of drives that are on tells when the table was where, as the log does") {
  Bench b;
  b.say("start");
  for (int i = 0; i < 6; ++i) {
    b.chip.tick(4);
    b.program.app().isr(b.chip);
  }
  const sw::LogRecord& last = b.program.app().log(b.program.app().log_size() - 1);
  const std::string now = " tick " + std::to_string(last.tick) + " x " +
                          std::to_string(last.x_pos) + " y " + std::to_string(last.y_pos);
  CHECK_THAT(b.say("status"), Catch::Contains(now + "\r\n"));
}

TEST_CASE("a command within a line of the log is answered behind that line") {
  for (int fields = 0; fields <= 25; ++fields) {  // of two lines, that are printed till then
    CAPTURE(fields);
    Bench b;
    b.say("start");
    for (int i = 0; i < 3; ++i) {
      b.chip.tick(4);
      b.program.app().isr(b.chip);
    }
    const std::vector<std::string> whole = b.lines("log 2");
    REQUIRE(whole.size() == 3);
    const std::string status = b.lines("status").at(0);
    for (const char c : std::string("log 2\n")) b.console.take(c);
    std::string text;
    const auto print = [&] { while (!b.console.ring().empty()) text += b.console.ring().take(); };
    print();
    for (int n = 0; n < fields; ++n) {
      b.console.pump();
      print();
    }
    std::vector<std::string> left = b.lines("status", text);
    const auto answer = std::find(left.begin(), left.end(), status);
    REQUIRE(answer != left.end());
    left.erase(answer);
    CHECK(left == whole);
  }
}

TEST_CASE("each number of a line of the log is the one its heading says, up to 128 lines") {
  Bench b;
  b.say("path square");
  b.say("start");
  b.chip.tick(4);
  b.program.app().isr(b.chip);
  std::vector<std::string> lines;
  for (std::int32_t n = 0; n < 300; ++n) {
    std::int32_t value = 1000 * n - 5000;
    for (const std::uint32_t address : {reg::kPos, reg::kPosModel, reg::kIqCmd}) {
      for (const std::uint32_t base : {reg::kX, reg::kY}) {
        b.chip.registers[base + address] = static_cast<std::uint32_t>(++value);
      }
    }
    b.chip.shown_status = {0x10u + static_cast<std::uint32_t>(2 * n) * 16, 0x8000'0000u};
    b.chip.tick(4);
    b.program.app().isr(b.chip);
    const sw::LogRecord& r = b.program.app().log(b.program.app().log_size() - 1);
    std::string line = std::to_string(b.chip.registers[reg::kTick]) + " " +
                       std::to_string(r.x_cmd) + " " + std::to_string(r.y_cmd);
    for (std::int32_t k = value - 5; k <= value; ++k) line += " " + std::to_string(k);
    lines.push_back(line + " " + std::to_string(b.chip.shown_status[0]) + " -2147483648");
  }
  for (const std::size_t asked : {std::size_t{1}, std::size_t{2}, std::size_t{128}}) {
    for (const std::string& command : {"log " + std::to_string(asked), std::string("log")}) {
      if (command == "log" && asked != 128) continue;
      const std::vector<std::string> printed = b.lines(command);
      CAPTURE(command);
      REQUIRE(printed.size() == asked + 1);
      CHECK(printed[0] ==
            "tick x_cmd y_cmd x_pos y_pos x_model y_model x_iq y_iq x_status y_status");
      for (std::size_t n = 0; n < asked; ++n) {
        const std::string& wanted = lines[300 - asked + n];
        if (printed[n + 1] != wanted) REQUIRE(printed[n + 1] == wanted);
      }
    }
  }
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
    CHECK(ring.room() == 512);
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

TEST_CASE("a line of a text has 160 bytes at most, and what is beyond is cut") {
  for (const std::uint32_t bytes : {159u, 160u, 161u}) {
    sw::TextLine line;
    line.text(std::string(bytes, 'a').c_str());
    CHECK(line.size() == std::min(bytes, 160u));
  }
}
