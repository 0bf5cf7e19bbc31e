// SPDX-License-Identifier: Apache-2.0
//
// kung_xy on an ECP5-25F: what surrounds the IC on a board. The clock comes from its pin, 50 MHz,
// and never leaps; the reset pin is active low and synchronised. The bus is on pins, for a
// processor beside the FPGA; one inside would take their place. Pin numbers: the board's LPF file.

module kung_xy_ecp5_25f (
    input logic clk_i,
    input logic rst_ni,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 9:0] s_axil_awaddr_i,
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
    input  logic [ 9:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,

    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_z_i,
    input  logic       trip_i,
    output logic [1:0] adc_cs_n_o,
    output logic [1:0] adc_sclk_o,
    input  logic [1:0] adc_sdata_a_i,
    input  logic [1:0] adc_sdata_b_i,
    output logic [5:0] gate_hi_o,
    output logic [5:0] gate_lo_o,

    output logic irq_o
);

  logic [1:0] reset_q;
  logic unused_tick, unused_sample, unused_quiescent, unused_tripped;
  logic [1:0] unused_driver_en;
  trammel_pkg::gap_t unused_next;
  kung_pkg::domains_t unused_awake;
  logic unused_timed;

  always_ff @(posedge clk_i) reset_q <= {reset_q[0], !rst_ni};

  kung_xy u_chip (
      .clk_i(clk_i),
      .clock_en_i('1),
      .rst_i(reset_q[1]),
      .leap_i('0),
      .s_axil_awvalid_i(s_axil_awvalid_i),
      .s_axil_awready_o(s_axil_awready_o),
      .s_axil_awaddr_i(s_axil_awaddr_i),
      .s_axil_awprot_i(s_axil_awprot_i),
      .s_axil_wvalid_i(s_axil_wvalid_i),
      .s_axil_wready_o(s_axil_wready_o),
      .s_axil_wdata_i(s_axil_wdata_i),
      .s_axil_wstrb_i(s_axil_wstrb_i),
      .s_axil_bvalid_o(s_axil_bvalid_o),
      .s_axil_bready_i(s_axil_bready_i),
      .s_axil_bresp_o(s_axil_bresp_o),
      .s_axil_arvalid_i(s_axil_arvalid_i),
      .s_axil_arready_o(s_axil_arready_o),
      .s_axil_araddr_i(s_axil_araddr_i),
      .s_axil_arprot_i(s_axil_arprot_i),
      .s_axil_rvalid_o(s_axil_rvalid_o),
      .s_axil_rready_i(s_axil_rready_i),
      .s_axil_rdata_o(s_axil_rdata_o),
      .s_axil_rresp_o(s_axil_rresp_o),
      .enc_a_i(enc_a_i),
      .enc_b_i(enc_b_i),
      .enc_z_i(enc_z_i),
      .trip_i(trip_i),
      .adc_cs_n_o(adc_cs_n_o),
      .adc_sclk_o(adc_sclk_o),
      .adc_sdata_a_i(adc_sdata_a_i),
      .adc_sdata_b_i(adc_sdata_b_i),
      .gate_hi_o(gate_hi_o),
      .gate_lo_o(gate_lo_o),
      .irq_o(irq_o),
      .tick_o(unused_tick),
      .sample_o(unused_sample),
      .driver_en_o(unused_driver_en),
      .tripped_o(unused_tripped),
      .next_o(unused_next),
      .quiescent_o(unused_quiescent),
      .awake_o(unused_awake),
      .timed_o(unused_timed)
  );

endmodule
