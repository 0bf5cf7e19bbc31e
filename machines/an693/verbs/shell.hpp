// SPDX-License-Identifier: Apache-2.0
//
// Executes lines of `trammel lm628` on the simulated part with its motor, as a host at its port.
// Simulated time passes only while a line is executed.
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "machines/an693/session.hpp"
#include "machines/an693/verbs/script.hpp"

namespace trammel::an693 {

// A line that cannot be completed: a wait that took too long, a part that stays busy.
struct Halt : std::runtime_error {
  Halt(cosim::EndReason why, const std::string& line) : std::runtime_error(line), end(why) {}
  cosim::EndReason end;
};

struct Answer {
  std::string text;             // lines for stdout, or nothing
  nlohmann::ordered_json json;  // the line, when it was done, and what came back
  std::string note;             // for stderr, or nothing
};

class Shell {
 public:
  static constexpr cosim::Clk kResetClk = 75'000;  // 1.5 ms at 50 MHz

  // Strobes RST and waits until the part is ready. `stop` ends a wait. A default window of waves
  // begins with the first line unless a trigger says when.
  Shell(const Options& options, const std::atomic<bool>& stop);

  Answer execute(const Line& line);  // throws Halt

  Result result();  // of all that was executed

 private:
  double seconds() const;
  double seconds_at(cosim::Clk edge) const {
    return cosim::seconds_of(edge, bench_.period_ps());
  }
  cosim::Clk clocks(double seconds) const;
  void strobe_reset();
  void pass(cosim::Clk count);
  void go_on() const;
  void check_assertions() const;
  void command(const Line& line, Answer& answer);
  std::string port_note(const Line& line) const;
  void wait(const Line& line, Answer& answer);
  void tell(const Command& command, std::uint32_t bits, Answer& answer) const;
  void tell_status(Answer& answer);
  void tell_pins(Answer& answer) const;

  Options options_;
  const std::atomic<bool>& stop_;
  Bench bench_;
  cosim::DirectBus bus_;
  bool twelve_bits_ = false;  // PORT12 was given
};

}  // namespace trammel::an693
