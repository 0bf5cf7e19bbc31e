// SPDX-License-Identifier: Apache-2.0
//
// Properties of supervisor for any input; the synchroniser of the pin is modelled separately.

module supervisor_props (
    input logic clk_i,
    input logic rst_i,

    input logic [31:0] tick_count_i,

    input logic [1:0] enabled_i,
    input logic       clear_i,

    input logic       trip_pin_i,
    input logic [1:0] over_current_i,
    input logic       watchdog_i,
    input logic [1:0] encoder_i,
    input logic [1:0] stroke_i,

    input logic        trip_o,
    input logic [ 3:0] fault_code_o,
    input logic        fault_axis_o,
    input logic [31:0] fault_tick_o,
    input logic        quiescent_o,

    input logic meta_q,
    input logic pin_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_trip_q, was_quiescent_q, may_clear_q;
  logic first_q, second_q;  // flip-flops of the pin
  logic [5:1] cause, cause_q;  // by code
  logic axis, axis_q;
  logic [31:0] tick_count_q;
  logic [38:0] state, was_state_q;  // all registers except the trip

  assign cause = {stroke_i != '0, encoder_i != '0, watchdog_i, over_current_i != '0, second_q};
  assign state = {meta_q, pin_q, fault_code_o, fault_axis_o, fault_tick_o};

  // The axis of the lowest cause; X when both have it.
  always_comb begin
    axis = 1'b0;
    if (cause[5] && cause[4:1] == '0) axis = stroke_i == 2'b10;
    if (cause[4] && cause[3:1] == '0) axis = encoder_i == 2'b10;
    if (cause[2] && !cause[1]) axis = over_current_i == 2'b10;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_trip_q      <= trip_o;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    first_q         <= !rst_i && trip_pin_i;
    second_q        <= !rst_i && first_q;
    cause_q         <= cause;
    axis_q          <= axis;
    tick_count_q    <= tick_count_i;
    may_clear_q     <= clear_i && enabled_i == '0 && cause == '0;
    if (live_q) begin
      no_trip_from_reset : assert (!was_rst_q || (!trip_o && fault_code_o == '0));
      trips_at_the_next_clock : assert (was_rst_q || cause_q == '0 || trip_o);
      trips_only_for_a_cause : assert (!trip_o || was_trip_q || cause_q != '0);
      latched_until_cleared : assert (was_rst_q || !was_trip_q || trip_o || may_clear_q);
      clears_when_it_may : assert (!was_trip_q || !may_clear_q || !trip_o);
      names_the_lowest_cause :
      assert (!trip_o || was_trip_q ||
              (cause_q[fault_code_o[2:0]] && fault_code_o >= 4'd1 && fault_code_o <= 4'd5 &&
               (cause_q & ((5'd1 << (fault_code_o - 4'd1)) - 5'd1)) == '0));
      names_the_axis : assert (!trip_o || was_trip_q || fault_axis_o == axis_q);
      keeps_the_tick : assert (!trip_o || was_trip_q || fault_tick_o == tick_count_q);
      first_fault_is_kept :
      assert (was_rst_q || !was_trip_q || !trip_o || state[36:0] == was_state_q[36:0]);
      no_trip_no_fault : assert (trip_o || state[36:0] == '0);
      quiescent_is_honest :
      assert (!was_quiescent_q || (trip_o == was_trip_q && state == was_state_q));
      inv_synchroniser : assert (meta_q == first_q && pin_q == second_q);
      reaches_trip_by_pin : cover (trip_o && fault_code_o == 4'd1);
      reaches_trip_of_y : cover (trip_o && fault_axis_o && fault_code_o == 4'd5);
      reaches_cleared : cover (!was_rst_q && was_trip_q && !trip_o);
    end
  end

  // breaks no_trip_from_reset: trip_q <= next || (rst_i && trip_q)
  // breaks trips_at_the_next_clock: pin_q <= next && pin_q
  // breaks trips_only_for_a_cause: present = meta_q || present
  // breaks latched_until_cleared: move = trip_q ? clear_i && !present : present
  // breaks latched_until_cleared: move = trip_q ? clear_i && enabled_i == '0 : present
  // breaks clears_when_it_may: trip_q <= next || (move && trip_q && axis_q && !rst_i)
  // breaks names_the_lowest_cause: cause = stroke_i[0] && !pin_q && over_current_i == '0 ? FaultWatchdog : cause
  // breaks names_the_axis: axis = cause == FaultEncoder ? encoder_i[1] : axis
  // breaks keeps_the_tick: tick_q <= move && !trip_q && !rst_i ? tick_count_i + 32'd1 : next
  // breaks first_fault_is_kept: code_q <= present && trip_q && !rst_i ? cause : next
  // breaks no_trip_no_fault: trip_o = trip_q && !clear_i
  // breaks quiescent_is_honest: quiescent_o = trip_pin_i == meta_q && !move

endmodule

bind supervisor supervisor_props u_supervisor_props (.*);
