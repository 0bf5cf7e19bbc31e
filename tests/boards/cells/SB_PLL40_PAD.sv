// SPDX-License-Identifier: Apache-2.0
//
// For simulation: a PLL whose clock is that of its pin, and which locks after 16 clocks.

module SB_PLL40_PAD #(
    parameter FEEDBACK_PATH = "SIMPLE",
    parameter DIVR = 4'd0,
    parameter DIVF = 7'd0,
    parameter DIVQ = 3'd0,
    parameter FILTER_RANGE = 3'd0
) (
    input  logic PACKAGEPIN,
    input  logic RESETB,
    input  logic BYPASS,
    output logic PLLOUTGLOBAL,
    output logic LOCK
);

  logic [4:0] count_q = '0;

  always_ff @(posedge PACKAGEPIN) if (!count_q[4]) count_q <= count_q + 5'd1;

  assign PLLOUTGLOBAL = PACKAGEPIN;
  assign LOCK         = count_q[4];

endmodule
