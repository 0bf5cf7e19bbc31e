// SPDX-License-Identifier: Apache-2.0
//
// Space vector modulation (specification section 8): compare values of the three phases.
// valid_o is high at the 25th clock edge after the one that sees tick_i, over-modulated or not;
// inputs hold until then. All times are in compare counts with 6 to 8 fractional bits.
//
//   x = rs(v_beta beta, 8), y = rs(v_alpha alpha, 8)       Q6; beta / 2^14 = top / 2 / 1024
//   X = 2 x, Y = x + y, Z = x - y                          Q7; alpha / beta = sqrt 3
//   S = t1 + t2 and t1 are magnitudes of X, Y, Z: case table below
//   a = top - S, b = a + 2 t1, c = top + S                 Q8, twice the off-times in Q7
//   S > top: a = 0, b = top t1 / S, c = top
//
//   50 MHz    top    beta   alpha   top = ClockHz / 2 carrier, beta = 8 top (4 top at 8 kHz)
//    8 kHz    3125   12500  21651   in Q5, Q6, Q7 instead of Q6, Q7, Q8
//   16 kHz    1562   12496  21644
//   20 kHz    1250   10000  17321
//   40 kHz     625    5000   8660
//
//   edges      what
//   0..2       v_beta beta; x, v_alpha alpha; y
//   3..5       sector; t1; S
//   6..8       a; b; c
//   9..22      14 bits of t1 / S, always, so that the latency is fixed
//   23..24     quotient top; output, valid

module svpwm
  import trammel_pkg::*;
  import math_pkg::*;
