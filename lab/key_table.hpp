// SPDX-License-Identifier: Apache-2.0
//
// How a machine's table of keys is written: a lens names the member of its Options, and the type of
// the member says what kind of key it is. Included only where a table is made.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "lab/machine.hpp"
#include "lab/settings.hpp"

#define TRAMMEL_LENS(member) [](auto& o) -> auto& { return o.member; }

namespace trammel::lab {

// Words of an enumeration, in its order.
template <class Enum>
std::vector<std::string> enum_names();
template <>
inline std::vector<std::string> enum_names<cosim::Platform>() {
  return {"systemc", "direct"};
}
template <>
inline std::vector<std::string> enum_names<cosim::Engine>() {
  return {"rtl", "twin"};
}
template <>
inline std::vector<std::string> enum_names<cosim::WaveFormat>() {
  return {"none", "vcd", "fst"};
}

template <>
inline std::vector<std::string> enum_names<cosim::FaultKind>() {
  return cosim::fault_words();
}

// Reads and writes the member that `lens` selects, whatever its type is.
template <class Options, class Lens>
Key make_key(std::string name, double min, double max, std::string help, Lens lens) {
  using T = std::decay_t<decltype(lens(std::declval<Options&>()))>;
  const auto in = [lens](const Settings& s) -> const T& {
    return lens(static_cast<const Options&>(s));
  };
  const auto of = [lens](Settings& s) -> T& { return lens(static_cast<Options&>(s)); };
  Key key;
  key.name = std::move(name);
  key.min = min;
  key.max = max;
  key.help = std::move(help);
  if constexpr (std::is_enum_v<T>) {
    key.kind = Kind::kChoice;
    key.choices = enum_names<T>();
    key.get = [in](const Settings& s) -> Value {
      return enum_names<T>()[static_cast<std::size_t>(in(s))];
    };
    key.set = [of](Settings& s, const Value& v) {
      const auto all = enum_names<T>();
      of(s) = static_cast<T>(std::find(all.begin(), all.end(), std::get<std::string>(v)) -
                             all.begin());
    };
  } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
    key.kind = std::is_same_v<T, bool> ? Kind::kFlag : Kind::kText;
    key.get = [in](const Settings& s) -> Value { return in(s); };
    key.set = [of](Settings& s, const Value& v) { of(s) = std::get<T>(v); };
  } else if constexpr (std::is_integral_v<T>) {
    key.kind = Kind::kInteger;
    key.get = [in](const Settings& s) -> Value { return static_cast<std::int64_t>(in(s)); };
    key.set = [of](Settings& s, const Value& v) {
      of(s) = static_cast<T>(std::get<std::int64_t>(v));
    };
  } else {
    key.get = [in](const Settings& s) -> Value { return in(s); };
    key.set = [of](Settings& s, const Value& v) { of(s) = std::get<double>(v); };
  }
  return key;
}

// Says which machine a file is of; no other can be set.
inline Key machine_key(const std::string& name) {
  Key key;
  key.name = "machine";
  key.kind = Kind::kChoice;
  key.choices = {name};
  key.help = "machine of the scenario";
  key.get = [name](const Settings&) -> Value { return name; };
  key.set = [](Settings&, const Value&) {};
  return key;
}

template <class Options>
struct KeyTable {
  std::vector<Key> keys;

  explicit KeyTable(const std::string& machine) : keys{machine_key(machine)} {}

  template <class Lens>
  void one(std::string name, double min, double max, std::string help, Lens lens) {
    keys.push_back(make_key<Options>(std::move(name), min, max, std::move(help), lens));
  }
  template <class Lens>
  void text(std::string name, std::string help, Lens lens) {
    one(std::move(name), 0, 0, std::move(help), lens);
  }

  template <class Lens>
  void file(std::string name, std::string help, Lens lens) {
    text(std::move(name), std::move(help), lens);
    keys.back().kind = Kind::kFile;
  }

