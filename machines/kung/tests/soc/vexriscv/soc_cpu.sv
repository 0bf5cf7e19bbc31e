// SPDX-License-Identifier: Apache-2.0
//
// Another core in the place of rtl/chips/soc_cpu.sv, for the same binary: VexRiscv Lite of the
// package pythondata-cpu-vexriscv, rv32im with a cache of instructions, which it fetches by the
// second port. It goes to an exception where PicoRV32 traps, and no output shows that.

module soc_cpu (
    input logic clk_i,
    input logic rst_i,

    output logic        i_valid_o,
    input  logic        i_ready_i,
    output logic [31:0] i_addr_o,
    input  logic [31:0] i_rdata_i,

    output logic        d_valid_o,
    input  logic        d_ready_i,
    output logic [31:0] d_addr_o,
    output logic [ 3:0] d_wstrb_o,
    output logic [31:0] d_wdata_o,
    input  logic [31:0] d_rdata_i,

    output logic trap_o
);

  logic i_cyc, i_stb, d_cyc, d_stb, d_we;
  logic [29:0] i_adr, d_adr;
  logic [3:0] d_sel;

  VexRiscv u_core (
      .externalResetVector   ('0),
      .timerInterrupt        (1'b0),
      .softwareInterrupt     (1'b0),
      .externalInterruptArray('0),
      .iBusWishbone_CYC      (i_cyc),
      .iBusWishbone_STB      (i_stb),
      .iBusWishbone_ACK      (i_ready_i),
      .iBusWishbone_WE       (),
      .iBusWishbone_ADR      (i_adr),
      .iBusWishbone_DAT_MISO (i_rdata_i),
      .iBusWishbone_DAT_MOSI (),
      .iBusWishbone_SEL      (),
      .iBusWishbone_ERR      (1'b0),
      .iBusWishbone_CTI      (),
      .iBusWishbone_BTE      (),
      .dBusWishbone_CYC      (d_cyc),
      .dBusWishbone_STB      (d_stb),
      .dBusWishbone_ACK      (d_ready_i),
      .dBusWishbone_WE       (d_we),
      .dBusWishbone_ADR      (d_adr),
      .dBusWishbone_DAT_MISO (d_rdata_i),
      .dBusWishbone_DAT_MOSI (d_wdata_o),
      .dBusWishbone_SEL      (d_sel),
      .dBusWishbone_ERR      (1'b0),
      .dBusWishbone_CTI      (),
      .dBusWishbone_BTE      (),
      .clk                   (clk_i),
      .reset                 (rst_i)
  );

  assign i_valid_o = i_cyc && i_stb;
  assign i_addr_o  = {i_adr, 2'b0};
  assign d_valid_o = d_cyc && d_stb;
  assign d_addr_o  = {d_adr, 2'b0};
  assign d_wstrb_o = d_we ? d_sel : '0;
  assign trap_o    = 1'b0;

endmodule
