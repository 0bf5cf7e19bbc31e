// SPDX-License-Identifier: Apache-2.0
//
// What `status` and `pins` of `trammel lm628` answer, as text and as JSON, by the twin: bits by
// their numbers in the data sheet (SNVS781C), the pins of either part, the motor in its sense.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "machines/an693/verbs/shell.hpp"

using namespace trammel;
using namespace trammel::an693;
using Catch::Matchers::Contains;

namespace {

struct Typed {
  const std::atomic<bool> stop{false};
  Shell shell;
  explicit Typed(lm628::Variant variant) : shell(of(variant), stop) {}

  Answer last(const std::string& script) {
    Answer answer;
    for (const Line& line : parse_script(script, "a")) answer = shell.execute(line);
    return answer;
  }
  static Options of(lm628::Variant variant) {
    Options options;
    options.run.engine = cosim::Engine::kTwin;
    options.part.variant = variant;
    return options;
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> sorted_keys(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

TEST_CASE("status shows each bit of both registers, and their words") {
  struct Case {
    const char* script;
    unsigned status, signals;
  };
  // Bit 7 motor off, 2 complete, 1 command error; 8 output of 8 bits, 13 UDF, 12 forward.
  for (const Case& one : {Case{"status", 0x84, 0x0184}, Case{"RSTI 0\nstatus", 0x80, 0x0180},
                          Case{"RSTI 0\nPORT12\nstatus", 0x80, 0x0080}}) {
    Typed typed(lm628::Variant::kLm628);
    const Answer answer = typed.last(one.script);
    CAPTURE(one.script, answer.text);
    CHECK(answer.json["status"] == hex(one.status, 8));
    CHECK(answer.json["signals"] == hex(one.signals, 16));
    const std::vector<std::string> lines = lines_of(answer.text);
    REQUIRE(lines.size() == 9);
    std::string head = "status " + hex(one.status, 8);
    head.resize(32, ' ');
    CHECK(lines[0] == head + "signals " + hex(one.signals, 16));
    for (unsigned row = 0; row < 8; ++row) {
      const std::string& line = lines[8 - row];
      CAPTURE(row, line);
      CHECK(std::stoul(line) == row);
      CHECK(line[26] == "01"[one.status >> row & 1]);
      CHECK(std::stoul(line.substr(29)) == row + 8);
      CHECK(line[56] == "01"[one.signals >> (row + 8) & 1]);
      CHECK(std::stoul(line.substr(57)) % 8 == row % 8);
      CHECK(line.back() == "01"[one.signals >> row & 1]);
    }
  }
}

TEST_CASE("pins are those of the part, the motor beside them turns in the sense of its counts") {
  for (const auto variant : {lm628::Variant::kLm628, lm628::Variant::kLm629}) {
    const bool pulses = variant == lm628::Variant::kLm629;
    using Names = std::vector<std::string>;
    {
      Typed typed(variant);
      const Answer rest = typed.last("pins");
      CHECK(sorted_keys(rest.json["pins"]) ==
            (pulses ? Names{"A", "B", "HI", "IN", "MAG", "SIGN"}
                    : Names{"A", "B", "DAC", "HI", "IN"}));
      CHECK(sorted_keys(rest.json["motor"]) ==
            Names{"current_A", "shaft_counts", "speed_rev_s", "volt_V"});
      CHECK(rest.text == std::string("HI 0  A 0  B 0  IN 0  ") +
                             (pulses ? "SIGN 0  MAG 0" : "DAC 800h") +
                             "\nmotor 0.000 V  0.0000 A  0.0000 rev/s  0.00 counts\n");
    }
    for (const int sense : {1, -1}) {  // the load turns the shaft back, the part holds against it
      Typed typed(variant);
      typed.last("PORT12\nLFIL 000Ah 400 4000\nUDF\nLTRJ 0\nSTT\ntorque " +
                 std::to_string(0.3 * sense) + "\nwait 0.4 s");
      const double counts = typed.last("RDRP").json["value"].get<double>();
      const auto json = typed.last("pins").json;
      CAPTURE(pulses, sense, json.dump());
      REQUIRE(sense * counts < -5);
      CHECK(json["motor"]["shaft_counts"].get<double>() == Approx(counts).margin(1.5));
      CHECK(sense * json["motor"]["current_A"].get<double>() > 1);
      if (pulses) {
        CHECK(json["pins"]["SIGN"] == (sense > 0 ? 0 : 1));
      } else {
        CHECK(sense * (json["pins"]["DAC"].get<int>() - 0x800) > 50);
        CHECK(sense * json["motor"]["volt_V"].get<double>() > 1);
      }
    }
  }
}
