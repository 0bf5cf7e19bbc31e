// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/page/afc_steps.hpp"

#include "models/exact/control/afc.hpp"

namespace trammel::kung {
namespace {

exact::Afc::Config config_of(const sw::AxisSetup& s) {
  exact::Afc::Config c;
  c.kp = {s.kp.mant, s.kp.exp};
  c.ki = {s.ki.mant, s.ki.exp};
  c.kv = {s.kv.mant, s.kv.exp};
  c.eta = {s.eta.mant, s.eta.exp};
  c.shift_e = s.shift_e;
  c.shift_de = s.shift_de;
  c.a0 = static_cast<std::int32_t>(s.a0);
  c.a0_scale = static_cast<int>(s.a0_scale);
  c.b2 = static_cast<std::int32_t>(fixed::wrap(s.b2, 24));
  c.adapt = s.adapt;
  c.feedforward = s.feedforward;
  return c;
}

struct Kept {
  AfcSteps steps;

  void product(std::size_t step, std::int64_t value) { steps[step].product = value; }
  void result(std::size_t step, std::int64_t value) { steps[step].result = value; }
};

}  // namespace

AfcSteps afc_steps(const sw::AxisSetup& setup, const AfcStart& s) {
  exact::Afc twin;
  twin.load({s.r_1, s.r_2, s.x_p_prev, s.e_prev, s.x_m, s.dx, s.integral});
  for (std::size_t n = 0; n < s.rules.size(); ++n) twin.set_rule(static_cast<int>(n), s.rules[n]);
  Kept kept;
  twin.step(config_of(setup), {s.r, s.x_p}, kept);
  return kept.steps;
}

}  // namespace trammel::kung
