// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/shell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/an693/figures.hpp"
#include "machines/an693/machine.hpp"

namespace trammel::an693 {
namespace {

namespace map = sw::lm628_map;
using cosim::Clk;
using Json = nlohmann::ordered_json;
using sw::Lm628Command;

constexpr double kLongestBusy = 100e-6;  // [s] of a command or word
constexpr const char* kStatusBits[] = {"busy",        "command error",  "trajectory complete",
                                       "index pulse", "wraparound",     "position error",
                                       "breakpoint",  "motor off"};
constexpr const char* kSignalBits[] = {
    "acquire next index", "command error",     "trajectory complete", "index pulse",
    "wraparound",         "position error",    "breakpoint",          "motor off",
    "8-bit output",       "turn off on error", "on target",           "velocity mode",
    "forward",            "UDF executed",      "acceleration loaded", "host interrupt"};

std::string names_of(std::uint32_t bits, const char* const* names, int count) {
  std::string text;
  for (int bit = count - 1; bit >= 0; --bit) {
    if ((bits >> bit & 1u) != 0) text += (text.empty() ? "" : ", ") + std::string(names[bit]);
  }
  return text.empty() ? "no bit set" : text;
}

// The pattern as the word's number: sign, fraction.
double number_of(const Lm628Word& word, std::uint32_t bits) {
  auto value = static_cast<std::int64_t>(bits);
  if (word.is_signed && (bits >> (word.reply_bits - 1) & 1u) != 0) {
    value -= std::int64_t{1} << word.reply_bits;
  }
  return std::ldexp(static_cast<double>(value), -word.fraction_bits);
}

cosim::Waves waves_of(const Options& options) {
  cosim::Waves waves;
  if (options.run.wave == cosim::WaveFormat::kNone) return waves;
  const auto event = cosim::wave_event(options.run, triggers());
  const Clk first_line = Lm628Shell::kResetClk;
  const Clk origin = !event ? 0 : event->known() ? event->edge : first_line;
  waves.window = cosim::wave_window(options.run, origin);
  return waves;
}

void check(const sw::Lm628Port& port, const std::string& where) {
  if (!port.stuck()) return;
  throw Lm628Halt(cosim::EndReason::kFault, where + ": the busy bit did not clear");
}

}  // namespace

Lm628Shell::Lm628Shell(const Options& options, const std::atomic<bool>& stop)
    : options_(options),
      stop_(stop),
      bench_(options, [](const Sample&) { return false; }, waves_of(options)),
      bus_(bench_.loop(), bench_.timing()) {
  strobe_reset();
  bus_.wait(kResetClk);
}

double Lm628Shell::seconds() const { return lab::seconds_of(bench_.chip().now()); }

Clk Lm628Shell::clocks(double seconds) const {
  return std::max<Clk>(1, cosim::clocks_of(seconds, options_.plant.clock_ps));
}

void Lm628Shell::strobe_reset() {
  bus_.write(map::kReset, 1);
  twelve_bits_ = false;
}

void Lm628Shell::look_at_promises(const std::string& where) const {
  const auto broken = bench_.chip().broken_promise();
  if (!broken) return;
  throw Lm628Halt(cosim::EndReason::kPromise,
                  fmt::format("{}: assertion failed: {}", where,
                              lab::promise_text(*broken)));
}

// Throws when there is no more time, or no wish to go on.
void Lm628Shell::go_on(const std::string& where) const {
  look_at_promises(where);
  if (stop_.load(std::memory_order_relaxed)) {
    throw Lm628Halt(cosim::EndReason::kStopped, fmt::format("{}: interrupted at {:.6f} s", where,
                                                            seconds()));
  }
  if (bench_.chip().now() >= bench_.end()) {
    throw Lm628Halt(cosim::EndReason::kTimeout,
                    fmt::format("{}: run.max_s = {:g} s of simulated time are over", where,
                                options_.run.max_s));
  }
}

void Lm628Shell::pass(const std::string& where, Clk count) {
  const Clk sample = clocks(kSampleS);
  for (Clk left = count; left > 0; left -= sample) {
    go_on(where);
    bus_.wait(std::min(left, sample));
  }
}

Lm628Answer Lm628Shell::execute(const Lm628Line& line) {
  go_on(line.where);
  Lm628Answer answer;
  answer.json["line"] = line.text;
  const Lm628Word& word = *line.word;
  switch (word.action) {
    case Lm628Action::kCommand: command(line, answer); break;
    case Lm628Action::kRdstat: tell(word, bus_.read(map::kCommand), answer); break;
    case Lm628Action::kRead:
      tell(word, bus_.read(line.to_data ? map::kData : map::kCommand), answer);
      break;
    case Lm628Action::kByte:
      bus_.write(line.to_data ? map::kData : map::kCommand,
                 static_cast<std::uint32_t>(line.values[0].value));
      break;
    case Lm628Action::kRst:
      strobe_reset();
      pass(line.where, kResetClk);
      break;
    case Lm628Action::kWait: wait(line, answer); break;
    case Lm628Action::kStatus: tell_status(line.where, answer); break;
    case Lm628Action::kPins: tell_pins(answer); break;
    case Lm628Action::kHelp: answer.text = lm628_help(line.topic); break;
    case Lm628Action::kQuit: break;
  }
  look_at_promises(line.where);
  answer.json["time_s"] = seconds();
  return answer;
}

void Lm628Shell::command(const Lm628Line& line, Lm628Answer& answer) {
  const Lm628Word& word = *line.word;
  sw::Lm628Port port(bus_);
  port.command(word.code);
  for (const Lm628Value& data : line.values) {
    if (data.bits == 16) {
      port.word(static_cast<std::uint32_t>(data.value));
    } else {
      port.long_word(static_cast<std::int32_t>(data.value));
    }
  }
  std::uint32_t reply = word.reply_bits > 0 ? port.read_word() : 0;
  if (word.reply_bits == 32) reply = reply << 16 | port.read_word();
  check(port, line.where);
  if (word.reply_bits > 0) tell(word, reply, answer);
  if (word.code == Lm628Command::kPort12) twelve_bits_ = true;
  if (word.code == Lm628Command::kPort8) twelve_bits_ = false;
  if (word.code == Lm628Command::kReset) {
    twelve_bits_ = false;
    pass(line.where, kResetClk);
  }
  if (word.code == Lm628Command::kStt && !twelve_bits_) {
    answer.note = line.where + ": STT: the motor gets nothing before PORT12";
  }
}

void Lm628Shell::tell(const Lm628Word& word, std::uint32_t bits, Lm628Answer& answer) const {
  const std::string hex = lm628_hex(bits, word.reply_bits);
  answer.json["hex"] = hex;
  if (word.action == Lm628Action::kRead) {
    answer.json["value"] = bits;
    answer.text = fmt::format("read    {}  {}\n", hex, bits);
  } else if (*word.unit == '\0') {
    const bool is_status = word.reply_bits == 8;
    const std::string names = names_of(bits, is_status ? kStatusBits : kSignalBits,
                                       word.reply_bits);
    answer.json["bits"] = names;
    answer.text = fmt::format("{:<8}{}  {}\n", word.name, hex, names);
  } else {
    const double value = number_of(word, bits);
    answer.json["value"] = value;
    answer.json["unit"] = word.unit;
    answer.text = fmt::format("{:<8}{}  {:.{}f} {}\n", word.name, hex, value,
                              word.fraction_bits > 0 ? 6 : 0, word.unit);
  }
}

void Lm628Shell::wait(const Lm628Line& line, Lm628Answer& answer) {
  const Clk begin = bench_.chip().now();
  const Clk limit = begin + clocks(line.seconds);
  if (line.until == Lm628Until::kTime) return pass(line.where, limit - begin);
  sw::Lm628Port port(bus_);
  const bool for_host = line.until == Lm628Until::kHost;
  const Clk sample = clocks(kSampleS);
  for (;;) {
    const std::uint8_t status = for_host ? bench_.chip().words().status : port.status();
    const bool is_there = for_host ? bench_.chip().host_irq()
                                   : (status & sw::lm628_status::kTrajectoryComplete) != 0;
    // A part that is busy may not yet have taken back what the last RSTI clears.
    if (is_there && (status & sw::lm628_status::kBusy) == 0) break;
    go_on(line.where);
    const Clk now = bench_.chip().now();
    if (now >= limit) {
      throw Lm628Halt(cosim::EndReason::kTimeout,
                      fmt::format("{}: {}: not within {:g} s; status {}", line.where, line.text,
                                  line.seconds, lm628_hex(status, 8)));
    }
    if (for_host && !is_there) {
      bus_.wait_until(bench_.loop().advance(std::min(limit, now + sample), cosim::kIrq).edge);
    } else {
      bus_.wait(std::min(limit - now, sample));
    }
  }
  const double waited = seconds() - lab::seconds_of(begin);
  answer.json["waited_s"] = waited;
  answer.text = fmt::format("{}: after {:.6f} s\n", line.text, waited);
}

// Both registers as a table: 8 rows of a status bit and two signals. The part has ended what was
// before.
void Lm628Shell::tell_status(const std::string& where, Lm628Answer& answer) {
  pass(where, clocks(kLongestBusy));
  const std::uint32_t status = bus_.read(map::kCommand);
  sw::Lm628Port port(bus_);
  port.command(Lm628Command::kRdsigs);
  const std::uint32_t signals = port.read_word();
  check(port, where);
  const std::string hex = lm628_hex(signals, 16);
  answer.json["status"] = lm628_hex(status, 8);
  answer.json["signals"] = hex;
  answer.text = fmt::format("{:<32}{}\n", "status " + lm628_hex(status, 8), "signals " + hex);
  for (unsigned row = 8; row-- > 0;) {
    answer.text += fmt::format("{:>3} {:<22}{}  ", row, kStatusBits[row], status >> row & 1u);
    for (const unsigned bit : {row + 8, row}) {
      answer.text += fmt::format("  {:>2} {:<22}{}", bit, kSignalBits[bit], signals >> bit & 1u);
    }
    answer.text += '\n';
  }
}

void Lm628Shell::tell_pins(Lm628Answer& answer) const {
  const cosim::Lines lines = bench_.plant().sense();
  const auto level = [lines](int bit) { return static_cast<int>(lines >> bit & 1u); };
  const cosim::Lines code = bench_.chip().drive();
  const plant::DcMotorState motor = bench_.plant().axis().state(bench_.chip().now() - 1);
  Sample shaft;
  shaft.theta = motor.theta;
  const double volt = bench_.plant().axis().voltage();
  const int in = 1 - level(lm628::kIndex);  // active low at the part
  const double counts = shaft_counts(options_, shaft);
  const double speed = motor.omega / plant::MotorAxis::kTurn;
  answer.json["pins"] = {{"HI", bench_.chip().host_irq() ? 1 : 0}, {"A", level(lm628::kEncoderA)},
                         {"B", level(lm628::kEncoderB)}, {"IN", in}, {"DAC", code}};
  answer.json["motor"] = {{"volt_V", volt}, {"current_A", motor.i}, {"speed_rev_s", speed},
                          {"shaft_counts", counts}};
  answer.text = fmt::format("HI {}  A {}  B {}  IN {}  DAC {:03X}h\n",
                            bench_.chip().host_irq() ? 1 : 0, level(lm628::kEncoderA),
                            level(lm628::kEncoderB), in, code);
  answer.text += fmt::format("motor {:.3f} V  {:.4f} A  {:.4f} rev/s  {:.2f} counts\n", volt,
                             motor.i, speed, counts);
}

Result Lm628Shell::result() {
  Result result = bench_.result();
  const lm628::Words words = bench_.chip().words();
  result.desired = static_cast<std::int32_t>(words.position >> 16);
  result.real = words.actual;
  return result;
}

}  // namespace trammel::an693
