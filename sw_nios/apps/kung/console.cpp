// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/kung/console.hpp"

#include <new>

#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "sw_nios/hal/soc_map.hpp"

namespace trammel::sw {
namespace {

namespace reg = kung_xy_regs;

bool same(const char* a, const char* b) {
  while (*a != 0 && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

// Of at most 9 digits.
bool number(const char* text, std::int32_t low, std::int32_t high, std::int32_t& value) {
  const bool negative = *text == '-';
  if (negative) ++text;
  std::int32_t digits = 0, sum = 0;
  for (; *text >= '0' && *text <= '9' && digits < 9; ++text, ++digits) {
    sum = 10 * sum + (*text - '0');
  }
  value = negative ? -sum : sum;
  return digits > 0 && *text == 0 && value >= low && value <= high;
}

// Decimal, or 0x and at most 8 hexadecimal digits.
bool address(const char* text, std::int32_t high, std::int32_t& value) {
  if (text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) return number(text, 0, high, value);
  std::uint32_t digits = 0, sum = 0;
  for (text += 2; digits < 8; ++text, ++digits) {
    const char lower = static_cast<char>(*text | 0x20);
    if (*text >= '0' && *text <= '9') {
      sum = 16 * sum + static_cast<std::uint32_t>(*text - '0');
    } else if (lower >= 'a' && lower <= 'f') {
      sum = 16 * sum + static_cast<std::uint32_t>(lower - 'a') + 10;
    } else {
      break;
    }
  }
  if (digits == 0 || *text != 0 || sum > static_cast<std::uint32_t>(high)) return false;
  value = static_cast<std::int32_t>(sum);
  return true;
}

struct PathName {
  const char* name;
  Path path;
};
constexpr std::array<PathName, 5> kPaths{{{"circle", Path::kCircle},
                                          {"window", Path::kWindow},
                                          {"star", Path::kStar},
                                          {"square", Path::kSquare},
                                          {"line", Path::kLine}}};

struct GainName {
  const char* name;
  Gain AxisSetup::* gain;
  std::uint32_t address;
};
constexpr std::array<GainName, 6> kGains{{{"kp", &AxisSetup::kp, reg::kKp},
                                          {"ki", &AxisSetup::ki, reg::kKi},
                                          {"kv", &AxisSetup::kv, reg::kKv},
                                          {"eta", &AxisSetup::eta, reg::kEta},
                                          {"kp_cur", &AxisSetup::kp_cur, reg::kKpCur},
                                          {"ki_cur", &AxisSetup::ki_cur, reg::kKiCur}}};

constexpr std::int32_t kMaxPasses = 1000;

}  // namespace

void KungProgram::make() { app_ = new (place_) KungApp(setup_); }

void Console::take(char byte) {
  if (byte == '\r' || byte == '\n') {
    execute();
    return;
  }
  if (byte < ' ' || byte > '~' || length_ == kLine) {
    bad_ = true;
    return;
  }
  line_[length_++] = byte;
}

void Console::execute() {
  while (field_ != 0) print_field();  // an answer is a line of its own
  line_[length_] = 0;
  Words words;
  bool inside = false;
  for (std::uint32_t n = 0; n < length_; ++n) {
    char& c = line_[n];
    if (c == ' ') {
      c = 0;
      inside = false;
    } else if (!inside) {
      inside = true;
      if (words.count == Words::kMax) {
        bad_ = true;
      } else {
        words.at[words.count++] = &c;
      }
    }
  }
  const bool blank = !bad_ && words.count == 0;  // an empty line, or LF behind CR
  if (!blank && (bad_ || !command(words))) say("?");
  length_ = 0;
  bad_ = false;
}

// False: not understood. A command that is refused says why itself.
bool Console::command(const Words& words) {
  const char* name = words.at[0];
  if (same(name, "path")) return choose_path(words);
  if (same(name, "gain")) return set_gain(words);
  if (same(name, "r")) return read_register(words);
  if (same(name, "log")) {
    std::int32_t count = static_cast<std::int32_t>(KungApp::kLogSize);
    if (words.count > 2 || (words.count == 2 && !number(words.at[1], 1, count, count))) {
      return false;
    }
    const std::uint32_t size = program_.app().log_size();
    log_left_ = static_cast<std::uint32_t>(count) < size ? static_cast<std::uint32_t>(count) : size;
    log_at_ = size - log_left_;
    say("tick x_cmd y_cmd x_pos y_pos x_model y_model x_iq y_iq x_status y_status");
    return true;
  }
  if (words.count != 1) return false;
  if (same(name, "help")) {
    say("help, path NAME [PASSES], start, stop, gain AXIS NAME MANT EXP, gains, r ADDRESS, "
        "status, log [COUNT]");
  } else if (same(name, "start")) {
    if (program_.started()) return refuse("drives are on");
    program_.start(bus_);
    say("started");
  } else if (same(name, "stop")) {
    program_.stop(bus_);
    say("stopped");
  } else if (same(name, "status")) {
    status();
  } else if (same(name, "gains")) {
    gains();
  } else {
    return false;
  }
  return true;
}

bool Console::choose_path(const Words& words) {
  std::int32_t passes = 1;
  if (words.count < 2 || words.count > 3) return false;
  if (words.count == 3 && !number(words.at[2], 1, kMaxPasses, passes)) return false;
  for (const PathName& p : kPaths) {
    if (!same(words.at[1], p.name)) continue;
    if (program_.started()) return refuse("drives are on");
    program_.setup().path = p.path;
    program_.setup().repeats = static_cast<std::uint32_t>(passes);
    say("ok");
    return true;
  }
  return false;
}

bool Console::set_gain(const Words& words) {
  Gain gain;
  if (words.count != 5 || !number(words.at[3], 0, 2047, gain.mant) ||
      !number(words.at[4], -16, 15, gain.exp)) {
    return false;
  }
  const bool is_y = same(words.at[1], "y");
  if (!is_y && !same(words.at[1], "x")) return false;
  for (const GainName& g : kGains) {
    if (!same(words.at[2], g.name)) continue;
    program_.setup().axis[is_y ? 1 : 0].*g.gain = gain;
    if (program_.started()) bus_.write((is_y ? reg::kY : reg::kX) + g.address, gain_word(gain));
    say("ok");
    return true;
  }
  return false;
}

bool Console::read_register(const Words& words) {
  std::int32_t at = 0;
  constexpr auto kLast = static_cast<std::int32_t>(soc_map::kChipBytes - 4);
  if (words.count != 2 || !address(words.at[1], kLast, at) || at % 4 != 0) return false;
  TextLine line;
  ring_.put(line.hex(bus_.read(static_cast<std::uint32_t>(at))));
  return true;
}

void Console::status() {
  KungApp& app = program_.app();
  const Mailbox& mail = app.mailbox();
  TextLine line;
  line.text(!program_.started() ? "off" : mail.failure != 0 ? "failed" : "on");
  line.text(" point ").number(mail.point).text(" of ").number(app.points());
  line.text(" failure ").number(mail.failure).text(" fault ").number(app.fault());
  if (lost_ != 0) line.text(" lost ").number(lost_);
  if (app.log_size() != 0) {
    const LogRecord& last = app.log(app.log_size() - 1);
    line.text(" tick ").number(last.tick).text(" x ").number(last.x_pos);
    line.text(" y ").number(last.y_pos);
  }
  ring_.put(line);
}

void Console::gains() {
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    TextLine line;
    line.text(axis == 0 ? "x" : "y");
    for (const GainName& g : kGains) {
      const Gain& gain = program_.setup().axis[axis].*g.gain;
      line.text(" ").text(g.name).text(" ").number(gain.mant).text(" ").number(gain.exp);
    }
    ring_.put(line);
  }
}

void Console::pump() {
  if (log_left_ != 0 && ring_.empty()) print_field();
}

void Console::print_field() {
  const LogRecord& r = program_.app().log(log_at_);
  const std::array<std::int32_t, 10> words{
      r.x_cmd,   r.y_cmd, r.x_pos, r.y_pos, r.x_model,
      r.y_model, r.x_iq,  r.y_iq,  static_cast<std::int32_t>(r.x_status),
      static_cast<std::int32_t>(r.y_status)};
  TextLine line;
  if (field_ == 0) {
    ring_.put_part(line.number(r.tick));
    ++field_;
    return;
  }
  line.text(" ").number(words[field_ - 1]);
  if (field_ < words.size()) {
    ring_.put_part(line);
    ++field_;
    return;
  }
  ring_.put(line);
  field_ = 0;
  ++log_at_;
  --log_left_;
}

bool Console::refuse(const char* why) {
  TextLine line;
  ring_.put(line.text("? ").text(why));
  return true;
}

void Console::say(const char* text) {
  TextLine line;
  ring_.put(line.text(text));
}

}  // namespace trammel::sw
