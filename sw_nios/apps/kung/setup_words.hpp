// SPDX-License-Identifier: Apache-2.0
//
// The set-up of the program as words of memory, the same on every computer: what a loader or a test
// bench writes into the image of a core before it starts. Freestanding.
#pragma once

#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::sw {

template <class F, class... Members>
constexpr void each(F& f, Members&... members) {
  (f(members), ...);
}

// Calls f(member) for every member of a set-up in a fixed order; lists are none.
template <class Setup, class F>
constexpr void each_member(Setup& s, F&& f) {
  each(f, s.path);
  each(f, s.circle.center.x, s.circle.center.y, s.circle.radius, s.circle.ticks);
  each(f, s.window.center.x, s.window.center.y, s.window.half_side, s.window.radius,
       s.window.half_stroke_ticks, s.window.arc_ticks);
  each(f, s.star.start.x, s.star.start.y, s.star.edge, s.star.strokes, s.star.turns,
       s.star.stroke_ticks);
  each(f, s.square.low.x, s.square.low.y, s.square.high.x, s.square.high.y, s.square.half_ticks);
  each(f, s.line.from.x, s.line.from.y, s.line.to.x, s.line.to.y, s.line.ticks);
  each(f, s.sweep.center.x, s.sweep.center.y, s.sweep.amplitude.x, s.sweep.amplitude.y,
       s.sweep.first_ticks, s.sweep.ratio, s.sweep.tones, s.sweep.dwell_ticks);
  each(f, s.feed.n_segments, s.feed.n_phases, s.feed.start.x, s.feed.start.y, s.feed.begin,
       s.feed.ticks, s.feed.mean);
  each(f, s.n_points, s.repeats, s.carrier, s.position_rate, s.irq_period, s.watchdog_ticks,
       s.current_limit, s.dead_time_min, s.following_limit, s.d_current_limit, s.current_command,
       s.offset_samples);
  for (auto& a : s.axis) {
    each(f, a.kp.mant, a.kp.exp, a.ki.mant, a.ki.exp, a.kv.mant, a.kv.exp, a.eta.mant, a.eta.exp,
         a.kp_cur.mant, a.kp_cur.exp, a.ki_cur.mant, a.ki_cur.exp);
    each(f, a.shift_e, a.shift_de, a.a0, a.a0_scale, a.b2, a.angle_step, a.theta_ofs, a.adc_zeros,
         a.dead_time, a.qep_filter, a.stroke_min, a.stroke_max, a.stroke_check, a.adapt,
         a.interpolate, a.feedforward);
  }
  auto& p = s.precision;
  each(f, p.on, p.identify, p.adapt, p.learn, p.learn_gain);
  for (auto& a : p.axis) {
    for (auto& gain : a.full) each(f, gain.mant, gain.exp);
    for (auto& gain : a.soft) each(f, gain.mant, gain.exp);
    auto& e = a.estimator;
    each(f, a.misc, a.wave, a.heavy, e.mass, e.viscous, e.coulomb, e.mass_min, e.mass_max, e.pitch,
         e.slowest, e.accel_shift, e.speed_shift);
  }
}

struct SetupWords {
  static constexpr std::uint32_t kMembers = 195;  // one of 8 bytes is two words
  static constexpr std::uint32_t kUsed = 1u << 0;   // of flags: the members hold
  static constexpr std::uint32_t kStart = 1u << 1;  // the program starts by itself

  std::uint32_t flags = 0;
  std::uint32_t points = 0;  // address of the list of points; or of segments, then their phases
  std::uint32_t corrections = 0;  // address of room for them; 0: nothing is learned
  std::array<std::uint32_t, kMembers> members{};
};

constexpr std::uint32_t count_words() {
  KungSetup s;
  std::uint32_t n = 0;
  each_member(s, [&n](auto& member) { n += sizeof member > 4 ? 2 : 1; });
  return n;
}
static_assert(count_words() == SetupWords::kMembers, "the members of a set-up and their words");

constexpr void pack(const KungSetup& setup, SetupWords& words) {
  std::uint32_t n = 0;
  each_member(setup, [&](const auto& member) {
    const auto value = static_cast<std::uint64_t>(member);
    words.members[n++] = static_cast<std::uint32_t>(value & 0xFFFF'FFFFu);
    if (sizeof member > 4) words.members[n++] = static_cast<std::uint32_t>(value >> 32);
  });
  words.flags |= SetupWords::kUsed;
}

namespace detail {
template <class T>
struct Unqualified {
  using Type = T;
};
template <class T>
struct Unqualified<T&> {
  using Type = T;
};
}  // namespace detail

// All but lists, which are where `words.points` says.
[[gnu::cold]] constexpr void unpack(const SetupWords& words, KungSetup& setup) {
  std::uint32_t n = 0;
  each_member(setup, [&](auto& member) {
    std::uint64_t value = words.members[n++];
    if (sizeof member > 4) value |= std::uint64_t{words.members[n++]} << 32;
    member = static_cast<typename detail::Unqualified<decltype(member)>::Type>(value);
  });
}

}  // namespace trammel::sw
