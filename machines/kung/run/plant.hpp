// SPDX-License-Identifier: Apache-2.0
//
// The plant of models/ behind the interface of cosim/; the processor may raise its trip pin.
#pragma once

#include <algorithm>
#include <optional>

#include "cosim/fault_plant.hpp"
#include "machines/kung/chip/pins.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

class TablePlant final : public cosim::FalliblePlant {
 public:
  explicit TablePlant(const plant::XyTableConfig& config) : table_(config) {}

  cosim::Lines sense() const override { return table_.sense() | trapped_; }
  cosim::Clk next() const override { return std::min(table_.next(), trip_); }
  void trip_from(cosim::Clk edge) { trip_ = std::min(trip_, edge); }  // the pin rises; not the past
  void commit(cosim::Clk n, cosim::Lines drive) override {
    table_.commit(n, drive);
    if (n < trip_) return;
    trapped_ = cosim::Lines{1} << kTripPin;
    trip_ = cosim::kNever;
  }
  int sample(int channel, cosim::Clk n) const override { return table_.sample(channel, n); }
  void open_phase(cosim::Clk n, int axis, int phase, bool open) override {
    table_.open_phase(n, axis, phase, open);
  }
  void supply(cosim::Clk n, double share) override { table_.supply(n, share); }
  std::optional<double> supplied(cosim::Clk n) const override {
    return table_.axis(0).supplied(n) + table_.axis(1).supplied(n);
  }

  const plant::XyTable& table() const { return table_; }

 private:
  plant::XyTable table_;
  cosim::Clk trip_ = cosim::kNever;
  cosim::Lines trapped_ = 0;
};

}  // namespace trammel::kung
