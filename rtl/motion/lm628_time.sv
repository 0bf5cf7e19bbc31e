// SPDX-License-Identifier: Apache-2.0
//
// Timing of the LM628 (data sheet SNVS781C): 8000 ticks of its clock for the reset routine, then
// samples of 2048 ticks, in clocks of the fabric. Inc ticks are 25 clocks: 4 for 8 MHz and 3 for
// 6 MHz in a 50 MHz fabric, 10 for 8 MHz in one of 20 MHz. One timer goes through the parts of a
// sample; at 8 MHz in 50 MHz, with tick 0 at clock 0:
//
//   clock  10           sample_o, when every edge of tick 0 has been counted
//   clocks 2371..12670  open_o: a command begun then ends in ticks 400..2047
//   clock  2499         commit_o: the results are visible from tick 400 on

module lm628_time
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,       // of the timers; gated for the other registers
    input logic clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    output logic begin_o,   // the last clock of the reset routine
    output logic ready_o,   // it is over
    output logic sample_o,
    output logic open_o,
    output logic commit_o,
    output gap_t next_o,
    output logic quiescent_o
);

  logic clk_gated;
  assign clk_gated = clk_i & clock_en_i;

  localparam int unsigned Ticks = 25 * 2048;             // of a sample, in 1/Inc clocks
  localparam int unsigned Lead = 24 / Inc + 4;           // last clock of tick 0, and encoder delay
  localparam int unsigned Commit = lm628_clocks(Inc, 400);

  localparam int unsigned RestBits = $clog2(Inc);
  typedef logic [RestBits-1:0] rest_t;
  localparam rest_t Rest = rest_t'(Ticks % Inc);
  localparam rest_t FirstRest = rest_t'((25 * 8000 + Inc - 1) % Inc);  // the reset routine's

  typedef logic [16:0] clocks_t;  // 8000 ticks of 6 MHz are 66 667
  localparam clocks_t Reset   = clocks_t'(lm628_clocks(Inc, 8000) - 2);
  localparam clocks_t First   = clocks_t'(Lead);
  localparam clocks_t Before  = clocks_t'(Lm628Run + 1 + Lead);
  localparam clocks_t Compute = clocks_t'(Commit - Lm628Run - 3 - Lead);
  localparam clocks_t Settle  = clocks_t'(Lm628Run);
  localparam clocks_t Open    = clocks_t'(Ticks / Inc - Commit - Lm628Run - 2);

  typedef enum logic [2:0] {
    StStart,
    StReset,
    StBefore,   // until the sample
    StCompute,  // until a command may begin
    StSettle,   // until the commit
    StOpen      // until a command would end too late
  } state_e;

  state_e state_d, state_q;
  clocks_t count, value;
  logic last;
  rest_t rest_d, rest_q;  // Inc - 1 less what the times so far were rounded up by, in 1/Inc
  logic [RestBits:0] rest;
  logic longer;

  timer #(
      .Width(17)
  ) u_part (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (last),
      .value_i(value),
      .count_o(count),
      .next_o (next_o)
  );

  assign last   = count == '0;
  assign rest   = {1'b0, rest_q} + {1'b0, Rest};
  assign longer = 32'(rest) >= Inc;

  always_comb begin
    state_d = state_q;
    value   = Settle;
    rest_d  = rest_q;
    if (last) begin
      unique case (state_q)
        StStart: begin
          state_d = StReset;
          value   = Reset;
        end
        StReset: begin
          state_d = StBefore;
          value   = First;
        end
        StBefore: begin
          state_d = StCompute;
          value   = Compute;
        end
        StCompute: state_d = StSettle;
        StSettle: begin
          state_d = StOpen;
          value   = Open;
        end
        default: begin  // StOpen
          state_d = StBefore;
          value   = Before + clocks_t'(longer);
          rest_d  = longer ? rest_t'(32'(rest) - Inc) : rest_t'(rest);
        end
      endcase
    end
  end

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      state_q <= StStart;
      rest_q  <= FirstRest;
    end else begin
      state_q <= state_d;
      rest_q  <= rest_d;
    end
  end

  assign begin_o     = state_q == StReset && last;
  assign ready_o     = state_q != StStart && state_q != StReset;
  assign open_o      = state_q == StSettle || state_q == StOpen;
  assign sample_o    = state_q == StBefore && last;
  assign commit_o    = state_q == StSettle && last;
  assign quiescent_o = !last;

endmodule
