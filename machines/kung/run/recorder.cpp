// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/recorder.hpp"

namespace trammel::kung {

void Recorder::on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) {
  if (done_ || stop.why == cosim::kLimit) return;
  hash_.mix(stop, chip);
  if ((stop.why & cosim::kTick) != 0) {
    pending_.tick = ++tick_;  // what TICK reads after this sample
    pending_.edge = stop.edge;
    for (int axis = 0; axis < kAxes; ++axis) {
      const plant::AxisState state = truth_.state(axis, stop.edge);
      AxisSample& sample = pending_.axis[static_cast<std::size_t>(axis)];
      sample.x_true_m = state.x_m;
      sample.v_true_m_s = state.v_m_s;
      sample.i_d_true_A = state.i_d_a;
      sample.i_q_true_A = state.i_q_a;
      sample.force_N = state.force_n;
      sample.dc_link_V = state.dc_link_v;
    }
  }
  if ((stop.why & cosim::kSample) != 0) {
    for (int axis = 0; axis < kAxes; ++axis) {
      AxisSample& sample = pending_.axis[static_cast<std::size_t>(axis)];
      chip_.read_words(axis, sample);
      hash_.mix(static_cast<std::uint32_t>(sample.x_m));
      hash_.mix(static_cast<std::uint32_t>(sample.i_q_ref));
    }
    samples_.push_back(pending_);
    if (precise_) laws_.push_back({chip_.law(0), chip_.law(1)});
    done_ = finished_(pending_);
  }
}

}  // namespace trammel::kung
