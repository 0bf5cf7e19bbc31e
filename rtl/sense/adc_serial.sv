// SPDX-License-Identifier: Apache-2.0
//
// Frame of a converter of the MCP3008 type: 8 channels against ground, 10 bits.
//
//   clock        1      2     3 4 5    6         7     8 ... 17
//   din          start  1     channel
//   dout                                hold      null  B9 ... B0
//
// A period of sclk has 2 Half clocks; it rises Half clocks after cs_n fell. din changes at its
// falls, dout is taken at its rises; the converter holds its input at fall 6, 12 Half clocks after
// cs_n fell. cs_n rises with fall 17, 34 Half clocks after it fell, and valid_o comes with it. A
// start during a frame is ignored. Half is 2 to 14; 8 at 50 MHz is 3.125 MHz.

module adc_serial
  import trammel_pkg::*;
#(
    parameter int unsigned Half = 8
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       start_i,
    input logic [2:0] channel_i,

    input  logic dout_i,
    output logic cs_n_o,
    output logic sclk_o,
    output logic din_o,

    output logic       valid_o,     // one clock
    output logic [2:0] channel_o,
    output logic [9:0] code_o,
    output gap_t       next_o,
    output logic       quiescent_o
);

  localparam logic [5:0] Edges = 6'd34;

  logic busy_q, sclk_q, valid_q, begins, turns, ends;
  logic [5:0] left_q;  // edges of sclk to come
  logic [4:0] din_q;  // the next bit highest
  logic [9:0] shift_q;
  logic [2:0] channel_q;
  logic [3:0] count;

  assign begins = start_i && !busy_q;
  assign turns  = busy_q && count == 4'd1;
  assign ends   = turns && left_q == 6'd1;

  timer #(
      .Width(4)
  ) u_half (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (begins || (turns && !ends)),
      .value_i(4'(Half)),
      .count_o(count),
      .next_o (next_o)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      busy_q    <= 1'b0;
      sclk_q    <= 1'b0;
      valid_q   <= 1'b0;
      left_q    <= '0;
      din_q     <= '0;
      shift_q   <= '0;
      channel_q <= '0;
    end else begin
      valid_q <= ends;
      if (begins) begin
        busy_q    <= 1'b1;
        left_q    <= Edges;
        din_q     <= {2'b11, channel_i};
        channel_q <= channel_i;
      end
      if (turns) begin
        left_q <= left_q - 6'd1;
        sclk_q <= !sclk_q;
        if (sclk_q) din_q <= {din_q[3:0], 1'b0};
        else shift_q <= {shift_q[8:0], dout_i};
      end
      if (ends) busy_q <= 1'b0;
    end
  end

  assign cs_n_o      = !busy_q;
  assign sclk_o      = sclk_q;
  assign din_o       = busy_q && din_q[4];
  assign valid_o     = valid_q;
  assign channel_o   = channel_q;
  assign code_o      = shift_q;
  assign quiescent_o = !begins && !turns && !valid_q;

endmodule
