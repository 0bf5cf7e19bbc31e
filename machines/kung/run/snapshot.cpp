// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trammel::kung {

namespace {
// From this clock of a period on, the current loop shows the compare values of the next one.
constexpr cosim::Clk kLoopDone = 200;
}  // namespace

RuleTable SnapshotRecorder::rules(int axis) const {
  RuleTable table{};
  for (int n = 0; n < 49; ++n) table[static_cast<std::size_t>(n)] = chip_.rule(axis, n);
  return table;
}

std::array<std::array<std::int32_t, 3>, 2> SnapshotRecorder::compare_values() const {
  const CurrentWords x = chip_.current(0);
  const CurrentWords y = chip_.current(1);
  return {{{x.cmp_a, x.cmp_b, x.cmp_c}, {y.cmp_a, y.cmp_b, y.cmp_c}}};
}

void SnapshotRecorder::path_begins() {
  on_path_ = true;
  snapshot_.rules_first = {rules(0), rules(1)};
}

void SnapshotRecorder::on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) {
  if (open_.end != 0 && stop.edge >= open_.end) close_window();
  if ((stop.why & cosim::kDrive) != 0) keep_edge(stop, chip.drive());
  const cosim::Clk inside = stop.edge - open_.begin;
  if (open_.compare.size() == 1 && inside > kLoopDone && inside < period_) {
    open_.compare.push_back(compare_values());
  }
  if ((stop.why & cosim::kTick) != 0) open_if_fastest(stop.edge);
  if ((stop.why & cosim::kSample) != 0) {
    before_ = last_;
    for (int axis = 0; axis < kAxes; ++axis) {
      chip_.read_words(axis, last_[static_cast<std::size_t>(axis)]);
    }
    if (moment_open_) moment_.end = last_;
    moment_open_ = false;
  }
}

void SnapshotRecorder::open_if_fastest(cosim::Clk edge) {
  ++tick_;
  if (!on_path_) return;  // the model may still be reset
  double speed = 0;
  for (int axis = 0; axis < kAxes; ++axis) {
    speed = std::fmax(speed, std::fabs(truth_.state(axis, edge).v_m_s));
  }
  if (tripped_ || speed <= fastest_m_s_) return;
  fastest_m_s_ = speed;
  moment_.tick = tick_;
  moment_.edge = edge;
  open_ = {edge, edge + 2 * period_, cosim::kNever, {}, {compare_values()}};
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    moment_.start[k] = {0, last_[k].r, before_[k].r, 0, last_[k].x_p, last_[k].x_m,
                        last_[k].dx, last_[k].e, chip_.integral(axis), rules(axis)};
  }
  moment_open_ = true;
}

void SnapshotRecorder::keep_edge(const cosim::Stop& stop, cosim::Lines gates) {
  while (recent_.size() > 1 && recent_[1].edge < stop.edge - 3 * period_) recent_.pop_front();
  recent_.push_back({stop.edge, gates});
  if (tripped_ || gates != 0 || chip_.fault().code == FaultCode::kNone) return;
  tripped_ = true;
  open_ = {stop.edge - period_, stop.edge + period_, stop.edge, {}, {}};
}

void SnapshotRecorder::close_window() {
  open_.edges = {{open_.begin, 0}};
  for (const GateEdge& edge : recent_) {
    if (edge.edge >= open_.end) break;
    if (edge.edge <= open_.begin) {
      open_.edges.front().gates = edge.gates;
    } else {
      open_.edges.push_back(edge);
    }
  }
  if (open_.trip == cosim::kNever) snapshot_.moment = moment_;
  snapshot_.gates = std::exchange(open_, {});
}

Snapshot SnapshotRecorder::take() {
  if (open_.trip != cosim::kNever) {  // the run ended soon after the trip
    open_.end = std::min(open_.end, chip_.now());
    close_window();
  }
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    snapshot_.rules_last[k] = rules(axis);
    snapshot_.moment.start[k].r = snapshot_.moment.end[k].r;
    snapshot_.moment.start[k].x_p = snapshot_.moment.end[k].x_p;
  }
  return std::move(snapshot_);
}

}  // namespace trammel::kung
