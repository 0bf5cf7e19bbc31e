// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <complex>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {
namespace {

constexpr double kQ14 = 16384;  // of a count in x_m

// What the current loop sees of a command that the processor writes behind a position tick: it
// holds for the `hold` current periods from the next one on, and the i_q of a record is that of the
// period before its tick. Images at multiples of the position rate, which the records fold back,
// are neglected.
std::complex<double> held(double turns, int hold) {  // `turns`: of the tone in a current period
  std::complex<double> sum;
  for (int k = 2; k < hold + 2; ++k) sum += std::polar(1.0 / hold, -2 * kPi * turns * k);
  return sum;
}

struct Pair {
  lab::ToneSum in, out;
  explicit Pair(std::size_t period) : in(period), out(period) {}
  void add(double from, double to) {
    in.add(from);
    out.add(to);
  }
  std::complex<double> gain() const { return out.sum() / in.sum(); }
  // Both amplitudes are at least that of a step of the words.
  bool seen(std::uint32_t samples, double step) const {
    return 2 * std::min(std::abs(in.sum()), std::abs(out.sum())) >= step * samples;
  }
};

}  // namespace

std::vector<LoopResponse> responses(const Plan& plan, const Result& result, std::size_t axis) {
  const Options& options = plan.options;
  if (options.path.kind != PathKind::kSweep) return {};
  const bool current = options.path.open_position();
  std::vector<LoopResponse> loops;
  for (const char* loop : {"position", "speed", "current"}) {
    if (current == (std::string(loop) == "current")) loops.push_back({loop, {}});
  }
  const sw::KungSetup& setup = plan.setup;
  sw::Trajectory path(setup);
  const int hold = options.chip.carrier_Hz / options.chip.position_Hz;
  const Range range = counted(result);
  std::size_t k = range.first;
  for (sw::SteppedSine::Tones tones(setup.sweep); !tones.ended(); tones.next()) {
    const sw::SteppedSine::Tone tone = tones.tone();
    const double hz = 1.0 * options.chip.position_Hz / tone.period;
    if (k + 2 * tone.settle > range.last) break;
    for (std::uint32_t n = 0; n < tone.settle; ++n) path.next();
    k += tone.settle;
    Pair first(tone.period), second(tone.period);
    for (std::uint32_t n = 0; n < tone.settle; ++n, ++k) {
      const sw::Point point = path.next();
      const AxisSample sample = result.samples[current ? k - 1 : k].axis[axis];
      if (current) {
        const double words = axis == 0 ? point.x - setup.sweep.center.x
                                       : point.y - setup.sweep.center.y;
        first.add(words, 2.0 * sample.i_q);  // in units of i_q*
      } else {
        first.add(sample.x_m / kQ14, sample.x_p);
        second.add(sample.v_star, sample.v);
      }
    }
    const double periods = static_cast<double>(tone.period) * hold;
    const std::complex<double> command = current ? held(1.0 / periods, hold) : 1.0;
    if (first.seen(tone.settle, current ? 2 : 1)) {
      loops[0].closed.push_back({hz, first.gain() / command});
    }
    if (!current && second.seen(tone.settle, 1)) loops[1].closed.push_back({hz, second.gain()});
  }
  return loops;
}

std::string unmeasured(const Plan& plan, const Result& result) {
  for (std::size_t a = 0; a < 2; ++a) {
    for (const LoopResponse& loop : responses(plan, result, a)) {
      if (!loop.closed.empty()) continue;
      return fmt::format("the {} loop of {} shows no tone of the sweep: its amplitude is too small",
                         loop.loop, a == 0 ? 'X' : 'Y');
    }
  }
  return "";
}

std::string sweep_text(const Plan& plan, const Result& result) {
  std::size_t least = sw::kMaxTicks, most = 0;
  for (std::size_t a = 0; a < 2; ++a) {
    for (const LoopResponse& loop : responses(plan, result, a)) {
      least = std::min(least, loop.closed.size());
      most = std::max(most, loop.closed.size());
    }
  }
  const bool current = plan.options.path.open_position();
  return fmt::format("measured {} of both axes at {}{} {}",
                     current ? "the current loop" : "position and speed loop",
                     least == most ? "" : fmt::format("{} to ", least), most,
                     most == 1 ? "frequency" : "frequencies");
}

void add_responses(std::vector<lab::Figure>& list, const Plan& plan, const Result& result) {
  for (std::size_t a = 0; a < 2; ++a) {
    for (const LoopResponse& loop : responses(plan, result, a)) {
      if (loop.closed.empty()) continue;
      const lab::Margins m = lab::margins(loop.closed);
      const char* axis = a == 0 ? "x" : "y";
      const std::string row = fmt::format("{} loop of {}", loop.loop, a == 0 ? 'X' : 'Y');
      const auto add = [&](const char* id, const char* column, std::optional<double> value,
                           const char* unit) {
        if (!value) return;
        list.push_back(lab::figure(fmt::format("{}.response.{}.{}", axis, loop.loop, id), row,
                                   column, *value, unit, 2));
      };
      add("bandwidth_Hz", "bandwidth", m.bandwidth_hz, "Hz");
      add("peak_dB", "peak", m.peak_db, "dB");
      add("peak_Hz", "at", m.peak_hz, "Hz");
      add("crossover_Hz", "crossover", m.crossover_hz, "Hz");
      add("phase_margin_deg", "phase margin", m.phase_margin_deg, "degree");
      add("reversal_Hz", "reversal", m.reversal_hz, "Hz");
      add("gain_margin_dB", "gain margin", m.gain_margin_db, "dB");
      for (lab::Figure& f : list) {
        if (f.row == row && f.column == "bandwidth") {
          f.tile = fmt::format("{}, bandwidth", row);
          f.tile[0] = static_cast<char>(std::toupper(f.tile[0]));
        }
      }
    }
  }
}

}  // namespace trammel::kung
