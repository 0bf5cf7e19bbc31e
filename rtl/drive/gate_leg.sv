// SPDX-License-Identifier: Apache-2.0
//
// Gates of one half bridge with dead time (specification section 8).
//
//   edge E      on_i differs from the side in use: both gates off, dead time starts
//   edge E + D  the gate of the new side on, D = dead_time_i at edge E, 0 acts as 1
//
// trip_i, or enable_i low, turns both gates off at the next edge; coming back is a new E. A change
// of side within a dead time restarts it. A change of dead_time_i counts from the next E on.

module gate_leg
  import trammel_pkg::*;
(
    input logic clk_i,       // of the timer; gated for the other registers
    input logic clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       enable_i,
    input logic       trip_i,
    input logic [9:0] dead_time_i,

    input logic on_i,

    output logic hi_o,
    output logic lo_o,
    output gap_t next_o,
    output logic quiescent_o
);

  logic clk_gated;
  assign clk_gated = clk_i & clock_en_i;

  logic allowed, change, ready;
  logic allowed_q;  // allowed at the previous edge
  logic side_d, side_q;
  logic hi_d, lo_d, hi_q, lo_q;
  logic [9:0] count;

  assign allowed = enable_i && !trip_i;
  assign change  = !allowed_q || on_i != side_q;
  assign side_d  = allowed ? on_i : side_q;

  timer #(
      .Width(10)
  ) u_dead_time (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (allowed && change),
      .value_i(dead_time_i),
      .count_o(count),
      .next_o (next_o)
  );

  assign ready = allowed && !change && count < 10'd2;
  assign hi_d  = ready && on_i;
  assign lo_d  = ready && !on_i;

  always_ff @(posedge clk_gated) begin
    if (rst_i) begin
      allowed_q <= 1'b0;
      side_q    <= 1'b0;
      hi_q      <= 1'b0;
      lo_q      <= 1'b0;
    end else begin
      allowed_q <= allowed;
      side_q    <= side_d;
      hi_q      <= hi_d;
      lo_q      <= lo_d;
    end
  end

  assign hi_o = hi_q;
  assign lo_o = lo_q;

  assign quiescent_o =
      allowed == allowed_q && side_d == side_q && hi_d == hi_q && lo_d == lo_q;

endmodule
