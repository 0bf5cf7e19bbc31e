// SPDX-License-Identifier: Apache-2.0
//
// Serial port: 8 data bits, no parity, 1 stop bit, ClocksPerBit clocks a bit; 434 at 50 MHz are
// 115,207 baud. One byte is sent at a time; one received byte is held until it is taken, and the
// next one, 10 bits later, takes its place.
//
//   send_i    -> start bit on tx_o    1 clock; busy_o for 10 bits
//   start bit -> full_o               9.5 bits and 3 clocks: the middle of the stop bit
//
// A start bit that is gone at its middle and a byte whose stop bit is low are dropped.

module uart #(
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input  logic send_i,  // ignored while busy
    output logic busy_o,
    input  logic take_i,
    output logic full_o,

    input  logic [7:0] byte_i,
    input  logic       rx_i,
    output logic [7:0] byte_o,
    output logic       tx_o,

    output logic quiescent_o
);

  if (ClocksPerBit < 4 || ClocksPerBit > 65536) begin : gen_refused
    $error("uart: ClocksPerBit is 4 to 65536");
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

  logic rx_meta_q, rx_q, full_q, sample;
  logic [3:0] rx_left_q;  // 10: start bit, 9 to 2: data, 1: stop bit, 0: idle
  logic [7:0] rx_bits_q, byte_q;
  count_t rx_count_q;

  assign sample = rx_left_q != '0 && rx_count_q == '0;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      rx_meta_q  <= 1'b1;
      rx_q       <= 1'b1;
      rx_left_q  <= '0;
      rx_count_q <= '0;
      rx_bits_q  <= '0;
      byte_q     <= '0;
      full_q     <= 1'b0;
    end else begin
      rx_meta_q <= rx_i;
      rx_q      <= rx_meta_q;
      if (take_i) full_q <= 1'b0;
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
        if (rx_left_q == 4'd1) begin
          if (rx_q) begin
            byte_q <= rx_bits_q;
            full_q <= 1'b1;
          end
        end else begin
          rx_bits_q <= {rx_q, rx_bits_q[7:1]};
        end
      end
    end
  end

  assign byte_o = byte_q;
  assign full_o = full_q;
  assign quiescent_o = !busy_o && !send_i && !take_i && rx_left_q == '0 && rx_i && rx_meta_q &&
      rx_q;

endmodule
