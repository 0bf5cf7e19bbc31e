// SPDX-License-Identifier: Apache-2.0
#include "cosim/wave_event.hpp"

#include <fmt/format.h>

#include <regex>

namespace trammel::cosim {

WaveEvent parse_wave_event(const std::string& text) {
  using What = WaveEvent::What;
  static const std::regex form(R"(\s*(?:at\s+(\S+)|(drive|hi|irq)(?:\s+after\s+(\S+))?)\s*)");
  std::smatch part;
  if (!std::regex_match(text, part, form)) {
    throw std::invalid_argument(fmt::format("\"{}\" is none of: {}", text, kWaveEvents));
  }
  if (part[1].matched) return {What::kAt, parse_edge(part[1])};
  const What what = part[2] == "drive" ? What::kDrive : part[2] == "hi" ? What::kHost : What::kIrq;
  return {what, part[3].matched ? parse_edge(part[3]) : 0};
}

std::optional<WaveEvent> EventSearch::event(const RunBasics& run) {
  const auto text = wave_trigger_text(run, kStart);
  if (!text) return {};
  return parse_wave_event(*text);
}

void EventSearch::on(const Stop& stop, const MachineChip& chip) {
  if (found_) return;
  if (event_.what == WaveEvent::What::kHost) {
    const Clk rise = chip.host_rise();
    if (rise != kNever && rise >= event_.edge) found_ = rise;
    return;
  }
  const unsigned why = event_.what == WaveEvent::What::kDrive ? kDrive : kIrq;
  if ((stop.why & why) != 0 && stop.edge >= event_.edge) found_ = stop.edge;
}

}  // namespace trammel::cosim
