// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/afc_steps.hpp"

#include "models/fixed/fixed.hpp"

namespace trammel::kung {
namespace {

using fixed::floor_shift;
using fixed::rs;
using fixed::sat;
using fixed::shift_left;

std::int32_t word(std::int64_t x) { return static_cast<std::int32_t>(x); }

// A step's product is rounded by the adder in a later one: the multiplier has a register.
class Tracer {
 public:
  Tracer(const sw::AxisSetup& setup, const kung::AfcStart& start) : c_(setup), s_(start) {}

  AfcTrace run() {
    model();
    errors();
    weights();
    fuzzy_output();
    command();
    tuning();
    return t_;
  }

 private:
  std::int64_t product(std::size_t step, std::int64_t a, std::int64_t b) {
    t_.steps[step].product = a * b;
    return a * b;
  }
  std::int64_t result(std::size_t step, std::int64_t value) {
    t_.steps[step].result = value;
    return value;
  }
  static std::int64_t scaled(std::int64_t product, const sw::Gain& gain, int point) {
    return rs(product, point - gain.exp);
  }

  void model() {
    const auto b2 = fixed::wrap(c_.b2, 24);
    const std::int64_t old = product(0, b2, s_.dx);
    std::int64_t sum = result(0, std::int64_t{s_.r} + s_.r_2);
    sum = result(1, sum + 2 * std::int64_t{s_.r_1});
    const std::int64_t s = result(2, sat(shift_left(sum, 6) - floor_shift(s_.x_m, 6), 24));
    const std::int64_t driven = product(3, c_.a0, s);
    const std::int64_t kept = result(3, rs(old, 23));
    t_.end.dx = word(result(4, sat(kept + rs(driven, 24), 24)));
    t_.end.x_m = word(result(5, fixed::wrap(std::int64_t{s_.x_m} + t_.end.dx, 32)));
    t_.end.x_r = word(result(6, rs(t_.end.x_m, 14)));
    t_.end.r = s_.r;
    t_.end.x_p = s_.x_p;
  }

  void errors() {
    t_.end.v = word(result(7, sat(16 * (std::int64_t{s_.x_p} - s_.x_p_prev), 12)));
    t_.end.e = word(result(8, sat(std::int64_t{t_.end.x_r} - s_.x_p, 12)));
    t_.end.de = word(result(9, sat(std::int64_t{t_.end.e} - s_.e_prev, 12)));
  }

  // Distance of the scaled error from the knot below, 0..511, and the number of that knot.
  struct Place {
    std::int64_t scaled, above;
    int section;
  };
  static Place place(std::int32_t error, std::uint32_t shift) {
    const std::int64_t scaled =
        fixed::clip(shift_left(error, static_cast<int>(shift)), -1536, 1535);
    const std::int64_t section = floor_shift(scaled + 1536, 9);
    return {scaled, scaled + 1536 - 512 * section, static_cast<int>(section)};
  }

  void weights() {
    const Place e = place(t_.end.e, c_.shift_e);
    const Place de = place(t_.end.de, c_.shift_de);
    t_.section_e = e.section;
    t_.section_de = de.section;
    const std::int64_t a_high = 4 * e.above;
    const std::int64_t a_low = result(10, 2048 - a_high);
    result(11, de.scaled);
    const std::int64_t b_high = 4 * de.above;
    const std::int64_t b_low = result(12, 2048 - b_high);
    const int first = 7 * de.section + e.section;
    t_.fired = {first, first + 1, first + 7, first + 8};
    const std::int64_t factors[4][2] = {
        {a_low, b_low}, {a_high, b_low}, {a_low, b_high}, {a_high, b_high}};
    for (std::size_t n = 0; n < 4; ++n) {
      d_[n] = rs(product(14 + n, factors[n][0], factors[n][1]), 11);
      result(15 + n, d_[n]);
    }
  }

  std::int64_t rule(std::size_t n) const {
    return s_.rules[static_cast<std::size_t>(t_.fired[n])];
  }

  void fuzzy_output() {
    std::int64_t sum = 1024;  // rounds u
    for (std::size_t n = 0; n < 4; ++n) {
      sum += product(18 + n, floor_shift(rule(n), 12), d_[n]);
      result(19 + n, sum);
    }
    t_.end.u = word(result(22, sat(floor_shift(sum, 11), 12)));
  }

  void command() {
    const std::int64_t kp_u = product(23, c_.kp.mant, t_.end.u);
    const std::int64_t ahead = result(23, c_.feedforward ? rs(t_.end.dx, 10) : 0);
    const std::int64_t ki_u = product(24, c_.ki.mant, t_.end.u);
    const std::int64_t proportional = result(24, ahead + scaled(kp_u, c_.kp, 11));
    t_.integral = word(result(25, sat(s_.integral + scaled(ki_u, c_.ki, -1), 24)));
    t_.end.v_star = word(result(26, sat(proportional + rs(t_.integral, 12), 12)));
    const std::int64_t speed_error = result(27, sat(t_.end.v_star - t_.end.v, 12));
    const std::int64_t current = product(28, c_.kv.mant, speed_error);
    t_.end.i_q_ref = word(result(29, sat(scaled(current, c_.kv, 11), 12)));
  }

  void tuning() {
    const std::int64_t t = result(30, product(29, c_.eta.mant, t_.end.e));
    for (std::size_t n = 0; n < 4; ++n) {
      const std::int64_t change = scaled(product(30 + n, t, d_[n]), c_.eta, 10);
      result(31 + n, c_.adapt ? sat(rule(n) + change, 24) : rule(n));
    }
  }

  const sw::AxisSetup& c_;
  const kung::AfcStart& s_;
  AfcTrace t_;
  std::array<std::int64_t, 4> d_{};
};

}  // namespace

AfcTrace trace_afc(const sw::AxisSetup& setup, const kung::AfcStart& start) {
  return Tracer(setup, start).run();
}

}  // namespace trammel::kung
