// SPDX-License-Identifier: Apache-2.0
//
// Properties of serial_line, for any line and any sends; clocks passed by leaps count. A leap
// beyond next_o is an error of the caller, and so is one in which a pin moves or a register would:
// what these lead to is left out until the next reset.

module serial_line_props
  import trammel_pkg::*;
#(
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       send_i,
    input logic [7:0] byte_i,
    input logic       busy_o,
    input logic       valid_o,
    input logic       bad_o,
    input logic [7:0] byte_o,
    input logic       rx_i,
    input logic       tx_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input logic [ 9:0] tx_bits_q,
    input logic [ 3:0] tx_left_q,
    input logic [31:0] tx_count,
    input logic        rx_q,
    input logic        rx_meta_q,
    input logic        broken_q,
    input logic [ 3:0] rx_left_q,
    input logic [31:0] rx_count
);

  localparam logic [31:0] Bit = 32'(ClocksPerBit);
  localparam logic [31:0] Half = 32'(ClocksPerBit / 2);

  logic live_q = 1'b0;
  logic fair_q, was_rst_q, was_quiescent_q, was_tx_q, was_valid_q;

  // ---- what is sent: the frame, and the clocks since it began ----

  logic sends_q;
  logic [9:0] frame_q, now_sent;
  logic [31:0] sent_q;

  always_comb begin
    now_sent = '0;
    for (int k = 0; k < 10; k++) begin
      now_sent[k] = sent_q >= 32'(k) * Bit && sent_q < 32'(k + 1) * Bit;
    end
  end

  // ---- what comes: bits at the middles of a frame, and the clocks since it began ----

  logic hears_q, middle, ends, ended_q, stop_q, release_q;
  logic [9:0] taken_q;  // start bit lowest
  logic [3:0] number_q;  // of them
  logic [31:0] heard_q;

  assign middle = hears_q && heard_q == Half + 32'(number_q) * Bit;
  assign ends   = middle && (number_q == 4'd9 || (number_q == 4'd0 && rx_q));

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    fair_q          <= rst_i || (fair_q && (leap_i == '0 || (leap_i < next_o && quiescent_o)));
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_tx_q        <= tx_o;
    was_valid_q     <= valid_o;
    if (rst_i) begin
      sends_q <= 1'b0;
    end else if (!sends_q) begin
      sends_q <= send_i;
      frame_q <= {1'b1, byte_i, 1'b0};
      sent_q  <= '0;
    end else begin
      sent_q <= sent_q + 32'd1 + 32'(leap_i);
      if (sent_q == 32'd10 * Bit - 32'd1) sends_q <= 1'b0;
    end
    ended_q <= !rst_i && ends && number_q == 4'd9;
    if (ends) stop_q <= rx_q;
    if (rst_i) begin
      hears_q   <= 1'b0;
      release_q <= 1'b1;
    end else if (!hears_q) begin
      hears_q   <= !rx_q && release_q;
      release_q <= release_q || rx_q;
      heard_q   <= 32'd1;
      number_q  <= '0;
      taken_q   <= '0;
    end else begin
      heard_q <= heard_q + 32'd1 + 32'(leap_i);
      if (middle) begin
        taken_q[number_q] <= rx_q;
        number_q          <= number_q + 4'd1;
      end
      if (ends) begin
        hears_q   <= 1'b0;
        release_q <= rx_q;
      end
    end
    if (live_q && fair_q) begin
      quiet_from_reset : assert (!was_rst_q || (tx_o && !busy_o && !valid_o));
      busy_is_a_frame_of_10_bits : assert (busy_o == sends_q);
      sends_what_was_asked : assert (!sends_q || tx_o == ((frame_q & now_sent) != '0));
      line_rests_high : assert (busy_o || tx_o);
      a_byte_at_each_stop_bit : assert (valid_o == ended_q);
      bad_where_the_stop_bit_is_low : assert (!valid_o || bad_o == !stop_q);
      byte_is_that_of_the_line : assert (!valid_o || byte_o == taken_q[8:1]);
      waits_for_a_high_line_behind_a_bad_byte :
      assert (hears_q || rx_left_q == '0);
      quiescent_is_honest :
      assert (!was_quiescent_q || (tx_o == was_tx_q && valid_o == was_valid_q));

      inv_sends :
      assert (sends_q ? (sent_q + tx_count + 32'd1 == (32'd11 - 32'(tx_left_q)) * Bit + 32'd1 &&
              tx_left_q <= 4'd10 && tx_left_q != '0 && tx_count <= Bit && tx_count != '0 &&
              tx_bits_q == 10'({10'h3FF, frame_q} >> (4'd10 - tx_left_q))) :
              (tx_bits_q == '1 && tx_left_q == '0));
      inv_hears :
      assert (hears_q ? (rx_left_q == 4'd10 - number_q && number_q <= 4'd9 && rx_count != '0 &&
              heard_q + rx_count == Half + 32'(number_q) * Bit + 32'd1 && rx_count <= Bit &&
              !broken_q) : (rx_left_q == '0 && release_q == !broken_q));
      inv_taken :
      assert (!hears_q || number_q <= 4'd1 || byte_o >> (4'd9 - number_q) == taken_q[8:1]);
      inv_number : assert (!hears_q || (taken_q >> number_q) == '0);
      inv_start : assert (!hears_q || number_q == '0 || !taken_q[0]);
      reaches_a_byte_sent : cover (sends_q && sent_q == 32'd10 * Bit - 32'd1 && frame_q[1]);
      reaches_a_byte_received : cover (valid_o && byte_o == 8'h5A && !bad_o);
    end
  end

  logic unused_was;
  assign unused_was = ^{rx_i, rx_meta_q};

  // breaks quiet_from_reset: valid_q <= next || (rst_i && send_i)
  // breaks busy_is_a_frame_of_10_bits: Bit = Bit - count_t'(1)
  // breaks sends_what_was_asked: tx_bits_q <= tx_begins && !rst_i ? {1'b1, byte_i[6:0], byte_i[7], 1'b0} : next
  // breaks line_rests_high: tx_o = tx_bits_q[0] && !send_i
  // breaks a_byte_at_each_stop_bit: valid_q <= rx_ends && rx_q && !rst_i
  // breaks bad_where_the_stop_bit_is_low: bad_q <= rx_ends && !rst_i ? rx_q : next
  // breaks byte_is_that_of_the_line: rx_bits_q <= rx_turns && rx_left_q == 4'd2 && !rst_i ? rx_bits_q : next
  // breaks waits_for_a_high_line_behind_a_bad_byte: broken_q <= 1'b0
  // breaks quiescent_is_honest: quiescent_o = !tx_turns && !rx_begins && !rx_turns && !valid_q

  // prove: set ClocksPerBit=4
  // prove: set ClocksPerBit=7

endmodule

bind serial_line serial_line_props #(.ClocksPerBit(ClocksPerBit)) u_serial_line_props (
    .*,
    .tx_count(32'(tx_count)),
    .rx_count(32'(rx_count))
);
