// SPDX-License-Identifier: Apache-2.0
//
// Promises of gate_leg under any input whatever, leaps apart.

module gate_leg_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       enable_i,
    input logic       trip_i,
    input logic [9:0] dead_time_i,

    input logic on_i,

    input logic hi_o,
    input logic lo_o,

    input logic       allowed_q,
    input logic       side_q,
    input logic       change,
    input logic [9:0] count
);

  // Edges since either gate was last on, counted to the largest dead time and no further.
  localparam logic [9:0] Long = 10'd1023;
  logic live_q = 1'b0;
  logic told_off_q, swap_q;
  logic [9:0] since_hi_q, since_lo_q, dead_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    told_off_q <= rst_i || !enable_i || trip_i;
    swap_q     <= leap_i != '0;
    if (rst_i) begin
      since_hi_q <= Long;
      since_lo_q <= Long;
      dead_q     <= '0;
    end else begin
      if (hi_o) since_hi_q <= '0;
      else if (since_hi_q != Long) since_hi_q <= since_hi_q + 10'd1;
      if (lo_o) since_lo_q <= '0;
      else if (since_lo_q != Long) since_lo_q <= since_lo_q + 10'd1;
      if (change) dead_q <= dead_time_i;
    end
    if (live_q) begin
      no_shoot_through : assert (!(hi_o && lo_o));
      off_when_told : assert (!told_off_q || (!hi_o && !lo_o));
      inv_high_side : assert (!hi_o || side_q);
      inv_low_side : assert (!lo_o || !side_q);
      reaches_high : cover (hi_o);
      reaches_low : cover (lo_o && since_hi_q < 10'd9);
    end
  end

  // breaks no_shoot_through: assign lo_d  = ready && !on_i; => assign lo_d  = ready;
  // breaks off_when_told: assign allowed = enable_i && !trip_i; => assign allowed = enable_i;

endmodule

bind gate_leg gate_leg_props u_gate_leg_props (.*);
