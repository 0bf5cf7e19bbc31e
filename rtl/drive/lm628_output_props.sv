// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_output for any input; clocks passed by leaps count. After a leap beyond
// next_o, an error of the caller, times are known again from the next commit on.

module lm628_output_props
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        commit_i,
    input logic        eight_bits_i,
    input logic [11:0] u_i,

    input logic [7:0] dac_o,
    input logic       dac_hi_lo_o,
    input logic       dac_wr_n_o,
    input logic       pwm_mag_o,
    input logic       pwm_sign_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input logic [ 6:0] strobe,
    input logic [12:0] period,
    input logic [12:0] high,
    input logic [12:0] high_value,
    input logic [ 2:0] state_q,
    input logic [11:0] own_u,
    input logic        own_eight
);

  localparam logic [15:0] Strobe = 16'(lm628_clocks(Inc, 8));
  localparam logic [15:0] Period = 16'(lm628_clocks(Inc, 512));

  // Clocks of 4 m ticks, rounded down, without a division, which the proof would have to carry.
  function automatic logic [15:0] clocks_of(logic signed [7:0] u);
    logic [15:0] m;
    m = 16'(u);
    if (u[7]) m = u == -8'sd128 ? 16'd127 : -16'(u);
    return Inc == 3 ? 16'd33 * m + ((16'd43 * m) >> 7) : 16'(100 / Inc) * m;
  endfunction

  logic live_q = 1'b0;
  logic was_rst_q, was_commit_q, was_quiescent_q, was_wr_n_q, was_hi_lo_q;
  logic [7:0] was_dac_q;
  logic [2:0] was_state_q;
  logic [12:0] passed;
  logic allowed;
  logic [11:0] u_q;  // command in use, 12 or 8 bits of it
  logic eight_q;
  logic known_q;  // there was a commit, and no leap beyond next_o since
  logic [15:0] clocks_q;  // 4 m ticks
  logic [15:0] since_q, turn_q;  // clocks since the last commit, up to 4095; into the period
  logic [11:0] code;

  assign passed  = 13'(leap_i) + 13'd1;
  assign allowed = leap_i == '0 || leap_i < next_o;
  assign code    = u_q ^ 12'h800;

  logic [15:0] later, turned;
  assign later  = since_q + 16'(passed);
  assign turned = turn_q + 16'(passed);

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_commit_q    <= commit_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_wr_n_q      <= dac_wr_n_o;
    was_hi_lo_q     <= dac_hi_lo_o;
    was_dac_q       <= dac_o;
    was_state_q     <= state_q;
    if (rst_i) begin
      u_q     <= '0;
      eight_q <= 1'b0;
      known_q <= 1'b0;
    end else begin
      if (commit_i) begin
        u_q      <= u_i;
        eight_q  <= eight_bits_i;
        clocks_q <= clocks_of(u_i[11:4]);
      end
      known_q <= commit_i || (known_q && allowed);
    end
    since_q <= commit_i ? '0 : later > 16'd4095 ? 16'd4095 : later;
    turn_q  <= commit_i || turned >= Period ? '0 : turned;
    if (live_q) begin
      zero_from_reset : assert (!was_rst_q || (dac_o == 8'h80 && dac_wr_n_o && !pwm_mag_o));
      eight_bits_are_the_upper_ones :
      assert (!known_q || !eight_q || (dac_o == code[11:4] && dac_wr_n_o));
      low_six_bits_first :
      assert (!known_q || eight_q || since_q >= 16'd2 * Strobe ||
              (dac_o == {code[5:0], 2'b00} && !dac_hi_lo_o));
      high_six_bits_16_ticks_later :
      assert (!known_q || eight_q || since_q < 16'd2 * Strobe ||
              (dac_o == {code[11:6], 2'b00} && dac_hi_lo_o));
      strobes_of_8_ticks :
      assert (!known_q || eight_q || !dac_wr_n_o ==
              (since_q < Strobe || (since_q >= 16'd2 * Strobe && since_q < 16'd3 * Strobe)));
      data_holds_as_a_strobe_ends :
      assert (was_rst_q || was_commit_q || was_wr_n_q || !dac_wr_n_o ||
              (dac_o == was_dac_q && dac_hi_lo_o == was_hi_lo_q));
      high_for_4_m_ticks : assert (!known_q || pwm_mag_o == (turn_q < clocks_q));
      sign_is_that_of_the_command : assert (pwm_sign_o == u_q[11]);
      quiescent_is_honest : assert (!was_quiescent_q || state_q == was_state_q);

      inv_words : assert (own_u == u_q && own_eight == eight_q);
      inv_state : assert (state_q <= 3'd4);
      inv_reset : assert (known_q || !was_rst_q || state_q == 3'd0);
      inv_period : assert (!known_q || 16'(period) + turn_q + 16'd1 == Period);
      inv_clocks : assert (!known_q || (clocks_q < Period && clocks_q == clocks_of(u_q[11:4])));
      inv_value : assert (!known_q || commit_i || 16'(high_value) == clocks_q);
      inv_high :
      assert (!known_q || 16'(high) == (turn_q < clocks_q ?
                                        clocks_q - turn_q : '0));
      inv_eight : assert (!known_q || !eight_q || state_q == 3'd4);
      inv_low_write :
      assert (!known_q || state_q != 3'd1 || 16'(strobe) + since_q + 16'd1 == Strobe);
      inv_low_hold :
      assert (!known_q || state_q != 3'd2 || 16'(strobe) + since_q + 16'd1 == 16'd2 * Strobe);
      inv_high_write :
      assert (!known_q || state_q != 3'd3 || 16'(strobe) + since_q + 16'd1 == 16'd3 * Strobe);
      inv_idle : assert (!known_q || eight_q || state_q != 3'd4 || since_q >= 16'd3 * Strobe);
      inv_started : assert (!known_q || state_q != 3'd0);

      reaches_strobe : cover (!was_rst_q && known_q && !was_wr_n_q && dac_wr_n_o);
      reaches_high : cover (known_q && pwm_mag_o && pwm_sign_o);
    end
  end

  // breaks zero_from_reset: u_q <= rst_i ? u_i : next
  // breaks eight_bits_are_the_upper_ones: dac_o = eight_q && !low ? {~u_q[11], u_q[10:6], u_q[3:2]} : dac_o
  // breaks low_six_bits_first: dac_o = low && !dac_wr_n_o ? {~u_q[11], u_q[10:6], eight_q ? u_q[5:4] : 2'b00} : dac_o
  // breaks high_six_bits_16_ticks_later: state_d = state_q == StLowHold && strobe_last && !commit_i ? StLowHold : state_d
  // breaks strobes_of_8_ticks: Strobe = Strobe + 7'd1
  // breaks data_holds_as_a_strobe_ends: state_d = state_q == StLowWrite && strobe_last && !commit_i ? StIdle : state_d
  // breaks high_for_4_m_ticks: m = top == 8'h80 ? 7'd126 : m
  // breaks high_for_4_m_ticks: top = u_q[11:4]
  // breaks sign_is_that_of_the_command: pwm_sign_o = u_q[10]
  // breaks quiescent_is_honest: quiescent_o = state_q == StIdle || !strobe_last

  // prove: set Inc=4
  // prove: set Inc=3
  // prove: set Inc=10

endmodule

bind lm628_output lm628_output_props #(.Inc(Inc)) u_lm628_output_props (
    .*,
    .state_q(3'(state_q)),
    .own_u(u_q),
    .own_eight(eight_q)
);
