// SPDX-License-Identifier: Apache-2.0
//
// A session of a machine that has a program and nothing more to say: when it ends, and that a fault
// is injected but not noticed.
#include <atomic>
#include <catch2/catch.hpp>
#include <memory>

#include "cosim/sampled_session.hpp"
#include "tests/cosim/still_chip.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;
using namespace trammel::cosim;

namespace {

struct Program final : sw::Firmware {
  sw::Mailbox mail;
  void start(sw::Bus&) override {}
  void isr(sw::Bus&) override {}
  const sw::Mailbox& mailbox() const override { return mail; }
};

class Plain final : public SampledSession {
 public:
  Program program;
  int recorded = 0;

  explicit Plain(const Hooks& hooks = {}, const Fault& fault = {})
      : SampledSession(hooks, RunOptions(), fault, ProcessorOptions(), Waves()) {
    wire(chip_, plant_);
    watch_trips();
  }
  explicit Plain(double record_s)
      : SampledSession(record_s, {}, RunOptions(), {}, ProcessorOptions(), Waves()) {
    wire(chip_, plant_);
  }

  sw::Firmware& firmware() override { return program; }
  std::unique_ptr<RunResult> result() override {
    auto result = std::make_unique<RunResult>();
    result->end = end_;
    complete(*result);
    return result;
  }
  void stop_at(Clk edge, unsigned why) { on({edge, why}, chip_, plant_); }

 private:
  std::int64_t read(std::size_t, int) const override { return 0; }
  void sampled(Clk, bool in_record) override { recorded += in_record; }
  double progress() const override { return 0; }

  test::StillChip chip_;
  test::NoPlant plant_;
};

}  // namespace

TEST_CASE("a session ends at the sample after its program has, by its failure or done") {
  for (const std::uint32_t failure : {0u, 3u}) {
    Plain session;
    session.stop_at(100, kSample);
    CHECK_FALSE(session.finished());
    session.program.mail.done = 1;
    session.program.mail.failure = failure;
    session.stop_at(150, kDrive);
    CHECK_FALSE(session.finished());
    session.stop_at(200, kSample);
    CHECK(session.finished());
    session.stop_at(300, kSample);
    CHECK(session.recorded == 2);
    CHECK(session.result()->end == (failure == 0 ? EndReason::kDone : EndReason::kFault));
  }
}

TEST_CASE("a session records the samples at multiples of a time, and counts its events") {
  for (const double record_s : {0.0, 1e-6}) {  // 50 clocks; less than one is one
    Plain session(record_s);
    for (const Clk edge : {48, 49, 98, 99}) session.stop_at(edge, kSample);
    session.stop_at(120, kDrive);
    const int samples = record_s == 0 ? 4 : 2;
    CHECK(session.recorded == samples);
    CHECK(session.result()->events == static_cast<Clk>(samples + 1));
  }
}

TEST_CASE("a session ends at the sample after somebody stopped it") {
  std::atomic<bool> stop{true};
  Hooks hooks;
  hooks.stop = &stop;
  Plain session(hooks);
  session.stop_at(100, kSample);
  CHECK(session.stopped());
  CHECK(session.result()->end == EndReason::kStopped);
}

TEST_CASE("a fault of which a machine says nothing is in the report, and not noticed") {
  Fault fault;
  fault.kind = FaultKind::kSupplyDip;
  fault.begin_s = 1e-6;
  Plain session({}, fault);
  session.stop_at(100, kDrive | kSample);
  const FaultReport report = session.result()->fault_report;
  CHECK(report.begin == 50);
  CHECK(report.detected == kNever);
  CHECK(report.off == kNever);
  CHECK(report.stopping == 0);
}
