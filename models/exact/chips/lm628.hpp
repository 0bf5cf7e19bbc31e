// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/chips/lm628.sv, pin by pin and clock by clock. step() is one edge; while quiescent()
// holds, advance(n) passes n <= next() of them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/exact/bus/lm628_port.hpp"
#include "models/exact/drive/lm628_output.hpp"
#include "models/exact/motion/lm628_engine.hpp"
#include "models/exact/motion/lm628_time.hpp"
#include "models/exact/sense/qep.hpp"

namespace trammel::exact {

class Lm628 {
 public:
  struct In {
    Lm628Port::Pins host;
    bool reset_n = true;
    bool a = false, b = false, index_n = true;  // encoder
    bool wrap = false;                          // products wrap instead of saturating
  };

  struct Out {
    std::uint8_t d = 0;
    bool d_oe = false;
    bool hi = false;
    Lm628Output::Out drive;
  };

  explicit Lm628(Lm628Clock clock = Lm628Clock::k8MHz)
      : time_(clock), port_(clock), output_(output_config(clock)) {}

  // The reset of all blocks; the synchronisers of this pin and of the port have none.
  void reset() { restart(false); }

  Out out() const { return {port_.d(), port_.d_oe(), port_.hi(), output_.out()}; }
  const Lm628Engine& engine() const { return engine_; }
  std::uint8_t status() const { return port_.status(host_in({})); }
  bool samples() const { return time_.sample(); }  // at the present edge
  bool commits() const { return time_.commit(); }

  void step(const In& in) {
    const Lm628Port::In host = host_in(in);
    const Lm628Engine::In work = work_in(in, host);
    const bool by_command = port_.restarts(host);
    const bool restarts = !reset_n_sync_ || by_command;
    const Lm628Output::In result = output_in();
    qep_.step(qep_in(in, work.arm));
    encoder_sync_ = encoder_meta_;
    encoder_meta_ = encoder(in);
    port_.step(host);
    time_.step();
    output_.step(result);
    engine_.step(work);
    if (restarts) restart(by_command);
    reset_n_sync_ = reset_n_meta_;
    reset_n_meta_ = in.reset_n;
  }
  bool quiescent(const In& in) const {
    const Lm628Port::In host = host_in(in);
    return in.reset_n && reset_n_meta_ && reset_n_sync_ && time_.quiescent() &&
           port_.quiescent(host) && output_.quiescent(output_in()) &&
           qep_.quiescent(qep_in(in, false)) && encoder(in) == encoder_meta_ &&
           encoder_meta_ == encoder_sync_;
  }

  Gap next(const In& in) const {
    if (!quiescent(in)) return 0;
    return std::min({time_.next(), port_.next(), output_.next(output_in())});
  }

  void advance(Gap n) {
    time_.advance(n);
    port_.advance(n);
    output_.advance(n);
  }

 private:
  static Lm628Output::Config output_config(Lm628Clock clock) {
    return {lm628_clocks(clock, 8), lm628_clocks(clock, 512), static_cast<std::uint32_t>(clock)};
  }

  void restart(bool by_command) {
    time_.reset();
    port_.reset(by_command);
    qep_.reset();
    output_.reset();
    engine_.reset();
  }

  Lm628Port::In host_in(const In& in) const {
    const Lm628Engine::Result& sample = engine_.sample_result();
    const Lm628Engine::Result command = engine_.command_result();
    return {in.host,
            time_.ready(),
            time_.open(),
            time_.commit(),
            {sample.events, sample.off},
            {command.events, command.off},
            engine_.reply()};
  }

  Lm628Engine::In work_in(const In& in, const Lm628Port::In& host) const {
    const Qep::Out& encoder = qep_.out();
    Lm628Engine::In work;
    work.sample = time_.sample();
    work.start = port_.starts(host);
    work.opcode = static_cast<Opcode>(port_.opcode());
    work.words = port_.words();
    work.flags = port_.flags(host);
    work.commit = time_.commit();
    work.end = port_.ends();
    work.count = encoder.count;
    work.arm = port_.arms_index();
    work.index_seen = encoder.index_seen;
    work.index_count = encoder.index_latch;
    work.wrap = in.wrap;
    return work;
  }

  Lm628Output::In output_in() const {
    return {time_.commit(), static_cast<std::int32_t>(engine_.output()),
            engine_.output_eight_bits()};
  }

  static unsigned encoder(const In& in) {
    return (in.a ? 4u : 0u) | (in.b ? 2u : 0u) | (in.index_n ? 1u : 0u);
  }

  // The index counts where both lines are low too; each line first passes two flip-flops.
  Qep::In qep_in(const In& in, bool clear) const {
    Qep::In qep;
    qep.a = in.a;
    qep.b = in.b;
    qep.z = encoder_sync_ == 0;
    qep.filter = 1;
    qep.preset = time_.begins();
    qep.clear_error = clear;
    return qep;
  }

  Lm628Time time_;
  Lm628Port port_;
  Lm628Output output_;
  Qep qep_;
  Lm628Engine engine_;
  bool reset_n_meta_ = false, reset_n_sync_ = false;
  unsigned encoder_meta_ = 0, encoder_sync_ = 0;
};

}  // namespace trammel::exact
