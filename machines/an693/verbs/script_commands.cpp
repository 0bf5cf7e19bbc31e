// SPDX-License-Identifier: Apache-2.0
//
// The words of `trammel lm628`, and what `help` says of each.
#include "machines/an693/verbs/script.hpp"

namespace trammel::an693 {
namespace {

constexpr char kFilterHelp[] =
    "control word: bits 15..8 n, the derivative is formed every n + 1 samples;\n"
    "bit 3 kp, 2 ki, 1 kd, 0 il follow, in this order, each 0..32767.\n"
    "  LFIL 030Ah 50 1000    kp = 50, kd = 1000, every 4 samples; UDF activates them\n";
constexpr char kTrajectoryHelp[] =
    "control word: bit 5 acceleration, 3 velocity, 1 position follow, in this order; the bit\n"
    "below each (4, 2, 0): it is relative. Bit 11 velocity mode, 12 forward in it;\n"
    "10 stop smoothly, 9 stop abruptly, 8 motor off.\n"
    "Acceleration in 2^-16 count/sample^2, velocity in 2^-16 count/sample, position in counts.\n"
    "  LTRJ 002Ah 2 346Eh 8000    all three, absolute; STT starts the move\n"
    "  LTRJ 1828h 11h 20C4Ah      velocity mode, forward\n"
    "  LTRJ 0400h                 stop smoothly\n";
constexpr char kStatusHelp[] =
    "bit 7 motor off, 6 breakpoint, 5 position error, 4 wraparound, 3 index pulse,\n"
    "2 trajectory complete, 1 command error, 0 busy; 1 to 6 hold until RSTI clears them.\n";
constexpr char kConverterHelp[] =
    "The converter of this machine latches 12 bits by their strobes: the motor needs PORT12.\n";
constexpr char kWaitHelp[] =
    "  wait 0.5 s           also ms, us, and samples of 256 us\n"
    "  wait hi              until the pin HI is high\n"
    "  wait complete        until status bit 2 is set, read every sample; a bit that is still set\n"
    "                       from before counts: RSTI 0 clears it\n"
    "  wait breakpoint      the same of bit 6; SBPA or SBPR arms it\n"
    "  wait index           the same of bit 3; SIP arms it\n"
    "  wait error           the same of bit 5, the position error; LPEI or LPES sets its limit\n"
    "  wait complete 5 s    for at most 5 s; the default is 60 s\n";
constexpr char kRepeatHelp[] =
    "The lines up to `end` are executed so many times, 1 to 10000; blocks may hold blocks. Up to\n"
    "the end of its last block a script executes at most 10000 lines.\n"
    "  repeat 4\n"
    "  LTRJ 0003h 50\n"
    "  STT\n"
    "  wait 0.3 s\n"
    "  end\n";
constexpr char kTorqueHelp[] =
    "From here on, in place of motor.external_torque_N_m; -10 to 10 N m.\n"
    "  torque 0.01          against positive motion\n"
    "  torque 0\n";
constexpr char kPortHelp[] =
    "One access of the port, whether the part is busy or not: c is PS low, d is PS high.\n";

}  // namespace

const std::vector<Command>& commands() {
  using Op = sw::Lm628Command;
  constexpr std::int64_t kCoefficient = 0x7FFF;
  constexpr std::int64_t kRate = 0x3FFFFFFF;
  constexpr std::int64_t kReach = std::int64_t{1} << 30;
  static const Field control{"control", 16, 0, 0xFFFF};
  static const Field mask{"mask", 16, 0, 0xFFFF};
  static const Field threshold{"threshold", 16, 0, kCoefficient};
  static const Field position{"position", 32, -kReach, kReach - 1};
  static const Field distance{"distance", 32, -kReach, kReach - 1};
  static const Reply counts{32, "counts"};
  static const std::vector<Command> all{
      {"RESET", "like a low RST; then waits 1.5 ms", Op::kReset},
      {"PORT8", "output of 8 bits", Op::kPort8},
      {"PORT12", "output of 12 bits", Op::kPort12, {}, {}, kConverterHelp},
      {"DFH", "define the present position as 0", Op::kDfh},
      {"SIP", "take the position at the next index pulse", Op::kSip},
      {"LPEI", "position error that interrupts", Op::kLpei, {threshold}},
      {"LPES", "position error that stops the motor", Op::kLpes, {threshold}},
      {"SBPA", "breakpoint", Op::kSbpa, {position}},
      {"SBPR", "breakpoint, relative to the target", Op::kSbpr, {distance}},
      {"MSKI", "1: this status bit may interrupt", Op::kMski, {mask}, {}, kStatusHelp},
      {"RSTI", "0: clear this status bit; HI goes low", Op::kRsti, {mask}, {}, kStatusHelp},
      {"LFIL", "load the filter", Op::kLfil,
       {control, {"kp", 16, 0, kCoefficient, 8}, {"ki", 16, 0, kCoefficient, 4},
        {"kd", 16, 0, kCoefficient, 2}, {"il", 16, 0, kCoefficient, 1}}, {}, kFilterHelp},
      {"UDF", "use the loaded filter", Op::kUdf},
      {"LTRJ", "load a trajectory", Op::kLtrj,
       {control, {"acceleration", 32, 0, kRate, 0x20, "acceleration"},
        {"velocity", 32, 0, kRate, 0x08, "velocity"},
        {"position", 32, -kReach, kReach - 1, 0x02, "distance"}}, {}, kTrajectoryHelp},
      {"STT", "start the loaded trajectory", Op::kStt},
      {"RDSTAT", "status byte", {}, {}, {8}, kStatusHelp, Action::kRead},
      {"RDSIGS", "signals register", Op::kRdsigs, {}, {16}},
      {"RDIP", "index position", Op::kRdip, {}, counts},
      {"RDDP", "desired position", Op::kRddp, {}, counts},
      {"RDRP", "real position", Op::kRdrp, {}, counts},
      {"RDDV", "desired velocity", Op::kRddv, {}, {32, "counts/sample", 16}},
      {"RDRV", "real velocity", Op::kRdrv, {}, {16, "counts/sample"}},
      {"RDSUM", "sum of the errors", Op::kRdsum, {}, {16, "256 counts"}},
      {"byte", "write one byte at the port, busy or not", {}, {{"byte", 8, 0, 0xFF}}, {}, kPortHelp,
       Action::kWrite, {"c", "d"}, "c|d byte"},
      {"read", "read one byte at the port, busy or not", {}, {}, {8, ""}, kPortHelp, Action::kRead,
       {"c", "d"}, "c|d"},
      {"rst", "strobe the pin RST; then wait 1.5 ms", {}, {}, {}, "", Action::kReset},
      {"wait", "let simulated time pass", {}, {}, {}, kWaitHelp, Action::kWait,
       {"hi", "complete", "breakpoint", "index", "error"}, "time | event [time]"},
      {"torque", "load of the shaft from here on, in N m", {}, {}, {}, kTorqueHelp,
       Action::kTorque, {}, "number"},
      {"repeat", "execute the lines up to end so many times", {}, {{"count", 16, 1, kMostLines}},
       {}, kRepeatHelp, Action::kRepeat},
      {"end", "of the lines of repeat", {}, {}, {}, kRepeatHelp, Action::kEnd},
      {"status", "status byte and signals, by name", {}, {}, {}, kStatusHelp, Action::kStatus},
      {"pins", "HI, encoder, converter, and the motor behind them", {}, {}, {}, "", Action::kPins},
      {"help", "all commands, or one in detail", {}, {}, {}, "", Action::kHelp, {}, "[mnemonic]"},
      {"quit", "end", {}, {}, {}, "", Action::kQuit},
      {"exit", "end", {}, {}, {}, "", Action::kQuit}};
  return all;
}

}  // namespace trammel::an693
