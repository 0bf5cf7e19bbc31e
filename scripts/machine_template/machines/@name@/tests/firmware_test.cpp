// SPDX-License-Identifier: Apache-2.0
//
// The speed controller, with words in memory in place of the chip.
#include "sw_nios/apps/@name@/@name@.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "sw_nios/hal/pin_map.hpp"

using namespace trammel::sw;
namespace words = @name@_words;

namespace {

struct Words final : Bus {
  std::map<std::uint32_t, std::uint32_t> at;

  std::uint32_t read(std::uint32_t addr) override { return at[addr]; }
  void write(std::uint32_t addr, std::uint32_t data) override { at[addr] = data; }

  std::int32_t duty() { return static_cast<std::int32_t>(at[pin_map::word(words::kDuty)]); }
  bool enabled() { return at[pin_map::word(words::kEnable)] == 1; }
};

struct Bench {
  Words words;
  @Name@App app;

  explicit Bench(const @Name@Setup& setup) : app(setup) {
    app.start(words);
    words.at[platform_map::kIrq] = platform_map::kIrqTimer;
  }

  // An interrupt after the shaft went so far.
  void after(int counts) {
    auto& count = words.at[pin_map::word(words::kCount)];
    const auto word = static_cast<std::uint16_t>(count + static_cast<std::uint32_t>(counts));
    count = static_cast<std::uint32_t>(static_cast<std::int16_t>(word));
    app.isr(words);
  }
};

}  // namespace

TEST_CASE("@name@: the duty word is proportional to the error and has its sign") {
  Bench bench({10, 256, 0, 500, 50'000});
  CHECK(bench.words.enabled());
  CHECK(bench.words.at[platform_map::kTimer] == 50'000);
  bench.after(4);
  CHECK(bench.words.duty() == 6);
  bench.after(17);
  CHECK(bench.words.duty() == -7);
}

TEST_CASE("@name@: the integral part adds up, and not while the duty is at its limit") {
  Bench bench({10, 0, 256, 500, 50'000});
  for (int n = 0; n < 3; ++n) bench.after(8);
  CHECK(bench.words.duty() == 4);
  Bench limited({100, 256 * 100, 256, 500, 50'000});
  for (int n = 0; n < 20; ++n) limited.after(1);
  CHECK(limited.words.duty() == @Name@App::kFull);
  limited.after(100);
  CHECK(limited.words.duty() == 0);
}

TEST_CASE("@name@: the counter may wrap") {
  Bench bench({10, 256, 0, 500, 50'000});
  for (int n = 0; n < 70; ++n) bench.after(1000);
  CHECK(bench.app.mailbox().real[0] == 70'000);
}

TEST_CASE("@name@: the program ends after its interrupts and turns the chip off") {
  Bench bench({10, 256, 0, 3, 50'000});
  for (int n = 0; n < 5; ++n) bench.after(10);
  CHECK(bench.app.mailbox().done == 1);
  CHECK(bench.app.mailbox().failure == 0);
  CHECK(bench.app.mailbox().point == 3);
  CHECK_FALSE(bench.words.enabled());
}

TEST_CASE("@name@: a motor that does not turn at full duty is a failure") {
  Bench bench({100, 256 * 100, 0, 500, 50'000});
  for (std::uint32_t n = 0; n < @Name@App::kStalled; ++n) bench.after(0);
  CHECK(bench.app.mailbox().failure == static_cast<std::uint32_t>(@Name@Failure::kStalled));
  CHECK_FALSE(bench.words.enabled());
}
