// SPDX-License-Identifier: Apache-2.0
//
// Words of the controllers for the record, of the bit-exact twin; of the verilated chip they are
// in verilated/probe.hpp.
#pragma once

#include "machines/kung/chip/chip.hpp"
#include "models/exact/chips/kung_xy.hpp"

namespace trammel::kung {

inline void twin_words(const exact::KungXy& chip, int axis, AxisSample& s) {
  const exact::Afc& afc = chip.afc(axis);
  const exact::Afc::Out& p = afc.out();
  const exact::CurrentLoop::Out& c = chip.current(axis).out();
  s.r = afc.r();
  s.x_p = afc.x_p();
  s.x_m = p.x_m;
  s.x_r = p.x_r;
  s.dx = p.dx;
  s.e = p.e;
  s.de = p.de;
  s.u = p.u;
  s.v_star = p.v_star;
  s.v = p.v;
  s.i_q_ref = p.i_q_ref;
  s.i_d = c.i_d;
  s.i_q = c.i_q;
  s.v_d = c.v_d;
  s.v_q = c.v_q;
  if (!chip.is_precise(axis)) return;
  s.x_p = chip.position(axis);
  s.i_q_ref = chip.precision().out(axis).i_q_ref;
  show_precision(chip.precision().set_point(axis),
                 chip.precision().word(axis, exact::PrecisionStore::Word::kV24), s);
}

inline AxisLaw twin_law(const exact::KungXy& chip, int axis) {
  if (!chip.is_precise(axis)) return {};
  const exact::Precision::State& s = chip.precision().law(axis);
  const auto word = [](std::int64_t of) { return static_cast<std::int32_t>(of); };
  return {word(s.d),    word(s.acc), word(s.aff), word(s.vff),
          word(s.iacc), s.km,        s.kb,        word(s.fc)};
}

inline CurrentWords twin_current(const exact::KungXy& chip, int axis) {
  const exact::KungCurrent& loop = chip.current(axis);
  const exact::CurrentLoop::Out& out = loop.out();
  CurrentWords words;
  words.code_a = loop.codes()[0];
  words.code_b = loop.codes()[1];
  words.count = loop.count();
  words.i_q_ref = loop.i_q_ref();
  words.cmp_a = out.cmp_a;
  words.cmp_b = out.cmp_b;
  words.cmp_c = out.cmp_c;
  words.i_d = out.i_d;
  words.i_q = out.i_q;
  words.v_d = out.v_d;
  words.v_q = out.v_q;
  words.busy = loop.busy(chip.now() - 1);
  words.clear = loop.cleared();
  return words;
}

}  // namespace trammel::kung
