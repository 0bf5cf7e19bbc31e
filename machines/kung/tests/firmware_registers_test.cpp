// SPDX-License-Identifier: Apache-2.0
//
// Every register that the trajectory program writes, by its address and its whole word, and every
// one that it reads, with a set-up whose members all differ from each other and from reset values.
#include <catch2/catch.hpp>
#include <cstdio>
#include <map>
#include <string>

#include "machines/kung/tests/fake_chip.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

using Words = std::map<std::uint32_t, std::uint32_t>;

std::string register_text(std::uint32_t address) {
  for (const reg::Register& r : reg::kRegisters) {
    if (r.address == address) return r.name;
  }
  char text[24];
  std::snprintf(text, sizeof text, "0x%03X", address);
  return text;
}

// "" or the registers in which the two differ, with both words.
std::string differing(const Words& is, const Words& wanted) {
  std::string all;
  const auto text = [](const Words& words, std::uint32_t address) {
    const auto at = words.find(address);
    char hex[16];
    if (at == words.end()) return std::string("not written");
    std::snprintf(hex, sizeof hex, "0x%08X", at->second);
    return std::string(hex);
  };
  const auto add = [&](std::uint32_t address) {
    all += register_text(address) + " is " + text(is, address) + ", wanted " +
           text(wanted, address) + "\n";
  };
  for (const auto& [address, word] : wanted) {
    const auto at = is.find(address);
    if (at == is.end() || at->second != word) add(address);
  }
  for (const auto& [address, word] : is) {
    if (wanted.count(address) == 0) add(address);
  }
  return all;
}

// The last word written to each address from that access on.
Words written(const FakeChip& chip, std::size_t from = 0) {
  Words words;
  for (const Access& w : chip.writes(from)) words[w.address] = w.data;
  return words;
}

// Line from (50 100, 60 200) to (50 300, 60 500) [count].
KungSetup unequal_setup() {
  KungSetup s;
  s.path = Path::kLine;
  s.line = {{from_counts(50'100), from_counts(60'200)}, {from_counts(50'300), from_counts(60'500)},
            4};
  s.carrier = 2;
  s.position_rate = 3;
  s.irq_period = 5;
  s.watchdog_ticks = 321;
  s.current_limit = 987;
  s.dead_time_min = 33;
  for (std::uint32_t a = 0; a < 2; ++a) {
    AxisSetup& x = s.axis[a];
    const auto n = static_cast<std::int32_t>(100 * a);
    x.kp = {701 + n, 1};
    x.ki = {702 + n, -2};
    x.kv = {703 + n, 3};
    x.eta = {704 + n, -4};
    x.kp_cur = {705 + n, 5};
    x.ki_cur = {706 + n, -6};
    x.shift_e = a == 0 ? 11 : -1;
    x.shift_de = a == 0 ? -2 : 6;
    x.a0 = 200'001 + a;
    x.a0_scale = 1 + a;
    x.b2 = 8'000'001 + a;
    x.angle_step = 345'678 + a;
    x.theta_ofs = 0x9000'0001u + a;
    x.adc_zeros = 2 + a;
    x.dead_time = 111 + a;
    x.qep_filter = 7 + a;
    x.stroke_min = -301 - n;
    x.stroke_max = 110'001 + n;
  }
  return s;
}

}  // namespace

