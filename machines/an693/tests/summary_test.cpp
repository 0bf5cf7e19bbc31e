// SPDX-License-Identifier: Apache-2.0
//
// What is told of a run of the machine an693: figures, interrupts, remarks, what it missed, in each
// program and sense, from results made by hand. docs/figures.md lists the figures.
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lab/record.hpp"
#include "machines/an693/machine_members.hpp"
#include "parts/lm628/signals.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/lm628_words.hpp"

using namespace trammel;
using namespace trammel::an693;
using Lines = std::vector<std::string>;
using Program = sw::An693Program;

namespace {

lab::Record record_of(const Options& options, Result result) {
  return lab::judged(options.clone(), std::make_unique<Result>(std::move(result)));
}

// Samples at 1 ms; where the trajectory and the shaft are [count] is the test's.
template <class Desired, class Real>
Result moved(const Options& options, int samples, Desired desired, Real real) {
  Result result;
  result.end = cosim::EndReason::kDone;
  for (int n = 0; n < samples; ++n) {
    Sample s;
    s.edge = 50'000 * (n + 1);
    s.words.position = std::int64_t{desired(n)} * 65536;
    s.words.actual = static_cast<std::int32_t>(real(n));
    s.theta = real(n) * plant::MotorAxis::kTurn / options.plant.counts;
    result.samples.push_back(s);
  }
  return result;
}

// Off, then a step of 4 counts, overshoot by 1, an interrupt at the 5th sample.
Result by_hand() {
  Result result;
  result.end = cosim::EndReason::kDone;
  const int real[] = {0, 0, 1, 4, 5, 4, 4};
  for (int n = 0; n < 7; ++n) {
    Sample s;
    s.edge = 12800 * (n + 1);
    s.words.status = n == 0 ? 0x80 : 0x00;
    s.words.position = std::int64_t{n == 0 ? 0 : 4} << 16;
    s.words.actual = real[n];
    s.words.error = n == 0 ? 0 : 4 - real[n];
    s.theta = real[n] * plant::MotorAxis::kTurn / 4000;
    s.host_irq = n >= 5;
    s.volt = n == 3 ? -3.5 : 1;
    s.omega = n == 3 ? -2.5 * plant::MotorAxis::kTurn : 1;
    s.i = n == 4 ? -0.75 : 0.5;
    result.samples.push_back(s);
  }
  result.desired = result.real = 4;
  result.clocks = 100000;
  result.evaluated = 1000;
  return result;
}

}  // namespace

TEST_CASE("an693: each largest value is that of either sign, in the first sample or the last") {
  for (const std::size_t at : {std::size_t{0}, std::size_t{4}}) {
    for (const int sign : {1, -1}) {
      CAPTURE(at, sign);
      Result result;
      for (std::size_t n = 0; n < 5; ++n) {
        Sample s;
        if (n == at) {
          s.words.error = 17 * sign;
          s.omega = 2.5 * plant::MotorAxis::kTurn * sign;
          s.volt = 3.5 * sign;
          s.i = 0.75 * sign;
        }
        result.samples.push_back(s);
      }
      result.desired = 111;
      result.real = -222;
      const auto of = [&](const char* id) { return test::figure(Options{}, result, id); };
      CHECK(of("motion.max_error_counts") == 17);
      CHECK(of("motion.max_speed_rev_s") == Approx(2.5));
      CHECK(of("motion.max_voltage_V") == 3.5);
      CHECK(of("motion.max_current_A") == 0.75);
      CHECK(of("motion.desired_count") == 111);
      CHECK(of("motion.real_count") == -222);
    }
  }
}

