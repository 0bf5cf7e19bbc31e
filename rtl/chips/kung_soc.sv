// SPDX-License-Identifier: Apache-2.0
//
// The whole motion-control chip of Kung et al. 2012 (Fig. 3): the two-axis IC kung_xy and the
// processor that runs its firmware, for an FPGA. Axis 0 is X, axis 1 is Y; 50 MHz.
//
//   driver fault, trap of the core -> gates off    4 clocks
//
// An axis' driver is enabled while the axis is enabled and nothing has tripped.

module kung_soc #(
    parameter int unsigned Words = 16384,
    parameter string Image = "",
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input  logic uart_rx_i,
    output logic uart_tx_o,

    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_z_i,
    input  logic [1:0] driver_fault_i,
    output logic [1:0] adc_cs_n_o,
    output logic [1:0] adc_sclk_o,
    input  logic [1:0] adc_sdata_a_i,
    input  logic [1:0] adc_sdata_b_i,
    output logic [5:0] gate_hi_o,
    output logic [5:0] gate_lo_o,
    output logic [1:0] driver_en_o,

    // For lamps: 0, 1 axis drives; 2 tripped; 3 the core has trapped; 4 the core waits; 5 an
    // interrupt is served; 6, 7 the serial port receives, sends a low bit
    output logic [7:0] status_o
);

  logic irq, core_trap, waiting, tripped;
  logic bus_valid, bus_ready;
  logic [9:0] bus_addr;
  logic [3:0] bus_wstrb;
  logic [31:0] bus_wdata, bus_rdata;
  logic unused_asks, unused_host_quiescent;

  soc_host #(
      .Words       (Words),
      .Image       (Image),
      .ClocksPerBit(ClocksPerBit)
  ) u_host (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .irq_i      (irq),
      .trap_o     (core_trap),
      .asks_o     (unused_asks),
      .waiting_o  (waiting),
      .bus_valid_o(bus_valid),
      .bus_ready_i(bus_ready),
      .bus_addr_o (bus_addr),
      .bus_wstrb_o(bus_wstrb),
      .bus_wdata_o(bus_wdata),
      .bus_rdata_i(bus_rdata),
      .uart_rx_i  (uart_rx_i),
      .uart_tx_o  (uart_tx_o),
      .quiescent_o(unused_host_quiescent)
  );

  logic awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  logic [9:0] awaddr, araddr;
  logic [2:0] awprot, arprot;
  logic [31:0] axil_wdata, axil_rdata;
  logic [3:0] axil_wstrb;
  logic [1:0] unused_bresp, unused_rresp;  // always OKAY

  axil_master #(
      .AddrBits(10)
  ) u_master (
      .clk_i           (clk_i),
      .rst_i           (rst_i),
      .valid_i         (bus_valid),
      .ready_o         (bus_ready),
      .addr_i          (bus_addr),
      .wstrb_i         (bus_wstrb),
      .wdata_i         (bus_wdata),
      .rdata_o         (bus_rdata),
      .m_axil_awvalid_o(awvalid),
      .m_axil_awready_i(awready),
      .m_axil_awaddr_o (awaddr),
      .m_axil_awprot_o (awprot),
      .m_axil_wvalid_o (wvalid),
      .m_axil_wready_i (wready),
      .m_axil_wdata_o  (axil_wdata),
      .m_axil_wstrb_o  (axil_wstrb),
      .m_axil_bvalid_i (bvalid),
      .m_axil_bready_o (bready),
      .m_axil_arvalid_o(arvalid),
      .m_axil_arready_i(arready),
      .m_axil_araddr_o (araddr),
      .m_axil_arprot_o (arprot),
      .m_axil_rvalid_i (rvalid),
      .m_axil_rready_o (rready),
      .m_axil_rdata_i  (axil_rdata)
  );

  logic unused_tick, unused_sample, unused_quiescent, unused_timed;
  trammel_pkg::gap_t unused_next;
  kung_pkg::domains_t unused_awake;

  kung_xy u_ic (
      .clk_i           (clk_i),
      .clock_en_i      ('1),
      .rst_i           (rst_i),
      .leap_i          ('0),
      .s_axil_awvalid_i(awvalid),
      .s_axil_awready_o(awready),
      .s_axil_awaddr_i (awaddr),
      .s_axil_awprot_i (awprot),
      .s_axil_wvalid_i (wvalid),
      .s_axil_wready_o (wready),
      .s_axil_wdata_i  (axil_wdata),
      .s_axil_wstrb_i  (axil_wstrb),
      .s_axil_bvalid_o (bvalid),
      .s_axil_bready_i (bready),
      .s_axil_bresp_o  (unused_bresp),
      .s_axil_arvalid_i(arvalid),
      .s_axil_arready_o(arready),
      .s_axil_araddr_i (araddr),
      .s_axil_arprot_i (arprot),
      .s_axil_rvalid_o (rvalid),
      .s_axil_rready_i (rready),
      .s_axil_rdata_o  (axil_rdata),
      .s_axil_rresp_o  (unused_rresp),
      .enc_a_i         (enc_a_i),
      .enc_b_i         (enc_b_i),
      .enc_z_i         (enc_z_i),
      .trip_i          (driver_fault_i != '0 || core_trap),
      .adc_cs_n_o      (adc_cs_n_o),
      .adc_sclk_o      (adc_sclk_o),
      .adc_sdata_a_i   (adc_sdata_a_i),
      .adc_sdata_b_i   (adc_sdata_b_i),
      .gate_hi_o       (gate_hi_o),
      .gate_lo_o       (gate_lo_o),
      .irq_o           (irq),
      .tick_o          (unused_tick),
      .sample_o        (unused_sample),
      .driver_en_o     (driver_en_o),
      .tripped_o       (tripped),
      .next_o          (unused_next),
      .quiescent_o     (unused_quiescent),
      .awake_o         (unused_awake),
      .timed_o         (unused_timed)
  );

  assign status_o = {!uart_tx_o, !uart_rx_i, irq, waiting, core_trap, tripped, driver_en_o};

endmodule
