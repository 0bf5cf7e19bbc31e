// SPDX-License-Identifier: Apache-2.0
//
// The processor of kung_soc: core, memory with the firmware, serial port. What it asks of the IC
// leaves by bus_*. Addresses:
//
//   0x0000_0000  memory, Words words
//   0x8000_0000  registers of the IC, 1 KiB
//   0xC000_0000  WAIT       read; answered when b0 interrupt or b1 received byte is there
//   0xC000_0004  UART       write: sends b7:0 once the byte before is sent; read: takes the
//                           oldest received byte, in b7:0; b31: there was none; b15:8 bytes
//                           lost since the reset, up to 255
//   0xC000_0008  WAIT_SEND  as WAIT, and answered when b2 the serial port can send
//
// A core that waits stands still. Any other address is not answered and trips the machine.

module soc_host #(
    parameter int unsigned Words = 16384,
    parameter string Image = "",
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input  logic irq_i,
    output logic trap_o,
    output logic asks_o,     // the core reads WAIT: irq_i counts
    output logic waiting_o,  // and is not answered

    output logic        bus_valid_o,  // held until ready
    input  logic        bus_ready_i,
    output logic [ 9:0] bus_addr_o,
    output logic [ 3:0] bus_wstrb_o,  // 0: a read
    output logic [31:0] bus_wdata_o,
    input  logic [31:0] bus_rdata_i,

    input  logic uart_rx_i,
    output logic uart_tx_o,

    output logic quiescent_o  // waiting, and nothing on the serial port
);

  localparam int unsigned Width = $clog2(Words);

  logic i_valid, i_ready, d_valid, d_ready, write, core_trap;
  logic [31:0] i_addr, i_rdata, addr, wdata, rdata, ram_rdata;
  logic [3:0] wstrb;
  logic ram_sel, bus_sel, sys_sel, uart_sel, wait_sel, stray;
  logic ram_ready, uart_ready, wait_ready;

  soc_cpu u_cpu (
      .clk_i    (clk_i),
      .rst_i    (rst_i),
      .i_valid_o(i_valid),
      .i_ready_i(i_ready),
      .i_addr_o (i_addr),
      .i_rdata_i(i_rdata),
      .d_valid_o(d_valid),
      .d_ready_i(d_ready),
      .d_addr_o (addr),
      .d_wstrb_o(wstrb),
      .d_wdata_o(wdata),
      .d_rdata_i(rdata),
      .trap_o   (core_trap)
  );

  assign ram_sel  = d_valid && addr[31:2] < 30'(Words);
  assign bus_sel  = d_valid && addr[31:10] == 22'h20_0000;
  assign sys_sel  = d_valid && addr[31:4] == 28'hC00_0000 && addr[3:2] != 2'd3;
  assign uart_sel = sys_sel && addr[2];
  assign wait_sel = sys_sel && !addr[2];
  assign stray    = d_valid && !ram_sel && !bus_sel && !sys_sel;
  assign write    = wstrb != '0;

  soc_ram #(
      .Words(Words),
      .Image(Image)
  ) u_ram (
      .clk_i    (clk_i),
      .rst_i    (rst_i),
      .i_valid_i(i_valid),
      .i_ready_o(i_ready),
      .d_valid_i(ram_sel),
      .d_ready_o(ram_ready),
      .i_addr_i (i_addr[2+:Width]),
      .d_addr_i (addr[2+:Width]),
      .d_wstrb_i(wstrb),
      .d_wdata_i(wdata),
      .i_rdata_o(i_rdata),
      .d_rdata_o(ram_rdata)
  );

  logic uart_busy, uart_waits, uart_quiescent;
  logic [7:0] uart_byte, uart_lost;

  uart #(
      .ClocksPerBit(ClocksPerBit)
  ) u_uart (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .send_i     (uart_sel && write),
      .busy_o     (uart_busy),
      .take_i     (uart_sel && !write),
      .waits_o    (uart_waits),
      .byte_i     (wdata[7:0]),
      .rx_i       (uart_rx_i),
      .byte_o     (uart_byte),
      .lost_o     (uart_lost),
      .tx_o       (uart_tx_o),
      .quiescent_o(uart_quiescent)
  );

  assign uart_ready = !write || !uart_busy;
  assign wait_ready = irq_i || uart_waits || (addr[3] && !uart_busy);

  always_comb begin
    d_ready = ram_ready || (bus_sel && bus_ready_i);
    rdata   = ram_rdata;
    if (bus_sel) rdata = bus_rdata_i;
    if (uart_sel) begin
      d_ready = uart_ready;
      rdata   = {!uart_waits, 15'd0, uart_lost, uart_byte};
    end
    if (wait_sel) begin
      d_ready = wait_ready;
      rdata   = {29'd0, !uart_busy, uart_waits, irq_i};
    end
  end

  assign bus_valid_o = bus_sel;
  assign bus_addr_o  = addr[9:0];
  assign bus_wstrb_o = wstrb;
  assign bus_wdata_o = wdata;
  assign trap_o      = core_trap || stray;
  assign asks_o      = wait_sel;
  assign waiting_o   = wait_sel && !wait_ready;
  assign quiescent_o = waiting_o && uart_quiescent;

  logic unused_bits;
  assign unused_bits = ^{i_addr[31:2+Width], i_addr[1:0]};

endmodule
