// SPDX-License-Identifier: Apache-2.0
//
// AXI4-Lite of 32 bits to words that are written and read in one clock: write_o with the bytes that
// are meant, or read_o, at whose edge data_i is taken. All responses are OKAY.
//
// Address and data of a write are taken in any order, one transfer of each direction beside the
// response that waits. A write goes before a read; none begins before the last response of its
// direction is taken. Bits: of the index of a word.

module word_axil #(
    parameter int unsigned Bits = 2
) (
    input logic clk_i,
    input logic rst_i,

    input  logic            s_axil_awvalid_i,
    output logic            s_axil_awready_o,
    input  logic [Bits+1:0] s_axil_awaddr_i,
    input  logic [     2:0] s_axil_awprot_i,
    input  logic            s_axil_wvalid_i,
    output logic            s_axil_wready_o,
    input  logic [    31:0] s_axil_wdata_i,
    input  logic [     3:0] s_axil_wstrb_i,
    output logic            s_axil_bvalid_o,
    input  logic            s_axil_bready_i,
    output logic [     1:0] s_axil_bresp_o,
    input  logic            s_axil_arvalid_i,
    output logic            s_axil_arready_o,
    input  logic [Bits+1:0] s_axil_araddr_i,
    input  logic [     2:0] s_axil_arprot_i,
    output logic            s_axil_rvalid_o,
    input  logic            s_axil_rready_i,
    output logic [    31:0] s_axil_rdata_o,
    output logic [     1:0] s_axil_rresp_o,

    output logic            write_o,
    output logic            read_o,
    output logic [Bits-1:0] word_o,
    output logic [     3:0] bytes_o,
    output logic [    31:0] data_o,
    input  logic [    31:0] data_i,

    output logic quiescent_o
);

  typedef logic [Bits-1:0] word_index_t;

  logic aw_q, w_q, ar_q;  // taken, and not yet done
  logic b_q, r_q;  // responses that wait
  word_index_t aw_word_q, ar_word_q;
  logic [ 3:0] bytes_q;
  logic [31:0] data_q, rdata_q;

  assign write_o = aw_q && w_q && !b_q;
  assign read_o  = ar_q && !r_q && !write_o;
  assign word_o  = write_o ? aw_word_q : ar_word_q;
  assign bytes_o = bytes_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      aw_q      <= 1'b0;
      w_q       <= 1'b0;
      ar_q      <= 1'b0;
      b_q       <= 1'b0;
      r_q       <= 1'b0;
      aw_word_q <= '0;
      ar_word_q <= '0;
      bytes_q   <= '0;
      data_q    <= '0;
      rdata_q   <= '0;
    end else begin
      if (s_axil_awvalid_i && !aw_q) begin
        aw_q      <= 1'b1;
        aw_word_q <= s_axil_awaddr_i[Bits+1:2];
      end
      if (s_axil_wvalid_i && !w_q) begin
        w_q     <= 1'b1;
        bytes_q <= s_axil_wstrb_i;
        data_q  <= s_axil_wdata_i;
      end
      if (s_axil_arvalid_i && !ar_q) begin
        ar_q      <= 1'b1;
        ar_word_q <= s_axil_araddr_i[Bits+1:2];
      end
      if (write_o) begin
        aw_q <= 1'b0;
        w_q  <= 1'b0;
      end
      if (read_o) begin
        ar_q    <= 1'b0;
        rdata_q <= data_i;
      end
      b_q <= write_o || (b_q && !s_axil_bready_i);
      r_q <= read_o || (r_q && !s_axil_rready_i);
    end
  end

  assign s_axil_awready_o = !aw_q;
  assign s_axil_wready_o  = !w_q;
  assign s_axil_arready_o = !ar_q;
  assign s_axil_bvalid_o  = b_q;
  assign s_axil_rvalid_o  = r_q;
  assign s_axil_bresp_o   = '0;
  assign s_axil_rresp_o   = '0;
  assign s_axil_rdata_o   = rdata_q;
  assign quiescent_o      = !s_axil_awvalid_i && !s_axil_wvalid_i && !s_axil_arvalid_i && !b_q &&
      !r_q && !ar_q && !(aw_q && w_q);

  logic unused_bits;
  assign unused_bits = ^{s_axil_awaddr_i[1:0], s_axil_awprot_i, s_axil_araddr_i[1:0],
                         s_axil_arprot_i};

endmodule
