// SPDX-License-Identifier: Apache-2.0
//
// Position command of one axis. commit_i makes pos_cmd_i the pending command; the next tick_pos_i
// takes it (a tick in the clock of the commit does not), so that both axes move together.
// r_o changes at the edge of the tick. With interpolate_i a taken command is reached in four equal
// parts, at this tick and the three after it (ticks of one 2 ms interrupt), exactly at the last:
//   quarters = 4 from + k (to - from), k = 1..4;  r = rs(quarters, 2)
// preset_i sets the command at once and drops what is pending.

module command
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_pos_i,

    input logic   commit_i,
    input logic   interpolate_i,
    input logic   preset_i,
    input count_t preset_value_i,

    input  count_t pos_cmd_i,
    output count_t r_o,

    output logic quiescent_o
);

  typedef logic signed [25:0] quarter_t;  // quarters of a count

  logic pending_q, pending_d;
  count_t next_q, next_d;
  quarter_t quarters_q, quarters_d;
  quarter_t stride_q, stride_d;
  logic [1:0] left_q, left_d;  // ticks still to move

  quarter_t distance, moved;
  logic take, up;
  assign take = tick_pos_i && pending_q;
  assign distance = quarter_t'(next_q) - quarter_t'(r_o);

  // A new command starts from r_o: quarters without their fraction, one count up where r_o rounds
  // up. Their low bits are then 11, so that the carry-in of the one adder adds this count.
  assign up = take && quarters_q[1];
  assign moved = {quarters_q[25:2], take ? {2{up}} : quarters_q[1:0]} +
      (take ? distance : stride_q) + quarter_t'({1'b0, up});

  // rs(quarters, 2): the highest dropped bit rounds. A concatenation, because Yosys' slang
  // sign-extends a select of a signed type.
  assign r_o = quarters_q[25:2] + {23'd0, quarters_q[1]};

  always_comb begin
    pending_d  = pending_q;
    next_d     = next_q;
    quarters_d = quarters_q;
    stride_d   = stride_q;
    left_d     = left_q;
    if (take) begin
      pending_d  = 1'b0;
      stride_d   = interpolate_i ? distance : '0;
      quarters_d = interpolate_i ? moved : {next_q, 2'd0};
      left_d     = interpolate_i ? 2'd3 : 2'd0;
    end else if (tick_pos_i && left_q != 2'd0) begin
      quarters_d = moved;
      left_d     = left_q - 2'd1;
    end
    if (commit_i) begin
      pending_d = 1'b1;
      next_d    = pos_cmd_i;
    end
    if (preset_i) begin
      pending_d  = 1'b0;
      quarters_d = {preset_value_i, 2'd0};
      left_d     = 2'd0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      pending_q  <= 1'b0;
      next_q     <= '0;
      quarters_q <= '0;
      stride_q   <= '0;
      left_q     <= '0;
    end else begin
      pending_q  <= pending_d;
      next_q     <= next_d;
      quarters_q <= quarters_d;
      stride_q   <= stride_d;
      left_q     <= left_d;
    end
  end

  assign quiescent_o = !commit_i && !preset_i && !(tick_pos_i && (pending_q || left_q != 2'd0));

endmodule
