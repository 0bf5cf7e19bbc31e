// SPDX-License-Identifier: Apache-2.0
//
// Faults in a run of the machine gantry: where one can be, what it does, by what it is noticed.
#include <catch2/catch.hpp>
#include <array>
#include <cstdint>
#include <exception>
#include <utility>

#include "lab/record.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::gantry;
using Catch::Contains;

TEST_CASE("gantry: a fault is noticed by what chip and program count, and names it") {
  for (const auto& [sends, by] : {std::pair{"0.02:15?", "unknown channel"},
                                  {"0.02:xFFFFFFFFFFFFFF00", "malformed frame"},
                                  {"0.02:31?", ""}}) {
    Options options = by_twin(0.05);
    options.sends = sends;
    options.fault.kind = cosim::FaultKind::kSupplyDip;
    options.fault.value = 99;
    const Result result = lab::simulate(options);
    CAPTURE(sends);
    CHECK(result.fault_report.by == by);
    const bool noticed = result.fault_report.detected != cosim::kNever;
    CHECK(noticed == (*by != '\0'));
    if (noticed) {
      CHECK(lab::seconds_of(result.fault_report.detected) == Approx(0.0203).margin(1e-3));
    }
  }
}

TEST_CASE("gantry: how far a cart went once its motors were off is told in mm") {
  Options options = by_twin(5);
  options.sends = "0.01:21=305";
  options.firmware.watch_sensor = true;
  options.fault.kind = cosim::FaultKind::kConverterSaturated;
  options.fault.begin_s = 0.15;
  options.fault.value = -1;
  const Result result = lab::simulate(options);
  const cosim::FaultReport& report = result.fault_report;
  REQUIRE(report.off != cosim::kNever);
  double off_mm = 0;
  for (const Sample& s : result.samples) {
    if (s.edge <= report.off) off_mm = 1e3 * s.x;
    if (s.edge > report.off) CHECK(s.words.force == std::array<std::int32_t, 2>{0, 0});
  }
  const double way = 1e3 * result.samples.back().x - off_mm;
  CHECK(way > 1);
  CHECK(report.stopping == Approx(way).margin(0.5));
  CHECK_FALSE(report.at_stop);
}

TEST_CASE("gantry: a fault is on the serial line, on either converter and each of its outputs") {
  const auto told = [](cosim::FaultKind kind, int axis, int line, int value) {
    Options options = by_twin(1e-3);
    options.fault.kind = kind;
    options.fault.axis = axis;
    options.fault.line = line;
    options.fault.value = value;
    return test::refusal_of<std::exception>([&] { lab::simulate(options); });
  };
  using Kind = cosim::FaultKind;
  CHECK(told(Kind::kEncoderStuck, 0, 0, -1) == "");
  CHECK(told(Kind::kEncoderStuck, 1, 0, -1) == "");
  CHECK(told(Kind::kConverterStuck, 1, 1, 1023) == "");
  CHECK_THAT(told(Kind::kConverterStuck, 0, 2, 0), Contains("inject.line"));
  CHECK(told(Kind::kOutputStuck, 1, 1, 0) == "");
  CHECK_THAT(told(Kind::kOutputStuck, 0, 2, 0), Contains("inject.line"));
  CHECK_THAT(told(Kind::kRegisterFlip, 0, 0, 0), Contains("inject.fault: register_flip"));
}

TEST_CASE("gantry: a fault of the line silences it, over-temperature is that of either motor") {
  using Kind = cosim::FaultKind;
  const auto heard = [](Kind kind, int axis, int line) {
    Options options = by_twin(0.1);
    options.sends = "0.05:d0? 0.06:d1?";
    options.fault.kind = kind;
    options.fault.axis = axis;
    options.fault.line = line;
    options.fault.value = kind == Kind::kSupplyDip ? 99 : line == 0 ? -1 : 1;
    options.fault.begin_s = 0.02;
    return lab::simulate(options).heard;
  };
  const auto whole = heard(Kind::kSupplyDip, 0, 0);
  REQUIRE(whole.size() == 4);  // the reset message, and an answer of a byte to each
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    CHECK(heard(Kind::kEncoderStuck, axis, 0).size() == 2);
    const auto hot = heard(Kind::kEncoderStuck, axis, 1);
    REQUIRE(hot.size() == 4);
    CHECK(hot[2] == (axis == 0 ? 0x20 : 0x00));  // a bit of channel 0, set or clear
    CHECK(hot[3] == (axis == 1 ? 0x21 : 0x01));
  }
}

TEST_CASE("gantry: frames that come while the processor stands are counted as lost") {
  Options options = by_twin(0.1);
  options.sends.clear();
  for (int k = 0; k < 60; ++k) options.sends += "0.05:1? ";
  options.fault.kind = cosim::FaultKind::kProcessorStopped;
  options.fault.begin_s = 0.02;
  const Result result = lab::simulate(options);
  CAPTURE(result.lost, result.malformed, result.unknown);
  CHECK(result.lost > 0);
  CHECK(result.lost < 60);
  CHECK(result.malformed == 0);
  CHECK(result.unknown == 0);
  CHECK(result.passes < 12);
}
