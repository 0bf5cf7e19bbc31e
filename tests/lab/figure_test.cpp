// SPDX-License-Identifier: Apache-2.0
//
// The list of figures: what is expected of them, how they are printed, where they stand in JSON.
#include "lab/figure.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace trammel;
using namespace trammel::lab;

namespace {

Figure expecting(double value, double expected, double tolerance) {
  Figure f = figure("tracking.mean_mm", "error", "mean", value, "mm");
  f.expected = expected;
  f.tolerance = tolerance;
  return f;
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
