// SPDX-License-Identifier: Apache-2.0
//
// Two-axis stepper interface (Larson 1974, section II): the clock of 240 kHz, a channel an axis,
// and what they share, which is the byte-write rule and the interrupt.
//
// A write is of one axis: its count in bytes 0 and 1, its status word in bytes 2 and 3, either or
// both. Half of a word is not written; such a transfer counts as an error (err_byte_o). Of two
// interrupts that wait X goes first; grant_i takes the one that vector_o names. With Buffered = 0
// buf_busy_i is not used; Inc and Mod are those of step_clock.

module step_table
  import trammel_pkg::*;
#(
    parameter int unsigned Inc = 3,
    parameter int unsigned Mod = 625,
    parameter bit Buffered = 1'b1
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        write_i,
    input logic        y_i,
    input logic [ 3:0] bytes_i,
    input logic [31:0] data_i,
    input logic        grant_i,

    input logic [1:0] limit_low_i,   // X, Y, as all pairs
    input logic [1:0] limit_high_i,
    input logic [1:0] buf_busy_i,

    output logic [ 1:0] step_o,
    output logic [ 1:0] forward_o,
    output logic [ 1:0] flush_o,
    output logic [31:0] x_o,          // status word and count
    output logic [31:0] y_o,
    output logic [15:0] err_byte_o,
    output logic        irq_o,
    output logic [ 7:0] vector_o,     // 0: none waits
    output gap_t        next_o,
    output logic        quiescent_o
);

  localparam logic [7:0] VectorX = 8'o340;
  localparam logic [7:0] VectorY = 8'o344;

  logic tick, half;
  gap_t ticks, next_tick, next_half;
  logic unused_clock_quiescent;
  logic count_whole, status_whole, broken;
  logic [1:0] irq, grant, channel_quiescent;
  gap_t [1:0] next;
  logic [1:0][15:0] count, status;
  logic [15:0] err_byte_q;

  step_clock #(
      .Inc(Inc),
      .Mod(Mod)
  ) u_clock (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .tick_o     (tick),
      .half_o     (half),
      .ticks_o    (ticks),
      .next_tick_o(next_tick),
      .next_half_o(next_half),
      .quiescent_o(unused_clock_quiescent)
  );

  assign count_whole  = bytes_i[1:0] == '1;
  assign status_whole = bytes_i[3:2] == '1;
  assign broken       = bytes_i[0] != bytes_i[1] || bytes_i[2] != bytes_i[3];
  assign grant        = {grant_i && irq == 2'b10, grant_i && irq[0]};

  for (genvar i = 0; i < 2; i++) begin : gen_axis
    logic write;
    assign write = write_i && y_i == (i == 1);

    step_channel #(
        .TickClk (Mod / Inc),
        .Buffered(Buffered)
    ) u_channel (
        .clk_i         (clk_i),
        .rst_i         (rst_i),
        .tick_i        (tick),
        .half_i        (half),
        .ticks_i       (ticks),
        .next_tick_i   (next_tick),
        .next_half_i   (next_half),
        .count_write_i (write && count_whole),
        .count_i       (data_i[15:0]),
        .status_write_i(write && status_whole),
        .status_i      (data_i[31:16]),
        .grant_i       (grant[i]),
        .limit_low_i   (limit_low_i[i]),
        .limit_high_i  (limit_high_i[i]),
        .buf_busy_i    (buf_busy_i[i]),
        .step_o        (step_o[i]),
        .forward_o     (forward_o[i]),
        .flush_o       (flush_o[i]),
        .count_o       (count[i]),
        .status_o      (status[i]),
        .irq_o         (irq[i]),
        .next_o        (next[i]),
        .quiescent_o   (channel_quiescent[i])
    );
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) err_byte_q <= '0;
    else if (write_i && broken && err_byte_q != '1) err_byte_q <= err_byte_q + 16'd1;
  end

  assign x_o         = {status[0], count[0]};
  assign y_o         = {status[1], count[1]};
  assign err_byte_o  = err_byte_q;
  assign irq_o       = irq != '0;
  assign vector_o    = irq[0] ? VectorX : irq[1] ? VectorY : '0;
  assign next_o      = next[0] < next[1] ? next[0] : next[1];
  assign quiescent_o = channel_quiescent == '1 && !write_i;

endmodule
