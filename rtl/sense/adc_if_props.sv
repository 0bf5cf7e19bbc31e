// SPDX-License-Identifier: Apache-2.0
//
// Properties of adc_if for any input; frame_q independently counts clocks since the fall of cs_n.

module adc_if_props (
    input logic clk_i,
    input logic rst_i,

    input logic       start_i,
    input logic [2:0] zeros_i,

    input logic sdata_a_i,
    input logic sdata_b_i,

    input logic        cs_n_o,
    input logic        sclk_o,
    input logic        busy_o,
    input logic        valid_o,
    input logic [11:0] code_a_o,
    input logic [11:0] code_b_o,
    input logic        quiescent_o,

    input logic [ 5:0] clock_q,
    input logic [ 2:0] zeros_q,
    input logic [11:0] shift_a_q,
    input logic [11:0] shift_b_q
);

  localparam logic [6:0] Clocks = 7'd64;  // of a frame: 16 periods of 4

  logic live_q = 1'b0;
  logic was_rst_q, was_cs_n_q, was_sclk_q, was_start_q, was_valid_q, was_quiescent_q;
  logic [6:0] frame_q;  // clocks since cs_n fell; Clocks = no frame
  logic [4:0] falls_q;  // falls of sclk in this frame
  logic [11:0] bits_a_q, bits_b_q;  // of this frame, by the fall that follows them
  logic [23:0] was_codes_q;
  logic [57:0] state, was_state_q;  // all registers except the line data
  logic falls;
  logic [2:0] zeros_at_start_q;
  logic [3:0] last;  // period that brings the last bit
  logic [4:0] taken;  // samples of this frame so far
  logic [11:0] mask;  // of their bits, without the leading zeros

  assign falls = was_sclk_q && !sclk_o;
  assign last  = zeros_at_start_q < 3'd4 ? 4'd11 + 4'(zeros_at_start_q) : 4'd15;
  assign taken = frame_q > 7'(4 * last + 1) ? 5'(last) + 5'd1 : 5'((frame_q + 7'd2) >> 2);
  assign mask  = taken + 5'd11 < 5'(last) ? '0 : ~(12'hFFF << (taken + 5'd11 - 5'(last)));
  assign state = {cs_n_o, sclk_o, valid_o, clock_q[3:0], zeros_q, shift_a_q, shift_b_q, code_a_o,
                  code_b_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_cs_n_q      <= rst_i || cs_n_o;
    was_sclk_q      <= rst_i || sclk_o;
    was_start_q     <= !rst_i && start_i;
    was_valid_q     <= !rst_i && valid_o;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_codes_q     <= {code_a_o, code_b_o};
    was_state_q     <= state;
    if (rst_i) frame_q <= Clocks;
    else if (frame_q != Clocks) frame_q <= frame_q + 7'd1;
    else if (start_i) frame_q <= '0;
    if (start_i && frame_q == Clocks) zeros_at_start_q <= zeros_i;
    falls_q <= (rst_i || cs_n_o ? '0 : falls_q) + 5'(falls);
    // The bit on the line at the edge that lowers sclk, behind the leading zeros.
    for (int n = 0; n < 12; n++) begin
      if (frame_q == 7'(4 * (32'(last) - n) + 1)) begin
        bits_a_q[n] <= sdata_a_i;
        bits_b_q[n] <= sdata_b_i;
      end
    end
    if (rst_i) begin
      bits_a_q <= '0;
      bits_b_q <= '0;
    end
    if (live_q) begin
      idle_from_reset : assert (!was_rst_q || (cs_n_o && sclk_o && !valid_o));
      starts_when_idle : assert (!was_cs_n_q || cs_n_o == !was_start_q);
      selected_exactly_64_clocks : assert (cs_n_o == (frame_q == Clocks));
      clock_quiet_when_idle : assert (!cs_n_o || sclk_o);
      clock_has_4_clocks :
      assert (cs_n_o || sclk_o == (frame_q == '0 || frame_q[1:0] == 2'd0 || frame_q[1:0] == 2'd1));
      sixteen_falls_a_frame : assert (was_cs_n_q || !cs_n_o || was_rst_q || falls_q == 5'd16);
      valid_as_the_frame_ends : assert (valid_o == (!was_rst_q && !was_cs_n_q && cs_n_o));
      valid_one_clock : assert (!was_valid_q || !valid_o);
      code_is_12_bits_behind_the_zeros :
      assert (!valid_o || {code_a_o, code_b_o} == {bits_a_q, bits_b_q});
      code_holds : assert (was_rst_q || valid_o || {code_a_o, code_b_o} == was_codes_q);
      busy_while_selected : assert (busy_o == !cs_n_o);
      quiescent_is_honest : assert (!was_quiescent_q || state == was_state_q);
      inv_frame : assert (frame_q <= Clocks);
      inv_clock : assert (clock_q == frame_q[5:0]);
      inv_falls : assert (cs_n_o || 7'(falls_q) == (frame_q + 7'd1) >> 2);
      inv_zeros : assert (cs_n_o || zeros_q == zeros_at_start_q);
      inv_bits_a :
      assert (mask == '0 || (shift_a_q & mask) == bits_a_q >> (5'(last) + 5'd1 - taken));
      inv_bits_b :
      assert (mask == '0 || (shift_b_q & mask) == bits_b_q >> (5'(last) + 5'd1 - taken));
      inv_codes :
      assert (!valid_o || {code_a_o, code_b_o} == {shift_a_q, shift_b_q});
      reaches_valid : cover (valid_o && code_a_o == 12'hA53 && code_b_o == 12'h7FF);
    end
  end

  // breaks idle_from_reset: sclk_q <= rst_i ? sdata_a_i : next
  // breaks starts_when_idle: busy_d = busy_q ? !finish : start_i && !valid_q
  // breaks selected_exactly_64_clocks: Last = Last - 6'd1
  // breaks clock_quiet_when_idle: sclk_q <= busy_q && !rst_i ? clock_q[1:0] == 2'd0 : next
  // breaks clock_has_4_clocks: sclk_q <= busy_q && !rst_i ? clock_q[1:0] != 2'd2 : next
  // breaks sixteen_falls_a_frame: Last = Last - 6'd4
  // breaks valid_as_the_frame_ends: valid_q <= sample && clock_q == 6'd61 && !rst_i
  // breaks valid_one_clock: valid_q <= next || (valid_q && !start_i && !rst_i)
  // breaks code_is_12_bits_behind_the_zeros: sample = busy_q && clock_q[1:0] == 2'd1
  // breaks code_is_12_bits_behind_the_zeros: shift_b_q <= sample && !rst_i ? {shift_b_q[10:0], sdata_a_i} : next
  // breaks code_holds: code_a_q <= rst_i ? next : valid_q ? shift_a_q : code_a_q
  // breaks busy_while_selected: busy_o = busy_d
  // breaks quiescent_is_honest: quiescent_o = !busy_q

endmodule

bind adc_if adc_if_props u_adc_if_props (.*);
