// SPDX-License-Identifier: Apache-2.0
//
// The processor's RTL in step with the chip: clock by clock what one model of kung_soc does, and
// write by write what native firmware does that reads the same.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>

#include "machines/kung/tests/soc/runs.hpp"
#include "machines/kung/tests/soc/soc_chip.hpp"
#include "sw_nios/hal/soc_map.hpp"

using namespace trammel;
using namespace trammel::test;

namespace {

struct OneModel {
  std::vector<Transfer> transfers;
  std::vector<std::pair<cosim::Clk, cosim::Lines>> drive;
  cosim::Clk trapped = cosim::kNever;  // edge before which the core's trap is high
};

// The table at the start of the path.
plant::XyTableConfig table_of(const Options& options, const sw::KungSetup& setup) {
  plant::XyTableConfig config = options.plant;
  const sw::Point start = sw::Trajectory(setup).start();
  config.axis[0].start_m = start.x * config.axis[0].encoder_count_m;
  config.axis[1].start_m = start.y * config.axis[1].encoder_count_m;
  return config;
}

// The same with kung_soc as one model; `patch` may change its memory.
OneModel run_one_model(const Options& options, cosim::Clk end, cosim::SerialHost* host = nullptr,
                       const std::function<void(CoreMemory&)>& patch = {}) {
  const auto plan = plan_of(options);
  const sw::KungSetup& setup = plan->setup;
  TablePlant plant(table_of(options, setup));
  CoreMemory memory = core_memory(setup, true);
  if (patch) patch(memory);
  test::SocChip chip(memory);
  chip.host = host;
  DriveEdges drive;
  cosim::Loop loop(chip, plant, drive);
  loop.advance(end, 0);
  return {std::move(chip.transfers), std::move(drive.all), chip.trapped};
}

// Of the 100,000 clocks between two points.
constexpr cosim::Clk kWorstRoutine = 4000;
constexpr double kMeanRoutine = 3500;

// Lines, arcs and a passed corner in 60 x 40 mm; chords of 0.1 mm, of which a point passes several.
Options feed_program(const std::function<void(Options&)>& change = {}) {
  Options options = line();
  options.path.profile = Profile::kFeed;
  options.path.kind = PathKind::kPoints;
  options.path.points_mode = PointsMode::kPath;
  ideal::Moves all;
  ideal::Move m;
  m.feed = 0.4;
  m.to = all.start = {0.1, 0.1};
  const auto to = [&](double x_m, double y_m) {
    m.from = m.to;
    m.to = {x_m, y_m};
    all.moves.push_back(m);
  };
  to(0.14, 0.1);
  m.kind = ideal::Move::Kind::kArc;  // tangential, and on into a corner
  m.center = {0.14, 0.12};
  m.sweep = 1.5707963267948966;
  to(0.16, 0.12);
  m.kind = ideal::Move::Kind::kLine;
  to(0.14, 0.13);
  all.moves.back().stop = true;
  all.moves.back().dwell = 0.02;
  for (int k = 1; k <= 20; ++k) to(0.14 - 1e-4 * k, 0.13 - 1e-6 * k * k);
  to(0.13, 0.1296);
  if (change) change(options);
  options.prepared = make_plan(options, {{}, all, {}});
  return options;
}

void check_same_as_native(const std::string& name) {
  const Options options = scenario(name);
  const Ran ran = run(options);
  CHECK(ran.result.end == EndReason::kDone);
  const std::size_t writes = test::writes_of(ran.transfers).size();
  CHECK(writes > 1000);
  CHECK(native_writes(options, ran.transfers) == writes);
  CHECK(ran.times.routine.worst <= kWorstRoutine);
  CHECK(ran.times.routine.mean() <= kMeanRoutine);
  WARN(name << ": " << writes << " writes, " << ran.times.routine.count << " routines, worst "
            << ran.times.routine.worst << ", mean " << ran.times.routine.mean());
}

// All transfers and gate edges of a span, with random bytes on the serial port.
void check_same_as_one_model(const Options& options, double seconds) {
  const auto end = static_cast<cosim::Clk>(seconds * kClockHz);
  Noise noise(5), same_noise(5);
  const Ran ran = run(options, end, &noise.host);
  CHECK(ran.transfers.size() > 300);

  const OneModel one = run_one_model(options, end, &same_noise.host);
  const std::size_t n = std::min(ran.transfers.size(), one.transfers.size());
  for (std::size_t i = 0; i < n; ++i) {
    if (ran.transfers[i] == one.transfers[i]) continue;
    INFO("transfer " << i);
    FAIL(text(ran.transfers[i]) + "; of one model: " + text(one.transfers[i]));
  }
  CHECK(ran.transfers.size() == one.transfers.size());
  CHECK(ran.drive.size() > 1000);
  CHECK((ran.drive == one.drive));
  CHECK(noise.sent > 500);
  CHECK_THAT(noise.heard, Catch::Matchers::Contains("?\r\n"));
  CHECK(noise.heard == same_noise.heard);
}

// Writes and gate edges of a run, without and with random bytes.
void check_noise(const Options& options, cosim::Clk end, long bytes) {
  const Ran quiet = run(options, end);
  Noise noise(6);
  const Ran noisy = run(options, end, &noise.host);
  CHECK(noise.sent >= bytes);
  CHECK(noisy.result.fault.code == FaultCode::kNone);
  CHECK(noisy.result.fault.processor.empty());
  const auto words = [](const Ran& ran) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const Transfer& t : writes_of(ran.transfers)) all.emplace_back(t.address, t.data);
    return all;
  };
  CHECK(words(quiet).size() > 200);
  CHECK((words(noisy) == words(quiet)));
  CHECK(quiet.drive.size() > 5000);
  CHECK((noisy.drive == quiet.drive));
}

