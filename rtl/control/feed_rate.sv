// SPDX-License-Identifier: Apache-2.0
//
// Fuzzy feed rate of self-paced tracking (McAfee 1994, appendix D): a speed from the curvature c of
// the path and its change cc ahead. Labels S, M, L; minimum for AND, maximum to merge rules, then
// the average of singletons weighted by strength. Rule tables and slopes are those of the listing.
// valid_o is high at the 25th clock edge after the one that sees tick_i; inputs hold until then.
//
//   edge 1-6     memberships c.S c.M c.L cc.S cc.M cc.L      multiplier: slope x mod 80h
//   edge 7-13    rules, one each
//   edge 14-16   TU = sum (strength singleton) >> 8          multiplier: strength singleton
//                SU = sum strength
//   edge 17-24   v = floor(256 TU / SU), one bit each, highest first

module feed_rate (
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic [7:0] c_i,
    input logic [7:0] cc_i,

    output logic       valid_o,
    output logic [7:0] v_o,
    output logic       quiescent_o
);

  localparam logic [4:0] Members = 5'd6, Rules = 5'd13, Sums = 5'd16, Last = 5'd24;

  localparam logic [1:0] S = 2'd0;
  localparam logic [1:0] M = 2'd1;
  localparam logic [1:0] L = 2'd2;
  localparam logic [1:0] Any = 2'd3;

  // Over half the universe a membership rises from 0, or falls from 255, by slope / 16 per unit.
  // The listing has x = 80h in the left half; there both halves give the same.
  typedef struct packed {
    logic       falls;
    logic [7:0] slope;
  } segment_t;

  localparam segment_t [2:0] Left  = {9'h0_00, 9'h0_20, 9'h1_20};  // L, M, S
  localparam segment_t [2:0] Right = {9'h0_20, 9'h1_20, 9'h0_00};

  typedef struct packed {logic [1:0] c, cc, v;} rule_t;

  // Column c = L is one rule with a single antecedent: cc does not matter.
  localparam rule_t [6:0] Rule = {
      {S, S, L}, {M, S, M}, {S, M, M}, {M, M, M}, {S, L, S}, {M, L, S}, {L, Any, S}};
  localparam logic [2:0][7:0] Singleton = {8'hFF, 8'h80, 8'h00};  // L, M, S

  logic valid_q;
  logic [4:0] edge_q;  // number of the next edge, 0 = idle
  logic [5:0][7:0] member_q;  // in the order of edges 1-6, the first one lowest
  logic [2:0][7:0] strength_q;  // of the labels of v
  logic [9:0] tu_q;  // then the remainder
  logic [9:0] su_q;
  logic [6:0] quotient_q;
  logic [7:0] v_q;

  logic [ 7:0] mul_a, mul_b;
  logic [15:4] product;
  logic [ 3:0] unused_product;

  // ---- memberships ----

  logic [2:0] which;  // 0..5
  logic [1:0] label;
  logic [7:0] x;
  logic [7:0] rise, member;

  assign which   = 3'(edge_q - 5'd1);
  assign label   = which >= 3'd3 ? 2'(which - 3'd3) : which[1:0];
  assign x       = which >= 3'd3 ? cc_i : c_i;
  assign rise    = product[11:4];  // below 256: slopes are 32 / 16 at most
  assign member  = (x[7] ? Right[label].falls : Left[label].falls) ? ~rise : rise;

  // ---- rules ----

  logic [2:0] number;  // 0..6
  rule_t rule;
  logic [7:0] if_c, if_cc, strength;

  function automatic logic [7:0] degree(logic [1:0] label_of, logic [2:0][7:0] members);
    return label_of == Any ? 8'hFF : members[label_of];
  endfunction

  assign number   = 3'(edge_q - Members - 5'd1);
  assign rule     = Rule[number];
  assign if_c     = degree(rule.c, member_q[2:0]);
  assign if_cc    = degree(rule.cc, member_q[5:3]);
  assign strength = if_c < if_cc ? if_c : if_cc;

  // ---- sums and quotient ----

  logic [ 1:0] sum;  // label whose strength is in strength_q[0]
  logic [10:0] twice;
  logic [ 9:0] rest;
  logic fits;

  assign sum     = 2'(edge_q - Rules - 5'd1);

  always_comb begin
    mul_a = Singleton[sum];
    mul_b = strength_q[0];
    if (edge_q <= Members) begin
      mul_a = x[7] ? Right[label].slope : Left[label].slope;
      mul_b = {1'b0, x[6:0]};
    end
  end

  assign {product, unused_product} = mul_a * mul_b;
  assign twice   = {tu_q, 1'b0};
  assign fits    = twice >= {1'b0, su_q};
  assign rest    = 10'(fits ? twice - {1'b0, su_q} : twice);

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      valid_q <= 1'b0;
      edge_q  <= '0;
      v_q     <= '0;
    end else begin
      valid_q <= edge_q == Last;
      if (edge_q == '0) edge_q <= 5'(tick_i);
      else edge_q <= edge_q == Last ? '0 : edge_q + 5'd1;
      if (edge_q == Last) v_q <= {quotient_q, fits};
    end
  end

  always_ff @(posedge clk_i) begin
    if (edge_q == '0) begin
      // idle: all registers hold
    end else if (edge_q <= Members) begin
      member_q   <= {member, member_q[5:1]};
      strength_q <= '0;
    end else if (edge_q <= Rules) begin
      for (int k = 0; k < 3; k++) begin
        if (rule.v == 2'(k) && strength > strength_q[k]) strength_q[k] <= strength;
      end
      {tu_q, su_q} <= '0;
    end else if (edge_q <= Sums) begin
      strength_q <= {8'd0, strength_q[2:1]};
      tu_q       <= tu_q + 10'(product[15:8]);
      su_q       <= su_q + 10'(strength_q[0]);
    end else begin
      tu_q       <= rest;
      quotient_q <= {quotient_q[5:0], fits};
    end
  end

  assign valid_o     = valid_q;
  assign v_o         = v_q;
  assign quiescent_o = edge_q == '0 && !tick_i && !valid_q;

endmodule
