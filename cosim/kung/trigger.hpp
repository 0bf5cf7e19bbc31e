// SPDX-License-Identifier: Apache-2.0
//
// What begins a window of waves: one event of the chip, found in a run of its own before the one
// that is dumped. Runs are deterministic, so that it stands at the same clock in both.
//
//   EXPR  := EVENT [after TIME]
//   EVENT := drives[.AXIS] | afc[.AXIS] | fault[.CAUSE] | at TIME
//          | rise NAME | fall NAME | change NAME | NAME OP NUMBER
//   NAME  := [AXIS.]signal; without axis either of the two      AXIS := x | y
//   CAUSE := trip | over_current | watchdog | encoder | stroke  OP   := == != < <= > >=
//   TIME  := number with s, ms, us or ns behind it
//
// A comparison fires when it becomes true: what holds from reset on must first cease to.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosim/kung/chip.hpp"

namespace trammel::kung {

// One line of it, for help texts.
inline constexpr char kTriggerForms[] =
    "drives, afc, fault, fault.encoder, at 10ms, rise|fall|change x.CTRL.enable, x.e > 100, each "
    "with `after TIME` behind it if wanted";

struct Trigger {
  enum class When { kAt, kHolds, kRises, kFalls, kChanges };
  enum class Relation { kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual };

  When when = When::kAt;
  cosim::Clk edge = 0;  // kAt: there; else not before it
  std::size_t signal = 0;
  int axis = 0;
  bool either = false;  // axis 0 or 1
  Relation relation = Relation::kEqual;
  std::int64_t value = 0;

  bool known() const { return when == When::kAt; }  // without a search
};

// A name that is no signal, to be met with a suggestion.
struct UnknownName : std::invalid_argument {
  explicit UnknownName(const std::string& given)
      : std::invalid_argument(given + ": unknown signal"), name(given) {}
  std::string name;
};

// Throws UnknownName, or std::invalid_argument that says what is wrong and what is allowed.
Trigger parse_trigger(const std::string& text);

// All that may stand for a NAME or EVENT, for suggestions.
std::vector<std::string> trigger_names();

// Looks for every event but kAt, whose edge is known.
class TriggerSearch final : public Watcher {
 public:
  // What these options look for; throws as parse_trigger() does.
  static std::optional<Trigger> event(const cosim::RunBasics& run);

  explicit TriggerSearch(const Trigger& trigger) : trigger_(trigger) {}

  void after(cosim::Clk edge, const SignalReader& chip) override;

  // The first clock edge after which the event is there.
  std::optional<cosim::Clk> found() const { return found_; }

 private:
  bool fires(std::int64_t before, std::int64_t now) const;
  bool holds(std::int64_t value) const;

  Trigger trigger_;
  std::optional<cosim::Clk> found_;
  std::int64_t before_[2] = {};
  bool known_ = false;  // there is a value before this one
};

}  // namespace trammel::kung
