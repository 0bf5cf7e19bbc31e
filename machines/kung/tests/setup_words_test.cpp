// SPDX-License-Identifier: Apache-2.0
//
// What a loader gives to the program of a core: every member of a set-up, by its name, and the room
// in the core's memory.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "machines/kung/machine.hpp"
#include "machines/kung/soc.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "sw_nios/hal/soc_map.hpp"

using namespace trammel;
using Catch::Matchers::Contains;

namespace {

// A new member of the program, of an axis, of the path or of the precision controller belongs into
// `each_named`, unless it is the address of a list.
static_assert(sizeof(void*) != 8 || sizeof(sw::KungSetup) == 808);

template <class F>
void named_gain(F& f, const std::string& name, sw::Gain& gain) {
  f(name + ".mant", gain.mant);
  f(name + ".exp", gain.exp);
}

template <class F>
void named_path(F& f, sw::KungSetup& s) {
  f("path", s.path), f("n_points", s.n_points), f("repeats", s.repeats);
  f("circle.center.x", s.circle.center.x), f("circle.center.y", s.circle.center.y);
  f("circle.radius", s.circle.radius), f("circle.ticks", s.circle.ticks);
  f("window.center.x", s.window.center.x), f("window.center.y", s.window.center.y);
  f("window.half_side", s.window.half_side), f("window.radius", s.window.radius);
  f("window.half_stroke_ticks", s.window.half_stroke_ticks);
  f("window.arc_ticks", s.window.arc_ticks);
  f("star.start.x", s.star.start.x), f("star.start.y", s.star.start.y);
  f("star.edge", s.star.edge), f("star.strokes", s.star.strokes), f("star.turns", s.star.turns);
  f("star.stroke_ticks", s.star.stroke_ticks);
  f("square.low.x", s.square.low.x), f("square.low.y", s.square.low.y);
  f("square.high.x", s.square.high.x), f("square.high.y", s.square.high.y);
  f("square.half_ticks", s.square.half_ticks);
  f("line.from.x", s.line.from.x), f("line.from.y", s.line.from.y);
  f("line.to.x", s.line.to.x), f("line.to.y", s.line.to.y), f("line.ticks", s.line.ticks);
  f("sweep.center.x", s.sweep.center.x), f("sweep.center.y", s.sweep.center.y);
  f("sweep.amplitude.x", s.sweep.amplitude.x), f("sweep.amplitude.y", s.sweep.amplitude.y);
  f("sweep.first_ticks", s.sweep.first_ticks), f("sweep.ratio", s.sweep.ratio);
  f("sweep.tones", s.sweep.tones), f("sweep.dwell_ticks", s.sweep.dwell_ticks);
  f("feed.n_segments", s.feed.n_segments), f("feed.n_phases", s.feed.n_phases);
  f("feed.start.x", s.feed.start.x), f("feed.start.y", s.feed.start.y);
  f("feed.begin", s.feed.begin), f("feed.ticks", s.feed.ticks), f("feed.mean", s.feed.mean);
}

template <class F>
void named_axis(F& f, const std::string& of, sw::AxisSetup& a) {
  named_gain(f, of + "kp", a.kp), named_gain(f, of + "ki", a.ki), named_gain(f, of + "kv", a.kv);
  named_gain(f, of + "eta", a.eta), named_gain(f, of + "kp_cur", a.kp_cur);
  named_gain(f, of + "ki_cur", a.ki_cur);
  f(of + "shift_e", a.shift_e), f(of + "shift_de", a.shift_de), f(of + "a0", a.a0);
  f(of + "a0_scale", a.a0_scale), f(of + "b2", a.b2), f(of + "angle_step", a.angle_step);
  f(of + "theta_ofs", a.theta_ofs), f(of + "adc_zeros", a.adc_zeros);
  f(of + "dead_time", a.dead_time), f(of + "qep_filter", a.qep_filter);
  f(of + "stroke_min", a.stroke_min), f(of + "stroke_max", a.stroke_max);
  f(of + "stroke_check", a.stroke_check), f(of + "adapt", a.adapt);
  f(of + "interpolate", a.interpolate), f(of + "feedforward", a.feedforward);
}

template <class F>
void named_precision(F& f, const std::string& of, sw::PrecisionAxisSetup& a) {
  for (std::size_t k = 0; k < a.full.size(); ++k) {
    named_gain(f, of + "full " + std::to_string(k), a.full[k]);
    named_gain(f, of + "soft " + std::to_string(k), a.soft[k]);
  }
  f(of + "misc", a.misc), f(of + "wave", a.wave), f(of + "heavy", a.heavy);
  sw::EstimatorSetup& e = a.estimator;
  f(of + "mass", e.mass), f(of + "viscous", e.viscous), f(of + "coulomb", e.coulomb);
  f(of + "mass_min", e.mass_min), f(of + "mass_max", e.mass_max), f(of + "pitch", e.pitch);
  f(of + "slowest", e.slowest), f(of + "accel_shift", e.accel_shift);
  f(of + "speed_shift", e.speed_shift);
}

template <class F>
void each_named(sw::KungSetup& s, F f) {
  named_path(f, s);
  f("carrier", s.carrier), f("position_rate", s.position_rate), f("irq_period", s.irq_period);
  f("watchdog_ticks", s.watchdog_ticks), f("current_limit", s.current_limit);
  f("dead_time_min", s.dead_time_min), f("following_limit", s.following_limit);
  f("d_current_limit", s.d_current_limit), f("current_command", s.current_command);
  f("offset_samples", s.offset_samples);
  f("precision.on", s.precision.on), f("precision.identify", s.precision.identify);
  f("precision.adapt", s.precision.adapt), f("precision.learn", s.precision.learn);
  f("precision.learn_gain", s.precision.learn_gain);
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string axis = a == 0 ? "x." : "y.";
    named_axis(f, axis, s.axis[a]);
    named_precision(f, axis + "precision.", s.precision.axis[a]);
  }
}

