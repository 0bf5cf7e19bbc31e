// SPDX-License-Identifier: Apache-2.0
//
// The plan of a sweep, which measures responses.
#include <algorithm>
#include <cmath>

#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"

namespace trammel::kung {
namespace {

constexpr double kLargestCurrentWord = 2047;

}  // namespace

sw::SteppedSine::Setup plan_stepped_sine(const Options& options, const Encoder& encoder) {
  const PathOptions& p = options.path;
  in_range("path.sweep_last_ticks", p.sweep_last_ticks, 4, p.sweep_first_ticks,
           "path.sweep_first_ticks");
  sw::SteppedSine::Setup s;
  const std::int32_t center = encoder.counts(p.sweep_center_m);
  s.center = {center, center};
  sw::Q32 amplitude = encoder.q32(p.sweep_amplitude_m);
  if (p.open_position()) {
    const double full_scale_A = options.plant.axis[0].current_full_scale_a;
    const double lsb_A = current_ref_lsb_A(full_scale_A);
    in_range("path.sweep_amplitude_A", p.sweep_amplitude_A, lsb_A, kLargestCurrentWord * lsb_A,
             fmt::format("at plant.x.current_full_scale_A = {:g}", full_scale_A));
    amplitude = std::llround(std::ldexp(p.sweep_amplitude_A / lsb_A, 32));
  }
  if (!p.open_position()) {
    // Behind the reference model a sine is at most omega_n / (2 zeta) times its amplitude fast.
    const double model = std::max(1 / options.gains[0].lag_s(), 1 / options.gains[1].lag_s());
    const double rate = std::min(model, 2 * kPi / (p.sweep_last_ticks * encoder.sample_s));
    in_range("path.sweep_amplitude_m", p.sweep_amplitude_m, 0, encoder.max_feed_m_s() / rate,
             feed_text(encoder));
  }
  s.amplitude = {amplitude, amplitude};
  s.first_ticks = word(p.sweep_first_ticks);
  s.tones = word(p.sweep_tones);
  s.dwell_ticks = word(p.sweep_dwell_ticks);
  const double tones = std::max(1, p.sweep_tones - 1);
  const double ratio = std::pow(1.0 * p.sweep_last_ticks / p.sweep_first_ticks, 1 / tones);
  s.ratio = static_cast<std::uint32_t>(std::min(std::ldexp(ratio, 32), std::ldexp(1, 32) - 1));
  return s;
}

void check_sweep(const Options& options) {
  const PathOptions& path = options.path;
  if (!path.is_sweep()) return;
  for (std::size_t a = 0; a < 2 && !path.open_position(); ++a) {
    require(!options.gains[a].feedforward,
            fmt::format("gains.{}.feedforward: must be off in a sweep of position, which measures "
                        "what the feedback does", a == 0 ? 'x' : 'y'));
  }
  // The second command of a service must be there before the next current period.
  constexpr int kAccesses = 15, kHandshake_clk = 4;
  const ProcessorOptions& processor = options.processor;
  const double write_s = 1e-12 * static_cast<double>(options.run.clock_ps) *
                         (processor.interrupt_latency_clk + options.point_clk +
                          kAccesses * (processor.access_clk + kHandshake_clk));
  require(!path.open_position() || write_s * options.chip.carrier_Hz < 1,
          fmt::format("path.sweep_of: \"current\" needs a processor that writes within a period of "
                      "chip.carrier_Hz = {}; processor.access_clk, interrupt_latency_clk and "
                      "point_clk make it {:.1f} us (scenario response-current has a fast one)",
                      options.chip.carrier_Hz, 1e6 * write_s));
}

}  // namespace trammel::kung
