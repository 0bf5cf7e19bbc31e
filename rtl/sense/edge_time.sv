// SPDX-License-Identifier: Apache-2.0
//
// When the last edge of an encoder was, without a free-running count: the phase of the carrier is
// kept at an edge, and what has passed since is summed at ticks. What a tick sees, from the next
// clock on until the next tick:
//   age_o    from the edge at the pin to the tick [clk]: Period - phase + 2 + filter at the tick
//            after the edge, + Period at each other one
//   ticks_o  ticks since, 0 at the one after the edge; from 15 on both stay
// An edge in the clock of a tick belongs to the next one, as its count does.

module edge_time
  import trammel_pkg::*;
#(
    parameter int unsigned Period = 3125  // [clk] of a tick: 16 kHz
) (
    input logic clk_i,
    input logic rst_i,

    input logic   tick_i,
    input phase_t phase_i,

    input logic [3:0] filter_i,  // of the decoder [clk]; 0 acts as 1

    input logic edge_i,  // the count changes at this clock edge
    input logic up_i,

    output logic [ 3:0] ticks_o,
    output logic [15:0] age_o,
    output logic        up_o,
    output logic        quiescent_o
);

  logic seen_q, way_q, up_q, moves;
  phase_t phase_q;
  logic [3:0] ticks_q;
  logic [3:0] filter;
  logic [15:0] age_q, from, passed, age_d;

  assign filter = {filter_i[3:1], filter_i[0] || filter_i == '0};

  // Period - phase = Period + ~phase + 1
  assign from   = seen_q ? ~16'(phase_q) : age_q;
  assign passed = 16'(Period) + (seen_q ? 16'd3 + 16'(filter) : 16'd0);
  assign age_d  = from + passed;
  assign moves  = tick_i && (seen_q || ticks_q != '1);

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      seen_q  <= 1'b0;
      ticks_q <= '1;
      age_q   <= '0;
      up_q    <= 1'b0;
    end else begin
      if (tick_i || edge_i) seen_q <= edge_i;
      if (moves) begin
        ticks_q <= seen_q ? '0 : ticks_q + 4'd1;
        age_q   <= age_d;
        if (seen_q) up_q <= way_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (edge_i) begin
      phase_q <= phase_i;
      way_q   <= up_i;
    end
  end

  assign ticks_o     = ticks_q;
  assign age_o       = age_q;
  assign up_o        = up_q;
  assign quiescent_o = !edge_i && !moves;

endmodule
