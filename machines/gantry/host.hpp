// SPDX-License-Identifier: Apache-2.0
//
// The other end of the serial line: a list of what is sent and when, or a pseudo-terminal.
//   0.1:21=305     at 0.1 s the value 305 on channel 21
//   0.2:31?        a poll of channel 31; 0.2:d0? of the digital input 0
//   0.3:x8A49      these bytes as they are
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cosim/serial_host.hpp"

namespace trammel::gantry {

struct Sent {
  double at_s = 0;
  std::vector<unsigned char> bytes;
};

// A value as Serial2002 sends it; see models/exact/bus/serial2002_tx.hpp for the chip's own.
std::vector<unsigned char> frame_of(std::uint32_t channel, std::uint32_t value);

// Throws host::ConfigError that names the word. `checked`: the checksum of each frame follows it,
// except for bytes as they are.
std::vector<Sent> read_sends(const std::string& text, bool checked = false);

// What is wrong with the line to the chip.
struct LineConfig {
  double baud_error = 0;      // share by which the host's baud rate is too high, either way
  double framing_errors = 0;  // share of the host's bytes whose stop bit is low, evenly spread
};

// Bytes of the line from the chip, from the edges at which it moves.
class LineReader {
 public:
  explicit LineReader(cosim::Clk clocks_per_bit) : bit_(clocks_per_bit) {}

  // The line is `level` from edge n on. True with a byte that has ended before n.
  template <class Sink>
  void see(cosim::Clk n, bool level, Sink&& sink) {
    while (left_ > 0 && at_ < n) {
      shift_ = shift_ >> 1 | (level_ ? 1u << 9 : 0);
      at_ += bit_;
      if (--left_ == 0 && level_) sink(static_cast<unsigned char>(shift_ >> 1 & 0xFFu));
    }
    if (left_ == 0 && level_ && !level) {
      left_ = 10;
      at_ = n + bit_ / 2;
    }
    level_ = level;
  }

 private:
  cosim::Clk bit_, at_ = 0;
  int left_ = 0;
  unsigned shift_ = 0;
  bool level_ = true;
};

// A pseudo-terminal whose name is printed on stderr once the chip has booted, 2 ms after its
// start: the reset message is then gone. Simulated time waits for that of the wall, and
// makes up for 50 ms at most where it is late. What the chip sends while no program has the port
// open is lost, as on a line.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(std::int64_t clock_ps);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  std::optional<unsigned char> next(cosim::Clk edge);
  void take(unsigned char byte);

 private:
  bool opened();
  void forget() const;

  int fd_ = -1;
  bool named_ = false;
  bool open_ = false;  // some program has the other end
  std::int64_t clock_ps_, started_ns_ = 0;
};

}  // namespace trammel::gantry
