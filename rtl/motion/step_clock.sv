// SPDX-License-Identifier: Apache-2.0
//
// The free-running clock of 240 kHz of a stepper interface (Larson 1974, section II), from any
// fabric clock by exact fractional division: 240 kHz / fabric = Inc / Mod, 3 / 625 at 50 MHz.
//
//   acc' = acc + Inc (1 + leap)  mod Mod;   a tick wherever it wraps
//
// A tick is high in the clock before the edge that acts on it; it comes within one clock of its
// exact time, and on average exactly. half_o marks the edge that is half a period behind a tick.
// Inc is at most Mod / 4, Mod / Inc 4095, and Mod + 4096 Inc below 2^32: any clock of whole hertz
// from 960 kHz to 982 MHz.

module step_clock
  import trammel_pkg::*;
  import step_pkg::*;
#(
    parameter int unsigned Inc = 3,
    parameter int unsigned Mod = 625
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    output logic tick_o,       // the present edge, by itself, is a tick
    output logic half_o,       // or half a period behind one
    output gap_t ticks_o,      // ticks in all clocks that the present edge stands for
    output gap_t next_tick_o,  // clocks before that of the next tick
    output gap_t next_half_o,  // the same, where half_o comes before it
    output logic quiescent_o
);

  localparam int unsigned Width = $clog2(Mod);
  localparam int unsigned Wide = $clog2(Mod + Inc * 4096);
  localparam int unsigned MaxTicks = (Mod - 1 + Inc * 4096) / Mod;
  localparam int unsigned Half = Mod / 2;

  logic [Width-1:0] acc_q;
  logic [Wide-1:0] acc, sum;
  logic [Width-1:0] acc_d;
  logic first;  // half of the period

  assign acc    = Wide'(acc_q);
  assign sum    = acc + Wide'(Inc) + Wide'(times_wide(32'(leap_i), 32'(Inc)));
  assign first  = acc < Wide'(Half);

  assign tick_o = acc >= Wide'(Mod - Inc);
  assign half_o = first && acc >= Wide'(Half - Inc);

  // Whole periods in what a leap adds up to: a bit for each.
  logic [MaxTicks:1] whole;
  for (genvar k = 1; k <= MaxTicks; k++) begin : gen_whole
    assign whole[k] = sum >= Wide'(k * Mod);
  end

  // Without a leap there is one tick or none.
  assign ticks_o = leap_i == '0 ? gap_t'(tick_o) : gap_t'($countones(whole));
  assign acc_d   = Width'(sum - Wide'(times_wide(32'(ticks_o), 32'(Mod))));

  always_ff @(posedge clk_i) begin
    if (rst_i) acc_q <= '0;
    else acc_q <= acc_d;
  end

  assign next_tick_o = gap_t'((Wide'(Mod - 1) - acc) / Wide'(Inc));
  assign next_half_o = first ? gap_t'((Wide'(Half - 1) - acc) / Wide'(Inc)) : next_tick_o;
  assign quiescent_o = 1'b1;

endmodule
