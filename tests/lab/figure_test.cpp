// SPDX-License-Identifier: Apache-2.0
//
// Figures with what is expected of them, and responses over frequency.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/figure.hpp"
#include "lab/response.hpp"

using namespace trammel;
using namespace trammel::lab;

namespace {

Figure expecting(double value, double expected, double tolerance) {
  Figure f = figure("tracking.mean_mm", "error", "mean", value, "mm");
  f.expected = expected;
  f.tolerance = tolerance;
  return f;
}

constexpr double kPi = 3.14159265358979323846;

// T of an open loop over 1 to 1000 Hz, 40 points a decade.
template <class Loop>
Response closed_of(Loop open) {
  Response closed;
  for (int k = 0; k <= 120; ++k) {
    const double hz = std::pow(10, k / 40.0);
    const std::complex<double> gain = open(std::complex<double>(0, 2 * kPi * hz));
    closed.push_back({hz, gain / (1.0 + gain)});
  }
  return closed;
}

}  // namespace

TEST_CASE("a figure fails beyond its tolerance, and never without an expected value") {
  Figure f = expecting(2.15, 2.11, 0.03 * 2.11);
  f.printed = 2.05;
  CHECK(f.good());
  f.value = 2.2;
  CHECK_FALSE(f.good());
  f.value = 2.02;
  CHECK_FALSE(f.good());
  f.expected.reset();
  CHECK(f.good());
}

TEST_CASE("a figure out of tolerance gives one line with its name, unit and tolerance") {
  const Figure good = expecting(2.15, 2.11, 0.05);
  const Figure bad = expecting(2.2, 2.11, 0.05);
  CHECK(outside({good, bad, figure("a", "a", "", 1, "")}) ==
        std::vector<std::string>{"error, mean 2.200 mm is outside 2.110 +- 0.050"});
  Figure hidden = bad;  // in metrics.json alone
  hidden.shown = false;
  CHECK(outside({hidden}) == outside({bad}));
  CHECK(any_expected({figure("a", "a", "", 1, ""), good}));
  Figure printed = figure("a", "a", "", 1, "");
  printed.printed = 1;
  CHECK_FALSE(any_expected({printed}));
}

TEST_CASE("a figure at its tolerance is good on both sides") {
  CHECK(expecting(2.5, 2, 0.5).good());
  CHECK(expecting(1.5, 2, 0.5).good());
}

TEST_CASE("a column that is a number follows the row's name without a comma") {
  CHECK(figure("a", "period", "12", 1, "").name() == "period 12");
  CHECK(figure("a", "period", "1a", 1, "").name() == "period, 1a");
  CHECK(figure("a", "period", "", 1, "").name() == "period");
}

TEST_CASE("a count is rounded, wherever it stands") {
  nlohmann::ordered_json json;
  put_figures(json, {count("a", "interrupts", "", 2.6)});
  CHECK(json["a"] == 3);
  CHECK(json["figures"][0]["value"] == 3);
  CHECK(figures_text({count("a", "interrupts", "", 2.6)}) == "  interrupts                3\n");
}

TEST_CASE("a table of one unit has it in its corner, and a blank line after it") {
  std::vector<Figure> list;
  for (const char* row : {"one", "two"}) {
    for (const char* column : {"a", "b", "c"}) list.push_back(figure("x", row, column, 1, "mm"));
  }
  list.push_back(figure("y", "peak", "", 1.5, "A", 2));
  CHECK(figures_text(list) == "\n  (mm)" + std::string(21, ' ') + "      a      b      c\n" +
                                  "  one" + std::string(22, ' ') + "  1.000  1.000  1.000\n" +
                                  "  two" + std::string(22, ' ') + "  1.000  1.000  1.000\n" +
                                  "\n  peak" + std::string(21, ' ') + " 1.50 A\n");
}

TEST_CASE("two columns make no table") {
  std::vector<Figure> list;
  for (const char* row : {"one", "two"}) {
    for (const char* column : {"a", "b"}) list.push_back(figure("x", row, column, 1, "mm", 1));
  }
  CHECK(figures_text(list) == "  one" + std::string(22, ' ') + " a 1.0 mm, b 1.0 mm\n" +
                                  "  two" + std::string(22, ' ') + " a 1.0 mm, b 1.0 mm\n");
}

TEST_CASE("each source is named once below the comparison") {
  std::vector<Figure> list;
  for (const char* source : {"a paper", "its manual", "a paper"}) {
    list.push_back(expecting(2.1, 2.11, 0.05));
    list.back().shown = false;
    list.back().source = source;
  }
  const std::string text = figures_text(list);
  CHECK(text.substr(text.rfind("\n  ")) == "\n  a paper; its manual\n");
}

TEST_CASE("rows of other units make no table, though their columns have the same names") {
  std::vector<Figure> list;
  for (const char* column : {"a", "b", "c"}) list.push_back(figure("x", "one", column, 1, "mm"));
  for (const char* column : {"a", "b", "c"}) list.push_back(figure("y", "two", column, 2, "V"));
  CHECK_THAT(figures_text(list), Catch::Contains("b 2.000 V"));
}

