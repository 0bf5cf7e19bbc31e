// SPDX-License-Identifier: Apache-2.0
//
// How a session is run: once, or twice where its waves need an event; and what its bus refuses.
#include "lab/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/message.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;
using namespace trammel::cosim;
using Catch::Contains;

namespace {

constexpr std::int64_t kClockPs = 20'000;

constexpr Clk kDrives = 40, kEnd = 400;  // [clk]

// A word of memory that answers at once; its outputs change in one clock, or never, and its
// interrupt comes at some edges and goes by a write to kClear.
constexpr std::uint32_t kClear = 0x40;

struct ToyChip final : MachineChip {
  Clk edge = 0, drives = kNever;
  std::optional<BusOp> op;
  std::uint32_t word = 0, from = 0;  // what it holds, the address of the last transfer
  std::vector<Clk> interrupts;
  bool raised = false;
  std::vector<std::string> events;

  Clk now() const override { return edge; }
  void sense(Lines) override {}
  void request(const BusOp& asked) override { op = asked; }
  Stop run(Clk end, const Plant&) override {
    while (edge < end) {
      const Clk at = edge++;
      unsigned why = at == drives ? unsigned{kDrive} : 0;
      if (std::find(interrupts.begin(), interrupts.end(), at) != interrupts.end()) {
        raised = true;
        why |= kIrq;
      }
      if (op) {
        events.push_back(fmt::format("{}: {} {:#x} {:#x}", at, op->write ? "write" : "read",
                                     op->addr, op->write ? op->data : word));
        if (op->write) word = op->data;
        if (op->write && op->addr == kClear) raised = false;
        from = op->addr;
        op.reset();
        why |= kBusDone;
      }
      if (why != 0) return {at, why};
    }
    return {edge - 1, kLimit};
  }
  Lines drive() const override { return edge > drives; }
  bool irq() const override { return raised; }
  std::uint32_t rdata() const override { return word; }
  Clk evaluated() const override { return edge; }
};

struct NoWords final : SignalReader {
  std::int64_t read(std::size_t, int) const override { return 0; }
};

using Start = std::function<void(sw::Bus&)>;

struct ToyFirmware final : sw::Firmware {
  Start begin, answer;
  sw::Mailbox box{};

  void start(sw::Bus& bus) override {
    if (begin) begin(bus);
  }
  void isr(sw::Bus& bus) override {
    if (answer) answer(bus);
  }
  const sw::Mailbox& mailbox() const override { return box; }
};

struct ToySession final : Session, Observer {
  ToyChip chip;
  test::NoPlant plant;
  ToyFirmware code;
  Waves waves;
  bool interrupted = false;
  Clk last = kEnd;
  ProcessorTiming times;
  Loop wiring{chip, plant, *this};

  void on(const Stop& stop, const Chip&, const Plant&) override {
    if (waves.search != nullptr) waves.search->on(stop, chip, NoWords());
  }
  Loop& loop() override { return wiring; }
  sw::Firmware& firmware() override { return code; }
  ProcessorTiming timing() const override { return times; }
  std::int64_t period_ps() const override { return kClockPs; }
  Clk end() const override { return last; }
  bool finished() const override { return waves.found() || interrupted; }
  bool stopped() const override { return interrupted; }
  std::unique_ptr<RunResult> result() override {
    auto made = std::make_unique<RunResult>();
    made->clocks = chip.edge;
    made->end = interrupted ? EndReason::kStopped : EndReason::kDone;
    return made;
  }
};

RunOptions with_waves(const std::string& trigger) {
  RunOptions run;
  run.platform = Platform::kDirect;
  run.wave = WaveFormat::kFst;
  run.wave_trigger = trigger;
  run.wave_pre_s = 1e-6;  // 50 clocks
  return run;
}

}  // namespace

