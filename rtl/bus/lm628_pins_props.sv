// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_pins for any input.

module lm628_pins_props #(
    parameter int unsigned Variant = 628
) (
    input logic clk_i,
    input logic rst_i,

    input logic       d_oe_i,
    input logic       d_oe_o,
    input logic       direction_o,
    input logic       sample_i,
    input logic [7:0] dac_i,
    input logic       dac_hi_lo_i,
    input logic       dac_wr_n_i,
    input logic       pwm_mag_i,
    input logic       pwm_sign_i,
    input logic [7:0] out_o,

    input logic oe_q,
    input logic direction_q,
    input logic sample_q,
    input logic twelve_q,
    input logic [6:0] hold_q
);

  localparam logic [7:0] Startup = 8'd127;  // clocks for which 12 bits of zero are kept

  logic live_q = 1'b0;
  logic was_rst_q, was_oe_q, was_direction_q;
  logic [1:0] asked_q;  // d_oe_i at the two previous edges, 0 in a reset
  logic [7:0] twelve, pulse;
  logic [7:0] was_dac_q;
  logic was_strobe_q, was_hi_lo_q, was_wr_n_q, was_mag_q, was_sign_q;
  logic was_sample_q, sampled_q;  // a clock and two ago
  logic mode_q;  // the last sample had a strobe
  logic mode;
  logic [7:0] since_q, was_since_q;  // clocks since a strobe or reset, or Startup

  assign twelve = {was_dac_q[7:2], was_hi_lo_q, was_wr_n_q};
  assign pulse  = {was_sign_q, was_mag_q, 6'd0};
  // Of the clock before: a sample that was published two clocks ago shows its strobe there.
  assign mode   = sampled_q ? was_strobe_q : mode_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_oe_q        <= !rst_i && d_oe_o;
    was_direction_q <= !rst_i && direction_o;
    asked_q         <= rst_i ? '0 : {asked_q[0], d_oe_i};
    was_dac_q       <= dac_i;
    was_hi_lo_q     <= dac_hi_lo_i;
    was_wr_n_q      <= dac_wr_n_i;
    was_strobe_q    <= !dac_wr_n_i || !dac_hi_lo_i;
    was_mag_q       <= pwm_mag_i;
    was_sign_q      <= pwm_sign_i;
    was_sample_q    <= !rst_i && sample_i;
    sampled_q       <= !rst_i && was_sample_q;
    mode_q          <= !rst_i && mode && !was_rst_q;
    was_since_q     <= rst_i ? '0 : since_q;
    since_q         <= rst_i || !dac_wr_n_i || !dac_hi_lo_i ? '0 :
        was_sample_q || since_q == Startup ? Startup : since_q + 8'd1;
    if (live_q) begin
      quiet_from_reset :
      assert (!was_rst_q || (!d_oe_o && !direction_o &&
                             out_o == (Variant == 629 ? 8'h00 : 8'h83)));
      drives_toward_the_host_only : assert (!d_oe_o || direction_o);
      turns_before_it_drives : assert (!d_oe_o || was_oe_q || was_direction_q);
      drives_no_longer_before_it_turns_back :
      assert (was_rst_q || direction_o || !was_oe_q);
      drives_after_2_clocks : assert (was_rst_q || asked_q != '1 || d_oe_o);
      off_after_a_clock : assert (!d_oe_o || asked_q[0]);
      turns_back_after_2_clocks : assert (!direction_o || asked_q != '0);
      shows_the_output :
      assert (was_rst_q || out_o == (Variant == 629 ? pulse :
              was_strobe_q || (!sampled_q && (mode_q || was_since_q != Startup)) ? twelve :
              was_dac_q));
      inv_direction :
      assert (was_rst_q || (oe_q == (asked_q[0] && was_direction_q) &&
              direction_q == (asked_q[0] || was_oe_q)));
      inv_mode :
      assert (was_rst_q || (sample_q == was_sample_q && twelve_q == mode));
      inv_hold : assert (9'(hold_q) + 9'(since_q) == 9'(Startup));
      reaches_a_drive : cover (d_oe_o && direction_o);
      reaches_12_bits : cover (!was_rst_q && mode_q && !was_strobe_q);
    end
  end

  // breaks quiet_from_reset: oe_q <= rst_i ? d_oe_i : next
  // breaks drives_toward_the_host_only: direction_q <= next && !sample_i
  // breaks turns_before_it_drives: oe_q <= d_oe_i && !rst_i
  // breaks drives_no_longer_before_it_turns_back: direction_q <= d_oe_i && !rst_i
  // breaks drives_after_2_clocks: oe_q <= next && !sample_i
  // breaks off_after_a_clock: oe_q <= next || (oe_q && !rst_i)
  // breaks turns_back_after_2_clocks: direction_q <= next || (direction_q && !rst_i)
  // breaks shows_the_output: eight = !strobes && !twelve_q && hold_q == '0
  // breaks shows_the_output: Hold = 7'd126
  // breaks shows_the_output: twelve_q <= next && sample_q

  // prove: set Variant=628
  // prove: set Variant=629
  // prove: frames 300

endmodule

bind lm628_pins lm628_pins_props #(.Variant(Variant)) u_lm628_pins_props (.*);
