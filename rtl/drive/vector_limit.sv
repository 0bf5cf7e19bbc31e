// SPDX-License-Identifier: Apache-2.0
//
// Voltage limit with priority of the d axis: the vector stays inside the circle of radius 2047,
// which lies inside the hexagon of the inverter.
// valid_o is high at the 2nd clock edge after the one that sees tick_i; inputs hold until then.
//
//   v_d = clip(v_d, +-2047)
//   |v_q| <= L(n), n = |v_d| >> 5, L(n) = floor(sqrt(2047^2 - min(2047, 32 (n + 1))^2))
//
//   edge 0     L(n) from the table
//   edge 1     v_d, v_q; valid

module vector_limit
  import trammel_pkg::*;
(
  input  logic  clk_i,
  input  logic  rst_i,

  input  logic  tick_i,

  input  word_t v_d_i,
  input  word_t v_q_i,

  output logic  valid_o,
  output word_t v_d_o,
  output word_t v_q_o,
  output logic  limited_o,
  output logic  quiescent_o
);

  localparam word_t VdMax = 12'sd2047;
  localparam logic [10:0] Limit[64] = '{
    11'd2046, 11'd2045, 11'd2044, 11'd2042, 11'd2040, 11'd2037, 11'd2034, 11'd2030,
    11'd2026, 11'd2021, 11'd2016, 11'd2010, 11'd2004, 11'd1997, 11'd1989, 11'd1981,
    11'd1973, 11'd1964, 11'd1954, 11'd1944, 11'd1933, 11'd1922, 11'd1910, 11'd1897,
    11'd1884, 11'd1870, 11'd1855, 11'd1840, 11'd1824, 11'd1807, 11'd1790, 11'd1772,
    11'd1753, 11'd1733, 11'd1713, 11'd1692, 11'd1669, 11'd1646, 11'd1622, 11'd1597,
    11'd1571, 11'd1543, 11'd1515, 11'd1485, 11'd1454, 11'd1422, 11'd1388, 11'd1353,
    11'd1315, 11'd1276, 11'd1235, 11'd1192, 11'd1146, 11'd1097, 11'd1045, 11'd0989,
    11'd0929, 11'd0863, 11'd0790, 11'd0709, 11'd0616, 11'd0503, 11'd0354, 11'd0000
  };

  logic        busy_d, busy_q;
  logic        valid_q;
  logic [10:0] limit_d, limit_q;
  word_t       v_d_d, v_d_q;
  word_t       v_q_d, v_q_q;
  logic        limited_d, limited_q;

  logic        d_out, q_high, q_low;  // outside the limit
  word_t       clipped_d;
  logic [5:0]  row;  // |v_d| >> 5
  word_t       limit;

  assign busy_d = tick_i && !busy_q;
  assign d_out = v_d_i == -12'sd2048;
  assign clipped_d = d_out ? -VdMax : v_d_i;
  assign row = clipped_d >= 12'sd0 ? clipped_d[10:5] : 6'((-clipped_d) >> 5);
  assign limit = $signed({1'b0, limit_q});
  assign q_high = v_q_i > limit;
  assign q_low = v_q_i < -limit;

  always_comb begin
    limit_d = limit_q;
    v_d_d = v_d_q;
    v_q_d = v_q_q;
    limited_d = limited_q;
    if (busy_d) limit_d = Limit[row];
    if (busy_q) begin
      v_d_d = clipped_d;
      v_q_d = q_high ? limit : q_low ? -limit : v_q_i;
      limited_d = d_out || q_high || q_low;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      busy_q <= 1'b0;
      valid_q <= 1'b0;
      limit_q <= '0;
      v_d_q <= '0;
      v_q_q <= '0;
      limited_q <= 1'b0;
    end else begin
      busy_q <= busy_d;
      valid_q <= busy_q;
      limit_q <= limit_d;
      v_d_q <= v_d_d;
      v_q_q <= v_q_d;
      limited_q <= limited_d;
    end
  end

  assign valid_o = valid_q;
  assign v_d_o = v_d_q;
  assign v_q_o = v_q_q;
  assign limited_o = limited_q;
  assign quiescent_o = !busy_q && !tick_i && !valid_q;

endmodule
