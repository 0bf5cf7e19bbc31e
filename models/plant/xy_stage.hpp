// SPDX-License-Identifier: Apache-2.0
//
// Two leadscrew axes: signatures of cosim::Plant except for the packing of lines, which is left to
// the machine.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/plant/leadscrew_axis.hpp"

namespace trammel::plant {

using XyStageConfig = std::array<LeadscrewConfig, 2>;

class XyStage {
 public:
  explicit XyStage(const XyStageConfig& c) : axes_{LeadscrewAxis(c[0]), LeadscrewAxis(c[1])} {}

  const LeadscrewAxis& axis(std::size_t k) const { return axes_[k]; }
  std::int64_t next() const { return std::min(axes_[0].next(), axes_[1].next()); }

  // Codes of the converters, offset binary.
  void commit(std::int64_t n, const std::array<unsigned, 2>& codes) {
    for (std::size_t k = 0; k < axes_.size(); ++k) axes_[k].drive(n, codes[k]);
  }
  void open(std::int64_t n, std::size_t k, bool open) { axes_[k].open(n, open); }
  void supply(std::int64_t n, double share) {
    for (LeadscrewAxis& axis : axes_) axis.supply(n, share);
  }

 private:
  std::array<LeadscrewAxis, 2> axes_;
};

}  // namespace trammel::plant
