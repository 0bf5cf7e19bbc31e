// SPDX-License-Identifier: Apache-2.0
//
// An LM628 on a Wishbone B4 bus, classic standard cycles, port of 32 bits, granularity 8: register
// 0 is command and status, register 1 data, each in byte 0. A cycle is one access of the part's
// port, see lm628_host, and ends with it; without byte 0 it ends at once and does nothing.
//
// A cycle that its master gives up gets no acknowledge. The access of the part goes on to its end,
// and the next cycle waits for that.

module lm628_wishbone #(
    parameter int unsigned ClockNs = 20
) (
    input logic clk_i,
    input logic rst_i,

    input  logic        cyc_i,
    input  logic        stb_i,
    input  logic        we_i,
    input  logic        adr_i,  // bit 2 of a byte address
    input  logic [ 3:0] sel_i,
    input  logic [31:0] dat_i,
    output logic [31:0] dat_o,
    output logic        ack_o,
    output logic        irq_o,  // pin HI

    output logic       cs_n_o,
    output logic       rd_n_o,
    output logic       wr_n_o,
    output logic       ps_o,
    output logic [7:0] d_o,
    output logic       drive_o,  // d_o is on the part's bus
    input  logic [7:0] d_i,
    input  logic       hi_i,

    output logic quiescent_o
);

  logic asks, starts, empty, busy, done, host_quiescent;
  logic open_q, ack_q;  // an access for the present cycle; it has ended
  logic hi_meta_q, hi_q;
  logic [7:0] from_part;

  assign asks   = cyc_i && stb_i;
  assign starts = asks && !open_q && !ack_q && !busy && sel_i[0];
  assign empty  = asks && !open_q && !ack_q && !sel_i[0];

  lm628_host #(
      .ClockNs(ClockNs)
  ) u_host (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .start_i    (starts),
      .busy_o     (busy),
      .done_o     (done),
      .write_i    (we_i),
      .ps_i       (adr_i),
      .byte_i     (dat_i[7:0]),
      .byte_o     (from_part),
      .cs_n_o     (cs_n_o),
      .rd_n_o     (rd_n_o),
      .wr_n_o     (wr_n_o),
      .ps_o       (ps_o),
      .d_o        (d_o),
      .drive_o    (drive_o),
      .d_i        (d_i),
      .quiescent_o(host_quiescent)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      open_q <= 1'b0;
      ack_q  <= 1'b0;
    end else begin
      open_q <= starts || (open_q && asks && !done);
      ack_q  <= empty || (open_q && asks && done);
    end
  end

  always_ff @(posedge clk_i) begin
    hi_meta_q <= hi_i;
    hi_q      <= hi_meta_q;
  end

  assign ack_o       = ack_q && asks;
  assign dat_o       = {24'd0, from_part};
  assign irq_o       = hi_q;
  assign quiescent_o = !asks && !ack_q && host_quiescent && hi_i == hi_meta_q && hi_meta_q == hi_q;

  logic unused_bits;
  assign unused_bits = ^{sel_i[3:1], dat_i[31:8]};

endmodule
