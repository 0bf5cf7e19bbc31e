// SPDX-License-Identifier: Apache-2.0
//
// Properties of rotator. The multiplier is free in the proof: it gets the right words, and whatever
// its products are, their sums do not overflow and are rounded and saturated once.

module rotator_props
  import trammel_pkg::*;
#(
    parameter bit Inverse = 1'b0
) (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input word_t x_i,
    input word_t y_i,
    input word_t sin_i,
    input word_t cos_i,

    input logic  valid_o,
    input word_t x_o,
    input word_t y_o,
    input logic  quiescent_o,

    input logic               multiply,
    input word_t              factor_a,
    input word_t              factor_b,
    input logic        [ 2:0] state_q,
    input logic signed [23:0] product_q,
    input logic signed [25:0] sum_q
);

  typedef logic signed [31:0] wide_t;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic start;
  logic [4:0] due_q;  // vectors in flight, the oldest in the highest bit
  wide_t first_q, x_q, y_q;  // the previous product; sums of two products
  logic [76:0] state, was_state_q;

  assign start = tick_i && due_q[3:0] == '0;
  assign state = {state_q, product_q, sum_q, x_o, y_o};

  function automatic wide_t rounded(wide_t sum);
    wide_t floor;
    floor = (sum + 32'sd1024) >>> 11;
    return floor > 32'sd2047 ? 32'sd2047 : floor < -32'sd2048 ? -32'sd2048 : floor;
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    due_q           <= rst_i ? '0 : {due_q[3:0], start};
    first_q         <= wide_t'(product_q);
    // Products come in the order x cos, y sin, x sin, y cos.
    if (due_q[1]) x_q <= Inverse ? first_q - wide_t'(product_q) : first_q + wide_t'(product_q);
    if (due_q[3]) y_q <= Inverse ? first_q + wide_t'(product_q) : wide_t'(product_q) - first_q;
    if (live_q) begin
      valid_after_5_clocks : assert (valid_o == due_q[4]);
      multiplies_in_order :
      assert (multiply == (start || due_q[2:0] != '0) &&
              (!multiply || (factor_a == (due_q[0] || due_q[2] ? y_i : x_i) &&
                             factor_b == (due_q[0] || due_q[1] ? sin_i : cos_i))));
      x_is_rounded_and_saturated : assert (!valid_o || wide_t'(x_o) == rounded(x_q));
      y_is_rounded_and_saturated : assert (!valid_o || wide_t'(y_o) == rounded(y_q));
      outputs_hold :
      assert (was_rst_q || valid_o || due_q[2] || state[23:0] == was_state_q[23:0]);
      x_holds : assert (was_rst_q || due_q[2] || state[23:12] == was_state_q[23:12]);
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_state :
      assert (state_q == (due_q[0] ? 3'd1 : due_q[1] ? 3'd2 : due_q[2] ? 3'd3 :
                          due_q[3] ? 3'd4 : 3'd0));
      inv_one : assert ((due_q[3:0] & (due_q[3:0] - 4'd1)) == '0);
      inv_half : assert ((!due_q[0] && !due_q[2]) || sum_q == 26'sd1024);
      inv_sum :
      assert ((!due_q[1] && !due_q[3]) || wide_t'(sum_q) ==
              32'sd1024 + (due_q[3] && !Inverse ? -first_q : first_q));
      inv_x : assert ((!due_q[2] && !due_q[3]) || wide_t'(x_o) == rounded(x_q));
      inv_product : assert (first_q >= -32'sd8388608 && first_q <= 32'sd8388607);
      reaches_high_limit : cover (valid_o && x_q > 32'sd4300000 && y_q < 32'sd0);
      reaches_low_limit : cover (valid_o && y_q < -32'sd4300000);
    end
  end

  // prove: set Inverse=0
  // prove: set Inverse=1
  // prove: free $mul
  // prove: depth 5

  // breaks valid_after_5_clocks: state_d = state_q == StYSin ? StYCos : state_d
  // breaks multiplies_in_order: factor_b = state_q == StIdle || state_q == StXSin ? sin_i : factor_b
  // breaks multiplies_in_order: multiply = multiply || state_q == StIdle
  // breaks x_is_rounded_and_saturated: Half = 26'sd1023
  // breaks x_is_rounded_and_saturated: minus = state_q == StYSin ? !Inverse : minus
  // breaks y_is_rounded_and_saturated: minus = state_q == StXSin ? Inverse : minus
  // breaks y_is_rounded_and_saturated: sum = 24'(sum_q + addend + 26'(minus))
  // breaks outputs_hold, x_holds: x_d = state_q == StIdle && tick_i ? '0 : x_d
  // breaks x_holds: x_d = state_q == StYCos ? '0 : x_d
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle && !valid_q

endmodule

bind rotator rotator_props #(.Inverse(Inverse)) u_rotator_props (
    .*,
    .state_q(state_q)  // no .* for an enum
);
