// SPDX-License-Identifier: Apache-2.0
//
// How far the table is beside the path that the scenario asks for, while it moves: the distance to
// the polyline through the points of the last 250 ms. What the chip takes for its command or its
// position does not enter.
#pragma once

#include <cstdint>
#include <deque>

#include "machines/kung/options.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace trammel::kung {

class CommandedPath {
 public:
  // `period`: samples for which a point holds; `count_m`: of the encoders; `reach`: samples that
  // are searched.
  CommandedPath(const sw::Trajectory& path, std::uint32_t period, double count_m,
                std::size_t reach);

  // The next sample, the first one being that of point 0: the distance [m] of the table from the
  // path. Once it is below `enough`, no nearer place is searched.
  double distance_m(const PointM& table, double enough);

  // What was asked some samples before the last one, at most as long ago as is searched.
  const PointM& commanded(std::uint32_t ago = 0) const;

 private:
  struct Vertex {
    PointM point;
    std::uint32_t at = 0;  // sample at which it came
  };

  sw::Trajectory path_;
  std::uint32_t period_;
  double count_m_;
  std::size_t reach_;
  std::uint32_t size_;
  std::uint32_t sample_ = 0;
  std::deque<Vertex> near_;  // the last is what is asked now
};

}  // namespace trammel::kung
