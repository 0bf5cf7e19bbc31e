// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/chips/larson_xy.sv, clock by clock, with one bus transfer at a time. step() is one
// edge; while quiescent() holds, advance(n) passes n <= next() of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "models/exact/motion/step_table.hpp"
#include "models/pins/port.hpp"

namespace trammel::exact {

class LarsonXy {
 public:
  struct In {  // pins, bit 0 X, bit 1 Y
    std::uint8_t limit_low_i = 0, limit_high_i = 0, buf_busy_i = 0;
  };
  struct Out {
    std::uint8_t step_o = 0, forward_o = 0, flush_o = 0;
  };

  static constexpr std::uint32_t kVector = 0x8;  // byte addresses
  static constexpr std::uint32_t kErrByte = 0xC;

  explicit LarsonXy(std::uint32_t inc = 3, std::uint32_t mod = 625, bool buffered = true)
      : table_(inc, mod, buffered) {}

  void reset() {
    table_.reset();
    phase_ = 0;
    read_data_ = 0;
  }

  const StepTable& table() const { return table_; }
  Out out() const {
    const StepChannel::Out x = table_.axis(0), y = table_.axis(1);
    return {both(x.step, y.step), both(x.forward, y.forward), both(x.flush, y.flush)};
  }
  bool irq() const { return table_.irq(); }

  // Valid from the present edge on; one at a time. A write is of these bytes of the 32 bits.
  void request(std::uint32_t address, std::uint32_t data, bool write, unsigned bytes = 15) {
    address_ = address & 0xC;
    data_ = data;
    write_ = write;
    bytes_ = bytes;
    phase_ = 1;
  }
  bool open() const { return phase_ != 0; }
  std::uint32_t read_data() const { return read_data_; }

  void step(const In& in) {
    const bool acts = phase_ == 2;
    if (acts && !write_) read_data_ = read();
    table_.step(table_in(in, acts));
    if (phase_ != 0) phase_ = phase_ == kEdges ? 0 : phase_ + 1;
  }

  bool quiescent(const In& in) const {
    return phase_ == 0 && table_.quiescent(table_in(in, false));
  }

  Gap next(const In& in) const { return quiescent(in) ? table_.next() : 0; }

  void advance(Gap n) { table_.advance(n); }

 private:
  static constexpr int kEdges = 3;  // of a transfer: taken, acts, answered

  StepTable::In table_in(const In& in, bool acts) const {
    StepTable::In table;
    for (int k = 0; k < 2; ++k) {
      table.pins[static_cast<std::size_t>(k)] = {
          level(in.limit_low_i, k), level(in.limit_high_i, k), level(in.buf_busy_i, k)};
    }
    if (!acts) return table;
    table.write = write_ && address_ < kVector;
    table.grant = !write_ && address_ == kVector;
    table.y = address_ == 4;
    table.bytes = bytes_;
    table.data = data_;
    return table;
  }

  std::uint32_t read() const {
    if (address_ < kVector) return table_.words(address_ / 4);
    return address_ == kVector ? table_.vector() : table_.err_byte();
  }

  StepTable table_;
  std::uint32_t address_ = 0, data_ = 0, read_data_ = 0;
  unsigned bytes_ = 15;
  bool write_ = false;
  int phase_ = 0;  // of the transfer
};

}  // namespace trammel::exact
