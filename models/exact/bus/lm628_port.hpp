// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/bus/lm628_port.sv.
#pragma once

#include <array>
#include <cstdint>

#include "models/exact/math/timer.hpp"
#include "models/exact/motion/lm628_opcode.hpp"
#include "models/exact/motion/lm628_time.hpp"

namespace trammel::exact {

class Lm628Port {
 public:
  struct Pins {
    bool cs_n = true, rd_n = true, wr_n = true, ps = false;
    std::uint8_t d = 0;

    bool operator==(const Pins& o) const {
      return cs_n == o.cs_n && rd_n == o.rd_n && wr_n == o.wr_n && ps == o.ps && d == o.d;
    }
    bool reads() const { return !cs_n && !rd_n; }
    bool writes() const { return !cs_n && !wr_n; }
  };

  // What a sample or a command yields, shown at its end.
  struct Result {
    std::uint8_t events = 0;  // status bits 1 to 6
    bool off = true;
  };

  struct In {
    Pins pins;
    bool ready = false;   // not in the reset routine
    bool open = false;    // a command may begin
    bool commit = false;  // the end of a sample
    Result sample, command;
    std::uint32_t reply = 0;
  };

  explicit Lm628Port(Lm628Clock clock = Lm628Clock::k8MHz) : clock_(clock) {}

  // Synchronisers and words have no reset. After a command RESET the routine shows busy.
  void reset(bool by_command) {
    Lm628Port fresh(clock_);
    fresh.meta_ = meta_;
    fresh.sync_ = sync_;
    fresh.prev_ = prev_;
    fresh.words_ = words_;
    fresh.by_command_ = by_command;
    *this = fresh;
  }

  // At the present edge: the command RESET is taken; a command begins; one ends.
  bool restarts(const In& in) const {
    return in.ready && command_written() && state_ == State::kIdle && prev_.d == 0;
  }
  bool starts(const In& in) const {
    return in.open && executes_ &&
           (state_ == State::kWait || (state_ == State::kBusy && timer_.count() == 0));
  }
  bool ends() const { return state_ == State::kRun && executes_ && timer_.count() == 0; }
  bool publishes(const In& in) const { return in.commit || ends(); }
  bool arms_index() const { return ends() && opcode_ == static_cast<std::uint8_t>(Opcode::kSip); }

  std::uint8_t opcode() const { return opcode_; }
  const std::array<std::uint16_t, 8>& words() const { return words_; }
  // Status bits 1 to 6 and, in bit 15, the host interrupt, as they will be published.
  std::uint16_t flags(const In& in) const {
    const bool hi = hi_ || (in.sample.events & mask_) != 0;
    return static_cast<std::uint16_t>((hi ? 0x8000u : 0u) | status_ | in.sample.events);
  }

  std::uint8_t d() const { return d_; }
  bool d_oe() const { return prev_.reads(); }
  bool hi() const { return hi_; }

  std::uint8_t status(const In& in) const {
    if (!in.ready) return by_command_ ? 1 : 0;
    return static_cast<std::uint8_t>((off_ ? 0x80u : 0u) | status_ |
                                     (state_ != State::kIdle ? 1u : 0u));
  }

  bool quiescent(const In& in) const {
    return in.pins == meta_ && meta_ == sync_ && sync_ == prev_ && !publishes(in) &&
           (state_ == State::kIdle || (state_ == State::kWait ? !in.open : timer_.count() != 0));
  }
  Gap next() const { return timer_.next({false, 0}); }
  void advance(Gap n) { timer_.advance(n); }

  void step(const In& in) {
    const State before = state_;
    const bool last = timer_.count() == 0;
    timer_.step({});
    bool error = false;
    if (written()) {
      if (before == State::kIdle && in.ready) error = prev_.ps ? write_data() : write_command();
    } else if (sync_.reads() && !prev_.reads()) {
      error = read(in);
    }
    if (before == State::kBusy && last) executes_ && !in.open ? wait() : run();
    if (before == State::kWait && in.open) run();
    publish(in, before == State::kRun && last);
    if (error) raise(1u << kCommandError);
    prev_ = sync_;
    sync_ = meta_;
    meta_ = in.pins;
  }

