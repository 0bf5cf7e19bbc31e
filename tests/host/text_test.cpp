// SPDX-License-Identifier: Apache-2.0
//
// Texts that others wrote, as a terminal, a message or a shell takes them.
#include "host/text.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <new>
#include <stdexcept>
#include <string>

#include "host/files.hpp"

using namespace trammel::host;

TEST_CASE("control characters and bytes that are no UTF-8 are told, not sent to the terminal") {
  const std::string same = "plain, it's \"one\": \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80";
  CHECK(printable(same) == same);
  CHECK(printable("a\x1b[31m\x7f\r\n\t") == "a\\u001b[31m\\u007f\\u000d\\u000a\\u0009");
  CHECK(printable(std::string("\0", 1)) == "\\u0000");
  CHECK(printable("\xC2\x9B" "31m") == "\\u009b31m");  // the same command in one character
  CHECK(printable("a\u202eb\u200b\u2028\ufeff") == "a\\u202eb\\u200b\\u2028\\ufeff");
  CHECK(printable("\U000e0041") == "\\U000e0041");
  CHECK(printable("\u00b5\u2026\u4e2d\U0001f600") == "\u00b5\u2026\u4e2d\U0001f600");
  CHECK(printable("a\xff") == "a\\xff");
  CHECK(printable("\x80") == "\\x80");
  CHECK(printable("\xC3") == "\\xc3");                      // begun
  CHECK(printable("\xC0\x9B") == "\\xc0\\x9b");             // longer than need be
  CHECK(printable("\xE0\x80\x9B") == "\\xe0\\x80\\x9b");
  CHECK(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");  // a surrogate
  CHECK(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(printable("\xED\xBF\xBF") == "\\xed\\xbf\\xbf");            // the last surrogate
  CHECK(printable("\xF0\x8F\xBF\xBF") == "\\xf0\\x8f\\xbf\\xbf");  // U+FFFF in four bytes
  CHECK(printable("\xF4\x8F\xBF\xBF") == "\xF4\x8F\xBF\xBF");      // the last character
  CHECK(printable_lines("a\n\tb\x1b") == "a\n\tb\\u001b");
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
    CHECK(printable(range.before) == range.before);
    CHECK(printable(range.first) == range.first_told);
    CHECK(printable(range.last) == range.last_told);
    CHECK(printable(range.after) == range.after);
  }
}

TEST_CASE("what a message repeats is cut") {
  CHECK(shown(std::string(120, 'k')) == std::string(120, 'k'));
  CHECK(shown(std::string(5000, 'k')) == std::string(120, 'k') + "\xE2\x80\xA6");
  CHECK(shown("\xC3\xA9\xC3\xA9\xC3\xA9", 2) == "\xC3\xA9\xC3\xA9\xE2\x80\xA6");
}

TEST_CASE("a message is one line with its beginning and its end") {
  CHECK(one_line("a\nb") == "a\\u000ab");
  const std::string cut = "\xE2\x80\xA6", name(255, 'n'), shown(120, 'k');
  CHECK(one_line("file: " + std::string(40000, 'k') + ": reason") ==
        "file: " + shown + cut + " reason");
  CHECK(one_line("/" + name + "/" + name + ": reason") ==
        "/" + name + "/" + name + ": reason");
  CHECK(one_line("a/" + std::string(301, 'k') + "/" + std::string(301, 'k')) ==
        "a/" + shown + cut + "/" + shown + cut);
  CHECK(one_line(std::string(300, 'k')) == std::string(300, 'k'));
  std::string longest;  // 2000 characters, and one more
  for (int k = 0; k < 1000; ++k) longest += "a ";
  CHECK(one_line(longest) == longest);
  CHECK(one_line(longest + "a") ==
        longest.substr(0, 1000) + cut + (longest + "a").substr(1001));
  std::string message = "file:";
  for (int k = 0; k < 10000; ++k) message += " word";
  const std::string line = one_line(message + ": reason");
  CHECK(line.size() == 2003);
  CHECK(line.substr(0, 10) == "file: word");
  CHECK(line.substr(line.size() - 12) == "word: reason");
}

TEST_CASE("a time has the unit that suits it, and as many digits as asked for") {
  CHECK(time_text(0) == "0 s");
  CHECK(time_text(1) == "1 s");
  CHECK(time_text(-2.4) == "-2.4 s");
  CHECK(time_text(2.4) == "2.4 s");
  CHECK(time_text(1.00000002) == "1.00000002 s");  // a clock behind a second
  CHECK(time_text(0.0018) == "1.8 ms");
  CHECK(time_text(-1e-3) == "-1 ms");
  CHECK(time_text(1.6e-7) == "0.16 us");
  CHECK(time_text(2.40123e-3, 3) == "2.4 ms");
}

TEST_CASE("a shell takes a word as it is, in quotes where it would not") {
  CHECK(shell_argument("run.max_s=1e-3,a/B:c+d") == "run.max_s=1e-3,a/B:c+d");
  for (const char* const text : {"a b", "~", "*", "?", "$a", "\"", "a;b", "(", "<", "!", "#", "\\",
                                 "[a]", "{a}", "&", "`", "\xC3\xA9"}) {
    CAPTURE(text);
    CHECK(shell_argument(text) == "'" + std::string(text) + "'");
  }
  CHECK(shell_argument("it's") == "'it'\\''s'");
  CHECK(shell_word("plain") == "'plain'");
  CHECK(shell_argument("a\n\xFF'\\") == "$'a\\u000a\\xff\\'\\\\'");
}

TEST_CASE("a lack of memory names the limit") {
  CHECK(reason_of(std::runtime_error("why")) == "why");
  rlimit before{};
  getrlimit(RLIMIT_DATA, &before);
  CHECK_THAT(reason_of(std::bad_alloc()), Catch::StartsWith("memory did not suffice: "));
  rlimit limit = before;
  limit.rlim_cur = rlim_t{1} << 40;
  if (before.rlim_max < limit.rlim_cur) return;
  setrlimit(RLIMIT_DATA, &limit);
  const std::string reason = reason_of(std::bad_alloc());
  setrlimit(RLIMIT_DATA, &before);
  rlimit address{};
  getrlimit(RLIMIT_AS, &address);
  if (address.rlim_cur != RLIM_INFINITY) return;
  CHECK(reason == "memory did not suffice: ulimit -d allows 1073741824 KiB");
}
