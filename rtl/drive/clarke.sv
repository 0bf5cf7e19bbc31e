// SPDX-License-Identifier: Apache-2.0
//
// Clarke transform of two measured phase currents (amplitude-invariant, the third is -(a + b)).
// valid_o is high at the 2nd clock edge after the one that sees tick_i; inputs hold until then.
//
//   i_alpha = i_a
//   i_beta  = sat(rs(1182 (i_a + 2 i_b), 11))        1182 / 2048 = 1 / sqrt 3
//
//   edge 0     product
//   edge 1     round, saturate; valid

module clarke
  import trammel_pkg::*;
  import math_pkg::*;
(
  input  logic  clk_i,
  input  logic  rst_i,

  input  logic  tick_i,

  input  word_t i_a_i,
  input  word_t i_b_i,

  output logic  valid_o,
  output word_t i_alpha_o,
  output word_t i_beta_o,
  output logic  quiescent_o
);

  localparam logic signed [11:0] InvSqrt3 = 12'sd1182;  // Q11

  logic               busy_d, busy_q;
  logic               valid_q;
  logic signed [13:0] sum;
  logic signed [25:0] product_d, product_q;
  word_t              i_alpha_d, i_alpha_q;
  word_t              i_beta_d, i_beta_q;

  assign sum = 14'(i_a_i) + (14'(i_b_i) <<< 1);
  assign busy_d = tick_i && !busy_q;

  always_comb begin
    product_d = product_q;
    i_alpha_d = i_alpha_q;
    i_beta_d = i_beta_q;
    if (busy_d) product_d = 26'(sum) * 26'(InvSqrt3);
    if (busy_q) begin
      i_alpha_d = i_a_i;
      i_beta_d = sat12(rs(acc_t'(product_q), 6'sd11));  // Kung eq. 7
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      busy_q <= 1'b0;
      valid_q <= 1'b0;
      product_q <= '0;
      i_alpha_q <= '0;
      i_beta_q <= '0;
    end else begin
      busy_q <= busy_d;
      valid_q <= busy_q;
      product_q <= product_d;
      i_alpha_q <= i_alpha_d;
      i_beta_q <= i_beta_d;
    end
  end

  assign valid_o = valid_q;
  assign i_alpha_o = i_alpha_q;
  assign i_beta_o = i_beta_q;
  assign quiescent_o = !busy_q && !tick_i && !valid_q;

endmodule
