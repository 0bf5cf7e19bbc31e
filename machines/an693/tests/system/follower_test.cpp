// SPDX-License-Identifier: Apache-2.0
//
// Programs of AN-693 on the verilated LM628 with a motor that follows at once. Numbers are those of
// AN-693 and the data sheet.

#include <catch2/catch.hpp>
#include <cstdlib>

#include "cosim/direct.hpp"
#include "machines/an693/machine_members.hpp"
#include "machines/an693/recorder.hpp"
#include "sw_nios/apps/an693/an693.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::an693;
using sw::An693Program;

namespace {

constexpr cosim::Clk kSecond = 50'000'000;

// A motor that is at its desired position from sample to sample.
class Follower final : public cosim::Plant, public cosim::Observer {
 public:
  cosim::Lines sense() const override {
    return cosim::Lines{((count_ + 1) & 2) != 0} << lm628::kEncoderA |
           cosim::Lines{(count_ & 2) != 0} << lm628::kEncoderB;
  }
  cosim::Clk next() const override { return count_ == goal_ ? cosim::kNever : at_ + 4; }
  void commit(cosim::Clk n, cosim::Lines) override {
    if (n < next()) return;
    count_ += goal_ > count_ ? 1 : -1;
    at_ = n;
  }
  int sample(int, cosim::Clk) const override { return 0; }
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override {
    recorder->on(stop, chip, plant);
    if ((stop.why & cosim::kSample) == 0) return;
    goal_ = dynamic_cast<const lm628::Lm628Chip&>(chip).words().position >> 16;
    at_ = stop.edge;
  }

  cosim::Observer* recorder = nullptr;

 private:
  std::int64_t count_ = 0, goal_ = 0;
  cosim::Clk at_ = 0;
};

struct Followed {
  Result result;  // its samples
  std::int32_t real = 0;
};

Result follow(sw::Firmware& app, cosim::Clk end) {
  const auto chip = lm628::make_verilated_chip({});
  Recorder recorder(
      *chip, [](Sample&) {}, [&app](const Sample&) { return app.mailbox().done != 0; });
  Follower follower;
  follower.recorder = &recorder;
  cosim::Loop loop(*chip, follower, follower);
  cosim::run_direct(loop, app, {}, end, [&recorder] { return recorder.done(); });
  REQUIRE(app.mailbox().done);
  Result result;
  result.samples = recorder.take_samples();
  return result;
}

Followed follow(const sw::An693Setup& setup, cosim::Clk end) {
  sw::An693App app(setup);
  Followed followed;
  followed.result = follow(app, end);
  REQUIRE(app.mailbox().failure == 0);
  followed.real = app.mailbox().real[0];
  return followed;
}

// E1, 2 rev/s forward, and the stop module after 0.2 s.
class StopProgram final : public sw::Firmware {
 public:
  explicit StopProgram(sw::An693Stop stop) : stop_(stop) {}
  void start(sw::Bus& bus) override {
    bus.write(sw::lm628_map::kReset, 1);
    bus.write(sw::lm628_map::kTimer, sw::An693App::kResetClk);
  }
  void isr(sw::Bus& bus) override {
    sw::Lm628Port port(bus);
    bus.write(sw::lm628_map::kTimer, kSecond / 5);
    if (step_ == 0) {
      CHECK(sw::initialise(port, sw::Lm628Converter::k12Bits));
      port.command(sw::Lm628Command::kMski, 0);
      sw::load_filter(port, {});
      port.command(sw::Lm628Command::kLtrj, 0x1828);  // velocity forward; A and V follow
      port.long_word(kAcceleration);
      port.long_word(kSpeed);
      port.command(sw::Lm628Command::kStt);
    } else if (step_ == 1) {
      sw::an693_stop(port, stop_);
    }
    CHECK_FALSE(port.stuck());
    mail_.done = ++step_ == 3;
  }
  const sw::Mailbox& mailbox() const override { return mail_; }

  static constexpr int kAcceleration = 0x400, kSpeed = 0x20C4A;  // 131 samples

 private:
  sw::Mailbox mail_;
  sw::An693Stop stop_;
  int step_ = 0;
};

}  // namespace

TEST_CASE("L-05 an693 moves through the port by 200 000 counts in 76 345 samples") {
  sw::An693Setup setup;
  setup.program = An693Program::kAbsolute;
  setup.acceleration = 9;
  setup.velocity = 0x51EB8;
  setup.position = 200000;
  Followed run = follow(setup, 25 * kSecond);
  CHECK(run.real == 200000);
  CHECK(std::abs(test::figure(Options{}, run.result, "motion.samples") - 76345) <= 80);
}

TEST_CASE("L-06 an693 on an ideal follower changes speed at 43 011, 64 517 and 80 308") {
  sw::An693Setup setup;
  setup.program = An693Program::kBreakpoints;
  setup.acceleration = 0x11;
  setup.velocity = 0x20C4A;
  Followed run = follow(setup, 40 * kSecond);
  figures(Options{}, run.result);
  const auto& interrupts = run.result.interrupts;
  REQUIRE(interrupts.size() == 3);
  CHECK(interrupts[0].sample == 43011);
  CHECK(interrupts[1].sample == 64517);
  CHECK(interrupts[2].sample == 80308);
  // 192 344 where a host sends ten bytes and words within the sample of the breakpoint; here the
  // second speed begins a sample later, 2 counts less.
  CHECK(run.real == 192342);
}

TEST_CASE("E4 an693 stops through the port: motor off, at once, or with the acceleration") {
  for (const sw::An693Stop stop : {sw::An693Stop::kOff, sw::An693Stop::kAbrupt,
                                   sw::An693Stop::kSmooth}) {
    StopProgram program(stop);
    const Result result = follow(program, kSecond);
    std::size_t last = 0;  // sample at full speed
    int slowing = 0;
    for (std::size_t k = 0; k < result.samples.size(); ++k) {
      const std::int32_t speed = result.samples[k].words.speed;
      if (speed == StopProgram::kSpeed) last = k;
      if (last != 0 && k > last && speed != 0) ++slowing;
    }
    CAPTURE(stop);
    REQUIRE(last > 131);
    REQUIRE(last + 200 < result.samples.size());
    const lm628::Words end = result.samples.back().words;
    CHECK(end.speed == 0);
    CHECK(slowing == (stop == sw::An693Stop::kSmooth ? 131 : 0));
    CHECK((end.status & sw::lm628_status::kMotorOff) ==
          (stop == sw::An693Stop::kOff ? sw::lm628_status::kMotorOff : 0));
    if (stop == sw::An693Stop::kOff) CHECK(end.output == 0);
  }
}
