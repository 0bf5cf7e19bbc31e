// SPDX-License-Identifier: Apache-2.0
//
// The controller block and its twin side by side; every sample is compared word by word.
#pragma once

#include <Vafc.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/control/afc.hpp"
#include "tests/support/rtl.hpp"

namespace trammel::test {

using exact::Afc;

constexpr int kAfcClocks = 70;  // 35 steps of 40 ns

template <class Port>
void set(Port& port, std::int64_t value, int bits) {
  port = static_cast<Port>(as_bits(value, bits));
}

inline std::uint32_t gain_word(const fixed::Gain& gain) {
  return as_bits(gain.exp * 2048 + gain.mant, 16);
}

struct AfcBench {
  Rtl<Vafc> rtl;
  Afc twin;
  Afc::Config config;

  AfcBench() {
    rtl->start_i = 0;
    rtl->reset_model_i = 0;
    rtl->reset_table_i = 0;
    rtl->rule_addr_i = 0;
    rtl->rule_we_i = 0;
    rtl->rule_wdata_i = 0;
    rtl->r_i = 0;
    rtl->x_p_i = 0;
    configure();
    rtl.reset();
    settle();
  }

  void configure() {
    rtl->adapt_i = config.adapt;
    rtl->feedforward_i = config.feedforward;
    set(rtl->kp_i, gain_word(config.kp), 16);
    set(rtl->ki_i, gain_word(config.ki), 16);
    set(rtl->kv_i, gain_word(config.kv), 16);
    set(rtl->eta_i, gain_word(config.eta), 16);
    set(rtl->shift_e_i, config.shift_e, 5);
    set(rtl->shift_de_i, config.shift_de, 5);
    set(rtl->a0_i, config.a0, 18);
    set(rtl->a0_scale_i, config.a0_scale, 2);
    set(rtl->b2_i, config.b2, 24);
    rtl.eval();
  }

  int settle() {
    int clocks = 0;
    for (; rtl->busy_o && clocks < 200; ++clocks) rtl.tick();
    return clocks;
  }

  void start(const Afc::In& in) {
    configure();
    set(rtl->r_i, in.r, 24);
    set(rtl->x_p_i, in.x_p, 24);
    rtl->start_i = 1;
    rtl.tick();
    rtl->start_i = 0;
    rtl.eval();
  }

  std::int64_t read(int index) {
    set(rtl->rule_addr_i, index, 6);
    rtl.tick();
    rtl.tick();  // after a write
    return as_signed(rtl->rule_rdata_o, 24);
  }

  void write(int index, std::int32_t value) {
    set(rtl->rule_addr_i, index, 6);
    set(rtl->rule_wdata_i, value, 24);
    rtl->rule_we_i = 1;
    rtl.tick();
    rtl->rule_we_i = 0;
    rtl.eval();
    twin.set_rule(index, value);
  }

  void require_same(const Afc::Out& out) {
    REQUIRE(as_signed(rtl->x_m_o, 32) == out.x_m);
    REQUIRE(as_signed(rtl->x_r_o, 24) == out.x_r);
    REQUIRE(as_signed(rtl->dx_o, 24) == out.dx);
    REQUIRE(as_signed(rtl->e_o, 12) == out.e);
    REQUIRE(as_signed(rtl->de_o, 12) == out.de);
    REQUIRE(as_signed(rtl->v_o, 12) == out.v);
    REQUIRE(as_signed(rtl->u_o, 12) == out.u);
    REQUIRE(as_signed(rtl->v_star_o, 12) == out.v_star);
    REQUIRE(as_signed(rtl->i_q_ref_o, 12) == out.i_q_ref);
    REQUIRE(static_cast<bool>(rtl->saturated_o) == out.saturated);
  }

  void require_same_rules() {
    for (int n = 0; n < 49; ++n) {
      CAPTURE(n);
      REQUIRE(read(n) == twin.rule(n));
    }
  }

  Afc::Out sample(const Afc::In& in) {
    start(in);
    REQUIRE(settle() == kAfcClocks);
    const Afc::Out out = twin.step(config, in);
    require_same(out);
    return out;
  }

  // Both at rest in x_p: the level held over one sample.
  void reset(std::int32_t x_p) {
    rtl->reset_model_i = 1;
    twin.reset(x_p);
    start({x_p + 1234, x_p});  // the command is not looked at
    rtl->reset_model_i = 0;
    REQUIRE(settle() == kAfcClocks);
    require_same(twin.step(config, {x_p, x_p}));
  }
};

}  // namespace trammel::test
