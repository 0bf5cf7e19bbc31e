// SPDX-License-Identifier: Apache-2.0
//
// The language of `trammel lm628`: what it accepts, and its messages for what it refuses.

#include "machines/an693/verbs/script.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "lab/files.hpp"
#include "lab/scenarios.hpp"

using namespace trammel;
using namespace trammel::an693;
using Catch::Matchers::Contains;
using sw::Lm628Command;

namespace {

Lm628Line parsed(const std::string& text) {
  const auto line = parse_lm628_line(text, "a:1");
  REQUIRE(line);
  return *line;
}

std::vector<std::int64_t> values(const std::string& text) {
  std::vector<std::int64_t> all;
  for (const Lm628Value& one : parsed(text).values) all.push_back(one.value);
  return all;
}

std::string refusal(const std::string& text) {
  try {
    parse_lm628_script(text, "move.lm628");
  } catch (const lab::ConfigError& error) {
    const std::string line = error.what();
    CHECK(line.find('\n') == std::string::npos);
    return line;
  }
  return "";
}

}  // namespace

TEST_CASE("commands are the data sheet's mnemonics in upper or lower case, with its opcodes") {
  CHECK(parsed("STT").word->code == Lm628Command::kStt);
  CHECK(parsed("  stt  # go").word->code == Lm628Command::kStt);
  CHECK(parsed("rdRP;").word->reply_bits == 32);
  CHECK_FALSE(parse_lm628_line(" # nothing", "a:1"));
  CHECK_FALSE(parse_lm628_line("", "a:1"));
  std::set<int> codes;
  for (const Lm628Word& word : lm628_words()) {
    if (word.action == Lm628Action::kCommand) codes.insert(static_cast<int>(word.code));
  }
  CHECK(codes == std::set<int>{0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A,
                               0x0B, 0x0C, 0x0D, 0x1A, 0x1B, 0x1C, 0x1D, 0x1E, 0x1F, 0x20, 0x21});
}

TEST_CASE("numbers are decimal or hexadecimal; a signed value may be given as a bit pattern") {
  CHECK(values("SBPA 80000") == std::vector<std::int64_t>{80000});
  CHECK(values("SBPA -10") == std::vector<std::int64_t>{-10});
  CHECK(values("SBPA -0xA") == std::vector<std::int64_t>{-10});
  CHECK(values("SBPA FFFFFFF6h") == std::vector<std::int64_t>{-10});
  CHECK(values("SBPA 0x3fffffff") == std::vector<std::int64_t>{0x3FFFFFFF});
  CHECK(values("SBPA C0000000h") == std::vector<std::int64_t>{-(1 << 30)});
  CHECK_THAT(refusal("SBPA 80000001h"), Contains("move.lm628:1: SBPA: position: 80000001h is out"));
  CHECK_THAT(refusal("SBPA 40000000h"), Contains("-1073741824..1073741823 (C0000000h..3FFFFFFFh)"));
  for (const char* word : {"12a", "h", "0x", "-", "1.5", "--1", "99999999999999999999x"}) {
    CHECK_THAT(refusal(std::string("SBPA ") + word), Contains("is no number"));
  }
  CHECK_THAT(refusal("SBPA 99999999999999999999"), Contains("is out of range"));
  CHECK_THAT(refusal("SBPA FFFFFFFFFFFFFFFFh"), Contains("is out of range"));
}

TEST_CASE("LFIL takes what its control word asks for, in the part's order and width") {
  CHECK(values("LFIL 030Fh 50 5 1000 32767") ==
        std::vector<std::int64_t>{0x30F, 50, 5, 1000, 32767});
  CHECK(values("LFIL 0009h 50 7") == std::vector<std::int64_t>{9, 50, 7});
  CHECK(values("LFIL 0") == std::vector<std::int64_t>{0});
  for (const Lm628Value& value : parsed("LFIL 000Fh 1 2 3 4").values) CHECK(value.bits == 16);
  CHECK(refusal("\nLFIL 000Ah 50") ==
        "move.lm628:2: LFIL 000Ah asks for kp 0..32767 (7FFFh), kd 0..32767 (7FFFh): "
        "2 values, not 1");
  CHECK(refusal("LFIL 0008h 32768") ==
        "move.lm628:1: LFIL: kp: 32768 is out of range 0..32767 (7FFFh)");
  CHECK_THAT(refusal("LFIL 0004h -1"), Contains("LFIL: ki: -1 is out of range"));
  CHECK_THAT(refusal("LFIL 000Fh"), Contains(", il 0..32767 (7FFFh): 4 values, not 0"));
  CHECK_THAT(refusal("LFIL 0001h"), Contains("asks for il 0..32767 (7FFFh): 1 value, not 0"));
  CHECK_THAT(refusal("LFIL"), Contains("control word 0..65535 (FFFFh) is missing"));
  CHECK_THAT(refusal("LFIL 10000h"), Contains("control word: 10000h is out of range"));
}

