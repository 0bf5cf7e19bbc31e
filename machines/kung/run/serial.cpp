// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/serial.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

#include "cosim/run.hpp"

namespace trammel::kung {
namespace {

constexpr cosim::Clk kClocksPerBit = 434;         // 115,200 baud at 50 MHz
constexpr cosim::Clk kLongestAnswer = 10'000'000;  // 0.2 s

}  // namespace

SerialConsole::SerialConsole(const std::string& from, std::function<bool()> listens)
    : listens_(std::move(listens)),
      host_(kClocksPerBit, [this](cosim::Clk edge) { return next(edge); },
            [this](unsigned char byte) { take(byte); }) {
  if (from == "-") {
    in_ = STDIN_FILENO;
    out_ = STDERR_FILENO;
  } else if (from == "pty") {
    in_ = out_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (in_ < 0 || grantpt(in_) != 0 || unlockpt(in_) != 0) {
      throw cosim::OptionsError("run.uart: \"pty\": this system gives no pseudo-terminal");
    }
    termios plain{};  // without an echo of the answers
    if (tcgetattr(in_, &plain) == 0) {
      cfmakeraw(&plain);
      tcsetattr(in_, TCSANOW, &plain);
    }
    std::fputs(fmt::format("trammel: the serial port is {}\n", ptsname(in_)).c_str(), stderr);
  } else {
    in_ = open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (in_ < 0) throw cosim::OptionsError("run.uart: " + from + ": there is no such file");
    by_answer_ = true;
  }
}

SerialConsole::~SerialConsole() {
  if (in_ > STDERR_FILENO) close(in_);
}

std::optional<unsigned char> SerialConsole::next(cosim::Clk edge) {
  if (in_ < 0 || !listens_()) return std::nullopt;
  if (by_answer_ && asked_ && edge < asked_at_ + kLongestAnswer) return std::nullopt;
  asked_ = false;
  pollfd wanted{in_, POLLIN, 0};
  unsigned char byte = 0;
  if (poll(&wanted, 1, 0) <= 0 || (wanted.revents & POLLIN) == 0) return std::nullopt;
  if (read(in_, &byte, 1) != 1) {
    if (in_ == STDIN_FILENO) in_ = -1;  // its end
    return std::nullopt;
  }
  if (byte == '\n') {
    asked_ = true;
    asked_at_ = edge;
  }
  return byte;
}

void SerialConsole::take(unsigned char byte) {
  heard_ += static_cast<char>(byte);
  if (byte == '\n') asked_ = false;
  if (out_ >= 0 && write(out_, &byte, 1) != 1) out_ = -1;
}

}  // namespace trammel::kung
