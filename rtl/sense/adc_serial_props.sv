// SPDX-License-Identifier: Apache-2.0
//
// Properties of adc_serial for any input; clocks passed by leaps count. A leap beyond next_o is an
// error of the caller: what it leads to is left out until the next reset.

module adc_serial_props
  import trammel_pkg::*;
#(
    parameter int unsigned Half = 8
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       start_i,
    input logic [2:0] channel_i,
    input logic       dout_i,
    input logic       cs_n_o,
    input logic       sclk_o,
    input logic       din_o,
    input logic       valid_o,
    input logic [2:0] channel_o,
    input logic [9:0] code_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input logic [5:0] left_q,
    input logic [4:0] din_q,
    input logic [3:0] count
);

  logic live_q = 1'b0;
  logic fair_q, was_rst_q, was_cs_n_q, was_start_q, was_valid_q, was_sclk_q, was_din_q;
  logic was_quiescent_q, was_dout_q;
  logic [2:0] was_channel_q, asked_q;
  logic [9:0] bits_q;  // dout at the rises of a frame, the last ten
  logic [15:0] low_q;  // clocks that cs_n has been low
  logic [4:0] rises_q;
  logic [16:0] outputs, was_outputs_q;

  logic rises;  // sclk rose by the edge before
  logic [9:0] bits;
  logic [2:0] asked;
  assign outputs = {cs_n_o, sclk_o, din_o, valid_o, channel_o, code_o};

  assign rises = !was_rst_q && !was_cs_n_q && sclk_o && !was_sclk_q;
  assign bits  = was_rst_q ? '0 : rises ? {bits_q[8:0], was_dout_q} : bits_q;
  assign asked = !was_rst_q && was_cs_n_q && !cs_n_o ? was_channel_q : asked_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    fair_q          <= rst_i || (fair_q && (leap_i == '0 || leap_i < next_o));
    was_rst_q       <= rst_i;
    was_cs_n_q      <= cs_n_o;
    was_start_q     <= !rst_i && start_i;
    was_valid_q     <= !rst_i && valid_o;
    was_sclk_q      <= sclk_o;
    was_din_q       <= din_o;
    was_dout_q      <= dout_i;
    was_channel_q   <= channel_i;
    was_quiescent_q <= !rst_i && quiescent_o && leap_i < next_o;
    was_outputs_q   <= outputs;
    low_q           <= rst_i || cs_n_o ? '0 : low_q + 16'd1 + 16'(leap_i);
    rises_q         <= rst_i || cs_n_o ? '0 : rises_q + 5'(rises);
    bits_q          <= rst_i ? '0 : bits;
    asked_q         <= asked;
    if (live_q && fair_q) begin
      idle_from_reset : assert (!was_rst_q || (cs_n_o && !sclk_o && !valid_o));
      starts_when_idle :
      assert (was_rst_q || !was_cs_n_q || cs_n_o == !was_start_q);
      selected_for_34_half_periods :
      assert (was_rst_q || was_cs_n_q || !cs_n_o || low_q == 16'(34 * Half));
      clock_low_when_idle : assert (!cs_n_o || !sclk_o);
      valid_as_the_frame_ends : assert (valid_o == (!was_rst_q && !was_cs_n_q && cs_n_o));
      valid_one_clock : assert (!was_valid_q || !valid_o);
      seventeen_rises_a_frame : assert (!valid_o || rises_q + 5'(rises) == 5'd17);
      start_bit_single_ended_channel :
      assert (!rises || din_o == (rises_q == 5'd0 || rises_q == 5'd1 ||
              (rises_q == 5'd2 && asked_q[2]) || (rises_q == 5'd3 && asked_q[1]) ||
              (rises_q == 5'd4 && asked_q[0])));
      din_moves_at_falls_only :
      assert (was_rst_q || was_cs_n_q || cs_n_o || din_o == was_din_q || (was_sclk_q && !sclk_o));
      code_is_the_last_ten_bits : assert (code_o == bits);
      channel_is_the_asked_one : assert (cs_n_o || channel_o == asked);
      quiescent_is_honest : assert (!was_quiescent_q || outputs == was_outputs_q);
      inv_left : assert (cs_n_o == (left_q == '0) && left_q <= 6'd34 && sclk_o == left_q[0]);
      inv_count : assert (cs_n_o || (count != '0 && count <= 4'(Half)));
      inv_low :
      assert (cs_n_o || low_q + 16'(count) + 16'(left_q) * 16'(Half) == 16'(35 * Half));
      inv_rises : assert (cs_n_o || rises_q + 5'(rises) == 5'((6'd35 - left_q) >> 1));
      inv_din :
      assert (cs_n_o || din_q == 5'({2'b11, asked} << ((6'd34 - left_q) >> 1)));
      reaches_a_code : cover (valid_o && code_o == 10'h2A5);
    end
  end

  // breaks idle_from_reset: sclk_q <= rst_i ? start_i : next
  // breaks starts_when_idle: begins = start_i && !busy_q && !valid_q
  // breaks selected_for_34_half_periods: ends = turns && left_q == 6'd3
  // breaks clock_low_when_idle: sclk_o = sclk_q || valid_q
  // breaks valid_as_the_frame_ends: valid_o = valid_q && channel_q != 3'd5
  // breaks valid_one_clock: valid_o = valid_q || (!busy_q && start_i)
  // breaks seventeen_rises_a_frame: left_q <= begins && !rst_i ? 6'd32 : next
  // breaks start_bit_single_ended_channel: din_o = busy_q && din_q[3]
  // breaks din_moves_at_falls_only: din_o = busy_q && din_q[4] && !turns
  // breaks code_is_the_last_ten_bits: shift_q <= turns && !sclk_q && !rst_i ? {dout_i, shift_q[9:1]} : next
  // breaks channel_is_the_asked_one: channel_q <= begins && !rst_i ? ~channel_i : next
  // breaks quiescent_is_honest: quiescent_o = !begins && !turns

  // prove: set Half=2
  // prove: set Half=8

endmodule

bind adc_serial adc_serial_props #(.Half(Half)) u_adc_serial_props (.*);
