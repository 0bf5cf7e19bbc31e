// SPDX-License-Identifier: Apache-2.0
//
// The engine of the LM628 beside its twin: commands and samples, results compared after each.
#pragma once

#include <Vlm628_engine.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/lm628_engine.hpp"
#include "tests/support/rtl.hpp"

namespace trammel::test {

using exact::Lm628Engine;
using exact::Opcode;

class EngineBench {
 public:
  EngineBench() {
    rtl_->sample_i = rtl_->start_i = rtl_->commit_i = rtl_->end_i = 0;
    rtl_->wrap_i = rtl_->arm_i = 0;
    rtl_->status_i = rtl_->host_irq_i = 0;
    rtl_->opcode_i = 0;
    rtl_->word_i = 0;
    rtl_->index_seen_i = 0;
    rtl_->count_i = rtl_->index_count_i = 0;
    reset();
  }

  Vlm628_engine* operator->() { return rtl_.operator->(); }
  const Lm628Engine& twin() const { return twin_; }
  int longest_sample() const { return longest_sample_; }    // [clk]
  int longest_command() const { return longest_command_; }  // [clk]

  std::int64_t count = 0;  // of the encoder, any size
  bool wrap = false;

  void reset() {
    rtl_.reset();
    twin_.reset();
    count = 0;
    armed_ = false;
    REQUIRE(rtl_->reply_o == 0);
    REQUIRE(rtl_->word_addr_o == 0);
    wait();
  }

  // Result of the sample: u, of which the events go with the commit.
  std::int64_t sample() {
    rtl_->wrap_i = wrap;
    rtl_->count_i = as_bits(count, 24);
    Lm628Engine::In in;
    in.sample = true;
    in.count = as_signed(rtl_->count_i, 24);
    in.wrap = wrap;
    rtl_->sample_i = 1;
    edge(in);
    rtl_->sample_i = 0;
    longest_sample_ = std::max(longest_sample_, wait());
    compare();
    Lm628Engine::In commit;
    commit.commit = true;
    rtl_->commit_i = 1;
    events = rtl_->sample_events_o << 1;
    edge(commit);
    rtl_->commit_i = 0;
    rtl_.eval();
    return twin_.output();
  }

  std::uint32_t command(Opcode opcode, Lm628Engine::Words words = {}) {
    Lm628Engine::In in;
    in.start = true;
    in.opcode = opcode;
    in.words = words_ = words;
    const unsigned status = ++commands_ % 64;  // bits 6 to 1
    const bool host_irq = commands_ / 64 % 2 == 0;
    in.flags = static_cast<std::uint16_t>(host_irq << 15 | status << 1);
    rtl_->opcode_i = static_cast<std::uint8_t>(opcode);
    rtl_->status_i = static_cast<std::uint8_t>(status);
    rtl_->host_irq_i = host_irq;
    rtl_->start_i = 1;
    edge(in);
    rtl_->start_i = 0;
    longest_command_ = std::max(longest_command_, wait());
    compare();
    events = rtl_->command_events_o << 1;
    Lm628Engine::In end;
    end.end = true;
    rtl_->end_i = 1;
    edge(end);
    rtl_->end_i = 0;
    rtl_.eval();
    return twin_.reply();
  }

  void arm_index() {
    Lm628Engine::In in;
    in.arm = true;
    rtl_->arm_i = 1;
    edge(in);
    rtl_->arm_i = 0;
    armed_ = true;
  }

  void index(std::int64_t at) {
    Lm628Engine::In in;
    in.index_seen = true;
    rtl_->index_count_i = as_bits(at, 24);
    in.index_count = as_signed(rtl_->index_count_i, 24);
    rtl_->index_seen_i = 1;
    edge(in);
    rtl_->index_seen_i = 0;
    armed_ = false;
  }

  void compare() {
    const Lm628Engine::Result sample = twin_.sample_result();
    const Lm628Engine::Result command = twin_.command_result();
    REQUIRE(rtl_->quiescent_o);
    REQUIRE(as_signed(rtl_->u_o, 16) == twin_.output());
    REQUIRE(bool(rtl_->eight_bits_o) == twin_.output_eight_bits());
    INFO("events are bits of the status byte: 1 command error, 2 trajectory complete, 3 index, 4 "
         "wraparound, 5 position error, 6 breakpoint; the RTL's and the twin's");
    REQUIRE(rtl_->sample_events_o << 1 == sample.events);
    REQUIRE(bool(rtl_->sample_off_o) == sample.off);
    REQUIRE(rtl_->command_events_o << 1 == command.events);
    REQUIRE(bool(rtl_->command_off_o) == command.off);
    REQUIRE(as_bits(rtl_->reply_o, reply_bits()) == as_bits(twin_.reply(), reply_bits()));
  }

  unsigned events = 0;  // status bits, of the last sample or command

 private:
  int reply_bits() const {
    const int words = exact::words_replied(rtl_opcode());
    if (words != 0) reply_bits_ = 16 * words;
    return reply_bits_;
  }
  std::uint8_t rtl_opcode() const { return const_cast<EngineBench*>(this)->rtl_->opcode_i; }

  void edge(const Lm628Engine::In& in) {
    rtl_.eval();
    const bool asked = in.sample || in.start || in.arm || (in.index_seen && armed_) ||
                       (in.end && rtl_->command_events_o != 0) ||
                       (in.commit && rtl_->sample_events_o != 0);
    if (bool(rtl_->quiescent_o) == (rtl_->busy_o || asked)) FAIL("quiescent_o is wrong");
    rtl_.tick();
    twin_.step(in);
  }

  int wait() {
    int clocks = 0;
    for (rtl_.eval(); rtl_->busy_o && clocks < 1000; ++clocks) {
      rtl_->word_i = words_[rtl_->word_addr_o];
      edge({});
    }
    return clocks;
  }

  Rtl<Vlm628_engine> rtl_;
  Lm628Engine twin_;
  Lm628Engine::Words words_{};
  mutable int reply_bits_ = 16;
  int longest_sample_ = 0, longest_command_ = 0;
  unsigned commands_ = 0;
  bool armed_ = false;  // for an index
};

}  // namespace trammel::test
