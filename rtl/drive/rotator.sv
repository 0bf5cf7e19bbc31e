// SPDX-License-Identifier: Apache-2.0
//
// Rotation of a vector: Park transform, or with Inverse = 1 the inverse Park transform.
// valid_o is high at the 5th clock edge after the one that sees tick_i; inputs hold until then.
//
//   Park     x' =  x cos + y sin      inverse   x' = x cos - y sin
//            y' = -x sin + y cos                y' = x sin + y cos
//
// Both full products are summed before one rounding shift by 11 and one saturation.
//
//   edge       multiplier   adder
//   0          x cos        -
//   1          y sin        1024 + x cos
//   2          x sin        sum +- y sin -> x'
//   3          y cos        1024 -+ x sin
//   4          -            sum + y cos -> y'; valid

module rotator
  import trammel_pkg::*;
  import math_pkg::*;
#(
  parameter bit Inverse = 1'b0
) (
  input  logic  clk_i,
  input  logic  rst_i,

  input  logic  tick_i,

  input  word_t x_i,
  input  word_t y_i,
  input  word_t sin_i,
  input  word_t cos_i,

  output logic  valid_o,
  output word_t x_o,
  output word_t y_o,
  output logic  quiescent_o
);

  typedef logic signed [23:0] product_t;
  typedef logic signed [25:0] sum_t;
  typedef enum logic [2:0] {StIdle, StXCos, StYSin, StXSin, StYCos} state_e;  // product held

  localparam sum_t Half = 26'sd1024;  // of the rounding shift by 11

  state_e   state_d, state_q;
  logic     valid_d, valid_q;
  product_t product_d, product_q;
  sum_t     sum_d, sum_q;
  word_t    x_d, x_q;
  word_t    y_d, y_q;

  word_t    factor_a, factor_b;
  logic     multiply;
  logic     minus;
  sum_t     addend;
  sum_t     sum;
  word_t    rounded;

  always_comb begin
    product_d = product_q;
    if (multiply) product_d = 24'(factor_a) * 24'(factor_b);
  end

  // base + product or base - product, one carry chain
  assign addend = minus ? ~26'(product_q) : 26'(product_q);
  assign sum = sum_q + addend + 26'(minus);
  assign rounded = sat12(acc_t'($signed(sum[25:11])));  // the half is already in the sum

  always_comb begin
    state_d = state_q;
    valid_d = 1'b0;
    sum_d = sum_q;
    x_d = x_q;
    y_d = y_q;
    factor_a = x_i;
    factor_b = cos_i;
    multiply = 1'b0;
    minus = 1'b0;
    unique case (state_q)
      StIdle: begin
        multiply = tick_i;
        if (tick_i) begin
          sum_d = Half;
          state_d = StXCos;
        end
      end
      StXCos: begin
        factor_a = y_i;
        factor_b = sin_i;
        multiply = 1'b1;
        sum_d = sum;
        state_d = StYSin;
      end
      StYSin: begin
        factor_b = sin_i;
        multiply = 1'b1;
        minus = Inverse;  // Kung eq. 9 and 10: x'
        x_d = rounded;
        sum_d = Half;
        state_d = StXSin;
      end
      StXSin: begin
        factor_a = y_i;
        multiply = 1'b1;
        minus = !Inverse;  // Kung eq. 9 and 10: y'
        sum_d = sum;
        state_d = StYCos;
      end
      default: begin  // StYCos
        y_d = rounded;
        valid_d = 1'b1;
        state_d = StIdle;
      end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q <= StIdle;
      valid_q <= 1'b0;
      product_q <= '0;
      sum_q <= '0;
      x_q <= '0;
      y_q <= '0;
    end else begin
      state_q <= state_d;
      valid_q <= valid_d;
      product_q <= product_d;
      sum_q <= sum_d;
      x_q <= x_d;
      y_q <= y_d;
    end
  end

  assign valid_o = valid_q;
  assign x_o = x_q;
  assign y_o = y_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q;

endmodule
