// SPDX-License-Identifier: Apache-2.0
//
// Each figure and verdict against the same figure computed from the samples in another way, with
// axes that have nothing in common, and each largest value of either sign.
#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/figures.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr double kCount = 5e-6;
constexpr std::size_t kFirst = 7, kCounted = 40, kAfter = 30;

Options unlike() {
  Options options;
  options.path.kind = PathKind::kLine;
  options.plant.axis[0].resistance_ohm = 21;
  options.plant.axis[1].resistance_ohm = 33;
  options.plant.axis[0].supply_ohm = options.plant.axis[1].supply_ohm = 1;
  options.settle_s = 1;
  options.settled_m = 1e-3;
  return options;
}

// A line along (2, 1); what is outside of the samples that count is larger than what is in them.
Result by_hand(double sign) {
  Result result;
  result.end = EndReason::kDone;
  result.points = 10;
  result.first_tick = kFirst;
  result.end_tick = kFirst + kCounted;
  for (std::size_t n = 0; n < kFirst + kCounted + kAfter; ++n) {
    Sample s;
    s.tick = static_cast<std::uint32_t>(n);
    const bool counts = n >= kFirst && n < kFirst + kCounted;
    const double k = static_cast<double>(std::min(n, kFirst + kCounted));
    for (std::size_t a = 0; a < 2; ++a) {
      AxisSample& at = s.axis[a];
      const double d = a == 0 ? 1 : 3;
      at.r = static_cast<std::int32_t>(a == 0 ? 200 * k : 100 * k);
      at.x_m = (at.r - static_cast<std::int32_t>(30 + 10 * a)) * (1 << 14);
      at.x_true_m = at.r * kCount + 1e-4 * (a == 0 ? std::sin(k) : 0.7 * std::cos(k));
      at.v_true_m_s = counts ? sign * (n == 20 ? d : -0.1 * d) : 99;
      at.i_q_true_A = counts ? sign * (n == 30 ? -2 * d : 0.2 * d) : 99;
      at.i_d_true_A = counts ? 0.3 * d : 99;
      at.force_N = counts ? sign * (n == 25 ? 50 * d : -5 * d) : 999;
      at.dc_link_V = counts ? 150 + 10 * d + static_cast<double>(n) : n == 0 ? 1 : 999;
    }
    if (!counts && n > 0) s.axis[0].x_true_m += n < kFirst ? 1 : 0;
    if (n >= kFirst + kCounted && n < kFirst + kCounted + 11) s.axis[1].x_true_m += 2e-3;
    result.samples.push_back(s);
  }
  result.from_last_m = 4e-3;
  return result;
}

void add_statistics(std::map<std::string, double>& all, const std::string& id,
                    const std::vector<double>& t) {
  double mean = 0, variance = 0, squares = 0, most = 0;
  const auto n = static_cast<double>(t.size());
  for (const double x : t) mean += x / n;
  for (const double x : t) {
    variance += (x - mean) * (x - mean) / n;
    squares += x * x / n;
    most = std::max(most, std::fabs(x));
  }
  all[id + ".mean_mm"] = mean;
  all[id + ".std_mm"] = std::sqrt(variance);
  all[id + ".variance_mm2"] = variance;
  all[id + ".rms_mm"] = std::sqrt(squares);
  all[id + ".max_mm"] = most;
  all[id + ".samples"] = n;
}

