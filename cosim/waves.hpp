// SPDX-License-Identifier: Apache-2.0
//
// Which clocks of a run are dumped as waves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

enum class WaveFormat { kNone, kVcd, kFst };

// What a traced chip dumps: the edges [begin, end), and the same again every `period` edges.
struct WaveWindow {
  Clk begin = 0;
  Clk end = 0;
  Clk period = kNever;

  void next() {
    const bool more = period != kNever;
    begin = more ? begin + period : kNever;
    end = more ? end + period : kNever;
  }
};

// Clock edges [begin, end) for which waves were dumped.
struct WaveSpan {
  Clk begin = 0;
  Clk end = 0;
};

// The part of a window, which may begin before edge 0, that a run of so many clocks has dumped.
inline std::vector<WaveSpan> wave_spans(WaveWindow window, Clk clocks) {
  std::vector<WaveSpan> spans;
  for (; window.begin < clocks; window.next()) {
    const WaveSpan cut{std::max<Clk>(0, window.begin), std::min(window.end, clocks)};
    if (cut.begin < cut.end) spans.push_back(cut);
  }
  return spans;
}

// Of times in a wave file: ns where half a period has no fraction of one, else ps.
struct WaveScale {
  const char* unit;
  std::int64_t period;  // [unit] of the clock
};
inline WaveScale wave_scale(std::int64_t clock_ps) {
  if (clock_ps % 2000 == 0) return {"ns", clock_ps / 1000};
  return {"ps", clock_ps};
}

// The system's number of the first error in writing waves since this was asked last, or 0.
int take_wave_error();

}  // namespace trammel::cosim
