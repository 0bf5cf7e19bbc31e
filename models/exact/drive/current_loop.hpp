// SPDX-License-Identifier: Apache-2.0
//
// Vector control of the current of one axis (specification section 7).
// Twin of rtl/drive/current_loop.sv.
#pragma once

#include <cstdint>

#include "models/exact/drive/clarke.hpp"
#include "models/exact/drive/current_pi.hpp"
#include "models/exact/drive/rotator.hpp"
#include "models/exact/drive/sine.hpp"
#include "models/exact/drive/svpwm.hpp"
#include "models/exact/drive/vector_limit.hpp"

namespace trammel::exact {

class CurrentLoop {
 public:
  struct In {
    bool clear = false;
    std::int32_t code_a = 2048, code_b = 2048;  // offset binary
    std::int32_t count = 0;
    std::uint32_t theta_ofs = 0;
    std::int32_t i_q_ref = 0, i_d_ref = 0;
    fixed::Gain kp{}, ki{};
  };
  struct Out {
    std::int32_t cmp_a = 781, cmp_b = 781, cmp_c = 781;
    std::int32_t i_a = 0, i_b = 0, i_d = 0, i_q = 0, v_d = 0, v_q = 0;
    bool limited = false;
  };

  void reset() {
    pi_d_.reset();
    pi_q_.reset();
  }

  Out step(const In& in) {
    const std::int32_t i_a = in.code_a - 2048, i_b = in.code_b - 2048;
    const Sine::Out angle = sine_.step({theta(in.count, in.theta_ofs) >> 22});
    const Clarke::Out i = clarke_.step({i_a, i_b});
    const Rotator::Out i_dq = park_.step({i.i_alpha, i.i_beta, angle.sin, angle.cos});
    const CurrentPi::Out d = pi_d_.step({in.clear, in.i_d_ref, i_dq.x, in.kp, in.ki});
    const CurrentPi::Out q = pi_q_.step({in.clear, in.i_q_ref, i_dq.y, in.kp, in.ki});
    const VectorLimit::Out v = limit_.step({d.v, q.v});
    const Rotator::Out v_ab = inverse_.step({v.v_d, v.v_q, angle.sin, angle.cos});
    const Svpwm::Out cmp = svpwm_.step({v_ab.x, v_ab.y});
    return {cmp.cmp_a, cmp.cmp_b, cmp.cmp_c, i_a,   i_b,
            i_dq.x,    i_dq.y,    v.v_d,     v.v_q, v.limited};
  }

  // Electrical angle, 2^32 = one turn = 12 200 counts.
  static std::uint32_t theta(std::int32_t count, std::uint32_t offset) {
    return static_cast<std::uint32_t>(count) * 352047u + offset;
  }

 private:
  Sine sine_;
  Clarke clarke_;
  Rotator park_{{Rotator::Direction::kPark}};
  CurrentPi pi_d_, pi_q_;
  VectorLimit limit_;
  Rotator inverse_{{Rotator::Direction::kInverse}};
  Svpwm svpwm_;
};

}  // namespace trammel::exact