// A program that was not started gets bytes, and asks nothing of the IC.
void check_noise_at_rest(long bytes) {
  const Options options = line();
  const auto core = make_core(core_memory(make_plan(options)->setup, false), false);
  Noise noise(7);
  const auto start_up = static_cast<cosim::Clk>(0.02 * kClockHz);
  const Ran ran = run(options, start_up + bytes * 10 * kClocksPerBit, &noise.host, core.get());
  CHECK(noise.sent >= bytes);
  CHECK(ran.transfers.empty());
  CHECK(ran.drive.empty());
  CHECK_FALSE(ran.trap);
  CHECK(noise.heard.size() > 10);
  CHECK(noise.heard.find_first_not_of("?\r\n") == std::string::npos);
}

}  // namespace

TEST_CASE("transfers and gates are clock by clock those of one model of the whole chip") {
  check_same_as_one_model(line(), 0.05);
}

TEST_CASE("transfers and gates of 0.1 s are those of one model", "[.full]") {
  check_same_as_one_model(line(), 0.1);
}

TEST_CASE("random bytes on the serial port change no write of the core and no gate edge") {
  check_noise(line(), static_cast<cosim::Clk>(0.1 * kClockHz), 1000);
}

TEST_CASE("14,000 random bytes change nothing of the whole circle", "[.full]") {
  check_noise(scenario("circle"), 0, 14'000);
}

TEST_CASE("random bytes with the drives off write no register of the IC") {
  check_noise_at_rest(1000);
}

TEST_CASE("a million random bytes with the drives off write no register of the IC", "[.million]") {
  check_noise_at_rest(1'000'000);
}

TEST_CASE("commands that are typed without a pause lose no byte, at a path's longest routine") {
  Options options = scenario("star");  // its strokes too short to aim the next one on the way
  options.path.star_edge_m = 0.005;
  options.path.star_stroke_ticks = 4;
  options.path.repeats = 30;
  const std::string line = fmt::format("{:<40}\r", fmt::format("r {:#x}", kung_xy_regs::kId));
  const auto begin = static_cast<cosim::Clk>(0.1 * kClockHz);  // it is started by then
  const auto end = static_cast<cosim::Clk>(0.8 * kClockHz);
  std::size_t sent = 0;
  std::string heard;
  cosim::SerialHost host(
      kClocksPerBit,
      [&](cosim::Clk edge) -> std::optional<unsigned char> {
        const bool done = edge + 2 * 410 * kClocksPerBit > end && sent % line.size() == 0;
        if (edge < begin || done) return std::nullopt;
        return static_cast<unsigned char>(line[sent++ % line.size()]);
      },
      [&heard](unsigned char byte) { heard += static_cast<char>(byte); });
  const Ran ran = run(options, end, &host);
  CHECK(ran.times.routine.worst > 2 * 10 * kClocksPerBit);  // longer than two bytes
  const std::string answer = fmt::format("{:#010x}\r\n", kung_xy_regs::kIdValue);
  std::string expected;
  for (std::size_t n = 0; n < sent / line.size(); ++n) expected += answer;
  CHECK(sent > 5000);
  CHECK(heard == expected);
}

TEST_CASE("a file of commands is answered on the serial port, line by line") {
  Options options = line();
  options.uart = "soc_test_commands.txt";
  std::ofstream(options.uart) << "status\ngain x kp 700 1\nnonsense\n"
                                 "gai\xEE" "s\n"  // an n but for its top bit: no command
                                 "gains\n";
  const Ran ran = run(options, static_cast<cosim::Clk>(0.1 * kClockHz));
  std::remove(options.uart.c_str());
  const std::string& heard = ran.result.uart;
  CHECK(heard.substr(0, 9) == "on point ");
  CHECK_THAT(heard, Catch::Matchers::Contains("\r\nok\r\n?\r\n?\r\nx kp 700 1 "));
  const auto all = writes_of(ran.transfers);
  CHECK(std::any_of(all.begin(), all.end(), [](const Transfer& t) {
    return t.address == kung_xy_regs::kX + kung_xy_regs::kKp && t.data == sw::gain_word({700, 1});
  }));
}

TEST_CASE("the core writes what native firmware writes, over the whole circle") {
  check_same_as_native("circle");
}

TEST_CASE("the core writes what native firmware writes, over the whole window") {
  check_same_as_native("window");
}

TEST_CASE("the core writes what native firmware writes, over the whole star") {
  check_same_as_native("star");
}

TEST_CASE("a waiting core stands still, at every stall of a run") {
  Options options = line();
  options.run.audit = true;
  const Ran ran = run(options, static_cast<cosim::Clk>(0.05 * kClockHz));
  CHECK(ran.times.routine.count > 5);
  CHECK(ran.moved.empty());
}

TEST_CASE("an illegal instruction turns the gates off within the trip's clocks, at its address") {
  Options options = line();
  options.fault = {cosim::FaultKind::kProcessorHung, 0.03};
  const auto end = static_cast<cosim::Clk>(0.05 * kClockHz);
  const Ran ran = run(options, end);
  CHECK(ran.result.end == EndReason::kFault);
  CHECK(ran.result.fault.code == FaultCode::kTrip);
  REQUIRE(ran.trap);
  CHECK_THAT(ran.result.fault.processor,
             Catch::Matchers::Contains(fmt::format("{:#010x}", ran.trap->address)));
  CHECK(core_image().at(ran.trap->address / 4) != 0);  // an instruction of the program
  REQUIRE(!ran.drive.empty());
  const auto& [off, gates] = ran.drive.back();
  CHECK(gates == 0);
  CHECK(off >= ran.trap->edge);
  CHECK(off <= ran.trap->edge + kTripsWithin);
}

TEST_CASE("the core draws lines and arcs under the feed profile as native firmware does") {
  const Options options = feed_program();
  const Ran ran = run(options);
  CHECK(ran.result.end == EndReason::kDone);
  const std::size_t writes = test::writes_of(ran.transfers).size();
  CHECK(writes > 500);
  CHECK(native_writes(options, ran.transfers) == writes);
  // Of the 25,000 that a service routine may take.
  CHECK(ran.times.routine.worst <= 7500);
  WARN("feed profile: " << writes << " writes, worst " << ran.times.routine.worst << ", mean "
                        << ran.times.routine.mean());
}

TEST_CASE("the core identifies, estimates and draws with precision as native firmware does") {
  const Options options = feed_program([](Options& o) {
    o.controller = Controller::kPrecision;
    o.plant.axis[0].payload_kg = o.plant.axis[1].payload_kg = 11;
    o.plant.axis[0].cogging_n = o.plant.axis[1].cogging_n = 3;
  });
  const Ran ran = run(options);
  CHECK(ran.result.end == EndReason::kDone);
  const std::size_t writes = test::writes_of(ran.transfers).size();
  CHECK(writes > 4000);
  CHECK(native_writes(options, ran.transfers) == writes);
  // Of the 100,000 between two points; docs/precision.md, section 11.
  CHECK(ran.times.routine.worst <= 33'000);
  CHECK(ran.times.routine.mean() <= 28'500);
  WARN("precision: " << writes << " writes, worst " << ran.times.routine.worst << ", mean "
                     << ran.times.routine.mean());
}

TEST_CASE("lamps show core and interrupts, and a fault of either driver turns all gates off") {
  const Options options = line();
  const sw::KungSetup setup = make_plan(options)->setup;
  for (const unsigned faults : {1u, 2u}) {
    CAPTURE(faults);
    test::SocChip chip(core_memory(setup, true));
    Vkung_soc& pins = chip.pins();
    TablePlant plant(table_of(options, setup));
    DriveEdges drive;
    cosim::Loop loop(chip, plant, drive);
    cosim::Clk end = 0;
    while (end < 5'000'000 && (drive.all.empty() || chip.drive() == 0)) {
      loop.advance(end += 10'000, 0);
    }
    REQUIRE(pins.driver_en_o == 3);
    REQUIRE((pins.status_o & 7) == 3);
    std::array<int, 2> lit{};  // the core waits; an interrupt is served
    int served = 0;
    for (int n = 0, before = 1; n < 300'000; ++n) {  // three of the firmware's points
      loop.advance(++end, 0);
      const int waits = pins.status_o >> 4 & 1, irq = pins.status_o >> 5 & 1;
      lit[0] += waits;
      lit[1] += irq;
      served += irq & ~before;
      before = irq;
    }
    CHECK(served == 3);
    CHECK(lit[0] > 250'000);
    CHECK(lit[1] < 20'000);
    pins.driver_fault_i = static_cast<std::uint8_t>(faults);
    for (cosim::Clk n = 0; n < kTripsWithin; ++n) {
      chip.clock();
      const bool tripped = (pins.status_o & 4) != 0;
      CAPTURE(n, tripped);
      CHECK(pins.driver_en_o == (tripped ? 0 : 3));
    }
    CHECK((pins.status_o & 7) == 4);
    CHECK(pins.gate_hi_o == 0);
    CHECK(pins.gate_lo_o == 0);
  }
}

TEST_CASE("what is behind the memory or the registers is not answered and trips, their end is") {
  struct Load {
    std::uint32_t upper, load;  // lui a0; lw a0
    bool answered;
  };
  for (const Load& one : {Load{0x00010537, 0xFFC52503, true},   // the last of 16,384 words
                          Load{0x00010537, 0x00052503, false},  // the next one
                          Load{0x80000537, 0x3FC52503, true},   // 1 KiB of registers
                          Load{0x80000537, 0x40052503, false},
                          Load{0xC0000537, 0x00452503, true},     // UART
                          Load{0xC0000537, 0x00852503, true},     // WAIT_SEND: it can send
                          Load{0xC0000537, 0x00C52503, false},    // between them and the next 16
                          Load{0xC0000537, 0x01052503, false}}) {
    CAPTURE(one.upper, one.load);
    test::SocChip chip({one.upper, one.load, 0x0000006F});  // then a loop
    for (int n = 0; n < 40; ++n) chip.clock();
    CHECK((chip.pins().status_o >> 2 & 3) == (one.answered ? 0 : 3));  // tripped, trapped
  }
}

TEST_CASE("a read of the serial port has the byte, the bytes lost and the flag in their places") {
  constexpr int kBit = 434, kWait = 128, kRead = 129;  // [clk], [word]
  // lui a0, 0xC0000; lw a1, kWait; beq a1, x0, -4; lw a2, 4 (a0); sw a2, kRead
  const std::vector<std::uint32_t> program{0xC0000537, 0x20002583, 0xFE058EE3, 0x00452603,
                                           0x20C02223, 0x0000006F};
  for (const int sent : {0, 1, 16, 19}) {  // 16 have a place
    CAPTURE(sent);
    test::SocChip chip(program);
    Vkung_soc& pins = chip.pins();
    auto& words = pins.rootp->kung_soc__DOT__u_host__DOT__u_ram__DOT__words;
    for (int n = 0; n < sent; ++n) {
      const int frame = (0x41 + n) << 1 | 1 << 9;
      for (int bit = 0; bit < 10; ++bit) {
        pins.uart_rx_i = frame >> bit & 1;
        for (int k = 0; k < kBit; ++k) chip.clock();
      }
    }
    words[kRead] = 0xFFFFFFFF;
    words[kWait] = 1;
    for (int k = 0; k < 100; ++k) chip.clock();
    const std::uint32_t read = words[kRead], lost = sent > 16 ? sent - 16 : 0;
    CHECK((read & sw::soc_map::kUartEmpty) == (sent == 0 ? sw::soc_map::kUartEmpty : 0));
    CHECK((read >> sw::soc_map::kUartLostShift & 0xFFFF) == lost);
    if (sent > 0) CHECK((read & 0xFF) == 0x41);
  }
}

TEST_CASE("lamps 6 and 7 show the low bits that the serial port receives and sends") {
  // lui a0, 0xC0000; sw a0, 4 (a0): the byte 0, eight low bits behind the start bit
  test::SocChip chip({0xC0000537, 0x00A52223, 0x0000006F});
  Vkung_soc& pins = chip.pins();
  int sends = 0, receives = 0;
  for (int n = 0; n < 6000; ++n) {
    pins.uart_rx_i = n / 700 % 2 != 0;
    chip.clock();
    CAPTURE(n, unsigned{pins.uart_rx_i}, unsigned{pins.uart_tx_o});
    REQUIRE(pins.status_o >> 6 == ((pins.uart_rx_i == 0) | (pins.uart_tx_o == 0) << 1));
    sends += pins.uart_tx_o == 0 && pins.uart_rx_i != 0;
    receives += pins.uart_rx_i == 0 && pins.uart_tx_o != 0;
  }
  CHECK(sends > 1000);
  CHECK(receives > 700);
}
