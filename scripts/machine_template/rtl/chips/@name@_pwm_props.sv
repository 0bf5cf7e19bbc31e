// SPDX-License-Identifier: Apache-2.0
//
@p@ // Promises of @name@_pwm under any input.
@c@ // Promises of @name@_pwm under any input, until the first leap: what a leap does is asked by
@c@ // `trammel prove --leap`.

@p@ module @name@_pwm_props (
@c@ module @name@_pwm_props
@c@   import trammel_pkg::*;
@c@ (
    input logic clk,
    input logic rst,
@c@
@c@     input gap_t leap_i,

    input logic               enable,
    input logic signed [12:0] duty,

    input logic               pwm,
    input logic               direction,
    input logic signed [15:0] count,

@p@     input logic [11:0] counter,
@c@     input logic [11:0] left,
@p@     input logic [12:0] width,
@c@     input logic [12:0] high,
    input logic        enabled
);

  logic live_q = 1'b0;
@c@   logic leapt_q = 1'b0;
  logic was_rst_q, was_enable_q, was_last_q, was_direction_q, was_negative_q;
  logic signed [15:0] was_count_q, moved;
  logic [12:0] asked_q;  // clocks of the pulse, as the duty word was at the start of the period
  logic [11:0] pulse_q;  // clocks of it before the present one
  logic whole_q;  // enabled in all clocks of the period before the present one
@c@   logic [11:0] counter;  // clocks of the period before the present one
  logic last;

@p@   assign last  = counter == 12'd2499;
@c@   assign counter = 12'd2499 - left;
@c@   assign last    = left == 12'd0;
@p@   assign moved = count - was_count_q;
@c@   assign moved   = count - was_count_q;

  always_ff @(posedge clk) begin
    if (rst) live_q <= 1'b1;
@c@     if (leap_i != '0) leapt_q <= 1'b1;
    was_rst_q       <= rst;
    was_enable_q    <= enable;
    was_last_q      <= last;
    was_direction_q <= direction;
    was_negative_q  <= duty < 13'sd0;
    was_count_q     <= count;
    whole_q         <= !rst && (last || (whole_q && enabled));
    pulse_q         <= last ? 12'd0 : pulse_q + 12'(pwm);
    if (rst) asked_q <= 13'd0;
    else if (last) asked_q <= duty < 13'sd0 ? -duty : duty;
@p@     if (live_q) begin
@c@     if (live_q && !leapt_q) begin
      no_pulse_while_disabled : assert (was_enable_q || !pwm);
      pulse_as_long_as_asked :
      assert (!whole_q || !enabled ||
              13'(pulse_q) + 13'(pwm) == (13'(counter) < asked_q ? 13'(counter) + 13'd1 : asked_q));
      direction_waits_for_the_period :
      assert (was_rst_q || was_last_q || direction == was_direction_q);
      direction_is_the_sign : assert (was_rst_q || !was_last_q || direction == was_negative_q);
      count_moves_by_one : assert (was_rst_q || (moved >= -16'sd1 && moved <= 16'sd1));
@p@       inv_counter : assert (counter <= 12'd2499);
@c@       inv_left : assert (left <= 12'd2499);
@p@       inv_width : assert (width == asked_q);
@c@       inv_high :
@c@       assert (high == (13'(counter) < asked_q ? asked_q - 13'(counter) : 13'd0) || was_rst_q);
      inv_pulse :
      assert (!whole_q || pulse_q == (13'(counter) < asked_q ? counter : 12'(asked_q)));
      reaches_a_pulse_backward : cover (pwm && direction);
      reaches_a_count_down : cover (!was_rst_q && moved == -16'sd1);
    end
  end

@p@   // breaks no_pulse_while_disabled: pwm = 13'(counter) < width
@c@   // breaks no_pulse_while_disabled: pwm = high != 13'd0
@p@   // breaks pulse_as_long_as_asked: pwm = enabled && 13'(counter) <= width
@c@   // breaks pulse_as_long_as_asked: pwm = enabled && high > 13'd1
  // breaks direction_waits_for_the_period: direction <= duty[12]
@p@   // breaks direction_is_the_sign: direction <= counter == Last ? !next : next
@c@   // breaks direction_is_the_sign: direction <= start ? !next : next
  // breaks count_moves_by_one: count <= next + 16'(moved)

endmodule

bind @name@_pwm @name@_pwm_props u_@name@_pwm_props (.*);