TEST_CASE("a figure is at the place its id names, and in the list of all") {
  nlohmann::ordered_json json;
  Figure mean = expecting(2.2, 2.11, 0.05);
  mean.printed = 2.05;
  mean.source = "a paper";
  mean.tile = "Mean error";
  Figure hidden = figure("x.periods.1.rms_mm", "rms error", "2", 0.25, "mm", 2);
  hidden.shown = false;
  put_figures(json, {mean, count("interrupts", "interrupts", "", 3),
                     figure("x.periods.0.rms_mm", "rms error", "1", 0.5, "mm", 2), hidden});
  CHECK(json["tracking"]["mean_mm"] == 2.2);
  CHECK(json["interrupts"] == 3);
  CHECK(json["interrupts"].is_number_integer());
  REQUIRE(json["x"]["periods"].is_array());
  CHECK(json["x"]["periods"][1]["rms_mm"] == 0.25);
  REQUIRE(json["figures"].size() == 4);
  CHECK(json["figures"][0] ==
        nlohmann::ordered_json{{"id", "tracking.mean_mm"}, {"name", "error, mean"},
                               {"value", 2.2},             {"unit", "mm"},
                               {"column", "mean"},         {"digits", 3},
                               {"printed", 2.05},          {"expected", 2.11},
                               {"tolerance", 0.05},        {"within", false},
                               {"source", "a paper"},      {"tile", "Mean error"}});
  CHECK(json["figures"][1] ==
        nlohmann::ordered_json{
            {"id", "interrupts"}, {"name", "interrupts"}, {"value", 3}, {"unit", ""}});
  CHECK(json["figures"][3]["shown"] == false);
}

TEST_CASE("a figure may have what is printed or what is expected without the other") {
  for (const bool printed : {false, true}) {
    Figure one = figure("mean", "mean", "", 2, "mm");
    (printed ? one.printed : one.expected) = 2.5;
    one.tolerance = 1;
    nlohmann::ordered_json json;
    put_figures(json, {one});
    const auto& put = json["figures"][0];
    INFO(put.dump());
    CHECK(put.contains("printed") == printed);
    for (const char* const name : {"expected", "tolerance", "within"}) {
      CHECK(put.contains(name) == !printed);
    }
    CHECK(put[printed ? "printed" : "expected"] == 2.5);
    CHECK(any_expected({one}) == !printed);
  }
}

TEST_CASE("rows of equal columns make a table whose wide figures do not run together") {
  std::vector<Figure> figures;
  for (const char* row : {"to the model", "to the command"}) {
    figures.push_back(figure("a", row, "mean", 123456.789, "mm"));
    figures.push_back(figure("b", row, "std", 123456.789, "mm"));
    figures.push_back(figure("c", row, "var", 1234567890.123, "mm2"));
  }
  figures[3].value = 1;
  CHECK(figures_text(figures) ==
        "\n"
        "                              mean (mm)    std (mm)       var (mm2)\n"
        "  to the model               123456.789  123456.789  1234567890.123\n"
        "  to the command                  1.000  123456.789  1234567890.123\n");
}

TEST_CASE("other rows are single lines, and hidden figures have none") {
  Figure hidden = figure("c", "hidden", "", 1, "mm");
  hidden.shown = false;
  CHECK(figures_text({figure("a", "peak current", "", 1.25, "A", 2),
                      figure("b", "peak current", "X", 1, "A", 2), hidden,
                      count("d", "interrupts", "", 3)}) ==
        "  peak current              1.25 A, X 1.00 A\n"
        "  interrupts                3\n");
}

TEST_CASE("our value is beside the printed and the expected one") {
  Figure f = expecting(2.2, 2.11, 0.05);
  f.printed = 2.05;
  f.shown = false;
  f.source = "a paper";
  Figure other = figure("b", "peak", "", 1.5, "A");
  other.expected = 1.4;
  other.tolerance = 0.2;
  other.shown = false;
  other.source = "a paper";
  CHECK(figures_text({f, other}) ==
        "\n"
        "                                              ours  printed  expected\n"
        "  error, mean (mm)                            2.20     2.05      2.11  outside its "
        "tolerance\n"
        "  peak (A)                                    1.50        -      1.40\n"
        "  a paper\n");
}

TEST_CASE("a tone through a first-order filter gives the filter's gain at that frequency") {
  constexpr double kPart = 0.2;  // y += kPart (u - y)
  for (const std::size_t period : {4u, 25u, 100u}) {
    ToneSum in(period), out(period);
    double y = 0;
    for (std::size_t k = 0; k < 20 * period + 200; ++k) {
      const double u = std::sin(2 * kPi * static_cast<double>(k) / static_cast<double>(period));
      y += kPart * (u - y);
      if (k < 200 + 10 * period) continue;  // 0.8^240 is below 1e-23
      in.add(u);
      out.add(y);
    }
    const std::complex<double> z = std::polar(1.0, 2 * kPi / static_cast<double>(period));
    const std::complex<double> expected = kPart * z / (z - (1 - kPart));
    CHECK(std::abs(out.sum() / in.sum() - expected) < 1e-9);
  }
}