TEST_CASE("a run with waves is made twice where its event must be found, and once where not") {
  const struct {
    const char* trigger;  // "": the machine's start, which is `drive`
    Clk drives;
    bool interrupted;           // the first run, from outside
    std::size_t runs;
    Clk begin;                  // of the window of the last run; kNever: it has none
    std::optional<Clk> found;
  } cases[] = {{"", kDrives, false, 2, kDrives - 50, kDrives},
               {"drive", kDrives, false, 2, kDrives - 50, kDrives},
               {"drive", kNever, false, 1, kNever, {}},
               {"drive", kNever, true, 1, kNever, {}},
               {"", kNever, false, 2, 0, {}},        // then from the start of the run
               {"", kNever, true, 1, kNever, {}},    // nobody waits for another one
               {"at 2us", kNever, false, 1, 50, 100}};
  for (const auto& one : cases) {
    CAPTURE(one.trigger, one.drives, one.interrupted);
    const std::vector<Signal> none;
    std::vector<Waves> made;
    std::vector<double> progress;
    Hooks hooks;
    hooks.progress = [&](double fraction) { progress.push_back(fraction); };
    const auto result = lab::simulate(
        with_waves(one.trigger), stop_forms(none, ""),
        [&](const Hooks& own, const Waves& waves) {
          auto session = std::make_unique<ToySession>();
          session->chip.drives = one.drives;
          session->interrupted = one.interrupted;
          session->waves = waves;
          made.push_back(waves);
          for (const double fraction : {0.0, 1.0}) own.progress(fraction);
          return session;
        },
        hooks);
    REQUIRE(made.size() == one.runs);
    CHECK((result->end == EndReason::kStopped) == one.interrupted);
    CHECK(result->wave_trigger.value_or(kNever) == one.found.value_or(kNever));
    REQUIRE(made.back().window.has_value() == (one.begin != kNever));
    if (made.back().window) {
      CHECK(made.back().window->begin == one.begin);
      CHECK(made.back().search == nullptr);
    }
    if (one.runs == 2) {  // half of the way each
      CHECK_FALSE(made.front().window.has_value());
      CHECK(progress == std::vector<double>{0, 0.5, 0.5, 1});
    }
  }
}

#ifndef __SANITIZE_ADDRESS__  // it takes the stack of a SystemC thread that throws for a wrong one

TEST_CASE("the bus of SystemC takes words at addresses of words, and names any other") {
  const auto run = [](const Start& start) {
    ToySession session;
    session.code.begin = start;
    lab::run_session(session, RunOptions());
    return std::pair{session.chip.word, session.chip.from};
  };
  for (const std::uint32_t address : {0u, 4u, 0x210u}) {
    CAPTURE(address);
    std::uint32_t seen = 0;
    const auto [word, from] = run([&](sw::Bus& bus) {
      bus.write(address, 0x80000001u + address);
      seen = bus.read(address);
    });
    CHECK(word == 0x80000001u + address);
    CHECK(seen == word);
    CHECK(from == address);
    for (const std::uint32_t beside : {1u, 2u, 3u}) {
      const std::uint32_t at = address + beside;
      CAPTURE(at);
      for (const bool write : {false, true}) {
        const std::string said = test::refusal_of<std::exception>([&] {
          run([&](sw::Bus& bus) { write ? bus.write(at, 7) : static_cast<void>(bus.read(at)); });
        });
        CHECK_THAT(said, Contains(fmt::format("bus: {} at address {:#x} was refused: ",
                                              write ? "write" : "read", at)));
      }
    }
  }
}

#endif

TEST_CASE("a processor takes the same clocks in SystemC as without, whatever fault it has") {
  const bool fast = GENERATE(false, true);  // it comes back in the next clock
  constexpr double kClock_s = 20e-9;
  const std::vector<std::pair<FaultKind, int>> faults{
      {FaultKind::kNone, 0},           {FaultKind::kProcessorSlow, 3},
      {FaultKind::kProcessorGarbage, 0}, {FaultKind::kBusStall, 37},
      {FaultKind::kProcessorStopped, 0}};
  for (const auto& [kind, value] : faults) {
    for (const Clk begin : {60, 61, 300, 313}) {
      CAPTURE(static_cast<int>(kind), begin);
      const auto ran = [&, kind = kind, value = value](Platform platform) {
        ToySession session;
        session.last = 3000;
        session.chip.interrupts = {250, 700, 1300};
        session.times.compute = fast ? 0 : 23;
        if (fast) session.times.latency = session.times.access = 1;
        session.times.computed = 0x10;
        Fault fault;
        fault.kind = kind;
        fault.value = value;
        fault.begin_s = static_cast<double>(begin) * kClock_s;
        fault.for_s = 500 * kClock_s;
        session.times.fault = ProcessorFault(fault, kClockPs);
        session.code.begin = [](sw::Bus& bus) {
          for (const std::uint32_t address : {0x0u, 0x10u, 0x14u}) {
            bus.write(address, address + 1);
            bus.write(address, bus.read(address) + 1);
          }
        };
        session.code.answer = [](sw::Bus& bus) {
          bus.write(kClear, bus.read(0x44));
          bus.write(0x10, 7);
        };
        RunOptions run;
        run.platform = platform;
        lab::run_session(session, run);
        session.chip.events.push_back(fmt::format("end {}", session.chip.now()));
        return session.chip.events;
      };
      const auto with = ran(Platform::kSystemC);
      CHECK(with == ran(Platform::kDirect));
      CHECK(with.size() > 10);
    }
  }
}
