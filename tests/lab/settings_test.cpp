// SPDX-License-Identifier: Apache-2.0
//
// What is suggested for a mistyped word, values as text, what a run's heading says; and texts of
// any kind as they are shown.
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <vector>

#include "host/files.hpp"
#include "host/text.hpp"
#include "lab/heading.hpp"
#include "lab/machine.hpp"
#include "lab/settings.hpp"

using namespace trammel;
using namespace trammel::lab;

TEST_CASE("a word with one letter left out, added or wrong is found among others") {
  const std::vector<std::string> words{"gains.feedforward", "path.kind", "plant.coulomb_N",
                                       "run.platform"};
  for (const std::string& word : words) {
    for (std::size_t at = 0; at < word.size(); ++at) {
      std::string less = word, more = word, wrong = word;
      less.erase(at, 1);
      more.insert(at, "#");
      wrong[at] = '#';
      for (const std::string& typed : {less, more, wrong}) {
        INFO("typed " << typed);
        CHECK(lab::suggest(typed, words) == word);
      }
    }
  }
}

TEST_CASE("two letters left out side by side are still that word, half of it is another") {
  const std::vector<std::string> words{"plant.coulomb_N", "run.platform"};
  CHECK(lab::suggest("plantcoulomb", {"plant.coulomb_N"}) == "plant.coulomb_N");
  for (std::size_t at = 0; at + 2 <= words[0].size(); ++at) {
    std::string less = words[0];
    less.erase(at, 2);
    INFO("typed " << less);
    CHECK(lab::suggest(less, words) == words[0]);
  }
  CHECK(lab::suggest("coulomb_N", words) == "");
}

TEST_CASE("a word is found in any case and by its beginning, a single letter is none") {
  CHECK(lab::suggest("PLANT.COULOMB_n", {"plant.coulomb_N"}) == "plant.coulomb_N");
  CHECK(lab::suggest("pl", {"gains.kp", "plant.coulomb_N"}) == "plant.coulomb_N");
  CHECK(lab::suggest("p", {"plant.coulomb_N"}) == "");
  CHECK(lab::suggest("fca", {"fc", "afc"}) == "fc");
  CHECK(lab::suggest("list", {"lint"}) == "lint");
  CHECK(lab::suggest("lost", {"lint"}) == "");  // half of a short word
  CHECK(lab::hint("lost", {"lint"}, "; none") == "; none");
  CHECK(lab::hint("linx", {"lint"}, "; none") == "; did you mean lint?");
}

