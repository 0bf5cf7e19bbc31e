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

// A line that cannot be ended: a wait that took too long, a part that stays busy. One line of text.
struct Lm628Halt : std::runtime_error {
  Lm628Halt(cosim::EndReason why, const std::string& text) : std::runtime_error(text), end(why) {}
  cosim::EndReason end;
};

struct Lm628Answer {
  std::string text;             // lines for stdout, or nothing
  nlohmann::ordered_json json;  // the line, when it was done, and what came back
  std::string note;             // for stderr, or nothing
};

class Lm628Shell {
 public:
  static constexpr cosim::Clk kResetClk = 75'000;  // 1.5 ms at 50 MHz

  // Strobes RST and waits until the part is ready. `stop` ends a wait. A default window of waves
  // begins with the first line, where no trigger says when.
  Lm628Shell(const Options& options, const std::atomic<bool>& stop);

  Lm628Answer execute(const Lm628Line& line);  // throws Lm628Halt

  Result result();  // of all that was executed

 private:
  double seconds() const;
  cosim::Clk clocks(double seconds) const;
  void strobe_reset();
  void pass(const std::string& where, cosim::Clk count);
  void go_on(const std::string& where) const;
  void look_at_promises(const std::string& where) const;
  void command(const Lm628Line& line, Lm628Answer& answer);
  void wait(const Lm628Line& line, Lm628Answer& answer);
  void tell(const Lm628Word& word, std::uint32_t bits, Lm628Answer& answer) const;
  void tell_status(const std::string& where, Lm628Answer& answer);
  void tell_pins(Lm628Answer& answer) const;

  Options options_;
  const std::atomic<bool>& stop_;
  Bench bench_;
  cosim::DirectBus bus_;
  bool twelve_bits_ = false;  // PORT12 was given
};

}  // namespace trammel::an693
