// SPDX-License-Identifier: Apache-2.0
//
// Properties of sincos_observer for any codes, asks and calibration words. Its multiplier is free:
// what the polynomials give is compared with the twin. Where an ask or a code comes while it works
// it is not looked at.

module sincos_observer_props
  import sincos_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic               tick_i,
    input logic               restart_i,
    input logic               active_i,
    input logic               velocity_i,
    input logic               ask_i,
    input logic               sample_i,
    input logic        [ 2:0] channel_i,
    input logic        [ 9:0] code_i,
    input calib_addr_t        calib_addr_o,
    input calib_t             calib_i,
    input logic               asked_o,
    input logic        [ 2:0] channel_o,
    input logic signed [31:0] position_o,
    input logic signed [22:0] velocity_o,
    input logic        [13:0] phase_o,
    input logic        [ 1:0] region_o,
    input logic               known_o,
    input logic               busy_o,
    input logic               quiescent_o,

    input logic [4:0] state,
    input logic [2:0] step_q,
    input logic [1:0] region_q,
    input logic [1:0] seen_q,
    input logic       used_q,
    input logic       invert_q,
    input logic       dot_next_q
);

  localparam logic [4:0] Rest = 5'd0;  // of the module's state_e
  localparam logic [4:0] Limit2 = 5'd3;
  localparam logic [4:0] Limit01 = 5'd4;
  localparam logic [4:0] Limit3 = 5'd5;
  localparam logic [4:0] Channel = 5'd6;
  localparam logic [4:0] Phase = 5'd9;
  localparam logic [4:0] Shift = 5'd16;
  localparam logic [4:0] Numeric = 5'd18;

  logic live_q = 1'b0;
  logic was_zero_q, was_quiescent_q, was_known_q;
  logic [4:0] was_state_q;
  logic [31:0] was_position_q;
  logic [22:0] was_velocity_word_q;
  logic [4:0] works_q;  // clocks that it has worked, 31 at most
  logic [2:0] waits_q;  // clocks since an ask that it works on, 7 at most
  logic [1:0] asked_q;  // encoders whose codes it has asked for and taken
  logic [1:0] last_q;  // channel it asked for last
  logic last_known_q;
  logic [4:0] short_left;
  logic signed [31:0] way;

  assign way = position_o - was_position_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_zero_q          <= rst_i || restart_i;
    was_quiescent_q     <= !rst_i && quiescent_o;
    was_known_q         <= known_o;
    was_state_q         <= state;
    was_position_q      <= position_o;
    was_velocity_word_q <= velocity_o;
    works_q             <= rst_i || restart_i || !busy_o ? '0 : works_q + 5'(works_q != '1);
    waits_q             <= rst_i || restart_i || state < Limit2 || state > Channel ? '0 :
        waits_q + 3'(waits_q != '1);
    if (rst_i || restart_i) asked_q <= '0;
    else if (state == Rest && sample_i && active_i && !known_o && !channel_i[2] && !channel_i[0])
      asked_q[channel_i[1]] <= 1'b1;
    if (rst_i || restart_i) begin
      last_known_q <= 1'b0;
    end else if (asked_o) begin
      last_known_q <= known_o;
      last_q       <= channel_o[1:0];
    end
    if (live_q) begin
      zero_from_a_restart :
      assert (!was_zero_q || (position_o == '0 && velocity_o == '0 && phase_o == '0 && !known_o &&
              !busy_o));
      known_after_both_encoders : assert (!known_o || asked_q == '1);
      asks_for_a_then_b_at_the_start :
      assert (!asked_o || known_o || channel_o == {1'b0, asked_q[0], 1'b0});
      asks_for_the_encoder_of_the_region :
      assert (!asked_o || !known_o || (!channel_o[2] && channel_o[1] == !region_q[0]));
      derivative_follows_its_encoder :
      assert (!asked_o || !known_o || !channel_o[0] ||
              (last_known_q && !last_q[0] && last_q[1] == channel_o[1]));
      region_within_the_limits_it_reads :
      assert (was_zero_q || was_state_q != Limit3 || region_q == 2'd3 || region_q == 2'd0);
      answers_within_5_clocks : assert (waits_q <= 3'd4);
      works_11_clocks_at_most : assert (works_q <= 5'd11);
      position_is_the_phase :
      assert (!used_q || position_o[13:0] == (invert_q ? -phase_o : phase_o));
      position_goes_the_shorter_way : assert (was_zero_q || (way >= -8192 && way < 8192));
      position_moves_with_a_code_only :
      assert (was_zero_q || was_state_q == Phase || position_o == was_position_q);
      bit_0_tells_the_source :
      assert (was_zero_q || ((was_state_q != Shift || !velocity_o[0]) &&
              (was_state_q != Numeric || velocity_o[0])));
      velocity_zero_before_the_first_code : assert (used_q || velocity_o[22:1] == '0 || known_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || (position_o == was_position_q &&
              velocity_o == was_velocity_word_q && known_o == was_known_q && !busy_o));
      inv_state : assert (state <= Numeric);
      inv_seen : assert (seen_q == asked_q);
      inv_known : assert (known_o || (!used_q && state <= 5'd2 && velocity_o == '0));
      inv_start : assert (state < 5'd1 || state > 5'd2 || (seen_q == '1 && !known_o));
      inv_dot : assert (!dot_next_q || (known_o && last_known_q && !last_q[0] &&
                                        last_q[1] == !region_q[0] &&
                                        (state < Limit2 || state > Channel)));
      inv_left : assert (state == Rest || works_q + short_left <= 5'd11);
      inv_waits :
      assert ((state != Limit2 || waits_q == 3'd0) && (state != Limit3 || waits_q == 3'd1) &&
              (state != Limit01 || waits_q == 3'd2 - step_q));
      inv_channel : assert (state != Channel || (waits_q >= 3'd2 && waits_q <= 3'd3));
      inv_step :
      assert ((state != Limit01 || step_q <= 3'd1) && (state != 5'd8 || step_q <= 3'd3) &&
              (state != 5'd13 || step_q <= 3'd4));
      reaches_a_derivative : cover (velocity_o[22] && velocity_o[5]);
      reaches_a_difference : cover (velocity_o[0]);
    end
  end

  // Clocks of work that are left at most, with the present one.
  always_comb begin
    unique case (state)
      5'd0: short_left = 5'd0;
      5'd1: short_left = 5'd2;
      5'd2: short_left = 5'd1;
      5'd3: short_left = 5'd4;
      5'd4: short_left = 5'd2 + 5'(step_q);
      5'd5: short_left = 5'd2;
      5'd6: short_left = 5'd1;
      5'd7: short_left = 5'd6;
      5'd8: short_left = 5'd5 - 5'(step_q);
      5'd9: short_left = 5'd1;
      5'd10: short_left = 5'd11;
      5'd11: short_left = 5'd10;
      5'd12: short_left = 5'd9;
      5'd13: short_left = 5'd8 - 5'(step_q);
      5'd14: short_left = 5'd3;
      5'd15: short_left = 5'd2;
      5'd16: short_left = 5'd1;
      5'd17: short_left = 5'd2;
      default: short_left = 5'd1;
    endcase
  end

  logic unused_inputs;
  assign unused_inputs = ^{tick_i, velocity_i, ask_i, code_i, calib_addr_o, calib_i, region_o};

  // breaks zero_from_a_restart: position_q <= restart_i ? position_q : next
  // breaks known_after_both_encoders: seen_q <= next | {2{state_q == StRest && starts && !rst_i && !restart_i}}
  // breaks asks_for_a_then_b_at_the_start: channel_o = channel_o ^ {1'b0, !known_q, 1'b0}
  // breaks asks_for_the_encoder_of_the_region: channel_o = channel_o ^ {1'b0, known_q, 1'b0}
  // breaks derivative_follows_its_encoder: dot_next_q <= next || (state_q == StPhase && !rst_i && !restart_i)
  // breaks region_within_the_limits_it_reads: region_q <= state_q == StLimit3 && !rst_i && !restart_i ? 2'd1 : next
  // breaks answers_within_5_clocks: state_q <= state_q == StChannel && sample_i && !rst_i && !restart_i ? StChannel : next
  // breaks works_11_clocks_at_most: step_q <= state_q == StT && !rst_i && !restart_i ? 3'd7 : next
  // breaks position_is_the_phase: target = p_q[13:0]
  // breaks position_goes_the_shorter_way: position_q <= state_q == StPhase && !rst_i && !restart_i ? position_q + 32'(step) : next
  // breaks position_moves_with_a_code_only: position_q <= next + 32'(state_q == StShift && !rst_i && !restart_i)
  // breaks bit_0_tells_the_source: velocity_q <= next | 23'(state_q == StShift && !rst_i && !restart_i)
  // breaks velocity_zero_before_the_first_code: velocity_q <= next | 23'(state_q == StOriginA ? 2 : 0)
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !ask_i && !tick_i && !restart_i

  // prove: free $mul

endmodule

bind sincos_observer sincos_observer_props u_sincos_observer_props (
    .*,
    .state(5'(state_q))
);
