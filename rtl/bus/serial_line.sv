// SPDX-License-Identifier: Apache-2.0
//
// Serial port of 8 data bits, no parity, 1 stop bit that a chip with leaps can wait for: between
// two bits nothing but timers moves. ClocksPerBit clocks a bit; 434 at 50 MHz are 115,207 baud.
//
//   send_i    -> start bit on tx_o    1 clock; busy_o for 10 bits
//   start bit -> valid_o              9.5 bits and 3 clocks: the middle of the stop bit; one clock
//
// A start bit that is gone at its middle is dropped. A byte whose stop bit is low comes with bad_o,
// and the next start bit is looked for when the line was high again.

module serial_line
  import trammel_pkg::*;
#(
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input  logic       send_i,   // ignored while busy
    input  logic [7:0] byte_i,
    output logic       busy_o,
    output logic       valid_o,
    output logic       bad_o,
    output logic [7:0] byte_o,

    input  logic rx_i,
    output logic tx_o,

    output gap_t next_o,
    output logic quiescent_o
);

  localparam int unsigned Width = $clog2(ClocksPerBit + 1);
  typedef logic [Width-1:0] count_t;
  localparam count_t Bit = count_t'(ClocksPerBit);
  localparam count_t Half = count_t'(ClocksPerBit / 2);

  // ---- transmitter: the bits that are left, the next one lowest; ones behind the stop bit ----

  logic [9:0] tx_bits_q;
  logic [3:0] tx_left_q;
  logic tx_begins, tx_turns;
  count_t tx_count;
  gap_t tx_next;

  assign busy_o    = tx_left_q != '0;
  assign tx_o      = tx_bits_q[0];
  assign tx_begins = send_i && !busy_o;
  assign tx_turns  = busy_o && tx_count == count_t'(1);

  timer #(
      .Width(Width)
  ) u_tx (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (tx_begins || (tx_turns && tx_left_q != 4'd1)),
      .value_i(Bit),
      .count_o(tx_count),
      .next_o (tx_next)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      tx_bits_q <= '1;
      tx_left_q <= '0;
    end else if (tx_begins) begin
      tx_bits_q <= {1'b1, byte_i, 1'b0};
      tx_left_q <= 4'd10;
    end else if (tx_turns) begin
      tx_bits_q <= {1'b1, tx_bits_q[9:1]};
      tx_left_q <= tx_left_q - 4'd1;
    end
  end

  // ---- receiver: waits to the middle of the start bit, then a bit at a time ----

  logic rx_meta_q, rx_q, valid_q, bad_q, broken_q;
  logic [3:0] rx_left_q;  // 10: start bit, 9 to 2: data, 1: stop bit, 0: idle
  logic [7:0] rx_bits_q;
  logic rx_idle, rx_begins, rx_turns, rx_false, rx_ends;
  count_t rx_count;
  gap_t rx_next;

  assign rx_idle   = rx_left_q == '0;
  assign rx_begins = rx_idle && !rx_q && !broken_q;
  assign rx_turns  = !rx_idle && rx_count == count_t'(1);
  assign rx_false  = rx_turns && rx_left_q == 4'd10 && rx_q;
  assign rx_ends   = rx_turns && rx_left_q == 4'd1;

  timer #(
      .Width(Width)
  ) u_rx (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (rx_begins || (rx_turns && !rx_ends && !rx_false)),
      .value_i(rx_begins ? Half : Bit),
      .count_o(rx_count),
      .next_o (rx_next)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      rx_meta_q <= 1'b1;
      rx_q      <= 1'b1;
      rx_left_q <= '0;
      rx_bits_q <= '0;
      valid_q   <= 1'b0;
      bad_q     <= 1'b0;
      broken_q  <= 1'b0;
    end else begin
      rx_meta_q <= rx_i;
      rx_q      <= rx_meta_q;
      valid_q   <= rx_ends;
      if (rx_begins) rx_left_q <= 4'd10;
      else if (rx_false) rx_left_q <= '0;
      else if (rx_turns) rx_left_q <= rx_left_q - 4'd1;
      if (rx_turns && !rx_ends) rx_bits_q <= {rx_q, rx_bits_q[7:1]};
      if (rx_ends) bad_q <= !rx_q;
      broken_q <= rx_ends ? !rx_q : broken_q && !rx_q;
    end
  end

  assign valid_o = valid_q;
  assign bad_o = bad_q;
  assign byte_o = rx_bits_q;
  assign next_o = tx_next < rx_next ? tx_next : rx_next;
  assign quiescent_o = !tx_begins && !tx_turns && !rx_begins && !rx_turns && !valid_q &&
      !(broken_q && rx_q) && rx_i == rx_meta_q && rx_meta_q == rx_q;

endmodule
