// SPDX-License-Identifier: Apache-2.0
//
// Properties of precision_knots for any input.

module precision_knots_props (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,
    input logic tick_pos_i,
    input logic commit_i,
    input logic off_i,

    input logic knot_o,
    input logic taken_o,
    input logic coast_o,
    input logic hold_o,
    input logic underrun_o,
    input logic quiescent_o,

    input logic       active_q,
    input logic       pending_q,
    input logic [4:0] tick_q,
    input logic [1:0] missed_q
);

  logic live_q = 1'b0;
  logic [5:0] since_q;  // ticks since the last knot, that one included
  logic any_q, wait_q;  // a knot since the reset, a COMMIT that waits
  logic [1:0] lost_q;   // knots in a row without a COMMIT, 3 or more as 3
  logic was_knot_q, was_wait_q, was_other_q, was_quiet_q, was_off_q;
  logic [11:0] held, was_held_q;

  assign held = {active_q, pending_q, tick_q, missed_q, taken_o, coast_o, hold_o};

  always_ff @(posedge clk_i) begin
    was_knot_q  <= knot_o && !rst_i;
    was_other_q <= (tick_i && !knot_o || off_i) && !rst_i;
    was_wait_q  <= wait_q;
    was_quiet_q <= quiescent_o && !rst_i;
    was_off_q   <= off_i;
    was_held_q  <= held;
    if (rst_i) live_q <= 1'b1;
    if (rst_i || off_i) begin
      {any_q, wait_q} <= '0;
      lost_q          <= '0;
      since_q         <= '0;
    end else begin
      wait_q <= commit_i || wait_q && !knot_o;
      if (knot_o) begin
        any_q   <= 1'b1;
        since_q <= 6'd1;
        lost_q  <= wait_q ? '0 : lost_q == '1 ? lost_q : lost_q + 2'd1;
      end else if (tick_i && any_q) begin
        since_q <= since_q + 6'd1;
      end
    end
    if (live_q) begin
      a_knot_every_32_ticks :
      assert (!tick_i || off_i || !any_q || knot_o == (since_q == 6'd32));
      the_first_knot_is_at_2_khz_after_a_commit :
      assert (!tick_i || off_i || any_q || knot_o == (wait_q && tick_pos_i));
      no_knot_without_a_tick_or_in_reset : assert (!knot_o || tick_i && !off_i);
      a_commit_is_taken_by_the_next_knot : assert (!was_knot_q || taken_o == was_wait_q);
      without_one_twice_constant_speed_then_none :
      assert (!was_knot_q || was_wait_q || {coast_o, hold_o} == (lost_q <= 2'd2 ? 2'b10 : 2'b01));
      other_ticks_are_no_knots : assert (!was_other_q || {taken_o, coast_o, hold_o} == '0);
      underrun_is_a_knot_without_a_commit : assert (underrun_o == (knot_o && !wait_q));
      in_reset_nothing_wakes_it : assert (!was_off_q || !off_i || quiescent_o);
      quiescent_is_honest : assert (!was_quiet_q || held == was_held_q);

      inv_knots :
      assert (active_q == any_q && pending_q == wait_q && since_q <= 6'd32 &&
          (!any_q || since_q == 6'(tick_q) + 6'd1) && missed_q == (lost_q == '1 ? 2'd2 : lost_q));
      inv_taken : assert (3'(taken_o) + 3'(coast_o) + 3'(hold_o) <= 3'd1);

      reaches_a_knot_that_stops : cover (hold_o);
      reaches_a_commit_after_it : cover (taken_o && any_q && was_knot_q);
    end
  end

  // breaks a_knot_every_32_ticks: LastTick = 5'd30
  // breaks the_first_knot_is_at_2_khz_after_a_commit: knot_o = tick_i && !off_i && (active_q ? tick_q == LastTick : pending_q)
  // breaks no_knot_without_a_tick_or_in_reset: knot_o = tick_i && (active_q ? tick_q == LastTick : pending_q && tick_pos_i)
  // breaks a_commit_is_taken_by_the_next_knot: taken_d = knot_o && !off_i && (pending_q || commit_i)
  // breaks without_one_twice_constant_speed_then_none: missed_d = knot_o ? '0 : missed_d
  // breaks without_one_twice_constant_speed_then_none: coast_d = knot_o && !off_i && !pending_q && missed_q == '0
  // breaks other_ticks_are_no_knots: taken_d = knot_o ? taken_d : taken_q && !off_i
  // breaks underrun_is_a_knot_without_a_commit: underrun_o = knot_o && !pending_q && !commit_i
  // breaks in_reset_nothing_wakes_it: quiescent_o = quiescent_o && !commit_i
  // breaks quiescent_is_honest: quiescent_o = !tick_i && !off_i

endmodule

bind precision_knots precision_knots_props u_precision_knots_props (.*);

// prove: frames 120
