// SPDX-License-Identifier: Apache-2.0
//
// Whether the table did what the program was to make it do, by its true position; and why the
// program itself gave up.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/mcafee/machine_members.hpp"
#include "parts/lm628/rest.hpp"

namespace trammel::mcafee {
namespace {

double diagonal_mm(const Path& path, const Table& table) {
  PointMm low = path.at(0), high = low;
  for (std::size_t row = 1; row <= table.rows.size(); ++row) {
    const PointMm p = path.at(std::min(path.length(), table.row_mm * static_cast<double>(row)));
    low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
    high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
  }
  return std::abs(high - low);
}

// Of one axis: where it rests, over the last quarter of the time for which it was to stand there.
// Until then it may swing: the square ends at full speed, and the amplifier's current is limited.
std::string not_at(const Options& options, const Result& result, std::size_t axis, double target,
                   double band) {
  const auto& all = result.samples;
  const auto wait = static_cast<std::size_t>(options.wait_s / options.sample_s() / 4);
  const std::size_t last = all.size() - 1;
  const lm628::Rest rest = lm628::rest_of(
      last - std::min(last, wait), last, target,
      [&](std::size_t k) { return all[k].axis[axis].x_mm / options.count_mm(); });
  const char name = axis == 0 ? 'X' : 'Y';
  if (rest.moves > band) {
    return fmt::format("{} still moves by {:.0f} counts at the end; trajectory.wait_s gives it "
                       "time", name, rest.moves);
  }
  if (std::abs(rest.off) <= band) return "";
  return fmt::format("{} ended {:.0f} counts from its target of {:.0f}", name, std::abs(rest.off),
                     target);
}

}  // namespace

void find_contour(const Options& options, Result& result) {
  constexpr double kReachMm = 10;  // a path may cross itself
  result.contour_mm = {};
  if (!options.tracks()) return;
  const Path path(options.path);
  for (const Sample& s : result.samples) {
    result.contour_mm.push_back(
        path.distance(path.at(0) + PointMm{s.axis[0].x_mm, s.axis[1].x_mm},
                      result.table.row_mm * s.row, kReachMm));
  }
}

const char* what_failed(const sw::Mailbox& mailbox) {
  switch (static_cast<sw::McafeeFailure>(mailbox.failure)) {
    case sw::McafeeFailure::kReset: return "a status after reset that the data sheet has not";
    case sw::McafeeFailure::kBusy: return "a busy bit that did not clear";
    case sw::McafeeFailure::kCommandError: return "a command error of a part";
    case sw::McafeeFailure::kPositionError: return "a position error of a part";
    case sw::McafeeFailure::kLimit: return "a limit switch";
    case sw::McafeeFailure::kIndex: return "an index that is not a turn from the one before";
    case sw::McafeeFailure::kLate:
      return "a sample between the STT of both axes: the processor is too slow "
             "(processor.access_clk, processor.interrupt_latency_clk)";
    case sw::McafeeFailure::kNone: break;
  }
  return "";
}

std::string what_missed(const Options& options, const Result& result) {
  if (result.samples.empty() || options.stage == sw::McafeeStage::kRead) return "";
  if (!options.tracks()) {
    return not_at(options, result, 0, options.position,
                  lm628::reached_band(options.reached_counts, std::abs(options.position)));
  }
  const std::size_t begun = result.samples.back().row, rows = result.table.rows.size();
  if (begun < rows) return fmt::format("stopped after {} of {} rows", begun, rows);
  const Path path(options.path);
  const double counts = diagonal_mm(path, result.table) / options.count_mm();
  const double band = lm628::reached_band(options.reached_counts, counts);
  PointMm target;  // [count]
  for (const sw::McafeeRow& row : result.table.rows) target += PointMm(row.dx, row.dy);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::string what =
        not_at(options, result, axis, axis == 0 ? target.real() : target.imag(), band);
    if (!what.empty()) return what;
  }
  const double beside = options.reached_counts != 0 ? band : std::max(band, counts / 20);
  double most = 0;
  for (const double mm : result.contour_mm) most = std::max(most, mm / options.count_mm());
  if (most <= beside) return "";
  return fmt::format("the table was {:.0f} counts beside its path, above {:.0f} "
                     "(run.reached_counts)", most, beside);
}

}  // namespace trammel::mcafee