TEST_CASE("start writes each register of both axes its own word of the set-up, and nothing else") {
  Machine m(unequal_setup());
  m.app.start(m.chip);
  REQUIRE(failure(m) == Failure::kNone);
  Words wanted{
      {0x204, 1},  // COMMIT
      {0x208, 1},  // IRQ_EN.tick
      {0x20C, 3},  // IRQ_STAT
      {0x21C, 321}, {0x220, 0x554E4C4B}, {0x224, 987}, {0x228, 33}, {0x22C, 5}, {0x240, 0x32}};
  for (std::uint32_t a = 0; a < 2; ++a) {
    const std::uint32_t base = 0x100 * a, n = 100 * a;
    wanted.insert({{base + 0x000, 0x30},  // reset of model and table
                   {base + 0x008, a == 0 ? 50'100u : 60'200u},
                   {base + 0x040, 0x01'0000 | (701 + n)},
                   {base + 0x044, 0x1E'0000 | (702 + n)},
                   {base + 0x048, 0x03'0000 | (703 + n)},
                   {base + 0x04C, 0x1C'0000 | (704 + n)},
                   {base + 0x050, a == 0 ? 0x1E0Bu : 0x061Fu},
                   {base + 0x054, (1 + a) << 20 | (200'001 + a)},
                   {base + 0x058, 8'000'001 + a},
                   {base + 0x060, 0x05'0000 | (705 + n)},
                   {base + 0x064, 0x1A'0000 | (706 + n)},
                   {base + 0x068, 0x9000'0001u + a},
                   {base + 0x06C, (7 + a) << 16 | (111 + a)},
                   {base + 0x078, a == 0 ? 50'100u : 60'200u},
                   {base + 0x080, 0u - (301 + n)},
                   {base + 0x084, 110'001 + n},
                   {base + 0x088, 0},
                   {base + 0x08C, 0},
                   {base + 0x0B0, 345'678 + a},
                   {base + 0x0B4, 0},
                   {base + 0x0BC, 2 + a}});
  }
  CHECK(differing(written(m.chip), wanted) == "");
}

TEST_CASE("the interrupt that arms writes the mode of each axis and the guards, and nothing else") {
  for (const std::uint32_t a : {0u, 1u}) {
    for (int flag = 0; flag < 4; ++flag) {
      CAPTURE(a, flag);
      KungSetup setup = unequal_setup();
      setup.axis[a].adapt = flag == 0;
      setup.axis[a].interpolate = flag == 1;
      setup.axis[a].feedforward = flag == 2;
      setup.axis[a].stroke_check = flag == 3;
      Machine m(setup);
      m.app.start(m.chip);
      const std::size_t from = m.chip.log.size();
      m.interrupt();
      constexpr std::uint32_t kFlags[] = {0x08, 0x40, 0x80, 0};
      Words wanted{{0x208, 3}, {0x20C, 2}, {0x218, 0x434C5246}, {0x220, 0x4C4F434B}};
      for (const std::uint32_t k : {0u, 1u}) {
        wanted[0x100 * k] = 0x07 | (k == a ? kFlags[flag] : 0);
        wanted[0x100 * k + 0x004] = 0x1E;
        wanted[0x100 * k + 0x088] = k == a && flag == 3;
      }
      CHECK(differing(written(m.chip, from), wanted) == "");
    }
  }
}

TEST_CASE("each point goes to its own axis, and each member of a record is its own register") {
  Machine m(unequal_setup());
  m.arm();
  for (std::uint32_t point = 0; point < 3; ++point) {
    CAPTURE(point);
    const std::uint32_t n = 10 * point;
    const Words shown{{0x004, 0x1204 + n}, {0x104, 0x1508 + n}, {0x00C, 71 + n}, {0x10C, 72 + n},
                      {0x010, 73 + n},     {0x110, 74 + n},     {0x024, 75 + n}, {0x124, 76 + n}};
    for (const auto& [address, word] : shown) m.chip.registers[address] = word;
    m.chip.shown_status = {shown.at(0x004), shown.at(0x104)};
    const std::size_t from = m.chip.log.size();
    m.interrupt();
    REQUIRE(m.app.log_size() == point + 1);
    const LogRecord& r = m.app.log(point);
    const std::uint32_t x = 50'100 + 50 * point, y = 60'200 + 75 * point;
    CHECK(differing(written(m.chip, from), {{0x20C, 1}, {0x008, x}, {0x108, y}, {0x204, 1}}) == "");
    const auto word = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
    CHECK(differing({{0x210, r.tick}, {0x008, word(r.x_cmd)}, {0x108, word(r.y_cmd)},
                     {0x004, r.x_status}, {0x104, r.y_status}, {0x00C, word(r.x_pos)},
                     {0x10C, word(r.y_pos)}, {0x010, word(r.x_model)}, {0x110, word(r.y_model)},
                     {0x024, word(r.x_iq)}, {0x124, word(r.y_iq)}},
                    [&] {
                      Words all = shown;
                      all.insert({{0x210, m.chip.registers[reg::kTick]}, {0x008, x}, {0x108, y}});
                      return all;
                    }()) == "");
  }
}

TEST_CASE("a path may touch each end of each stroke, and pass none by a count") {
  for (const std::uint32_t a : {0u, 1u}) {
    for (const bool high : {false, true}) {
      for (const std::int32_t beyond : {0, 1}) {
        CAPTURE(a, high, beyond);
        KungSetup setup = unequal_setup();
        const std::int32_t low_end[] = {50'100, 60'200}, high_end[] = {50'300, 60'500};
        if (high) {
          setup.axis[a].stroke_max = high_end[a] - beyond;
        } else {
          setup.axis[a].stroke_min = low_end[a] + beyond;
        }
        Machine m(setup);
        m.app.start(m.chip);
        CHECK(failure(m) == (beyond == 1 ? Failure::kOutOfStroke : Failure::kNone));
      }
    }
  }
}

TEST_CASE("a board that stays busy keeps the drives off, in each axis and at each of two places") {
  for (const std::uint32_t a : {0u, 1u}) {
    for (const bool arming : {false, true}) {
      CAPTURE(a, arming);
      Machine m(unequal_setup());
      m.chip.shown_status[a] = arming ? 0u : 1u;
      m.app.start(m.chip);
      if (arming) {
        REQUIRE(failure(m) == Failure::kNone);
        m.chip.shown_status[a] = 1;
        m.interrupt();
      }
      CHECK(failure(m) == Failure::kBusy);
      CHECK(still_on(m.chip) == "");
    }
  }
}
