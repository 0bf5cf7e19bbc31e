// SPDX-License-Identifier: Apache-2.0
//
// Promises of gate_leg under any input, leaps included where they do not count clocks.

module gate_leg_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic enable_i,
    input logic trip_i,

    input logic hi_o,
    input logic lo_o,

    input logic side_q
);

  logic live_q = 1'b0;
  logic told_off_q, was_hi_q, was_lo_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    told_off_q <= rst_i || !enable_i || trip_i;
    was_hi_q   <= hi_o;
    was_lo_q   <= lo_o;
    if (live_q) begin
      no_shoot_through : assert (!(hi_o && lo_o));
      off_when_told : assert (!told_off_q || (!hi_o && !lo_o));
      break_before_make : assert (rst_i || !(was_hi_q && lo_o) && !(was_lo_q && hi_o));
      inv_high_side : assert (!hi_o || side_q);
      inv_low_side : assert (!lo_o || !side_q);
      reaches_high : cover (hi_o);
      reaches_low : cover (lo_o && leap_i == '0);
    end
  end

  // breaks no_shoot_through: assign lo_d  = ready && !on_i; => assign lo_d  = ready;
  // breaks off_when_told: assign allowed = enable_i && !trip_i; => assign allowed = enable_i;
  // breaks break_before_make: assign ready = allowed && !change && => assign ready = allowed &&

endmodule

bind gate_leg gate_leg_props u_gate_leg_props (.*);
