// SPDX-License-Identifier: Apache-2.0
//
// Memory of a processor: one block RAM of 32-bit words with two ports, instructions (read only) and
// data (byte strobes; none: a read). A port answers one clock after it was asked and then holds
// what it read; the next access begins in the clock after the answer at the earliest.
// Image is a file of hexadecimal words that the memory holds at power-up.

module soc_ram #(
    parameter int unsigned Words = 64,
    parameter string Image = ""
) (
    input logic clk_i,
    input logic rst_i,

    input  logic i_valid_i,  // held until ready
    output logic i_ready_o,
    input  logic d_valid_i,
    output logic d_ready_o,

    input  logic [$clog2(Words)-1:0] i_addr_i,
    input  logic [$clog2(Words)-1:0] d_addr_i,
    input  logic [              3:0] d_wstrb_i,
    input  logic [             31:0] d_wdata_i,
    output logic [             31:0] i_rdata_o,
    output logic [             31:0] d_rdata_o
);

  logic [31:0] words[Words];
  logic i_ready_q, d_ready_q, i_asked, d_asked;
  logic [31:0] i_rdata_q, d_rdata_q;

  if (Image != "") begin : gen_image
    initial $readmemh(Image, words);
  end

  assign i_asked = i_valid_i && !i_ready_q && !rst_i;
  assign d_asked = d_valid_i && !d_ready_q && !rst_i;

  always_ff @(posedge clk_i) begin
    i_ready_q <= i_asked;
    d_ready_q <= d_asked;
  end

  always_ff @(posedge clk_i) begin
    if (i_asked) i_rdata_q <= words[i_addr_i];
  end

  always_ff @(posedge clk_i) begin
    if (d_asked) begin
      for (int unsigned n = 0; n < 4; n++) begin
        if (d_wstrb_i[n]) words[d_addr_i][8*n+:8] <= d_wdata_i[8*n+:8];
      end
      if (d_wstrb_i == '0) d_rdata_q <= words[d_addr_i];
    end
  end

  assign i_ready_o = i_ready_q;
  assign d_ready_o = d_ready_q;
  assign i_rdata_o = i_rdata_q;
  assign d_rdata_o = d_rdata_q;

endmodule
