// SPDX-License-Identifier: Apache-2.0
//
// Figures, columns and verdicts of the machine larson, from results made by hand in which no two
// values are equal, in each axis and of each sign.
#include <catch2/catch.hpp>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/larson/machine_members.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/message.hpp"

using namespace trammel;

namespace {

using sw::LarsonOp;

larson::Result by_hand() {
  larson::Result result;
  result.end = cosim::EndReason::kDone;
  result.peaks = {{{1.25, 810, 0.31, 1.5, 7}, {1.75, 920, 0.32, 2.5, 9}}};
  const auto call = [&](LarsonOp op, const char* text, std::size_t line, sw::LarsonAnswer answer,
                        std::array<double, 2> at) {
    larson::Call one;
    one.call.op = op;
    one.text = text;
    one.line = line;
    result.calls.push_back(one);
    result.answers.push_back(answer);
    result.done.push_back({5'000'000 * static_cast<cosim::Clk>(result.calls.size()), at,
                           {at[0] + 0.25, at[1]}, {}});
  };
  call(LarsonOp::kCaltbl, "CALTBL", 1, {}, {0, 0});
  call(LarsonOp::kAbstbl, "ABSTBL 3 4", 2, {0, {}}, {0, 0});
  call(LarsonOp::kAbstbl, "ABSTBL 5 6", 3, {-2, {}}, {1, 0});
  call(LarsonOp::kReltbl, "RELTBL 1 1", 4, {-1, {}}, {2, 0});
  call(LarsonOp::kReltbl, "RELTBL 2 2", 5, {0, {}}, {2, 1});
  call(LarsonOp::kWttbl, "WTTBL", 6, {1, {}}, {3, 4});
  call(LarsonOp::kWttbl, "wttbl", 7, {0, {}}, {3, 4});
  call(LarsonOp::kWttbl, "Wttbl", 8, {1, {}}, {3, 4});
  call(LarsonOp::kWhrtbl, "WHRTBL", 9, {0, {3, 4}}, {3.25, 4.5});
  result.pulses = {1111, 2222};
  result.lost = {10, 20};
  result.slips[0].resize(3);
  result.slips[1].resize(4);
  result.breaches[0].resize(1);
  result.breaches[1].resize(2);
  result.travel = {333, 444};
  result.mean_current = {7, 10.5};
  result.end_at = {55.5, 66.25};
  result.interrupts = 12;
  result.err_byte = 34;
  return result;
}

// The run of what Larson prints, made once.
larson::Result& printed_run() {
  static larson::Result result = [] {
    const auto settings = lab::load_scenario(lab::find_scenario("larson-published"));
    auto options = static_cast<const larson::Options&>(*settings);
    options.run.engine = cosim::Engine::kTwin;
    options.run.platform = cosim::Platform::kDirect;
    return lab::simulate(options);
  }();
  return result;
}

}  // namespace

TEST_CASE("larson: each figure is of its own axis and value") {
  auto result = by_hand();
  const std::map<std::string, double> expected{
      {"script.time_s", 0.9},   {"script.calls", 9},       {"script.normal", 2},
      {"script.error", 1},      {"script.refused", 2},     {"script.off_step", 0.5},
      {"script.ahead_step", 0}, {"script.platform_off_step", 0.5},
      {"x.breaches", 1},        {"y.breaches", 2},         {"x.max_torque_N_m", 0.31},
      {"y.max_torque_N_m", 0.32}, {"x.mean_current_A", 7}, {"y.mean_current_A", 10.5},
      {"x.max_power_W", 1.5},   {"y.max_power_W", 2.5},
      {"x.pulses", 1111},       {"y.pulses", 2222},        {"x.lost_step", 10},
      {"y.lost_step", 20},      {"x.slips", 3},
      {"y.slips", 4},           {"x.max_angle_step", 1.25}, {"y.max_angle_step", 1.75},
      {"x.max_rate", 810},      {"y.max_rate", 920},       {"x.max_waiting", 7},
      {"y.max_waiting", 9},     {"x.travel_step", 333},    {"y.travel_step", 444},
      {"x.end_step", 55.5},     {"y.end_step", 66.25},     {"interrupts", 12},
      {"err_byte", 34}};
  std::size_t seen = 0;
  for (const lab::Figure& f : larson::figures(larson::Options{}, result)) {
    if (!f.source.empty()) continue;  // Larson's own
    INFO("figure " << f.id);
    REQUIRE(expected.count(f.id) == 1);
    CHECK(f.value == Approx(expected.at(f.id)));
    if (f.id[1] == '.') CHECK(f.column == (f.id[0] == 'x' ? "X" : "Y"));
    ++seen;
  }
  CHECK(seen == expected.size());
}

