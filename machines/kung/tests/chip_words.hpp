// SPDX-License-Identifier: Apache-2.0
//
// Everything that kung_xy shows at a stop of the loop, in one comparable list.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "machines/kung/chip.hpp"

namespace trammel::test {

struct StopWords {
  cosim::Stop stop;
  cosim::Lines drive = 0;
  std::vector<std::int64_t> words;

  bool operator==(const StopWords& o) const {
    return stop.edge == o.stop.edge && stop.why == o.stop.why && drive == o.drive &&
           words == o.words;
  }
};

inline std::vector<std::int64_t> integer_words(const kung::AxisSample& s) {
  return {s.r, s.x_p, s.x_r, s.x_m, s.dx,  s.e,   s.de, s.u,
          s.v_star, s.v, s.i_q_ref, s.i_d, s.i_q, s.v_d, s.v_q};
}

inline StopWords look(const cosim::Stop& stop, const kung::KungChip& chip) {
  StopWords all{stop, chip.drive(), {chip.irq() ? 1 : 0, chip.rdata()}};
  const kung::Fault fault = chip.fault();
  all.words.insert(all.words.end(), {static_cast<int>(fault.code), fault.axis, fault.tick});
  for (int axis = 0; axis < kung::kAxes; ++axis) {
    kung::AxisSample sample;
    chip.read_words(axis, sample);
    const auto words = integer_words(sample);
    all.words.insert(all.words.end(), words.begin(), words.end());
    const kung::CurrentWords c = chip.current(axis);
    all.words.insert(all.words.end(), {c.code_a, c.code_b, c.count, c.i_q_ref, c.cmp_a, c.cmp_b,
                                       c.cmp_c, c.busy ? 1 : 0, c.clear ? 1 : 0,
                                       chip.integral(axis)});
    if ((stop.why & cosim::kSample) == 0) continue;
    for (int rule = 0; rule < 49; ++rule) all.words.push_back(chip.rule(axis, rule));
  }
  return all;
}

}  // namespace trammel::test
