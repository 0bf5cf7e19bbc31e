// SPDX-License-Identifier: Apache-2.0
//
// What is at the other end of the serial port of kung_soc in a run: nothing, a file of commands,
// this terminal, or a pseudo-terminal.
#pragma once

#include <functional>
#include <string>

#include "cosim/serial_host.hpp"

namespace trammel::kung {

// The console of one run. A line of a file is sent when the one before was answered, or 0.2 s
// later; nothing before `listens()`.
class SerialConsole {
 public:
  // `from`: "-" the terminal, "pty" a pseudo-terminal, whose name is printed, or a file. Throws
  // OptionsError where there is no such file.
  SerialConsole(const std::string& from, std::function<bool()> listens);
  ~SerialConsole();
  SerialConsole(const SerialConsole&) = delete;
  SerialConsole& operator=(const SerialConsole&) = delete;

  cosim::SerialHost& host() { return host_; }
  const std::string& heard() const { return heard_; }

 private:
  std::optional<unsigned char> next(cosim::Clk edge);
  void take(unsigned char byte);

  std::function<bool()> listens_;
  int in_ = -1, out_ = -1;
  bool by_answer_ = false;  // a file: lines wait for answers
  bool asked_ = false;      // a line was sent and is not yet answered
  cosim::Clk asked_at_ = 0;
  std::string heard_;
  cosim::SerialHost host_;
};

}  // namespace trammel::kung
