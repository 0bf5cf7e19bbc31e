// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/page/afc_steps.hpp"

#include "models/exact/control/rule_store.hpp"

namespace trammel::kung {
namespace {

using fixed::floor_shift;
using fixed::rs;
using fixed::sat;
using fixed::shift_left;
using Wide = std::int64_t;

// A scaled error, 1/1024 unit: the knot below it, its memberships of that knot and the next (Q11).
struct Fuzzy {
  Wide scaled;
  int section;
  Wide low, high;
};

Fuzzy fuzzify(Wide error, std::int32_t shift) {
  const Wide scaled = fixed::clip(shift_left(error, shift + 2), -4 * 1536, 4 * 1535);
  const Wide section = floor_shift(scaled + 4 * 1536, 11);
  const Wide high = scaled + 4 * 1536 - 2048 * section;
  return {scaled, static_cast<int>(section), 2048 - high, high};
}

Wide scaled(Wide product, const sw::Gain& gain, int point) { return rs(product, point - gain.exp); }

}  // namespace

// A step's product is rounded by the adder in a later one: the multiplier has a register.
AfcSteps afc_steps(const sw::AxisSetup& c, const AfcStart& s) {
  AfcSteps steps;
  const auto product = [&steps](std::size_t step, Wide a, Wide b) {
    return *(steps[step].product = a * b);
  };
  const auto result = [&steps](std::size_t step, Wide value) {
    return *(steps[step].result = value);
  };

  // Reference model.
  const Wide kept = product(0, fixed::wrap(c.b2, 24), s.dx);
  const Wide two = result(0, Wide{s.r} + s.r_2);
  const Wide four = result(1, two + 2 * Wide{s.r_1});
  const Wide driven =
      product(3, c.a0, result(2, sat(shift_left(four, 6) - floor_shift(s.x_m, 6), 24)));
  const int a0_shift = c.a0_scale == 0 ? 24 : c.a0_scale == 1 ? 20 : 15;
  const Wide dx = result(4, sat(result(3, rs(kept, 23)) + rs(driven, a0_shift), 24));
  const Wide x_r = result(6, rs(result(5, fixed::wrap(s.x_m + dx, 32)), 14));

  // Errors.
  const Wide v = result(7, sat(16 * (Wide{s.x_p} - s.x_p_prev), 12));
  const Wide e = result(8, sat(x_r - s.x_p, 12));
  const Wide de = result(9, sat(e - s.e_prev, 12));

  // Memberships and weights of the four rules that fire.
  const Fuzzy a = fuzzify(e, c.shift_e);
  const Fuzzy b = fuzzify(de, c.shift_de);
  result(10, a.low);
  result(11, b.scaled);
  result(12, b.low);
  const Wide factors[4][2] = {{a.low, b.low}, {a.high, b.low}, {a.low, b.high}, {a.high, b.high}};
  const std::array<int, 4> fired = exact::RuleStore::fired(a.section, b.section);
  Wide weight[4], rule[4];
  for (std::size_t n = 0; n < 4; ++n) {
    rule[n] = s.rules[static_cast<std::size_t>(fired[n])];
    weight[n] = result(15 + n, rs(product(14 + n, factors[n][0], factors[n][1]), 11));
  }

  // Output of the fuzzy system.
  Wide sum = 1024;  // rounds u
  for (std::size_t n = 0; n < 4; ++n) {
    sum = result(19 + n, sum + product(18 + n, floor_shift(rule[n], 12), weight[n]));
  }
  const Wide u = result(22, sat(floor_shift(sum, 11), 12));

  // Speed and current commands.
  const Wide kp_u = product(23, c.kp.mant, u);
  const Wide ahead = result(23, c.feedforward ? rs(dx, 10) : 0);
  const Wide ki_u = product(24, c.ki.mant, u);
  const Wide proportional = result(24, ahead + scaled(kp_u, c.kp, 11));
  const Wide integral = result(25, sat(s.integral + scaled(ki_u, c.ki, -1), 24));
  const Wide v_star = result(26, sat(proportional + rs(integral, 12), 12));
  const Wide current = product(28, c.kv.mant, result(27, sat(v_star - v, 12)));
  result(29, sat(scaled(current, c.kv, 11), 12));

  // Tuning.
  const Wide rate = result(30, product(29, c.eta.mant, e));
  for (std::size_t n = 0; n < 4; ++n) {
    const Wide change = scaled(product(30 + n, rate, weight[n]), c.eta, 10);
    result(31 + n, c.adapt ? sat(rule[n] + change, 24) : rule[n]);
  }
  return steps;
}

}  // namespace trammel::kung
