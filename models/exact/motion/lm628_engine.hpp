// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/motion/lm628_engine.sv: registers, commands and the sample of the LM628 (data sheet
// SNVS781C, application note AN-693). A sample or a command is computed at the edge that begins it;
// the RTL takes up to 400 or 127 clocks, but shows none of it before the end.
#pragma once

#include <array>
#include <cstdint>

#include "models/exact/control/lm628_pid.hpp"
#include "models/exact/motion/lm628_opcode.hpp"
#include "models/exact/motion/trapezoid.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Lm628Engine {
 public:
  using Words = std::array<std::uint16_t, 8>;

  // Bits of the signals register that are held here; 1 to 6 are those of the status byte.
  struct Signals {
    bool acceleration_loaded = false;  // 14
    bool filter_pending = false;       // 13
    bool forward = false;              // 12
    bool velocity_mode = false;        // 11
    bool on_target = false;            // 10
    bool off_on_error = false;         // 9
    bool eight_bits = true;            // 8
    bool off = true;                   // 7
    bool index_armed = false;          // 0
  };

  struct In {
    bool sample = false;
    bool start = false;  // a command begins
    Opcode opcode = Opcode::kReset;
    Words words{};
    std::uint16_t flags = 0;  // status bits 1 to 6 and, in bit 15, the host interrupt
    bool commit = false;      // the sample's events are taken
    bool end = false;         // the command's events are taken
    std::int64_t count = 0;   // encoder, 24 bits
    bool arm = false;         // capture the next index
    bool index_seen = false;
    std::int64_t index_count = 0;
    bool wrap = false;  // products wrap
  };

  // What a sample or a command yields, shown at its end: its events as status bits 1 to 6.
  struct Result {
    std::uint8_t events = 0;
    bool off = true;
  };

  void reset() { *this = Lm628Engine(); }

  // One clock edge.
  void step(const In& in) {
    if (in.commit) sample_result_.events = 0;
    if (in.end) events_ = 0;
    if (in.start) reply_ = execute(in.opcode, in.words, in.flags);
    if (in.sample) {
      sample({in.count, captured_, captured_count_, in.wrap});
      captured_ = false;
    }
    if (in.arm) {
      capturing_ = true;
      captured_ = false;
    } else if (capturing_ && in.index_seen) {
      capturing_ = false;
      captured_ = true;
      captured_count_ = in.index_count;
    }
  }

  const Result& sample_result() const { return sample_result_; }
  Result command_result() const { return {events_, signals_.off}; }
  std::uint32_t reply() const { return reply_; }
  const Signals& signals() const { return signals_; }
  const Trapezoid::State& desired() const { return profile_.state; }
  std::int64_t actual() const { return actual_; }
  std::int64_t error() const { return error_; }
  std::int64_t output() const { return output_; }  // 16 bits, of the last sample
  const Lm628Pid& pid() const { return pid_; }
  const Lm628Pid::Config& filter() const { return filter_; }  // in use, not the buffers
  bool output_eight_bits() const { return output_eight_; }
  bool moving() const { return moving_; }

  struct Sample {
    std::int64_t count = 0;  // encoder, 24 bits
    bool index = false;      // an index was captured since the last sample
    std::int64_t index_count = 0;
    bool wrap = false;
  };

  void sample(const Sample& in) {
    if (signals_.filter_pending) take_filter(in.wrap);
    const std::int64_t before = actual_;
    velocity_ = fixed::wrap(in.count - count_, 24);
    count_ = in.count;
    actual_ = fixed::wrap(actual_ + velocity_, 32);
    if (in.index) {
      index_ = fixed::wrap(actual_ + fixed::wrap(in.index_count - in.count, 24), 32);
      signals_.index_armed = false;
      event(kIndex);
    }
    if (reported(actual_) != reported(before) + velocity_) event(kWraparound);
    generate();
    error_ = fixed::sat(profile_.count() - actual_, 16);
    if (!signals_.off && std::abs(error_) > threshold_) {
      event(kPositionError);
      if (signals_.off_on_error) turn_off();
    }
    if (armed_ && side_ * (actual_ - breakpoint_) >= 0) {
      armed_ = false;
      event(kBreakpoint);
    }
    filter_.wrap = in.wrap;
    if (signals_.off) pid_.reset();
    output_ = signals_.off ? 0 : pid_.step(filter_, error_);
    output_eight_ = signals_.eight_bits;
    signals_.filter_pending = false;
    sample_result_ = {events_, signals_.off};
    events_ = 0;
  }

  // Executes a command. Returns its reply, 16 or 32 bits, or else the previous one.
  std::uint32_t execute(Opcode opcode, const Words& words, std::uint16_t flags) {
    switch (opcode) {
      case Opcode::kStt:
        start();
        break;
      case Opcode::kDfh:
        define_home();
        break;
      case Opcode::kSip:
        signals_.index_armed = true;
        break;
      case Opcode::kUdf:
        signals_.filter_pending = true;
        break;
      case Opcode::kPort8:
        signals_.eight_bits = true;
        break;
      case Opcode::kPort12:
        signals_.eight_bits = false;
        break;
      case Opcode::kRddv:
        return low(profile_.state.speed, 32);
      case Opcode::kRddp:
        return low(reported(profile_.count()), 32);
      case Opcode::kRdip:
        return low(reported(index_), 32);
      case Opcode::kRdrp:
        return low(reported(actual_), 32);
      case Opcode::kRdrv:
        return low(velocity_, 16);
      case Opcode::kRdsigs:
        return signals_word(flags);
      case Opcode::kRdsum:
        return low(pid_.sum(), 16);
      case Opcode::kLpes:
      case Opcode::kLpei:
        threshold_ = words[0] & 0x7FFF;
        signals_.off_on_error = opcode == Opcode::kLpes;
        break;
      case Opcode::kLfil:
        load_filter(words);
        break;
      case Opcode::kLtrj:
        load_trajectory(words);
        break;
      case Opcode::kSbpa:
        arm(long_word(words, 0));
        break;
      case Opcode::kSbpr:
        arm((signals_.velocity_mode ? profile_.count() : profile_.state.target) +
            long_word(words, 0));
        break;
      default:
        break;  // RESET, MSKI and RSTI concern the host port alone
    }
    return reply_;
  }

 private:
  static constexpr std::int64_t kMask30 = (std::int64_t{1} << 30) - 1;

  struct Buffer {
    std::int64_t acceleration = 0, velocity = 0, position = 0;
    bool relative = false;  // the next STT adds the position to the target
  };

  // A position as the host reads it, in the data sheet's range.
  static std::int64_t reported(std::int64_t x) { return fixed::wrap(x, 31); }

  static std::uint32_t low(std::int64_t x, int bits) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) &
                                      ((std::uint64_t{1} << bits) - 1));
  }

  static std::int64_t long_word(const Words& words, std::size_t n) {
    return fixed::wrap((std::int64_t{words[n]} << 16) + words[n + 1], 32);
  }

  void event(int bit) { events_ = static_cast<std::uint8_t>(events_ | 1u << bit); }

  void turn_off() {
    if (!signals_.off) event(kTrajectoryComplete);
    signals_.off = true;
    moving_ = false;
  }

  void take_filter(bool wrap) {
    filter_ = filter_buffer_;
    filter_.wrap = wrap;
    pid_.renew(filter_);
  }

  void generate() {
    if (signals_.off) {
      profile_.state.position = fixed::shift_left(actual_, 16);
      profile_.state.speed = 0;
      return;
    }
    profile_config_.forward = signals_.forward;
    if (!moving_ || !profile_.step(profile_config_)) return;
    moving_ = false;
    signals_.on_target = true;
    event(kTrajectoryComplete);
  }

  void start() {
    const bool waits = moving_ && signals_.acceleration_loaded;
    if (waits && (control_ & kStops) == 0) {
      event(kCommandError);
      return;
    }
    Trapezoid::State& desired = profile_.state;
    const bool velocity_mode = (control_ & kVelocityMode) != 0;
    if (!velocity_mode) {
      if (buffer_.relative) {
        const std::int64_t base = signals_.velocity_mode ? profile_.count() : desired.target;
        buffer_.position = fixed::wrap(buffer_.position + base, 32);
      }
      buffer_.relative = false;
      desired.target = buffer_.position;
    }
    if (!waits) {
      profile_config_.acceleration = buffer_.acceleration;
      signals_.acceleration_loaded = false;
    }
    profile_config_.velocity = buffer_.velocity;
    profile_config_.mode = velocity_mode ? Trapezoid::Mode::kVelocity : Trapezoid::Mode::kPosition;
    signals_.on_target = false;
    signals_.velocity_mode = velocity_mode;
    signals_.forward = (control_ & kForward) != 0;
    if ((control_ & kStopOff) != 0) {
      turn_off();
    } else {
      signals_.off = false;
      moving_ = true;
      if ((control_ & kStopAbruptly) != 0) {
        desired = {fixed::shift_left(actual_, 16), 0, actual_};
        profile_config_.mode = Trapezoid::Mode::kPosition;
      } else if ((control_ & kStopSmoothly) != 0) {
        profile_config_.mode = Trapezoid::Mode::kSmoothStop;
      }
    }
    control_ = static_cast<std::uint16_t>(control_ & ~kStops);
  }

  void define_home() {
    Trapezoid::State& desired = profile_.state;
    desired.position = fixed::wrap(desired.position - fixed::shift_left(actual_, 16), 48);
    desired.target = fixed::wrap(desired.target - actual_, 32);
    breakpoint_ = fixed::wrap(breakpoint_ - actual_, 32);
    actual_ = 0;
  }

  void load_filter(const Words& words) {
    std::size_t next = 1;
    const auto load = [&](unsigned bit, std::int64_t& value) {
      if ((words[0] >> bit & 1u) != 0) value = words[next++] & 0x7FFF;
    };
    filter_buffer_.interval = words[0] >> 8;
    load(3, filter_buffer_.kp);
    load(2, filter_buffer_.ki);
    load(1, filter_buffer_.kd);
    load(0, filter_buffer_.il);
  }

  void load_trajectory(const Words& words) {
    control_ = words[0];
    std::size_t next = 1;
    const auto loads = [&](unsigned bit) { return (control_ >> bit & 1u) != 0; };
    const auto take = [&] {
      next += 2;
      return long_word(words, next - 2);
    };
    if (loads(5)) {
      buffer_.acceleration = (take() + (loads(4) ? buffer_.acceleration : 0)) & kMask30;
      signals_.acceleration_loaded = true;
    }
    if (loads(3)) buffer_.velocity = (take() + (loads(2) ? buffer_.velocity : 0)) & kMask30;
    if (loads(1)) {
      buffer_.position = take();
      buffer_.relative = loads(0);
    }
  }

  void arm(std::int64_t position) {
    breakpoint_ = fixed::wrap(position, 32);
    side_ = breakpoint_ > actual_ ? 1 : breakpoint_ < actual_ ? -1 : 0;
    armed_ = true;
  }

  std::uint16_t signals_word(std::uint16_t flags) const {
    const Signals& s = signals_;
    const auto bit = [](bool value, int n) { return static_cast<unsigned>(value) << n; };
    return static_cast<std::uint16_t>(
        (flags & 0x807Eu) | bit(s.acceleration_loaded, 14) | bit(s.filter_pending, 13) |
        bit(s.forward, 12) | bit(s.velocity_mode, 11) | bit(s.on_target, 10) |
        bit(s.off_on_error, 9) | bit(s.eight_bits, 8) | bit(s.off, 7) | bit(s.index_armed, 0));
  }

  Trapezoid profile_;
  Trapezoid::Config profile_config_;
  Lm628Pid pid_;
  Lm628Pid::Config filter_, filter_buffer_;
  Buffer buffer_;
  Signals signals_;
  std::uint16_t control_ = 0;  // of the last LTRJ
  std::uint8_t events_ = 0;
  Result sample_result_;
  std::uint32_t reply_ = 0;
  bool capturing_ = false, captured_ = false;
  std::int64_t captured_count_ = 0;
  bool moving_ = false;
  bool armed_ = false;  // breakpoint
  std::int64_t side_ = 0, breakpoint_ = 0;
  std::int64_t count_ = 0;  // encoder at the last sample
  std::int64_t actual_ = 0, velocity_ = 0, index_ = 0, error_ = 0;
  std::int64_t threshold_ = 0x7FFF;
  std::int64_t output_ = 0;
  bool output_eight_ = true;
};

}  // namespace trammel::exact
