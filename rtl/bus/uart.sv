// SPDX-License-Identifier: Apache-2.0
//
// Serial port: 8 data bits, no parity, 1 stop bit, ClocksPerBit clocks a bit; 434 at 50 MHz are
// 115,207 baud. One byte is sent at a time; Depth received bytes (a power of two) wait until they
// are taken; one that comes while all places are taken is lost and counted, up to 255.
//
//   send_i    -> start bit on tx_o    1 clock; busy_o for 10 bits
//   start bit -> waits_o              9.5 bits and 3 clocks: the middle of the stop bit
//   take_i    -> next byte, waits_o   1 clock
//
// A start bit that is gone at its middle and a byte whose stop bit is low are dropped.

module uart #(
    parameter int unsigned ClocksPerBit = 434,
    parameter int unsigned Depth = 16
) (
    input logic clk_i,
    input logic rst_i,

    input  logic send_i,   // ignored while busy
    output logic busy_o,
    input  logic take_i,   // ignored while no byte waits
    output logic waits_o,

    input  logic [7:0] byte_i,
    input  logic       rx_i,
    output logic [7:0] byte_o,  // the oldest that waits
    output logic [7:0] lost_o,
    output logic       tx_o,

    output logic quiescent_o
);

  if (ClocksPerBit < 4 || ClocksPerBit > 65536) begin : gen_refused
    $error("uart: ClocksPerBit is 4 to 65536");
  end
  if (Depth < 2 || Depth > 256 || (Depth & (Depth - 1)) != 0) begin : gen_depth_refused
    $error("uart: Depth is a power of two, 2 to 256");
  end

  localparam int unsigned Width = $clog2(ClocksPerBit);
  typedef logic [Width-1:0] count_t;
  localparam count_t Bit  = count_t'(ClocksPerBit - 1);
  localparam count_t Half = count_t'(ClocksPerBit / 2 - 1);

  // ---- transmitter: the bits that are left, the next one lowest; ones behind the stop bit ----

  logic [9:0] tx_bits_q;
  logic [3:0] tx_left_q;
  count_t tx_count_q;

  assign busy_o = tx_left_q != '0;
  assign tx_o   = tx_bits_q[0];

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      tx_bits_q  <= '1;
      tx_left_q  <= '0;
      tx_count_q <= '0;
    end else if (!busy_o) begin
      if (send_i) begin
        tx_bits_q  <= {1'b1, byte_i, 1'b0};
        tx_left_q  <= 4'd10;
        tx_count_q <= Bit;
      end
    end else if (tx_count_q != '0) begin
      tx_count_q <= tx_count_q - count_t'(1);
    end else begin
      tx_bits_q  <= {1'b1, tx_bits_q[9:1]};
      tx_left_q  <= tx_left_q - 4'd1;
      tx_count_q <= Bit;
    end
  end

  // ---- receiver: waits to the middle of the start bit, then a bit at a time ----

  logic rx_meta_q, rx_q, sample, comes;
  logic [3:0] rx_left_q;  // 10: start bit, 9 to 2: data, 1: stop bit, 0: idle
  logic [7:0] rx_bits_q;
  count_t rx_count_q;

  assign sample = rx_left_q != '0 && rx_count_q == '0;
  assign comes  = sample && rx_left_q == 4'd1 && rx_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      rx_meta_q  <= 1'b1;
      rx_q       <= 1'b1;
      rx_left_q  <= '0;
      rx_count_q <= '0;
      rx_bits_q  <= '0;
    end else begin
      rx_meta_q <= rx_i;
      rx_q      <= rx_meta_q;
      if (rx_left_q == '0) begin
        if (!rx_q) begin
          rx_left_q  <= 4'd10;
          rx_count_q <= Half;
        end
      end else if (!sample) begin
        rx_count_q <= rx_count_q - count_t'(1);
      end else begin
        rx_count_q <= Bit;
        rx_left_q  <= rx_left_q - 4'd1;
        if (rx_left_q == 4'd10 && rx_q) rx_left_q <= '0;
        if (rx_left_q != 4'd1) rx_bits_q <= {rx_q, rx_bits_q[7:1]};
      end
    end
  end

  // ---- received bytes that wait: places with a bit above the address, equal when none does ----

  localparam int unsigned AddrBits = $clog2(Depth);
  typedef logic [AddrBits:0] place_t;

  logic [7:0] bytes[Depth];
  place_t in_q, out_q;
  logic [7:0] lost_q;
  logic no_room, stored;

  assign waits_o = in_q != out_q;
  assign no_room = (in_q ^ out_q) == place_t'(Depth);
  assign stored  = comes && !no_room && !rst_i;
  assign byte_o  = bytes[out_q[AddrBits-1:0]];
  assign lost_o  = lost_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      in_q   <= '0;
      out_q  <= '0;
      lost_q <= '0;
    end else begin
      if (stored) in_q <= in_q + place_t'(1);
      if (take_i && waits_o) out_q <= out_q + place_t'(1);
      if (comes && no_room && lost_q != '1) lost_q <= lost_q + 8'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (stored) bytes[in_q[AddrBits-1:0]] <= rx_bits_q;
  end

  assign quiescent_o = !busy_o && !send_i && !take_i && rx_left_q == '0 && rx_i && rx_meta_q &&
      rx_q;

endmodule