TEST_CASE("larson: Larson's times and rates stand beside ours, in their band but for a misprint") {
  larson::Result& result = printed_run();
  std::size_t times = 0, rates = 0;
  for (const lab::Figure& f : larson::figures(larson::Options{}, result)) {
    if (f.source.empty()) continue;
    INFO("figure " << f.id << ": " << f.value);
    REQUIRE(f.printed);
    const bool rate = f.id.rfind("rate.", 0) == 0;
    ++(rate ? rates : times);
    if (f.id == "rate.7650_pps") {
      CHECK(f.value == Approx(240'000 / 88.0).epsilon(1e-4));
      CHECK_FALSE(f.expected);
      continue;
    }
    REQUIRE(f.expected);
    CHECK(f.expected == f.printed);
    CHECK(f.tolerance <= (rate ? 0.51 : 0.051 * *f.printed));
    CHECK(std::fabs(f.value - *f.expected) <= f.tolerance);
  }
  CHECK(times == 7 + 2);
  CHECK(rates == 17);
}

TEST_CASE("larson: with a motor, buffer or processor of one's own nothing is judged by Larson's") {
  const auto judged = [](auto change) {
    larson::Options options;
    change(options);
    larson::Result& result = printed_run();
    std::size_t count = 0;
    for (const lab::Figure& f : larson::figures(options, result)) count += f.expected ? 1 : 0;
    return count;
  };
  CHECK(judged([](larson::Options&) {}) == 7 + 2 + 16);
  CHECK(judged([](larson::Options& o) { o.axis.buffer.dead_s *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.buffer.start *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.buffer.rise *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.buffer.brake *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.inertia *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.stiffness_2 *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.stiffness_3 *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.damping_3 *= 1.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.friction = 0.01; }) == 0);
  CHECK(judged([](larson::Options& o) { o.axis.motor.torque_share = 0.99; }) == 0);
  CHECK(judged([](larson::Options& o) { ++o.processor.access_clk; }) == 0);
}

TEST_CASE("larson: WHRTBL is held against the rotor of its own axis, in each sense") {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const double off : {1.5, -1.5}) {
      CAPTURE(axis, off);
      auto result = by_hand();
      result.done.back().at = {3, 4};
      result.done.back().at[axis] += off;
      const auto value = [&result](const char* id) {
        return test::figure(larson::Options{}, result, id);
      };
      CHECK(value("script.off_step") == Approx(1.5));
      CHECK(value("script.ahead_step") == 0);
      result.done.back().moving[axis] = true;  // where the pulses are is not where it is
      CHECK(value("script.off_step") == 0);
      CHECK(value("script.platform_off_step") == 0);
      CHECK(value("script.ahead_step") == Approx(1.5));
    }
  }
}