// The same figures, from the samples that count alone.
std::map<std::string, double> recomputed(const Options& options, const Result& result) {
  std::map<std::string, double> all;
  std::vector<double> model, command, contour, error[2];
  double left = 0, right = 0;
  for (std::size_t n = kFirst; n < kFirst + kCounted; ++n) {
    const Sample s = result.samples[n];
    double x[2], m[2], r[2];
    for (std::size_t a = 0; a < 2; ++a) {
      x[a] = 1e3 * s.axis[a].x_true_m;
      m[a] = 1e3 * kCount * s.axis[a].x_m / 16384;
      r[a] = 1e3 * kCount * s.axis[a].r;
      error[a].push_back(m[a] - x[a]);
      const std::string axis = a == 0 ? "x." : "y.";
      const auto most = [&](const std::string& id, double value) {
        all[axis + id] = std::max(all[axis + id], std::fabs(value));
        all[id] = std::max(all[id], std::fabs(value));
      };
      most("peak_current_A", s.axis[a].i_q_true_A);
      most("max_speed_m_s", s.axis[a].v_true_m_s);
      const double i2 = s.axis[a].i_q_true_A * s.axis[a].i_q_true_A +
                        s.axis[a].i_d_true_A * s.axis[a].i_d_true_A;
      all[axis + "rms_current_A"] += i2 / 2 / kCounted;
      all[axis + "rms_force_N"] += s.axis[a].force_N * s.axis[a].force_N / kCounted;
      all[axis + "most_dc_link_V"] = std::max(all[axis + "most_dc_link_V"], s.axis[a].dc_link_V);
      double& least = all.insert({axis + "least_dc_link_V", 1e9}).first->second;
      least = std::min(least, s.axis[a].dc_link_V);
    }
    model.push_back(std::hypot(m[0] - x[0], m[1] - x[1]));
    command.push_back(std::hypot(r[0] - x[0], r[1] - x[1]));
    // The path is the straight line from the first command to the last.
    const auto at = [&](std::size_t k, std::size_t a) {
      return 1e3 * kCount * result.samples[k].axis[a].r;
    };
    const double ends[2][2] = {{at(kFirst, 0), at(kFirst, 1)},
                               {at(kFirst + kCounted - 1, 0), at(kFirst + kCounted - 1, 1)}};
    const double dx = ends[1][0] - ends[0][0], dy = ends[1][1] - ends[0][1];
    const double px = x[0] - ends[0][0], py = x[1] - ends[0][1];
    const double along = (px * dx + py * dy) / (dx * dx + dy * dy);
    double off = (dx * py - dy * px) / std::hypot(dx, dy);
    if (along < 0) off = std::copysign(std::hypot(px, py), off);
    if (along > 1) off = std::copysign(std::hypot(px - dx, py - dy), off);
    contour.push_back(std::fabs(off));
    left = std::max(left, off);
    right = std::max(right, -off);
  }
  for (const char* axis : {"x.", "y."}) {
    const std::string of = axis;
    all[of + "copper_loss_W"] = 3 * (of == "x." ? 21 : 33) * all[of + "rms_current_A"];
    all[of + "rms_current_A"] = std::sqrt(all[of + "rms_current_A"]);
    all[of + "rms_force_N"] = std::sqrt(all[of + "rms_force_N"]);
  }
  add_statistics(all, "tracking.model", model);
  add_statistics(all, "tracking.command", command);
  add_statistics(all, "contour", contour);
  add_statistics(all, "x.error_to_model", error[0]);
  add_statistics(all, "y.error_to_model", error[1]);
  all["contour.left_mm"] = left;
  all["contour.right_mm"] = right;
  all["at_end.from_last_point_mm"] = 4;
  all["at_end.settling_s"] = 11 * options.chip.sample_s();
  all["at_end.stopping_mm"] = 0;
  return all;
}

}  // namespace

TEST_CASE("each figure is that of its own axis, word and samples") {
  const Options options = unlike();
  for (const double sign : {1.0, -1.0}) {
    CAPTURE(sign);
    Result result = by_hand(sign);
    const auto expected = recomputed(options, result);
    std::size_t seen = 0;
    for (const lab::Figure& f : figures(options, result)) {
      INFO("figure " << f.id);
      REQUIRE(expected.count(f.id) == 1);
      CHECK(f.value == Approx(expected.at(f.id)).margin(1e-9));
      const std::string end = f.id.substr(f.id.rfind('_') + 1);
      if (end == "mm" || end == "A" || end == "s" || end == "W" || end == "V" || end == "N") {
        CHECK(f.unit.substr(f.unit.rfind('/') + 1) == end);
      }
      if (f.id[1] == '.' && f.id.find("error_to") == std::string::npos) {
        CHECK(f.column == (f.id[0] == 'x' ? "X" : "Y"));
      }
      ++seen;
    }
    CHECK(seen == expected.size());
    CHECK(result.largest_mm == Approx(expected.at("contour.max_mm")));
  }
}

