// SPDX-License-Identifier: Apache-2.0
//
// Frames that wait, in their order; the oldest one shows. A push without room is refused and
// counted, 65535 at most; a pop of none does nothing. Depth is a power of two.

module frame_fifo
  import serial2002_pkg::*;
#(
    parameter int unsigned Depth = 8
) (
    input logic clk_i,
    input logic rst_i,

    input logic   push_i,
    input frame_t frame_i,
    input logic   pop_i,

    output frame_t                 frame_o,     // 0 where none waits
    output logic                   waits_o,
    output logic [$clog2(Depth):0] room_o,
    output logic [15:0]            lost_o,
    output logic                   quiescent_o
);

  localparam int unsigned Bits = $clog2(Depth);

  frame_t frames[Depth];
  logic [Bits:0] head_q, tail_q;
  logic [15:0] lost_q;
  logic full, pushes;

  assign waits_o = head_q != tail_q;
  assign full    = room_o == '0;
  assign room_o  = (Bits + 1)'(Depth) - (tail_q - head_q);
  assign pushes  = push_i && !full;
  assign frame_o = waits_o ? frames[head_q[Bits-1:0]] : '0;

  always_ff @(posedge clk_i) begin
    if (pushes) frames[tail_q[Bits-1:0]] <= frame_i;
    if (rst_i) begin
      head_q <= '0;
      tail_q <= '0;
      lost_q <= '0;
    end else begin
      if (pushes) tail_q <= tail_q + (Bits + 1)'(1);
      if (pop_i && waits_o) head_q <= head_q + (Bits + 1)'(1);
      if (push_i && full && lost_q != '1) lost_q <= lost_q + 16'd1;
    end
  end

  assign lost_o      = lost_q;
  assign quiescent_o = !push_i && !pop_i;

endmodule
