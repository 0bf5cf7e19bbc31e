// SPDX-License-Identifier: Apache-2.0
//
// Properties of svpwm for any input. The model knows no sectors: from the differences of the phases
// X = u_b - u_c, Y = u_a - u_c, Z = u_b - u_a the off-time is top / 2 - (u - (u_max + u_min) / 2).

module svpwm_props
  import trammel_pkg::*;
#(
    parameter int unsigned ClockHz = 50_000_000
) (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input carrier_t carrier_i,

    input word_t v_alpha_i,
    input word_t v_beta_i,

    input logic       valid_o,
    input cmp_t       cmp_a_o,
    input cmp_t       cmp_b_o,
    input cmp_t       cmp_c_o,
    input logic [2:0] sector_o,
    input logic       quiescent_o,

    input logic        [ 3:0] state_q,
    input carrier_t           carrier_q,
    input logic               multiply,
    input logic signed [14:0] factor_a,
    input logic signed [15:0] factor_b,
    input logic signed [30:0] product_q,
    input logic signed [18:0] x_q,
    input logic signed [18:0] y_q,
    input logic        [ 2:0] sector_q,
    input logic        [18:0] t1_q,
    input logic        [18:0] sum_q,
    input logic signed [19:0] off_q,
    input logic               over_q,
    input cmp_t               low_q,
    input cmp_t               mid_q,
    input logic        [ 3:0] bit_q,
    input logic        [13:0] quotient_q
);

  typedef logic signed [35:0] wide_t;
  typedef logic signed [21:0] line_t;  // Q7

  // Half the period of each carrier, rounded down [clk].
  localparam wide_t Top16kHz = 36'(32'(ClockHz / 32'd32_000));
  localparam wide_t Top8kHz  = 36'(32'(ClockHz / 32'd16_000));
  localparam wide_t Top20kHz = 36'(32'(ClockHz / 32'd40_000));
  localparam wide_t Top40kHz = 36'(32'(ClockHz / 32'd80_000));
  localparam wide_t Root3    = 36'sd1816187;  // 2^20 sqrt 3
  localparam wide_t Beta8kHz  = 36'sd4 * Top8kHz;  // the largest
  localparam wide_t Alpha8kHz = (Beta8kHz * Root3 + 36'sd524288) >>> 20;

  localparam wide_t BetaMax  = 36'sd2048 * Beta8kHz;  // products
  localparam wide_t AlphaMax = 36'sd2048 * Alpha8kHz;
  localparam wide_t ScaleMax = 36'sd16383 * Top8kHz;
  localparam line_t XMax     = 22'(36'sd8 * Beta8kHz);  // Q6
  localparam line_t YMax     = 22'(36'sd8 * Alpha8kHz);

  // Words of the carrier: 2^14 V_dc / sqrt 3 to counts, and sqrt 3 times that; half its top in Q8,
  // Q7 at 8 kHz; the half of the rounding there.
  function automatic logic signed [15:0] beta_of(carrier_t carrier);
    return carrier == 2'd1 ? 16'(Beta8kHz) : carrier == 2'd2 ? 16'(36'sd8 * Top20kHz) :
        carrier == 2'd3 ? 16'(36'sd8 * Top40kHz) : 16'(36'sd8 * Top16kHz);
  endfunction

  function automatic logic signed [15:0] alpha_of(carrier_t carrier);
    return carrier == 2'd1 ? 16'(Alpha8kHz) :
        carrier == 2'd2 ? 16'((36'sd8 * Top20kHz * Root3 + 36'sd524288) >>> 20) :
        carrier == 2'd3 ? 16'((36'sd8 * Top40kHz * Root3 + 36'sd524288) >>> 20) :
        16'((36'sd8 * Top16kHz * Root3 + 36'sd524288) >>> 20);
  endfunction

  carrier_t used_q;  // of this vector
  logic signed [15:0] top;
  line_t full, half;

  assign top  = used_q == 2'd1 ? 16'(Top8kHz) : used_q == 2'd2 ? 16'(Top20kHz) :
      used_q == 2'd3 ? 16'(Top40kHz) : 16'(Top16kHz);
  assign half = used_q == 2'd1 ? 22'sd64 : 22'sd128;
  assign full = 22'(top) * half;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic start;
  logic [24:0] due_q;  // vectors in flight, the oldest in the highest bit
  logic step_q;  // of the division, at the previous edge
  line_t x, y;  // Q6
  line_t u_bc, u_ac, u_ba;  // differences of the phases
  line_t span, spread, rest;  // u_max - u_min, u_max - u_mid, u_mid - u_min
  line_t span_q, spread_q, rest_q, off_a_q, off_b_q, off_c_q;  // as soon as x and y are there
  logic over;
  line_t t1, sum, low, mid, high;  // as registers hold them
  wide_t product, was_product_q;
  logic [18:0] was_t1_q;
  logic [12:0] was_quotient_q;
  logic [38:0] outputs, was_outputs_q;
  logic [176:0] state, was_state_q;

  function automatic line_t more(line_t p, line_t q);
    return p > q ? p : q;
  endfunction

  function automatic line_t less(line_t p, line_t q);
    return p < q ? p : q;
  endfunction

  // Off-time of a phase with these differences to the others, plus the rounding half.
  function automatic line_t off_time(line_t p, line_t q);
    return full + half - more(more(p, q), 22'sd0) - less(less(p, q), 22'sd0);
  endfunction

  function automatic logic is_off(cmp_t found, line_t off);
    return line_t'({10'd0, found}) == (used_q == 2'd1 ? off >>> 7 : off >>> 8);
  endfunction

  // Over-modulated: off-time 0 for the highest phase, the top for the lowest, a quotient between.
  function automatic logic is_over(cmp_t found, line_t p, line_t q);
    if (p > 22'sd0 && q > 22'sd0) return found == '0;
    if (p < 22'sd0 && q < 22'sd0) return 16'(found) == top;
    return p == 22'sd0 || q == 22'sd0 ||
        wide_t'({1'b0, found}) == (was_product_q + 36'sd8192) >>> 14;
  endfunction

  assign start   = tick_i && due_q[23:0] == '0;
  assign x       = line_t'(x_q);
  assign y       = line_t'(y_q);
  assign u_bc    = x <<< 1;
  assign u_ac    = x + y;
  assign u_ba    = x - y;
  assign span    = more(more(more(u_bc, -u_bc), more(u_ac, -u_ac)), more(u_ba, -u_ba));
  assign over    = span_q > full;
  assign t1      = line_t'({3'd0, t1_q});
  assign sum     = line_t'({3'd0, sum_q});
  assign product = wide_t'(product_q);
  assign outputs = {cmp_c_o, cmp_b_o, cmp_a_o, sector_o};
  assign state   = {state_q, product_q, x_q, y_q, sector_q, t1_q, sum_q, off_q, over_q, low_q,
                    mid_q, bit_q, quotient_q};

  always_comb begin
    if (u_ac >= 22'sd0 && u_ba <= 22'sd0) begin  // a is the highest phase
      spread = less(u_ac, -u_ba);
      rest   = more(u_bc, -u_bc);
    end else if (u_bc >= 22'sd0 && u_ba >= 22'sd0) begin
      spread = less(u_bc, u_ba);
      rest   = more(u_ac, -u_ac);
    end else begin
      spread = less(-u_bc, -u_ac);
      rest   = more(u_ba, -u_ba);
    end
  end

  // The off-times sorted by the sector.
  always_comb begin
    unique case (sector_q)
      3'd1:    {low, mid, high} = {off_b_q, off_a_q, off_c_q};
      3'd2:    {low, mid, high} = {off_a_q, off_c_q, off_b_q};
      3'd4:    {low, mid, high} = {off_c_q, off_b_q, off_a_q};
      3'd5:    {low, mid, high} = {off_b_q, off_c_q, off_a_q};
      3'd6:    {low, mid, high} = {off_c_q, off_a_q, off_b_q};
      default: {low, mid, high} = {off_a_q, off_b_q, off_c_q};
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    was_outputs_q   <= outputs;
    if (start) used_q <= carrier_i;
    due_q           <= rst_i ? '0 : {due_q[23:0], start};
    step_q          <= due_q[21:8] != '0 && !rst_i;
    was_product_q   <= product;
    was_t1_q        <= t1_q;
    was_quotient_q  <= quotient_q[12:0];
    if (due_q[3]) begin
      spread_q <= spread;
      rest_q   <= rest;
      off_a_q  <= off_time(-u_ba, u_ac);
      off_b_q  <= off_time(u_ba, u_bc);
      off_c_q  <= off_time(-u_bc, -u_ac);
      span_q   <= span;
    end
    if (live_q) begin
      valid_after_25_clocks : assert (valid_o == due_q[24]);
      multiplies_in_order :
      assert (multiply == (start || due_q[0] || due_q[22]) &&
              (!start || (factor_a == 15'(v_beta_i) && factor_b == beta_of(carrier_i))) &&
              (!due_q[0] || (factor_a == 15'(v_alpha_i) && factor_b == alpha_of(used_q))) &&
              (!due_q[22] || (factor_a == $signed({1'b0, quotient_q}) && factor_b == top)));
      no_overflow :
      assert ((!due_q[1] || wide_t'(x) == (was_product_q + 36'sd128) >>> 8) &&
              (!due_q[2] || wide_t'(y) == (was_product_q + 36'sd128) >>> 8));
      sector_is_of_the_signs :
      assert (!valid_o || sector_o == {u_ac < 22'sd0, u_ba < 22'sd0, u_bc > 22'sd0});
      duty_is_min_max :
      assert (!valid_o || over ||
              (is_off(cmp_a_o, off_a_q) && is_off(cmp_b_o, off_b_q) && is_off(cmp_c_o, off_c_q)));
      over_modulated_to_the_ends :
      assert (!valid_o || !over || (is_over(cmp_a_o, -u_ba, u_ac) && is_over(cmp_b_o, u_ba, u_bc) &&
                                    is_over(cmp_c_o, -u_bc, -u_ac)));
      divides_bit_by_bit :
      assert (!step_q || (quotient_q[13:1] == was_quotient_q &&
                          t1 == line_t'({2'd0, was_t1_q, 1'b0}) - (quotient_q[0] ? sum : '0)));
      remainder_within_divisor : assert (!due_q[22] || t1 <= sum);
      compare_within_carrier :
      assert (!valid_o ||
              16'(cmp_a_o) <= top && 16'(cmp_b_o) <= top && 16'(cmp_c_o) <= top);
      outputs_hold : assert (was_rst_q || valid_o || outputs == was_outputs_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (state == was_state_q && outputs == was_outputs_q && !valid_o));
      inv_state :
      assert (state_q == (due_q[21:8] != '0 ? 4'd9 : due_q[22] ? 4'd10 : due_q[23] ? 4'd11 :
                          due_q[0] ? 4'd1 : due_q[1] ? 4'd2 : due_q[2] ? 4'd3 : due_q[3] ? 4'd4 :
                          due_q[4] ? 4'd5 : due_q[5] ? 4'd6 : due_q[6] ? 4'd7 : due_q[7] ? 4'd8 :
                          4'd0));
      inv_carrier : assert (due_q == '0 || carrier_q == used_q);
      inv_one : assert ((due_q[23:0] & (due_q[23:0] - 24'd1)) == '0);
      inv_bit : assert (due_q[21:8] == '0 || due_q[5'(bit_q)+5'd8]);
      inv_beta : assert (!due_q[0] || (product <= BetaMax && product >= -BetaMax));
      inv_alpha : assert (!due_q[1] || (product <= AlphaMax && product >= -AlphaMax));
      inv_scale : assert (!due_q[23] || (product <= ScaleMax && product >= 36'sd0));
      inv_x : assert (x <= XMax && x >= -XMax);
      inv_y : assert (y <= YMax && y >= -YMax);
      inv_sector :
      assert (due_q[23:3] == '0 || sector_q == {u_ac < 22'sd0, u_ba < 22'sd0, u_bc > 22'sd0});
      inv_t1 : assert (due_q[8:4] == '0 || t1 == spread_q);
      inv_sum : assert (due_q[23:5] == '0 || sum == span_q);
      inv_span :
      assert (due_q[24:4] == '0 || (span_q <= XMax + YMax && span_q == spread_q + rest_q));
      inv_spread : assert (due_q[24:4] == '0 || (spread_q >= 22'sd0 && rest_q >= 22'sd0));
      inv_sorted_low : assert (due_q[23:4] == '0 || low == full + half - span_q);
      inv_sorted_mid :
      assert (due_q[23:4] == '0 || mid == full + half - rest_q + spread_q);
      inv_sorted_high : assert (due_q[23:4] == '0 || high == full + half + span_q);
      inv_off_low : assert (!due_q[6] || line_t'(off_q) == low);
      inv_off_mid : assert (!due_q[7] || line_t'(off_q) == mid);
      inv_off_high : assert (due_q[23:8] == '0 || line_t'(off_q) == high);
      inv_over : assert (due_q[23:7] == '0 || over_q == over);
      inv_low : assert (due_q[23:7] == '0 || (over ? low_q == '0 : is_off(low_q, low)));
      inv_mid : assert (due_q[23:8] == '0 || over || is_off(mid_q, mid));
      inv_remainder : assert (due_q[22:8] == '0 || t1 <= sum);
      reaches_plain : cover (valid_o && !over && sector_o == 3'd3);
      reaches_over_modulation : cover (valid_o && over);
    end
  end

  // prove: frames 60
  // prove: set ClockHz=50000000
  // prove: set ClockHz=48000000

  // breaks valid_after_25_clocks: LastBit = LastBit - 4'd1
  // breaks multiplies_in_order: factor_a = state_q == StIdle ? 15'(v_alpha_i) : factor_a
  // breaks no_overflow: y_d = state_q == StAlpha ? {{2{scaled[16]}}, scaled[16:0]} : y_d
  // breaks no_overflow: scaled = product_q[26:8]
  // breaks duty_is_min_max: full_off = carrier_q == Carrier8kHz ? 20'(64 * Top8kHz + 128) : full_off
  // breaks duty_is_min_max: carrier_q <= rst_i ? next : carrier_i
  // breaks sector_is_of_the_signs: sector = {plus < 20'sd0, minus <= 20'sd0, x_q > 19'sd0}
  // breaks duty_is_min_max: magnitude = picked
  // breaks duty_is_min_max: addend = state_q == StB ? $signed({1'b0, t1_q}) : addend
  // breaks over_modulated_to_the_ends: high = rounded
  // breaks over_modulated_to_the_ends: mid = mid_q
  // breaks divides_bit_by_bit: quotient_d = state_q == StDivide ? {quotient_q[12:0], !fits} : quotient_d
  // breaks divides_bit_by_bit: t1_d = state_q == StDivide ? (fits ? twice[18:0] : remainder[18:0]) : t1_d
  // breaks remainder_within_divisor: fits = remainder[19]
  // breaks compare_within_carrier: low_d = state_q == StB ? rounded : low_d
  // breaks outputs_hold: cmp_c_d = state_q == StLast ? cmp_c_d : low_q
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle

endmodule

bind svpwm svpwm_props #(.ClockHz(ClockHz)) u_svpwm_props (
    .*,
    .state_q(state_q)  // no .* for an enum
);
