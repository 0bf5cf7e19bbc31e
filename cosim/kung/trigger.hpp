// SPDX-License-Identifier: Apache-2.0
//
// Triggers of the X-Y table: cosim/trigger.hpp with its signals, and these words.
//
//   EVENT := drives[.AXIS] | afc[.AXIS] | fault[.CAUSE]
//   CAUSE := trip | over_current | watchdog | encoder | stroke
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cosim/kung/chip.hpp"
#include "cosim/trigger.hpp"

namespace trammel::kung {

using cosim::Trigger;
using cosim::UnknownName;

// One line of it, for help texts.
inline constexpr char kTriggerForms[] =
    "drives, afc, fault, fault.encoder, at 10ms, rise|fall|change x.CTRL.enable, x.e > 100, each "
    "with `after TIME` behind it if wanted";

// Throws UnknownName, or std::invalid_argument that says what is wrong and what is allowed.
Trigger parse_trigger(const std::string& text);

// All that may stand for a NAME or EVENT, for suggestions.
std::vector<std::string> trigger_names();

// Looks for every event but kAt, whose edge is known.
class TriggerSearch final : public Watcher {
 public:
  // What these options look for; throws as parse_trigger() does.
  static std::optional<Trigger> event(const cosim::RunBasics& run);

  explicit TriggerSearch(const Trigger& trigger) : search_(trigger) {}

  void after(cosim::Clk edge, const SignalReader& chip) override { search_.after(edge, chip); }

  // The first clock edge after which the event is there.
  std::optional<cosim::Clk> found() const { return search_.found(); }

 private:
  cosim::SignalSearch search_;
};

}  // namespace trammel::kung
