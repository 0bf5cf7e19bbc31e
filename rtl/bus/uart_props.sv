// SPDX-License-Identifier: Apache-2.0
//
// Properties of uart for any input. Beside the block stand two counts of clocks, since the byte was
// asked for and since the receiver saw a start bit: which bit is on the line follows from them. The
// bytes that wait are a queue whose oldest is always its first.

module uart_props #(
    parameter int unsigned ClocksPerBit = 434,
    parameter int unsigned Depth = 16
) (
    input logic clk_i,
    input logic rst_i,

    input logic       send_i,
    input logic       busy_o,
    input logic       take_i,
    input logic       waits_o,
    input logic [7:0] byte_i,
    input logic       rx_i,
    input logic [7:0] byte_o,
    input logic [7:0] lost_o,
    input logic       tx_o,
    input logic       quiescent_o,

    input logic [ 9:0] tx_bits_q,
    input logic [ 3:0] tx_left_q,
    input logic [19:0] tx_count,
    input logic        rx_meta_q,
    input logic        rx_q,
    input logic [ 3:0] rx_left_q,
    input logic [ 7:0] rx_bits_q,
    input logic [19:0] rx_count,
    input logic [ 7:0] bytes[Depth],
    input logic [ 8:0] in,
    input logic [ 8:0] out
);

  localparam logic [19:0] Bit = 20'(ClocksPerBit);
  localparam logic [19:0] Middle = 20'(ClocksPerBit / 2 - 1);  // of the start bit, from its begin

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_waits_q, was_tx_q;
  logic [7:0] was_byte_q, was_lost_q;
  logic [1:0] line_q;  // rx_i of the two clocks before; 1 from a reset on

  // Sender: the frame, and clocks since it began.
  logic sends_q, was_sends_q;
  logic [19:0] sent_q;
  logic [9:0] frame_q;
  logic [9:0] now_sent;  // one bit: that of the frame which is on the line

  // Receiver: clocks since its start bit was seen, bits at their middles.
  logic hears_q;
  logic [19:0] heard_q;
  logic [8:1] taken_q;
  logic [9:0] middle;  // one bit: that of the frame whose middle is now
  logic comes;         // a byte, at the middle of a high stop bit

  // What waits, the oldest first, and what found no place.
  logic [7:0] queue_q[Depth];
  logic [8:0] count_q, stay;  // stay: behind what is taken in this clock
  logic [Depth-1:0] agrees;   // each with its place in the block
  logic [7:0] lost_q;
  logic takes, stored;

  always_comb begin
    for (int unsigned n = 0; n < 10; n++) begin
      now_sent[n] = sent_q >= 20'(n) * Bit && sent_q < 20'(n + 1) * Bit;
      middle[n]   = hears_q && heard_q == Middle + 20'(n) * Bit;
    end
    comes  = middle[9] && line_q[1];
    stored = comes && count_q != 9'(Depth);
    takes  = take_i && count_q != '0;
    stay   = count_q - 9'(takes);
    for (int unsigned n = 0; n < Depth; n++) begin
      agrees[n] = 9'(n) >= count_q || bytes[(32'(out)+n)%Depth] == queue_q[n];
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_waits_q     <= waits_o;
    was_tx_q        <= tx_o;
    was_byte_q      <= byte_o;
    was_lost_q      <= lost_o;
    was_sends_q     <= !rst_i && sends_q;
    line_q          <= rst_i ? '1 : {line_q[0], rx_i};

    if (rst_i) begin
      sends_q <= 1'b0;
    end else if (!sends_q) begin
      sends_q <= send_i;
      sent_q  <= '0;
      frame_q <= {1'b1, byte_i, 1'b0};
    end else begin
      sent_q  <= sent_q + 20'd1;
      sends_q <= sent_q != 20'd10 * Bit - 20'd1;
    end

    if (rst_i) begin
      hears_q <= 1'b0;
      count_q <= '0;
      lost_q  <= '0;
    end else begin
      if (!hears_q) begin
        hears_q <= !line_q[1];
        heard_q <= '0;
      end else begin
        heard_q <= heard_q + 20'd1;
        for (int unsigned n = 1; n < 9; n++) if (middle[n]) taken_q[n] <= line_q[1];
        if ((middle[0] && line_q[1]) || middle[9]) hears_q <= 1'b0;
      end
      count_q <= stay + 9'(stored);
      if (comes && !stored && lost_q != 8'd255) lost_q <= lost_q + 8'd1;
      for (int unsigned n = 0; n < Depth; n++) begin
        if (takes && n + 1 < Depth) queue_q[n] <= queue_q[(n+1)%Depth];
        if (stored && stay == 9'(n)) queue_q[n] <= taken_q;
      end
    end

    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (tx_o && !busy_o && !waits_o && lost_o == '0));
      busy_is_a_frame_of_10_bits : assert (busy_o == sends_q);
      sends_what_was_asked : assert (!sends_q || tx_o == ((frame_q & now_sent) != '0));
      line_rests_high : assert (busy_o || tx_o);
      waits_from_a_good_stop_bit_until_taken : assert (waits_o == (count_q != '0));
      byte_is_the_oldest_of_the_line : assert (count_q == '0 || byte_o == queue_q[0]);
      lost_counts_bytes_without_a_place : assert (lost_o == lost_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (tx_o == was_tx_q && waits_o == was_waits_q &&
              byte_o == was_byte_q && lost_o == was_lost_q && !busy_o && rx_left_q == '0));

      inv_sends :
      assert (!sends_q || (sent_q + tx_count + 20'd1 == (20'd11 - 20'(tx_left_q)) * Bit &&
              tx_left_q <= 4'd10 && tx_count < Bit && tx_bits_q == shifted(frame_q, tx_left_q)));
      inv_count :
      assert (count_q <= 9'(Depth) &&
              (in - out == count_q || in - out + 9'(2 * Depth) == count_q));
      inv_queue : assert (agrees == '1);
      inv_rests : assert (sends_q || tx_bits_q == '1);
      inv_line : assert (line_q == {rx_q, rx_meta_q});
      inv_hears : assert (hears_q == (rx_left_q != '0) && rx_left_q <= 4'd10);
      inv_heard :
      assert (!hears_q ||
              (heard_q + rx_count == Middle + (20'd10 - 20'(rx_left_q)) * Bit && rx_count < Bit));
      inv_start : assert (rx_left_q != 4'd10 || rx_count <= Middle);
      inv_taken :
      assert (rx_left_q == '0 || rx_left_q >= 4'd9 ||
              (rx_bits_q >> rx_left_q - 4'd1) ==
              (taken_q & ~(8'hFF << 4'd9 - rx_left_q)));

      reaches_a_byte_sent : cover (was_sends_q && !busy_o && frame_q[1]);
      reaches_a_byte_received : cover (waits_o && byte_o == 8'h5A);
      reaches_a_byte_lost : cover (lost_o != '0);
    end
  end

  // What is left to send of a frame: ones follow the stop bit.
  function automatic logic [9:0] shifted(logic [9:0] frame, logic [3:0] left);
    return 10'({10'h3FF, frame} >> (4'd10 - left));
  endfunction

  // breaks quiet_from_reset: lost_q <= next || (rst_i && take_i)
  // breaks busy_is_a_frame_of_10_bits: Bit = Bit - count_t'(1)
  // breaks sends_what_was_asked: tx_bits_q <= !busy_o && send_i && !rst_i ? {1'b1, byte_i[6:0], byte_i[7], 1'b0} : next
  // breaks line_rests_high: tx_o = tx_bits_q[0] && !send_i
  // breaks waits_from_a_good_stop_bit_until_taken: comes = sample && rx_left_q == 4'd1
  // breaks waits_from_a_good_stop_bit_until_taken: out_q <= take_i && !rst_i ? out_q + place_t'(1) : next
  // breaks byte_is_the_oldest_of_the_line: rx_q <= rx_i
  // breaks lost_counts_bytes_without_a_place: lost_q <= comes && !rst_i ? lost_q + 8'd1 : next
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !send_i && !take_i && rx_left_q == '0

  // prove: set ClocksPerBit=4 Depth=2
  // prove: set ClocksPerBit=7 Depth=4
  // prove: frames 130

endmodule

bind uart uart_props #(
    .ClocksPerBit(ClocksPerBit),
    .Depth(Depth)
) u_uart_props (
    .*,
    .in(9'(in_q)),
    .out(9'(out_q)),
    .tx_count(20'(tx_count_q)),
    .rx_count(20'(rx_count_q))
);
