// SPDX-License-Identifier: Apache-2.0
//
// Properties of feed_rate for inputs that hold from tick to valid, as those of its callers do.

module feed_rate_props (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic [7:0] c_i,
    input logic [7:0] cc_i,

    input logic       valid_o,
    input logic [7:0] v_o,
    input logic       quiescent_o,

    input logic [4:0]      edge_q,
    input logic [5:0][7:0] member_q,
    input logic [2:0][7:0] strength_q,
    input logic [9:0]      tu_q,
    input logic [9:0]      su_q,
    input logic [6:0]      quotient_q
);

  typedef logic [7:0] byte_t;

  // Memberships as the listing intends them: 2 x, clipped; from 80h on M falls and L rises.
  function automatic byte_t rising(byte_t x);
    return x[7] ? 8'hFF : {x[6:0], 1'b0};
  endfunction

  function automatic logic [2:0][7:0] members(byte_t x);
    if (x <= 8'h80) return {8'h00, rising(x), ~rising(x)};
    return {rising({1'b0, x[6:0]}), ~rising({1'b0, x[6:0]}), 8'h00};
  endfunction

  function automatic byte_t least(byte_t a, byte_t b);
    return a < b ? a : b;
  endfunction

  function automatic byte_t most(byte_t a, byte_t b);
    return a > b ? a : b;
  endfunction

  // Strengths of S, M and L after the first n of the seven rules.
  function automatic logic [2:0][7:0] strengths(logic [5:0][7:0] mu, logic [2:0] n);
    logic [2:0][7:0] c, cc;
    {cc, c}   = mu;
    strengths = '0;
    if (n > 3'd0) strengths[0] = c[2];
    if (n > 3'd1) strengths[0] = most(strengths[0], least(cc[2], c[1]));
    if (n > 3'd2) strengths[0] = most(strengths[0], least(cc[2], c[0]));
    if (n > 3'd3) strengths[1] = least(cc[1], c[1]);
    if (n > 3'd4) strengths[1] = most(strengths[1], least(cc[1], c[0]));
    if (n > 3'd5) strengths[1] = most(strengths[1], least(cc[0], c[1]));
    if (n > 3'd6) strengths[2] = least(cc[0], c[0]);
  endfunction

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q;
  logic [4:0] age_q, was_age_q;  // clocks since the tick, 0 = idle
  byte_t c_q, cc_q, v_q;
  logic steady_q;  // the inputs held since the tick
  logic fuzzy_q;  // the memberships are those of the inputs
  logic bounded;  // TU below SU, or both 0
  logic [9:0] was_tu_q;
  logic [106:0] state, was_state_q;

  assign bounded = tu_q < su_q || (tu_q == '0 && su_q == '0);
  assign state = {edge_q, member_q, strength_q, tu_q, su_q, quotient_q, valid_o, v_o[1:0]};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_state_q     <= state;
    was_tu_q        <= tu_q;
    was_age_q       <= age_q;
    v_q             <= v_o;
    if (rst_i) age_q <= '0;
    else if (age_q == '0) age_q <= 5'(tick_i);
    else age_q <= age_q == 5'd24 ? '0 : age_q + 5'd1;
    if (age_q == '0) begin
      c_q      <= c_i;
      cc_q     <= cc_i;
      steady_q <= 1'b1;
    end else begin
      steady_q <= steady_q && c_i == c_q && cc_i == cc_q;
    end
    if (age_q == 5'd7) fuzzy_q <= member_q == {members(cc_q), members(c_q)};
    if (live_q) begin
      valid_after_25_clocks : assert (valid_o == (!was_rst_q && was_age_q == 5'd24));
      memberships_are_the_listings :
      assert (age_q != 5'd7 || !steady_q || member_q == {members(cc_q), members(c_q)});
      rules_are_the_listings :
      assert (age_q != 5'd14 || strength_q == strengths(member_q, 3'd7));
      some_rule_fires : assert (age_q < 5'd17 || !fuzzy_q || su_q != '0);
      average_below_singletons : assert (age_q != 5'd17 || bounded);
      divides_bit_by_bit :
      assert (age_q < 5'd18 || {was_tu_q, 1'b0} == 11'(tu_q) + (quotient_q[0] ? 11'(su_q) : 11'd0));
      remainder_within_divisor : assert (age_q < 5'd18 || bounded);
      output_holds : assert (was_rst_q || valid_o || v_o == v_q);
      quiescent_is_honest : assert (!was_quiescent_q || state == was_state_q);
      inv_rules :
      assert (age_q < 5'd7 || age_q > 5'd14 || strength_q == strengths(member_q, 3'(age_q - 5'd7)));
      inv_cleared : assert (age_q < 5'd8 || age_q > 5'd14 || {tu_q, su_q} == '0);
      inv_small :
      assert (age_q < 5'd15 || age_q > 5'd17 || su_q <= 10'd255 * (10'(age_q) - 10'd14));
      inv_divisor : assert (age_q < 5'd18 || su_q <= 10'd765);
      inv_sums : assert (age_q < 5'd14 || age_q > 5'd17 || bounded);
      inv_age : assert (age_q == edge_q && age_q <= 5'd24);
      reaches_254 : cover (valid_o && v_o == 8'd254);
      reaches_0 : cover (valid_o && v_o == 8'd0 && v_q != 8'd0);
    end
  end

  // breaks valid_after_25_clocks: Last = Last - 5'd1
  // breaks memberships_are_the_listings: mul_a = edge_q <= Members ? (x[6] ? Right[label].slope : Left[label].slope) : mul_a
  // breaks memberships_are_the_listings: member = (x[7] ? Right[label].falls : Left[label].falls) ? -rise : rise
  // breaks rules_are_the_listings: rule = number == 3'd0 ? rule_t'({L, S, S}) : rule
  // breaks rules_are_the_listings: strength = if_c > if_cc ? if_c : if_cc
  // breaks some_rule_fires: rule = number == 3'd6 ? rule_t'({S, L, L}) : number == 3'd5 ? rule_t'({M, L, M}) : rule
  // breaks average_below_singletons: tu_q <= edge_q > Rules && edge_q <= Sums ? tu_q + 10'(product[14:7]) : next
  // breaks divides_bit_by_bit: rest = 10'(fits ? twice - {1'b0, tu_q} : twice)
  // breaks remainder_within_divisor: fits = twice > {1'b0, su_q}
  // breaks output_holds: v_q <= edge_q >= Sums && !rst_i ? {quotient_q, fits} : next
  // breaks quiescent_is_honest: quiescent_o = edge_q == '0 && !valid_q

endmodule

bind feed_rate feed_rate_props u_feed_rate_props (.*);
