// SPDX-License-Identifier: Apache-2.0
//
// Everything that kung_xy shows at a stop of the loop, in one comparable list with a name for each
// word of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "machines/kung/chip/chip.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

inline constexpr int kRules = 49;

struct StopValues {
  cosim::Stop stop;
  cosim::Lines drive = 0;
  std::vector<std::int64_t> words;

  bool operator==(const StopValues& o) const {
    return stop.edge == o.stop.edge && stop.why == o.stop.why && drive == o.drive &&
           words == o.words;
  }
};

inline std::vector<std::int64_t> integer_values(const kung::AxisSample& s) {
  return {s.r, s.x_p, s.x_r, s.x_m, s.dx,  s.e,   s.de, s.u,
          s.v_star, s.v, s.i_q_ref, s.i_d, s.i_q, s.v_d, s.v_q};
}

inline const std::vector<std::string>& integer_names() {
  static const std::vector<std::string> names{"r", "x_p", "x_r", "x_m", "dx",  "e",   "de", "u",
                                              "v_star", "v", "i_q_ref", "i_d", "i_q", "v_d", "v_q"};
  return names;
}

inline StopValues look(const cosim::Stop& stop, const kung::KungChip& chip) {
  StopValues all{stop, chip.drive(), {chip.irq() ? 1 : 0, chip.rdata()}};
  const kung::Fault fault = chip.fault();
  all.words.insert(all.words.end(), {static_cast<int>(fault.code), fault.axis, fault.tick});
  for (int axis = 0; axis < kung::kAxes; ++axis) {
    kung::AxisSample sample;
    chip.read_words(axis, sample);
    // Words of the precision controller may be in motion.
    if (sample.set_point != kung::kNoSetPoint && (stop.why & cosim::kSample) == 0) {
      const std::int32_t i_q_ref = sample.i_q_ref;
      sample = {};
      sample.i_q_ref = i_q_ref;
    }
    const auto words = integer_values(sample);
    all.words.insert(all.words.end(), words.begin(), words.end());
    const kung::CurrentWords c = chip.current(axis);
    all.words.insert(all.words.end(), {c.code_a, c.code_b, c.count, c.i_q_ref, c.cmp_a, c.cmp_b,
                                       c.cmp_c, c.busy ? 1 : 0, c.clear ? 1 : 0,
                                       chip.integral(axis)});
    if ((stop.why & cosim::kSample) == 0) continue;
    for (int rule = 0; rule < kRules; ++rule) all.words.push_back(chip.rule(axis, rule));
  }
  return all;
}

// Of the words of look(), which has the rules at samples only.
inline std::vector<std::string> stop_names(bool sample) {
  std::vector<std::string> names{"irq", "rdata", "fault.code", "fault.axis", "fault.tick"};
  for (const std::string axis : {"X.", "Y."}) {
    for (const std::string& name : integer_names()) names.push_back(axis + name);
    for (const char* name : {"code_a", "code_b", "count", "i_q_ref", "cmp_a", "cmp_b", "cmp_c",
                             "busy", "clear", "integral"}) {
      names.push_back(axis + "current." + name);
    }
    for (int rule = 0; sample && rule < kRules; ++rule) {
      names.push_back(axis + "rule[" + std::to_string(rule) + "]");
    }
  }
  return names;
}

// "X.e of the RTL is 4, of its twin 5" for each word that differs.
inline std::string differences(const std::vector<std::string>& names,
                               const std::vector<std::int64_t>& rtl,
                               const std::vector<std::int64_t>& twin) {
  std::string all;
  for (std::size_t n = 0; n < std::max(rtl.size(), twin.size()); ++n) {
    const auto text = [n](const std::vector<std::int64_t>& words) {
      return n < words.size() ? number(words[n]) : std::string("not there");
    };
    if (text(rtl) == text(twin)) continue;
    if (!all.empty()) all += "; ";
    all += names.at(n) + " of the RTL is " + text(rtl) + ", of its twin " + text(twin);
  }
  return all;
}

// "" if they are the same.
inline std::string differences(const StopValues& rtl, const StopValues& twin) {
  if (rtl == twin) return "";
  const bool sample = (rtl.stop.why & cosim::kSample) != 0;
  const auto heads = [](const StopValues& s) {
    return std::vector<std::int64_t>{s.stop.edge, s.stop.why, static_cast<std::int64_t>(s.drive)};
  };
  const std::string head = differences({"edge", "reason", "gates"}, heads(rtl), heads(twin));
  // Words of different edges differ anyway.
  const bool alike = rtl.words.size() == twin.words.size() && rtl.stop.edge == twin.stop.edge;
  const std::string words =
      alike ? differences(stop_names(sample), rtl.words, twin.words) : std::string();
  return "edge " + std::to_string(rtl.stop.edge) + ": " + head +
         (head.empty() || words.empty() ? "" : "; ") + words;
}

}  // namespace trammel::test
