// SPDX-License-Identifier: Apache-2.0
//
// PI controller of one current component; the integrator takes the error of the previous sample.
// valid_o is high at the 5th clock edge after the one that sees tick_i; inputs hold until then.
//
//   e   = sat(ref - 2 meas)                              full scale of ref: half that of meas
//   v_i = clip(v_i + rs(ki_m e_prev, -1 - ki_s), -2048 * 4096, 2047 * 4096)
//   v   = sat(rs(kp_m e, 11 - kp_s) + rs(v_i, 12))
//
// The exponent s = 8 h + f: the multiplier gets mant * 2^f, and h chooses one of four shifts, the
// same for both terms because v_i is in units of v / 4096. A rounding shift is the floor plus the
// highest dropped bit.
//
//   edge 0     e
//   edge 1     ki_m e_prev
//   edge 2     kp_m e; integral term
//   edge 3     v_i; proportional term
//   edge 4     v; e_prev = e; valid

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
  typedef logic signed [24:0] term_t;  // [v / 4096]; larger than any useful step of v_i
  typedef enum logic [2:0] {StIdle, StIntegral, StProportional, StAccumulate, StOutput} state_e;

  state_e   state_d, state_q;
  logic     valid_d, valid_q;
  word_t    error_d, error_q;
  word_t    error_prev_d, error_prev_q;
  count_t   integral_d, integral_q;
  word_t    v_d, v_q;
  product_t product_d, product_q;
  term_t    term_d, term_q;
  logic     dropped_d, dropped_q;  // highest bit below the term

  logic               use_kp;
  logic               multiply;
  logic         [2:0] fine_shift;
  logic        [10:0] mantissa;
  logic        [17:0] coefficient;
  word_t              factor;
  logic         [1:0] coarse;
  logic               fits;
  term_t              shifted;
  term_t              term;
  logic               dropped;
  logic signed [25:0] sum;
  logic signed [12:0] v_integral;
  logic signed [14:0] v_sum;

  always_comb begin
    mantissa = use_kp ? kp_i.mant : ki_i.mant;
    fine_shift = use_kp ? kp_i.exp[2:0] : ki_i.exp[2:0];
    coefficient = 18'(mantissa) << fine_shift;
    factor = use_kp ? error_q : error_prev_q;
    product_d = product_q;
    if (multiply) product_d = 30'($signed({1'b0, coefficient})) * 30'(factor);
  end

  // product * 2^(1 + 8 h), clipped to the width of a term. The product lags use_kp by a state.
  always_comb begin
    coarse = use_kp ? ki_i.exp[4:3] : kp_i.exp[4:3];
    dropped = 1'b0;
    fits = 1'b1;
    unique case (coarse)
      2'b01:   shifted = {product_q[15:0], 9'd0};
      2'b00:   shifted = {product_q[23:0], 1'b0};
      2'b11:   begin shifted = 25'($signed(product_q[29:7])); dropped = product_q[6]; end
      default: begin shifted = 25'($signed(product_q[29:15])); dropped = product_q[14]; end
    endcase
    if (!coarse[1]) begin
      fits = product_q[29:23] == '0 || product_q[29:23] == '1;
      if (coarse[0]) fits = fits && (product_q[23:15] == '0 || product_q[23:15] == '1);
    end
    term = fits ? shifted : {product_q[29], {24{~product_q[29]}}};
  end

  // -2048 * 4096 .. 2047 * 4096
  function automatic count_t clip_integral(logic signed [25:0] x);
    if (!x[25] && (x[24:23] != '0 || x[22:12] == '1)) return 24'sd8384512;
    if (x[25] && x[24:23] != '1) return -24'sd8388608;
    return x[23:0];
  endfunction

  assign sum = 26'(integral_q) + 26'(term_q) + 26'($signed({1'b0, dropped_q}));
  assign v_integral = 13'($signed(integral_q[23:12])) + 13'($signed({1'b0, integral_q[11]}));
  assign v_sum = 15'($signed(term_q[24:12])) + 15'(v_integral) + 15'($signed({1'b0, term_q[11]}));

  assign use_kp   = state_q == StProportional;
  assign multiply = state_q == StIntegral || use_kp;

  always_comb begin
    state_d = state_q;
    valid_d = 1'b0;
    error_d = error_q;
    error_prev_d = error_prev_q;
    integral_d = integral_q;
    v_d = v_q;
    term_d = term_q;
    dropped_d = dropped_q;
    unique case (state_q)
      StIdle: begin
        if (tick_i) begin
          error_d = sat12(acc_t'(ref_i) - (acc_t'(meas_i) <<< 1));  // Kung eq. 11
          state_d = StIntegral;
        end
      end
      StIntegral: begin  // Kung eq. 13: the error of the previous sample
        state_d = StProportional;
      end
      StProportional: begin  // Kung eq. 12
        term_d = term;
        dropped_d = dropped;
        state_d = StAccumulate;
      end
      StAccumulate: begin
        integral_d = clip_integral(sum);
        term_d = term;
        state_d = StOutput;
      end
      default: begin  // StOutput
        v_d = sat12(acc_t'(v_sum));  // Kung eq. 14
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
      term_q <= '0;
      dropped_q <= 1'b0;
    end else begin
      state_q <= state_d;
      valid_q <= valid_d;
      error_q <= error_d;
      error_prev_q <= error_prev_d;
      integral_q <= integral_d;
      v_q <= v_d;
      product_q <= product_d;
      term_q <= term_d;
      dropped_q <= dropped_d;
    end
  end

  assign valid_o = valid_q;
  assign v_o = v_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q &&
                       !(clear_i && (error_prev_q != '0 || integral_q != '0 || v_q != '0));

endmodule
