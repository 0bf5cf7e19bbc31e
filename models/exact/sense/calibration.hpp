// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/sense/calibration.sv.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/sense/sincos_observer.hpp"

namespace trammel::exact {

// CRC-16/CCITT-FALSE with one more byte: 0x1021, from 0xFFFF, no reflection.
constexpr std::uint16_t crc16(std::uint16_t check, std::uint8_t byte) {
  std::uint32_t value = check ^ (std::uint32_t{byte} << 8);
  for (int k = 0; k < 8; ++k) value = (value << 1) ^ ((value & 0x8000) != 0 ? 0x1021u : 0u);
  return static_cast<std::uint16_t>(value);
}

// Of a word, low byte first.
constexpr std::uint16_t crc16_word(std::uint16_t check, std::uint16_t word) {
  return crc16(crc16(check, static_cast<std::uint8_t>(word & 0xFF)),
               static_cast<std::uint8_t>(word >> 8));
}

// With the checksum of its words.
inline Calibration sealed(Calibration calib) {
  std::uint16_t check = 0xFFFF;
  for (std::size_t k = 0; k < Calibration::kWords; ++k) check = crc16_word(check, calib.words[k]);
  calib.words[Calibration::kWords] = check;
  return calib;
}

class CalibrationStore {
 public:
  struct In {
    bool write = false;  // a command
    std::uint32_t command = 0;
    std::uint16_t word = 0;
    bool reads = false;  // the reader is at work
    bool nv_ready = true;
    std::uint16_t nv_data = 0;
  };
  struct Out {
    bool nv_valid = true, nv_write = false;
    std::uint32_t nv_addr = 0;
    std::uint16_t nv_data = 0;
  };

  void reset() {
    const auto banks = banks_;
    *this = CalibrationStore();
    banks_ = banks;
  }

  const Calibration& data() const { return banks_[bank_]; }
  bool valid() const { return valid_; }
  bool busy() const { return state_ != State::kReady; }
  std::uint32_t count() const { return count_; }

  Out out() const {
    const bool stores = state_ == State::kStore;
    return {stores || state_ == State::kLoad, stores, stores ? saved_ : count_,
            stores ? fetched_ : std::uint16_t{0}};
  }
  // Pulses of the present edge.
  bool stored(const In& in) const {
    return state_ == State::kStore && in.nv_ready && saved_ == Calibration::kWords;
  }
  bool refused() const { return state_ == State::kCheck && !good(); }

  void step(const In& in) {
    switch (state_) {
      case State::kLoad:
        if (!in.nv_ready) break;
        take(in.nv_data);
        if (count_ == kAll) state_ = State::kCheck;
        break;
      case State::kCheck:
        state_ = good() ? State::kTake : State::kReady;
        if (!good()) loading_ = false;
        break;
      case State::kTake:
        saved_ = 0;
        if (in.reads) break;
        bank_ = 1 - bank_;
        valid_ = true;
        state_ = loading_ ? State::kReady : State::kFetch;
        loading_ = false;
        begin();
        break;
      case State::kFetch:
        fetched_ = data().words[saved_];
        if (!in.reads) state_ = State::kStore;
        break;
      case State::kStore:
        if (!in.nv_ready) break;
        state_ = saved_ == Calibration::kWords ? State::kReady : State::kFetch;
        saved_ = (saved_ + 1) % 64;
        break;
      case State::kReady:
        if (!in.write) break;
        if (in.command == 1) begin();
        if (in.command == 2 && count_ < kAll) take(in.word);
        if (in.command == 7) state_ = State::kCheck;
        break;
    }
  }

  bool quiescent(const In& in) const { return !busy() && !in.write; }

 private:
  enum class State { kLoad, kCheck, kTake, kFetch, kStore, kReady };
  static constexpr std::uint32_t kAll = Calibration::kWords + 1;

  bool good() const { return count_ == kAll && right_; }
  void begin() {
    count_ = 0;
    check_ = 0xFFFF;
    right_ = false;
  }
  void take(std::uint16_t word) {
    banks_[1 - bank_].words[count_++] = word;
    right_ = word == check_;
    check_ = crc16_word(check_, word);
  }

  std::array<Calibration, 2> banks_{};
  std::size_t bank_ = 0;
  State state_ = State::kLoad;
  bool valid_ = false, right_ = false, loading_ = true;
  std::uint32_t count_ = 0, saved_ = 0;
  std::uint16_t check_ = 0xFFFF, fetched_ = 0;
};

}  // namespace trammel::exact
