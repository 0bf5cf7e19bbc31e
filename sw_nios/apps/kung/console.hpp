// SPDX-License-Identifier: Apache-2.0
//
// Commands of the table's program on a serial line: one a line, words between blanks, numbers
// decimal. What it does not understand is answered by a line that begins with `?` and does nothing.
//
//   help                        the commands
//   path NAME [PASSES]          circle, window, star, square or line; drives off
//   start                       the path from its first point; drives off
//   stop                        drives off
//   gain AXIS NAME MANT EXP     x or y; kp, ki, kv, eta, kp_cur, ki_cur; mant 0..2047, exp -16..15;
//                               in effect at once while the drives are on
//   gains                       those in effect
//   r ADDRESS                   a register of the IC, decimal or 0x...; a multiple of 4 to 1020
//   status                      of the program, bytes lost on the line, last record of the log
//   log [COUNT]                 the last records, one a line
//
// Nothing is printed in the service routine: answers go into a ring that the main loop empties, and
// the log into it number by number whenever it is empty. Freestanding.
#pragma once

#include "sw_nios/apps/kung/kung.hpp"
#include "sw_nios/hal/text_ring.hpp"

namespace trammel::sw {

// The program with the set-up that it was made from; it is made anew when that changes.
class KungProgram {
 public:
  explicit KungProgram(const KungSetup& setup) : setup_(setup) { make(); }
  KungProgram(const KungProgram&) = delete;
  KungProgram& operator=(const KungProgram&) = delete;

  KungApp& app() { return *app_; }
  KungSetup& setup() { return setup_; }
  bool started() const { return started_; }

  void start(Bus& bus) {
    make();
    started_ = true;
    app_->start(bus);
  }
  void stop(Bus& bus) {
    started_ = false;
    app_->stop(bus);
  }

 private:
  void make();

  KungSetup setup_;
  alignas(KungApp) unsigned char place_[sizeof(KungApp)];
  KungApp* app_ = nullptr;
  bool started_ = false;
};

class Console {
 public:
  static constexpr std::uint32_t kLine = 48;  // longest command

  Console(KungProgram& program, Bus& bus) : program_(program), bus_(bus) {}

  void take(char byte);
  void lost(std::uint32_t bytes) { lost_ = bytes; }  // on the line so far, for the status
  // When the ring is empty: the next number of the log, if one is asked for. Together with a
  // service routine it takes less than a byte does on the line, so that no byte is lost.
  void pump();
  TextRing& ring() { return ring_; }
  bool printing() const { return log_left_ != 0; }

 private:
  struct Words {
    static constexpr std::uint32_t kMax = 6;
    std::array<const char*, kMax> at{};
    std::uint32_t count = 0;
  };

  void execute();
  bool command(const Words& words);
  bool choose_path(const Words& words);
  bool set_gain(const Words& words);
  bool read_register(const Words& words);
  void print_field();
  void status();
  void gains();
  bool refuse(const char* why);
  void say(const char* text);

  KungProgram& program_;
  Bus& bus_;
  TextRing ring_;
  std::array<char, kLine + 1> line_{};
  std::uint32_t length_ = 0;
  bool bad_ = false;  // the line holds a byte that no command has, or is too long
  std::uint32_t lost_ = 0;
  std::uint32_t log_at_ = 0, log_left_ = 0;
  std::uint32_t field_ = 0;  // of the line of the log that is being printed
};

}  // namespace trammel::sw
