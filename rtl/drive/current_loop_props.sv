// SPDX-License-Identifier: Apache-2.0
//
// Properties of current_loop for any input: its schedule and its registers. The multipliers are
// free in the proof; what the blocks of the chain compute is proven with each of them.

module current_loop_props
  import trammel_pkg::*;
#(
    parameter int unsigned ClockHz = 50_000_000
) (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic        clear_i,
    input carrier_t    carrier_i,
    input logic [11:0] code_a_i,
    input logic [11:0] code_b_i,
    input word_t       offset_a_i,
    input word_t       offset_b_i,

    input logic  busy_o,
    input logic  valid_o,
    input cmp_t  cmp_a_o,
    input cmp_t  cmp_b_o,
    input cmp_t  cmp_c_o,
    input word_t i_a_o,
    input word_t i_b_o,
    input logic  quiescent_o,

    input logic [ 4:0] digit_q,
    input logic [31:0] theta_q,
    input cmp_t        cmp_a,
    input cmp_t        cmp_b,
    input cmp_t        cmp_c,

    // Progress of the blocks of the chain.
    input logic       clarke_valid,
    input logic       sine_valid,
    input logic       park_valid,
    input logic       pi_d_valid,
    input logic       pi_q_valid,
    input logic       limit_valid,
    input logic       inverse_valid,
    input logic       svpwm_valid,
    input logic       in_clarke,
    input logic [1:0] in_sine,
    input logic [2:0] in_park,
    input logic [2:0] in_pi_d,
    input logic [2:0] in_pi_q,
    input logic       in_limit,
    input logic [2:0] in_inverse,
    input logic [3:0] in_svpwm,
    input logic [3:0] in_division
);

  localparam cmp_t Centre16kHz = 12'(ClockHz / 32'd64_000);
  localparam cmp_t Centre8kHz  = 12'(ClockHz / 32'd32_000);
  localparam cmp_t Centre20kHz = 12'(ClockHz / 32'd80_000);
  localparam cmp_t Centre40kHz = 12'(ClockHz / 32'd160_000);

  carrier_t was_carrier_q;
  cmp_t centre;  // half the top of that carrier
  assign centre = was_carrier_q == 2'd1 ? Centre8kHz : was_carrier_q == 2'd2 ? Centre20kHz :
      was_carrier_q == 2'd3 ? Centre40kHz : Centre16kHz;

  logic live_q = 1'b0;
  logic was_rst_q, was_clear_q, was_quiescent_q;
  logic start;
  logic [67:0] due_q;  // samples in flight, the oldest in the highest bit
  logic took_q;
  word_t expected_a_q, expected_b_q;
  logic [35:0] cmp, was_cmp_q, new_q;
  logic [97:0] state, was_state_q;

  // Number of the state in a sequence of four, 0 = idle.
  function automatic logic [2:0] four(logic [3:0] due);
    return due[0] ? 3'd1 : due[1] ? 3'd2 : due[2] ? 3'd3 : due[3] ? 3'd4 : 3'd0;
  endfunction

  // Offset binary less an offset, within the range of a word.
  function automatic word_t less(logic [11:0] code, word_t offset);
    logic signed [13:0] current;
    current = $signed({2'b00, code}) - 14'sd2048 - 14'(offset);
    return current > 14'sd2047 ? 12'sd2047 : current < -14'sd2048 ? -12'sd2048 : current[11:0];
  endfunction

  assign start = tick_i && due_q[66:0] == '0;
  assign cmp   = {cmp_c_o, cmp_b_o, cmp_a_o};
  assign state = {busy_o, digit_q, theta_q, i_a_o, i_b_o, cmp};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_clear_q     <= clear_i && !rst_i;
    was_carrier_q   <= carrier_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    was_cmp_q       <= cmp;
    new_q           <= {cmp_c, cmp_b, cmp_a};
    due_q           <= rst_i ? '0 : {due_q[66:0], start};
    took_q          <= start && !rst_i;
    expected_a_q    <= less(code_a_i, offset_a_i);
    expected_b_q    <= less(code_b_i, offset_b_i);
    if (live_q) begin
      valid_after_68_clocks : assert (valid_o == due_q[67]);
      busy_until_valid : assert (busy_o == (due_q[66:0] != '0));
      centred_while_cleared : assert (!was_clear_q || cmp == {centre, centre, centre});
      new_values_with_valid : assert (!valid_o || was_clear_q || cmp == new_q);
      values_hold : assert (was_rst_q || was_clear_q || valid_o || cmp == was_cmp_q);
      code_less_offset :
      assert (!took_q || (i_a_o == expected_a_q && i_b_o == expected_b_q));
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_one : assert ((due_q[66:0] & (due_q[66:0] - 67'd1)) == '0);
      inv_angle : assert (due_q[18:0] == '0 || due_q[7'd18-7'(digit_q)]);
      inv_bit : assert (digit_q <= 5'd18 && (due_q[18:0] != '0 || digit_q == '0));
      inv_valid :
      assert ({clarke_valid, sine_valid, park_valid, pi_d_valid, pi_q_valid, limit_valid,
               inverse_valid, svpwm_valid} == {due_q[20], due_q[24], due_q[29], due_q[34],
               due_q[34], due_q[36], due_q[41], due_q[66]});
      inv_clarke : assert (in_clarke == due_q[19]);
      inv_sine : assert (3'(in_sine) == four({1'b0, due_q[23:21]}));
      inv_park : assert (in_park == four(due_q[28:25]));
      inv_pi : assert (in_pi_d == four(due_q[33:30]) && in_pi_q == in_pi_d);
      inv_limit : assert (in_limit == due_q[35]);
      inv_inverse : assert (in_inverse == four(due_q[40:37]));
      inv_svpwm :
      assert (in_svpwm == (due_q[63:50] != '0 ? 4'd9 : due_q[64] ? 4'd10 : due_q[65] ? 4'd11 :
                           due_q[49:46] != '0 ? 4'd4 + 4'(four(due_q[49:46])) :
                           4'(four(due_q[45:42]))));
      inv_division : assert (due_q[63:50] == '0 || due_q[7'd50+7'(in_division)]);
      reaches_valid : cover (valid_o);
    end
  end

  // prove: free $mul

  // breaks valid_after_68_clocks: FirstDigit = FirstDigit - 5'd1
  // breaks busy_until_valid: state_d = state_q == StChain && inverse_valid ? StIdle : state_d
  // breaks centred_while_cleared: cmp_c_d = clear_i ? cmp_c_q : cmp_c_d
  // breaks new_values_with_valid: cmp_b_d = svpwm_valid && !clear_i ? cmp_a : cmp_b_d
  // breaks values_hold: cmp_a_d = svpwm_valid || clear_i ? cmp_a_d : cmp_a
  // breaks code_less_offset: i_b_d = state_q == StIdle && tick_i ? {~code_b_i[11], code_b_i[10:0]} : i_b_d
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !valid_q && !(clear_i && (cmp_a_q != centre || cmp_b_q != centre || cmp_c_q != centre)) && clarke_quiescent && sine_quiescent && park_quiescent && pi_d_quiescent && pi_q_quiescent && limit_quiescent && inverse_quiescent && svpwm_quiescent

endmodule

bind current_loop current_loop_props #(.ClockHz(ClockHz)) u_current_loop_props (
    .*,
    .in_clarke  (u_clarke.busy_q),
    .in_sine    (u_sine.state_q),
    .in_park    (u_park.state_q),
    .in_pi_d    (u_pi_d.state_q),
    .in_pi_q    (u_pi_q.state_q),
    .in_limit   (u_vector_limit.busy_q),
    .in_inverse (u_inverse_park.state_q),
    .in_svpwm   (u_svpwm.state_q),
    .in_division(u_svpwm.bit_q)
);
