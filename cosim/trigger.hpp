// SPDX-License-Identifier: Apache-2.0
//
// What begins a window of waves: one event of a chip, found in a separate run before the one that
// is dumped. Runs are deterministic, so that it stands at the same clock in both.
//
//   EXPR  := EVENT [after TIME]
//   EVENT := an event of the machine | at TIME
//          | rise NAME | fall NAME | change NAME | NAME OP NUMBER
//   NAME  := [AXIS.]signal; without axis either of the two      AXIS := x | y
//   OP    := == != < <= > >=      TIME := number with s, ms, us or ns behind it
//
// A comparison fires when it becomes true; one that holds from reset on must first become false.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

// A value inside a chip, described once for the columns of trace.csv and the names of triggers.
struct Word {
  const char* name;  // without axis: "e", "STATUS.step", "TICK"
  const char* unit;  // "" where it has none or `help` tells it
  const char* help;
  int bits;
  bool is_signed;
};

// One that a trigger may name.
struct Signal : Word {
  bool of_axis;  // there are two, x.<name> and y.<name>
};

struct SignalReader {
  virtual ~SignalReader() = default;
  virtual std::int64_t read(std::size_t signal, int axis) const = 0;  // its place in the list
};

// Sees a chip after each edge that is evaluated; at the others no signal changes.
struct Watcher {
  virtual ~Watcher() = default;
  virtual void after(Clk edge, const SignalReader& chip) = 0;
};

struct Trigger {
  enum class When { kAt, kEvent, kHolds, kRises, kFalls, kChanges };
  enum class Relation { kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual };

  When when = When::kAt;
  Clk edge = 0;            // kAt: there; else not before it
  std::size_t signal = 0;  // kEvent: which, by the machine's own count
  int axis = 0;
  bool either = false;     // axis 0 or 1
  Relation relation = Relation::kEqual;
  std::int64_t value = 0;

  bool known() const { return when == When::kAt; }  // without a search
  bool fires(std::int64_t before, std::int64_t now) const;

 private:
  bool holds(std::int64_t value) const;
};

std::string described(const Word& word);  // "encoder counter [count]"

// A name that is no signal, to be met with a suggestion.
struct UnknownName : std::invalid_argument {
  explicit UnknownName(const std::string& given)
      : std::invalid_argument(given + ": unknown signal"), name(given) {}
  std::string name;
};

// The triggers that a machine offers.
struct TriggerForms {
  const std::vector<Signal>& signals;
  std::vector<std::string> events;  // the machine's words, for suggestions
  const char* help;                 // one line of all forms
  const char* start;                // the event to which the default window is anchored
  // Puts an event of the machine into the trigger; false: the word is none. May throw
  // UnknownName.
  bool (*event)(Trigger& trigger, const std::string& word);
};

// Throws UnknownName, or std::invalid_argument that says what is wrong and what is allowed.
Trigger parse_trigger(const std::string& text, const TriggerForms& forms, std::int64_t clock_ps);

// "x.e" is signal e of axis 0. Throws UnknownName.
void name_signal(Trigger& trigger, const std::string& name, const std::vector<Signal>& signals);

// All that may stand for a NAME or EVENT, for suggestions.
std::vector<std::string> trigger_names(const TriggerForms& forms);

// Looks for a comparison or a change of a signal, edge by edge.
class SignalSearch {
 public:
  explicit SignalSearch(const Trigger& trigger) : trigger_(trigger) {}

  void after(Clk edge, const SignalReader& chip);

  // The first clock edge after which it is there.
  std::optional<Clk> found() const { return found_; }

 private:
  Trigger trigger_;
  std::optional<Clk> found_;
  std::int64_t before_[2] = {};
  bool known_ = false;  // a value was read before
};

}  // namespace trammel::cosim
