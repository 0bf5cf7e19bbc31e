// SPDX-License-Identifier: Apache-2.0
//
// Belt, stripes and host of models/ behind the interface of cosim/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "cosim/fault_plant.hpp"
#include "machines/gantry/host.hpp"
#include "machines/gantry/pins.hpp"
#include "models/plant/belt_axis.hpp"
#include "models/plant/stripe_track.hpp"

namespace trammel::gantry {

class TrackPlant final : public cosim::FalliblePlant {
 public:
  static constexpr cosim::Clk kClocksPerBit = 434;  // 115,200 baud at 50 MHz
  static constexpr cosim::Clk kCarrier = 6944;      // a period of the bridges

  TrackPlant(const plant::BeltAxisConfig& axis, const plant::StripeTrackConfig& stripes,
             std::vector<Sent> sends, bool serial, const LineConfig& line = {})
      : axis_(axis),
        stripes_(stripes),
        sends_(std::move(sends)),
        terminal_(serial ? std::make_unique<PseudoTerminal>(axis.clock_ps) : nullptr),
        line_(line),
        host_(bit_of(line), [this](cosim::Clk edge) { return next_byte(edge); },
              [](unsigned char) {}),
        reader_(bit_of(line)) {
    ask();
  }

  const plant::BeltAxis& axis() const { return axis_; }
  const std::vector<unsigned char>& heard() const { return heard_; }

  cosim::Lines sense() const override { return rx_ ? cosim::Lines{1} << kRx : 0; }
  // The belt is followed at least each millisecond: what the sensor tells is older than that.
  cosim::Clk next() const override {
    return std::min(host_.next(), (last_ / kFollow + 1) * kFollow);
  }

  void commit(cosim::Clk n, cosim::Lines drive) override {
    std::array<double, kMotors> bridge{};
    for (int m = 0; m < kMotors; ++m) {
      const double on = level(drive, pwm(m)) ? 1 : 0;
      bridge[static_cast<std::size_t>(m)] = level(drive, negative(m)) ? on : -on;
    }
    axis_.drive(n, bridge);
    rx_ = host_.level(n);
    reader_.see(n, level(drive, kTx), [this](unsigned char byte) {
      if (terminal_) terminal_->take(byte);
      if (heard_.size() < kMostHeard) heard_.push_back(byte);
    });
    ask();
    last_ = n;
  }

  int sample(int channel, cosim::Clk n) const override {
    if (channel == kCurrent) {
      const auto& force = axis_.state().force;
      return std::clamp(static_cast<int>(0.5 * (std::abs(force[0]) + std::abs(force[1]))), 0, 1023);
    }
    const plant::BeltAxis::Seen seen = axis_.seen(n);
    return stripes_.code(channel, seen.x, seen.v, n);
  }

  // Where on the track an observer's position is 0 that has this one at edge n [m]: it counts from
  // a whole period.
  double origin(cosim::Clk n, std::int32_t position) const {
    const double period = stripes_.config().period, counted = period * position / 16384;
    return period * std::round((axis_.seen(n).x - counted) / period);
  }

  void open_phase(cosim::Clk n, int axis, int, bool open) override {
    last_ = std::max(last_, n);
    axis_.open(static_cast<std::size_t>(axis), open);
  }
  void supply(cosim::Clk, double share) override { axis_.supply(share); }

 private:
  static constexpr cosim::Clk kFollow = 50'000;
  static constexpr std::size_t kMostHeard = 1'000'000;

  static cosim::Clk bit_of(const LineConfig& line) {
    return std::llround(static_cast<double>(kClocksPerBit) / (1 + line.baud_error));
  }

  // The edge at which the next bytes of the list are due.
  cosim::Clk due() const {
    return static_cast<cosim::Clk>(
        std::ceil(1e12 * sends_[sent_].at_s / static_cast<double>(axis_.config().clock_ps)));
  }
  void ask() {
    if (sent_ < sends_.size() && !terminal_) host_.ask_at(due());
  }

  std::optional<unsigned> next_byte(cosim::Clk edge) {
    const std::optional<unsigned char> byte = terminal_ ? terminal_->next(edge) : listed(edge);
    if (!byte) return std::nullopt;
    wrong_ += line_.framing_errors;
    if (wrong_ < 1) return *byte;
    wrong_ -= 1;
    return *byte | cosim::SerialHost::kNoStop;
  }

  std::optional<unsigned char> listed(cosim::Clk edge) {
    if (sent_ == sends_.size() || edge < due()) return std::nullopt;
    const Sent& now = sends_[sent_];
    const unsigned char byte = now.bytes[byte_++];
    if (byte_ == now.bytes.size()) {
      ++sent_;
      byte_ = 0;
    }
    return byte;
  }

  plant::BeltAxis axis_;
  plant::StripeTrack stripes_;
  std::vector<Sent> sends_;
  std::size_t sent_ = 0, byte_ = 0;
  std::unique_ptr<PseudoTerminal> terminal_;
  LineConfig line_;
  double wrong_ = 0;  // share of a byte that is due to be one
  cosim::SerialHost host_;
  LineReader reader_;
  std::vector<unsigned char> heard_;
  bool rx_ = true;
  cosim::Clk last_ = 0;
};

}  // namespace trammel::gantry
