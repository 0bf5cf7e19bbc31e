// SPDX-License-Identifier: Apache-2.0
//
// Adaptive fuzzy position and speed controller of one axis (Kung et al. 2012; specification
// sections 4 to 6): 35 steps of 2 clocks = 70 clocks from the clock after start_i, with ONE signed
// 24 x 24 multiplier (registered) and ONE adder. Rounding is the adder's carry-in, taken from the
// highest dropped bit. The adder works on the last product.
//   s0-s6    reference model x_m, dx         multiplier: s0 B2 dx, s3 A0 s
//   s7-s9    v, e, de                        s10-s12 sections and memberships, s13 read four rules
//   s14-s18  weights d                       s18-s22 u = sum of c d
//   s23-s26  v* = PI(u) (+ dx)               s27-s29 i_q* = Kv (v* - v), published at s29
//   s29-s34  four rules += ETA e d, written as they come; s34 keeps e and x_p for the next sample

module afc
  import trammel_pkg::*;
  import math_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic start_i,  // 2 kHz tick

    input logic          adapt_i,
    input logic          feedforward_i,
    input logic          reset_model_i,
    input logic          reset_table_i,
    input gain_t         kp_i,
    input gain_t         ki_i,
    input gain_t         kv_i,
    input gain_t         eta_i,
    input logic   [ 3:0] shift_e_i,
    input logic   [ 3:0] shift_de_i,
    input logic   [17:0] a0_i,
    input count_t        b2_i,

    input count_t r_i,
    input count_t x_p_i,

    input logic   [5:0] rule_addr_i,
    input logic         rule_we_i,
    input count_t       rule_wdata_i,

    output logic       busy_o,
    output logic       done_o,
    output logic       overrun_o,
    output logic [6:0] step_o,
    output logic       iq_valid_o,

    output model_t x_m_o,
    output count_t x_r_o,
    output count_t dx_o,
    output word_t  e_o,
    output word_t  de_o,
    output word_t  u_o,
    output word_t  v_star_o,
    output word_t  v_o,
    output word_t  i_q_ref_o,
    output logic   saturated_o,
    output count_t rule_rdata_o,
    output logic   table_busy_o,
    output logic   quiescent_o
);

  typedef logic signed [39:0] sum_t;      // the largest term, Ki u << 16, has 39 bits
  typedef logic signed [47:0] product_t;

  // ---- sequence ----

  logic running_q, running_d;
  logic phase_q, phase_d;
  logic [5:0] step_q, step_d;
  logic waiting_q, waiting_d;      // a start met the table reset
  logic asked_q, asked_d;          // reset_model_i was seen since the last start
  logic resetting_q, resetting_d;  // this sample begins with the reset state
  logic done_q, done_d;
  logic iq_valid_q, iq_valid_d;
  logic step_end;

  assign step_end = running_q && phase_q;

  always_comb begin
    running_d   = running_q;
    phase_d     = running_q && !phase_q;
    step_d      = step_q;
    waiting_d   = waiting_q;
    asked_d     = asked_q || reset_model_i;
    resetting_d = resetting_q;
    done_d      = step_end && step_q == 6'd34;
    iq_valid_d  = step_end && step_q == 6'd29;
    if (running_q) begin
      if (phase_q) step_d = step_q + 6'd1;
      if (done_d) begin
        running_d = 1'b0;
        step_d    = '0;
      end
    end else if (table_busy_o) begin
      waiting_d = waiting_q || start_i;
    end else if (start_i || waiting_q) begin
      running_d   = 1'b1;
      waiting_d   = 1'b0;
      resetting_d = asked_d;
      asked_d     = 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      running_q   <= 1'b0;
      phase_q     <= 1'b0;
      step_q      <= '0;
      waiting_q   <= 1'b0;
      asked_q     <= 1'b0;
      resetting_q <= 1'b0;
      done_q      <= 1'b0;
      iq_valid_q  <= 1'b0;
    end else begin
      running_q   <= running_d;
      phase_q     <= phase_d;
      step_q      <= step_d;
      waiting_q   <= waiting_d;
      asked_q     <= asked_d;
      resetting_q <= resetting_d;
      done_q      <= done_d;
      iq_valid_q  <= iq_valid_d;
    end
  end

  // ---- registers of the sample ----

  count_t r_q, r_1_q, r_2_q;
  count_t x_p_q, x_p_prev_q;
  model_t x_m_q;
  count_t dx_q, x_r_q, s_q, integral_q;
  word_t e_q, e_prev_q, de_q, v_q, u_q, v_star_q, i_q_ref_q;
  logic saturated_q;
  word_t scaled_q;                 // E, then DE, in the universe
  logic [2:0] col_q, row_q;        // sections i of e and j of de
  member_t mu_a0_q, mu_a1_q, mu_b0_q, mu_b1_q;
  member_t d00_q, d01_q, d10_q, d11_q;
  count_t c00_q, c01_q, c10_q, c11_q;
  count_t t_q;                     // ETA e
  sum_t acc_q;
  product_t product_q;

  // ---- multiplier: operands of each step ----

  count_t mul_a, mul_b;
  logic mul_used;  // otherwise the product stays

  function automatic count_t unsigned12(logic [11:0] x);
    return {12'd0, x};
  endfunction

  function automatic count_t upper12(count_t c);  // floor of a stored rule
    return c >>> 12;
  endfunction

  always_comb begin
    mul_a = '0;
    mul_b = '0;
    mul_used = 1'b1;
    unique case (step_q)
      6'd0: begin mul_a = b2_i; mul_b = dx_q; end
      6'd3: begin mul_a = {6'd0, a0_i}; mul_b = s_q; end
      6'd14: begin mul_a = unsigned12(mu_a0_q); mul_b = unsigned12(mu_b0_q); end
      6'd15: begin mul_a = unsigned12(mu_a1_q); mul_b = unsigned12(mu_b0_q); end
      6'd16: begin mul_a = unsigned12(mu_a0_q); mul_b = unsigned12(mu_b1_q); end
      6'd17: begin mul_a = unsigned12(mu_a1_q); mul_b = unsigned12(mu_b1_q); end
      6'd18: begin mul_a = upper12(c00_q); mul_b = unsigned12(d00_q); end
      6'd19: begin mul_a = upper12(c01_q); mul_b = unsigned12(d01_q); end
      6'd20: begin mul_a = upper12(c10_q); mul_b = unsigned12(d10_q); end
      6'd21: begin mul_a = upper12(c11_q); mul_b = unsigned12(d11_q); end
      6'd23: begin mul_a = {13'd0, kp_i.mant}; mul_b = count_t'(u_q); end
      6'd24: begin mul_a = {13'd0, ki_i.mant}; mul_b = count_t'(u_q); end
      6'd28: begin mul_a = {13'd0, kv_i.mant}; mul_b = acc_q[23:0]; end
      6'd29: begin mul_a = {13'd0, eta_i.mant}; mul_b = count_t'(e_q); end
      6'd30: begin mul_a = product_q[23:0]; mul_b = unsigned12(d00_q); end
      6'd31: begin mul_a = t_q; mul_b = unsigned12(d01_q); end
      6'd32: begin mul_a = t_q; mul_b = unsigned12(d10_q); end
      6'd33: begin mul_a = t_q; mul_b = unsigned12(d11_q); end
      default: mul_used = 1'b0;
    endcase
  end

  // ---- the product at the adder: shifted, its highest dropped bit as carry ----

  logic signed [5:0] shift;
  sum_t shifted;
  logic half;

  always_comb begin
    unique case (step_q)
      6'd3: shift = 6'sd23;
      6'd4: shift = 6'sd24;
      6'd15, 6'd16, 6'd17, 6'd18: shift = 6'sd11;
      6'd24: shift = 6'sd11 - 6'(kp_i.exp);
      6'd25: shift = -6'sd1 - 6'(ki_i.exp);
      6'd29: shift = 6'sd11 - 6'(kv_i.exp);
      6'd31, 6'd32, 6'd33, 6'd34: shift = 6'sd10 - 6'(eta_i.exp);
      default: shift = 6'sd0;
    endcase
    shifted = sum_t'(shift > 6'sd0 ? product_q >>> shift : product_q <<< -shift);
    half = shift > 6'sd0 && product_q[6'(shift - 6'sd1)];
  end

  // ---- adder: operands of each step ----

  sum_t add_a, add_b, sum;
  logic carry;
  count_t r_new;

  assign r_new = resetting_q ? x_p_i : r_i;  // a reset sample stands still

  always_comb begin
    add_a = '0;
    add_b = shifted;
    carry = half;
    unique case (step_q)
      6'd0: begin add_a = sum_t'(r_new); add_b = sum_t'(r_2_q); carry = 1'b0; end
      6'd1: begin add_a = acc_q; add_b = sum_t'(r_1_q) <<< 1; end
      6'd2: begin add_a = acc_q <<< 6; add_b = ~(sum_t'(x_m_q) >>> 6); carry = 1'b1; end
      6'd4, 6'd20, 6'd21, 6'd22, 6'd24: add_a = acc_q;
      6'd5: begin add_a = sum_t'(x_m_q); add_b = sum_t'(dx_q); end
      6'd6: begin add_b = sum_t'(x_m_q) >>> 14; carry = x_m_q[13]; end
      6'd7: begin add_a = sum_t'(x_p_q); add_b = ~sum_t'(x_p_prev_q); carry = 1'b1; end
      6'd8: begin add_a = sum_t'(x_r_q); add_b = ~sum_t'(x_p_q); carry = 1'b1; end
      6'd9: begin add_a = sum_t'(e_q); add_b = ~sum_t'(e_prev_q); carry = 1'b1; end
      6'd10, 6'd12: begin
        add_a = 40'sd2048;
        add_b = ~sum_t'({1'b0, scaled_q[8:0], 2'd0});
        carry = 1'b1;
      end
      6'd19: add_a = 40'sd1024;  // rounds u
      6'd23: begin
        add_b = '0;
        if (feedforward_i) add_b = sum_t'(dx_q) >>> 10;
        carry = feedforward_i && dx_q[9];
      end
      6'd25: add_a = sum_t'(integral_q);
      6'd26: begin add_a = acc_q; add_b = sum_t'(integral_q) >>> 12; carry = integral_q[11]; end
      6'd27: begin add_a = sum_t'(v_star_q); add_b = ~sum_t'(v_q); carry = 1'b1; end
      6'd31: add_a = sum_t'(c00_q);
      6'd32: add_a = sum_t'(c01_q);
      6'd33: add_a = sum_t'(c10_q);
      6'd34: add_a = sum_t'(c11_q);
      default: ;
    endcase
    sum = add_a + add_b + sum_t'({1'b0, carry});
  end

  word_t sum12;
  count_t sum24;
  assign sum12 = sat12(acc_t'(sum));
  assign sum24 = sat24(acc_t'(sum));

  // ---- rules ----

  count_t rule_00, rule_01, rule_10, rule_11;
  logic tune_we, store_quiescent;
  logic [1:0] tune_sel;

  assign tune_we = step_end && adapt_i && step_q >= 6'd31;
  assign tune_sel = 2'(step_q - 6'd31);

  rule_store u_rules (
      .clk_i,
      .rst_i,
      .reset_i(reset_table_i),
      .hold_i(running_q),
      .i_i(col_q),
      .j_i(row_q),
      .rule_00_o(rule_00),
      .rule_01_o(rule_01),
      .rule_10_o(rule_10),
      .rule_11_o(rule_11),
      .tune_we_i(tune_we),
      .tune_sel_i(tune_sel),
      .tune_data_i(sum24),
      .addr_i(rule_addr_i),
      .we_i(rule_we_i),
      .wdata_i(rule_wdata_i),
      .rdata_o(rule_rdata_o),
      .busy_o(table_busy_o),
      .quiescent_o(store_quiescent)
  );

  // ---- what each step keeps ----

  acc_t to_scale;
  assign to_scale = step_q == 6'd9 ? acc_t'(e_q) <<< shift_e_i : acc_t'(de_q) <<< shift_de_i;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      {r_q, r_1_q, r_2_q, x_p_q, x_p_prev_q, dx_q, x_r_q, integral_q} <= '0;
      x_m_q <= '0;
      {e_q, e_prev_q, de_q, v_q, u_q, v_star_q, i_q_ref_q, saturated_q} <= '0;
    end else if (step_end) begin
      if (mul_used) product_q <= mul_a * mul_b;
      unique case (step_q)
        6'd0: begin
          acc_q <= sum;
          r_q   <= r_new;
          x_p_q <= x_p_i;
        end
        6'd2: s_q <= sum24;
        6'd4: dx_q <= sum24;
        6'd5: x_m_q <= sum[31:0];
        6'd6: begin
          x_r_q <= sum[23:0];
          r_1_q <= r_q;
          r_2_q <= r_1_q;
        end
        6'd7: v_q <= sat12(acc_t'(sum) <<< 4);
        6'd8: e_q <= sum12;
        6'd9: begin
          de_q     <= sum12;
          scaled_q <= word_t'(clip(to_scale, -56'sd1536, 56'sd1535));
        end
        6'd10: begin
          col_q   <= scaled_q[11:9] + 3'd3;
          mu_a0_q <= sum[11:0];
          mu_a1_q <= {1'b0, scaled_q[8:0], 2'd0};
        end
        6'd11: scaled_q <= word_t'(clip(to_scale, -56'sd1536, 56'sd1535));
        6'd12: begin
          row_q   <= scaled_q[11:9] + 3'd3;
          mu_b0_q <= sum[11:0];
          mu_b1_q <= {1'b0, scaled_q[8:0], 2'd0};
        end
        6'd13: {c00_q, c01_q, c10_q, c11_q} <= {rule_00, rule_01, rule_10, rule_11};
        6'd15: d00_q <= sum[11:0];
        6'd16: d01_q <= sum[11:0];
        6'd17: d10_q <= sum[11:0];
        6'd18: d11_q <= sum[11:0];
        6'd22: u_q <= sat12(acc_t'(sum) >>> 11);
        6'd25: integral_q <= sum24;
        6'd26: v_star_q <= sum12;
        6'd27: acc_q <= sum_t'(sum12);
        6'd29: begin
          i_q_ref_q   <= sum12;
          saturated_q <= sum != sum_t'(sum12);
        end
        6'd30: t_q <= product_q[23:0];
        6'd34: begin
          e_prev_q   <= e_q;
          x_p_prev_q <= x_p_q;
        end
        default: acc_q <= sum;
      endcase
    end else if (running_q && resetting_q && step_q == 6'd0) begin
      // Rest at x_p; its first clock, so that s0 already computes with it.
      r_1_q      <= x_p_i;
      r_2_q      <= x_p_i;
      x_m_q      <= {x_p_i[17:0], 14'd0};
      x_p_prev_q <= x_p_i;
      {dx_q, e_prev_q, integral_q} <= '0;
    end
  end

  assign busy_o = running_q || waiting_q || table_busy_o;
  assign done_o = done_q;
  assign overrun_o = start_i && (running_q || waiting_q);
  assign step_o = {1'b0, step_q};
  assign iq_valid_o = iq_valid_q;
  assign x_m_o = x_m_q;
  assign x_r_o = x_r_q;
  assign dx_o = dx_q;
  assign e_o = e_q;
  assign de_o = de_q;
  assign u_o = u_q;
  assign v_star_o = v_star_q;
  assign v_o = v_q;
  assign i_q_ref_o = i_q_ref_q;
  assign saturated_o = saturated_q;
  assign quiescent_o = !busy_o && !start_i && asked_q == asked_d && !done_q && !iq_valid_q
      && store_quiescent;

endmodule