TEST_CASE("an693: motion, overshoot and settling are those of either sense, there and back") {
  const Options options;
  for (const int sense : {1, -1}) {
    // From sample 2 on in steps of 10 counts to 100; the shaft 5 beyond in sample 14 and 3 short
    // until sample 16; back by one step at sample 30, where the shaft is 7 beyond at 32.
    const auto desired = [sense](int n) {
      return sense * (n < 2 ? 0 : n < 12 ? 10 * (n - 1) : n < 30 ? 100 : 60);
    };
    const auto real = [&](int n) {
      const int off = n == 14 ? 5 : n > 2 && n <= 16 ? -3 : n == 32 ? -7 : 0;
      return desired(n) + sense * off;
    };
    Result result = moved(options, 40, desired, real);
    const auto of = [&](const std::string& id) {
      return test::figure(options, result, "motion." + id);
    };
    CAPTURE(sense);
    CHECK(of("samples") == 29);  // of 2 to 30, the first being 1
    CHECK(of("time_s") == Approx(29 * 256e-6));
    CHECK(of("overshoot_counts") == Approx(7));
    CHECK(of("settled_s") == Approx(15 * 256e-6));
  }
}

TEST_CASE("an693: interrupts are told with sample, time, both places and status, once each") {
  const Options options;
  Result result = moved(options, 8, [](int n) { return n < 2 ? 0 : -20 * n; },
                        [](int n) { return -19.0 * n; });
  host::DiskVector<Sample> all;
  for (std::size_t n = 0; n < 8; ++n) {
    Sample s = result.samples[n];
    s.host_irq = n == 0 || n == 4 || n == 5 || n == 7;
    s.words.status = static_cast<std::uint8_t>(0x04 + n);
    all.push_back(s);
  }
  result.samples = std::move(all);
  const lab::Record record = record_of(options, std::move(result));
  nlohmann::ordered_json json;
  add_metrics(record, json);
  CHECK(json["interrupts"].dump() ==
        R"([{"sample":0,"time_s":0.001,"desired_count":0,"real_count":0,"status":4},)"
        R"({"sample":3,"time_s":0.005,"desired_count":-80,"real_count":-76,"status":8},)"
        R"({"sample":6,"time_s":0.008,"desired_count":-140,"real_count":-133,"status":11}])");
  CHECK(remarks(record) ==
        Lines{"host interrupt at 0.0010 s, before the motion: desired 0, real 0 counts",
              "host interrupt at 0.0050 s, sample 3: desired -80, real -76 counts",
              "host interrupt at 0.0080 s, sample 6: desired -140, real -133 counts"});
  CHECK(test::figure(record, "motion.interrupts") == 3);
}

TEST_CASE("an693: remarks tell of ten host interrupts, and how many more there were") {
  for (const int interrupts : {10, 11, 25}) {
    Result result;
    for (int n = 0; n < 2 * interrupts; ++n) {
      Sample s;
      s.host_irq = n % 2 == 1;
      result.samples.push_back(s);
    }
    const Lines lines = remarks(record_of({}, std::move(result)));
    CAPTURE(interrupts);
    REQUIRE(lines.size() == (interrupts == 10 ? 10 : 11));
    CHECK(lines[9].find("host interrupt at") == 0);
    if (interrupts > 10) {
      CHECK(lines[10] == "and " + std::to_string(interrupts - 10) + " more host interrupts");
    }
  }
}

TEST_CASE("an693: each program is held against its own target, on either side of it and of zero") {
  struct Case {
    Program program;
    bool target;  // is asked for
    bool at;      // the shaft is to be at it
  };
  for (const Case& one : {Case{Program::kHold, false, false}, Case{Program::kAbsolute, true, true},
                          Case{Program::kRelative, true, true},
                          Case{Program::kBreakpoints, false, true}}) {
    for (const int target : {1000, -1000}) {
      Options options;
      options.program = one.program;
      options.position = target;
      const auto missed = [&](int asked, int off, int moves = 0) {
        return what_missed(options,
                           moved(options, 200, [&](int n) { return n < 100 ? n * asked / 100
                                                                           : asked; },
                                 [&](int n) { return asked + off + n % 2 * moves - moves / 2.0; }));
      };
      CAPTURE(static_cast<int>(one.program), target);
      CHECK(missed(target, 0) == "");
      const std::string where = std::to_string(target);
      CHECK(missed(target + 7, 0) ==
            (one.target ? "the trajectory ended at " + std::to_string(target + 7) +
                              " counts, not at " + where
                        : ""));
      for (const int off : {49, -49, 51, -51}) {
        CAPTURE(off);
        const bool misses = one.at && std::abs(off) > 50;
        CHECK(missed(target, off) ==
              (misses ? "the shaft is 51 counts from the target of " + where : ""));
      }
      CHECK(missed(target, 0, 50) == "");
      CHECK(missed(target, 0, 52) == "the shaft moves by 52 counts at the end");
    }
  }
}

