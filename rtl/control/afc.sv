// SPDX-License-Identifier: Apache-2.0
//
// Adaptive fuzzy position and speed controller of one axis (Kung et al. 2012; specification
// sections 4 to 6): 35 steps of 2 clocks = 70 clocks from the clock after start_i, with ONE signed
// 24 x 24 multiplier (registered) and ONE adder. Rounding is the adder's carry-in, taken from the
// highest dropped bit. The adder works on the last product, which the first clock of a step shifts.
//   s0-s6    reference model x_m, dx         multiplier: s0 B2 dx, s3 A0 s
//   s7-s9    v, e, de                        s10-s12 sections and memberships (s13 empty)
//   s14-s18  weights d                       s18-s22 u = sum of c d
//   s23-s26  v* = PI(u) (+ dx)               s27-s29 i_q* = Kv (v* - v), published at s29
//   s29-s34  four rules += ETA e d, written one by one; s34 keeps e and x_p for the next sample

module afc
  import trammel_pkg::*;
  import math_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic start_i,  // position tick

    input logic          adapt_i,
    input logic          feedforward_i,
    input logic          reset_model_i,
    input logic          reset_table_i,
    input gain_t         kp_i,
    input gain_t         ki_i,
    input gain_t         kv_i,
    input gain_t         eta_i,
    input logic signed [4:0] shift_e_i,  // below -2 acts as -2
    input logic signed [4:0] shift_de_i,
    input logic   [17:0] a0_i,
    input logic   [ 1:0] a0_scale_i,  // of a0_i: 2^-32, 2^-28, 2^-23 (2 and 3)
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
  typedef logic signed [13:0] fine_t;  // 1/1024 unit: a shift by -2 loses no bit

  // ---- sequence ----

  logic running_q, running_d;
  logic phase_q, phase_d;
  logic [5:0] step_q, step_d;
  logic waiting_q, waiting_d;      // a start came during the table reset
  logic asked_q, asked_d;          // reset_model_i was seen since the last start
  logic resetting_q, resetting_d;  // this sample begins in the reset state
  logic done_q, done_d;
  logic iq_valid_q, iq_valid_d;
  logic step_begin, step_end;  // the first clock prepares operands, the second stores results

  assign step_begin = running_q && !phase_q;
  assign step_end   = running_q && phase_q;

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
  fine_t scaled_q;                 // E, then DE, in the universe
  logic [2:0] col_q, row_q;        // sections i of e and j of de
  member_t mu_a0_q, mu_a1_q, mu_b0_q, mu_b1_q;
  member_t d00_q, d01_q, d10_q, d11_q;
  sum_t acc_q;
  product_t product_q;

  // ---- multiplier: operands of each step ----

  // The product goes to the adder shifted right by place, which a gain raises or lowers. Its low
  // bits are made 1 by first shifting a factor of 12 bits to the left, so that few shifts of the
  // product remain: place[5:3] chooses -9, -1, 7, 15, 23 or 31.
  localparam logic [5:0] Place24 = 6'o47;  // a shift by 24, for A0

  count_t mul_a, mul_b, mul_a_q, mul_b_q;
  logic [11:0] factor;
  logic [18:0] scaled_factor;
  logic [5:0] place;
  logic [2:0] place_q;
  logic mul_used;  // otherwise the product holds
  count_t rule;    // the one of the four that this step uses, in its first clock

  function automatic count_t unsigned12(logic [11:0] x);
    return {12'd0, x};
  endfunction

  always_comb begin
    factor = '0;
    mul_b = '0;
    place = 6'd23;
    mul_used = 1'b1;
    unique case (step_q)
      6'd0: mul_b = resetting_q ? '0 : dx_q;  // times B2
      6'd3: begin  // times A0
        mul_b = s_q;
        place = a0_scale_i == 2'd0 ? Place24 : a0_scale_i == 2'd1 ? 6'd23 : 6'd15;
      end
      6'd14: begin factor = mu_b0_q; mul_b = unsigned12(mu_a0_q); place = 6'd11; end
      6'd15: begin factor = mu_b0_q; mul_b = unsigned12(mu_a1_q); place = 6'd11; end
      6'd16: begin factor = mu_b1_q; mul_b = unsigned12(mu_a0_q); place = 6'd11; end
      6'd17: begin factor = mu_b1_q; mul_b = unsigned12(mu_a1_q); place = 6'd11; end
      6'd18: begin factor = d00_q; mul_b = rule >>> 12; place = 6'd0; end
      6'd19: begin factor = d01_q; mul_b = rule >>> 12; place = 6'd0; end
      6'd20: begin factor = d10_q; mul_b = rule >>> 12; place = 6'd0; end
      6'd21: begin factor = d11_q; mul_b = rule >>> 12; place = 6'd0; end
      6'd23: begin factor = 12'(kp_i.mant); mul_b = count_t'(u_q); place = 6'd11 - 6'(kp_i.exp); end
      6'd24: begin factor = 12'(ki_i.mant); mul_b = count_t'(u_q); place = -6'd1 - 6'(ki_i.exp); end
      6'd28: begin factor = 12'(kv_i.mant); mul_b = acc_q[23:0]; place = 6'd11 - 6'(kv_i.exp); end
      6'd29: begin factor = 12'(eta_i.mant); mul_b = count_t'(e_q); end
      6'd30: begin factor = d00_q; mul_b = product_q[23:0]; place = 6'd10 - 6'(eta_i.exp); end
      6'd31: begin factor = d01_q; mul_b = mul_b_q; place = 6'd10 - 6'(eta_i.exp); end
      6'd32: begin factor = d10_q; mul_b = mul_b_q; place = 6'd10 - 6'(eta_i.exp); end
      6'd33: begin factor = d11_q; mul_b = mul_b_q; place = 6'd10 - 6'(eta_i.exp); end
      default: mul_used = 1'b0;
    endcase
    scaled_factor = 19'(factor) << ~place[2:0];
    mul_a = {5'd0, scaled_factor};
    if (step_q == 6'd0) mul_a = b2_i;
    if (step_q == 6'd3) mul_a = a0_scale_i == 2'd1 ? {3'd0, a0_i, 3'd0} : {6'd0, a0_i};
  end

  // ---- the product at the adder: shifted, its highest dropped bit as carry ----

  sum_t shifted;
  logic half;

  always_comb begin
    unique case (place_q)
      3'o6:    {shifted, half} = {product_q[30:0], 10'd0};
      3'o7:    {shifted, half} = {product_q[38:0], 2'd0};
      3'o0:    {shifted, half} = product_q[46:6];
      3'o1:    {shifted, half} = 41'($signed(product_q[47:14]));
      3'o2:    {shifted, half} = 41'($signed(product_q[47:22]));
      3'o3:    {shifted, half} = 41'($signed(product_q[47:30]));
      default: {shifted, half} = 41'($signed(product_q[47:23]));  // Place24
    endcase
  end

  // ---- adder: operands of each step ----

  sum_t add_a, add_b, add_a_q, add_b_q, sum;
  logic carry, carry_q, unused_sum;
  count_t r_new, r_2;

  assign r_new = resetting_q ? x_p_i : r_i;  // a reset sample stands still
  assign r_2 = resetting_q ? x_p_i : r_2_q;

  always_comb begin
    add_a = '0;
    add_b = shifted;
    carry = half;
    unique case (step_q)
      6'd0: begin add_a = sum_t'(r_new); add_b = sum_t'(r_2); carry = 1'b0; end
      6'd1: begin add_a = acc_q; add_b = sum_t'(r_1_q) <<< 1; carry = 1'b0; end
      6'd2: begin add_a = acc_q <<< 6; add_b = ~(sum_t'(x_m_q) >>> 6); carry = 1'b1; end
      6'd4, 6'd20, 6'd21, 6'd22, 6'd24: add_a = acc_q;
      6'd5: begin add_a = sum_t'(x_m_q); add_b = sum_t'(dx_q); carry = 1'b0; end
      6'd6: begin add_b = sum_t'(x_m_q) >>> 14; carry = x_m_q[13]; end
      6'd7: begin add_a = sum_t'(x_p_q); add_b = ~sum_t'(x_p_prev_q); carry = 1'b1; end
      6'd8: begin add_a = sum_t'(x_r_q); add_b = ~sum_t'(x_p_q); carry = 1'b1; end
      6'd9: begin add_a = sum_t'(e_q); add_b = ~sum_t'(e_prev_q); carry = 1'b1; end
      6'd10, 6'd12: begin
        add_a = 40'sd2048;
        add_b = ~sum_t'({1'b0, scaled_q[10:0]});
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
      6'd31, 6'd32, 6'd33, 6'd34: add_a = sum_t'(rule);
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (step_begin) begin
      {mul_a_q, mul_b_q} <= {mul_a, mul_b};
      {add_a_q, add_b_q, carry_q} <= {add_a, add_b, carry};
    end
    if (step_end && mul_used) begin
      product_q <= mul_a_q * mul_b_q;
      place_q   <= place[5:3];
    end
  end

  assign {sum, unused_sum} = {add_a_q, 1'b1} + {add_b_q, carry_q};  // one carry chain

  word_t sum12;
  count_t sum24;
  assign sum12 = sat12(acc_t'(sum));
  assign sum24 = sat24(acc_t'(sum));

  // ---- rules ----

  logic tune_we, store_quiescent;
  logic [1:0] rule_sel;

  assign tune_we = step_end && adapt_i && step_q >= 6'd31;  // Kung eq. 27: s31 to s34
  // For s18 to s21 and s31 to s34; the first clock of a step reads for the next one.
  assign rule_sel = step_q[1:0] + (step_q[5] || step_q[3:2] == '1 ? 2'd1 : 2'd2) + 2'(!phase_q);

  rule_store u_rules (
      .clk_i,
      .rst_i,
      .reset_i(reset_table_i),
      .hold_i(running_q),
      .i_i(col_q),
      .j_i(row_q),
      .sel_i(rule_sel),
      .read_i(step_begin),
      .rule_o(rule),
      .tune_we_i(tune_we),
      .tune_data_i(sum24),
      .addr_i(rule_addr_i),
      .we_i(rule_we_i),
      .wdata_i(rule_wdata_i),
      .rdata_o(rule_rdata_o),
      .busy_o(table_busy_o),
      .quiescent_o(store_quiescent)
  );

  // ---- what each step stores ----

  // clip(x 2^n, -1536, 1535) in 1/256 unit, with two more bits
  function automatic fine_t universe(word_t x, logic signed [4:0] n);
    logic signed [28:0] scaled;
    scaled = 29'(x) <<< (n < -5'sd2 ? 5'd0 : 5'(n + 5'sd2));
    if (!scaled[28] && (scaled[27:13] != '0 || scaled[12:11] == '1)) return {12'sd1535, 2'd0};
    if (scaled[28] && (scaled[27:13] != '1 || scaled[12:11] == '0)) return {-12'sd1536, 2'd0};
    return scaled[13:0];
  endfunction

  fine_t scaled;
  assign scaled = universe(step_q[1] ? de_q : e_q, step_q[1] ? shift_de_i : shift_e_i);

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      {r_q, r_1_q, r_2_q, x_p_q, x_p_prev_q, dx_q, x_r_q, integral_q} <= '0;
      x_m_q <= '0;
      {e_q, e_prev_q, de_q, v_q, u_q, v_star_q, i_q_ref_q, saturated_q} <= '0;
    end else if (step_end) begin
      unique case (step_q)
        6'd0: begin
          acc_q <= sum;
          r_q   <= r_new;
          x_p_q <= x_p_i;
        end
        6'd2: s_q <= sum24;  // Kung eq. 24, incremental: s2, s4, s5
        6'd4: dx_q <= sum24;
        6'd5: x_m_q <= sum[31:0];
        6'd6: begin
          x_r_q <= sum[23:0];
          r_1_q <= r_q;
          r_2_q <= r_1_q;
        end
        6'd7: v_q <= resetting_q ? '0 : sat12(acc_t'(sum) <<< 4);
        6'd8: e_q <= sum12;  // Kung eq. 15
        6'd9: begin
          de_q     <= sum12;  // Kung eq. 16
          scaled_q <= scaled;
        end
        6'd10: begin
          col_q   <= scaled_q[13:11] + 3'd3;  // Kung eq. 17
          mu_a0_q <= sum[11:0];  // Kung eq. 18
          mu_a1_q <= {1'b0, scaled_q[10:0]};
        end
        6'd11: scaled_q <= scaled;
        6'd12: begin
          row_q   <= scaled_q[13:11] + 3'd3;  // Kung eq. 17
          mu_b0_q <= sum[11:0];  // Kung eq. 18
          mu_b1_q <= {1'b0, scaled_q[10:0]};
        end
        6'd15: d00_q <= sum[11:0];  // Kung eq. 20: weights, then u at s22
        6'd16: d01_q <= sum[11:0];
        6'd17: d10_q <= sum[11:0];
        6'd18: d11_q <= sum[11:0];
        6'd22: u_q <= sat12(acc_t'(sum) >>> 11);  // Kung eq. 20
        6'd25: integral_q <= sum24;
        6'd26: v_star_q <= sum12;
        6'd27: acc_q <= sum_t'(sum12);
        6'd29: begin
          i_q_ref_q   <= sum12;
          saturated_q <= sum[39:11] != '0 && sum[39:11] != '1;
        end
        6'd34: begin
          e_prev_q   <= e_q;
          x_p_prev_q <= x_p_q;
        end
        default: acc_q <= sum;
      endcase
    end else if (running_q && resetting_q && step_q == 6'd0) begin
      // Rest at x_p, from the first clock on; s0 takes care of r_2 and s7 of the speed.
      r_1_q <= x_p_i;
      x_m_q <= {x_p_i[17:0], 14'd0};
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
