// SPDX-License-Identifier: Apache-2.0
//
// Scripts of the LM628, line by line, and what status and pins answer, as text and as JSON: bits by
// their numbers in the data sheet (SNVS781C), the pins of either part, the motor in its sense.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "host/files.hpp"
#include "lab/scenarios.hpp"
#include "machines/an693/verbs/script.hpp"
#include "machines/an693/verbs/shell.hpp"

using namespace trammel;
using namespace trammel::an693;
using Catch::Matchers::Contains;
using sw::Lm628Command;

namespace {

Line parsed(const std::string& text) {
  const auto line = parse_line(text, "a:1");
  REQUIRE(line);
  return *line;
}

using Words = std::vector<std::uint32_t>;

Words words(const std::string& text) { return parsed(text).words; }

std::string refusal(const std::string& text) {
  try {
    parse_script(text, "move.lm628");
  } catch (const host::ConfigError& error) {
    const std::string line = error.what();
    CHECK_THAT(line, !Catch::Contains("\n"));
    return line;
  }
  return "";
}

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

TEST_CASE("commands are the mnemonics of the data sheet in any case, and have its codes") {
  CHECK(parsed("STT").command->opcode == Lm628Command::kStt);
  CHECK(parsed("  stt  # go").command->opcode == Lm628Command::kStt);
  CHECK(parsed("rdRP;").command->reply.bits == 32);
  CHECK_FALSE(parse_line(" # nothing", "a:1"));
  CHECK_FALSE(parse_line("", "a:1"));
  std::set<int> codes;
  for (const Command& command : commands()) {
    if (command.action == Action::kCommand) codes.insert(static_cast<int>(command.opcode));
  }
  CHECK(codes == std::set<int>{0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A,
                               0x0B, 0x0C, 0x0D, 0x1A, 0x1B, 0x1C, 0x1D, 0x1E, 0x1F, 0x20, 0x21});
}

TEST_CASE("numbers are decimal or hexadecimal, and of a signed width a pattern too") {
  CHECK(words("SBPA 80000") == Words{1, 80000 - 65536});
  CHECK(words("SBPA -10") == Words{0xFFFF, 0xFFF6});
  CHECK(words("SBPA -0xA") == Words{0xFFFF, 0xFFF6});
  CHECK(words("SBPA FFFFFFF6h") == Words{0xFFFF, 0xFFF6});
  CHECK(words("SBPA 0x3fffffff") == Words{0x3FFF, 0xFFFF});
  CHECK(words("SBPA C0000000h") == Words{0xC000, 0});
  CHECK(words("SBPR 1073741823") == Words{0x3FFF, 0xFFFF});
  CHECK(words("SBPR -1073741824") == Words{0xC000, 0});
  CHECK_THAT(refusal("SBPR 1073741824"), Contains("SBPR: distance: 1073741824 is out of range"));
  CHECK_THAT(refusal("SBPR -1073741825"), Contains("is out of range"));
  CHECK_THAT(refusal("SBPA -1073741825"), Contains("is out of range"));
  CHECK_THAT(refusal("SBPA 80000001h"), Contains("move.lm628:1: SBPA: position: 80000001h is out"));
  CHECK_THAT(refusal("SBPA 40000000h"), Contains("-1073741824..1073741823 (C0000000h..3FFFFFFFh)"));
  for (const char* word : {"12a", "h", "0x", "-", "1.5", "--1", "99999999999999999999x"}) {
    CHECK_THAT(refusal(std::string("SBPA ") + word), Contains("is not a number"));
  }
  CHECK_THAT(refusal("SBPA 99999999999999999999"), Contains("is out of range"));
  CHECK_THAT(refusal("SBPA FFFFFFFFFFFFFFFFh"), Contains("is out of range"));
}

TEST_CASE("LFIL takes what its control word asks for, in the part's order and width") {
  CHECK(words("LFIL 030Fh 50 5 1000 32767") == Words{0x30F, 50, 5, 1000, 32767});
  CHECK(words("LFIL 0009h 50 7") == Words{9, 50, 7});
  CHECK(words("LFIL 0") == Words{0});
  CHECK(refusal("\nLFIL 000Ah 50") ==
        "move.lm628:2: LFIL 000Ah asks for kp 0..32767 (7FFFh), kd 0..32767 (7FFFh): "
        "2 values, not 1");
  CHECK(refusal("LFIL 0008h 32768") ==
        "move.lm628:1: LFIL: kp: 32768 is out of range 0..32767 (7FFFh)");
  CHECK_THAT(refusal("LFIL 0004h -1"), Contains("LFIL: ki: -1 is out of range"));
  CHECK_THAT(refusal("LFIL 000Fh"), Contains(", il 0..32767 (7FFFh): 4 values, not 0"));
  CHECK_THAT(refusal("LFIL 0001h"), Contains("asks for il 0..32767 (7FFFh): 1 value, not 0"));
  CHECK_THAT(refusal("LFIL"), Contains("control 0..65535 (FFFFh) is missing"));
  CHECK_THAT(refusal("LFIL 10000h"), Contains("control: 10000h is out of range"));
}

TEST_CASE("LTRJ takes what its control word asks for; relative values may be negative") {
  CHECK(words("LTRJ 002Ah 2 346Eh 8000") == Words{0x2A, 0, 2, 0, 0x346E, 0, 8000});
  CHECK(words("LTRJ 003Fh -2 -1 -8000") ==
        Words{0x3F, 0xFFFF, 0xFFFE, 0xFFFF, 0xFFFF, 0xFFFF, 0xE0C0});
  CHECK(words("LTRJ 0002h FFFFE0C0h") == Words{2, 0xFFFF, 0xE0C0});
  CHECK(words("LTRJ 0100h") == Words{0x100});
  CHECK(words("LTRJ 1815h") == Words{0x1815});  // relative, but nothing loaded
  CHECK_THAT(refusal("LTRJ 002Ah 2 3"),
             Contains("LTRJ 002Ah asks for acceleration 0..1073741823 (") &&
                 Contains("3 values, not 2"));
  CHECK_THAT(refusal("LTRJ 0003h"), Contains("asks for distance -1073741824..1073741823 ("));
  CHECK_THAT(refusal("LTRJ 0100h 5"), Contains("asks for nothing: 0 values, not 1"));
  CHECK_THAT(refusal("LTRJ 0008h 40000000h"),
             Contains("velocity: 40000000h is out of range 0..1073741823 (3FFFFFFFh)"));
  CHECK_THAT(refusal("LTRJ 000Ch"),
             Contains("asks for velocity -1073741823..1073741823 (C0000001h"));
  CHECK_THAT(refusal("LTRJ 0030h"), Contains("asks for acceleration -1073741823..1073741823 ("));
  CHECK_THAT(refusal("LTRJ 0028h"),
             Contains("acceleration 0..1073741823 (3FFFFFFFh), velocity 0.."));
  CHECK_THAT(refusal("LTRJ 0028h -1 1"), Contains("acceleration: -1 is out of range"));
}

TEST_CASE("the other commands take one number or none") {
  CHECK(words("LPES 7FFFh") == Words{0x7FFF});
  CHECK(words("MSKI 0040h") == Words{0x40});
  CHECK(words("byte d 255") == Words{255});
  CHECK(parsed("byte d 255").choice == "d");
  CHECK(parsed("READ C").choice == "c");
  CHECK_THAT(refusal("LPEI 8000h"), Contains("LPEI: threshold: 8000h is out of range"));
  CHECK_THAT(refusal("RSTI"), Contains("RSTI: mask 0..65535 (FFFFh) is missing"));
  CHECK_THAT(refusal("STT 3"), Contains("STT asks for nothing: 0 values, not 1"));
  CHECK_THAT(refusal("byte d 256"), Contains("byte: 256 is out of range 0..255 (FFh)"));
  CHECK_THAT(refusal("byte 3"), Contains("expects c (PS low"));
  CHECK_THAT(refusal("read"), Contains("expects c (PS low"));
  CHECK_THAT(refusal("rdsatt"), Contains("rdsatt: unknown command; did you mean RDSTAT?"));
  CHECK_THAT(refusal("\x1b[2J"), Contains("\\u001b[2J: unknown command"));
  CHECK(refusal("STT\nquit\nfoo") ==
        "move.lm628:3: foo: unknown command; `help` names them all");
}

TEST_CASE("a wait takes a time, or an event with a time limit") {
  CHECK(parsed("wait 0.5 s").seconds == Approx(0.5));
  CHECK(parsed("wait 10ms").seconds == Approx(0.01));
  CHECK(parsed("wait 300 us").seconds == Approx(300e-6));
  CHECK(parsed("wait 100 samples").samples == 100);
  CHECK(parsed("wait 100 samples").choice.empty());
  CHECK(parsed("WAIT HI").choice == "hi");
  CHECK(parsed("wait hi").seconds == kLongestWait);
  CHECK(parsed("wait hi").samples == 0);
  CHECK(parsed("wait complete 2 s").choice == "complete");
  CHECK(parsed("wait Breakpoint").choice == "breakpoint");
  CHECK(parsed("wait index 20 ms").choice == "index");
  CHECK(parsed("wait error 20 ms").seconds == Approx(0.02));
  CHECK(parsed("wait complete 2 s").seconds == 2);
  for (const char* bad : {"wait", "wait 5", "wait s", "wait -1 s", "wait hi 4 days", "wait inf s",
                          "wait 1 s 2", "wait 1 5 ms", "wait hi 1 5 s", "wait done"}) {
    CHECK_THAT(refusal(bad), Contains("expects a time as 0.5 s"));
  }
  CHECK_THAT(refusal("wait 3601 s"), Contains("3601s is out of range 0..3600 s"));
  CHECK_THAT(refusal("wait 1e9 s"), Contains("is out of range"));
  CHECK(parsed("wait 3600 s").seconds == 3600);
  // 3600 s are 14,062,500 samples of 256 us.
  CHECK(parsed("wait 14062499 samples").samples == 14062499);
  CHECK_THAT(refusal("wait 14062501 samples"),
             Contains("14062501samples is out of range 0..3600 s"));
  CHECK_THAT(refusal("wait hi 14062501 samples"), Contains("is out of range 0..3600 s"));
  CHECK_THAT(refusal("wait hi 3601 s"), Contains("is out of range 0..3600 s"));
}

TEST_CASE("repeat executes the lines up to its end, blocks in blocks too") {
  const auto names = [](const std::string& text) {
    std::string all;
    for (const Line& line : parse_script(text, "a")) {
      all += fmt::format("{}{} ", line.command->name, line.where);
    }
    return all;
  };
  CHECK(names("RDIP\nrepeat 2\nRDRP\n\nRDDP ; two\nEND\nRDDV") ==
        "RDIPa:1 RDRPa:3 RDDPa:5 RDRPa:3 RDDPa:5 RDDVa:7 ");
  CHECK(names("REPEAT 1\nRDRP\nend") == "RDRPa:2 ");
  CHECK(names("repeat 2\nrepeat 0x2\nRDRP\nend\nRDDP\nrepeat 1\nend\nend") ==
        "RDRPa:3 RDRPa:3 RDDPa:5 RDRPa:3 RDRPa:3 RDDPa:5 ");
  CHECK(parse_script("repeat 10000\nrepeat 10000\nend\nend", "a").empty());
  CHECK(parse_script("repeat 5000\nSTT\nRDRP\nend", "a").size() == 10000);
  CHECK(depth_after(2, parsed("repeat 3")) == 3);
  CHECK(depth_after(2, parsed("STT")) == 2);
  CHECK(depth_after(2, parsed("end")) == 1);
}

TEST_CASE("a block that has no end, no beginning or too many lines is refused where it is") {
  CHECK(refusal("STT\nrepeat 2\nSTT") == "move.lm628:2: repeat: has no end");
  CHECK(refusal("repeat 2\nrepeat 2\nend") == "move.lm628:1: repeat: has no end");
  CHECK(refusal("repeat 2\nend\nend") == "move.lm628:3: end: there is no repeat before it");
  CHECK(refusal("repeat") == "move.lm628:1: repeat: count 1..10000 (2710h) is missing");
  CHECK(refusal("repeat 0") == "move.lm628:1: repeat: count: 0 is out of range 1..10000 (2710h)");
  CHECK_THAT(refusal("repeat 10001"), Contains("count: 10001 is out of range 1..10000"));
  CHECK_THAT(refusal("repeat -1"), Contains("is out of range"));
  CHECK_THAT(refusal("repeat two"), Contains("two is not a number 1..10000"));
  CHECK_THAT(refusal("repeat 2 3"), Contains("1 value, not 2"));
  CHECK_THAT(refusal("end 2"), Contains("end asks for nothing"));
  CHECK(refusal("RDRP\nrepeat 5000\nSTT\nRDRP\nend") ==
        "move.lm628:2: repeat 5000: the script would execute 10001 lines up to its end; at most "
        "10000 are allowed");
  CHECK_THAT(refusal("repeat 10000\nrepeat 10000\nSTT\nend\nend"),
             Contains("move.lm628:1: repeat 10000: the script would execute 100000000 lines"));
  CHECK_THAT(refusal("repeat 3\nSTTT\nend"), Contains("move.lm628:2: STTT: unknown command"));
}

TEST_CASE("a load is one number in N m") {
  CHECK(parsed("torque 0.01").torque == 0.01);
  CHECK(parsed("Torque -10").torque == -10);
  for (const char* bad : {"torque", "torque x", "torque 1 2", "torque 0.1Nm", "torque nan"}) {
    CHECK_THAT(refusal(bad), Contains("torque: expects one number in N m, -10 to 10, as 0.01"));
  }
  CHECK_THAT(refusal("torque 0.1Nm"), Catch::EndsWith("as 0.01, not 0.1Nm"));
  CHECK(refusal("torque 10.1") == "move.lm628:1: torque: 10.1 is out of range -10..10 N m");
  CHECK_THAT(refusal("torque -inf"), Contains("-inf is out of range"));
  CHECK_THAT(refusal("torque 1e999"), Contains("1e999 is out of range"));
}

// SNVS781C, tables of the commands.
TEST_CASE("help tells of each command its code in the data sheet") {
  const std::string all = "\n" + help_text(nullptr);
  for (const char* line :
       {"00h  RESET", "05h  PORT8", "06h  PORT12", "02h  DFH", "03h  SIP", "1Bh  LPEI", "1Ah  LPES",
        "20h  SBPA", "21h  SBPR", "1Ch  MSKI", "1Dh  RSTI", "1Eh  LFIL", "04h  UDF", "1Fh  LTRJ",
        "01h  STT", "     RDSTAT", "0Ch  RDSIGS", "09h  RDIP", "08h  RDDP", "0Ah  RDRP",
        "07h  RDDV", "0Bh  RDRV", "0Dh  RDSUM"}) {
    CHECK_THAT(all, Contains(std::string("\n") + line + " "));
  }
}

TEST_CASE("help tells of all words, or of one") {
  const auto help = [](const std::string& text) { return help_text(parsed(text).topic); };
  for (const Command& command : commands()) CHECK_THAT(help("help"), Contains(command.name));
  CHECK_THAT(help("help"), Contains("1Fh  LTRJ control [acceleration] [velocity] [position] "));
  CHECK_THAT(help("help"), Contains("     byte c|d byte  "));
  CHECK_THAT(help("help ltrj"), Contains("bit 5 acceleration"));
  CHECK_THAT(help("help PORT12"), Contains("the motor needs PORT12"));
  CHECK_THAT(help("help STT"), !Catch::Contains("LTRJ"));
  CHECK_THAT(refusal("help lfl"), Contains("did you mean LFIL?"));
  CHECK_THAT(refusal("help a b"), Contains("expects one mnemonic"));
}

TEST_CASE("what may stand at a place is completed, in the case in which it was begun") {
  using Names = std::vector<std::string>;
  CHECK(completions("", "RDS") == Names{"RDSTAT", "RDSIGS", "RDSUM"});
  CHECK(completions("", "port1") == Names{"port12"});
  CHECK(completions("Help ", "wa") == Names{"wait"});
  CHECK(completions("wait ", "") == Names{"hi", "complete", "breakpoint", "index", "error"});
  CHECK(completions("", "rep") == Names{"repeat"});
  CHECK(completions("read ", "D") == Names{"d"});
  CHECK(completions("", "").size() == commands().size());
  CHECK(completions("RDRP ", "").empty());
}

TEST_CASE("built-in scripts can be read, and have names") {
  const auto files = lab::built_in(".lm628");
  CHECK(files.size() == 6);
  for (const auto& file : files) {
    INFO(file);
    CHECK(find_script(file.stem().string()) == file);
    CHECK(parse_script(host::read_text(file), file.string()).size() > 5);
  }
  CHECK_THROWS_WITH(find_script("absolut"),
                    Contains("no such script, did you mean absolute?"));
  CHECK(find_script("my/move") == "my/move");
}

TEST_CASE("status shows each bit of both registers, and their words; help has the same names") {
  const std::string help = help_text(parsed("help RDSTAT").topic);
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
      CHECK_THAT(help, Contains(fmt::format("{} {}", row, line.substr(4, line.find("  ", 4) - 4))));
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
