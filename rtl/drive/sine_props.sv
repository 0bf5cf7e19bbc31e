// SPDX-License-Identifier: Apache-2.0
//
// Properties of sine for any input. The values of the table are checked against the twin.

module sine_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input angle_t angle_i,

    input logic  valid_o,
    input word_t sin_o,
    input word_t cos_o,
    input logic  quiescent_o,

    input logic   [ 1:0] state_q,
    input angle_t        angle_q,
    input logic   [11:0] magnitude_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic start;
  logic [3:0] due_q;  // angles in flight, the oldest in the highest bit
  angle_t took_q;  // angle of the tick
  logic [47:0] state, was_state_q;

  assign start = tick_i && due_q[2:0] == '0;
  assign state = {state_q, angle_q, magnitude_q, sin_o, cos_o};

  // The sign of a sine: that of the half revolution, 0 at its ends.
  function automatic logic signed_as(word_t value, angle_t angle);
    return angle[8:0] == '0 ? value == '0 : angle[9] ? value < 12'sd0 : value > 12'sd0;
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    due_q           <= rst_i ? '0 : {due_q[2:0], start};
    if (start) took_q <= angle_i;
    if (live_q) begin
      valid_after_4_clocks : assert (valid_o == due_q[3]);
      signs_of_the_quadrant :
      assert (!valid_o || (signed_as(sin_o, took_q) && signed_as(cos_o, took_q + 10'd256)));
      crest_is_full_scale :
      assert (!valid_o || took_q[8:0] != 9'd256 || sin_o == (took_q[9] ? -12'sd2048 : 12'sd2047));
      minus_one_only_near_its_crest :
      assert (!valid_o || sin_o != -12'sd2048 || (took_q >= 10'd765 && took_q <= 10'd771));
      outputs_hold :
      assert (was_rst_q || valid_o || due_q[2] || state[23:0] == was_state_q[23:0]);
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_state :
      assert (state_q == (due_q[0] ? 2'd1 : due_q[1] ? 2'd2 : due_q[2] ? 2'd3 : 2'd0));
      inv_one : assert ((due_q[2:0] & (due_q[2:0] - 3'd1)) == '0);
      inv_angle : assert (due_q[2:0] == '0 || angle_q == took_q);
      reaches_crest : cover (valid_o && sin_o == -12'sd2048 && cos_o == 12'sd0);
    end
  end

  // prove: depth 5

  // breaks valid_after_4_clocks: state_d = state_q == StReadSin && !angle_q[0] ? StLast : state_d
  // breaks signs_of_the_quadrant: value = value_angle[8] ? -$signed(magnitude) : magnitude[11] ? 12'sd2047 : $signed(magnitude)
  // breaks signs_of_the_quadrant: value_angle = state_q == StLast ? angle_q - 10'd256 : value_angle
  // breaks crest_is_full_scale: magnitude = value_angle[8:0] == 9'd256 ? 12'd2047 : magnitude_q
  // breaks minus_one_only_near_its_crest: value = value_angle[9] ? value : $signed(magnitude)
  // breaks outputs_hold: cos_d = state_q == StIdle && tick_i ? '0 : cos_d
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle && !valid_q

endmodule

bind sine sine_props u_sine_props (
    .*,
    .state_q(state_q)  // no .* for an enum
);
