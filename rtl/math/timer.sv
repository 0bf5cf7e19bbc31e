// SPDX-License-Identifier: Apache-2.0
//
// Down counter: the one primitive behind everything that counts or waits by itself.
//
//   load:     count' = value
//   no load:  count' = max(count - (1 + leap), 0)
//
// next_o is the number of clock edges, from the present one on, that do nothing but count. The edge
// that makes the count 0 is the event, and so is a load. A caller leaps only where leap_i < next_o.

module timer
  import trammel_pkg::*;
#(
    parameter int unsigned Width = 12
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic             load_i,
    input logic [Width-1:0] value_i,

    output logic [Width-1:0] count_o,
    output gap_t             next_o
);

  // Wide enough for both the count and 1 + leap.
  localparam int unsigned Wide = Width > 13 ? Width : 13;

  logic [Width-1:0] count_q;
  logic [Wide-1:0] count, step;

  assign count = Wide'(count_q);
  assign step  = Wide'(leap_i) + Wide'(1);

  always_ff @(posedge clk_i) begin
    if (rst_i) count_q <= '0;
    else if (load_i) count_q <= value_i;
    else if (count > step) count_q <= Width'(count - step);
    else count_q <= '0;
  end

  always_comb begin
    next_o = GapMax;
    if (load_i) next_o = '0;
    else if (count > Wide'(GapMax)) next_o = GapMax - gap_t'(1);
    else if (count_q != '0) next_o = gap_t'(count - Wide'(1));
  end

  assign count_o = count_q;

endmodule
