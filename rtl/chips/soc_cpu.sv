// SPDX-License-Identifier: Apache-2.0
//
// The processor core of kung_soc: PicoRV32 as rv32im, without counters and interrupts, with barrel
// shifter, fast multiplier and divider. Another rv32im core is another file with this module: it
// begins at address 0, holds a request until it is answered, and may fetch by either port.
// trap_o stays high after an illegal instruction or a misaligned access.

module soc_cpu (
    input logic clk_i,
    input logic rst_i,

    output logic        i_valid_o,  // instructions, for a core with two ports
    input  logic        i_ready_i,
    output logic [31:0] i_addr_o,
    input  logic [31:0] i_rdata_i,

    output logic        d_valid_o,
    input  logic        d_ready_i,
    output logic [31:0] d_addr_o,
    output logic [ 3:0] d_wstrb_o,  // 0: a read
    output logic [31:0] d_wdata_o,
    input  logic [31:0] d_rdata_i,

    output logic trap_o
);

  logic unused_instr, unused_la_read, unused_la_write, unused_pcpi_valid, unused_trace_valid;
  logic [31:0] unused_la_addr, unused_la_wdata, unused_pcpi_insn, unused_rs1, unused_rs2;
  logic [31:0] unused_eoi;
  logic [3:0] unused_la_wstrb;
  logic [35:0] unused_trace_data;

  picorv32 #(
      .ENABLE_COUNTERS  (0),
      .ENABLE_COUNTERS64(0),
      .BARREL_SHIFTER   (1),
      .CATCH_MISALIGN   (1),
      .CATCH_ILLINSN    (1),
      .ENABLE_MUL       (0),
      .ENABLE_FAST_MUL  (1),
      .ENABLE_DIV       (1),
      .ENABLE_IRQ       (0),
      .PROGADDR_RESET   (0)
  ) u_core (
      .clk         (clk_i),
      .resetn      (!rst_i),
      .trap        (trap_o),
      .mem_valid   (d_valid_o),
      .mem_instr   (unused_instr),
      .mem_ready   (d_ready_i),
      .mem_addr    (d_addr_o),
      .mem_wdata   (d_wdata_o),
      .mem_wstrb   (d_wstrb_o),
      .mem_rdata   (d_rdata_i),
      .mem_la_read (unused_la_read),
      .mem_la_write(unused_la_write),
      .mem_la_addr (unused_la_addr),
      .mem_la_wdata(unused_la_wdata),
      .mem_la_wstrb(unused_la_wstrb),
      .pcpi_valid  (unused_pcpi_valid),
      .pcpi_insn   (unused_pcpi_insn),
      .pcpi_rs1    (unused_rs1),
      .pcpi_rs2    (unused_rs2),
      .pcpi_wr     (1'b0),
      .pcpi_rd     ('0),
      .pcpi_wait   (1'b0),
      .pcpi_ready  (1'b0),
      .irq         ('0),
      .eoi         (unused_eoi),
      .trace_valid (unused_trace_valid),
      .trace_data  (unused_trace_data)
  );

  assign i_valid_o = 1'b0;
  assign i_addr_o  = '0;

  logic unused_bits;
  assign unused_bits = ^{i_ready_i, i_rdata_i};

endmodule
