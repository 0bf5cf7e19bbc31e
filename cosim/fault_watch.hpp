// SPDX-License-Identifier: Apache-2.0
//
// What became of a fault: by what and when it was noticed, when the drives were off, how far the
// carriage then went; currents and stops by the truth of the plant, at each event. Without an
// injected fault it watches a trip from where it is noticed, for the way to rest.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cosim/fault.hpp"
#include "cosim/fault_report.hpp"

namespace trammel::cosim {

struct FaultTruth {
  std::vector<double> at;  // of the axes, in the machine's unit
  double current_A = 0;    // largest of a phase
  bool at_stop = false;
};

class FaultWatch {
 public:
  FaultWatch(const Fault& fault, std::int64_t clock_ps, std::string unit = "mm")
      : injected_(fault.any()) {
    report_.begin = FaultSpan(fault, clock_ps).begin;
    report_.unit = std::move(unit);
  }

  // After an event; by() names what detected a fault, truth() is a FaultTruth.
  template <class By, class Truth>
  void on(const Stop& stop, bool drives_off, By by, Truth truth) {
    if (injected_ && stop.edge < report_.begin) return;
    if (report_.detected == kNever) {
      report_.by = by();
      if (!report_.by.empty()) report_.detected = stop.edge;
    }
    if (!injected_ && report_.detected == kNever) return;
    const FaultTruth now = truth();
    report_.peak_A = std::max(report_.peak_A, now.current_A);
    report_.at_stop = report_.at_stop || now.at_stop;
    if (drives_off && report_.detected != kNever && report_.off == kNever) {
      report_.off = stop.edge;
      off_at_ = now.at;
    }
    if (report_.off != kNever) {
      report_.stopping = 0;
      for (std::size_t k = 0; k < now.at.size(); ++k) {
        report_.stopping = std::hypot(report_.stopping, now.at[k] - off_at_[k]);
      }
    }
  }

  const FaultReport& report() const { return report_; }

 private:
  bool injected_;
  FaultReport report_;
  std::vector<double> off_at_;
};

}  // namespace trammel::cosim