TEST_CASE("a tone's sum turns back by a part of its period for each value before") {
  for (const std::size_t period : {4u, 25u}) {
    for (std::size_t at = 0; at < 2 * period; ++at) {  // of an impulse there
      ToneSum tone(period);
      for (std::size_t k = 0; k < 2 * period; ++k) tone.add(k == at ? 3 : 0);
      const double turn = 2 * kPi * static_cast<double>(at) / static_cast<double>(period);
      CAPTURE(period, at);
      CHECK(std::abs(tone.sum() - std::complex<double>(3 * std::cos(turn), -3 * std::sin(turn))) <
            1e-12);
    }
  }
}

TEST_CASE("an integrating loop has its bandwidth at its crossover and 90 degrees of margin") {
  const Margins m = margins(closed_of([](auto s) { return 2 * kPi * 50 / s; }));
  REQUIRE(m.bandwidth_hz);
  CHECK(*m.bandwidth_hz == Approx(50).epsilon(0.002));  // lines between the points
  CHECK(*m.crossover_hz == Approx(50).epsilon(1e-3));
  CHECK(*m.phase_margin_deg == Approx(90).margin(1e-6));
  CHECK_FALSE(m.gain_margin_db);
  CHECK(m.peak_hz == 1);
}

TEST_CASE("a bandwidth is 3 dB below the first point, on a line over the logarithm of frequency") {
  const Margins m = margins({{10, 0.5}, {1000, 0.25}});
  REQUIRE(m.bandwidth_hz);
  CHECK(*m.bandwidth_hz == Approx(100).epsilon(1e-6));  // half of 6.02 dB
  CHECK(m.peak_db == Approx(20 * std::log10(0.5)));
}

TEST_CASE("of equal peaks the first is told, and a point on a border is no crossing yet") {
  const Margins m = margins({{1, 0.5}, {2, 2}, {4, 2}, {8, 0.5}});
  CHECK(m.peak_hz == 2);
  CHECK(m.peak_db == Approx(20 * std::log10(2.0)));
  // An open loop of exactly 1 at 10 Hz, from where it falls.
  const auto closed = [](double open) { return std::complex<double>(open / (1 + open)); };
  const Margins at = margins({{5, closed(2)}, {10, closed(1)}, {20, closed(0.5)}});
  REQUIRE(at.crossover_hz);
  CHECK(*at.crossover_hz == Approx(10));
}

TEST_CASE("three equal lags have a gain margin of 8 over their gain, where they turn by 180") {
  const double w = 2 * kPi * 20;
  const Margins m = margins(closed_of([w](auto s) {
    return 4.0 / std::pow(1.0 + s / w, 3);
  }));
  REQUIRE(m.gain_margin_db);
  CHECK(*m.gain_margin_db == Approx(20 * std::log10(2.0)).margin(0.01));
  CHECK(*m.reversal_hz == Approx(20 * std::sqrt(3.0)).epsilon(0.001));
  const double crossover = std::sqrt(std::pow(4, 2.0 / 3) - 1);  // of w
  CHECK(*m.crossover_hz == Approx(20 * crossover).epsilon(0.001));
  CHECK(*m.phase_margin_deg == Approx(180 - 3 * std::atan(crossover) * 180 / kPi).margin(0.1));
  CHECK(m.peak_db > 3);
  CHECK(m.peak_hz == Approx(20 * crossover).epsilon(0.2));
}

TEST_CASE("the first phase lies between -270 and 90 degrees, the others beside the one before") {
  const auto at = [](double degree) { return std::polar(2.0, degree * kPi / 180); };
  for (const double first : {80.0, 10.0, -100.0, -170.0, -190.0, -260.0}) {
    const std::vector<double> degrees = phases({{1, at(first)}, {2, at(first - 100)}});
    REQUIRE(degrees.size() == 2);
    CHECK(degrees[0] == Approx(first));
    CHECK(degrees[1] == Approx(first - 100));
  }
}

TEST_CASE("two integrators begin at -180 degrees, not at 180") {
  const Margins m = margins(closed_of([](auto s) {
    const double w = 2 * kPi * 30;
    return w * w / (s * s) * (1.0 + 2.0 * s / w);
  }));
  REQUIRE(m.phase_margin_deg);
  CHECK(*m.phase_margin_deg == Approx(std::atan(2 * *m.crossover_hz / 30) * 180 / kPi).margin(0.1));
}

TEST_CASE("what the measured frequencies do not enclose is not given") {
  CHECK_FALSE(margins({}).bandwidth_hz);
  const Response flat{{1, 0.99}, {10, {0.98, -0.05}}};
  const Margins m = margins(flat);
  CHECK_FALSE(m.bandwidth_hz);
  CHECK_FALSE(m.crossover_hz);
  CHECK_FALSE(m.gain_margin_db);
}
