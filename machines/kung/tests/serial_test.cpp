// SPDX-License-Identifier: Apache-2.0
//
// The console of a run, with a file of commands: what it sends when, and what it hears.
#include "machines/kung/run/serial.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "cosim/run.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr cosim::Clk kBit = 434;  // 115,200 baud at 50 MHz

// The chip's end of the line: hears the console and answers at an edge of its own.
struct Line {
  explicit Line(const std::string& commands) : scratch("kung_serial") {
    const auto file = scratch.path / "commands.txt";
    std::ofstream(file) << commands;
    console.emplace(file.string(), [this] { return listens; });
  }

  void run(cosim::Clk until) {
    for (; now < until; now += kBit / 2) {  // two looks a bit
      const bool level = console->host().level(now);
      if (left == 0 && !level) {
        left = 10;
        at = now + kBit / 2;
        if (begin < 0) begin = now;
      }
      if (left > 0 && now >= at) {
        frame = frame >> 1 | (level ? 1u << 9 : 0);
        at += kBit;
        if (--left == 0) sent += static_cast<char>(frame >> 1 & 0xFF);
      }
    }
  }

  void answer(const std::string& text) {
    for (const char c : text) {
      const unsigned bits = static_cast<unsigned char>(c) << 1 | 1u << 9;
      for (int k = 0; k < 10; ++k) {
        see((bits >> k & 1u) != 0);
      }
      see(true);
    }
  }
  void see(bool level) {  // a bit long
    for (int half = 0; half < 2; ++half) {
      console->host().see(now, level);
      run(now + kBit / 2);
    }
  }

  test::Scratch scratch;
  std::optional<SerialConsole> console;
  bool listens = true;
  cosim::Clk now = 0, begin = -1, at = 0;
  std::string sent;

 private:
  int left = 0;
  unsigned frame = 0;
};

constexpr cosim::Clk kMs = 50'000;

}  // namespace

TEST_CASE("nothing is sent before the chip listens, then a line; the next one after its answer") {
  Line line("one\ntwo\nthree\n");
  line.listens = false;
  line.run(5 * kMs);
  CHECK(line.sent.empty());
  line.listens = true;
  line.run(20 * kMs);
  CHECK(line.sent == "one\n");
  CHECK(line.begin >= 5 * kMs);
  line.answer("o");  // an answer ends with its line
  line.run(40 * kMs);
  CHECK(line.sent == "one\n");
  line.answer("k\n");
  line.run(60 * kMs);
  CHECK(line.sent == "one\ntwo\n");
  CHECK(line.console->heard() == "ok\n");
}

TEST_CASE("a line that is not answered is followed by the next one 0.2 s later") {
  Line line("a\nb\n");
  line.run(190 * kMs);
  CHECK(line.sent == "a\n");
  line.run(210 * kMs);
  CHECK(line.sent == "a\nb\n");
  line.run(600 * kMs);  // and behind the last one comes nothing
  CHECK(line.sent == "a\nb\n");
}

TEST_CASE("a console leaves no open file behind, and refuses one that is not there") {
  const auto next = [] {  // that the system would give
    const int lowest = open("/dev/null", O_RDONLY | O_CLOEXEC);
    close(lowest);
    return lowest;
  };
  const int before = next();
  for (int k = 0; k < 3; ++k) Line("a\n").run(kMs);
  CHECK(next() == before);
  CHECK_THROWS_AS(SerialConsole("/nowhere/commands.txt", [] { return true; }),
                  cosim::OptionsError);
  CHECK_THROWS_WITH(SerialConsole("/nowhere/commands.txt", [] { return true; }),
                    "run.uart: /nowhere/commands.txt: there is no such file");
}
