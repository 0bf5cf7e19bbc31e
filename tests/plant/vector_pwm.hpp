// SPDX-License-Identifier: Apache-2.0
//
// Gate events of a plain field-oriented open-loop drive, for plant tests: a voltage vector fixed to
// the rotor, centred 16 kHz pulses, dead time. Not a model of the chip.
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "models/plant/xy_table.hpp"

namespace trammel::plant::test {

inline constexpr Clk kPeriod = 3125;

struct Pwm {
  double u_d = 0, u_q = 20;  // [V]
  Clk dead_time = 100;
};

// Adds the events of the PWM period that starts at n for the axis; the values are (clear, set)
// bits.
using Events = std::map<Clk, std::pair<Lines, Lines>>;
inline void add_period(Events& events, const XyTable& table, int axis, Clk n, const Pwm& pwm,
                       double dc_link) {
  const SinCos a = table.axis(axis).motor().angle(table.state(axis, n).x_m);
  const auto u = to_phases(Pmlsm::stator(pwm.u_d, pwm.u_q, a));
  const double mid =
      0.5 * (*std::max_element(u.begin(), u.end()) + *std::min_element(u.begin(), u.end()));
  for (int phase = 0; phase < 3; ++phase) {
    const double duty =
        std::clamp(0.5 + (u[static_cast<std::size_t>(phase)] - mid) / dc_link, 0.1, 0.9);
    const Clk on = n + static_cast<Clk>((1 - duty) * 0.5 * kPeriod);
    const Clk off = n + kPeriod - (on - n);
    const Lines hi = Lines{1} << xy::gate_hi(axis, phase);
    const Lines lo = Lines{1} << xy::gate_lo(axis, phase);
    events[on].first |= lo;
    events[on + pwm.dead_time].second |= hi;
    events[off].first |= hi;
    events[off + pwm.dead_time].second |= lo;
  }
}

// Runs both axes to `end`; before(n) is called before time moves on to n, on_commit(n) after each
// commit, period(n) at the start of a PWM period.
struct Runner {
  XyTable& table;
  std::array<double, 2> dc_link{311, 311};
  std::array<Pwm, 2> pwm{};
  Lines drive = 0;
  Clk now = 0, period_at = 0;
  Events events{};
  long commits = 0;

  template <class OnCommit, class Period, class Before>
  void run(Clk end, OnCommit on_commit, Period period, Before before) {
    while (true) {
      if (period_at == now) {
        period(now);
        for (int k = 0; k < 2; ++k) {
          const auto axis = static_cast<std::size_t>(k);
          add_period(events, table, k, now, pwm[axis], dc_link[axis]);
        }
        period_at += kPeriod;
      }
      Clk n = std::min({table.next(), period_at, end});
      if (!events.empty()) n = std::min(n, events.begin()->first);
      before(n);
      if (table.next() == n) {
        table.commit(n, drive);
        ++commits;
        on_commit(n);
      }
      if (!events.empty() && events.begin()->first == n) {
        drive = (drive & ~events.begin()->second.first) | events.begin()->second.second;
        events.erase(events.begin());
        table.commit(n, drive);
        ++commits;
        on_commit(n);
      }
      now = n;
      if (now >= end) return;
    }
  }
  template <class OnCommit>
  void run(Clk end, OnCommit on_commit) {
    run(
        end, on_commit, [](Clk) {}, [](Clk) {});
  }
};

}  // namespace trammel::plant::test
