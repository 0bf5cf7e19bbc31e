// SPDX-License-Identifier: Apache-2.0
//
// Records a run: a sample at every 2 kHz tick and a hash over all events with their edges.
#pragma once

#include <cstdint>
#include <functional>

#include "cosim/event_hash.hpp"
#include "host/disk_vector.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

class Recorder final : public cosim::Observer {
 public:
  // `truth` is the plant behind the loop; `finished` is asked after each complete sample. After it
  // said so nothing more is recorded: what a wiring still executes to leave its loop is no event.
  // `precise`: the words of the precision controller too.
  Recorder(const KungChip& chip, const plant::XyTable& truth, bool precise,
           std::function<bool(const Sample&)> finished)
      : chip_(chip), truth_(truth), precise_(precise), finished_(std::move(finished)) {}

  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override;

  bool done() const { return done_; }
  std::uint64_t event_hash() const { return hash_.value(); }
  host::DiskVector<Sample> take_samples() { return std::move(samples_); }
  host::DiskVector<AxisLaws> take_laws() { return std::move(laws_); }

 private:
  const KungChip& chip_;
  const plant::XyTable& truth_;
  const bool precise_;
  std::function<bool(const Sample&)> finished_;
  host::DiskVector<Sample> samples_;
  host::DiskVector<AxisLaws> laws_;
  Sample pending_;
  std::uint32_t tick_ = 0;
  cosim::EventHash hash_;
  bool done_ = false;
};

}  // namespace trammel::kung
