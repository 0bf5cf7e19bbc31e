// SPDX-License-Identifier: Apache-2.0
//
// step_table on an iCE40 UP5K: what surrounds it on a board. The clock comes from its pin, 12 MHz;
// it never leaps. A processor's bus of 16 bits, in step with the clock, has the four words of
// Larson 1974: 0 X count, 1 X status, 2 Y count, 3 Y status. grant_i takes the vector. What is
// read stands on the bus in the clock after read_i or grant_i. Pin numbers: the board's PCF file.

module larson_ice40_up5k (
    input logic clk_i,
    input logic reset_n_i,

    input logic [ 1:0] a_i,
    input logic        read_i,
    input logic        write_i,
    input logic        byte_i,   // a write of half a word
    input logic        grant_i,
    inout wire  [15:0] d_io,
    output logic       irq_o,

    input  logic [1:0] limit_low_i,
    input  logic [1:0] limit_high_i,
    input  logic [1:0] buf_busy_i,
    output logic [1:0] step_o,
    output logic [1:0] forward_o,
    output logic [1:0] flush_o
);

  logic [31:0] x, y, axis;
  logic [15:0] shown_q, unused_err_byte;
  logic shows_q;
  logic [7:0] vector;
  logic [3:0] bytes;
  trammel_pkg::gap_t unused_next;
  logic unused_quiescent;

  assign axis  = a_i[1] ? y : x;
  assign d_io  = shows_q ? shown_q : 'z;
  assign bytes = byte_i ? 4'b0001 : 4'b0011;

  always_ff @(posedge clk_i) begin
    shows_q <= reset_n_i && (read_i || grant_i);
    shown_q <= grant_i ? 16'(vector) : a_i[0] ? axis[31:16] : axis[15:0];
  end

  step_table #(
      .Inc(1),
      .Mod(50)
  ) u_table (
      .clk_i       (clk_i),
      .rst_i       (!reset_n_i),
      .leap_i      ('0),
      .write_i     (write_i),
      .y_i         (a_i[1]),
      .bytes_i     (a_i[0] ? {bytes[1:0], 2'b00} : bytes),
      .data_i      ({d_io, d_io}),
      .grant_i     (grant_i),
      .limit_low_i (limit_low_i),
      .limit_high_i(limit_high_i),
      .buf_busy_i  (buf_busy_i),
      .step_o      (step_o),
      .forward_o   (forward_o),
      .flush_o     (flush_o),
      .x_o         (x),
      .y_o         (y),
      .err_byte_o  (unused_err_byte),
      .irq_o       (irq_o),
      .vector_o    (vector),
      .next_o      (unused_next),
      .quiescent_o (unused_quiescent)
  );

endmodule
