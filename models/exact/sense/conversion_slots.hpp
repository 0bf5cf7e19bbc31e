// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/sense/conversion_slots.sv, and reads as the thesis' loop over clients.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trammel::exact {

class ConversionSlots {
 public:
  enum class Client { kObserver, kRequester, kNone };
  struct In {
    bool pick = false;
    std::uint32_t observer_slots = 2, requester_slots = 1;
    bool wants = false;     // the observer
    std::uint32_t ask = 0;  // by channel
    bool done = false;      // a conversion
    std::uint32_t channel = 0, code = 0;
  };

  void reset() { *this = ConversionSlots(); }

  // What a pick at the present edge gives.
  Client pick(const In& in) const { return ConversionSlots(*this).turn(in); }
  std::uint32_t channel() const {  // of the requester
    for (std::uint32_t k = 0; k < 6; ++k) {
      if ((pending_ >> k & 1) != 0) return k;
    }
    return 6;
  }
  std::uint32_t pending() const { return pending_; }
  bool served(const In& in) const { return (pending_ & done_mask(in)) != 0; }
  const std::array<std::uint16_t, 5>& codes() const { return codes_; }  // A, dA, B, dB, current

  void step(const In& in) {
    if (in.pick) turn(in);
    pending_ = (pending_ & ~done_mask(in)) | in.ask;
    if (!in.done) return;
    if (in.channel < 4) codes_[in.channel] = static_cast<std::uint16_t>(in.code);
    if (in.channel == 6) codes_[4] = static_cast<std::uint16_t>(in.code);
  }

  bool quiescent(const In& in) const { return !in.pick && !in.done && in.ask == 0; }

 private:
  static std::uint32_t done_mask(const In& in) {
    return in.done && in.channel != 7 ? 1u << in.channel : 0;
  }

  Client turn(const In& in) {
    const auto wants = [&](Client c) { return c == Client::kObserver ? in.wants : pending_ != 0; };
    const auto slots = [&](Client c) {
      return c == Client::kObserver ? in.observer_slots : in.requester_slots;
    };
    for (int visits = 0; visits < 3; ++visits) {  // itself, the other one, itself again
      if (left_ > 0 && wants(client_)) {
        --left_;
        return client_;
      }
      client_ = client_ == Client::kObserver ? Client::kRequester : Client::kObserver;
      left_ = slots(client_);
    }
    client_ = Client::kRequester;
    left_ = 0;
    return Client::kNone;
  }

  Client client_ = Client::kRequester;
  std::uint32_t left_ = 0, pending_ = 0;
  std::array<std::uint16_t, 5> codes_{};
};

}  // namespace trammel::exact
