// SPDX-License-Identifier: Apache-2.0
//
// What a processor transfers; native firmware that is fed the same reads; a core that is recorded.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosim/core.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::test {

struct Transfer {
  cosim::Clk edge = 0;  // at which its answer is taken
  std::uint32_t address = 0, data = 0;
  bool write = false;
};

inline bool operator==(const Transfer& a, const Transfer& b) {
  return a.edge == b.edge && a.address == b.address && a.data == b.data && a.write == b.write;
}

inline std::string text(const Transfer& t) {
  return (t.write ? "write " : "read ") + std::to_string(t.data) + " at " +
         std::to_string(t.address) + ", edge " + std::to_string(t.edge);
}

inline std::vector<Transfer> writes_of(const std::vector<Transfer>& all) {
  std::vector<Transfer> writes;
  for (const Transfer& t : all) {
    if (t.write) writes.push_back(t);
  }
  return writes;
}

// A core that notes its transfers.
class RecordedCore final : public cosim::Core {
 public:
  explicit RecordedCore(cosim::Core& core) : core_(core) {}

  cosim::Clk now() const override { return core_.now(); }
  Asks asks() const override { return core_.asks(); }
  cosim::BusOp transfer() const override { return core_.transfer(); }
  void step() override { core_.step(); }
  void answer(std::uint32_t data) override {
    const cosim::BusOp op = core_.transfer();
    transfers.push_back({core_.now(), op.addr, op.write ? op.data : data, op.write});
    core_.answer(data);
  }
  void interrupt(bool level) override { core_.interrupt(level); }
  cosim::Clk still() override { return core_.still(); }
  void skip(cosim::Clk edge) override { core_.skip(edge); }
  std::optional<cosim::CoreTrap> trap() const override { return core_.trap(); }

  std::vector<Transfer> transfers;

 private:
  cosim::Core& core_;
};

// Native firmware on what a core transferred: its reads get the same words, and each of its
// transfers must be the next one of the core. Returns how many writes were equal.
class Replay final : public sw::Bus {
 public:
  explicit Replay(const std::vector<Transfer>& all) : all_(all) {}

  std::uint32_t read(std::uint32_t address) override { return next(address, 0, false).data; }
  void write(std::uint32_t address, std::uint32_t data) override { next(address, data, true); }

  std::size_t run(sw::Firmware& firmware) {
    try {
      firmware.start(*this);
      while (at_ < all_.size()) firmware.isr(*this);
    } catch (const Ended&) {  // the core was stopped in a routine
    }
    return writes_;
  }

 private:
  struct Ended {};

  const Transfer& next(std::uint32_t address, std::uint32_t data, bool write) {
    if (at_ == all_.size()) throw Ended();
    const Transfer& t = all_[at_++];
    if (t.address != address || t.write != write || (write && t.data != data)) {
      throw std::runtime_error("transfer " + std::to_string(at_ - 1) + " of the core: " + text(t) +
                               "; natively: " + text({t.edge, address, data, write}));
    }
    writes_ += write ? 1 : 0;
    return t;
  }

  const std::vector<Transfer>& all_;
  std::size_t at_ = 0, writes_ = 0;
};

}  // namespace trammel::test
