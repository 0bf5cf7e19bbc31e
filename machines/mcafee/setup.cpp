// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/setup.hpp"

#include <cstdlib>

namespace trammel::mcafee {

Table followed_table(const Options& o) {
  if (!o.tracks()) return {};
  return make_table(o.path, o.count_mm(), o.travel_mm());
}

sw::McafeeSetup setup_of(const Options& o, const Table& table) {
  const std::int64_t period_ps = o.run.clock_ps;
  sw::McafeeSetup setup;
  setup.stage = o.stage;
  setup.filter = o.filter;
  setup.wait_clk = static_cast<std::uint32_t>(cosim::clocks_of(o.wait_s, period_ps));
  setup.readings = static_cast<std::uint32_t>(o.readings);
  setup.sample_clk = static_cast<std::uint32_t>(cosim::clocks_of(o.sample_s(), period_ps));
  setup.acceleration = o.acceleration;
  setup.velocity = o.velocity;
  setup.position = o.position;
  setup.rows = table.rows.data();
  setup.row_count = static_cast<std::uint32_t>(table.rows.size());
  setup.index_counts =
      o.index_check ? static_cast<std::uint32_t>(4 * o.stage_axis.encoder.lines) : 0;
  setup.error_limit = static_cast<std::uint32_t>(o.error_limit);
  setup.speed = static_cast<std::uint32_t>(o.speed);
  setup.least_speed = static_cast<std::uint32_t>(o.least_speed);
  setup.velocity_shift = static_cast<std::uint32_t>(o.velocity_shift);
  return setup;
}

double share_done(const Options& o, const Table& table, std::uint32_t point, std::int32_t x) {
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 1; };
  switch (o.stage) {
    case sw::McafeeStage::kRead: return share(point, o.readings);
    case sw::McafeeStage::kMove: return share(std::abs(x), std::abs(o.position));
    case sw::McafeeStage::kTrack: break;
  }
  return share(point, static_cast<double>(table.rows.size()));
}

}  // namespace trammel::mcafee