  // Keys that runs of all machines have; each table says where among its own they stand.
  void names() {
    text("name", "name of the run and of its output folder", TRAMMEL_LENS(scenario));
    text("description", "one line, shown by `trammel list`", TRAMMEL_LENS(description));
  }
  void platform_and_clocks() {
    text("run.engine", "the verilated RTL, or its bit-exact twins without SystemC: same results",
         TRAMMEL_LENS(run.engine));
    text("run.platform",
         "SystemC platform or direct wiring; a twin and a processor's RTL are always wired "
         "directly",
         TRAMMEL_LENS(run.platform));
    text("run.leap", "skip clocks in which nothing happens; false: evaluate every clock",
         TRAMMEL_LENS(run.leap));
    text("run.domains", "evaluate the clock domains that are awake; false: all of them",
         TRAMMEL_LENS(run.domains));
    one("run.audit", 0, 0, "run a leaping and a plain chip in lock step, compare every register",
        TRAMMEL_LENS(run.audit));
    one("run.assertions", 0, 0, "check the assertions of the RTL in every clock",
        TRAMMEL_LENS(run.assertions));
  }
  void waves(const std::string& begins, const std::string& events) {
    text("run.wave", "format of signal traces", TRAMMEL_LENS(run.wave));
    one("run.wave_begin_s", -3600, 3600,
        "begin of the traced window, from the start of the run or the trigger; begin and end "
        "0: 2 ms around the trigger, or from " +
            begins,
        TRAMMEL_LENS(run.wave_begin_s));
    one("run.wave_end_s", -3600, 3600, "end of the traced window", TRAMMEL_LENS(run.wave_end_s));
    text("run.wave_trigger", "event that the window is anchored to, " + events,
         TRAMMEL_LENS(run.wave_trigger));
    one("run.wave_pre_s", 0, 10, "part of the default window before the trigger",
        TRAMMEL_LENS(run.wave_pre_s));
    one("run.wave_every_s", 0, 3600, "period with which the window is repeated; 0 = once",
        TRAMMEL_LENS(run.wave_every_s));
  }

  // One fault, of the kinds and at the places that the machine has.
  void faults(const cosim::FaultPins& pins) {
    int lines = 1;
    std::vector<std::string> names;
    for (const cosim::FaultPlace& one : pins.places) {
      lines = std::max(lines, one.lines);
      if (one.lines > 1) names.push_back(one.names);
    }
    text("inject.fault", "what fails, see docs/faults.md", TRAMMEL_LENS(fault.kind));
    keys.back().choices = pins.words();
    one("inject.begin_s", 0, 3600, "from when", TRAMMEL_LENS(fault.begin_s));
    one("inject.for_s", 0, 3600, "for how long; 0 = it stays", TRAMMEL_LENS(fault.for_s));
    one("inject.axis", 0, pins.last_axis(),
        pins.axes.empty() ? "this machine has one axis"
                          : fmt::format("on {}", fmt::join(pins.axes, " or ")),
        TRAMMEL_LENS(fault.axis));
    one("inject.line", 0, lines - 1,
        names.empty() ? "no fault of this machine has a choice of lines"
                      : fmt::format("{}", fmt::join(names, "; ")),
        TRAMMEL_LENS(fault.line));
    one("inject.value", -65535, 65535, "how much or at which level, by the fault",
        TRAMMEL_LENS(fault.value));
    text("inject.bit", "of register_flip: register of the chip and bit, as u_supervisor.trip_q[0]",
         TRAMMEL_LENS(fault.bit));
  }

  void window() {
    one("run.window_clk", 0, 1e9, "longest look-ahead; 0 = unbounded, 1 = lock step",
        TRAMMEL_LENS(run.window_clk));
  }
  void longest_run() {
    one("run.max_s", 1e-3, 3600, "longest simulated time of a run", TRAMMEL_LENS(run.max_s));
  }
  void processor() {
    one("processor.access_clk", 1, 10000, "clocks per bus access",
        TRAMMEL_LENS(processor.access_clk));
    one("processor.interrupt_latency_clk", 0, 90000, "clocks from an interrupt to the first access",
        TRAMMEL_LENS(processor.interrupt_latency_clk));
  }
};

}  // namespace trammel::lab