TEST_CASE("larson: each column of the trace shows what it is named after") {
  larson::Result result;
  larson::Sample s;
  s.edge = 150'000;
  s.call = 5;
  s.switches = 6;
  s.irq = true;
  s.axis[0] = {0x1234'5678, 101, 102, 103.5, 104.5, 105.5, 106.5, 107, 108.5, 109.5, 110.5, 111.5};
  s.axis[1] = {0xABCD'EF01, 201, 202, 203.5, 204.5, 205.5, 206.5, 207, 208.5, 209.5, 210.5,
               211.5};
  result.samples.push_back(s);
  test::check_row(test::row(larson::Options{}, result, 0),
                  {{"t_s", 3e-3}, {"call", 5}, {"switches", 6}, {"irq", 1},
                   {"x_asked_step", 107}, {"y_asked_step", 207}, {"x_step", 101},
                   {"y_step", 201}, {"x_waiting", 102}, {"y_waiting", 202},
                   {"x_at_step", 103.5}, {"y_at_step", 203.5}, {"x_speed_step_s", 104.5},
                   {"y_speed_step_s", 204.5}, {"x_angle_step", 105.5}, {"y_angle_step", 205.5},
                   {"x_rate_step_s", 106.5}, {"y_rate_step_s", 206.5}, {"x_platform_step", 108.5},
                   {"y_platform_step", 208.5}, {"x_torque_N_m", 109.5}, {"y_torque_N_m", 209.5},
                   {"x_current_A", 110.5}, {"y_current_A", 210.5}, {"x_power_W", 111.5},
                   {"y_power_W", 211.5}, {"x_count", 0x5678},
                   {"y_count", 0xEF01}, {"x_status", 0x1234}, {"y_status", 0xABCD}});
}

TEST_CASE("larson: friction that the steps of a motor cannot follow is refused, by each key") {
  // 6e4 / s of F_c / (v_f J), v_f in rad/s
  const auto refusal = [](double friction, double speed, double inertia) -> std::string {
    larson::Options options;
    plant::StepperConfig& motor = options.axis.motor;
    motor.inertia = 2e-5 * inertia;
    motor.friction_speed = 4 * speed;
    const double speed_rad_s = 4 * 2 * std::acos(-1.0) / motor.steps;
    motor.friction = 6e4 * speed_rad_s * 2e-5 * friction;
    return test::refusal_of([&] { larson::machine().validate(options); });
  };
  CHECK(refusal(0.999, 1, 1) == "");
  CHECK(refusal(1.001, 1, 1) != "");
  CHECK(refusal(1.9, 2, 1) == "");
  CHECK(refusal(1.9, 1, 2) == "");
  CHECK(refusal(3.9, 2, 2) == "");
  CHECK(refusal(4.1, 2, 2) != "");
  CHECK(refusal(1, 0.5, 1) ==
        "motor.friction_N_m / (motor.friction_speed_step_s motor.inertia_kg_m2): 1.2e+05 1/s is "
        "above 6e+04 1/s, the fastest that the motor's steps of 25 us can follow");
  CHECK(refusal(1, 1, 0.25) ==
        "motor.friction_N_m / (motor.friction_speed_step_s motor.inertia_kg_m2): 2.4e+05 1/s is "
        "above 6e+04 1/s, the fastest that the motor's steps of 25 us can follow");
}

TEST_CASE("larson: a table is missed beyond its limit, in each axis and sense, or by a lost step") {
  larson::Options options;
  options.reached_steps = 3;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const double off : {3.0, -3.0, 3.5, -3.5}) {
      CAPTURE(axis, off);
      larson::Result result;
      result.calibrated = true;
      result.known = {100, 200};
      result.origin = {-40, 70};
      result.end_at = {60, 270};
      CHECK(larson::what_missed(options, result) == "");
      result.end_at[axis] += off;
      const std::string name = axis == 0 ? "X" : "Y";
      const std::string text = name + (off < 0 ? " is -3.5" : " is 3.5") + " steps from " +
                               (axis == 0 ? "100" : "200") +
                               ", where its program has it (run.reached_steps)";
      CHECK(larson::what_missed(options, result) == (std::fabs(off) > 3 ? text : ""));
      result.calibrated = false;  // it has it nowhere,
      CHECK(larson::what_missed(options, result) == "");
      result.stopped = axis == 0 ? 1 : 2;  // or a switch has stopped it: it has not arrived
      CHECK(larson::what_missed(options, result) ==
            "a switch stopped " + name + ", and no CALTBL followed" +
                (std::fabs(off) > 3 ? "; " + text : ""));
      const std::string first = "; the first at step 1234, 1.500 s into the run";
      result.lost[axis] = 20;
      result.slips[axis] = {{75'000'000, 1234, 20, false}};
      CHECK(larson::what_missed(options, result) == name + " lost 20 steps" + first);
      result.lost[axis] = 10;
      result.slips[axis].push_back({80'000'000, 5, -10, false});
      const std::string most = name + " lost up to 20 steps in 2 slips, 10 at the end";
      CHECK(larson::what_missed(options, result) == most + first);
      // Where CALTBL fails: in its way a motor is too weak, at the stop a switch is the cause.
      result.end = cosim::EndReason::kFault;
      result.fault = "CALTBL found no switch";
      CHECK(larson::what_missed(options, result) == most + first + "; CALTBL found no switch");
      result.slips[axis].front().at_stop = true;
      CHECK(larson::what_missed(options, result) == "");
    }
  }
}

