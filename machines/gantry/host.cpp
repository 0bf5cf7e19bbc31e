// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/host.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <sstream>
#include <thread>

#include "cosim/run.hpp"
#include "host/errors.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"

namespace trammel::gantry {
namespace {

// Where the computer was busy for longer, the track goes on from there: it makes up for less than
// this, so that no program sees it faster than the wall's time.
constexpr std::int64_t kMostLate_ns = 50'000'000;

// By then the line has taken the last byte of the reset message away.
constexpr std::int64_t kBooted_ns = 2'000'000;

std::int64_t wall_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

[[noreturn]] void refuse(const std::string& word, const std::string& why) {
  throw host::ConfigError(fmt::format(
      "host.sends: \"{}\": {}; permitted: time_s:channel=value, time_s:channel?, time_s:dN? and "
      "time_s:xHEX, channels 0 to 31, separated by blanks", word, why));
}

unsigned long long number(const std::string& word, const std::string& digits, int base,
                          unsigned long long most) {
  std::size_t used = 0;
  unsigned long long value = 0;
  try {
    value = std::stoull(digits, &used, base);
  } catch (const std::exception&) {
    refuse(word, "\"" + digits + "\" is no number");
  }
  if (used != digits.size() || digits[0] == '-') refuse(word, "\"" + digits + "\" is no number");
  if (value > most) refuse(word, fmt::format("{} is above {}", value, most));
  return value;
}

Sent read_word(const std::string& word, bool checked) {
  Sent sent;
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) refuse(word, "there is no \":\"");
  std::size_t used = 0;
  try {
    sent.at_s = std::stod(word.substr(0, colon), &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != colon || !(sent.at_s >= 0 && sent.at_s <= 3600)) {
    refuse(word, "its time is not 0 to 3600 s");
  }
  const std::string what = word.substr(colon + 1);
  const auto check = [&sent, checked](const sw::gantry_channel::Frame& frame) {
    if (!checked) return;
    for (const unsigned char byte :
         frame_of(sw::gantry_channel::kCheck, sw::gantry_channel::checksum_of(frame))) {
      sent.bytes.push_back(byte);
    }
  };
  if (!what.empty() && what[0] == 'x') {
    if (what.size() < 3 || what.size() % 2 == 0) refuse(word, "bytes have two digits each");
    for (std::size_t k = 1; k < what.size(); k += 2) {
      sent.bytes.push_back(
          static_cast<unsigned char>(number(word, what.substr(k, 2), 16, 255)));
    }
    return sent;
  }
  if (!what.empty() && what.back() == '?') {
    const bool bit = what[0] == 'd';
    const std::string digits = what.substr(bit ? 1 : 0, what.size() - (bit ? 2 : 1));
    const auto channel = static_cast<std::uint32_t>(number(word, digits, 10, 31));
    namespace proto = sw::gantry_channel;
    const std::uint32_t form = bit ? proto::kPollBit : proto::kPollChannel;
    sent.bytes.push_back(static_cast<unsigned char>(form << 5 | channel));
    check({form, channel, 0});
    return sent;
  }
  const std::size_t equal = what.find('=');
  if (equal == std::string::npos) refuse(word, "it neither sets nor polls");
  const auto channel = static_cast<std::uint32_t>(number(word, what.substr(0, equal), 10, 31));
  const auto value =
      static_cast<std::uint32_t>(number(word, what.substr(equal + 1), 10, 0xFFFFFFFF));
  sent.bytes = frame_of(channel, value);
  check({sw::gantry_channel::kValue, channel, value});
  return sent;
}

}  // namespace

std::vector<unsigned char> frame_of(std::uint32_t channel, std::uint32_t value) {
  std::vector<unsigned char> bytes{
      static_cast<unsigned char>((value & 3) << 5 | (channel & 31))};
  for (value >>= 2;;) {
    bytes.insert(bytes.begin(), static_cast<unsigned char>(0x80 | (value & 0x7F)));
    value >>= 7;
    if (value == 0) return bytes;
  }
}

std::vector<Sent> read_sends(const std::string& text, bool checked) {
  std::vector<Sent> all;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    all.push_back(read_word(word, checked));
    if (all.size() > 1 && all.back().at_s < all[all.size() - 2].at_s) {
      refuse(word, "it is earlier than the one before");
    }
  }
  return all;
}

PseudoTerminal::PseudoTerminal(std::int64_t clock_ps) : clock_ps_(clock_ps) {
  fd_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd_ < 0 || grantpt(fd_) != 0 || unlockpt(fd_) != 0) {
    if (fd_ >= 0) close(fd_);
    throw cosim::OptionsError("host.serial: this system gives no pseudo-terminal");
  }
  termios plain{};
  if (tcgetattr(fd_, &plain) == 0) {
    cfmakeraw(&plain);
    tcsetattr(fd_, TCSANOW, &plain);
  }
  forget();  // from here on the other end is known to be closed
  started_ns_ = wall_ns();
}

PseudoTerminal::~PseudoTerminal() { close(fd_); }

// Drops what waits at the other end.
void PseudoTerminal::forget() const {
  const int other = open(ptsname(fd_), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (other < 0) return;
  tcflush(other, TCIFLUSH);
  close(other);
}

// A program that has left did not read the rest, and the next one does not want it.
bool PseudoTerminal::opened() {
  pollfd other{fd_, 0, 0};
  const bool open = poll(&other, 1, 0) < 0 || (other.revents & POLLHUP) == 0;
  if (open_ && !open) forget();
  open_ = open;
  return open;
}

std::optional<unsigned char> PseudoTerminal::next(cosim::Clk edge) {
  const auto due = started_ns_ + edge * clock_ps_ / 1000;
  if (const std::int64_t early = due - wall_ns(); early > 1'000'000) {
    std::this_thread::sleep_for(std::chrono::nanoseconds(early));
  } else if (early < -kMostLate_ns) {
    started_ns_ -= early;
  }
  if (!named_ && edge * clock_ps_ / 1000 >= kBooted_ns) {
    named_ = true;
    std::fputs(fmt::format("trammel: the serial port is {}\n", ptsname(fd_)).c_str(), stderr);
  }
  opened();
  pollfd wanted{fd_, POLLIN, 0};
  unsigned char byte = 0;
  if (poll(&wanted, 1, 0) <= 0 || (wanted.revents & POLLIN) == 0) return std::nullopt;
  if (read(fd_, &byte, 1) != 1) return std::nullopt;
  return byte;
}

// So is what a program does not read.
void PseudoTerminal::take(unsigned char byte) {
  if (opened() && write(fd_, &byte, 1) != 1) forget();
}

}  // namespace trammel::gantry