TEST_CASE("an693: a short travel has a narrow band, by where the trajectory went farthest") {
  for (const int sense : {1, -1}) {
    const auto missed = [sense](int farthest, int off) {
      Options options;
      options.program = Program::kBreakpoints;
      return what_missed(options, moved(options, 300,
                                        [&](int n) { return n < 100 ? sense * farthest : 0; },
                                        [&](int) { return static_cast<double>(sense * off); }));
    };
    CAPTURE(sense);
    CHECK(missed(100, 25) == "");
    CHECK(missed(100, 26) == "the shaft is 26 counts from the target of 0");
    CHECK(missed(4, 3) == "");
    CHECK(missed(4, 4) == "the shaft is 4 counts from the target of 0");
  }
  Options wide;
  wide.program = Program::kAbsolute;
  wide.position = 1000;
  for (const int reached : {51, 60}) {
    wide.reached_counts = reached;
    CHECK(what_missed(wide, moved(wide, 300, [](int n) { return n < 100 ? 10 * n : 1000; },
                                  [](int n) { return n % 2 == 0 ? 974.0 : 1026.0; })) ==
          (reached == 51 ? "the shaft moves by 52 counts at the end" : ""));
  }
  CHECK(what_missed(Options{}, Result{}) == "");
}

TEST_CASE("an693: a shaft is asked where it stands in the last half of its rest, no earlier") {
  Options options;
  options.program = Program::kAbsolute;
  options.position = 1000;
  // Stands from sample 100 to 299; the last half are 200 to 299.
  const auto missed = [&](int from, int until) {
    return what_missed(options,
                       moved(options, 300, [](int n) { return n < 100 ? 10 * n : 1000; },
                             [&](int n) { return n >= from && n < until ? 1200.0 : 1000.0; }));
  };
  CHECK(missed(100, 200) == "");
  CHECK(missed(100, 201) == "the shaft moves by 200 counts at the end");
  CHECK(missed(299, 300) == "the shaft moves by 200 counts at the end");
}

TEST_CASE("an693: of steps there and back the odd ones end at the size, the others at zero") {
  for (const int size : {40, -40}) {
    Options options;
    options.program = Program::kTuning;
    options.position = size;
    const auto missed = [&](int step, int trajectory, std::vector<std::size_t> ends, double off = 0,
                            double swing = 0) {
      const auto asked = [&](int n) {
        return n / 100 == step ? trajectory : n / 100 % 2 == 0 ? size : 0;
      };
      Result result = moved(options, 400, asked, [&](int n) {
        return asked(n) + (n / 100 == step ? off + n % 2 * swing : 0);
      });
      result.step_ends = std::move(ends);
      return what_missed(options, result);
    };
    CAPTURE(size);
    CHECK(missed(9, 0, {100, 200, 300, 400}) == "");
    CHECK(missed(3, 5, {100, 200, 300, 400}) ==
          "step 4 of 4: the trajectory ended at 5 counts, not at 0");
    CHECK(missed(2, 5, {100, 200, 300, 400}) ==
          "step 3 of 4: the trajectory ended at 5 counts, not at " + std::to_string(size));
    CHECK(missed(9, 0, {100, 100, 200}) == "step 2 of 3: no sample fell in it");
    const std::vector<std::size_t> ends{100, 200, 300, 400};
    CHECK(missed(0, size, ends, -size) ==
          "step 1 of 4: the shaft is 40 counts from the target of " + std::to_string(size));
    CHECK(missed(1, 0, ends, 10) == "");
    CHECK(missed(1, 0, ends, 11) == "step 2 of 4: the shaft is 11 counts from the target of 0");
    CHECK(missed(1, 0, ends, -5, 11) == "step 2 of 4: the shaft moves by 11 counts at the end");
  }
}

