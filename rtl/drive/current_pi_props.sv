// SPDX-License-Identifier: Apache-2.0
//
// Properties of current_pi for any input. The multiplier is free in the proof: it gets the right
// words, and whatever its products are, the rest follows the equation in 48 bits, saturated where
// that says so and nowhere else.

module current_pi_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic clear_i,

    input word_t ref_i,
    input word_t meas_i,
    input gain_t kp_i,
    input gain_t ki_i,

    input logic  valid_o,
    input word_t v_o,
    input logic  quiescent_o,

    input logic        [ 2:0] state_q,
    input word_t              error_q,
    input word_t              error_prev_q,
    input count_t             integral_q,
    input logic               multiply,
    input logic        [17:0] coefficient,
    input word_t              factor,
    input logic signed [29:0] product_q,
    input logic signed [24:0] term_q,
    input logic               dropped_q
);

  typedef logic signed [47:0] wide_t;

  localparam wide_t IntegralMax = 48'sd8384512;  // 2047 * 4096
  localparam wide_t IntegralMin = -48'sd8388608;  // -2048 * 4096

  logic live_q = 1'b0;
  logic was_rst_q, was_clear_q, was_quiescent_q;
  logic start;
  logic [4:0] due_q;  // errors in flight, the oldest in the highest bit
  wide_t error_wide_q, step_q, output_q, was_integral_q;  // results of the previous edge, unclipped
  word_t was_error_q, was_error_prev_q, was_v_q;
  logic [118:0] state, was_state_q;

  function automatic wide_t clip(wide_t x, wide_t low, wide_t high);
    return x < low ? low : x > high ? high : x;
  endfunction

  // product * 2^(8 h - point), rounded half up.
  function automatic wide_t shifted(logic signed [29:0] product, logic [1:0] h,
                                    logic signed [5:0] point);
    logic signed [5:0] right;
    right = point - (6'($signed(h)) <<< 3);
    if (right <= 6'sd0) return wide_t'(product) <<< -right;
    return (wide_t'(product) + (wide_t'(1) <<< (right - 6'sd1))) >>> right;
  endfunction

  assign start = tick_i && due_q[3:0] == '0;
  assign state = {state_q, error_q, error_prev_q, integral_q, product_q, term_q, dropped_q, v_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q        <= rst_i;
    was_clear_q      <= clear_i && !rst_i;
    was_quiescent_q  <= !rst_i && quiescent_o;
    was_state_q      <= state;
    was_integral_q   <= wide_t'(integral_q);
    was_error_q      <= error_q;
    was_error_prev_q <= error_prev_q;
    was_v_q          <= v_o;
    due_q            <= rst_i ? '0 : {due_q[3:0], start};
    error_wide_q     <= wide_t'(ref_i) - (wide_t'(meas_i) <<< 1);
    if (due_q[1]) step_q <= shifted(product_q, ki_i.exp[4:3], -6'sd1);
    if (due_q[2]) output_q <= shifted(product_q, kp_i.exp[4:3], 6'sd11);
    if (live_q) begin
      valid_after_5_clocks : assert (valid_o == due_q[4]);
      error_is_saturated :
      assert (!due_q[0] || wide_t'(error_q) == clip(error_wide_q, -48'sd2048, 48'sd2047));
      multiplies_in_order :
      assert (multiply == (due_q[1:0] != '0) &&
              (!due_q[0] || (factor == error_prev_q &&
                             coefficient == 18'(ki_i.mant) << ki_i.exp[2:0])) &&
              (!due_q[1] || (factor == error_q &&
                             coefficient == 18'(kp_i.mant) << kp_i.exp[2:0])));
      integral_is_the_equation :
      assert (!due_q[3] || was_clear_q || wide_t'(integral_q) ==
              clip(was_integral_q + step_q, IntegralMin, IntegralMax));
      integral_within_limits : assert (wide_t'(integral_q) <= IntegralMax);
      integral_holds :
      assert (was_rst_q || was_clear_q || due_q[3] || wide_t'(integral_q) == was_integral_q);
      output_is_the_equation :
      assert (!valid_o || was_clear_q || wide_t'(v_o) ==
              clip(output_q + ((was_integral_q + 48'sd2048) >>> 12), -48'sd2048, 48'sd2047));
      output_holds : assert (was_rst_q || was_clear_q || valid_o || v_o == was_v_q);
      error_before_is_kept :
      assert (was_rst_q || was_clear_q ||
              error_prev_q == (valid_o ? was_error_q : was_error_prev_q));
      clear_empties : assert (!was_clear_q || {integral_q, error_prev_q, v_o} == '0);
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_state :
      assert (state_q == (due_q[0] ? 3'd1 : due_q[1] ? 3'd2 : due_q[2] ? 3'd3 :
                          due_q[3] ? 3'd4 : 3'd0));
      inv_one : assert ((due_q[3:0] & (due_q[3:0] - 4'd1)) == '0);
      reaches_high_limit : cover (valid_o && wide_t'(integral_q) == IntegralMax);
      reaches_low_limit : cover (valid_o && v_o == -12'sd2048 && integral_q > 24'sd0);
    end
  end

  // prove: free $mul
  // prove: depth 5

  // breaks valid_after_5_clocks: state_d = state_q == StAccumulate && clear_i ? StIdle : state_d
  // breaks error_is_saturated: error_d = state_q == StIdle && tick_i ? sat12(acc_t'(ref_i) - acc_t'(word_t'(meas_i <<< 1))) : error_d
  // breaks multiplies_in_order: factor = error_q
  // breaks integral_is_the_equation: integral_d = state_q == StAccumulate && !clear_i && sum[25:11] == 15'h0ffe ? sum[23:0] : integral_d
  // breaks integral_is_the_equation: term = coarse == 2'b11 ? 25'($signed(product_q[28:7])) : term
  // breaks integral_within_limits: integral_d = state_q == StAccumulate && !clear_i && sum[25:23] == '0 ? sum[23:0] : integral_d
  // breaks integral_holds: integral_d = state_q != StAccumulate && tick_i && !clear_i ? '0 : integral_d
  // breaks output_is_the_equation: term = fits ? term : {product_q[29], product_q[23:0]}
  // breaks output_is_the_equation: v_sum = 15'($signed(term_q[24:12])) + 15'(v_integral) + 15'($signed({1'b0, term_q[12]}))
  // breaks output_holds: v_d = state_q != StOutput && tick_i && !clear_i ? ref_i : v_d
  // breaks error_before_is_kept: error_prev_d = state_q == StOutput && !clear_i ? ref_i : error_prev_d
  // breaks clear_empties: v_d = state_q == StOutput && clear_i ? sat12(acc_t'(v_sum)) : v_d
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle && !tick_i && !valid_q && !(clear_i && (integral_q != '0 || v_q != '0))

endmodule

bind current_pi current_pi_props u_current_pi_props (
    .*,
    .state_q(state_q)  // no .* for an enum
);
