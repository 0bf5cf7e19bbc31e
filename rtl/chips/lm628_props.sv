// SPDX-License-Identifier: Apache-2.0
//
// Properties of the whole LM628 for any input, without its engine's program: what memories give is
// free in the proof. Clocks passed by leaps count.

module lm628_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic reset_n_i,

    input logic [7:0] dac_o,
    input logic       dac_wr_n_o,
    input logic       hi_o,
    input logic       pwm_mag_o,
    input logic       sample_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input logic rst,
    input logic restart,
    input logic ready,
    input logic begins,
    input logic signed [23:0] count,
    input gap_t time_next,
    input gap_t port_next,
    input gap_t output_next
);

  logic live_q = 1'b0;
  logic was_rst_q, was_begins_q, was_quiescent_q, was_hi_q, was_mag_q;
  logic [1:0] low_q;  // reset_n_i at the two previous edges
  logic [7:0] was_dac_q;
  logic [1:0] history_q;  // edges since live, up to 3
  gap_t was_next_q, was_leap_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst;
    was_begins_q    <= begins;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_hi_q        <= hi_o;
    was_mag_q       <= pwm_mag_o;
    was_dac_q       <= dac_o;
    was_next_q      <= next_o;
    was_leap_q      <= leap_i;
    low_q           <= {low_q[0], reset_n_i};
    if (live_q && history_q != 2'd3) history_q <= history_q + 2'd1;
    if (!live_q) history_q <= '0;
    if (live_q) begin
      pin_resets_after_2_clocks : assert (history_q != 2'd3 || low_q[1] || rst);
      zero_from_reset :
      assert (!was_rst_q || (dac_o == 8'h80 && dac_wr_n_o && !pwm_mag_o && !hi_o && !ready));
      routine_follows_every_reset : assert (!restart || rst);
      counts_from_the_end_of_the_routine :
      assert (!was_begins_q || was_rst_q || (ready && count == '0));
      next_is_the_least :
      assert (next_o <= time_next && next_o <= port_next && next_o <= output_next &&
              (next_o == time_next || next_o == port_next || next_o == output_next));
      samples_when_ready : assert (!sample_o || ready);
      quiescent_holds_the_pins :
      assert (!was_quiescent_q || rst_i || was_leap_q >= was_next_q ||
              (dac_o == was_dac_q && pwm_mag_o == was_mag_q && hi_o == was_hi_q));
      reaches_ready_pin : cover (!was_rst_q && !rst && history_q == 2'd3 && low_q[1]);
    end
  end

  // breaks pin_resets_after_2_clocks: reset_n_q <= next || reset_n_q
  // breaks zero_from_reset (lm628_output): u_q <= rst_i ? u_i : next
  // breaks routine_follows_every_reset: rst = rst_i || !reset_n_q
  // breaks counts_from_the_end_of_the_routine: u_qep.preset_i = 1'b0
  // breaks next_is_the_least: next_o = output_next > next_o ? output_next : next_o
  // breaks samples_when_ready: sample_o = time_quiescent
  // breaks quiescent_holds_the_pins (lm628_output): pwm_mag_o = high[0]

  // prove: free $mem_v2

endmodule

bind lm628 lm628_props u_lm628_props (.*);