TEST_CASE("an693: a converter that an LM629 has not is warned of before a run") {
  Options options;
  options.part.dac_bits = 8;
  CHECK(machine().texts.warnings(options).empty());
  options.part.variant = lm628::Variant::kLm629;
  const Lines lines = machine().texts.warnings(options);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].find("chip.dac_bits = 8") != std::string::npos);
}

TEST_CASE("an693: each column of the trace shows what it is named after") {
  Result result;
  Sample s;
  s.edge = 150'000;
  s.words = test::numbered_words(100);
  s.host_irq = true;
  s.theta = plant::MotorAxis::kTurn / 4;
  s.omega = 121;
  s.i = 122;
  s.volt = 123;
  result.samples.push_back(s);
  std::map<std::string, double> expected = test::numbered_columns("", 100);
  expected.insert({{"t_s", 3e-3}, {"host_irq", 1}, {"theta_count", 1000}, {"omega_rad_s", 121},
                   {"i_A", 122}, {"u_V", 123}});
  test::check_row(test::row(Options{}, result, 0), expected);
}

TEST_CASE("an693: with the motor off a shaft pushed away is no motion, and no overshoot") {
  Result result = by_hand();
  const int pushed[] = {10, 14};  // where the desired position follows the real one
  for (int n = 0; n < 2; ++n) {
    Sample s = result.samples.back();
    s.edge += 12800;
    s.words.status = 0x80;
    s.words.position = std::int64_t{pushed[n]} << 16;
    s.words.actual = pushed[n] + n;
    s.theta = (pushed[n] + 3) * plant::MotorAxis::kTurn / 4000;
    s.host_irq = n == 1;
    result.samples.push_back(s);
  }
  CHECK(test::figure(Options{}, result, "motion.samples") == 1);
  CHECK(test::figure(Options{}, result, "motion.overshoot_counts") == Approx(1));
  REQUIRE(result.interrupts.size() == 2);
  CHECK(result.interrupts[1].desired == 14);
  CHECK(result.interrupts[1].real == 15);
}

TEST_CASE("an693: the first step takes until it stays in the band, however many samples it moves") {
  const Options options;
  for (const int moving : {1, 2, 10, 30}) {
    CAPTURE(moving);
    Result result;
    for (int n = 0; n < 100; ++n) {  // back to 0 from sample 60 on, where the shaft does not follow
      const int desired = n < 60 ? std::min(n, moving) * 60 / moving : 0;
      const int shaft = n < 60 ? desired - (n > 0 && n <= 20 ? 3 : 0) : 60;
      Sample s;
      s.words.position = std::int64_t{desired} << 16;
      s.theta = shaft * plant::MotorAxis::kTurn / options.plant.counts;
      result.samples.push_back(s);
    }
    CHECK(test::figure(options, result, "motion.settled_s") == Approx(20 * options.sample_s()));
  }
}

TEST_CASE("an693: the words of a part are those of its samples") {
  const lm628::Words all{-5 * 65536, 6, 7, -8, 9, -10, 11, -12, 0x84};
  const std::map<std::string, std::int64_t> wanted{
      {"desired_count", -5}, {"desired_speed", 6}, {"real_count", 7}, {"e", -8}, {"p", 9},
      {"i", -10}, {"d", 11}, {"output", -12}, {"status", 0x84}, {"status.motor_off", 1},
      {"status.complete", 1}};
  for (std::size_t n = 0; n < lm628::signals().size(); ++n) {
    const std::string name = lm628::signals()[n].name;
    INFO(name);
    const auto found = wanted.find(name);
    CHECK(lm628::word(all, n) == (found == wanted.end() ? 0 : found->second));
  }
}

TEST_CASE("an693: what ended a run is in its verdict, of a script that waited in vain alone") {
  Result result;
  result.fault = "test:1: wait hi: not within 1 s";
  result.end = cosim::EndReason::kTimeout;
  CHECK(machine().verdict(Options{}, result) == result.fault);
  result.end = cosim::EndReason::kFault;
  CHECK(machine().verdict(Options{}, result) == "tripped: " + result.fault);
}
