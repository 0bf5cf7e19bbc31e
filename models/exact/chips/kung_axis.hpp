// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of the controllers of rtl/chips/kung_axis.sv, sample by sample: position
// controller at 2 kHz, current loop at 16 kHz. Where both ticks coincide, call step16k() first: it
// uses the old i_q*.
#pragma once

#include <cstdint>

#include "models/exact/control/afc.hpp"
#include "models/exact/drive/current_loop.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class KungAxis {
 public:
  struct Config {
    Afc::Config position{};
    fixed::Gain kp_cur{1275, 2};
    fixed::Gain ki_cur{1478, -2};
    std::uint32_t angle_step = CurrentLoop::kAngleStep;
    std::uint32_t theta_ofs = 0;
    bool close_position = true;   // CTRL b2; otherwise i_q* is iq_manual
    bool close_current = true;    // enabled, not tripped and CTRL b1; otherwise 50 % duty
    std::int32_t iq_manual = 0;   // I_fs / 4096
  };

  // What the converters hold at a 16 kHz tick, offset binary.
  struct Codes {
    std::int32_t a = 2048;
    std::int32_t b = 2048;
  };

  CurrentLoop::Out step16k(const Config& config, const Codes& codes, std::int32_t count) {
    CurrentLoop::In in;
    in.clear = !config.close_current;
    in.code_a = codes.a;
    in.code_b = codes.b;
    in.count = count;
    in.angle_step = config.angle_step;
    in.theta_ofs = config.theta_ofs;
    in.i_q_ref = config.close_position ? i_q_ref_ : config.iq_manual;
    in.kp = config.kp_cur;
    in.ki = config.ki_cur;
    return current_.step(in);
  }

  Afc::Out step2k(const Config& config, std::int32_t r, std::int32_t x_p) {
    const Afc::Out out = position_.step(config.position, {r, x_p});
    i_q_ref_ = out.i_q_ref;
    return out;
  }

  Afc& position() { return position_; }

 private:
  Afc position_;
  CurrentLoop current_;
  std::int32_t i_q_ref_ = 0;
};

}  // namespace trammel::exact
