// SPDX-License-Identifier: Apache-2.0
//
// Triggers of waves: relations at their value, words at the ends of their range, times, and events
// at the clocks from which they count.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "cosim/wave_plan.hpp"
#include "tests/cosim/still_chip.hpp"
#include "tests/support/message.hpp"

using namespace trammel::cosim;

namespace {

const std::vector<Signal>& words() {
  static const std::vector<Signal> all{{{"e", "count", "error", 12, true}, true},
                                       {{"yaw", "", "word of no axis", 8, false}, false}};
  return all;
}

constexpr char kHelp[] = "what may be asked";

Trigger parsed(const std::string& text) {
  return parse_trigger(text, stop_forms(words(), kHelp), 20'000);
}

// What is said of a text, "" where nothing is refused.
std::string refusal(const std::string& text) {
  return trammel::test::refusal_of<std::invalid_argument>([&] { parsed(text); });
}

struct Reader final : SignalReader {
  std::int64_t read(std::size_t signal, int axis) const override { return value[signal][axis]; }
  std::int64_t value[2][2] = {};
};

struct RisingChip final : trammel::test::StillChip {
  Clk host_rise() const override { return rise; }

  Clk rise = kNever;
};

constexpr Clk kAfter = 50;  // clocks of "1us"

// Where a search is that stops at an edge for a reason, -1 = nothing found.
Clk found_at(const std::string& text, Clk edge, unsigned why, Clk rise = kNever) {
  TriggerSearch search(parsed(text));
  RisingChip chip;
  chip.rise = rise;
  search.on({edge, why}, chip, Reader());
  return search.found().value_or(-1);
}

}  // namespace

TEST_CASE("a relation holds below, at and above its value as it is written") {
  const struct {
    const char* op;
    bool holds[3];  // of 4, 5 and 6 against 5
  } cases[] = {{"==", {false, true, false}}, {"!=", {true, false, true}},
               {"<", {true, false, false}},  {"<=", {true, true, false}},
               {">", {false, false, true}},  {">=", {false, true, true}}};
  for (const auto& one : cases) {
    const Trigger trigger = parsed(fmt::format("yaw {} 5", one.op));
    for (int before = 0; before < 3; ++before) {
      for (int now = 0; now < 3; ++now) {
        const bool expected = one.holds[now] && !one.holds[before];
        INFO(fmt::format("yaw {} 5 from {} to {}", one.op, before + 4, now + 4));
        CHECK(trigger.fires(before + 4, now + 4) == expected);
      }
    }
  }
}

TEST_CASE("an edge fires in its sense alone") {
  const struct {
    const char* text;
    bool up, down, same;
  } cases[] = {{"rise yaw", true, false, false},
               {"fall yaw", false, true, false},
               {"change yaw", true, true, false},
               {"at 1us", false, false, false}};
  for (const auto& one : cases) {
    CAPTURE(one.text);
    CHECK(parsed(one.text).fires(0, 1) == one.up);
    CHECK(parsed(one.text).fires(1, 0) == one.down);
    CHECK(parsed(one.text).fires(1, 1) == one.same);
  }
}

TEST_CASE("a value is taken up to both ends of its word, and refused one beyond") {
  const struct {
    const char *name, *low, *high, *below, *above, *range;
  } cases[] = {{"x.e", "-2048", "2047", "-2049", "2048", "-2048..2047"},
               {"yaw", "0", "0xff", "-1", "0x100", "0..255"}};
  for (const auto& one : cases) {
    CAPTURE(one.name);
    for (const char* value : {one.low, one.high}) {
      CHECK(refusal(fmt::format("{} == {}", one.name, value)) == "");
    }
    for (const char* value : {one.below, one.above}) {
      CHECK(refusal(fmt::format("{} == {}", one.name, value)) ==
            fmt::format("{}: value {} is out of range {}", one.name, value, one.range));
    }
  }
  CHECK(parsed("yaw == 0x10").value == 16);
  CHECK(parsed("yaw == 10").value == 10);
}

TEST_CASE("a word is of its axis, of either where none is named, or of none") {
  const struct {
    const char* text;
    bool fires[2];  // where that of X, of Y becomes 1
  } cases[] = {{"x.e == 1", {true, false}}, {"y.e == 1", {false, true}}, {"e == 1", {true, true}},
               {"yaw == 1", {true, false}}};  // whatever its name begins with
  for (const auto& one : cases) {
    const Trigger trigger = parsed(one.text);
    for (const int axis : {0, 1}) {
      Reader reader;
      SignalSearch search(trigger);
      search.after(0, reader);
      reader.value[trigger.signal][axis] = 1;
      search.after(1, reader);
      CAPTURE(one.text, axis);
      CHECK(search.found().has_value() == one.fires[axis]);
    }
  }
  CHECK(refusal("x.yaw == 1") == "x.yaw: unknown signal");
}

TEST_CASE("a search compares with edge 0, with nothing in reset, and fires from its time on") {
  const struct {
    const char* text;
    Clk first, second;  // edges at which yaw is 0, then 1
    bool found;
  } cases[] = {{"rise yaw", 0, 1, true},         {"rise yaw", -1, 0, false},
               {"rise yaw after 1us", 0, kAfter, true},
               {"rise yaw after 1us", 0, kAfter - 1, false}};
  Reader held;
  SignalSearch late(parsed("yaw > 0 after 1us"));
  for (const Clk edge : {Clk{0}, Clk{1}, kAfter}) {  // it is true before its time, and stays so
    late.after(edge, held);
    held.value[1][0] = 1;
  }
  CHECK_FALSE(late.found());
  for (const auto& one : cases) {
    Reader reader;
    SignalSearch search(parsed(one.text));
    search.after(one.first, reader);
    reader.value[1][0] = 1;
    search.after(one.second, reader);
    CAPTURE(one.text, one.first, one.second);
    CHECK(search.found().value_or(-1) == (one.found ? one.second : -1));
  }
}

TEST_CASE("a change is one from the edge before, whatever was at the first") {
  Reader reader;
  SignalSearch search(parsed("rise yaw"));
  Clk edge = 0;
  for (const int value : {5, 3, 3, 2, 4}) {
    reader.value[1][0] = value;
    search.after(edge++, reader);
  }
  CHECK(search.found().value_or(-1) == 4);
}

TEST_CASE("a text is a time, or an event or a word that is known, and not both times") {
  CHECK(parsed("at 1us").known());
  CHECK(parsed("at 1us").edge == kAfter);
  CHECK_FALSE(parsed("rise yaw after 1us").known());
  CHECK(parsed("rise yaw after 1us").edge == kAfter);
  CHECK(refusal("at 1us after 2us") == "`at` and `after` exclude each other");
  for (const char* name : {"none", "x.none", "x.yaw"}) {
    for (const char* form : {"rise {}", "{} > 1", "{}"}) {
      const std::string text = fmt::format(fmt::runtime(form), name);
      CAPTURE(text);
      CHECK(refusal(text) == name + std::string(": unknown signal"));
    }
  }
  for (const char* text : {"yaw", "at", "after 1us", "rise", "yaw = 1", "yaw > one", "yaw >"}) {
    CHECK(refusal(text) == fmt::format("\"{}\" is none of: {}", text, kHelp));
  }
}

TEST_CASE("an event that is seen from outside is found at its own stops, from its time on") {
  const struct {
    const char* text;
    Clk edge;
    unsigned why;
    Clk rise, found;
  } cases[] = {{"drive", 7, kDrive, kNever, 7},
               {"drive", 7, kIrq | kTick | kSample, kNever, -1},
               {"drive after 1us", kAfter, kDrive, kNever, kAfter},
               {"drive after 1us", kAfter - 1, kDrive, kNever, -1},
               {"irq", 7, kIrq, kNever, 7},
               {"irq", 7, kDrive | kTick | kSample, kNever, -1},
               {"irq after 1us", kAfter, kIrq, kNever, kAfter},
               {"irq after 1us", kAfter - 1, kIrq, kNever, -1},
               {"irq after 1us", kAfter, kDrive, kNever, -1},
               {"hi", 70, kTick, 60, 60},  // where the pin rose, not where the loop stopped
               {"hi", 70, kDrive | kIrq, kNever, -1},
               {"hi after 1us", 70, kTick, kAfter, kAfter},
               {"hi after 1us", 70, kTick, kAfter - 1, -1}};
  for (const auto& one : cases) {
    CAPTURE(one.text, one.edge, one.why, one.rise);
    CHECK(found_at(one.text, one.edge, one.why, one.rise) == one.found);
  }
}

TEST_CASE("words of a chip that is not watched are read where a sample is published") {
  for (const bool sample : {false, true}) {
    TriggerSearch search(parsed("rise yaw"));
    const trammel::test::StillChip chip;
    Reader reader;
    search.on({10, kSample}, chip, reader);
    reader.value[1][0] = 1;
    search.on({20, sample ? kSample : kTick | kDrive}, chip, reader);
    CAPTURE(sample);
    CHECK(search.found().value_or(-1) == (sample ? 20 : -1));
  }
}

TEST_CASE("a time has a unit or none, and lies within an hour") {
  const struct {
    const char* text;
    Clk edge;  // -1 = refused
  } cases[] = {{"0", 0},          {"2", 100'000'000},  {"2s", 100'000'000}, {"2ms", 100'000},
               {"2us", 100},      {"2000ns", 100},     {"3600s", 180'000'000'000},
               {"3600.001s", -1}, {"-1ns", -1},        {"1e999s", -1},      {"nan", -1},
               {"ms", -1},        {"2 ms", -1},        {"2min", -1}};
  for (const auto& one : cases) {
    CAPTURE(one.text);
    const std::string said = fmt::format(
        "value {} is not a time 0..3600 s with s, ms, us or ns behind it", one.text);
    if (one.edge < 0) {
      CHECK_THROWS_WITH(parse_edge(one.text, 20'000), said);
    } else {
      CHECK(parse_edge(one.text, 20'000) == one.edge);
      CHECK(parse_edge(one.text, 40'000) == one.edge / 2);
    }
  }
}

TEST_CASE("a wave file has the chip's clock, and whole numbers at its falling edges") {
  for (const std::int64_t clock_ps : {20'000, 25'000, 20'834, 10'002}) {
    const WaveScale scale = wave_scale(clock_ps);
    const bool ns = scale.unit == std::string("ns");
    CHECK(scale.period * (ns ? 1000 : 1) == clock_ps);
    CHECK(scale.period % 2 == 0);
  }
}

TEST_CASE("a window counts from the start event, from the run's begin, or repeats") {
  const struct {
    double begin_s, end_s, every_s;
    bool start;                  // anchored to the start event
    Clk origin, begin, end, period;  // where that is not found
  } cases[] = {{0, 0, 0, true, 10'000, 0, 100'000, kNever},
               {0, 2e-3, 0, false, 0, 0, 100'000, kNever},
               {1e-3, 2e-3, 0, false, 0, 50'000, 100'000, kNever},
               {-1e-3, 0, 0, false, 0, -50'000, 0, kNever},
               {0, 0, 0.1, false, 0, 0, 10'000, 5'000'000},
               {0, 2e-3, 0.1, false, 0, 0, 100'000, 5'000'000},
               // One that has ended before edge 1 is not the first.
               {-2e-3, 0, 0.1, false, 0, 4'900'000, 5'000'000, 5'000'000},
               {-2e-3, 2e-8, 0.1, false, 0, -100'000, 1, 5'000'000}};
  for (const auto& one : cases) {
    RunOptions run;
    run.wave = WaveFormat::kFst;
    run.wave_pre_s = 2e-4;
    run.wave_begin_s = one.begin_s;
    run.wave_end_s = one.end_s;
    run.wave_every_s = one.every_s;
    CAPTURE(one.begin_s, one.end_s, one.every_s);
    CHECK(wave_trigger_text(run, "drive").value_or("none") == (one.start ? "drive" : "none"));
    CHECK(wave_origin(run) == one.origin);
    const WaveWindow window = wave_window(run, wave_origin(run));
    CHECK(window.begin == one.begin);
    CHECK(window.end == one.end);
    CHECK(window.period == one.period);
  }
}

TEST_CASE("only what the run reached counts as dumped") {
  const auto spans = [](const WaveWindow& window, Clk clocks) {
    std::vector<std::pair<Clk, Clk>> list;
    for (const WaveSpan& span : wave_spans(window, clocks)) list.emplace_back(span.begin, span.end);
    return list;
  };
  using List = std::vector<std::pair<Clk, Clk>>;
  CHECK(spans({10, 20, kNever}, 100) == List{{10, 20}});
  CHECK(spans({-10, 20, kNever}, 100) == List{{0, 20}});
  CHECK(spans({90, 120, kNever}, 100) == List{{90, 100}});
  CHECK(spans({100, 120, kNever}, 100).empty());
  CHECK(spans({-20, -10, kNever}, 100).empty());
  CHECK(spans({10, 20, 40}, 100) == List{{10, 20}, {50, 60}, {90, 100}});
  CHECK(spans({95, 110, 40}, 100) == List{{95, 100}});
}
