// SPDX-License-Identifier: Apache-2.0
//
// Ticks of any rate from any fabric clock, exact on average: a period is Clock / Rate clocks,
// rounded down or up, and what is lost by that is carried to the next one.
//
//   rest' = rest + Clock mod Rate, mod Rate;   period = Clock div Rate + (1 where rest wrapped)
//
// A tick is high in the clock before the edge that acts on it. The first period begins with the
// first clock after reset. Clock and Rate are in Hz; their quotient is 2 to 2^24 - 1.

module rate_tick
  import trammel_pkg::*;
#(
    parameter int unsigned Clock = 50_000_000,
    parameter int unsigned Rate = 4612
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    output logic tick_o,
    output gap_t next_o,
    output logic quiescent_o
);

  localparam int unsigned Whole = Clock / Rate;
  localparam int unsigned Rest = Clock % Rate;
  localparam int unsigned Width = $clog2(Whole + 2);
  localparam int unsigned RestWidth = $clog2(2 * Rate);

  logic [RestWidth-1:0] rest_d, rest_q, sum;
  logic [Width-1:0] count;
  logic load, carry;

  assign tick_o = count == Width'(1);
  assign load   = count == '0 || tick_o;
  assign sum    = rest_q + RestWidth'(Rest);
  assign carry  = sum >= RestWidth'(Rate);
  assign rest_d = carry ? sum - RestWidth'(Rate) : sum;

  timer #(
      .Width(Width)
  ) u_period (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (load),
      .value_i(Width'(Whole) + Width'(carry)),
      .count_o(count),
      .next_o (next_o)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) rest_q <= '0;
    else if (load) rest_q <= rest_d;
  end

  assign quiescent_o = !load;

endmodule