std::map<std::string, std::int64_t> values(sw::KungSetup& setup) {
  std::map<std::string, std::int64_t> all;
  each_named(setup, [&](const std::string& name, auto& member) {
    all[name] = static_cast<std::int64_t>(member);
  });
  return all;
}

}  // namespace

TEST_CASE("every member of a set-up goes to the core and comes back, alone") {
  sw::KungSetup plain;
  const auto before = values(plain);
  for (const auto& [changed, was] : before) {
    sw::KungSetup given, back;
    std::int64_t wanted = 0;
    each_named(given, [&, &changed = changed](const std::string& name, auto& member) {
      using Member = std::decay_t<decltype(member)>;
      if (name != changed) return;
      if constexpr (std::is_same_v<Member, bool>) {
        member = !member;
      } else {
        member = static_cast<Member>(static_cast<std::int64_t>(member) ^ 5);
      }
      wanted = static_cast<std::int64_t>(member);
    });
    sw::SetupWords words;
    sw::pack(given, words);
    sw::unpack(words, back);
    auto expected = before;
    expected[changed] = wanted;
    for (const auto& [name, value] : values(back)) {
      CAPTURE(changed, name);
      if (value != expected[name]) CHECK(value == expected[name]);
    }
  }
}

TEST_CASE("lists have the room from the program's data to the stack, which is 2 KiB at the end") {
  if (kung::core_image().empty()) return;  // built without the cross compiler
  namespace map = sw::soc_map;
  constexpr std::uint32_t kMemory = 4 * 16384, kStack = 2048;  // [byte], Words of kung_soc.sv
  sw::KungSetup setup;
  const kung::CoreMemory memory = kung::core_memory(setup, true);
  const std::uint32_t free = memory.at(map::kHeader / 4 + map::kFree);
  CHECK(memory.at(map::kHeader / 4 + map::kLimit) == kMemory - kStack);
  const std::uint32_t room = (kMemory - kStack - free) / 8;
  std::vector<sw::Point> points(room + 1);
  setup.path = sw::Path::kPoints;
  setup.points = points.data();
  setup.n_points = room;
  CHECK_NOTHROW(kung::core_memory(setup, true));
  setup.n_points = room + 1;
  CHECK_THROWS_WITH(kung::core_memory(setup, true),
                    Contains("its memory has room for " + std::to_string(room)));
}