#(
  parameter int unsigned ClockHz = 50_000_000
) (
  input  logic       clk_i,
  input  logic       rst_i,

  input  logic       tick_i,

  input  carrier_t   carrier_i,

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
  typedef logic        [18:0] time_t;  // Q7, at most 2363 counts
  typedef logic signed [19:0] off_t;   // Q8

  typedef enum logic [3:0] {
    StIdle, StBeta, StAlpha, StSector, StTime, StSum, StA, StB, StC, StDivide, StScale, StLast
  } state_e;
  typedef enum logic [1:0] {PickX, PickY, PickZ} pick_e;

  if (!makes_carriers(ClockHz)) begin : gen_refused
    $error("svpwm: its carriers need ClockHz to be a multiple of 80,000, 8 to 55.36 MHz");
  end

  localparam logic [3:0] LastBit = 4'd13;

  localparam periods_t    Periods   = pwm_periods(ClockHz);
  localparam int unsigned Top16kHz  = 32'(Periods[Carrier16kHz]) >> 1;
  localparam int unsigned Top8kHz   = 32'(Periods[Carrier8kHz]) >> 1;
  localparam int unsigned Top20kHz  = 32'(Periods[Carrier20kHz]) >> 1;
  localparam int unsigned Top40kHz  = 32'(Periods[Carrier40kHz]) >> 1;
  localparam int unsigned Root3     = 32'd113_512;  // 2^16 sqrt 3
  localparam int unsigned Half      = 32'd32_768;

  carrier_t carrier_q;  // of this vector
  factor_t beta_scale, alpha_scale;
  off_t    full_off;  // top / 2, plus the rounding half
  cmp_t    top;
  logic    coarse;    // one fractional bit less

  assign top    = cmp_max(Periods[carrier_q]);
  assign coarse = carrier_q == Carrier8kHz;

  always_comb begin
    unique case (carrier_i)
      Carrier8kHz:  beta_scale = 16'(4 * Top8kHz);
      Carrier20kHz: beta_scale = 16'(8 * Top20kHz);
      Carrier40kHz: beta_scale = 16'(8 * Top40kHz);
      default:      beta_scale = 16'(8 * Top16kHz);
    endcase
    unique case (carrier_q)
      Carrier8kHz:  alpha_scale = 16'((4 * Top8kHz * Root3 + Half) >> 16);
      Carrier20kHz: alpha_scale = 16'((8 * Top20kHz * Root3 + Half) >> 16);
      Carrier40kHz: alpha_scale = 16'((8 * Top40kHz * Root3 + Half) >> 16);
      default:      alpha_scale = 16'((8 * Top16kHz * Root3 + Half) >> 16);
    endcase
    unique case (carrier_q)
      Carrier8kHz:  full_off = 20'(64 * Top8kHz + 64);
      Carrier20kHz: full_off = 20'(128 * Top20kHz + 128);
      Carrier40kHz: full_off = 20'(128 * Top40kHz + 128);
      default:      full_off = 20'(128 * Top16kHz + 128);
    endcase
  end

  state_e      state_d, state_q;
  logic        valid_d, valid_q;
  product_t    product_d, product_q;
  volt_t       x_d, x_q;
  volt_t       y_d, y_q;
  logic [2:0]  sector_d, sector_q;
  time_t       t1_d, t1_q;    // then the remainder of the division
  time_t       sum_d, sum_q;
  off_t        off_d, off_q;
  logic        over_d, over_q;
  cmp_t        low_d, low_q;
  cmp_t        mid_d, mid_q;
  logic [3:0]  bit_d, bit_q;
  logic [13:0] quotient_d, quotient_q;
  logic [2:0]  code_d, code_q;
  cmp_t        cmp_a_d, cmp_a_q;
  cmp_t        cmp_b_d, cmp_b_q;
  cmp_t        cmp_c_d, cmp_c_q;

  // The one multiplier and its rounded product
  logic               multiply;
  logic signed [14:0] factor_a;
  factor_t            factor_b;
  volt_t              scaled;
  cmp_t               divided;

  assign product_d = multiply ? 31'(factor_a) * 31'(factor_b) : product_q;
  assign scaled = 19'(rs(acc_t'(product_q), 6'sd8));
  assign divided = 12'(rs(acc_t'(product_q), 6'sd14));

  // X, Y, Z and the sector code of this vector: the signs of Kung eq. 8
  logic signed [19:0] plus, minus;
  logic         [2:0] sector;

  assign plus = 20'(x_q) + 20'(y_q);
  assign minus = 20'(x_q) - 20'(y_q);
  assign sector = {plus < 20'sd0, minus < 20'sd0, x_q > 19'sd0};

  // t1 (first) or S of the sector: one of X, Y, Z, negated where it is negative
  logic               first, negative;
  pick_e              pick;
  time_t              picked, magnitude;

  always_comb begin
    negative = 1'b0;
    unique case (sector_q)
      3'd1:    pick = first ? PickZ : PickX;
      3'd2:    begin pick = first ? PickY : PickZ; negative = !first; end
      3'd3:    begin pick = first ? PickZ : PickY; negative = first; end
      3'd4:    begin pick = first ? PickX : PickY; negative = 1'b1; end
      3'd5:    pick = first ? PickX : PickZ;
      3'd6:    begin pick = first ? PickY : PickX; negative = 1'b1; end
      default: pick = PickX;
    endcase
    unique case (pick)
      PickX:   picked = {x_q[17:0], 1'b0};
      PickY:   picked = plus[18:0];
      default: picked = minus[18:0];
    endcase
    magnitude = (negative ? ~picked : picked) + 19'(negative);
  end

  // One bit of the restoring division
  logic [19:0] twice, remainder;
  logic        fits;

  assign twice = {t1_q, 1'b0};
  assign remainder = twice - {1'b0, sum_q};
  assign fits = !remainder[19];

  // Off-times: the shortest a, b, the longest c
  off_t base, addend;
  logic subtract;
  cmp_t rounded, mid, high;

  assign off_d = base + (subtract ? ~addend : addend) + 20'(subtract);
  assign rounded = coarse ? off_q[18:7] : {1'b0, off_q[18:8]};  // the half is in full_off
  assign mid = over_q ? divided : mid_q;
  assign high = over_q ? top : rounded;

  always_comb begin
    state_d = state_q;
    valid_d = 1'b0;
    x_d = x_q;
    y_d = y_q;
    sector_d = sector_q;
    t1_d = t1_q;
    sum_d = sum_q;
    over_d = over_q;
    low_d = low_q;
    mid_d = mid_q;
    bit_d = bit_q;
    quotient_d = quotient_q;
    code_d = code_q;
    cmp_a_d = cmp_a_q;
    cmp_b_d = cmp_b_q;
    cmp_c_d = cmp_c_q;
    multiply = 1'b0;
    factor_a = 15'(v_beta_i);
    factor_b = beta_scale;
    first = 1'b0;
    base = off_q;
    addend = '0;
    subtract = 1'b0;
    unique case (state_q)
      StIdle: begin
        multiply = tick_i;
        if (tick_i) state_d = StBeta;
      end
      StBeta: begin
        x_d = scaled;
        multiply = 1'b1;
        factor_a = 15'(v_alpha_i);
        factor_b = alpha_scale;
        state_d = StAlpha;
      end
      StAlpha: begin
        y_d = scaled;
        state_d = StSector;
      end
      StSector: begin
        sector_d = sector;
        state_d = StTime;
      end
      StTime: begin
        first = 1'b1;
        t1_d = magnitude;
        state_d = StSum;
      end
      StSum: begin
        sum_d = magnitude;
        state_d = StA;
      end
      StA: begin
        base = full_off;
        addend = $signed({1'b0, sum_q});
        subtract = 1'b1;
        state_d = StB;
      end
      StB: begin
        over_d = off_q < (coarse ? 20'sd64 : 20'sd128);
        low_d = over_d ? '0 : rounded;
        addend = $signed({t1_q, 1'b0});
        state_d = StC;
      end
      StC: begin
        mid_d = rounded;
        base = full_off;
        addend = $signed({1'b0, sum_q});
        bit_d = '0;
        state_d = StDivide;
      end
      StDivide: begin
        t1_d = fits ? remainder[18:0] : twice[18:0];
        quotient_d = {quotient_q[12:0], fits};
        bit_d = bit_q + 4'd1;
        if (bit_q == LastBit) state_d = StScale;
      end
      StScale: begin
        multiply = 1'b1;
        factor_a = $signed({1'b0, quotient_q});
        factor_b = 16'(top);
        state_d = StLast;
      end
      default: begin  // StLast
        unique case (sector_q)
          3'd1:    begin cmp_a_d = mid;   cmp_b_d = low_q; cmp_c_d = high;  end
          3'd2:    begin cmp_a_d = low_q; cmp_b_d = high;  cmp_c_d = mid;   end
          3'd4:    begin cmp_a_d = high;  cmp_b_d = mid;   cmp_c_d = low_q; end
          3'd5:    begin cmp_a_d = high;  cmp_b_d = low_q; cmp_c_d = mid;   end
          3'd6:    begin cmp_a_d = mid;   cmp_b_d = high;  cmp_c_d = low_q; end
          default: begin cmp_a_d = low_q; cmp_b_d = mid;   cmp_c_d = high;  end
        endcase
        code_d = sector_q;
        valid_d = 1'b1;
        state_d = StIdle;
      end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q <= StIdle;
      valid_q <= 1'b0;
      carrier_q <= Carrier16kHz;
      product_q <= '0;
      x_q <= '0;
      y_q <= '0;
      sector_q <= '0;
      t1_q <= '0;
      sum_q <= '0;
      off_q <= '0;
      over_q <= 1'b0;
      low_q <= '0;
      mid_q <= '0;
      bit_q <= '0;
      quotient_q <= '0;
      code_q <= '0;
      cmp_a_q <= 12'(Top16kHz >> 1);
      cmp_b_q <= 12'(Top16kHz >> 1);
      cmp_c_q <= 12'(Top16kHz >> 1);
    end else begin
      state_q <= state_d;
      valid_q <= valid_d;
      if (state_q == StIdle && tick_i) carrier_q <= carrier_i;
      product_q <= product_d;
      x_q <= x_d;
      y_q <= y_d;
      sector_q <= sector_d;
      t1_q <= t1_d;
      sum_q <= sum_d;
      off_q <= off_d;
      over_q <= over_d;
      low_q <= low_d;
      mid_q <= mid_d;
      bit_q <= bit_d;
      quotient_q <= quotient_d;
      code_q <= code_d;
      cmp_a_q <= cmp_a_d;
      cmp_b_q <= cmp_b_d;
      cmp_c_q <= cmp_c_d;
    end
  end

  assign valid_o = valid_q;
  assign cmp_a_o = cmp_a_q;
  assign cmp_b_o = cmp_b_q;
  assign cmp_c_o = cmp_c_q;
  assign sector_o = code_q;
  assign quiescent_o = state_q == StIdle && !tick_i && !valid_q;

endmodule
