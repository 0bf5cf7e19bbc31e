// SPDX-License-Identifier: Apache-2.0
//
// What surrounds larson_xy, whoever evaluates it: the registers of its platform, the tick of the
// record, and the bridge between a processor whose every access is of 32 bits and the words of 16
// bits: each has an address of its own there, and is half of the chip's bus, as its bytes have.
#pragma once

#include "cosim/processor_bus.hpp"
#include "machines/larson/chip.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::larson {

struct Surroundings : cosim::ProcessorBus {
  explicit Surroundings(const ChipSetup& setup = {}) { ticks = {setup.sample_clk, kLook}; }

  // Of a transfer of the chip: its bytes, and address and data in their place.
  bool half() const { return op.addr < sw::larson_map::kVector; }
  bool byte() const { return op.addr >= sw::larson_map::kBytes; }
  int shift() const {
    if (byte()) return static_cast<int>(op.addr / 4 & 3) * 8;
    return half() && (op.addr & 4) != 0 ? 16 : 0;
  }
  unsigned bytes() const { return (byte() ? 1u : half() ? 3u : 15u) << shift() / 8; }
  cosim::BusOp placed() const {
    const std::uint32_t addr = byte() ? op.addr / 4 : op.addr / 2;
    return {(byte() ? addr & 4u : addr & ~3u), op.data << shift(), op.write};
  }
  void answer(std::uint32_t data) {
    rdata = byte() ? data >> shift() & 0xFF : half() ? data >> shift() & 0xFFFF : data;
  }
};

}  // namespace trammel::larson