TEST_CASE("half periods and periods are those of their own axis") {
  Options options;
  options.path.kind = PathKind::kSquare;
  options.path.square_low_m = 0;
  options.path.square_high_m = 0.01;
  options.path.square_half_samples = 4;
  Result result;
  result.end = EndReason::kFault;  // nothing of the paper's beside it
  result.points = 16;
  result.first_tick = 1;
  const double past[2][4] = {{1, 2, 3, 4}, {8, 7, 6, 5}};  // [%], by half period
  for (std::uint32_t n = 0; n < 16; ++n) {
    Sample s;
    s.tick = 1 + n;
    for (std::size_t a = 0; a < 2; ++a) {
      const bool up = n / 4 % 2 == 0;
      const double over = 1e-4 * past[a][n / 4] * (n % 4 == 1);
      s.axis[a].x_m = (up ? 2000 : 0) << 14;
      s.axis[a].x_true_m = up ? 0.01 + over : -over;
    }
    result.samples.push_back(s);
  }
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string axis = a == 0 ? "x" : "y";
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string id = axis + ".half_periods." + std::to_string(k);
      CHECK(test::figure(options, result, id + ".overshoot_percent") == Approx(past[a][k]));
      CHECK(test::figure(options, result, id + ".rms_mm") == Approx(0.1 * past[a][k] / 2));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string id = axis + ".periods." + std::to_string(k);
      const double worse = std::max(past[a][2 * k], past[a][2 * k + 1]);
      CHECK(test::figure(options, result, id + ".overshoot_percent") == Approx(worse));
      CHECK(test::figure(options, result, id + ".rms_mm") == Approx(0.1 * worse / 2));
    }
  }
  for (const lab::Figure& f : figures(options, result)) {
    INFO(f.id);
    CHECK((f.tile == "Overshoot X") == (f.id == "x.periods.1.overshoot_percent"));  // of the last
    CHECK((f.tile == "Overshoot Y") == (f.id == "y.periods.1.overshoot_percent"));
    CHECK(f.tile != "Top speed");
    if (f.id.find(".periods.") != std::string::npos) {
      CHECK(f.column == std::string(1, static_cast<char>(f.id[10] + 1)));  // from 1
      CHECK(f.row == (f.id.find("rms") == std::string::npos ? "overshoot " : "rms error ") +
                         std::string(f.id[0] == 'x' ? "X" : "Y") + ", period");
    }
  }
}

TEST_CASE("the way to rest is shown of a trip on the path alone, in which the gates went off") {
  for (const bool trip : {true, false}) {
    for (const bool on_path : {true, false}) {
      for (const bool off : {true, false}) {
        Result result = by_hand(1);
        result.end = trip ? EndReason::kFault : EndReason::kDone;
        result.points = on_path ? 1 : 0;
        if (off) result.fault_report.off = 1000;
        result.fault_report.stopping = 12.5;
        const auto list = figures(unlike(), result);
        const lab::Figure* const f = lab::find_figure(list, "at_end.stopping_mm");
        REQUIRE(f != nullptr);
        CAPTURE(trip, on_path, off);
        CHECK(f->value == 12.5);
        CHECK(f->shown == (trip && on_path && off));
      }
    }
  }
}

TEST_CASE("figures without samples are not shown") {
  Result result;
  result.end = EndReason::kStopped;
  for (const lab::Figure& f : figures(unlike(), result)) {
    INFO(f.id);
    CHECK_FALSE(f.shown);
  }
}

TEST_CASE("a trip names its cause, and its axis where it has one") {
  const struct {
    FaultCode code;
    const char* name;
    bool of_axis;
  } all[] = {{FaultCode::kTrip, "external trip", false},
             {FaultCode::kOverCurrent, "over-current", true},
             {FaultCode::kWatchdog, "watchdog", false},
             {FaultCode::kEncoder, "encoder fault", true},
             {FaultCode::kStroke, "stroke exceeded", true}};
  for (const auto& one : all) {
    for (const int axis : {0, 1}) {
      CAPTURE(one.name, axis);
      const std::string text = one.name + std::string(one.of_axis ? " on axis " : "") +
                               (one.of_axis ? (axis == 0 ? "X" : "Y") : "");
      CHECK(cause_text({one.code, axis, 17}) == text);
      Options options;
      Result result;
      result.end = EndReason::kFault;
      result.fault = {one.code, axis, 17};
      CHECK(machine().verdict(options, result) ==
            "tripped: " + text + " at position tick 17 (0.0085 s)");
    }
  }
}

TEST_CASE("a run that did not follow tells which axis had no more to give") {
  Options options;
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(a);
    Result result;
    result.end = EndReason::kMissed;
    result.missed = "late";
    result.load[a].samples = 100;
    result.load[a].at_current = 2;
    const std::string limits = std::string(a == 0 ? "; X" : "; Y") +
                               ": i_q* at its limit 2 % of the samples";
    CHECK(machine().verdict(options, result) == "missed: late" + limits);
    result.end = EndReason::kDiverged;
    CHECK(machine().verdict(options, result) ==
          "diverged: error to the model above run.diverged_m = 0.05" + limits);
    result.beside_m = 0.125;
    CHECK(machine().verdict(options, result) ==
          "diverged: 0.1250 m beside the path asked, above run.diverged_m = 0.05" + limits);
    result.load[a].at_current = 1;  // not worth telling
    result.end = EndReason::kMissed;
    CHECK(machine().verdict(options, result) == "missed: late");
  }
}
