// SPDX-License-Identifier: Apache-2.0
//
// Properties of clarke for any input; the equation is computed in 32 bits.

module clarke_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input word_t i_a_i,
    input word_t i_b_i,

    input logic  valid_o,
    input word_t i_alpha_o,
    input word_t i_beta_o,
    input logic  quiescent_o,

    input logic               busy_q,
    input logic signed [25:0] product_d,
    input logic signed [25:0] product_q
);

  typedef logic signed [31:0] wide_t;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic start;
  logic [1:0] due_q;  // samples in flight, the older in the higher bit
  word_t a_q;  // of the tick
  wide_t scaled, product_was_q, beta;
  logic steady_q;  // the inputs held since the tick
  logic [50:0] state, was_state_q;

  assign start  = tick_i && !due_q[0];
  assign scaled = (wide_t'(i_a_i) + (wide_t'(i_b_i) <<< 1)) * 32'sd1182;
  assign beta   = (product_was_q + 32'sd1024) >>> 11;
  assign state  = {busy_q, product_q, i_alpha_o, i_beta_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    due_q           <= rst_i ? '0 : {due_q[0], start};
    steady_q        <= start || (steady_q && i_a_i == a_q);
    product_was_q   <= wide_t'(product_q);
    if (start) a_q <= i_a_i;
    if (live_q) begin
      valid_after_2_clocks : assert (valid_o == due_q[1]);
      alpha_is_a : assert (!valid_o || !steady_q || i_alpha_o == a_q);
      no_overflow : assert (!start || wide_t'(product_d) == scaled);
      beta_is_rounded_and_saturated :
      assert (!valid_o || wide_t'(i_beta_o) ==
              (beta > 32'sd2047 ? 32'sd2047 : beta < -32'sd2048 ? -32'sd2048 : beta));
      outputs_hold : assert (was_rst_q || valid_o || state[23:0] == was_state_q[23:0]);
      quiescent_is_honest : assert (!was_quiescent_q || (state == was_state_q && !valid_o));
      inv_busy : assert (busy_q == due_q[0]);
      reaches_high_limit : cover (valid_o && beta > 32'sd2047 && a_q == 12'sd2000);
      reaches_low_limit : cover (valid_o && beta < -32'sd2048);
    end
  end

  // breaks valid_after_2_clocks: busy_d = tick_i
  // breaks alpha_is_a: i_alpha_d = busy_q ? i_b_i : i_alpha_d
  // breaks beta_is_rounded_and_saturated: i_beta_d = busy_q ? sat12(rs(acc_t'(product_q), 6'sd12)) : i_beta_d
  // breaks no_overflow: InvSqrt3 = 12'sd1183
  // breaks no_overflow: sum = 14'(12'(i_a_i + (i_b_i <<< 1)))
  // breaks outputs_hold: i_alpha_d = busy_d ? i_a_i : i_alpha_q
  // breaks quiescent_is_honest: quiescent_o = !busy_q && !valid_q

endmodule

bind clarke clarke_props u_clarke_props (.*);
