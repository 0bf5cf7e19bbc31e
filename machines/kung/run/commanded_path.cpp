// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/commanded_path.hpp"

#include <algorithm>

#include "machines/kung/chip/measures.hpp"

namespace trammel::kung {

CommandedPath::CommandedPath(const sw::Trajectory& path, std::uint32_t period, double count_m,
                             std::size_t reach)
    : path_(path), period_(period), count_m_(count_m), reach_(reach), size_(path.size()) {
  const sw::Point start = path_.start();
  near_.push_back({{start.x * count_m_, start.y * count_m_}, 0});
}

double CommandedPath::distance_m(const PointM& table, double enough) {
  if (sample_ % period_ == 0 && sample_ / period_ < size_) {
    const sw::Point next = path_.next();
    near_.push_back({{next.x * count_m_, next.y * count_m_}, sample_});
  }
  while (near_.size() > 1 && near_[1].at + reach_ < sample_) near_.pop_front();
  ++sample_;
  double best = tracking_error(near_.back().point, table);
  for (std::size_t i = near_.size() - 1; i > 0 && best > enough; --i) {
    best = std::min(best, segment_distance(table, near_[i - 1].point, near_[i].point));
  }
  return best;
}

const PointM& CommandedPath::commanded(std::uint32_t ago) const {
  std::size_t i = near_.size() - 1;
  while (i > 0 && near_[i].at + ago >= sample_) --i;
  return near_[i].point;
}

}  // namespace trammel::kung