TEST_CASE("larson: of two axes that are missed the one that was farther off is named") {
  larson::Result result;
  result.calibrated = true;
  result.end_at = {30, -40};
  CHECK_THAT(larson::what_missed({}, result), Catch::StartsWith("Y is -40.0 steps from 0"));
  result.slips[0] = {{50'000'000, 7, 10, false}};
  result.slips[1] = {{60'000'000, 8, -70, false}, {70'000'000, 9, 70, false}};
  result.lost = {10, 0};
  CHECK(larson::what_missed({}, result) ==
        "Y lost up to 70 steps in 2 slips, 0 at the end; the first at step 8, 1.200 s into the "
        "run");
}

TEST_CASE("larson: a run with pulses that made no step is missed, and says why of the first") {
  using Kind = plant::StepBreach::Kind;
  larson::Result result;
  result.breaches[1] = {{75'000'000, Kind::kHold, 12}};
  CHECK(larson::what_missed({}, result) ==
        "1 pulse of Y made no step; the first 1.500 s into the run, as direction turned 0.24 us "
        "behind the edge of its pulse, below translator.hold_us");
  result.breaches[1].front().kind = Kind::kSetup;
  result.breaches[1].push_back({76'000'000, Kind::kWidth, 104});
  CHECK(larson::what_missed({}, result) ==
        "2 pulses of Y made no step; the first 1.500 s into the run, as direction turned 0.24 us "
        "before its pulse, below translator.setup_us");
}

TEST_CASE("larson: metrics and remarks name each call with its answer, each event with its axis") {
  auto result = by_hand();
  result.happened = {{50'000, 0, "interrupt", 1.5, 2, 3}, {100'000, 1, "low switch open", 4, 5, 6}};
  result.happened_count = 17;
  auto record = lab::judged(larson::Options{}.clone(),
                            std::make_unique<larson::Result>(std::move(result)));
  nlohmann::ordered_json json;
  larson::add_metrics(record, json);
  CHECK(json["event_count"] == 17);
  CHECK(json["events"].dump() ==
        R"([{"time_s":0.001,"axis":"x","what":"interrupt","at_step":1.5,"count":2,"status":3},)"
        R"({"time_s":0.002,"axis":"y","what":"low switch open","at_step":4.0,"count":5,)"
        R"("status":6}])");
  REQUIRE(json["calls"].size() == 9);
  const char* const answers[] = {"", "", "moving", "not calibrated", "", "normal", "error",
                                 "normal", "3 4"};
  for (std::size_t k = 0; k < 9; ++k) {
    INFO("call " << k);
    CHECK(json["calls"][k]["answer"] == answers[k]);
    CHECK(json["calls"][k]["line"] == k + 1);
    CHECK(json["calls"][k]["time_s"].get<double>() == Approx(0.1 * static_cast<double>(k + 1)));
  }
  CHECK(json["calls"][8]["call"] == "WHRTBL");
  CHECK(json["calls"][8]["x_step"] == 3.25);
  CHECK(json["calls"][8]["y_step"] == 4.5);
  const auto lines = larson::remarks(record);
  REQUIRE(lines.size() == 6);
  CHECK(lines.front() == "    0.3000 s  ABSTBL 5 6: moving");
  CHECK(lines.back() == "    0.9000 s  WHRTBL: 3 4");
}
