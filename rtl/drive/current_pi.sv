// SPDX-License-Identifier: Apache-2.0
//
// PI controller of one current component; the integrator takes the error of the sample before.
// valid_o is high at the 4th clock edge after the one that sees tick_i; inputs hold until then.
//
//   e   = sat(ref - 2 meas)                              the reference has half the full scale
//   v_i = clip(v_i + rs(ki_m e_prev, -1 - ki_s), -2048 * 4096, 2047 * 4096)
//   v   = sat(rs(kp_m e, 11 - kp_s) + rs(v_i, 12))
//
// The exponent s = 8 h + f: the multiplier gets mant * 2^f, and h chooses one of four shifts.
//
//   edge 0     e
//   edge 1     ki_m e_prev
//   edge 2     kp_m e; v_i
//   edge 3     v; e_prev = e; valid

module current_pi
  import trammel_pkg::*;
  import math_pkg::*;
(
  input  logic  clk_i,
  input  logic  rst_i,

  input  logic  tick_i,

  input  logic  clear_i,  // holds the integrator, the last error and the output at 0

  input  word_t ref_i,
  input  word_t meas_i,
  input  gain_t kp_i,
  input  gain_t ki_i,

  output logic  valid_o,
  output word_t v_o,
  output logic  quiescent_o
);

  typedef logic signed [29:0] product_t;
  typedef logic signed [24:0] step_t;
  typedef enum logic [1:0] {StIdle, StIntegral, StProportional, StOutput} state_e;

  localparam acc_t IntegralMax = acc_t'(2047 * 4096);
  localparam acc_t IntegralMin = -acc_t'(2048 * 4096);

  state_e   state_d, state_q;
  logic     valid_d, valid_q;
  word_t    error_d, error_q;
  word_t    error_prev_d, error_prev_q;
  count_t   integral_d, integral_q;
  word_t    v_d, v_q;
  product_t product_d, product_q;

  logic               use_kp;
  logic               multiply;
  logic         [2:0] fine_shift;
  logic        [10:0] mantissa;
  logic        [17:0] coefficient;
  word_t              factor;
  acc_t               integral_step;
  acc_t               proportional;

  always_comb begin
    mantissa = use_kp ? kp_i.mant : ki_i.mant;
    fine_shift = use_kp ? kp_i.exp[2:0] : ki_i.exp[2:0];
    coefficient = 18'(mantissa) << fine_shift;
    factor = use_kp ? error_q : error_prev_q;
    product_d = product_q;
    if (multiply) product_d = 30'($signed({1'b0, coefficient})) * 30'(factor);
  end

  // rs(m e, -1 - s) and rs(m e, 11 - s), the part 2^f of the shift being in the product
  always_comb begin
    unique case (ki_i.exp[4:3])
      2'b01:   integral_step = rs(acc_t'(product_q), -6'sd9);
      2'b00:   integral_step = rs(acc_t'(product_q), -6'sd1);
      2'b11:   integral_step = rs(acc_t'(product_q), 6'sd7);
      default: integral_step = rs(acc_t'(product_q), 6'sd15);
    endcase
    unique case (kp_i.exp[4:3])
      2'b01:   proportional = rs(acc_t'(product_q), 6'sd3);
      2'b00:   proportional = rs(acc_t'(product_q), 6'sd11);
      2'b11:   proportional = rs(acc_t'(product_q), 6'sd19);
      default: proportional = rs(acc_t'(product_q), 6'sd27);
    endcase
  end

  always_comb begin
    state_d = state_q;
    valid_d = 1'b0;
    error_d = error_q;
    error_prev_d = error_prev_q;
    integral_d = integral_q;
    v_d = v_q;
    use_kp = 1'b0;
    multiply = 1'b0;
    unique case (state_q)
      StIdle: begin
        if (tick_i) begin
          error_d = sat12(acc_t'(ref_i) - (acc_t'(meas_i) <<< 1));
          state_d = StIntegral;
        end
      end
      StIntegral: begin
        multiply = 1'b1;
        state_d = StProportional;
      end
      StProportional: begin
        use_kp = 1'b1;
        multiply = 1'b1;
        integral_d = 24'(clip(acc_t'(integral_q) + integral_step, IntegralMin, IntegralMax));
        state_d = StOutput;
      end
      default: begin  // StOutput
        v_d = sat12(proportional + rs(acc_t'(integral_q), 6'sd12));
        error_prev_d = error_q;
        valid_d = 1'b1;
        state_d = StIdle;
      end
    endcase
    if (clear_i) begin
      error_prev_d = '0;
      integral_d = '0;
      v_d = '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q <= StIdle;
      valid_q <= 1'b0;
      error_q <= '0;
      error_prev_q <= '0;
      integral_q <= '0;
      v_q <= '0;
      product_q <= '0;
    end else begin
      state_q <= state_d;
      valid_q <= valid_d;
      error_q <= error_d;
      error_prev_q <= error_prev_d;
      integral_q <= integral_d;
      v_q <= v_d;
      product_q <= product_d;
    end
  end

  assign valid_o = valid_q;
  assign v_o = v_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q &&
                       !(clear_i && (error_prev_q != '0 || integral_q != '0 || v_q != '0));

endmodule