TEST_CASE("LTRJ takes what its control word asks for; relative values may be negative") {
  CHECK(values("LTRJ 002Ah 2 346Eh 8000") == std::vector<std::int64_t>{0x2A, 2, 0x346E, 8000});
  CHECK(values("LTRJ 003Fh -2 -1 -8000") == std::vector<std::int64_t>{0x3F, -2, -1, -8000});
  const Lm628Line line = parsed("LTRJ 0002h FFFFE0C0h");
  CHECK(line.values[0].bits == 16);
  CHECK(line.values[1].bits == 32);
  CHECK(line.values[1].value == -8000);
  CHECK(values("LTRJ 0100h") == std::vector<std::int64_t>{0x100});
  CHECK(values("LTRJ 1815h") == std::vector<std::int64_t>{0x1815});  // relative, but nothing loaded
  CHECK_THAT(refusal("LTRJ 002Ah 2 3"),
             Contains("LTRJ 002Ah asks for acceleration 0..1073741823 (") &&
                 Contains("3 values, not 2"));
  CHECK_THAT(refusal("LTRJ 0003h"), Contains("asks for distance -1073741824..1073741823 ("));
  CHECK_THAT(refusal("LTRJ 0100h 5"), Contains("asks for nothing: 0 values, not 1"));
  CHECK_THAT(refusal("LTRJ 0008h 40000000h"),
             Contains("velocity: 40000000h is out of range 0..1073741823 (3FFFFFFFh)"));
  CHECK_THAT(refusal("LTRJ 0028h -1 1"), Contains("acceleration: -1 is out of range"));
}

TEST_CASE("all other commands take one number or none") {
  CHECK(values("LPES 7FFFh") == std::vector<std::int64_t>{0x7FFF});
  CHECK(values("MSKI 0040h") == std::vector<std::int64_t>{0x40});
  CHECK(values("byte d 255") == std::vector<std::int64_t>{255});
  CHECK(parsed("byte d 255").to_data);
  CHECK_FALSE(parsed("READ c").to_data);
  CHECK_THAT(refusal("LPEI 8000h"), Contains("LPEI: threshold: 8000h is out of range"));
  CHECK_THAT(refusal("RSTI"), Contains("RSTI: mask 0..65535 (FFFFh) is missing"));
  CHECK_THAT(refusal("STT 3"), Contains("STT asks for nothing: 0 values, not 1"));
  CHECK_THAT(refusal("byte d 256"), Contains("byte: 256 is out of range 0..255 (FFh)"));
  CHECK_THAT(refusal("byte 3"), Contains("expects c (PS low"));
  CHECK_THAT(refusal("read"), Contains("expects c (PS low"));
  CHECK_THAT(refusal("rdsatt"), Contains("unknown command, did you mean RDSTAT?"));
  CHECK_THAT(refusal("\x1b[2J"), Contains("?[2J: unknown command"));
  CHECK(refusal("STT\nquit\nfoo") ==
        "move.lm628:3: foo: unknown command; `help` names them all");
}

TEST_CASE("a wait takes a time, or an event with a time limit") {
  CHECK(parsed("wait 0.5 s").seconds == Approx(0.5));
  CHECK(parsed("wait 10ms").seconds == Approx(0.01));
  CHECK(parsed("wait 300 us").seconds == Approx(300e-6));
  CHECK(parsed("wait 100 samples").seconds == Approx(100 * 256e-6));
  CHECK(parsed("wait 100 samples").until == Lm628Until::kTime);
  CHECK(parsed("WAIT HI").until == Lm628Until::kHost);
  CHECK(parsed("wait hi").seconds == kLongestWait);
  CHECK(parsed("wait complete 2 s").until == Lm628Until::kComplete);
  CHECK(parsed("wait complete 2 s").seconds == 2);
  for (const char* bad : {"wait", "wait 5", "wait s", "wait -1 s", "wait hi 4 days", "wait inf s",
                          "wait 1 s 2", "wait done"}) {
    CHECK_THAT(refusal(bad), Contains("expects a time as 0.5 s"));
  }
  CHECK_THAT(refusal("wait 3601 s"), Contains("3601s is out of range 0..3600 s"));
  CHECK_THAT(refusal("wait 1e9 s"), Contains("is out of range"));
}

TEST_CASE("help lists all commands, or describes one") {
  const std::string all = lm628_help("");
  for (const Lm628Word& word : lm628_words()) CHECK_THAT(all, Contains(word.name));
  CHECK_THAT(all, Contains("1Fh  LTRJ control [acceleration]"));
  CHECK_THAT(lm628_help(parsed("help ltrj").topic), Contains("bit 5 acceleration"));
  CHECK_THAT(lm628_help("PORT12"), Contains("the motor needs PORT12"));
  CHECK(lm628_help("STT").find("LTRJ") == std::string::npos);
  CHECK_THAT(refusal("help lfl"), Contains("did you mean LFIL?"));
  CHECK_THAT(refusal("help a b"), Contains("expects one mnemonic"));
}

TEST_CASE("built-in scripts are found by name and can be parsed") {
  const auto files = lab::built_in(".lm628");
  CHECK(files.size() == 5);
  for (const auto& file : files) {
    INFO(file);
    CHECK(find_lm628_script(file.stem().string()) == file);
    CHECK(parse_lm628_script(lab::read_text(file), file.string()).size() > 5);
  }
  CHECK_THROWS_WITH(find_lm628_script("absolut"),
                    Contains("no such script, did you mean absolute?"));
  CHECK(find_lm628_script("my/move") == "my/move");
}
