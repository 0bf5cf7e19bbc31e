// SPDX-License-Identifier: Apache-2.0
//
// A processor's accesses on an AXI4-Lite bus of 32 bits, one transfer at a time. A request is held
// until ready_o and reaches the bus in the same clock: address and data of a write are offered
// together, and each is withdrawn when it has been accepted; the response is taken at once and is
// the answer. So an access takes as long as the slave needs, and no clock more.

module axil_master #(
    parameter int unsigned AddrBits = 10
) (
    input logic clk_i,
    input logic rst_i,

    input  logic                valid_i,  // held until ready
    output logic                ready_o,
    input  logic [AddrBits-1:0] addr_i,
    input  logic [         3:0] wstrb_i,  // 0: a read
    input  logic [        31:0] wdata_i,
    output logic [        31:0] rdata_o,

    output logic                m_axil_awvalid_o,
    input  logic                m_axil_awready_i,
    output logic [AddrBits-1:0] m_axil_awaddr_o,
    output logic [         2:0] m_axil_awprot_o,
    output logic                m_axil_wvalid_o,
    input  logic                m_axil_wready_i,
    output logic [        31:0] m_axil_wdata_o,
    output logic [         3:0] m_axil_wstrb_o,
    input  logic                m_axil_bvalid_i,
    output logic                m_axil_bready_o,
    output logic                m_axil_arvalid_o,
    input  logic                m_axil_arready_i,
    output logic [AddrBits-1:0] m_axil_araddr_o,
    output logic [         2:0] m_axil_arprot_o,
    input  logic                m_axil_rvalid_i,
    output logic                m_axil_rready_o,
    input  logic [        31:0] m_axil_rdata_i
);

  logic write;
  logic aw_done_q, w_done_q, ar_done_q;  // accepted, and not yet answered

  assign write   = wstrb_i != '0;
  assign ready_o = valid_i && (write ? m_axil_bvalid_i : m_axil_rvalid_i);

  always_ff @(posedge clk_i) begin
    if (rst_i || ready_o) begin
      aw_done_q <= 1'b0;
      w_done_q  <= 1'b0;
      ar_done_q <= 1'b0;
    end else begin
      aw_done_q <= aw_done_q || (m_axil_awvalid_o && m_axil_awready_i);
      w_done_q  <= w_done_q || (m_axil_wvalid_o && m_axil_wready_i);
      ar_done_q <= ar_done_q || (m_axil_arvalid_o && m_axil_arready_i);
    end
  end

  assign m_axil_awvalid_o = valid_i && write && !aw_done_q;
  assign m_axil_wvalid_o  = valid_i && write && !w_done_q;
  assign m_axil_arvalid_o = valid_i && !write && !ar_done_q;
  assign m_axil_awaddr_o  = addr_i;
  assign m_axil_araddr_o  = addr_i;
  assign m_axil_awprot_o  = '0;
  assign m_axil_arprot_o  = '0;
  assign m_axil_wdata_o   = wdata_i;
  assign m_axil_wstrb_o   = wstrb_i;
  assign m_axil_bready_o  = 1'b1;
  assign m_axil_rready_o  = 1'b1;
  assign rdata_o          = m_axil_rdata_i;

endmodule
