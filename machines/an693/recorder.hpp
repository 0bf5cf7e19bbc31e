// SPDX-License-Identifier: Apache-2.0
//
// Records a run of the LM628: commanded and real trajectory at every sample; a hash of the events.
#pragma once

#include <functional>
#include <utility>

#include "cosim/event_hash.hpp"
#include "host/disk_vector.hpp"
#include "machines/an693/record.hpp"

namespace trammel::an693 {

class Recorder final : public cosim::Observer {
 public:
  // `truth` fills in what the plant knows; `finished` is asked after each sample, and after it said
  // so nothing more is recorded.
  Recorder(const lm628::Lm628Chip& chip, std::function<void(Sample&)> truth,
           std::function<bool(const Sample&)> finished)
      : chip_(chip), truth_(std::move(truth)), finished_(std::move(finished)) {}

  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override {
    if (done_ || stop.why == cosim::kLimit) return;
    hash_.mix(stop, chip);
    if ((stop.why & cosim::kSample) == 0) return;
    Sample sample;
    sample.edge = stop.edge;
    sample.words = chip_.words();
    sample.host_irq = chip_.host_irq();
    truth_(sample);
    hash_.mix(static_cast<std::uint64_t>(sample.words.position));
    hash_.mix(static_cast<std::uint32_t>(sample.words.actual));
    samples_.push_back(sample);
    done_ = finished_(sample);
  }

  bool done() const { return done_; }
  std::uint64_t event_hash() const { return hash_.value(); }
  host::DiskVector<Sample> take_samples() { return std::move(samples_); }

 private:
  const lm628::Lm628Chip& chip_;
  std::function<void(Sample&)> truth_;
  std::function<bool(const Sample&)> finished_;
  host::DiskVector<Sample> samples_;
  cosim::EventHash hash_;
  bool done_ = false;
};

}  // namespace trammel::an693
