// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "testbench/mcafee.hpp"
#include "testbench/output.hpp"

namespace trammel::testbench {
namespace {

constexpr std::size_t kMostSamples = 4000;  // more make a heavy picture, not a better one

// Blocks $p0..: t, x, y, speed along the path, contour error, of each run; $c: the path itself.
constexpr char kPathScript[] = R"(
set output 'path.svg'
set title '{title}'
set size ratio -1
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set xlabel 'x (mm)'
set ylabel 'y (mm)'
set cblabel 'speed (0..255)'
set cbrange [0:255]
set palette defined (0 '#2c3e9e', 128 '#2ca02c', 255 '#d62728')
set key off
plot $c using 1:2 with lines lc rgb '#bbbbbb' lw 5, \
     $p0 using 2:3:4 with lines lc palette lw 2
reset
)";

constexpr char kContourScript[] = R"(
set output 'contour.svg'
set title '{title}'
set xlabel 't (s)'
set ylabel 'contour error (mm)'
set yrange [0:*]
)";

constexpr const char* kColours[] = {"#2ca02c", "#d62728", "#1f77b4"};

}  // namespace

bool write_tracking_pictures(const std::filesystem::path& folder, const mcafee::Options& options,
                             const std::vector<McafeeRun>& runs) {
  const mcafee::Path path(options.path);
  const mcafee::PointMm origin = path.at(0);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& samples = runs[r].result.samples;
    const std::size_t stride = samples.size() / kMostSamples + 1;
    fmt::format_to(out, "$p{} << EOD\n", r);
    double worst = 0;  // of the samples since the last that is drawn
    for (std::size_t k = runs[r].metrics.first; k < samples.size(); ++k) {
      worst = std::max(worst, runs[r].metrics.contour_mm[k]);
      if (k % stride != 0) continue;
      const mcafee::Sample& s = samples[k];
      fmt::format_to(out, "{:.5f} {:.4f} {:.4f} {} {:.5f}\n",
                     static_cast<double>(k - runs[r].metrics.first) * mcafee::kSampleS,
                     origin.x + s.axis[0].x_mm, origin.y + s.axis[1].x_mm, s.v, worst);
      worst = 0;
    }
    fmt::format_to(out, "EOD\n");
  }
  fmt::format_to(out, "$c << EOD\n");
  constexpr int kPieces = 2000;
  for (int k = 0; k <= kPieces; ++k) {
    const mcafee::PointMm p = path.at(path.length() * k / kPieces);
    fmt::format_to(out, "{:.4f} {:.4f}\n", p.x, p.y);
  }
  fmt::format_to(out, "EOD\n");
  const std::string title = plain_text(options.scenario);
  fmt::format_to(out, kPictureStyle, 800, 700);
  fmt::format_to(out, kPathScript, fmt::arg("title", title));
  fmt::format_to(out, kPictureStyle, 900, 420);
  fmt::format_to(out, kContourScript, fmt::arg("title", title));
  for (std::size_t r = 0; r < runs.size(); ++r) {
    fmt::format_to(out, "{}$p{} using 1:5 with lines lw 1.2 lc rgb '{}' title '{}'",
                   r == 0 ? "plot " : ", ", r, kColours[r % std::size(kColours)], runs[r].name);
  }
  fmt::format_to(out, "\nunset output\n");
  return draw(folder, fmt::to_string(text), "path.svg");
}

}  // namespace trammel::testbench