TEST_CASE("a value is the text that TOML reads as the same value") {
  CHECK(lab::value_text(true) == "true");
  CHECK(lab::value_text(std::int64_t{-7}) == "-7");
  CHECK(lab::value_text(3.0) == "3.0");
  CHECK(lab::value_text(0.1) == "0.1");
  CHECK(lab::value_text(1e300) == "1e+300");
  CHECK(lab::value_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(lab::value_text(std::nan("")) == "nan");
  CHECK(lab::value_text(std::string("a \"b\" \\ \n\x01\x7f")) ==
        "\"a \\\"b\\\" \\\\ \\u000A\\u0001\\u007F\"");
}

TEST_CASE("a heading names what is not its scenario's, three of them at most, axes together") {
  std::size_t tried = 0;
  for (const lab::Machine* const machine : lab::machines()) {
    if (machine->alters == nullptr) continue;
    std::vector<const lab::Key*> of_x;  // reals of both axes that alter it
    for (const lab::Key& key : machine->keys()) {
      if (key.kind == lab::Kind::kReal && key.name.find(".x.") != std::string::npos &&
          machine->alters(key, 0.5)) {
        of_x.push_back(&key);
      }
    }
    REQUIRE(of_x.size() >= 4);
    const auto settings = machine->defaults();
    const auto set = [&](const std::string& name, double value) {
      for (const lab::Key* const key : lab::find_keys(machine->keys(), name)) {
        const lab::Value before = key->get(*settings);
        key->set(*settings, value);
        if (lab::Value(value) != before) lab::note_change(*settings, *key, before);
      }
    };
    const auto own = [&](const std::string& name) {
      return std::get<double>(
          lab::find_keys(machine->keys(), name).front()->get(*machine->defaults()));
    };
    settings->description = "mine (a (b)) (Fig. 3)";
    settings->heading = {};
    const std::string one = of_x[0]->name, both = lab::short_form(one);
    const std::string begin = "mine (a (b)); here ";
    CAPTURE(machine->name, one);
    set(one, own(one) + 0.5);
    CHECK(settings->description.rfind(begin + one + " = ", 0) == 0);
    CHECK(settings->description.find(',') == std::string::npos);
    set(one, own(one) + 0.75);  // and again: still against the scenario's
    set(one, own(one));
    CHECK(settings->description == "mine (a (b)) (Fig. 3)");
    set(both, own(one) + 0.5);
    CHECK(settings->description.rfind(begin + both + " = ", 0) == 0);
    CHECK(settings->description.find(',') == std::string::npos);
    for (std::size_t k = 1; k < 4; ++k) set(of_x[k]->name, own(of_x[k]->name) + 0.5);
    CHECK_THAT(settings->description, Catch::EndsWith(" and 1 more"));
    CHECK_THAT(settings->description, Catch::Contains(of_x[2]->name + " = ") &&
                                          !Catch::Contains(of_x[3]->name + " = "));
    ++tried;
  }
  CHECK(tried > 0);
}

TEST_CASE("control characters and bytes that are no UTF-8 are told, not sent to the terminal") {
  const std::string same = "plain, it's \"one\": \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80";
  CHECK(host::printable(same) == same);
  CHECK(host::printable("a\x1b[31m\x7f\r\n\t") == "a\\u001b[31m\\u007f\\u000d\\u000a\\u0009");
  CHECK(host::printable(std::string("\0", 1)) == "\\u0000");
  CHECK(host::printable("\xC2\x9B" "31m") == "\\u009b31m");  // the same command in one character
  CHECK(host::printable("a\u202eb\u200b\u2028\ufeff") == "a\\u202eb\\u200b\\u2028\\ufeff");
  CHECK(host::printable("\U000e0041") == "\\U000e0041");
  CHECK(host::printable("\u00b5\u2026\u4e2d\U0001f600") == "\u00b5\u2026\u4e2d\U0001f600");
  CHECK(host::printable("a\xff") == "a\\xff");
  CHECK(host::printable("\x80") == "\\x80");
  CHECK(host::printable("\xC3") == "\\xc3");                      // begun
  CHECK(host::printable("\xC0\x9B") == "\\xc0\\x9b");             // longer than need be
  CHECK(host::printable("\xE0\x80\x9B") == "\\xe0\\x80\\x9b");
  CHECK(host::printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");  // a surrogate
  CHECK(host::printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(host::printable("\xED\xBF\xBF") == "\\xed\\xbf\\xbf");            // the last surrogate
  CHECK(host::printable("\xF0\x8F\xBF\xBF") == "\\xf0\\x8f\\xbf\\xbf");  // U+FFFF in four bytes
  CHECK(host::printable("\xF4\x8F\xBF\xBF") == "\xF4\x8F\xBF\xBF");      // the last character
  CHECK(host::printable_lines("a\n\tb\x1b") == "a\n\tb\\u001b");
}

TEST_CASE("each range of control characters begins and ends where Unicode has it") {
  const struct {
    const char *before, *first, *last, *after, *first_told, *last_told;
  } ranges[] = {
      {"~", "\x7f", "\xC2\x9F", "\u00a0", "\\u007f", "\\u009f"},
      {"\u00ac", "\u00ad", "\u00ad", "\u00ae", "\\u00ad", "\\u00ad"},
      {"\u05ff", "\u0600", "\u0605", "\u0606", "\\u0600", "\\u0605"},
      {"\u061b", "\u061c", "\u061c", "\u061d", "\\u061c", "\\u061c"},
      {"\u180d", "\u180e", "\u180e", "\u180f", "\\u180e", "\\u180e"},
      {"\u200a", "\u200b", "\u200f", "\u2010", "\\u200b", "\\u200f"},
      {"\u2027", "\u2028", "\u202e", "\u202f", "\\u2028", "\\u202e"},
      {"\u205f", "\u2060", "\u2064", "\u2065", "\\u2060", "\\u2064"},
      {"\u2065", "\u2066", "\u206f", "\u2070", "\\u2066", "\\u206f"},
      {"\ufff8", "\ufff9", "\ufffb", "\ufffc", "\\ufff9", "\\ufffb"},
      {"\U000e001f", "\U000e0020", "\U000e007f", "\U000e0080", "\\U000e0020", "\\U000e007f"}};
  for (const auto& range : ranges) {
    CAPTURE(range.first_told);
    CHECK(host::printable(range.before) == range.before);
    CHECK(host::printable(range.first) == range.first_told);
    CHECK(host::printable(range.last) == range.last_told);
    CHECK(host::printable(range.after) == range.after);
  }
}

TEST_CASE("what a message repeats is cut") {
  CHECK(host::shown(std::string(120, 'k')) == std::string(120, 'k'));
  CHECK(host::shown(std::string(5000, 'k')) == std::string(120, 'k') + "\xE2\x80\xA6");
  CHECK(host::shown("\xC3\xA9\xC3\xA9\xC3\xA9", 2) == "\xC3\xA9\xC3\xA9\xE2\x80\xA6");
}

TEST_CASE("a message is one line with its beginning and its end") {
  CHECK(host::one_line("a\nb") == "a\\u000ab");
  const std::string cut = "\xE2\x80\xA6", name(255, 'n'), shown(120, 'k');
  CHECK(host::one_line("file: " + std::string(40000, 'k') + ": reason") ==
        "file: " + shown + cut + " reason");
  CHECK(host::one_line("/" + name + "/" + name + ": reason") ==
        "/" + name + "/" + name + ": reason");
  CHECK(host::one_line("a/" + std::string(301, 'k') + "/" + std::string(301, 'k')) ==
        "a/" + shown + cut + "/" + shown + cut);
  CHECK(host::one_line(std::string(300, 'k')) == std::string(300, 'k'));
  std::string longest;  // 2000 characters, and one more
  for (int k = 0; k < 1000; ++k) longest += "a ";
  CHECK(host::one_line(longest) == longest);
  CHECK(host::one_line(longest + "a") ==
        longest.substr(0, 1000) + cut + (longest + "a").substr(1001));
  std::string message = "file:";
  for (int k = 0; k < 10000; ++k) message += " word";
  const std::string line = host::one_line(message + ": reason");
  CHECK(line.size() == 2003);
  CHECK(line.substr(0, 10) == "file: word");
  CHECK(line.substr(line.size() - 12) == "word: reason");
}

TEST_CASE("a time has the unit that suits it, and as many digits as asked for") {
  CHECK(host::time_text(0) == "0 s");
  CHECK(host::time_text(1) == "1 s");
  CHECK(host::time_text(-2.4) == "-2.4 s");
  CHECK(host::time_text(2.4) == "2.4 s");
  CHECK(host::time_text(1.00000002) == "1.00000002 s");  // a clock behind a second
  CHECK(host::time_text(0.0018) == "1.8 ms");
  CHECK(host::time_text(-1e-3) == "-1 ms");
  CHECK(host::time_text(1.6e-7) == "0.16 us");
  CHECK(host::time_text(2.40123e-3, 3) == "2.4 ms");
}

TEST_CASE("a shell takes a word as it is, in quotes where it would not") {
  CHECK(host::shell_argument("run.max_s=1e-3,a/B:c+d") == "run.max_s=1e-3,a/B:c+d");
  for (const char* const text : {"a b", "~", "*", "?", "$a", "\"", "a;b", "(", "<", "!", "#", "\\",
                                 "[a]", "{a}", "&", "`", "\xC3\xA9"}) {
    CAPTURE(text);
    CHECK(host::shell_argument(text) == "'" + std::string(text) + "'");
  }
  CHECK(host::shell_argument("it's") == "'it'\\''s'");
  CHECK(host::shell_word("plain") == "'plain'");
  CHECK(host::shell_argument("a\n\xFF'\\") == "$'a\\u000a\\xff\\'\\\\'");
}

TEST_CASE("a lack of memory names the limit") {
  CHECK(host::reason_of(std::runtime_error("why")) == "why");
  rlimit before{};
  getrlimit(RLIMIT_DATA, &before);
  CHECK_THAT(host::reason_of(std::bad_alloc()), Catch::StartsWith("memory did not suffice: "));
  rlimit limit = before;
  limit.rlim_cur = rlim_t{1} << 40;
  if (before.rlim_max < limit.rlim_cur) return;
  setrlimit(RLIMIT_DATA, &limit);
  const std::string reason = host::reason_of(std::bad_alloc());
  setrlimit(RLIMIT_DATA, &before);
  rlimit address{};
  getrlimit(RLIMIT_AS, &address);
  if (address.rlim_cur != RLIM_INFINITY) return;
  CHECK(reason == "memory did not suffice: ulimit -d allows 1073741824 KiB");
}
