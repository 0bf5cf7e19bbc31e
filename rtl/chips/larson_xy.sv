// SPDX-License-Identifier: Apache-2.0
//
// The X-Y stepper interface of Larson 1974 behind AXI4-Lite: its four words of 16 bits at byte
// offsets 0 to 6, and behind them the interrupt vector, whose read is the grant, and the count of
// byte writes. Fabric clock / 240 kHz = Mod / Inc.
// With Buffered = 0 no pulse buffer reports on buf_busy_i.
//
//   0x0  X count    0x2  X rate and status    0x4  Y count    0x6  Y rate and status
//   0x8  vector of the interrupt that is taken by this read, 0 = none
//   0xC  writes of half a word so far, 65535 at most

module larson_xy
  import trammel_pkg::*;
#(
    parameter int unsigned Inc = 3,
    parameter int unsigned Mod = 625,
    parameter bit Buffered = 1'b1
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 3:0] s_axil_awaddr_i,
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
    input  logic [ 3:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,

    input  logic [1:0] limit_low_i,   // X, Y, as all pairs
    input  logic [1:0] limit_high_i,
    input  logic [1:0] buf_busy_i,
    output logic [1:0] step_o,
    output logic [1:0] forward_o,
    output logic [1:0] flush_o,

    output logic irq_o,
    output gap_t next_o,
    output logic quiescent_o
);

  typedef enum logic [1:0] {
    WordX,
    WordY,
    WordVector,
    WordErrByte
  } word_e;

  logic write, read, bus_quiescent, table_quiescent;
  logic [1:0] word;
  logic [3:0] bytes;
  logic [31:0] written, shown, x, y;
  logic [15:0] err_byte;
  logic [7:0] vector;

  word_axil #(
      .Bits(2)
  ) u_bus (
      .clk_i           (clk_i),
      .rst_i           (rst_i),
      .s_axil_awvalid_i(s_axil_awvalid_i),
      .s_axil_awready_o(s_axil_awready_o),
      .s_axil_awaddr_i (s_axil_awaddr_i),
      .s_axil_awprot_i (s_axil_awprot_i),
      .s_axil_wvalid_i (s_axil_wvalid_i),
      .s_axil_wready_o (s_axil_wready_o),
      .s_axil_wdata_i  (s_axil_wdata_i),
      .s_axil_wstrb_i  (s_axil_wstrb_i),
      .s_axil_bvalid_o (s_axil_bvalid_o),
      .s_axil_bready_i (s_axil_bready_i),
      .s_axil_bresp_o  (s_axil_bresp_o),
      .s_axil_arvalid_i(s_axil_arvalid_i),
      .s_axil_arready_o(s_axil_arready_o),
      .s_axil_araddr_i (s_axil_araddr_i),
      .s_axil_arprot_i (s_axil_arprot_i),
      .s_axil_rvalid_o (s_axil_rvalid_o),
      .s_axil_rready_i (s_axil_rready_i),
      .s_axil_rdata_o  (s_axil_rdata_o),
      .s_axil_rresp_o  (s_axil_rresp_o),
      .write_o         (write),
      .read_o          (read),
      .word_o          (word),
      .bytes_o         (bytes),
      .data_o          (written),
      .data_i          (shown),
      .quiescent_o     (bus_quiescent)
  );

  step_table #(
      .Inc     (Inc),
      .Mod     (Mod),
      .Buffered(Buffered)
  ) u_table (
      .clk_i       (clk_i),
      .rst_i       (rst_i),
      .leap_i      (leap_i),
      .write_i     (write && !word[1]),
      .y_i         (word[0]),
      .bytes_i     (bytes),
      .data_i      (written),
      .grant_i     (read && word == WordVector),
      .limit_low_i (limit_low_i),
      .limit_high_i(limit_high_i),
      .buf_busy_i  (buf_busy_i),
      .step_o      (step_o),
      .forward_o   (forward_o),
      .flush_o     (flush_o),
      .x_o         (x),
      .y_o         (y),
      .err_byte_o  (err_byte),
      .irq_o       (irq_o),
      .vector_o    (vector),
      .next_o      (next_o),
      .quiescent_o (table_quiescent)
  );

  always_comb begin
    unique case (word_e'(word))
      WordX:      shown = x;
      WordY:      shown = y;
      WordVector: shown = 32'(vector);
      default:    shown = 32'(err_byte);
    endcase
  end

  assign quiescent_o = bus_quiescent && table_quiescent;

endmodule
