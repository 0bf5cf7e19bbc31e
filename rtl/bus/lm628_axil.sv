// SPDX-License-Identifier: Apache-2.0
//
// An LM628 on an AXI4-Lite bus of 32 bits: register 0 is command and status, register 4 data, each
// in byte 0. A transfer is one access of the part's port, see lm628_host; its response comes when
// that has ended. A write without byte 0 does nothing. All responses are OKAY.
//
// Address and data of a write are taken in any order, one transfer of each direction beside the one
// that runs. A write goes before a read; but none begins before the response to the last of its
// direction is taken, so that the other direction is next.

module lm628_axil #(
    parameter int unsigned ClockNs = 20
) (
    input logic clk_i,
    input logic rst_i,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 2:0] s_axil_awaddr_i,
    input  logic [ 2:0] s_axil_awprot_i,
    input  logic        s_axil_wvalid_i,
    output logic        s_axil_wready_o,
    input  logic [31:0] s_axil_wdata_i,
    input  logic [ 3:0] s_axil_wstrb_i,
    output logic        s_axil_bvalid_o,
    input  logic        s_axil_bready_i,
    output logic [ 1:0] s_axil_bresp_o,
    input  logic        s_axil_arvalid_i,
    output logic        s_axil_arready_o,
    input  logic [ 2:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,
    output logic        irq_o,             // pin HI

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

  logic aw_q, w_q, ar_q;  // taken, and not yet begun
  logic b_q, r_q;  // responses that wait
  logic aw_ps_q, ar_ps_q, w_lane_q;
  logic [7:0] w_byte_q;
  logic writing_q;  // the access that runs
  logic can_write, can_read, begins_write, begins_read, start, busy, done, host_quiescent;
  logic hi_meta_q, hi_q;
  logic [7:0] from_part;

  assign can_write    = aw_q && w_q && !b_q;
  assign can_read     = ar_q && !r_q;
  assign begins_write = !busy && can_write;
  assign begins_read  = !busy && can_read && !can_write;
  assign start        = (begins_write && w_lane_q) || begins_read;

  lm628_host #(
      .ClockNs(ClockNs)
  ) u_host (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .start_i    (start),
      .busy_o     (busy),
      .done_o     (done),
      .write_i    (begins_write),
      .ps_i       (begins_write ? aw_ps_q : ar_ps_q),
      .byte_i     (w_byte_q),
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
      aw_q      <= 1'b0;
      w_q       <= 1'b0;
      ar_q      <= 1'b0;
      b_q       <= 1'b0;
      r_q       <= 1'b0;
      writing_q <= 1'b0;
      aw_ps_q   <= 1'b0;
      ar_ps_q   <= 1'b0;
      w_lane_q  <= 1'b0;
      w_byte_q  <= '0;
    end else begin
      if (s_axil_awvalid_i && !aw_q) begin
        aw_q    <= 1'b1;
        aw_ps_q <= s_axil_awaddr_i[2];
      end
      if (s_axil_wvalid_i && !w_q) begin
        w_q      <= 1'b1;
        w_lane_q <= s_axil_wstrb_i[0];
        w_byte_q <= s_axil_wdata_i[7:0];
      end
      if (s_axil_arvalid_i && !ar_q) begin
        ar_q    <= 1'b1;
        ar_ps_q <= s_axil_araddr_i[2];
      end
      if (begins_write) begin
        aw_q      <= 1'b0;
        w_q       <= 1'b0;
        writing_q <= 1'b1;
      end
      if (begins_read) begin
        ar_q      <= 1'b0;
        writing_q <= 1'b0;
      end
      b_q    <= (done && writing_q) || (begins_write && !w_lane_q) ||
          (b_q && !s_axil_bready_i);
      r_q    <= (done && !writing_q) || (r_q && !s_axil_rready_i);
    end
  end

  always_ff @(posedge clk_i) begin
    hi_meta_q <= hi_i;
    hi_q      <= hi_meta_q;
  end

  assign s_axil_awready_o = !aw_q;
  assign s_axil_wready_o  = !w_q;
  assign s_axil_arready_o = !ar_q;
  assign s_axil_bvalid_o  = b_q;
  assign s_axil_rvalid_o  = r_q;
  assign s_axil_bresp_o   = '0;
  assign s_axil_rresp_o   = '0;
  assign s_axil_rdata_o   = {24'd0, from_part};
  assign irq_o            = hi_q;
  assign quiescent_o      = !s_axil_awvalid_i && !s_axil_wvalid_i && !s_axil_arvalid_i && !aw_q &&
      !w_q && !ar_q && !b_q && !r_q && host_quiescent && hi_i == hi_meta_q && hi_meta_q == hi_q;

  logic unused_bits;
  assign unused_bits = ^{s_axil_awaddr_i[1:0], s_axil_awprot_i, s_axil_wdata_i[31:8],
                         s_axil_wstrb_i[3:1], s_axil_araddr_i[1:0], s_axil_arprot_i};

endmodule