 private:
  enum class State { kIdle, kBusy, kWait, kRun };

  bool written() const { return prev_.writes() && !sync_.writes(); }
  bool command_written() const { return written() && !prev_.ps; }

  void raise(unsigned events) {
    status_ = static_cast<std::uint8_t>(status_ | events);
    if ((events & mask_) != 0) hi_ = true;
  }

  void be_busy() {
    state_ = State::kBusy;
    timer_.step({true, lm628_clocks(clock_, 160) - kLm628Run - 1});
  }
  void wait() { state_ = State::kWait; }
  void run() {
    state_ = State::kRun;
    timer_.step({true, kLm628Run - 1});
  }

  void publish(const In& in, bool ends) {
    if (in.commit) {
      off_ = in.sample.off;
      raise(in.sample.events);
    }
    if (!ends) return;
    state_ = State::kIdle;
    if (!executes_) return;
    off_ = in.command.off;
    raise(in.command.events);
    left_ = words_replied(opcode_);
    if (opcode_ == static_cast<std::uint8_t>(Opcode::kRsti)) {
      status_ = static_cast<std::uint8_t>(status_ & low_);
      hi_ = false;
    }
    if (opcode_ == static_cast<std::uint8_t>(Opcode::kMski)) mask_ = low_ & 0x7E;
  }

  // These three return whether the host made an error.

  bool write_command() {
    const bool error = due_ != 0 || left_ != 0 || !is_known(prev_.d);
    half_written_ = half_read_ = false;
    left_ = 0;
    opcode_ = prev_.d;
    due_ = words_due(opcode_);
    next_ = 0;
    executes_ = due_ == 0 && is_known(opcode_);
    be_busy();
    return error;
  }

  bool write_data() {
    if (due_ == 0) return true;
    if (half_written_) {
      const auto word = static_cast<std::uint16_t>(high_ << 8 | prev_.d);
      low_ = prev_.d;
      words_[next_] = word;
      due_ += (next_ == 0 ? words_after_control(opcode_, word) : 0) - 1;
      ++next_;
      executes_ = due_ == 0;
      be_busy();
    } else {
      high_ = prev_.d;
    }
    half_written_ = !half_written_;
    return false;
  }

  bool read(const In& in) {
    const bool idle = state_ == State::kIdle && in.ready;
    if (!sync_.ps) {
      d_ = status(in);
      return false;
    }
    if (idle && left_ != 0) {
      const int shift = (left_ == 2 ? 16 : 0) + (half_read_ ? 0 : 8);
      last_ = static_cast<std::uint8_t>(in.reply >> shift);
      if (half_read_) {
        executes_ = false;
        be_busy();
      }
    }
    d_ = last_;
    if (!idle) return false;
    const bool error = left_ == 0;
    if (!error && half_read_) --left_;
    if (!error) half_read_ = !half_read_;
    return error;
  }

  Lm628Clock clock_;
  Pins meta_, sync_, prev_;
  Timer timer_;
  State state_ = State::kIdle;
  bool by_command_ = false;
  bool executes_ = false;  // the busy time ends with the execution of a command
  std::uint8_t opcode_ = 0;
  std::array<std::uint16_t, 8> words_{};
  int due_ = 0;   // words to be written
  int left_ = 0;  // words of the reply to be read
  std::size_t next_ = 0;
  bool half_written_ = false, half_read_ = false;
  std::uint8_t high_ = 0, low_ = 0, last_ = 0, d_ = 0;
  std::uint8_t status_ = 1u << kTrajectoryComplete;  // bits 1 to 6
  std::uint8_t mask_ = 0x3E;
  bool off_ = true, hi_ = false;
};

}  // namespace trammel::exact
