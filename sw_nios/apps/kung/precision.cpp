// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/kung/precision.hpp"

#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "sw_nios/apps/kung/identification.hpp"
#include "sw_nios/apps/kung/rounding.hpp"
#include "sw_nios/path/feed_prefilter.hpp"

namespace trammel::sw {
namespace {

namespace reg = kung_xy_regs;

constexpr std::array<std::uint32_t, 2> kWindows{reg::kX, reg::kY};
constexpr std::uint32_t kKnotWords = 0, kTickWords = 8;  // of the window
constexpr std::uint32_t kK1 = 3;                         // of the gains

constexpr std::int32_t kLate = 16 * 256 * 32;  // 16 counts in the mean of a knot [ERR_SUM]
constexpr std::int32_t kSlower = 4;            // K1 times 2^-4: late on circle and window, no swing

// The observer's d has carried what a corrected force adds at once, and gives it back too late:
// 16 ms are slow for it. A new mass is no such step, as RATIO leaves the current where it was.
constexpr std::uint32_t kFollow = 3;  // 2^-3 a knot

void follow(Estimator::Theta& fed, const Estimator::Theta& found) {
  for (std::uint32_t n = 0; n < fed.size(); ++n) fed[n] += rs(found[n] - fed[n], kFollow);
  fed[Estimator::kMass] = found[Estimator::kMass];
}

constexpr std::uint32_t as_word(std::int32_t value) { return static_cast<std::uint32_t>(value); }

}  // namespace

PrecisionControl::PrecisionControl(const PrecisionSetup& setup, Point start, Point move,
                                   std::uint32_t size, std::uint32_t lap)
    : setup_(setup),
      start_{256 * start.x, 256 * start.y},
      move_(move),
      before_path_(setup.identify ? Identification::kPoints : 0),
      size_(size),
      axes_{{{Estimator(setup.axis[0].estimator, start_.x), {}, {}, {}, {}, {}, {}, {}},
             {Estimator(setup.axis[1].estimator, start_.y), {}, {}, {}, {}, {}, {}, {}}}} {
  for (std::uint32_t a = 0; a < 2; ++a) {
    Axis& axis = axes_[a];
    const std::int32_t at = a == 0 ? start_.x : start_.y;
    axis.points = axis.corrected = {at, at, at};
    axis.control = at;
    axis.fed = axis.estimator.theta();
    axis.words = knot_words(axis.fed, setup.axis[a].estimator);
    if (setup.learn && setup.corrections != nullptr) {
      axis.learning = Learning(&setup.corrections->of[a], lap, setup.learn_gain);
    }
  }
}

void PrecisionControl::give(Point point) {
  const bool path = needs_point();
  const std::uint32_t n = given_++;
  if (!path) {
    point = {start_.x + Identification::offset(n, move_.x),
             start_.y + Identification::offset(n, move_.y)};
  }
  for (std::uint32_t a = 0; a < 2; ++a) {
    Axis& axis = axes_[a];
    const std::int32_t at = a == 0 ? point.x : point.y;
    const std::int32_t learned =
        path && n - before_path_ < size_ ? axis.learning.correction(n - before_path_) : 0;
    axis.points = {at, axis.points[0], axis.points[1]};
    axis.corrected = {at + learned, axis.corrected[0], axis.corrected[1]};
  }
}

void PrecisionControl::start(Bus& bus) {
  for (std::uint32_t a = 0; a < 2; ++a) {
    const PrecisionAxisSetup& axis = setup_.axis[a];
    write_gains(bus, a, setup_.identify ? axis.soft : axis.full);
    bus.write(kWindows[a] + reg::kPrecData, axis.misc);
    write_knot(bus, a, a == 0 ? start_.x : start_.y, 0, 0);
  }
}

void PrecisionControl::serve(Bus& bus) {
  for (std::uint32_t a = 0; a < 2; ++a) estimate(bus, a);
  if (setup_.identify && given_ - 2 == Identification::kFull) {
    for (std::uint32_t a = 0; a < 2; ++a) write_gains(bus, a, setup_.axis[a].full);
  }
  for (std::uint32_t a = 0; a < 2; ++a) command(bus, a);
  bus.write(reg::kCommit, reg::kCommitTake);
}

void PrecisionControl::estimate(Bus& bus, std::uint32_t a) {
  Axis& axis = axes_[a];
  const auto err_sum = static_cast<std::int32_t>(bus.read(kWindows[a] + reg::kErrSum));
  const auto iq_sum = static_cast<std::int32_t>(bus.read(kWindows[a] + reg::kIqSum));
  if (setup_.adapt || !on_path()) axis.estimator.step(err_sum, iq_sum);
  if (!on_path()) return;
  axis.learning.step(given_ - 2 - before_path_, axis.points[1] - axis.points[2], err_sum);
  const bool heavy = axis.estimator.theta()[Estimator::kMass] >= setup_.axis[a].heavy;
  if (!axis.late && heavy && (err_sum > kLate || err_sum < -kLate)) slow_down(bus, a);
}

// The rest of the current could not brake what K1 asks for: from now on an error decays slowly.
void PrecisionControl::slow_down(Bus& bus, std::uint32_t a) {
  axes_[a].late = true;
  Gain k1 = setup_.axis[a].full[kK1];
  k1.exp = clip(k1.exp - kSlower, -16, 15);
  bus.write(kWindows[a] + reg::kPrecAddr, kTickWords + kK1);
  bus.write(kWindows[a] + reg::kPrecData, gain_word(k1));
}

void PrecisionControl::command(Bus& bus, std::uint32_t a) {
  Axis& axis = axes_[a];
  if (on_path()) {
    follow(axis.fed, axis.estimator.theta());
  } else {
    axis.fed = axis.estimator.theta();
  }
  const Estimator::Theta& theta = axis.fed;
  const EstimatorSetup& words = setup_.axis[a].estimator;
  const KnotWords before = axis.words;
  axis.words = knot_words(theta, words);
  const std::int32_t c = prefilter(axis.corrected[2], axis.corrected[1], axis.corrected[0]);
  write_knot(bus, a, c, force_current(theta, axis.points[2], axis.points[1], words.pitch),
             mass_ratio(before.km, axis.words.km));
  // What this interrupt writes is in effect from the next knot on: its sums come after that.
  axis.estimator.command(axis.control);
  axis.control = c;
}

void PrecisionControl::write_gains(Bus& bus, std::uint32_t a, const LawGains& gains) const {
  bus.write(kWindows[a] + reg::kPrecAddr, kTickWords);
  for (const Gain& gain : gains) bus.write(kWindows[a] + reg::kPrecData, gain_word(gain));
}

void PrecisionControl::write_knot(Bus& bus, std::uint32_t a, std::int32_t c, std::int32_t iff,
                                  std::int32_t ratio) const {
  const KnotWords& words = axes_[a].words;
  const std::uint32_t data = kWindows[a] + reg::kPrecData;
  bus.write(kWindows[a] + reg::kPrecAddr, kKnotWords);
  bus.write(data, as_word(c));
  bus.write(data, as_word(iff));
  bus.write(data, gain_word(words.km));
  bus.write(data, gain_word(words.kmi));
  bus.write(data, as_word(ratio));
  bus.write(data, gain_word(words.kb));
  bus.write(data, as_word(words.fc));
}

}  // namespace trammel::sw
