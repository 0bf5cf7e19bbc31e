// SPDX-License-Identifier: Apache-2.0
//
// Times, bits and commands of the LM628 (data sheet SNVS781C), and the instructions of its engine.
//
// An instruction has 18 bits:
//   1 p cccccc tttttttttt   go to t if condition c is p
//   0 ooooo aaaaaaaaaaaa    operation o with argument a
// Argument of memory operations: {count - 1, address} with 6 bits each; count is the number of
// clocks that Mul, Div and Shl take.

package lm628_pkg;

  // Clocks of the fabric for so many ticks of the part's clock, inc ticks in 25 clocks: in 50 MHz,
  // inc = 4 is 8 MHz and 3 is 6 MHz; in 20 MHz, 10 is 8 MHz.
  function automatic int unsigned lm628_clocks(int unsigned inc, int unsigned ticks);
    return (25 * ticks + inc - 1) / inc;
  endfunction

  localparam int unsigned Lm628Run = 128;  // [clk] for the execution of a command

  // Opcodes that the host port treats differently from the others.
  localparam logic [7:0] CmdReset = 8'h00;
  localparam logic [7:0] CmdSip   = 8'h03;
  localparam logic [7:0] CmdMski  = 8'h1C;
  localparam logic [7:0] CmdRsti  = 8'h1D;
  localparam logic [7:0] CmdLfil  = 8'h1E;
  localparam logic [7:0] CmdLtrj  = 8'h1F;

  // Clock domains of lm628: registers of one move only at edges at which it is awake. The timers
  // have the free-running clock and are in none.
  typedef struct packed {
    logic sense;   // encoder
    logic engine;
    logic system;  // the others
  } domains_t;

  typedef logic [6:1] events_t;  // bits of the status byte
  localparam int unsigned EventError = 1;

  typedef logic signed [63:0] lm628_t;  // the engine's registers

  // Those from 8 on write the accumulator, those from 16 on take several clocks.
  typedef enum logic [4:0] {
    OpHalt  = 5'd0,
    OpSt    = 5'd1,   // m = acc
    OpFlag  = 5'd2,   // flag a[4:0] = a[5]
    OpCall  = 5'd3,   // go to a, keep the return address
    OpRet   = 5'd4,
    OpOut   = 5'd5,   // the sample's result: acc, events, motor off, port width
    OpReply = 5'd6,   // reply = acc
    OpAdd   = 5'd8,   // acc = acc + m
    OpSub   = 5'd9,   // acc = acc - m
    OpShr8  = 5'd10,  // acc = acc / 256, rounded down
    OpExt   = 5'd11,  // acc = its low bits, see ext_e
    OpLd    = 5'd12,  // acc = m
    OpToq   = 5'd13,  // multiplier or dividend = acc, 30 bits; acc = 0
    OpIn    = 5'd14,  // acc = input word, chosen by source_e in the upper bits of the argument
    OpToq15 = 5'd15,  // multiplier = acc, 15 bits, for 15 steps of Mul; acc = 0
    OpMul   = 5'd16,  // acc = 2 acc, + m if the multiplier's next bit is 1; 30 steps restore it
    OpDiv   = 5'd17,  // acc = 2 acc + the dividend's next bit, - m if it fits; a quotient bit
    OpShl   = 5'd18   // acc = 2 acc
  } op_e;

  typedef enum logic [5:0] {
    CondAlways = 6'd0,
    CondN      = 6'd1,   // acc is negative
    CondZ      = 6'd2,   // acc is 0
    CondWrap   = 6'd3,   // products wrap
    CondTake   = 6'd4,   // an index was captured
    CondBit    = 6'd16,  // and the 15 after it: a bit of acc
    CondFlag   = 6'd32   // and the 31 after it: a flag
  } cond_e;

  typedef enum logic [2:0] {
    FromNumber,   // a[8:0]
    FromWord,     // the command's next word
    FromCount,    // encoder
    FromIndex,    // encoder at the index
    FromSignals
  } source_e;

  typedef enum logic [2:0] {
    ExtZ15,
    ExtS16,
    ExtS24,
    ExtZ30,
    ExtS31,
    ExtS32,
    ExtS48
  } ext_e;

  // 0 and 7 to 14 are bits of the signals register, 1 to 6 events of the status byte.
  typedef enum logic [4:0] {
    FlagIndexArmed,
    FlagError,
    FlagComplete,
    FlagIndex,
    FlagWraparound,
    FlagPositionError,
    FlagBreakpoint,
    FlagOff,
    FlagEightBits,
    FlagOffOnError,
    FlagOnTarget,
    FlagVelocityMode,
    FlagForward,
    FlagFilter,
    FlagAcceleration,
    FlagMoving,
    FlagRelative,      // the next STT adds the loaded position to the target
    FlagSmooth,        // the move is a smooth stop
    FlagVelocity,      // the move is in velocity mode
    FlagArmed,         // a breakpoint is set
    FlagAbove,         // it was above the position when set
    FlagBelow,         // it was below the position when set
    FlagUp             // the target is above
  } flag_e;

  localparam int unsigned Flags = 23;

endpackage
