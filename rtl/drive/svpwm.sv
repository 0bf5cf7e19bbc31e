// SPDX-License-Identifier: Apache-2.0
//
// Space vector modulation (specification section 8): compare values of the three phases.
// valid_o is high at the 24th clock edge after the one that sees tick_i, over-modulated or not;
// inputs hold until then. All times are in compare counts with 6 to 8 fractional bits.
//
//   x = rs(v_beta 12496, 8), y = rs(v_alpha 21644, 8)      Q6; 12496 / 2^14 = 781 / 1024
//   X = 2 x, Y = x + y, Z = x - y                          Q7; 21644 / 12496 = sqrt 3
//   a = 1562 - t1 - t2, b = a + 2 t1, c = b + 2 t2         Q8, twice the off-times in Q7
//   t1 + t2 > 1562: a = 0, b = 1562 t1 / (t1 + t2), c = 1562
//
//   edges      what
//   0..2       v_beta 12496; x, v_alpha 21644; y
//   3..4       sector, t1, t2; t1 + t2
//   5..7       a; b; c
//   8..21      14 bits of t1 / (t1 + t2), always, so that the time is fixed
//   22..23     quotient 1562; output, valid

module svpwm
  import trammel_pkg::*;
  import math_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_i,

  input  logic       tick_i,

  input  word_t      v_alpha_i,
  input  word_t      v_beta_i,

  output logic       valid_o,
  output cmp_t       cmp_a_o,
  output cmp_t       cmp_b_o,
  output cmp_t       cmp_c_o,
  output logic [2:0] sector_o,
  output logic       quiescent_o
);

  typedef logic signed [15:0] factor_t;
  typedef logic signed [30:0] product_t;
  typedef logic signed [18:0] volt_t;  // Q6
  typedef logic        [18:0] time_t;  // Q7, at most 2134 counts
  typedef logic signed [19:0] off_t;   // Q8

  typedef enum logic [3:0] {
    StIdle, StBeta, StAlpha, StSector, StSum, StA, StB, StC, StDivide, StScale, StLast
  } state_e;

  localparam factor_t BetaScale  = 16'sd12496;
  localparam factor_t AlphaScale = 16'sd21644;
  localparam factor_t Full       = 16'sd1562;
  localparam off_t    FullOff    = 20'sd199936;  // 1562 in Q7 = 781 in Q8
  localparam logic [3:0] LastBit = 4'd13;

  state_e      state_d, state_q;
  logic        valid_d, valid_q;
  product_t    product_d, product_q;
  volt_t       x_d, x_q;
  volt_t       y_d, y_q;
  logic [2:0]  sector_d, sector_q;
  time_t       t1_d, t1_q;
  time_t       t2_d, t2_q;
  time_t       rest_d, rest_q;  // remainder of the division
  time_t       sum_d, sum_q;
  off_t        off_d, off_q;
  logic        over_d, over_q;
  cmp_t        low_d, low_q;
  cmp_t        mid_d, mid_q;
  logic [3:0]  bit_d, bit_q;
  logic [13:0] quotient_d, quotient_q;
  cmp_t        cmp_a_d, cmp_a_q;
  cmp_t        cmp_b_d, cmp_b_q;
  cmp_t        cmp_c_d, cmp_c_q;

  // The one multiplier
  logic                multiply;
  logic signed [14:0]  factor_a;
  factor_t             factor_b;
  volt_t               scaled;
  cmp_t                divided;

  assign product_d = multiply ? 31'(factor_a) * 31'(factor_b) : product_q;
  assign scaled = 19'(rs(acc_t'(product_q), 6'sd8));
  assign divided = 11'(rs(acc_t'(product_q), 6'sd14));

  // Sector code, and X, Y, Z of this vector
  logic signed [19:0] plus, minus;
  volt_t              x2;
  logic        [2:0]  sector;
  time_t              t1, t2;  // never negative

  assign x2 = x_q <<< 1;
  assign plus = 20'(x_q) + 20'(y_q);
  assign minus = 20'(x_q) - 20'(y_q);
  assign sector = {plus < 20'sd0, minus < 20'sd0, x_q > 19'sd0};

  always_comb begin
    unique case (sector)
      3'd1:    begin t1 = 19'(minus);  t2 = 19'(plus);   end
      3'd2:    begin t1 = 19'(plus);   t2 = 19'(-x2);    end
      3'd3:    begin t1 = 19'(-minus); t2 = 19'(x2);     end
      3'd4:    begin t1 = 19'(-x2);    t2 = 19'(minus);  end
      3'd5:    begin t1 = 19'(x2);     t2 = 19'(-plus);  end
      3'd6:    begin t1 = 19'(-plus);  t2 = 19'(-minus); end
      default: begin t1 = '0;          t2 = '0;          end
    endcase
  end

  // One bit of the restoring division
  logic [19:0] twice;
  logic        fits;
  time_t       rest_next;

  assign twice = {rest_q, 1'b0};
  assign fits = twice >= {1'b0, sum_q};
  assign rest_next = fits ? 19'(twice - {1'b0, sum_q}) : twice[18:0];

  // Off-times of the three patterns: a is the shortest, c the longest
  cmp_t rounded, low, mid, high;

  assign rounded = 11'(rs(acc_t'(off_q), 6'sd8));
  assign low = over_q ? '0 : low_q;
  assign mid = over_q ? divided : mid_q;
  assign high = over_q ? CmpMax : rounded;

  always_comb begin
    state_d = state_q;
    valid_d = 1'b0;
    x_d = x_q;
    y_d = y_q;
    sector_d = sector_q;
    t1_d = t1_q;
    t2_d = t2_q;
    rest_d = rest_q;
    sum_d = sum_q;
    off_d = off_q;
    over_d = over_q;
    low_d = low_q;
    mid_d = mid_q;
    bit_d = bit_q;
    quotient_d = quotient_q;
    cmp_a_d = cmp_a_q;
    cmp_b_d = cmp_b_q;
    cmp_c_d = cmp_c_q;
    multiply = 1'b0;
    factor_a = 15'(v_beta_i);
    factor_b = BetaScale;
    unique case (state_q)
      StIdle: begin
        multiply = tick_i;
        if (tick_i) state_d = StBeta;
      end
      StBeta: begin
        x_d = scaled;
        multiply = 1'b1;
        factor_a = 15'(v_alpha_i);
        factor_b = AlphaScale;
        state_d = StAlpha;
      end
      StAlpha: begin
        y_d = scaled;
        state_d = StSector;
      end
      StSector: begin
        sector_d = sector;
        t1_d = t1;
        t2_d = t2;
        state_d = StSum;
      end
      StSum: begin
        sum_d = t1_q + t2_q;
        state_d = StA;
      end
      StA: begin
        off_d = FullOff - $signed({1'b0, sum_q});
        state_d = StB;
      end
      StB: begin
        over_d = off_q < 20'sd0;
        low_d = rounded;
        off_d = off_q + $signed({t1_q, 1'b0});
        state_d = StC;
      end
      StC: begin
        mid_d = rounded;
        off_d = off_q + $signed({t2_q, 1'b0});
        rest_d = t1_q;
        bit_d = '0;
        state_d = StDivide;
      end
      StDivide: begin
        rest_d = rest_next;
        quotient_d = {quotient_q[12:0], fits};
        bit_d = bit_q + 4'd1;
        if (bit_q == LastBit) state_d = StScale;
      end
      StScale: begin
        multiply = 1'b1;
        factor_a = $signed({1'b0, quotient_q});
        factor_b = Full;
        state_d = StLast;
      end
      default: begin  // StLast
        unique case (sector_q)
          3'd1:    begin cmp_a_d = mid;  cmp_b_d = low;  cmp_c_d = high; end
          3'd2:    begin cmp_a_d = low;  cmp_b_d = high; cmp_c_d = mid;  end
          3'd4:    begin cmp_a_d = high; cmp_b_d = mid;  cmp_c_d = low;  end
          3'd5:    begin cmp_a_d = high; cmp_b_d = low;  cmp_c_d = mid;  end
          3'd6:    begin cmp_a_d = mid;  cmp_b_d = high; cmp_c_d = low;  end
          default: begin cmp_a_d = low;  cmp_b_d = mid;  cmp_c_d = high; end
        endcase
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
      x_q <= '0;
      y_q <= '0;
      sector_q <= '0;
      t1_q <= '0;
      t2_q <= '0;
      rest_q <= '0;
      sum_q <= '0;
      off_q <= '0;
      over_q <= 1'b0;
      low_q <= '0;
      mid_q <= '0;
      bit_q <= '0;
      quotient_q <= '0;
      cmp_a_q <= CmpMax / 11'd2;
      cmp_b_q <= CmpMax / 11'd2;
      cmp_c_q <= CmpMax / 11'd2;
    end else begin
      state_q <= state_d;
      valid_q <= valid_d;
      product_q <= product_d;
      x_q <= x_d;
      y_q <= y_d;
      sector_q <= sector_d;
      t1_q <= t1_d;
      t2_q <= t2_d;
      rest_q <= rest_d;
      sum_q <= sum_d;
      off_q <= off_d;
      over_q <= over_d;
      low_q <= low_d;
      mid_q <= mid_d;
      bit_q <= bit_d;
      quotient_q <= quotient_d;
      cmp_a_q <= cmp_a_d;
      cmp_b_q <= cmp_b_d;
      cmp_c_q <= cmp_c_d;
    end
  end

  assign valid_o = valid_q;
  assign cmp_a_o = cmp_a_q;
  assign cmp_b_o = cmp_b_q;
  assign cmp_c_o = cmp_c_q;
  assign sector_o = sector_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q;

endmodule
