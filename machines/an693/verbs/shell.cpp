// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/shell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/an693/machine_members.hpp"

namespace trammel::an693 {
namespace {

namespace map = sw::lm628_map;
using cosim::Clk;
using cosim::EndReason;

constexpr double kLongestBusy = 100e-6;  // [s] of a command or word
constexpr const char* kSignalBits[] = {
    "acquire next index", "command error",     "trajectory complete", "index pulse",
    "wraparound",         "position error",    "breakpoint",          "motor off",
    "8-bit output",       "turn off on error", "on target",           "velocity mode",
    "forward",            "UDF executed",      "acceleration loaded", "host interrupt"};

// Bits 1 to 7 of the status byte are those of the signals register.
const char* status_bit(unsigned bit) { return bit == 0 ? "busy" : kSignalBits[bit]; }

std::string names_of(std::uint32_t bits, unsigned count) {
  std::string text;
  for (unsigned bit = count; bit-- > 0;) {
    if ((bits >> bit & 1u) == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(count == 8 ? status_bit(bit)
                                                                : kSignalBits[bit]);
  }
  return text.empty() ? "no bit set" : text;
}

cosim::Waves waves_of(const Options& options) {
  cosim::Waves waves;
  if (options.run.wave == cosim::WaveFormat::kNone) return waves;
  const auto event = cosim::wave_event(options.run, triggers());
  const Clk origin = !event ? 0 : event->known() ? event->edge : Shell::kResetClk;
  waves.window = cosim::wave_window(options.run, origin);
  return waves;
}

std::uint32_t address(const Line& line) { return line.choice == "d" ? map::kData : map::kCommand; }

// Of the status byte, for the words of `wait`.
std::uint8_t awaited_bit(const std::string& event) {
  namespace bits = sw::lm628_status;
  if (event == "breakpoint") return bits::kBreakpoint;
  if (event == "index") return bits::kIndex;
  if (event == "error") return bits::kPositionError;
  return bits::kTrajectoryComplete;
}

void check(const sw::Lm628Port& port) {
  if (port.stuck()) throw Halt(EndReason::kFault, "the busy bit did not clear");
}

}  // namespace

Shell::Shell(const Options& options, const std::atomic<bool>& stop)
    : options_(options),
      stop_(stop),
      bench_(options, [](const Sample&) { return false; }, waves_of(options)),
      bus_(bench_.loop(), bench_.timing()) {
  strobe_reset();
  bus_.wait(kResetClk);
}

double Shell::seconds() const { return seconds_at(bench_.chip().now()); }

Clk Shell::clocks(double seconds) const {
  return std::max<Clk>(1, options_.run.clocks(seconds));
}

void Shell::strobe_reset() {
  bus_.write(map::kReset, 1);
  twelve_bits_ = false;
}

void Shell::check_assertions() const {
  if (const auto broken = bench_.chip().failed_assertion()) {
    throw Halt(EndReason::kAssertion,
               "assertion failed: " + lab::assertion_text(*broken, bench_.period_ps()));
  }
}

// Throws when simulated time is up, or the user interrupts.
void Shell::go_on() const {
  check_assertions();
  if (stop_.load(std::memory_order_relaxed)) {
    throw Halt(EndReason::kStopped, fmt::format("interrupted at {:.6f} s", seconds()));
  }
  if (bench_.chip().now() >= bench_.end()) {
    throw Halt(EndReason::kTimeout, fmt::format("run.max_s = {:g} s of simulated time are over",
                                                options_.run.max_s));
  }
}

void Shell::pass(Clk count) {
  const Clk sample = clocks(options_.sample_s());
  for (Clk left = count; left > 0; left -= sample) {
    go_on();
    bus_.wait(std::min(left, sample));
  }
}

Answer Shell::execute(const Line& line) {
  Answer answer;
  answer.json["line"] = line.text;
  try {
    go_on();
    switch (line.command->action) {
      case Action::kCommand: command(line, answer); break;
      case Action::kRead: tell(*line.command, bus_.read(address(line)), answer); break;
      case Action::kWrite: bus_.write(address(line), line.words[0]); break;
      case Action::kReset:
        strobe_reset();
        pass(kResetClk);
        break;
      case Action::kWait: wait(line, answer); break;
      case Action::kStatus: tell_status(answer); break;
      case Action::kPins: tell_pins(answer); break;
      case Action::kTorque: bench_.load(line.torque); break;
      case Action::kRepeat:
      case Action::kEnd: break;  // their lines are executed, in their place
      case Action::kHelp: answer.text = help_text(line.topic); break;
      case Action::kQuit: break;
    }
    check_assertions();
  } catch (const Halt& halt) {
    throw Halt(halt.end, line.where + ": " + halt.what());
  }
  answer.json["time_s"] = seconds();
  return answer;
}

void Shell::command(const Line& line, Answer& answer) {
  using Op = sw::Lm628Command;
  const Command& command = *line.command;
  sw::Lm628Port port(bus_);
  port.command(command.opcode);
  for (const std::uint32_t word : line.words) port.word(word);
  std::uint32_t reply = command.reply.bits > 0 ? port.read_word() : 0;
  if (command.reply.bits == 32) reply = reply << 16 | port.read_word();
  check(port);
  if (command.reply.bits > 0) tell(command, reply, answer);
  if (command.opcode == Op::kPort12) twelve_bits_ = true;
  if (command.opcode == Op::kPort8 || command.opcode == Op::kReset) twelve_bits_ = false;
  if (command.opcode == Op::kReset) pass(kResetClk);
  if (command.opcode == Op::kStt) answer.note = port_note(line);
}

// Why the motor would not do what it is told, or "".
std::string Shell::port_note(const Line& line) const {
  const lm628::PartOptions& part = options_.part;
  if (part.pulses() || twelve_bits_ == (part.dac_bits == 12)) return "";
  return line.where + (twelve_bits_ ? ": STT: the converter of 8 bits needs PORT8"
                                    : ": STT: the motor gets nothing before PORT12");
}

void Shell::tell(const Command& command, std::uint32_t bits, Answer& answer) const {
  const Reply& reply = command.reply;
  const std::string pattern = hex(bits, reply.bits);
  answer.json["hex"] = pattern;
  std::string text;
  if (reply.unit == nullptr) {
    text = names_of(bits, static_cast<unsigned>(reply.bits));
    answer.json["bits"] = text;
  } else {
    const bool negative = *reply.unit != '\0' && (bits >> (reply.bits - 1) & 1u) != 0;
    const double whole = bits - (negative ? std::ldexp(1, reply.bits) : 0);
    const double value = std::ldexp(whole, -reply.fraction_bits);
    answer.json["value"] = value;
    text = fmt::format("{:.{}f}", value, reply.fraction_bits > 0 ? 6 : 0);
    if (*reply.unit != '\0') {
      answer.json["unit"] = reply.unit;
      text += fmt::format(" {}", reply.unit);
    }
  }
  answer.text = fmt::format("{:<8}{}  {}\n", command.name, pattern, text);
}

void Shell::wait(const Line& line, Answer& answer) {
  const Clk begin = bench_.chip().now();
  const Clk limit = begin + clocks(line.seconds + line.samples * options_.sample_s());
  if (line.choice.empty()) return pass(limit - begin);
  sw::Lm628Port port(bus_);
  const bool for_host = line.choice == "hi";
  const std::uint8_t awaited = for_host ? 0 : awaited_bit(line.choice);
  const Clk sample = clocks(options_.sample_s());
  for (;;) {
    const std::uint8_t status = for_host ? bench_.chip().words().status : port.status();
    const bool is_there = for_host ? bench_.chip().host_irq()
                                   : (status & awaited) != 0;
    // A part that is busy may not yet have taken back what the last RSTI clears.
    if (is_there && (status & sw::lm628_status::kBusy) == 0) break;
    go_on();
    const Clk now = bench_.chip().now();
    if (now >= limit) {
      throw Halt(EndReason::kTimeout, fmt::format("{}: not within {:g} s; status {}", line.text,
                                                  line.seconds + line.samples * options_.sample_s(),
                                                  hex(status, 8)));
    }
    if (for_host && !is_there) {
      bus_.wait_until(bench_.loop().advance(std::min(limit, now + sample), cosim::kIrq).edge);
    } else {
      bus_.wait(std::min(limit - now, sample));
    }
  }
  const double waited = seconds() - seconds_at(begin);
  answer.json["waited_s"] = waited;
  answer.text = fmt::format("{}: after {:.6f} s\n", line.text, waited);
}

// Both registers as a table: 8 rows of a status bit and two signals. First the part finishes the
// command before.
void Shell::tell_status(Answer& answer) {
  pass(clocks(kLongestBusy));
  const std::uint32_t status = bus_.read(map::kCommand);
  sw::Lm628Port port(bus_);
  port.command(sw::Lm628Command::kRdsigs);
  const std::uint32_t signals = port.read_word();
  check(port);
  answer.json["status"] = hex(status, 8);
  answer.json["signals"] = hex(signals, 16);
  answer.text = fmt::format("status {:<25}signals {}\n", hex(status, 8), hex(signals, 16));
  for (unsigned row = 8; row-- > 0;) {
    answer.text += fmt::format("{:>3} {:<22}{}  ", row, status_bit(row), status >> row & 1u);
    for (const unsigned bit : {row + 8, row}) {
      answer.text += fmt::format("  {:>2} {:<22}{}", bit, kSignalBits[bit], signals >> bit & 1u);
    }
    answer.text += '\n';
  }
}

void Shell::tell_pins(Answer& answer) const {
  const cosim::Lines lines = bench_.plant().sense();
  const auto level = [lines](int bit) { return static_cast<int>(lines >> bit & 1u); };
  const int hi = bench_.chip().host_irq() ? 1 : 0, a = level(lm628::kEncoderA);
  const int b = level(lm628::kEncoderB), in = 1 - level(lm628::kIndex);  // active low at the part
  const cosim::Lines drive = bench_.chip().drive();
  const plant::DcMotorState motor = bench_.plant().axis().state(bench_.chip().now() - 1);
  const double volt = bench_.plant().axis().voltage();
  const double counts = shaft_counts(options_, motor.theta);
  const double speed = motor.omega / plant::MotorAxis::kTurn;
  answer.json["pins"] = {{"HI", hi}, {"A", a}, {"B", b}, {"IN", in}};
  std::string output;
  if (options_.part.pulses()) {
    const auto pin = [drive](int bit) { return static_cast<int>(drive >> bit & 1u); };
    const int sign = pin(lm628::kSign), magnitude = pin(lm628::kMagnitude);
    answer.json["pins"]["SIGN"] = sign;
    answer.json["pins"]["MAG"] = magnitude;
    output = fmt::format("SIGN {}  MAG {}", sign, magnitude);
  } else {
    answer.json["pins"]["DAC"] = drive;
    output = fmt::format("DAC {:03X}h", drive);
  }
  answer.json["motor"] = {{"volt_V", volt}, {"current_A", motor.i}, {"speed_rev_s", speed},
                          {"shaft_counts", counts}};
  answer.text = fmt::format("HI {}  A {}  B {}  IN {}  {}\n"
                            "motor {:.3f} V  {:.4f} A  {:.4f} rev/s  {:.2f} counts\n",
                            hi, a, b, in, output, volt, motor.i, speed, counts);
}

Result Shell::result() {
  Result result = bench_.result();
  const lm628::Words words = bench_.chip().words();
  result.desired = static_cast<std::int32_t>(words.position >> 16);
  result.real = words.actual;
  return result;
}

}  // namespace trammel::an693
