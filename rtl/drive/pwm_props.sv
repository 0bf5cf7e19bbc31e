// SPDX-License-Identifier: Apache-2.0
//
// Properties of pwm for any compare values, in every phase of the period that timebase makes.

module pwm_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input phase_t phase_i,
    input phase_t rest_i,
    input logic        load_i,

    input logic enable_i,

    input cmp_t cmp_a_i,
    input cmp_t cmp_b_i,
    input cmp_t cmp_c_i,

    input logic [2:0] on_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input cmp_t cmp_a_q,
    input cmp_t cmp_b_q,
    input cmp_t cmp_c_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, enable_q;
  logic period_q;  // the previous phase was within the period
  logic [2:0] was_on_q, above, above_q;  // carrier > compare value; at the previous edge
  cmp_t [2:0] cmp_q;  // c, b, a, taken at the latest load
  logic [35:0] state, was_state_q;
  phase_t phase_q, rest_q, period;
  gap_t was_next_q;
  logic calm;  // inputs as at the previous edge, except for the next phase

  // From 0 up to half the period and down to 1.
  function automatic phase_t carrier(phase_t phase, phase_t whole);
    return {phase, 1'b0} <= {1'b0, whole} ? phase : whole - phase;
  endfunction

  assign period = phase_i + rest_i;

  for (genvar n = 0; n < 3; n++) begin : gen_phase
    assign above[n] = carrier(phase_i, period) > 13'(cmp_q[n]);
  end

  assign state = {cmp_c_q, cmp_b_q, cmp_a_q};
  assign calm  = was_quiescent_q && enable_i == enable_q && !load_i && !rst_i && period >= rest_i &&
      rest_i == rest_q - 13'd1 && phase_i == phase_q + 13'd1 && rest_i != '0 && phase_i != '0 &&
      was_next_q >= 12'd2;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    enable_q        <= !rst_i && enable_i;
    period_q        <= period >= rest_i && phase_i < period;
    above_q         <= above;
    was_on_q        <= on_o;
    was_state_q     <= state;
    phase_q         <= phase_i;
    rest_q          <= rest_i;
    was_next_q      <= next_o;
    if (rst_i) begin
      cmp_q <= '1;
    end else if (load_i) begin
      cmp_q <= {cmp_c_i, cmp_b_i, cmp_a_i};
    end
    if (live_q) begin
      off_from_reset : assert (!was_rst_q || on_o == '0);
      off_when_disabled : assert (enable_q || on_o == '0);
      carrier_above_compare : assert (!enable_q || !period_q || on_o == above_q);
      values_change_at_load_only : assert (state == cmp_q);
      off_at_phase_zero : assert (was_rst_q || phase_q != '0 || on_o == '0);
      next_falls_by_one_at_most : assert (!calm || next_o >= was_next_q - 12'd1);
      next_is_quiet : assert (!calm || quiescent_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || (on_o == was_on_q && state == was_state_q));
      reaches_on : cover (on_o == 3'b101);
      reaches_last_phase : cover (on_o == 3'b111 && rest_q == 13'd2);
      reaches_calm : cover (calm && on_o != '0 && next_o == 12'd100);
    end
  end

  // breaks off_from_reset: on_q <= on_d
  // breaks off_when_disabled: on_d = enable_i ? on_d : on_q
  // breaks carrier_above_compare: on_d = on_d | {1'b0, enable_i && phase_i > 13'(cmp_b_q), 1'b0}
  // breaks carrier_above_compare: on_d = on_d & {1'b1, rest_i > 13'(cmp_b_q) + 13'd1, 1'b1}
  // breaks values_change_at_load_only: cmp_a_q <= phase_i == '0 && !rst_i ? cmp_a_i : next
  // breaks off_at_phase_zero: on_d = on_d | {enable_i && phase_i >= 13'(cmp_c_q), 2'b00}
  // breaks next_is_quiet: next_o = next_o == GapMax ? next_o : next_o + 12'd1
  // breaks next_falls_by_one_at_most: next_o = phase_i <= rest_i ? next_o << 1 : next_o
  // breaks quiescent_is_honest: quiescent_o = on_d == on_q

endmodule

bind pwm pwm_props u_pwm_props (.*);
