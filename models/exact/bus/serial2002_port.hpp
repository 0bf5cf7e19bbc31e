// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/bus/serial2002_port.sv.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/exact/bus/frame_fifo.hpp"
#include "models/exact/bus/serial2002_rx.hpp"
#include "models/exact/bus/serial2002_tx.hpp"
#include "models/exact/bus/serial_line.hpp"

namespace trammel::exact {

class Serial2002Port {
 public:
  struct In {
    bool rx = true;
    bool send = false;
    Frame frame;
    bool take = false;
    std::uint32_t gap = 0;  // [clk] 24 bits
  };

  explicit Serial2002Port(std::uint32_t clocks_per_bit = 434) : line_(clocks_per_bit) {}

  void reset() {
    line_.reset();
    rx_.reset();
    tx_.reset();
    in_.reset();
    out_.reset();
    malformed_ = 0;
  }

  bool tx() const { return line_.out().tx; }
  const FrameFifo& in() const { return in_; }    // received frames that wait
  const FrameFifo& out() const { return out_; }  // those to send
  bool idle() const { return tx_.idle(tx_in()); }
  std::uint32_t malformed() const { return malformed_; }

  void step(const In& in) {
    const Serial2002Rx::Out frame = rx_.out();
    const Serial2002Tx::In sends = tx_in();
    const Serial2002Tx::Out byte = tx_.out(sends);
    if (frame.malformed) malformed_ = std::min<std::uint32_t>(malformed_ + 1, 0xFFFF);
    in_.step({frame.valid, frame.frame, in.take});
    rx_.step(rx_in(in));
    out_.step({in.send, in.frame, byte.take});
    tx_.step(sends);
    line_.step({byte.send, byte.byte, in.rx});
  }

  bool quiescent(const In& in) const {
    const Serial2002Tx::In sends = tx_in();
    return !in.send && !in.take && tx_.quiescent(sends) &&
           rx_.quiescent(rx_in(in)) &&
           line_.quiescent({tx_.out(sends).send, 0, in.rx});
  }
  Gap next() const { return std::min(line_.next(), rx_.next()); }
  void advance(Gap n) {
    line_.advance(n);
    rx_.advance(n);
  }

 private:
  Serial2002Rx::In rx_in(const In& in) const {
    const SerialLine::Out line = line_.out();
    return {line.valid, line.bad, line.byte, in.gap};
  }
  Serial2002Tx::In tx_in() const { return {out_.waits(), out_.frame(), line_.out().busy}; }

  SerialLine line_;
  Serial2002Rx rx_;
  Serial2002Tx tx_;
  FrameFifo in_{8}, out_{32};
  std::uint32_t malformed_ = 0;
};

}  // namespace trammel::exact
