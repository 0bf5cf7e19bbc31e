// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>

#include "testbench/an693.hpp"
#include "testbench/output.hpp"

namespace trammel::testbench {
namespace {

constexpr std::size_t kMostDrawn = 6000;  // samples: more make a heavy picture, not a better one

// Four panels of one block $d: t, desired, real, error, p, i, d, output, then the pin HI and
// status bits 1 to 7, each on a line of its own.
constexpr char kMotionScript[] = R"(
set output 'motion.svg'
set multiplot layout 4,1 title '{title}'
set lmargin 12
set rmargin 12
set xrange [{from}:{to}]
set ylabel 'position (counts)'
plot $d using 1:2 with lines lc rgb '#bbbbbb' lw 3 title 'desired', \
     $d using 1:3 with lines lc rgb '#d62728' lw 1.5 title 'real'
set ylabel 'error (counts)'
plot $d using 1:4 with lines lc rgb '#d62728' title ''
set ylabel 'filter'
plot $d using 1:8 with lines lc rgb '#bbbbbb' title 'output', \
     $d using 1:7 with lines lc rgb '#9467bd' title 'd', \
     $d using 1:5 with lines lc rgb '#1f77b4' lw 1.5 title 'p', \
     $d using 1:6 with lines lc rgb '#2ca02c' lw 1.5 title 'i'
set ylabel 'status'
set xlabel 'time (s)'
set yrange [-0.3:8]
set ytics ('HI' 0.35, 'error' 1.35, 'complete' 2.35, 'index' 3.35, 'wrap' 4.35, \
           'position' 5.35, 'breakpoint' 6.35, 'off' 7.35) font ',10'
plot for [k=0:7] $d using 1:(k + 0.7 * column(9 + k)) with steps lc rgb '#444444' title ''
unset multiplot
unset output
)";

}  // namespace

bool write_motion_picture(const std::filesystem::path& folder, const lm628::Options& options,
                          const lm628::Result& result) {
  const auto& samples = result.samples;
  if (samples.size() < 2) return false;
  const std::size_t stride = samples.size() / kMostDrawn + 1;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, kPictureStyle, 900, 1000);
  fmt::format_to(out, "$d << EOD\n");
  unsigned status = 0;
  bool irq = false;
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const lm628::Sample& s = samples[n];
    const lm628::Words& w = s.words;
    status |= w.status;  // a bit of one sample is seen though that sample is not drawn
    irq = irq || s.host_irq;
    if (n % stride != stride - 1) continue;
    fmt::format_to(out, "{:.6f} {:.3f} {:.3f} {} {} {} {} {} {}", seconds_at(options, s.edge),
                   static_cast<double>(w.position) / 65536,
                   shaft_counts(options, s), w.error,
                   w.proportional, w.integral, w.derivative, w.output, irq ? 1 : 0);
    for (unsigned bit = 1; bit < 8; ++bit) fmt::format_to(out, " {}", status >> bit & 1u);
    fmt::format_to(out, "\n");
    status = 0;
    irq = false;
  }
  fmt::format_to(out, "EOD\n");
  fmt::format_to(out, kMotionScript, fmt::arg("title", plain_text(options.scenario)),
                 fmt::arg("from", seconds_at(options, samples.front().edge)),
                 fmt::arg("to", seconds_at(options, samples.back().edge)));
  return draw(folder, fmt::to_string(text), "motion.svg");
}

}  // namespace trammel::testbench
